// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRandomWalkLightSampler.h"

#include "OpenGL/vtkIndirectKey.h"
#include "Plan/vtkIndirectReport.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectSurfaces.h"
#include "Senders/vtkIndirectEmitters.h"
#include "Senders/vtkIndirectRandomWalk.h"
#include "Senders/vtkIndirectSampler.h"
#include "Senders/vtkIndirectSenderClusters.h"
#include "Senders/vtkIndirectSenderTexels.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkRandomWalkLightSampler);

namespace
{
// While things move, a tree is made of this many times fewer vertices.
constexpr int FewerWhileMoving = 8;

// Largest number of vertices, however many frames a walk extends over.
constexpr int MostVertices = 1048576;

// The area over which later vertices are smoothed, over their own area. Places are random, and with
// less smoothing vertices beside a crease would show one by one. The smoothing costs rooms half a
// per cent of their light.
constexpr double SmoothingOfLaterBounces = 8.0;

// Makes a key of the inputs of the paths, except the surfaces.
vtkIndirectKey MakeKey(const vtkIndirectSampler::Input& input,
  const vtkIndirectEmitters::List& emitters, const vtkIndirectRandomWalk::Settings& settings)
{
  vtkIndirectKey key;
  input.Frame.Seen.Near.AppendTo(key);
  key.Add("lights turn", input.LightsTurn);
  key.Add("number of vertices", settings.NumberOfVertices);
  key.Add("bounces", settings.FirstBounce).Add("bounces", settings.LastBounce);
  for (const vtkIndirectLight& emitter : emitters)
  {
    emitter.AppendTo(key);
    key.Add("bounces", emitter.FirstBounce);
  }
  return key;
}

class WalkLights : public vtkIndirectSampler
{
public:
  explicit WalkLights(vtkRandomWalkLightSampler& settings)
    : vtkIndirectSampler(&settings)
    , Set(settings)
  {
  }
  void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const override;
  bool Update(const Input& input) override;
  vtkIndirectSamplerAbilities GetAbilities() const override;
  /** Follows the paths; their vertices are the senders. */
  const vtkIndirectFurtherSenders* UpdateSenders(const Input& input) override;
  void AddToReport(vtkIndirectReport& report) const override;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  bool Walk(const Input& input);
  void FindSenders(vtkIndirectFurtherSenders& senders) const;

  const vtkRandomWalkLightSampler& Set;
  vtkMTimeType SurfacesTime = 0; // time of the surfaces that the paths met
  size_t NumberOfTriangles = 0;
  size_t NumberOfSpheres = 0;
  size_t NumberOfTreeBuilds = 0;
  std::vector<std::pair<std::string, std::string>> LeftOut; // entries of the surfaces
  vtkIndirectRandomWalk Paths;
  vtkIndirectSenderClusters Clusters;
  size_t NumberOfEmitters = 0;
  bool LightsTurn = false;
  int NumberOfWalks = 0;
  int Frames = 0;          // number of frames that the walk extends over so far
  bool HasMore = false;    // a still frame would have more vertices
  vtkIndirectKey WalkKey;  // the inputs of the paths, except surfaces; empty: there are no paths
  vtkIndirectKey TableKey; // the further inputs of the lights
  vtkIndirectFurtherSenders Further;
};
}

//------------------------------------------------------------------------------
vtkRandomWalkLightSampler::vtkRandomWalkLightSampler()
  : vtkVirtualLightSampler(std::make_unique<WalkLights>(*this))
{
  this->NumberOfLights = 1000;
}

//------------------------------------------------------------------------------
void WalkLights::AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const
{
  this->vtkIndirectSampler::AddSettings(list, plan);
  list.Add("NumberOfVertices", this->Set.GetNumberOfVertices())
    .Add("NumberOfFrames", this->Set.GetNumberOfFrames())
    .Add("FirstBounce", this->Set.GetFirstBounce());
}

