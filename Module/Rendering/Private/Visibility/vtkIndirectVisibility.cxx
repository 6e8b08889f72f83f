// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectVisibility.h"

#include "Frame/vtkIndirectReport.h"
#include "Visibility/vtkIndirectDistanceField.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "vtkOpenGLRenderWindow.h"

//------------------------------------------------------------------------------
vtkIndirectVisibility::vtkIndirectVisibility()
  : Volume(new vtkIndirectOccupancyVolume)
{
}

vtkIndirectVisibility::~vtkIndirectVisibility() = default;

//------------------------------------------------------------------------------
void vtkIndirectVisibility::Update(const vtkIndirectFrame& frame, const Needs& needs, bool caching)
{
  const bool used = needs.Senders || needs.Volume;
  const bool wasUsed = this->Current.Senders || this->Current.Volume;
  this->Current = needs;
  if (!used)
  {
    if (wasUsed)
    {
      this->Volume->Release(frame.Window);
      this->Volume = std::make_unique<vtkIndirectOccupancyVolume>();
    }
    return;
  }
  if (!caching)
  {
    this->Volume->Forget();
  }
  if (needs.Triangles)
  {
    this->Volume->KeepTriangles();
  }
  this->NumberOfUpdates += this->Volume->Update(frame, needs.Resolution) ? 1 : 0;
  if (needs.Segments && this->HidesSenders())
  {
    this->Volume->GetDistanceField();
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectVisibility::HidesSenders() const
{
  return this->Current.Senders && !this->Volume->IsEmpty();
}

//------------------------------------------------------------------------------
const char* vtkIndirectVisibility::GetDefinitions() const
{
  return this->HidesSenders() ? "#define VTKI_OCCUPANCY\n" : "";
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program) const
{
  if (this->HidesSenders())
  {
    this->Volume->GetDistanceField().Activate(window, program);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::Deactivate() const
{
  if (this->HidesSenders())
  {
    this->Volume->GetDistanceField().Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::AddToReport(vtkIndirectReport& report) const
{
  report.Bytes += this->GetBytes();
  report.MainMemoryBytes += this->GetMainMemoryBytes();
  const char* const name = "visibility between sender and receiver";
  if (!this->HidesSenders())
  {
    report.LeftOut.emplace_back(
      name, "Occupancy is off or nothing has polygons; the result is too bright");
    return;
  }
  report.Modelled.emplace_back(name,
    std::to_string(this->Volume->GetNumberOfOccupiedVoxels()) + " occupied voxels of " +
      std::to_string(this->Current.Resolution) + " along the longest edge");
  for (const auto& entry : this->Volume->GetLeftOut())
  {
    report.LeftOut.push_back(entry);
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectVisibility::GetBytes() const
{
  return this->Volume->GetBytes();
}

//------------------------------------------------------------------------------
size_t vtkIndirectVisibility::GetMainMemoryBytes() const
{
  return this->Volume->GetMainMemoryBytes();
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::Release(vtkWindow* window)
{
  this->Volume->Release(window);
}
