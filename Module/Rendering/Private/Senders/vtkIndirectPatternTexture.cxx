// SPDX-License-Identifier: BSD-3-Clause
#include "Senders/vtkIndirectPatternTexture.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkIndirectPatternTexture::Update(vtkOpenGLRenderWindow* window,
  vtkIndirectMapSampler& sampler, const std::vector<vtkIndirectMapSampler::Source>& sources)
{
  if (!this->IsEmpty() && this->Sources == sources && this->Sampler == &sampler &&
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
  this->Set(window, FLOATS, 4, { width, rows, 0 }, pattern.data());
  return true;
}
