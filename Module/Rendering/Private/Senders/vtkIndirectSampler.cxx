// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Senders/vtkIndirectSampler.h"

#include "OpenGL/vtkIndirectContextGuard.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectLightTable.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkVirtualLightSampler.h"

#include <algorithm>

static_assert(vtkIndirectSampler::RowLength == vtkIndirectKernels::VTKI_ROW_LENGTH,
  "what shaders read the table by");

//------------------------------------------------------------------------------
vtkIndirectSampler::vtkIndirectSampler(vtkVirtualLightSampler* owner)
  : Owner(owner)
  , Guard(vtkSmartPointer<vtkIndirectContextGuard>::New())
  , Table(this, vtkIndirectLightTable, false)
{
  this->Guard->Release = [this](vtkWindow* window) { this->Release(window); };
}

vtkIndirectSampler::~vtkIndirectSampler() = default;

//------------------------------------------------------------------------------
vtkIndirectSampler::Pointer vtkIndirectSampler::Get(vtkVirtualLightSampler* sampler)
{
  if (!sampler)
  {
    return nullptr;
  }
  const auto held = std::make_shared<vtkSmartPointer<vtkVirtualLightSampler>>(sampler);
  return Pointer(held, sampler->Lights.get());
}

//------------------------------------------------------------------------------
void vtkIndirectSampler::AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan*) const
{
  if (this->Owner)
  {
    list.Add("NumberOfLights", this->Owner->GetNumberOfLights());
  }
}

