// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectVisibility.h"

#include "Frame/vtkIndirectReport.h"
#include "VirtualLights/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectDistanceField.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace
{
// Along an edge of a virtual light's tile.
constexpr int TexelsOfLights = 128;
}

//------------------------------------------------------------------------------
vtkIndirectVisibility::vtkIndirectVisibility()
  : Volume(new vtkIndirectOccupancyVolume)
{
}

vtkIndirectVisibility::~vtkIndirectVisibility() = default;

//------------------------------------------------------------------------------
bool vtkIndirectVisibility::Update(const Input& input, const Needs& needs)
{
  const vtkIndirectFrame& frame = input.Frame;
  const bool hadVolume = this->Current.HasVolume();
  const bool lookedUp = this->LooksUpMaps();
  this->Current = needs;
  const bool volume = needs.HasVolume();
  if (lookedUp && !this->LooksUpMaps())
  {
    this->Maps.Release(frame.Window);
    this->EmittersTime = 0;
  }
  if (!volume && hadVolume)
  {
    this->Volume->Release(frame.Window);
    this->Volume = std::make_unique<vtkIndirectOccupancyVolume>();
  }
  if (volume)
  {
    if (!input.Caching)
    {
      this->Volume->Forget();
    }
    if (needs.Triangles)
    {
      this->Volume->KeepTriangles();
    }
    this->Volume->KeepTree(needs.Exact);
    this->NumberOfUpdates += this->Volume->Update(frame, needs.Resolution) ? 1 : 0;
    if (needs.Segments && this->WalksSegments())
    {
      this->Volume->GetDistanceField();
    }
  }
  return !this->LooksUpMaps() || this->UpdateMaps(input);
}

//------------------------------------------------------------------------------
bool vtkIndirectVisibility::UpdateMaps(const Input& input)
{
  const vtkIndirectVirtualLights* lights = input.Lights;
  const size_t count = lights ? static_cast<size_t>(lights->GetNumberOfLights()) : 0;
  if (count == 0)
  {
    this->Current.Maps = false;
    return true;
  }
  if (this->EmittersTime != lights->GetContentTime() || this->Emitters.size() != count)
  {
    const vtkIndirectTarget& table = lights->GetTable();
    const auto position = table.ReadBack(vtkVirtualLightSampler::PositionArea);
    const auto normal = table.ReadBack(vtkVirtualLightSampler::NormalExponent);
    const auto density = table.ReadBack(vtkVirtualLightSampler::DensityArea);
    this->Emitters.resize(count);
    for (size_t i = 0; i < count; ++i)
    {
      const float* p = &position[4 * i];
      const float* n = &normal[4 * i];
      const float* d = &density[4 * i];
      vtkIndirectDepthAtlas::Emitter& emitter = this->Emitters[i];
      emitter.Sends = p[3] > 0.0f && std::max({ d[0], d[1], d[2] }) > 0.0f;
      emitter.Tile = vtkIndirectDepthTile::FromPlace({ p[0], p[1], p[2] }, { n[0], n[1], n[2] });
    }
    this->EmittersTime = lights->GetContentTime();
  }
  return this->Maps.Update(
    input.Frame, input.Capture, this->Emitters, TexelsOfLights, input.Caching);
}

//------------------------------------------------------------------------------
bool vtkIndirectVisibility::WalksSegments() const
{
  return this->Current.Senders && !this->Current.Maps && !this->Volume->IsEmpty();
}

//------------------------------------------------------------------------------
bool vtkIndirectVisibility::IsExact() const
{
  return this->Current.Exact && this->Volume->GetTree().GetNumberOfTriangles() > 0;
}

//------------------------------------------------------------------------------
const char* vtkIndirectVisibility::GetDefinitions() const
{
  return this->LooksUpMaps() ? "#define VTKI_VISIBILITY\n#define VTKI_DEPTH_TILES\n"
    : this->WalksSegments()  ? "#define VTKI_VISIBILITY\n#define VTKI_SEGMENTS\n"
                             : "";
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program) const
{
  if (this->LooksUpMaps())
  {
    this->Maps.Activate(program);
  }
  else if (this->WalksSegments())
  {
    this->Volume->GetDistanceField().Activate(window, program);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::Deactivate() const
{
  if (this->LooksUpMaps())
  {
    this->Maps.Deactivate();
  }
  else if (this->WalksSegments())
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
  if (this->LooksUpMaps())
  {
    report.Modelled.emplace_back(name,
      "depth maps of " + std::to_string(this->Maps.GetNumberOfTiles()) + " virtual lights, " +
        std::to_string(this->Maps.GetTexels()) + " texels squared");
    report.LeftOut.emplace_back("what stands between near the horizon of senders",
      "a map ends 72 degrees from the sender's normal; what its border sees decides over the 8 % "
      "of "
      "the light beyond");
    return;
  }
  if (this->IsExact())
  {
    report.Modelled.emplace_back(name,
      "segments against all " + std::to_string(this->Volume->GetTree().GetNumberOfTriangles()) +
        " triangles");
  }
  else if (this->WalksSegments())
  {
    report.Modelled.emplace_back(name,
      std::to_string(this->Volume->GetNumberOfOccupiedVoxels()) + " occupied voxels of " +
        std::to_string(this->Current.Resolution) + " along the longest edge");
  }
  else
  {
    report.LeftOut.emplace_back(
      name, "Visibility is none or nothing has polygons; the result is too bright");
    return;
  }
  for (const auto& entry : this->Volume->GetLeftOut())
  {
    report.LeftOut.push_back(entry);
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectVisibility::GetBytes() const
{
  return this->Volume->GetBytes() + this->Maps.GetBytes();
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
  this->Maps.Release(window);
  this->EmittersTime = 0;
}
