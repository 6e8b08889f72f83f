// SPDX-License-Identifier: BSD-3-Clause
#include "Senders/vtkIndirectRandomWalk.h"

#include "Scene/vtkIndirectSurfaces.h"
#include "Senders/vtkIndirectSamplePattern.h"
#include "vtkMath.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace
{
using vtkIndirectSamplePattern::CosineDirection;
using vtkIndirectSamplePattern::FindAxes;
using vtkIndirectSamplePattern::ScrambledPoint;

constexpr double Pi = 3.14159265358979323846;
constexpr double TwoPi = 2.0 * Pi;

// The first paths of each light tell how many paths the light needs: this many, or eight times as
// many and so on while they have few vertices. Where thousands of paths have none, later bounces
// are less than a thousandth of the light.
constexpr size_t PilotPaths = 64;
constexpr size_t MostPilotPaths = 4096;
constexpr size_t PilotVertices = 32;
constexpr size_t PathsAtATime = 64;
// Where more paths than that leave the scene for each vertex, later bounces are a small part of all
// light, and fewer vertices tell them well enough.
constexpr double MostPathsOfVertex = 8.0;

// A ray begins this far from its surface, as a share of the scene's diagonal: coincident copies of
// a surface lie nearer.
constexpr double Clearance = 1e-6;

// Interpolated normals may face a ray that is almost parallel to the facet. These are the smallest
// cosines between ray and facet that light is divided by: at a first vertex the area is divided by
// the same cosine, at later vertices the area does not depend on it.
constexpr double LeastCosineToLight = 1e-4;
constexpr double LeastFacetCosine = 1e-2;

// The rectangle around the part that the eye sees is this many times as wide: surfaces around the
// part send light into it.
constexpr double ReachOfPart = 2.0;

// The number of nearest vertices that give the density of vertices.
constexpr int Neighbors = 8;

double Largest(const glm::dvec3& v)
{
  return std::max({ v.x, v.y, v.z });
}

//------------------------------------------------------------------------------
// A tree of points. Each part is halved at its median along its longest axis, so that a search
// stays fast when a few points lie a million times farther away than the others.
class PointTree
{
public:
  using Found = std::vector<std::pair<double, uint32_t>>; // squared distance, point

  explicit PointTree(std::vector<glm::dvec3> points)
    : Points(std::move(points))
    , Order(this->Points.size())
    , Axes(this->Points.size(), 0)
  {
    std::iota(this->Order.begin(), this->Order.end(), 0u);
    this->Part(0, this->Order.size());
    std::vector<glm::dvec3> sorted;
    sorted.reserve(this->Points.size());
    for (const uint32_t i : this->Order)
    {
      sorted.push_back(this->Points[i]);
    }
    this->Points.swap(sorted);
  }

  // Returns the points in an order in which neighbours come soon after each other.
  const std::vector<uint32_t>& GetOrder() const { return this->Order; }

  // Finds this many points nearest to a place, the nearest first.
  void FindNearest(const glm::dvec3& place, size_t count, Found& found) const
  {
    found.clear();
    this->Find(0, this->Order.size(), place, count, found);
  }

private:
  static constexpr size_t LargestLeaf = 8;

  void Part(size_t begin, size_t end)
  {
    if (end - begin <= LargestLeaf)
    {
      return;
    }
    glm::dvec3 lower = this->Points[this->Order[begin]];
    glm::dvec3 upper = lower;
    for (size_t i = begin; i < end; ++i)
    {
      lower = glm::min(lower, this->Points[this->Order[i]]);
      upper = glm::max(upper, this->Points[this->Order[i]]);
    }
    const glm::dvec3 size = upper - lower;
    const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
    const size_t middle = begin + (end - begin) / 2;
    const auto first = this->Order.begin();
    std::nth_element(first + static_cast<std::ptrdiff_t>(begin),
      first + static_cast<std::ptrdiff_t>(middle), first + static_cast<std::ptrdiff_t>(end),
      [&](uint32_t a, uint32_t b)
      {
        const double x = this->Points[a][axis];
        const double y = this->Points[b][axis];
        return x < y || (x == y && a < b);
      });
    this->Axes[middle] = static_cast<unsigned char>(axis);
    this->Part(begin, middle);
    this->Part(middle + 1, end);
  }

  // Keeps the list sorted: it is too short for a heap to pay.
  void Take(size_t i, const glm::dvec3& place, size_t count, Found& found) const
  {
    const glm::dvec3 apart = this->Points[i] - place;
    const Found::value_type taken(glm::dot(apart, apart), this->Order[i]);
    if (found.size() == count)
    {
      if (!(taken < found.back()))
      {
        return;
      }
      found.pop_back();
    }
    found.push_back(taken);
    for (size_t k = found.size() - 1; k > 0 && found[k] < found[k - 1]; --k)
    {
      std::swap(found[k], found[k - 1]);
    }
  }

  void Find(size_t begin, size_t end, const glm::dvec3& place, size_t count, Found& found) const
  {
    if (end - begin <= LargestLeaf)
    {
      for (size_t i = begin; i < end; ++i)
      {
        this->Take(i, place, count, found);
      }
      return;
    }
    const size_t middle = begin + (end - begin) / 2;
    const int axis = this->Axes[middle];
    const double beyond = place[axis] - this->Points[middle][axis];
    this->Take(middle, place, count, found);
    const bool above = beyond > 0.0;
    this->Find(above ? middle + 1 : begin, above ? end : middle, place, count, found);
    if (found.size() < count || beyond * beyond < found.back().first)
    {
      this->Find(above ? begin : middle + 1, above ? middle : end, place, count, found);
    }
  }

  std::vector<glm::dvec3> Points;  // in the tree's order
  std::vector<uint32_t> Order;     // the number that each of them was given as
  std::vector<unsigned char> Axes; // axis of each part's median
};
}

