// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Senders/vtkIndirectVirtualLights.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectLightTable.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
constexpr int RowLength = vtkIndirectSampler::RowLength;

int CountRows(int lights)
{
  return std::max(1, (lights + RowLength - 1) / RowLength);
}
}

//------------------------------------------------------------------------------
vtkIndirectVirtualLights::vtkIndirectVirtualLights(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Joined(this, vtkIndirectLightTable, false)
  , JoinedBranches(this, vtkIndirectLightTable, false)
  , JoinedLobes(this, vtkIndirectSenderLobeTable, false)
{
}

//------------------------------------------------------------------------------
const vtkIndirectTarget* vtkIndirectVirtualLights::GetPart(
  const vtkIndirectSampler::Pointer& sampler, Part part)
{
  return part == Lights ? &sampler->GetTable()
    : part == Branches  ? sampler->GetBranches()
                        : sampler->GetLobes();
}

//------------------------------------------------------------------------------
bool vtkIndirectVirtualLights::HasPart(const Samplers& samplers, Part part)
{
  return std::any_of(samplers.begin(), samplers.end(),
    [part](const auto& sampler) { return GetPart(sampler, part) != nullptr; });
}

//------------------------------------------------------------------------------
bool vtkIndirectVirtualLights::Update(const Input& input, const Samplers& samplers)
{
  this->NumberOfLights = 0;
  this->WithDirections = false;
  std::vector<std::pair<vtkIndirectSampler*, vtkMTimeType>> contents;
  for (const vtkIndirectSampler::Pointer& sampler : samplers)
  {
    if (!sampler->UpdateBatch(input))
    {
      return false;
    }
    this->NumberOfLights += sampler->GetActualNumberOfLights();
    const vtkIndirectSamplerAbilities abilities = sampler->GetAbilities();
    this->WithDirections = this->WithDirections || abilities.Directions;
    contents.emplace_back(sampler.get(), sampler->GetContentTime());
  }
  // The newest of the samplers' times would not reveal that a sampler has gone.
  if (contents != this->Contents)
  {
    this->Contents = std::move(contents);
    this->ContentTime.Modified();
    this->JoinedTime = 0;
  }
  if (samplers.size() != 1)
  {
    return this->Join(input, samplers);
  }
  this->Current = &samplers.front()->GetTable();
  this->CurrentBranches = samplers.front()->GetBranches();
  this->CurrentLobes = samplers.front()->GetLobes();
  this->Joined.Release(input.Frame.Window);
  this->JoinedBranches.Release(input.Frame.Window);
  this->JoinedLobes.Release(input.Frame.Window);
  this->JoinedTime = 0;
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectVirtualLights::AreThere() const
{
  return std::all_of(this->Contents.begin(), this->Contents.end(),
    [](const auto& content) { return content.first->GetContentTime() == content.second; });
}

//------------------------------------------------------------------------------
bool vtkIndirectVirtualLights::Join(const Input& input, const Samplers& samplers)
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  this->Current = &this->Joined;
  const bool branches = HasPart(samplers, Branches);
  const bool lobes = HasPart(samplers, Lobes);
  this->CurrentBranches = branches ? &this->JoinedBranches : nullptr;
  this->CurrentLobes = lobes ? &this->JoinedLobes : nullptr;
  const int rows = CountRows(this->NumberOfLights);
  if (this->JoinedTime == this->GetContentTime() && this->Joined.GetHeight() == rows)
  {
    return true;
  }
  this->JoinedTime = 0;
  if (!branches)
  {
    this->JoinedBranches.Release(window);
  }
  if (!lobes)
  {
    this->JoinedLobes.Release(window);
  }
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  if (!this->JoinTables(window, samplers, this->Joined, Lights) ||
    (branches && !this->JoinTables(window, samplers, this->JoinedBranches, Branches)) ||
    (lobes && !this->JoinTables(window, samplers, this->JoinedLobes, Lobes)))
  {
    return false;
  }
  this->JoinedTime = this->GetContentTime();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectVirtualLights::JoinTables(
  vtkOpenGLRenderWindow* window, const Samplers& samplers, vtkIndirectTarget& table, Part part)
{
  const int perLight = part == Branches ? vtkIndirectKernels::VTKI_BRANCHES : 1;
  if (!table.Resize(window, RowLength, CountRows(this->NumberOfLights * perLight)))
  {
    return false;
  }
  vtkIndirectFullScreenProgram& join = part == Lobes ? this->LobeProgram : this->Program;
  table.Begin();
  table.Clear();
  bool done = true;
  {
    vtkIndirectFullScreenState fullScreen(window);
    int first = 0;
    for (const vtkIndirectSampler::Pointer& sampler : samplers)
    {
      const int count = perLight * sampler->GetActualNumberOfLights();
      const vtkIndirectTarget* source = GetPart(sampler, part);
      if (source)
      {
        vtkIndirectProgram program = join.Use(window, part == Lobes ? "#define VTKI_LOBES\n" : "");
        done = program != nullptr;
        if (!done)
        {
          break;
        }
        for (int channel = 0; channel < source->GetNumberOfChannels(); ++channel)
        {
          source->Activate(channel, program);
        }
        program->SetUniformi("vtkiFirst", first);
        program->SetUniformi("vtkiCount", count);
        join.Draw();
      }
      first += count;
    }
  }
  table.End();
  return done;
}

//------------------------------------------------------------------------------
int vtkIndirectVirtualLights::GetNumberOfRows() const
{
  return CountRows(this->NumberOfLights);
}

//------------------------------------------------------------------------------
void vtkIndirectVirtualLights::Activate(const vtkIndirectProgram& program) const
{
  for (int channel = 0; channel < 3; ++channel)
  {
    this->Current->Activate(channel, program);
  }
  program->SetUniformi("vtkiLightCount", this->NumberOfLights);
  this->ActivateBranches(program);
}

//------------------------------------------------------------------------------
void vtkIndirectVirtualLights::ActivateBranches(const vtkIndirectProgram& program) const
{
  if (this->CurrentBranches)
  {
    this->CurrentBranches->Activate(0, program, "vtkiBranchPosition");
    this->CurrentBranches->Activate(1, program, "vtkiBranchNormal");
    this->CurrentBranches->Activate(2, program, "vtkiBranchDensity");
    program->SetUniformf("vtkiChildDistanceScale", this->ChildDistanceScale);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectVirtualLights::ActivateLobes(const vtkIndirectProgram& program) const
{
  if (this->CurrentLobes)
  {
    this->CurrentLobes->Activate(vtkIndirectSampler::LobeDirectionExponent, program);
    this->CurrentLobes->Activate(vtkIndirectSampler::LobeDensityArea, program);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectVirtualLights::CopyLobes(const vtkIndirectFrame& frame, vtkImageData* image) const
{
  constexpr int channels = 2;
  image->SetDimensions(channels, this->NumberOfLights, 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  for (int c = 0; c < channels; ++c)
  {
    const std::vector<float> values = this->CurrentLobes->ReadBack(c);
    // Only the channel LobeDensityArea has areas.
    const double unit =
      c == vtkIndirectSampler::LobeDensityArea ? 1.0 / (frame.SceneScale * frame.SceneScale) : 1.0;
    for (size_t i = 0; i < static_cast<size_t>(this->NumberOfLights); ++i)
    {
      for (size_t k = 0; k < 4; ++k)
      {
        out[(i * channels + static_cast<size_t>(c)) * 4 + k] =
          static_cast<float>(values[4 * i + k] * unit);
      }
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectVirtualLights::CopyLights(const vtkIndirectFrame& frame, vtkImageData* image) const
{
  Copy(frame, *this->Current, this->NumberOfLights, image);
}

//------------------------------------------------------------------------------
void vtkIndirectVirtualLights::CopyBranches(
  const vtkIndirectFrame& frame, vtkImageData* image) const
{
  const int count = vtkIndirectKernels::VTKI_BRANCHES * this->NumberOfLights;
  Copy(frame, *this->CurrentBranches, count, image);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < count; ++i)
  {
    float& softening = out[12 * i + 11];
    softening = static_cast<float>(softening / frame.SceneScale / frame.SceneScale);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectVirtualLights::Copy(
  const vtkIndirectFrame& frame, const vtkIndirectTarget& table, int count, vtkImageData* image)
{
  const double scale = frame.SceneScale;
  image->SetDimensions(3, count, 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  const std::vector<float> channels[3] = { table.ReadBack(0), table.ReadBack(1),
    table.ReadBack(2) };
  for (int i = 0; i < count; ++i)
  {
    float* row = out + 12 * i;
    for (int c = 0; c < 3; ++c)
    {
      std::copy(&channels[c][4 * i], &channels[c][4 * i] + 4, row + 4 * c);
    }
    // Directions and solid angles have no unit of length.
    if (row[3] < 0.0f)
    {
      continue;
    }
    for (int k = 0; k < 3; ++k)
    {
      row[k] = static_cast<float>(row[k] / scale + frame.SceneCenter[k]);
      row[8 + k] = static_cast<float>(row[8 + k] / scale / scale);
    }
    row[3] = static_cast<float>(row[3] / scale / scale);
    row[7] = static_cast<float>(row[7] / scale);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectVirtualLights::ReleaseOwn(vtkWindow*)
{
  this->JoinedTime = 0;
  this->Contents.clear();
  this->Current = nullptr;
  this->CurrentBranches = nullptr;
  this->CurrentLobes = nullptr;
}