//------------------------------------------------------------------------------
// Vertices of a light's first bounce cover surfaces once, as the texels of a map do; those of all
// later bounces together cover them once more. Where lights turn, later vertices keep the number of
// their emitter.
void WalkLights::FindSenders(vtkIndirectFurtherSenders& senders) const
{
  senders.Senders.clear();
  senders.NumberOfMaps = this->NumberOfEmitters;
  for (const vtkIndirectRandomWalk::Vertex& vertex : this->Paths.GetVertices())
  {
    const int cover =
      vertex.Bounce == 1 ? vertex.Emitter : static_cast<int>(this->NumberOfEmitters);
    const int map = this->LightsTurn ? vertex.Emitter : cover;
    senders.NumberOfMaps = std::max(senders.NumberOfMaps, static_cast<size_t>(map) + 1);
    senders.Senders.push_back({ glm::vec3(vertex.Position), glm::vec3(vertex.Normal),
      static_cast<float>(vertex.Area), glm::vec3(vertex.DensityArea), map,
      static_cast<float>(vertex.Bounce > 1 ? SmoothingOfLaterBounces : 1.0) });
    senders.Senders.back().Cover = this->LightsTurn ? cover : -1;
  }
}

//------------------------------------------------------------------------------
// Follows the paths if they have changed. Returns true if they have.
bool WalkLights::Walk(const Input& input)
{
  vtkIndirectEmitters::List emitters;
  if (!input.LightsTurn)
  {
    std::copy_if(input.Frame.Lights.begin(), input.Frame.Lights.end(), std::back_inserter(emitters),
      std::mem_fn(&vtkIndirectLight::IsReflected));
  }
  this->LightsTurn = input.LightsTurn;
  // The first bounce of the sky and of area lights comes from maps of their own.
  for (size_t i = 0; input.Emitters && i < input.Emitters->size(); ++i)
  {
    emitters.push_back((*input.Emitters)[i]);
    emitters.back().FirstBounce = 2;
    if (input.LightsTurn)
    {
      emitters.back().Color = glm::dvec3(1.0); // the lights' strengths come later
    }
  }
  vtkIndirectRandomWalk::Settings settings;
  settings.NumberOfVertices = this->Set.GetNumberOfVertices() > 0 ? this->Set.GetNumberOfVertices()
                                                                  : this->Set.GetNumberOfLights();
  settings.FirstBounce = this->Set.GetFirstBounce();
  settings.LastBounce = input.NumberOfBounces;
  const bool moved = this->SurfacesTime != input.Surfaces->GetTime();
  vtkIndirectKey key = MakeKey(input, emitters, settings);
  bool same = !moved && key == this->WalkKey;
  bool coarse = false;
  if (!same && input.Interactive && this->Set.GetNumberOfVertices() > 0)
  {
    settings.NumberOfVertices = std::max(this->Set.GetNumberOfVertices() / FewerWhileMoving, 1);
    coarse = true;
    key = MakeKey(input, emitters, settings);
    same = !moved && key == this->WalkKey;
  }
  const int next = this->Frames + (input.Interactive ? 0 : 1);
  const int most =
    std::min(this->Set.GetNumberOfFrames(), MostVertices / settings.NumberOfVertices);
  const int number = same ? std::min(next, most) : 1;
  this->HasMore = coarse || number < most;
  if (same && number == this->Frames)
  {
    return false;
  }
  // Paths go on in their sequence. The first ones are followed again, which is cheaper than keeping
  // them.
  settings.NumberOfVertices *= number;
  this->Frames = number;
  this->Paths.Walk(*input.Surfaces, input.Frame, emitters, settings);
  this->SurfacesTime = input.Surfaces->GetTime();
  this->NumberOfTriangles = input.Surfaces->GetTree().GetNumberOfTriangles();
  this->NumberOfSpheres = input.Surfaces->GetTree().GetNumberOfSpheres();
  this->NumberOfTreeBuilds = input.Surfaces->GetNumberOfBuilds();
  this->LeftOut = input.Surfaces->GetLeftOut();
  this->NumberOfEmitters = emitters.size();
  this->WalkKey = key;
  ++this->NumberOfWalks;
  return true;
}

