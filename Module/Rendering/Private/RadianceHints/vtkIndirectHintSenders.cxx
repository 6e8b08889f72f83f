// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "RadianceHints/vtkIndirectHintSenders.h"

#include "Frame/vtkIndirectFrame.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "vtkObjectFactory.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkTextureObject.h"

vtkStandardNewMacro(vtkIndirectHintSenders);

namespace
{
// Texels read along a block's edge: more would change its sums by less than its share of the map's
// noise.
constexpr int ReadsPerBlockEdge = 8;
}

//------------------------------------------------------------------------------
vtkIndirectHintSenders::vtkIndirectHintSenders()
{
  this->ViewPattern->SetNumberOfLights(1024);
}

//------------------------------------------------------------------------------
bool vtkIndirectHintSenders::Update(const Input& input)
{
  const vtkReflectiveShadowMapPass& maps = input.Maps;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  if (this->MapTime == maps.GetContentTime() && this->Blocks == this->BlocksPerEdge)
  {
    return true;
  }
  this->MapTime = 0;
  const int count = maps.GetNumberOfLayers() * this->BlocksPerEdge * this->BlocksPerEdge;
  if (count > RowLength * vtkTextureObject::GetMaximumTextureSize(window))
  {
    vtkErrorMacro(
      "Hints cannot read " << count << " blocks of the lights' maps; use fewer lights.");
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  if (!this->Resize(window, count))
  {
    return false;
  }
  vtkIndirectTarget& table = this->BeginChange();
  vtkShaderProgram* program = count > 0 ? this->Program.Use(window, table) : nullptr;
  if (count > 0 && !program)
  {
    return false;
  }
  if (program)
  {
    table.Begin();
    vtkIndirectFullScreenState fullScreen(window);
    maps.Activate(program);
    program->SetUniformi("vtkiBlocks", this->BlocksPerEdge);
    program->SetUniformi("vtkiReads", ReadsPerBlockEdge);
    program->SetUniformi("vtkiLightCount", count);
    this->Program.Draw();
    maps.Deactivate();
    table.End();
  }
  this->MapTime = maps.GetContentTime();
  this->Blocks = this->BlocksPerEdge;
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectHintSenders::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!this->CanBeOf(window))
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  this->ViewPattern->ReleaseGraphicsResources(window);
  this->Program.Release();
  this->MapTime = 0;
}
