// SPDX-License-Identifier: BSD-3-Clause
#include "VirtualLights/vtkIndirectPatternTexture.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

vtkIndirectPatternTexture::vtkIndirectPatternTexture() = default;
vtkIndirectPatternTexture::~vtkIndirectPatternTexture() = default;

//------------------------------------------------------------------------------
bool vtkIndirectPatternTexture::Update(vtkOpenGLRenderWindow* window,
  vtkIndirectMapSampler& sampler, const std::vector<vtkIndirectMapSampler::Source>& sources)
{
  if (this->Texture && this->Sources == sources && this->Sampler == &sampler &&
    this->Time >= sampler.GetSettingsTime())
  {
    return false;
  }
  this->Sources = sources;
  this->Sampler = &sampler;
  this->Time = sampler.GetSettingsTime();
  std::vector<vtkIndirectMapSampler::Sample> pattern;
  sampler.MakePattern(sources, pattern);
  this->NumberOfSamples = static_cast<int>(pattern.size());
  constexpr int width = vtkIndirectSampler::RowLength;
  const int rows = std::max(1, (this->NumberOfSamples + width - 1) / width);
  pattern.resize(static_cast<size_t>(rows) * width, { 0.0f, 0.0f, 0.0f, 0.0f });
  if (!this->Texture)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
  }
  this->Texture->SetContext(window);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->Texture->Create2DFromRaw(width, rows, 4, VTK_FLOAT, pattern.data());
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectPatternTexture::Activate(vtkShaderProgram* program) const
{
  this->Texture->Activate();
  program->SetUniformi("vtkiPattern", this->Texture->GetTextureUnit());
}

//------------------------------------------------------------------------------
void vtkIndirectPatternTexture::Deactivate() const
{
  this->Texture->Deactivate();
}

//------------------------------------------------------------------------------
size_t vtkIndirectPatternTexture::GetBytes() const
{
  return this->Texture ? static_cast<size_t>(this->Texture->GetWidth()) *
      this->Texture->GetHeight() * sizeof(vtkIndirectMapSampler::Sample)
                       : 0;
}

//------------------------------------------------------------------------------
void vtkIndirectPatternTexture::Release(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
}