//------------------------------------------------------------------------------
// The rays that leave a light.
class vtkIndirectRandomWalk::Emission
{
public:
  // Makes more rays for the part of the scene that is seen.
  Emission(const vtkIndirectFrame& frame, const vtkIndirectLight& light);

  bool IsDark() const { return this->Dark; }
  bool IsVTKLight() const { return this->Light.Light != nullptr; }
  // Makes the ray for a place of the unit square. footprint: the ray's share of all rays times
  // their number: a solid angle, or an area for a directional light.
  void MakeRay(
    const glm::dvec2& at, glm::dvec3& start, glm::dvec3& direction, double& footprint) const;
  // Returns a footprint over that of a ray that is made without regard to what is seen.
  double FindRatio(double footprint) const
  {
    return this->IsPart ? footprint / (4.0 * this->HalfWidths.x * this->HalfWidths.y) : 1.0;
  }
  // Returns the factor that turns the footprint into an area across the ray at that distance.
  double FindSpread(double distance) const
  {
    return this->Light.Positional ? distance * distance : 1.0;
  }
  // Returns the intensity times that factor, for a ray of that direction.
  glm::dvec3 FindStrength(const glm::dvec3& direction, double distance) const;

private:
  const vtkIndirectLight& Light;
  double SceneScale;
  bool Dark = false;
  glm::dvec3 Origin{ 0.0 }; // scene units; for a directional light the middle of the rays' starts
  glm::dvec3 Axis{ 0.0, 0.0, -1.0 };
  glm::dvec3 U{ 1.0, 0.0, 0.0 };
  glm::dvec3 V{ 0.0, 1.0, 0.0 };
  glm::dvec2 HalfWidths{ 1.0 };
  // Half of the rays of a directional light start in the rectangle around the part that is seen.
  bool IsPart = false;
  glm::dvec2 LowerOfPart{ 0.0 };
  glm::dvec2 UpperOfPart{ 0.0 };
  double CosCone = -1.0; // cosine of the cone that rays fill
  double Exponent = 0.0; // exponent of the cosine in the rays' density
};

