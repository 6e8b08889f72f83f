// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectVisibility.h"

#include "Capture/vtkIndirectCreases.h"
#include "Plan/vtkIndirectReport.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectSurfaces.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectDistanceField.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{
// Texels along an edge of a virtual light's tile.
constexpr int TexelsOfLights = 128;
// Number of tiles that have memory: 64 MB. More lights share them.
constexpr size_t MaximumNumberOfTiles = 1024;
// Rounds of all loops of an invocation; llvmpipe ends the loops after 65535.
constexpr double MostRounds = 65535.0;
// Distance, in scene units, that two opposite directions count as: lights that share a tile face
// the same way first.
constexpr double DistanceOfTurn = 0.25;
}

//------------------------------------------------------------------------------
vtkIndirectVisibility::vtkIndirectVisibility(
  vtkIndirectResource* owner, vtkIndirectDepthMaps& maps, vtkIndirectDepthMaps::ClientType client)
  : vtkIndirectResource(owner)
  , Volume(new vtkIndirectOccupancyVolume(this))
  , DepthMaps(maps)
  , Client(client)
  , Atlas(maps.Get(client))
{
}

vtkIndirectVisibility::~vtkIndirectVisibility() = default;

//------------------------------------------------------------------------------
void vtkIndirectVisibility::Update(const Input& input, const Needs& needs)
{
  const vtkIndirectFrame& frame = input.Frame;
  const bool hadVolume = this->Current.HasVolume();
  const bool lookedUp = this->LooksUpMaps();
  this->Current = needs;
  this->Surfaces = &input.Surfaces;
  const bool volume = needs.HasVolume();
  if (lookedUp && !this->LooksUpMaps())
  {
    this->DepthMaps.Release(this->Client, frame.Window);
    this->LightsTime = 0;
  }
  if (!volume && hadVolume)
  {
    this->Volume = std::make_unique<vtkIndirectOccupancyVolume>(this);
  }
  bool changed = false;
  if (volume)
  {
    if (!input.Caching)
    {
      this->Volume->Forget();
    }
    if (needs.Volume || needs.Surfaces)
    {
      this->Volume->KeepSurfaces(needs.Surfaces);
    }
    changed = this->Volume->Update(frame, input.Surfaces, needs.Resolution);
    if (needs.Segments && this->WalksVoxels())
    {
      this->Volume->GetDistanceField();
    }
  }
  if (needs.Surfaces && this->SurfacesTime != input.Surfaces.GetTime())
  {
    this->SurfacesTime = input.Surfaces.GetTime();
    changed = true;
  }
  this->NumberOfUpdates += changed ? 1 : 0;
  this->UpdateSpheres(input);
  if (this->LooksUpMaps())
  {
    this->RequestMaps(input);
  }
}