//------------------------------------------------------------------------------
bool WalkLights::Update(const Input& input)
{
  const double error = this->Set.GetNumberOfVertices() > 0
    ? vtkIndirectSenderClusters::FindError(input.ErrorTolerance)
    : 0.0;
  vtkIndirectKey key;
  key.Add("number of lights", this->Set.GetNumberOfLights());
  key.Add("number of vertices", this->Set.GetNumberOfVertices()).Add("error", error);
  if (!this->Walk(input) && key == this->TableKey)
  {
    return true;
  }
  this->TableKey.Clear();
  std::vector<Row> lights;
  std::vector<Row> branches;
  if (this->Set.GetNumberOfVertices() > 0)
  {
    vtkIndirectFurtherSenders senders;
    this->FindSenders(senders);
    this->Clusters.SetSenders(std::move(senders.Senders));
    this->Clusters.SetSeen(input.Frame.Seen.Near);
    const vtkIndirectSenderClusters::LightTree found =
      this->Clusters.MakeLights(std::vector<glm::dvec3>(senders.NumberOfMaps, glm::dvec3(1.0)),
        this->Set.GetNumberOfLights(), error,
        input.NumberOfBounces > 1 ? vtkIndirectSenderClusters::NearnessOfBounces
                                  : vtkIndirectSenderClusters::StandardNearness);
    lights = vtkIndirectSenderTexels::MakeRows(found.Lights);
    branches = vtkIndirectSenderTexels::MakeRows(found.Branches);
  }
  else
  {
    for (const vtkIndirectRandomWalk::Vertex& vertex : this->Paths.GetVertices())
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
  this->TableKey = key;
  return true;
}

//------------------------------------------------------------------------------
const vtkIndirectFurtherSenders* WalkLights::UpdateSenders(const Input& input)
{
  if (this->Walk(input))
  {
    this->FindSenders(this->Further);
    ++this->Further.Time;
  }
  return &this->Further;
}

//------------------------------------------------------------------------------
vtkIndirectSamplerAbilities WalkLights::GetAbilities() const
{
  vtkIndirectSamplerAbilities abilities = this->vtkIndirectSampler::GetAbilities();
  abilities.Walks = true;
  abilities.HasMore = this->HasMore;
  return abilities;
}

//------------------------------------------------------------------------------
void WalkLights::AddToReport(vtkIndirectReport& report) const
{
  report.Counters["walks"] += this->NumberOfWalks;
  report.Counters["walk_trees"] += static_cast<long long>(this->NumberOfTreeBuilds);
  report.MainMemoryBytes += this->Clusters.GetBytes();
  report.Modelled.emplace_back("random walk",
    std::to_string(this->Paths.GetNumberOfPaths()) + " paths through " +
      std::to_string(this->NumberOfTriangles) + " triangles, " +
      (this->NumberOfSpheres > 0 ? std::to_string(this->NumberOfSpheres) + " spheres, "
                                 : std::string()) +
      std::to_string(this->Paths.GetVertices().size()) + " vertices" +
      (this->Set.GetNumberOfFrames() > 1 ? ", frame " + std::to_string(this->Frames) + " of " +
            std::to_string(this->Set.GetNumberOfFrames())
                                         : std::string()));
  // A hundredth is below the walk's noise.
  if (this->Paths.GetTail() > 0.01)
  {
    report.LeftOut.emplace_back("bounces beyond the walk's last one",
      "about " + vtkIndirectReport::Number(std::round(1000.0 * this->Paths.GetTail()) / 10.0) +
        " % of the light of later bounces; the result is too dark");
  }
  for (const auto& [what, why] : this->LeftOut)
  {
    report.LeftOut.emplace_back(what + " in the random walk", why);
  }
}

//------------------------------------------------------------------------------
void WalkLights::ReleaseOwn(vtkWindow* window)
{
  this->vtkIndirectSampler::ReleaseOwn(window);
  this->Clusters.SetSenders({});
  this->WalkKey.Clear();
  this->HasMore = false;
  this->TableKey.Clear();
  this->Further.Senders = {};
}
