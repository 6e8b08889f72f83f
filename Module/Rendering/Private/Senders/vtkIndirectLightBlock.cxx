// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Senders/vtkIndirectLightBlock.h"

#include "OpenGL/vtkIndirectTarget.h"
#include "Senders/vtkIndirectSampler.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

namespace
{
constexpr int Channels = 3;
constexpr int BytesPerTexel = 16;
}

//------------------------------------------------------------------------------
int vtkIndirectLightBlock::GetCapacity(vtkOpenGLRenderWindow* window)
{
  if (this->Capacity == 0)
  {
    window->MakeCurrent();
    int bytes = 0;
    glGetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &bytes);
    // OpenGL guarantees 16384 bytes: 341 lights.
    const int lights = bytes / (Channels * BytesPerTexel);
    this->Capacity = lights >= 1024 ? 1024 : (lights >= 512 ? 512 : 256);
  }
  return this->Capacity;
}

//------------------------------------------------------------------------------
std::string vtkIndirectLightBlock::GetDefinitions() const
{
  return (this->Count > this->Capacity
             ? "#define VTKI_MORE_LIGHTS\n"
             : "#define VTKI_LIGHTS " + std::to_string(this->Capacity) + "\n") +
    this->Lights->GetDefinitions();
}

//------------------------------------------------------------------------------
void vtkIndirectLightBlock::Update(
  vtkOpenGLRenderWindow* window, const vtkIndirectVirtualLights& lights)
{
  this->Update(window, lights, 0, lights.GetNumberOfLights());
}

//------------------------------------------------------------------------------
void vtkIndirectLightBlock::Update(
  vtkOpenGLRenderWindow* window, const vtkIndirectVirtualLights& lights, int first, int count)
{
  const int capacity = this->GetCapacity(window);
  this->Lights = &lights;
  this->First = first;
  this->Count = count;
  if (count > capacity)
  {
    return;
  }
  if (this->Block.GetBytes() == 0)
  {
    this->Block.Update(window, nullptr, static_cast<size_t>(capacity) * Channels * BytesPerTexel);
  }
  constexpr int width = vtkIndirectSampler::RowLength;
  const vtkIndirectTarget& table = lights.GetTable();
  const int rows = (count + width - 1) / width;
  vtkOpenGLState* state = window->GetState();
  state->PushFramebufferBindings();
  table.GetFramebuffer()->Bind();
  glBindBuffer(GL_PIXEL_PACK_BUFFER, this->Block.GetBuffer());
  for (int channel = 0; channel < Channels; ++channel)
  {
    table.GetFramebuffer()->ActivateReadBuffer(static_cast<unsigned int>(channel));
    const size_t offset = static_cast<size_t>(channel) * capacity * BytesPerTexel;
    glReadPixels(0, first / width, width, rows, GL_RGBA, GL_FLOAT, reinterpret_cast<void*>(offset));
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  state->PopFramebufferBindings();
}

//------------------------------------------------------------------------------
void vtkIndirectLightBlock::Activate(const vtkIndirectProgram& program) const
{
  this->Block.Activate(program);
  this->Lights->Activate(program);
  program->SetUniformi("vtkiFirstLight", this->First);
  program->SetUniformi("vtkiLightCount", this->Count);
}
