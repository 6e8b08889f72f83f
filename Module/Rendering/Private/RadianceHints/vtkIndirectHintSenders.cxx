// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "RadianceHints/vtkIndirectHintSenders.h"

#include "Maps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkTextureObject.h"

namespace
{
// Texels read along a block's edge: more would change its sums by less than its share of the map's
// noise.
constexpr int ReadsPerBlockEdge = 8;
}

//------------------------------------------------------------------------------
vtkIndirectHintSenders::vtkIndirectHintSenders(vtkObject* caller)
  : Caller(caller)
{
  this->HeadlightPattern->SetNumberOfLights(1024);
}

//------------------------------------------------------------------------------
vtkIndirectMapSampler* vtkIndirectHintSenders::GetHeadlightPattern()
{
  return vtkIndirectSampler::Get(this->HeadlightPattern)->GetHeadlightPattern();
}

//------------------------------------------------------------------------------
vtkIndirectSamplerAbilities vtkIndirectHintSenders::GetAbilities() const
{
  return vtkIndirectSampler::Get(this->HeadlightPattern)->GetAbilities();
}

//------------------------------------------------------------------------------
bool vtkIndirectHintSenders::Update(const Input& input)
{
  const vtkIndirectLightMaps& maps = input.Maps;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  if (this->MapTime == maps.GetContentTime() && this->Blocks == this->BlocksPerEdge)
  {
    return true;
  }
  this->MapTime = 0;
  const int count = maps.GetNumberOfLayers() * this->BlocksPerEdge * this->BlocksPerEdge;
  if (count > RowLength * vtkTextureObject::GetMaximumTextureSize(window))
  {
    vtkErrorWithObjectMacro(this->Caller,
      "Hints cannot read " << count << " blocks of the lights' maps; use fewer lights.");
    return false;
  }
  if (!this->Resize(window, count))
  {
    return false;
  }
  vtkIndirectTarget& table = this->BeginChange();
  vtkIndirectFullScreenState fullScreen(window);
  const bool drawn = count == 0 ||
    this->Program.Run(window, table,
      [&](const vtkIndirectProgram& program)
      {
        maps.Activate(program);
        program->SetUniformi("vtkiBlocks", this->BlocksPerEdge);
        program->SetUniformi("vtkiReads", ReadsPerBlockEdge);
        program->SetUniformi("vtkiLightCount", count);
      });
  if (!drawn)
  {
    return false;
  }
  this->MapTime = maps.GetContentTime();
  this->Blocks = this->BlocksPerEdge;
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectHintSenders::ReleaseOwn(vtkWindow* window)
{
  this->vtkIndirectSampler::ReleaseOwn(window);
  this->HeadlightPattern->ReleaseGraphicsResources(window);
  this->MapTime = 0;
}