//------------------------------------------------------------------------------
// Makes the lists of spheres, if they are needed.
void vtkIndirectVisibility::UpdateSpheres(const Input& input)
{
  const vtkIndirectBlockingSpheres* const spheres =
    this->Current.HasSphereLists() ? input.Spheres : nullptr;
  this->Blocking = this->Current.HasSphereLists() || this->Current.Exact ? input.Spheres : nullptr;
  if (!spheres || spheres->Spheres.empty())
  {
    this->Spheres.Release(input.Frame.Window);
    this->Spheres.Clear();
    this->SpheresTime = 0;
    this->StepsOfSpheres = 0.0;
    this->SpheresAreTooMany = false;
    return;
  }
  if (this->SpheresTime == spheres->NumberOfUpdates && input.Caching)
  {
    return;
  }
  const size_t rows =
    static_cast<size_t>(vtkTextureObject::GetMaximumTextureSize(input.Frame.Window));
  this->SpheresAreTooMany = !this->Spheres.Build(spheres->Spheres,
    std::min(
      vtkIndirectSphereGrid::MaximumNumberOfEntries, rows * vtkIndirectSphereGrid::RowLength));
  this->SpheresTime = spheres->NumberOfUpdates;
  ++this->NumberOfSphereUpdates;
  // The value is kept while spheres move about, so that decisions based on it do not alternate.
  const double steps = this->Spheres.GetNumberOfSteps();
  if (std::abs(steps - this->StepsOfSpheres) > 0.15 * this->StepsOfSpheres)
  {
    this->StepsOfSpheres = steps;
  }
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::ReadLights(const vtkIndirectVirtualLights& lights)
{
  const size_t count = static_cast<size_t>(lights.GetNumberOfLights());
  const vtkIndirectTarget& table = lights.GetTable();
  const auto position = table.ReadBack(vtkIndirectSampler::PositionArea);
  const auto normal = table.ReadBack(vtkIndirectSampler::NormalChildDistance);
  const auto density = table.ReadBack(vtkIndirectSampler::DensityArea);
  const auto lobes = lights.HasLobes()
    ? lights.GetLobes()->ReadBack(vtkIndirectSampler::LobeDensityArea)
    : std::vector<float>(density.size(), 0.0f);
  this->Lights.resize(count);
  for (size_t i = 0; i < count; ++i)
  {
    const float* p = &position[4 * i];
    const float* n = &normal[4 * i];
    const float* d = &density[4 * i];
    const float* lobe = &lobes[4 * i];
    vtkIndirectDepthMaps::Map& map = this->Lights[i];
    map.Sends = p[3] > 0.0f && std::max({ d[0], d[1], d[2], lobe[0], lobe[1], lobe[2] }) > 0.0f;
    // The normal is a mean, which is shorter than one where surfaces differ.
    const glm::dvec3 axis =
      map.Sends ? glm::normalize(glm::dvec3(n[0], n[1], n[2])) : glm::dvec3(n[0], n[1], n[2]);
    map.Tile = vtkIndirectDepthTile::FromPlace({ p[0], p[1], p[2] }, axis);
  }
  this->Stride = (count + MaximumNumberOfTiles - 1) / MaximumNumberOfTiles;
  this->Maps.clear();
  for (size_t i = 0; i < count; i += this->Stride)
  {
    this->Maps.push_back(this->Lights[i]);
  }
  // Numbers with their bits reversed are spread over all lights, however few a frame draws.
  for (size_t bit = 1; bit < this->Maps.size(); bit *= 2)
  {
    for (size_t i = 0; i < this->Maps.size(); ++i)
    {
      size_t& turn = this->Maps[i].Turn;
      turn = 2 * turn + (i & bit ? 1 : 0);
    }
  }
  this->LightsTime = lights.GetContentTime();
  this->LightsAreNew = true;
  this->WithDirections = lights.HasDirections();
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::RequestMaps(const Input& input)
{
  const vtkIndirectVirtualLights* lights = input.Lights;
  const size_t count = lights ? static_cast<size_t>(lights->GetNumberOfLights()) : 0;
  if (count == 0)
  {
    this->Current.Maps = false;
    return;
  }
  if (this->LightsTime != lights->GetContentTime() || this->Lights.size() != count)
  {
    this->ReadLights(*lights);
  }
  this->DepthMaps.Request(this->Client, input.Frame, this->Maps, TexelsOfLights);
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::UpdateSharing(const vtkIndirectFrame& frame)
{
  if (!this->LooksUpMaps())
  {
    return;
  }
  const bool shared = this->Shares;
  this->Shares = this->Stride > 1 || this->Atlas.GetNumberOfMissingTiles() > 0;
  if (!this->Shares)
  {
    this->Owners.Release(frame.Window);
  }
  if (this->Shares && (this->LightsAreNew || !shared || this->Atlas.HasChanged()))
  {
    this->ShareTiles(frame);
  }
  this->LightsAreNew = false;
}

//------------------------------------------------------------------------------
// A light without a tile of its own looks up the tile of the most similar light that has one: near,
// and facing the same way (clustered visibility: Dong, Grosch, Ritschel, Kautz, Seidel 2009).
// Differences between their places are ignored; where the other light is hidden more, the result is
// too dark.
void vtkIndirectVisibility::ShareTiles(const vtkIndirectFrame& frame)
{
  std::vector<int> there;
  for (size_t k = 0; k < this->Maps.size(); ++k)
  {
    if (this->Atlas.HasTile(k))
    {
      there.push_back(static_cast<int>(k));
    }
  }
  constexpr size_t width = vtkIndirectSampler::RowLength;
  const size_t rows = (this->Lights.size() + width - 1) / width;
  // The rows hold place and tile of all lights, then axes of all; shaders do not look up a light
  // that sends nothing.
  std::vector<float> owners(8 * width * rows, 0.0f);
  for (size_t i = 0; i < this->Lights.size(); ++i)
  {
    const vtkIndirectDepthTile& light = this->Lights[i].Tile;
    double best = 0.0;
    int owner = -1;
    const bool own = i % this->Stride == 0 && this->Atlas.HasTile(i / this->Stride);
    if (own)
    {
      owner = static_cast<int>(i / this->Stride);
    }
    for (size_t k = 0; !own && this->Lights[i].Sends && k < there.size(); ++k)
    {
      const vtkIndirectDepthTile& other = this->Maps[static_cast<size_t>(there[k])].Tile;
      const glm::dvec3 apart = other.Place - light.Place;
      const double turned = DistanceOfTurn * (1.0 - glm::dot(other.Forward, light.Forward));
      const double distance = glm::dot(apart, apart) + turned * turned;
      if (owner < 0 || distance < best)
      {
        best = distance;
        owner = there[k];
      }
    }
    const vtkIndirectDepthTile& tile =
      owner < 0 ? light : this->Maps[static_cast<size_t>(owner)].Tile;
    float* place = &owners[4 * i];
    float* axis = &owners[4 * (width * rows + i)];
    for (int c = 0; c < 3; ++c)
    {
      place[c] = static_cast<float>(tile.Place[c]);
      axis[c] = static_cast<float>(tile.Forward[c]);
    }
    place[3] = static_cast<float>(std::max(owner, 0));
  }
  this->Owners.Set(frame.Window, vtkIndirectDataTexture::FLOATS, 4,
    { static_cast<int>(width), static_cast<int>(2 * rows), 0 }, owners.data());
}

//------------------------------------------------------------------------------
bool vtkIndirectVisibility::WalksVoxels() const
{
  return this->Current.Senders && !this->Current.Maps && !this->Volume->IsEmpty();
}

//------------------------------------------------------------------------------
bool vtkIndirectVisibility::WalksSpheres() const
{
  return this->Current.Senders && !this->Current.Maps && !this->Spheres.IsEmpty();
}

//------------------------------------------------------------------------------
int vtkIndirectVisibility::GetMaximumNumberOfSegments() const
{
  constexpr int row = vtkIndirectSampler::RowLength;
  if (!this->WalksSpheres())
  {
    return MaximumNumberOfSegments;
  }
  const double senders = MostRounds / this->FindRounds();
  return row * std::clamp(static_cast<int>(senders) / row, 1, MaximumNumberOfSegments / row);
}

//------------------------------------------------------------------------------
// Returns the rounds for a sender: a constant number for voxels, and four times the mean steps for
// spheres.
double vtkIndirectVisibility::FindRounds() const
{
  const double voxels = this->WalksVoxels() ? MostRounds / MaximumNumberOfSegments : 0.0;
  return voxels + 4.0 * this->StepsOfSpheres;
}

//------------------------------------------------------------------------------
// Returns true if not even one row of lights would have enough rounds: then a round is four steps
// through the lists, which is slower where fewer steps are enough.
bool vtkIndirectVisibility::TakesLongSteps() const
{
  return this->WalksSpheres() && vtkIndirectSampler::RowLength * this->FindRounds() > MostRounds;
}

//------------------------------------------------------------------------------
bool vtkIndirectVisibility::IsExact() const
{
  return this->Current.Exact &&
    this->Surfaces->GetTree().GetNumberOfTriangles() +
      this->Surfaces->GetTree().GetNumberOfSpheres() >
    0;
}

//------------------------------------------------------------------------------
std::string vtkIndirectVisibility::GetDefinitions() const
{
  if (this->LooksUpMaps())
  {
    return this->Shares
      ? "#define VTKI_VISIBILITY\n#define VTKI_DEPTH_TILES\n#define VTKI_SHARED_TILES\n"
      : "#define VTKI_VISIBILITY\n#define VTKI_DEPTH_TILES\n";
  }
  if (!this->WalksSegments())
  {
    return "";
  }
  return std::string("#define VTKI_VISIBILITY\n#define VTKI_SEGMENTS\n") +
    (this->WalksVoxels() ? "#define VTKI_VOXEL_SEGMENTS\n" : "") +
    (this->WalksSpheres() ? "#define VTKI_SPHERE_SEGMENTS\n" : "") +
    (this->TakesLongSteps() ? "#define VTKI_LONG_STEPS\n" : "");
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::Activate(vtkOpenGLRenderWindow* window,
  const vtkIndirectProgram& program, const vtkIndirectCreases& creases) const
{
  if (this->LooksUpMaps())
  {
    this->Atlas.Activate(program);
    creases.Activate(program);
    if (this->Shares)
    {
      this->Owners.Activate(program, "vtkiTileOwners");
    }
    return;
  }
  if (this->WalksVoxels())
  {
    this->Volume->GetDistanceField().Activate(window, program);
  }
  if (this->WalksSpheres())
  {
    this->Spheres.Activate(window, program);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::AddToReport(vtkIndirectReport& report) const
{
  report.MainMemoryBytes += this->GetMainMemoryBytes();
  const char* const name = "visibility between sender and receiver";
  if (this->LooksUpMaps())
  {
    const int there = this->Atlas.GetNumberOfTiles() - this->Atlas.GetNumberOfMissingTiles();
    report.Modelled.emplace_back(name,
      "depth maps of " + std::to_string(there) + " of " + std::to_string(this->Lights.size()) +
        " virtual lights, " + std::to_string(this->Atlas.GetTexels()) + " texels squared");
    if (this->Stride > 1)
    {
      report.LeftOut.emplace_back("depth maps of all virtual lights",
        "there is memory for " + std::to_string(MaximumNumberOfTiles) +
          "; others share those of their neighbours");
    }
    if (this->WithDirections)
    {
      report.LeftOut.emplace_back(
        "what hides directions", "depth maps are of places; voxels would be looked up");
    }
    return;
  }
  this->AddSegmentsToReport(report, name);
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::AddSegmentsToReport(vtkIndirectReport& report, const char* name) const
{
  const bool surfaces = this->Current.HasSurfaces();
  if (surfaces)
  {
    report.LeftOut.insert(report.LeftOut.end(), this->Surfaces->GetLeftOut().begin(),
      this->Surfaces->GetLeftOut().end());
  }
  const bool lists = this->Blocking && !this->Spheres.IsEmpty();
  std::string what;
  if (this->IsExact())
  {
    const vtkIndirectTriangleTree& tree = this->Surfaces->GetTree();
    const size_t triangles = tree.GetNumberOfTriangles();
    what = triangles > 0 ? "segments against all " + std::to_string(triangles) + " triangles" : "";
    if (this->Blocking && tree.GetNumberOfSpheres() > 0)
    {
      what +=
        (what.empty() ? "segments against " : ", and segments against ") + this->Blocking->What;
    }
  }
  else if (this->WalksVoxels())
  {
    what = std::to_string(this->Volume->GetNumberOfOccupiedVoxels()) + " occupied voxels of " +
      std::to_string(this->Current.Resolution) + " along the longest edge";
  }
  if (lists)
  {
    const glm::ivec3& size = this->Spheres.GetSize();
    what += (what.empty() ? "segments against " : ", and segments against ") +
      this->Blocking->What + ", in " + std::to_string(size.x) + " x " + std::to_string(size.y) +
      " x " + std::to_string(size.z) + " lists";
  }
  if (this->SpheresAreTooMany)
  {
    report.LeftOut.emplace_back(std::to_string(this->Blocking->Spheres.size()) + " spheres",
      "there is no memory for so many; they block no indirect light, and the result is too bright");
  }
  if (this->Blocking && !surfaces)
  {
    report.LeftOut.insert(
      report.LeftOut.end(), this->Blocking->LeftOut.begin(), this->Blocking->LeftOut.end());
  }
  if (what.empty())
  {
    report.LeftOut.emplace_back(
      name, "Visibility is none or nothing has polygons or spheres; the result is too bright");
    return;
  }
  report.Modelled.emplace_back(name, what);
  for (const vtkIndirectOccupancyVolume::LeftOutProp& entry : this->Volume->GetLeftOut())
  {
    const bool ofSpheres = lists &&
      std::find(this->Blocking->Props.begin(), this->Blocking->Props.end(), entry.Prop) !=
        this->Blocking->Props.end();
    if (!surfaces && !ofSpheres)
    {
      report.LeftOut.emplace_back(entry.What, entry.Why);
    }
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectVisibility::GetMainMemoryBytes() const
{
  return this->Volume->GetMainMemoryBytes() + this->Spheres.GetMainMemoryBytes() +
    (this->Blocking ? this->Blocking->Spheres.size() * sizeof(glm::dvec4) : 0);
}

//------------------------------------------------------------------------------
void vtkIndirectVisibility::ReleaseOwn(vtkWindow* window)
{
  this->DepthMaps.Release(this->Client, window);
  this->LightsTime = 0;
}