//------------------------------------------------------------------------------
vtkIndirectRandomWalk::Emission::Emission(
  const vtkIndirectFrame& frame, const vtkIndirectLight& light)
  : Light(light)
  , SceneScale(frame.SceneScale)
{
  this->Dark = !(Largest(light.Color) > 0.0) || frame.Casters.empty();
  glm::dvec3 lower(VTK_DOUBLE_MAX);
  glm::dvec3 upper(-VTK_DOUBLE_MAX);
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    lower = glm::min(lower, vtkIndirectFrame::GetCorner(caster.GetFit(), 0));
    upper = glm::max(upper, vtkIndirectFrame::GetCorner(caster.GetFit(), 7));
  }
  lower = frame.ToScene(lower);
  upper = frame.ToScene(upper);
  const glm::dvec3 middle = 0.5 * (lower + upper);
  if (!this->Light.Positional)
  {
    this->Axis = this->Light.DirectionWC;
    FindAxes(this->Axis, this->U, this->V);
    const glm::dvec3 half = 0.5 * (upper - lower);
    this->HalfWidths = { glm::dot(half, glm::abs(this->U)), glm::dot(half, glm::abs(this->V)) };
    // A flat scene seen edge-on has no width of its own.
    this->HalfWidths = glm::max(this->HalfWidths,
      glm::dvec2(1e-3 * std::max({ this->HalfWidths.x, this->HalfWidths.y, 1e-3 })));
    this->Origin = middle - 1.01 * (glm::dot(half, glm::abs(this->Axis)) + 1e-3) * this->Axis;
    const vtkIndirectSeenBox& part = frame.Seen.Near;
    const glm::dvec2 at(
      glm::dot(part.Middle - middle, this->U), glm::dot(part.Middle - middle, this->V));
    const glm::dvec2 reach(part.FindReach(this->U), part.FindReach(this->V));
    this->LowerOfPart = glm::max(at - ReachOfPart * reach, -this->HalfWidths);
    this->UpperOfPart = glm::min(at + ReachOfPart * reach, this->HalfWidths);
    this->IsPart = part.IsPart() && glm::all(glm::lessThan(this->LowerOfPart, this->UpperOfPart));
    return;
  }
  this->Origin = frame.ToScene(this->Light.PositionWC);
  const glm::dvec3 toMiddle = middle - this->Origin;
  const double distance = glm::length(toMiddle);
  const double radius = 0.501 * glm::length(upper - lower);
  const bool spot = this->Light.ConeAngle < 90.0;
  const double cosCone = spot ? std::cos(vtkMath::RadiansFromDegrees(this->Light.ConeAngle)) : -1.0;
  const double cosAim =
    distance > radius ? std::sqrt((distance - radius) * (distance + radius)) / distance : -1.0;
  if (cosAim > cosCone)
  {
    this->Axis = toMiddle / distance;
    this->CosCone = cosAim;
  }
  else
  {
    this->Axis = this->Light.DirectionWC;
    this->CosCone = cosCone;
    this->Exponent = spot ? this->Light.Exponent : 0.0;
  }
  FindAxes(this->Axis, this->U, this->V);
}