//------------------------------------------------------------------------------
vtkIndirectSamplerAbilities vtkIndirectSampler::GetAbilities() const
{
  vtkIndirectSamplerAbilities abilities;
  abilities.NumberOfLights =
    this->Owner ? this->Owner->GetNumberOfLights() : abilities.NumberOfLights;
  return abilities;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkIndirectSampler::GetSettingsTime() const
{
  return this->Owner ? this->Owner->GetMTime() : 0;
}

//------------------------------------------------------------------------------
void vtkIndirectSampler::HoldContext(vtkOpenGLRenderWindow* window)
{
  this->Guard->SetContext(window);
}

//------------------------------------------------------------------------------
bool vtkIndirectSampler::CanRelease(vtkWindow* window)
{
  return window && this->Guard->CanBeOf(window);
}

//------------------------------------------------------------------------------
void vtkIndirectSampler::ReleaseOwn(vtkWindow*)
{
  this->ContentTime.Modified();
  this->Branches.reset();
  this->Lobes.reset();
  this->Rows = {};
  this->BranchRows = {};
}

//------------------------------------------------------------------------------
bool vtkIndirectSampler::Resize(vtkOpenGLRenderWindow* window, int numberOfLights)
{
  const int rows = std::max(1, (numberOfLights + RowLength - 1) / RowLength);
  this->NumberOfLights = numberOfLights;
  return this->Table.Resize(window, RowLength, rows);
}

//------------------------------------------------------------------------------
vtkIndirectTarget& vtkIndirectSampler::BeginChange()
{
  this->ContentTime.Modified();
  return this->Table;
}

//------------------------------------------------------------------------------
// Fills a table. source: number of the lights' source in the scene; below zero: the rows are
// branches.
void vtkIndirectSampler::Fill(vtkIndirectTarget& table, const std::vector<Row>& rows, double source)
{
  const size_t places = static_cast<size_t>(table.GetWidth()) * table.GetHeight();
  std::vector<float> channels[3];
  for (std::vector<float>& channel : channels)
  {
    channel.reserve(4 * places);
  }
  auto add = [&channels](int channel, const double v[3], double last)
  {
    for (int c = 0; c < 3; ++c)
    {
      channels[channel].push_back(static_cast<float>(v[c]));
    }
    channels[channel].push_back(static_cast<float>(last));
  };
  const Row empty = { { 0.0, 0.0, 0.0 }, 1.0, { 0.0, 0.0, 1.0 }, { 0.0, 0.0, 0.0 } };
  for (size_t i = 0; i < places; ++i)
  {
    const Row& light = i < rows.size() ? rows[i] : empty;
    add(PositionArea, light.Position, light.Area);
    add(NormalChildDistance, light.Normal, light.ChildDistance);
    add(DensityArea, light.DensityArea, source < 0.0 ? light.ContactSoftening : source);
  }
  for (int channel = 0; channel < 3; ++channel)
  {
    table.Write(channel, channels[channel]);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectSampler::UpdateBatch(const Input& input)
{
  const bool other = !(input.Batch == this->Batch);
  this->Batch = input.Batch;
  const vtkMTimeType before = this->ContentTime.GetMTime();
  if (!this->Update(input))
  {
    return false;
  }
  const bool written = this->ContentTime.GetMTime() != before;
  return written || !other || this->Rows.empty() || this->WriteBatch(input.Frame);
}

//------------------------------------------------------------------------------
bool vtkIndirectSampler::WriteBatch(const vtkIndirectFrame& frame)
{
  constexpr size_t perLight = vtkIndirectKernels::VTKI_BRANCHES;
  std::vector<Row> lights;
  std::vector<Row> branches;
  for (size_t i = static_cast<size_t>(this->Batch.Number); i < this->Rows.size();
       i += static_cast<size_t>(this->Batch.Count))
  {
    lights.push_back(this->Rows[i]);
    for (size_t k = 0; k < perLight && !this->BranchRows.empty(); ++k)
    {
      branches.push_back(this->BranchRows[perLight * i + k]);
    }
  }
  return this->WriteAll(frame, lights, branches);
}

//------------------------------------------------------------------------------
bool vtkIndirectSampler::Write(
  const vtkIndirectFrame& frame, const std::vector<Row>& lights, const std::vector<Row>& branches)
{
  const bool parts = this->Batch.Count > 1;
  this->Rows = parts ? lights : std::vector<Row>();
  this->BranchRows = parts ? branches : std::vector<Row>();
  return parts ? this->WriteBatch(frame) : this->WriteAll(frame, lights, branches);
}

//------------------------------------------------------------------------------
bool vtkIndirectSampler::WriteAll(
  const vtkIndirectFrame& frame, const std::vector<Row>& lights, const std::vector<Row>& branches)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  if (!this->Resize(frame.Window, static_cast<int>(lights.size())))
  {
    return false;
  }
  // The numbers before this source belong to the frame's lights.
  Fill(this->BeginChange(), lights, static_cast<double>(frame.Lights.size()));
  if (!this->WriteLobes(frame.Window, lights))
  {
    return false;
  }
  if (branches.empty())
  {
    this->Branches.reset();
    return true;
  }
  if (!this->Branches)
  {
    this->Branches = std::make_unique<vtkIndirectTarget>(this, vtkIndirectLightTable, false);
  }
  const int rows = (static_cast<int>(branches.size()) + RowLength - 1) / RowLength;
  if (!this->Branches->Resize(frame.Window, RowLength, rows))
  {
    return false;
  }
  Fill(*this->Branches, branches, -1.0);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSampler::WriteLobes(vtkOpenGLRenderWindow* window, const std::vector<Row>& lights)
{
  const bool any = std::any_of(lights.begin(), lights.end(),
    [](const Row& row)
    {
      return std::max({ row.LobeDensityArea[0], row.LobeDensityArea[1], row.LobeDensityArea[2] }) >
        0.0;
    });
  if (!any)
  {
    this->Lobes.reset();
    return true;
  }
  vtkIndirectTarget* lobes = this->MakeLobes(window);
  if (!lobes)
  {
    return false;
  }
  const size_t places = static_cast<size_t>(lobes->GetWidth()) * lobes->GetHeight();
  std::vector<float> channels[2] = { std::vector<float>(4 * places, 0.0f),
    std::vector<float>(4 * places, 0.0f) };
  const Row empty = {};
  for (size_t i = 0; i < places; ++i)
  {
    const Row& light = i < lights.size() ? lights[i] : empty;
    for (size_t c = 0; c < 3; ++c)
    {
      channels[LobeDirectionExponent][4 * i + c] = static_cast<float>(light.LobeDirection[c]);
      channels[LobeDensityArea][4 * i + c] = static_cast<float>(light.LobeDensityArea[c]);
    }
    channels[LobeDirectionExponent][4 * i + 3] = static_cast<float>(light.LobeExponent);
  }
  lobes->Write(LobeDirectionExponent, channels[LobeDirectionExponent]);
  lobes->Write(LobeDensityArea, channels[LobeDensityArea]);
  return true;
}

//------------------------------------------------------------------------------
vtkIndirectTarget* vtkIndirectSampler::MakeLobes(vtkOpenGLRenderWindow* window)
{
  if (!this->Lobes)
  {
    this->Lobes = std::make_unique<vtkIndirectTarget>(this, vtkIndirectSenderLobeTable, false);
  }
  const bool made = this->Lobes->Resize(window, this->Table.GetWidth(), this->Table.GetHeight());
  return made ? this->Lobes.get() : nullptr;
}
