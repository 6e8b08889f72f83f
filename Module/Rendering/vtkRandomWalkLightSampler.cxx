// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRandomWalkLightSampler.h"

#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectReport.h"
#include "VirtualLights/vtkIndirectEmitters.h"
#include "VirtualLights/vtkIndirectSenderClusters.h"
#include "VirtualLights/vtkIndirectSenderTexels.h"
#include "Visibility/vtkIndirectRandomWalk.h"
#include "Visibility/vtkIndirectSurfaces.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkRandomWalkLightSampler);

//------------------------------------------------------------------------------
struct vtkRandomWalkLightSampler::Internals
{
  vtkMTimeType SurfacesTime = 0; // of those that the paths met
  size_t NumberOfTriangles = 0;
  size_t NumberOfSpheres = 0;
  size_t NumberOfTreeBuilds = 0;
  std::vector<std::pair<std::string, std::string>> LeftOut; // of the surfaces
  vtkIndirectRandomWalk Walk;
  vtkIndirectSenderClusters Clusters;
  size_t NumberOfSources = 0;
  int NumberOfWalks = 0;
  int NumberOfFrames = 0; // over which the walk extends by now
  bool HasMore = false;   // whether a still frame would have more vertices
  double Smoothing = 1.0;
  std::vector<double> WalkKey;  // what paths were made of, besides surfaces; empty: there are none
  std::vector<double> TableKey; // and lights of these
  vtkIndirectFurtherSenders Further;

  void FindSenders(vtkIndirectFurtherSenders& senders) const;
};

namespace
{
// How many times fewer vertices a tree is made of while things move.
constexpr int FewerWhileMoving = 4;

// However many frames a walk extends over.
constexpr int MostVertices = 1048576;

// The area by which later vertices are smoothed over theirs, in a tree of so many: places are
// random, and with less those beside a crease would show one by one. It costs rooms half a per cent
// of their light.
double FindSmoothing(int vertices)
{
  return 12.0 * std::sqrt(8192.0 / vertices);
}
}

//------------------------------------------------------------------------------
// Vertices of a light's first bounce cover surfaces once, as the texels of a map do; those of all
// later bounces together do so once more.
void vtkRandomWalkLightSampler::Internals::FindSenders(vtkIndirectFurtherSenders& senders) const
{
  senders.Senders.clear();
  senders.NumberOfMaps = this->NumberOfSources;
  for (const vtkIndirectRandomWalk::Vertex& vertex : this->Walk.GetVertices())
  {
    const int map = vertex.Bounce == 1 ? vertex.Source : static_cast<int>(this->NumberOfSources);
    senders.NumberOfMaps = std::max(senders.NumberOfMaps, static_cast<size_t>(map) + 1);
    senders.Senders.push_back({ glm::vec3(vertex.Position), glm::vec3(vertex.Normal),
      static_cast<float>(vertex.Area), glm::vec3(vertex.DensityArea), map,
      static_cast<float>(vertex.Bounce > 1 ? this->Smoothing : 1.0) });
  }
}

namespace
{
void Append(std::vector<double>& key, const glm::dvec3& v)
{
  key.insert(key.end(), { v.x, v.y, v.z });
}

// All that paths depend on, but the surfaces.
std::vector<double> MakeKey(const std::vector<vtkIndirectRandomWalk::Source>& sources,
  const vtkIndirectRandomWalk::Settings& settings)
{
  std::vector<double> key = { static_cast<double>(settings.NumberOfVertices),
    static_cast<double>(settings.FirstBounce), static_cast<double>(settings.LastBounce) };
  for (const vtkIndirectRandomWalk::Source& source : sources)
  {
    const vtkIndirectLight& light = source.Light;
    key.push_back(light.Positional ? 1.0 : 0.0);
    Append(key, light.PositionWC);
    Append(key, light.DirectionWC);
    Append(key, light.Attenuation);
    key.push_back(light.ConeAngle);
    key.push_back(light.Exponent);
    Append(key, source.Strength);
    key.push_back(source.FirstBounce);
  }
  return key;
}
}