//------------------------------------------------------------------------------
void vtkIndirectRandomWalk::Emission::MakeRay(
  const glm::dvec2& at, glm::dvec3& start, glm::dvec3& direction, double& footprint) const
{
  if (!this->Light.Positional)
  {
    glm::dvec2 p = (2.0 * at - 1.0) * this->HalfWidths;
    footprint = 4.0 * this->HalfWidths.x * this->HalfWidths.y;
    if (this->IsPart)
    {
      const glm::dvec2 size = this->UpperOfPart - this->LowerOfPart;
      const bool first = at.x < 0.5;
      p = first ? this->LowerOfPart + glm::dvec2(2.0 * at.x, at.y) * size
                : (glm::dvec2(4.0 * at.x - 3.0, 2.0 * at.y - 1.0)) * this->HalfWidths;
      const bool within = glm::all(glm::greaterThanEqual(p, this->LowerOfPart)) &&
        glm::all(glm::lessThanEqual(p, this->UpperOfPart));
      footprint = 1.0 / (0.5 / footprint + (within ? 0.5 / (size.x * size.y) : 0.0));
    }
    start = this->Origin + p.x * this->U + p.y * this->V;
    direction = this->Axis;
    return;
  }
  // The density goes by the power of the cosine: its integral from the cone's border is uniform in
  // the first number.
  const double power = this->Exponent + 1.0;
  const double border = this->Exponent > 0.0 ? std::pow(this->CosCone, power) : this->CosCone;
  const double inverted = 1.0 - at.x * (1.0 - border);
  const double cosine = this->Exponent > 0.0 ? std::pow(inverted, 1.0 / power) : inverted;
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  const double angle = TwoPi * at.y;
  start = this->Origin;
  direction = glm::normalize(
    cosine * this->Axis + sine * (std::cos(angle) * this->U + std::sin(angle) * this->V));
  footprint = TwoPi * (1.0 - border) / power;
  if (this->Exponent > 0.0)
  {
    footprint /= std::pow(std::max(cosine, 1e-6), this->Exponent);
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectRandomWalk::Emission::FindStrength(
  const glm::dvec3& direction, double distance) const
{
  const vtkIndirectLight& light = this->Light;
  return light.Positional
    ? distance * distance * light.FindFalloff(direction, distance / this->SceneScale) * light.Color
    : light.Color;
}

//------------------------------------------------------------------------------
vtkIndirectRandomWalk::List vtkIndirectRandomWalk::Trace(const vtkIndirectSurfaces& surfaces,
  const Emission& emission, int place, size_t paths, double flux, int firstBounce,
  int lastBounce) const
{
  const size_t blocks = (paths + PathsAtATime - 1) / PathsAtATime;
  std::vector<List> found(blocks);
  const auto walk = [&](size_t path, List& list)
  {
    const uint32_t number = static_cast<uint32_t>(path);
    const uint32_t seed =
      vtkIndirectSamplePattern::Hash(static_cast<uint32_t>(place) * 64u + 0x51ed270bu);
    glm::dvec3 start;
    glm::dvec3 direction;
    double footprint;
    emission.MakeRay(ScrambledPoint(number, seed), start, direction, footprint);
    // A path ends where it carries less than a first vertex of its footprint: ended by less than
    // the mean, paths of the part that is seen would be few and bright.
    const double ratio = emission.FindRatio(footprint);
    const double most = flux * ratio / static_cast<double>(paths);
    footprint /= static_cast<double>(paths);
    glm::dvec3 carried(0.0);
    uint32_t last = vtkIndirectTriangleTree::None;
    vtkIndirectSurfaces::Meeting meeting;
    for (int bounce = 1; bounce <= lastBounce; ++bounce)
    {
      if (!surfaces.Meet(start, direction, last, meeting) || !meeting.Sends)
      {
        return;
      }
      const double shading = std::max(-glm::dot(meeting.Normal, direction), 0.0);
      const double facet = -glm::dot(meeting.FacetNormal, direction);
      Vertex vertex;
      vertex.Area = 0.0;
      glm::dvec3 reflected = meeting.Albedo;
      if (bounce == 1)
      {
        const double cosine = std::max(facet, LeastCosineToLight);
        carried = footprint * emission.FindStrength(direction, meeting.Distance);
        vertex.Area = footprint * emission.FindSpread(meeting.Distance) / cosine;
        reflected *=
          shading / cosine * (emission.IsVTKLight() ? meeting.GetShareOfVTKLights() : 1.0);
      }
      else
      {
        reflected *= shading / std::max(facet, LeastFacetCosine);
      }
      carried *= reflected;
      if (!(Largest(carried) > 0.0) || !std::isfinite(carried.x + carried.y + carried.z))
      {
        return;
      }
      if (bounce >= firstBounce)
      {
        vertex.Position = meeting.Position;
        vertex.Normal = meeting.FacetNormal;
        vertex.DensityArea = carried;
        vertex.Emitter = place;
        vertex.Bounce = bounce;
        vertex.Footprint = ratio;
        list.push_back(vertex);
      }
      if (bounce == lastBounce)
      {
        return;
      }
      const uint32_t dimension = seed + 2u * static_cast<uint32_t>(bounce);
      const double onward = std::min(Largest(carried) / most, 1.0);
      if (!(ScrambledPoint(number, dimension).x < onward))
      {
        return;
      }
      carried /= onward;
      direction = CosineDirection(meeting.FacetNormal, ScrambledPoint(number, dimension + 1u));
      start = meeting.Position + Clearance * meeting.FacetNormal;
      last = meeting.Triangle;
    }
  };
  vtkSMPTools::For(0, static_cast<vtkIdType>(blocks),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType block = begin; block < end; ++block)
      {
        const size_t first = static_cast<size_t>(block) * PathsAtATime;
        for (size_t path = first; path < std::min(first + PathsAtATime, paths); ++path)
        {
          walk(path, found[static_cast<size_t>(block)]);
        }
      }
    });
  List all;
  for (const List& list : found)
  {
    all.insert(all.end(), list.begin(), list.end());
  }
  return all;
}