//------------------------------------------------------------------------------
vtkRandomWalkLightSampler::vtkRandomWalkLightSampler()
  : Internal(new Internals)
{
}

vtkRandomWalkLightSampler::~vtkRandomWalkLightSampler() = default;

//------------------------------------------------------------------------------
void vtkRandomWalkLightSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfLights: " << this->NumberOfLights << "\n";
  os << indent << "NumberOfVertices: " << this->NumberOfVertices << "\n";
  os << indent << "NumberOfFrames: " << this->NumberOfFrames << "\n";
  os << indent << "NumberOfWalks: " << this->GetNumberOfWalks() << "\n";
  os << indent << "NumberOfTreeBuilds: " << this->GetNumberOfTreeBuilds() << "\n";
  os << indent << "FirstBounce: " << this->FirstBounce << "\n";
}

//------------------------------------------------------------------------------
int vtkRandomWalkLightSampler::GetNumberOfWalks() const
{
  return this->Internal->NumberOfWalks;
}

int vtkRandomWalkLightSampler::GetNumberOfTreeBuilds() const
{
  return static_cast<int>(this->Internal->NumberOfTreeBuilds);
}

//------------------------------------------------------------------------------
// Follows the paths where they have changed, and returns whether they have.
bool vtkRandomWalkLightSampler::Walk(const Input& input)
{
  Internals& in = *this->Internal;
  std::vector<vtkIndirectRandomWalk::Source> sources;
  for (const vtkIndirectLight& light : input.Frame.Lights)
  {
    if (!light.Fill && light.Color != glm::dvec3(0.0))
    {
      sources.push_back({ light, light.Color, 1 });
    }
  }
  // The first bounce of these comes from maps of their own.
  for (size_t i = 0; input.Emitters && i < input.Emitters->size(); ++i)
  {
    sources.push_back({ (*input.Emitters)[i].Light, (*input.Emitters)[i].Strength, 2 });
  }
  vtkIndirectRandomWalk::Settings settings;
  settings.NumberOfVertices =
    this->NumberOfVertices > 0 ? this->NumberOfVertices : this->NumberOfLights;
  settings.FirstBounce = this->FirstBounce;
  settings.LastBounce = input.NumberOfBounces;
  const bool moved = in.SurfacesTime != input.Surfaces->GetTime();
  std::vector<double> key = MakeKey(sources, settings);
  bool same = !moved && key == in.WalkKey;
  bool coarse = false;
  if (!same && input.Interactive && this->NumberOfVertices > 0)
  {
    settings.NumberOfVertices = std::max(this->NumberOfVertices / FewerWhileMoving, 1);
    coarse = true;
    key = MakeKey(sources, settings);
    same = !moved && key == in.WalkKey;
  }
  const int next = in.NumberOfFrames + (input.Interactive ? 0 : 1);
  const int most = std::min(this->NumberOfFrames, MostVertices / settings.NumberOfVertices);
  const int number = same ? std::min(next, most) : 1;
  in.HasMore = coarse || number < most;
  if (same && number == in.NumberOfFrames)
  {
    return false;
  }
  // Paths go on in their sequence; to follow the first ones again takes less than to keep them.
  settings.NumberOfVertices *= number;
  in.NumberOfFrames = number;
  in.Walk.Walk(*input.Surfaces, input.Frame, sources, settings);
  in.SurfacesTime = input.Surfaces->GetTime();
  in.NumberOfTriangles = input.Surfaces->GetTree().GetNumberOfTriangles();
  in.NumberOfSpheres = input.Surfaces->GetTree().GetNumberOfSpheres();
  in.NumberOfTreeBuilds = input.Surfaces->GetNumberOfBuilds();
  in.LeftOut = input.Surfaces->GetLeftOut();
  in.NumberOfSources = sources.size();
  in.Smoothing = FindSmoothing(settings.NumberOfVertices);
  in.WalkKey = key;
  ++in.NumberOfWalks;
  return true;
}

//------------------------------------------------------------------------------
bool vtkRandomWalkLightSampler::Update(const Input& input)
{
  Internals& in = *this->Internal;
  const double error =
    this->NumberOfVertices > 0 ? vtkIndirectSenderClusters::FindError(input.ErrorTolerance) : 0.0;
  const std::vector<double> key = { static_cast<double>(this->NumberOfLights),
    static_cast<double>(this->NumberOfVertices), error };
  if (!this->Walk(input) && key == in.TableKey)
  {
    return true;
  }
  in.TableKey.clear();
  std::vector<Row> lights;
  std::vector<Row> branches;
  if (this->NumberOfVertices > 0)
  {
    vtkIndirectFurtherSenders senders;
    in.FindSenders(senders);
    in.Clusters.SetSenders(std::move(senders.Senders));
    const vtkIndirectSenderClusters::Lights found = in.Clusters.MakeLights(
      std::vector<glm::dvec3>(senders.NumberOfMaps, glm::dvec3(1.0)), this->NumberOfLights, error,
      input.NumberOfBounces > 1 ? vtkIndirectSenderClusters::NearnessOfBounces
                                : vtkIndirectSenderClusters::StandardNearness);
    lights = vtkIndirectSenderTexels::MakeRows(found.Tops);
    branches = vtkIndirectSenderTexels::MakeRows(found.Branches);
  }
  else
  {
    for (const vtkIndirectRandomWalk::Vertex& vertex : in.Walk.GetVertices())
    {
      lights.push_back({ { vertex.Position.x, vertex.Position.y, vertex.Position.z }, vertex.Area,
        { vertex.Normal.x, vertex.Normal.y, vertex.Normal.z },
        { vertex.DensityArea.x, vertex.DensityArea.y, vertex.DensityArea.z } });
    }
  }
  if (!this->Write(input.Frame, lights, branches))
  {
    return false;
  }
  in.TableKey = key;
  return true;
}

//------------------------------------------------------------------------------
const vtkIndirectFurtherSenders& vtkRandomWalkLightSampler::UpdateSenders(const Input& input)
{
  Internals& in = *this->Internal;
  if (this->Walk(input))
  {
    in.FindSenders(in.Further);
    ++in.Further.Time;
  }
  return in.Further;
}

//------------------------------------------------------------------------------
bool vtkRandomWalkLightSampler::HasMore() const
{
  return this->Internal->HasMore;
}

//------------------------------------------------------------------------------
void vtkRandomWalkLightSampler::AddToReport(vtkIndirectReport& report) const
{
  const Internals& in = *this->Internal;
  report.MainMemoryBytes += in.Clusters.GetBytes();
  report.Modelled.emplace_back("random walk",
    std::to_string(in.Walk.GetNumberOfPaths()) + " paths through " +
      std::to_string(in.NumberOfTriangles) + " triangles, " +
      (in.NumberOfSpheres > 0 ? std::to_string(in.NumberOfSpheres) + " spheres, " : std::string()) +
      std::to_string(in.Walk.GetVertices().size()) + " vertices" +
      (this->NumberOfFrames > 1 ? ", frame " + std::to_string(in.NumberOfFrames) + " of " +
            std::to_string(this->NumberOfFrames)
                                : std::string()));
  // A hundredth is what the walk's noise hides.
  if (in.Walk.GetTail() > 0.01)
  {
    report.LeftOut.emplace_back("bounces beyond the walk's last one",
      "about " + vtkIndirectReport::Number(std::round(1000.0 * in.Walk.GetTail()) / 10.0) +
        " % of the light of later bounces; the result is too dark");
  }
  for (const auto& [what, why] : in.LeftOut)
  {
    report.LeftOut.emplace_back(what + " in the random walk", why);
  }
}

//------------------------------------------------------------------------------
void vtkRandomWalkLightSampler::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!this->CanBeOf(window))
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  this->Internal->Clusters.SetSenders({});
  this->Internal->WalkKey.clear();
  this->Internal->HasMore = false;
  this->Internal->TableKey.clear();
  this->Internal->Further.Senders = {};
}