//------------------------------------------------------------------------------
vtkIndirectRandomWalk::List vtkIndirectRandomWalk::TracePilot(const vtkIndirectSurfaces& surfaces,
  const Emission& emission, int place, double flux, int firstBounce, int lastBounce,
  size_t& paths) const
{
  List found;
  const size_t most = emission.IsDark() ? 0 : MostPilotPaths;
  paths = PilotPaths;
  for (size_t next = paths; next <= most && found.size() < PilotVertices; next *= 8)
  {
    paths = next;
    found = this->Trace(surfaces, emission, place, paths, flux, firstBounce, lastBounce);
  }
  return found;
}

//------------------------------------------------------------------------------
// Sets each vertex's area to one over the density of all vertices of later bounces: the circle of
// the nearest vertices on similarly oriented surfaces. The outermost vertex is on the circle's
// border and counts half.
void vtkIndirectRandomWalk::FindAreas()
{
  std::vector<size_t> members;
  std::vector<glm::dvec3> places;
  for (size_t i = 0; i < this->Vertices.size(); ++i)
  {
    if (this->Vertices[i].Bounce > 1)
    {
      members.push_back(i);
      places.push_back(this->Vertices[i].Position);
    }
  }
  if (members.empty())
  {
    return;
  }
  const PointTree tree(std::move(places));
  vtkSMPTools::For(0, static_cast<vtkIdType>(members.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      PointTree::Found nearest;
      for (vtkIdType i = begin; i < end; ++i)
      {
        Vertex& vertex = this->Vertices[members[tree.GetOrder()[static_cast<size_t>(i)]]];
        // Twice as many are searched, because some of them lie around a corner.
        tree.FindNearest(vertex.Position, 2 * Neighbors, nearest);
        int alike = 0;
        double farthest = 0.0;
        for (size_t k = 0; k < nearest.size() && alike < Neighbors; ++k)
        {
          const Vertex& other = this->Vertices[members[nearest[k].second]];
          if (glm::dot(other.Normal, vertex.Normal) > 0.5)
          {
            ++alike;
            const glm::dvec3 apart = other.Position - vertex.Position;
            farthest = std::max(farthest, glm::dot(apart, apart));
          }
        }
        // A vertex without neighbours represents the remaining area: a disk half as wide as the
        // scene.
        vertex.Area = farthest > 0.0 ? Pi * farthest / (alike - 0.5) : Pi / 16.0;
      }
    });
}

//------------------------------------------------------------------------------
void vtkIndirectRandomWalk::FindTail(int lastBounce)
{
  int firstBounce = lastBounce;
  for (const Vertex& vertex : this->Vertices)
  {
    firstBounce = std::min(firstBounce, vertex.Bounce);
  }
  double all = 0.0;
  double first = 0.0;
  double last = 0.0;
  for (const Vertex& vertex : this->Vertices)
  {
    const double light = vertex.DensityArea.x + vertex.DensityArea.y + vertex.DensityArea.z;
    all += light;
    first += vertex.Bounce == firstBounce ? light : 0.0;
    last += vertex.Bounce == lastBounce ? light : 0.0;
  }
  // If no light is lost the series has no end; one bounce alone tells nothing about further ones.
  const double kept =
    firstBounce < lastBounce && all > last ? std::min((all - first) / (all - last), 0.999) : 0.0;
  const double tail = last * kept / (1.0 - kept);
  this->Tail = all > 0.0 ? tail / (all + tail) : 0.0;
}

//------------------------------------------------------------------------------
void vtkIndirectRandomWalk::Walk(const vtkIndirectSurfaces& surfaces, const vtkIndirectFrame& frame,
  const vtkIndirectEmitters::List& emitters, const Settings& settings)
{
  this->Vertices.clear();
  this->NumberOfPaths = 0;
  // A few paths of each light tell how much of its light is reflected, and how many vertices a path
  // has.
  std::vector<Emission> emissions;
  std::vector<double> powers;
  std::vector<double> fluxes;
  std::vector<double> lengths;
  double total = 0.0;
  for (size_t i = 0; i < emitters.size(); ++i)
  {
    const Emission& emission = emissions.emplace_back(frame, emitters[i]);
    const int place = static_cast<int>(i);
    // The mean flux of first vertices, weighted by that flux itself: it differs with the distance
    // from the light and with the albedo.
    size_t paths = 0;
    double sum = 0.0;
    double squares = 0.0;
    for (const Vertex& vertex : this->TracePilot(surfaces, emission, place, 1.0, 1, 1, paths))
    {
      const double flux = Largest(vertex.DensityArea);
      sum += flux;
      squares += flux * flux / vertex.Footprint;
    }
    fluxes.push_back(sum > 0.0 ? squares / sum * static_cast<double>(paths) : 0.0);
    const List pilot = sum > 0.0
      ? this->TracePilot(surfaces, emission, place, fluxes.back(),
          std::max(settings.FirstBounce, emitters[i].FirstBounce), settings.LastBounce, paths)
      : List();
    double power = 0.0;
    for (const Vertex& vertex : pilot)
    {
      power += vertex.DensityArea.x + vertex.DensityArea.y + vertex.DensityArea.z;
    }
    powers.push_back(power);
    lengths.push_back(static_cast<double>(pilot.size()) / static_cast<double>(paths));
    total += power;
  }
  double perPath = 0.0;
  for (size_t i = 0; i < emitters.size() && total > 0.0; ++i)
  {
    perPath += powers[i] / total * lengths[i];
  }
  for (size_t i = 0; i < emitters.size() && perPath > 0.0; ++i)
  {
    const double share =
      powers[i] / total * settings.NumberOfVertices / std::max(perPath, 1.0 / MostPathsOfVertex);
    if (!(share > 0.0))
    {
      continue;
    }
    // The number of paths changes in steps, so that a light that moves a little keeps its paths.
    const size_t step = share > 256.0 ? 16 : 1;
    const size_t paths = std::max<size_t>(static_cast<size_t>(share) / step * step, 1);
    const List found = this->Trace(surfaces, emissions[i], static_cast<int>(i), paths, fluxes[i],
      std::max(settings.FirstBounce, emitters[i].FirstBounce), settings.LastBounce);
    this->Vertices.insert(this->Vertices.end(), found.begin(), found.end());
    this->NumberOfPaths += paths;
  }
  this->FindAreas();
  this->FindTail(settings.LastBounce);
}
