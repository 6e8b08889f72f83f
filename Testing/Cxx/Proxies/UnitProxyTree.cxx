// SPDX-License-Identifier: BSD-3-Clause
// Spheres in groups: at any position, the weights of all entries that represent a sphere add up to
// one. And shapes found for meshes.
#include "vtkIndirectTestUtilities.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Proxies/vtkIndirectProxyLight.h"
#include "Proxies/vtkIndirectProxyShapes.h"
#include "Proxies/vtkIndirectProxyTree.h"
#include "vtkAppendPolyData.h"
#include "vtkCubeSource.h"
#include "vtkDiskSource.h"
#include "vtkEnvironmentLight.h"
#include "vtkMath.h"
#include "vtkPlaneSource.h"
#include "vtkPolyData.h"
#include "vtkRegularPolygonSource.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;
using Entry = vtkIndirectProxyTree::Entry;
using Spheres = std::vector<vtkIndirectProxySphere>;

namespace
{
Spheres MakeSpheres(int count, std::uint64_t seed)
{
  Random random(seed);
  Spheres spheres;
  for (int i = 0; i < count; ++i)
  {
    vtkIndirectProxySphere sphere;
    sphere.Center =
      glm::dvec3(random.Next(-0.3, 0.3), random.Next(-0.2, 0.2), random.Next(-0.1, 0.1));
    sphere.Radius = random.NextMagnitude(1e-4, 1e-3);
    sphere.Albedo = glm::vec3(random.Next(), 0.5f, 1.0f);
    spheres.push_back(sphere);
  }
  return spheres;
}

double WeightOf(const Entry& entry, const glm::vec3& place)
{
  return vtkiProxyWeight(glm::length(entry.OuterCenter - place), entry.Outer,
    glm::length(entry.Center - place), entry.Inner);
}

// Adds the weights of an entry and its ancestors, for each sphere below it.
void AddWeights(const std::vector<Entry>& entries, int number, double above, const glm::vec3& place,
  std::vector<double>& sums)
{
  const Entry& entry = entries[static_cast<size_t>(number)];
  const double weight = above + WeightOf(entry, place);
  if (entry.Inner <= 0.0f)
  {
    sums.push_back(weight);
    return;
  }
  for (int child = number + 1; child != entry.Next;
       child = entries[static_cast<size_t>(child)].Next)
  {
    AddWeights(entries, child, weight, place, sums);
  }
}
}

VTK_INDIRECT_TEST(ProxyTreeWeights)
{
  Random random(5);
  double worst = 0.0;
  for (const int count : { 1, 2, 3, 4, 5, 17, 300, 2000 })
  {
    vtkIndirectProxyTree tree;
    tree.Build(MakeSpheres(count, static_cast<std::uint64_t>(count)), 0.4, 0.0);
    for (int trial = 0; trial < 40; ++trial)
    {
      const glm::vec3 place(
        static_cast<float>(random.NextMagnitude(1e-3, 3.0)) * glm::vec3(random.NextDirection()));
      std::vector<double> sums;
      AddWeights(tree.GetEntries(), 0, 0.0, place, sums);
      CheckEqual("spheres below the root", static_cast<double>(sums.size()), count);
      for (const double sum : sums)
      {
        worst = std::max(worst, std::abs(sum - 1.0));
      }
    }
  }
  CheckAtMost("weights of what stands for a sphere, off from one", worst, 1e-3,
    "floats in smooth steps; where two bands met it would be 1");
}

VTK_INDIRECT_TEST(ProxyTreeSkipsNothing)
{
  // The entries of a receiver's descent through the tree are all that count, and those of the lists
  // by blocks.
  vtkIndirectProxyTree tree;
  tree.Build(MakeSpheres(3000, 11), 0.4, 0.0);
  const std::vector<Entry>& entries = tree.GetEntries();
  Random random(13);
  double met = 0.0;
  double missed = 0.0;
  double outside = 0.0;
  double visited = 0.0;
  for (int trial = 0; trial < 60; ++trial)
  {
    const glm::vec3 place(
      static_cast<float>(random.NextMagnitude(1e-2, 1.0)) * glm::vec3(random.NextDirection()));
    double all = 0.0;
    for (size_t i = 0; i < entries.size(); ++i)
    {
      const double weight = WeightOf(entries[i], place);
      all += weight;
      const vtkIndirectProxyTree::Block& block = tree.GetBlocks()[i / VTKI_ROW_LENGTH];
      const bool inBlock = glm::all(glm::lessThanEqual(block.Lower, place)) &&
        glm::all(glm::greaterThanEqual(block.Upper, place));
      const bool listed = vtkiProxyMeetsBox(place, glm::vec3(1e-6f), entries[i].OuterCenter,
        entries[i].Outer, entries[i].Center, entries[i].Inner);
      outside += weight > 0.0 && !(inBlock && listed) ? weight : 0.0;
    }
    double down = 0.0;
    for (int i = 0; i >= 0;)
    {
      const Entry& entry = entries[static_cast<size_t>(i)];
      down += WeightOf(entry, place);
      const bool goes = glm::length(entry.OuterCenter - place) < entry.Outer &&
        glm::length(entry.Center - place) < entry.Inner;
      i = goes ? i + 1 : entry.Next;
      visited += 1.0 / 60.0;
    }
    met += down;
    missed = std::max(missed, std::abs(all - down));
  }
  Check("something counts", met > 60.0);
  CheckAtMost("weight that is not met", missed, 1e-3, "rounding of sums");
  CheckEqual("weight outside of blocks and lists", outside, 0.0);
  CheckAtMost("entries visited of 4000, on average", visited, 600.0, "most of it is far away");
}

VTK_INDIRECT_TEST(ProxyTreeBounds)
{
  // The bound excludes only entries wholly below a receiver.
  vtkIndirectProxyTree tree;
  tree.Build(MakeSpheres(3000, 17), 0.4, 0.0);
  const std::vector<Entry>& entries = tree.GetEntries();
  double farthest = 0.0;
  double groups = 0.0;
  double width = 0.0;
  for (size_t i = 0; i < entries.size(); ++i)
  {
    const size_t end = entries[i].Next < 0 ? entries.size() : static_cast<size_t>(entries[i].Next);
    double reach = 0.0;
    for (size_t k = i; k < end; ++k)
    {
      reach = std::max(reach,
        static_cast<double>(
          glm::length(entries[k].Center - entries[i].Center) + entries[k].Radius));
    }
    farthest = std::max(farthest, reach / entries[i].Bound);
    groups += end > i + 1 ? 1.0 : 0.0;
    width += end > i + 1 ? entries[i].Bound / reach : 0.0;
  }
  Check("there are groups", groups > 900.0);
  CheckAtMost("what is below an entry, over its bound", farthest, 1.0 + 1e-5, "rounding");
  CheckAtMost("bounds over what they hold, on average", width / groups, 1.5,
    "sums of the ways down, not the farthest sphere");
}

VTK_INDIRECT_TEST(ProxyRegionsInATexel)
{
  Random random(19);
  double way = 0.0;
  double radii = 0.0;
  double share = 0.0;
  bool finite = true;
  for (int trial = 0; trial < 2000; ++trial)
  {
    vtkiRegion region;
    region.Outer = vtkiPairedAbove(static_cast<float>(random.NextMagnitude(1e-6, 1e8)));
    region.ToOuter =
      region.Outer * static_cast<float>(random.Next()) * glm::vec3(random.NextDirection());
    region.Inner = trial % 3 == 0 ? 0.0f
      : trial % 3 == 1            ? -1.0f
                       : vtkiPairedAbove(static_cast<float>(random.NextMagnitude(1e-6, 1e8)));
    region.Bound = vtkiPairedAbove(static_cast<float>(random.NextMagnitude(1e-6, 1e8)));
    region.Share = static_cast<float>(random.Next());
    region.Next = static_cast<float>(trial - 1);
    const glm::vec4 texel = vtkiPackRegion(region);
    for (int i = 0; i < 4; ++i)
    {
      finite = finite && (std::isnormal(texel[i]) || texel[i] == 0.0f);
    }
    const vtkiRegion found = vtkiUnpackRegion(texel);
    way = std::max(
      way, static_cast<double>(glm::length(found.ToOuter - region.ToOuter) / region.Outer));
    radii += found.Outer == region.Outer && found.Inner == region.Inner &&
        found.Bound == region.Bound && found.Next == region.Next
      ? 0.0
      : 1.0;
    share = std::max(share, std::abs(static_cast<double>(found.Share) - region.Share));
  }
  Check("no texel is a special number", finite);
  CheckEqual("regions whose radii or next entry are others", radii, 0.0);
  CheckAtMost("the way to the region's centre, over its radius", way, 2.5e-3,
    "half a step of each coordinate: 1/1022, 1/1022, 1/510");
  CheckAtMost("the share", share, 2.0e-3, "8 bits of mantissa");
}

VTK_INDIRECT_TEST(ProxyTreeGroups)
{
  // Far away a group's area is about that of its spheres, and no larger.
  Spheres cloud;
  Random random(7);
  double area = 0.0;
  for (int i = 0; i < 64; ++i)
  {
    vtkIndirectProxySphere sphere;
    sphere.Center = 0.2 * std::cbrt(random.Next()) * random.NextDirection();
    sphere.Radius = 0.001;
    sphere.Albedo = glm::vec3(i % 2 ? 1.0f : 0.0f);
    area += sphere.Radius * sphere.Radius;
    cloud.push_back(sphere);
  }
  vtkIndirectProxyTree tree;
  tree.Build(cloud, 0.4, 0.0);
  const Entry& root = tree.GetEntries().front();
  CheckRelative("area of a thin cloud", root.Share * root.Radius * root.Radius, area, 0.01,
    "64 (0.001 / 0.2)^2 = 0.0016 of it hides each other");
  CheckRelative("its radius", root.Radius, 0.2, 0.1, "64 places at random in a ball");
  CheckRelative("its albedo", root.Albedo.x, 0.5, 1e-5, "half of them");
  // 100,000 spheres at one place are one.
  const Spheres same(100000, cloud.front());
  tree.Build(same, 0.4, 0.0);
  const Entry& one = tree.GetEntries().front();
  CheckRelative("radius of 100,000 at one place", one.Radius, 0.001, 1e-4, "rounding");
  CheckEqual("all of its disk hides", one.Share, 1.0);
  CheckEqual("entries", static_cast<double>(tree.GetEntries().size()), 1.0);
  tree.Build(cloud, 0.0, 15.0);
  CheckEqual("without groups", static_cast<double>(tree.GetEntries().size()), 64.0);
  CheckRelative("a region of influence", tree.GetEntries()[3].Outer, 0.015, 1e-6, "15 radii");
  tree.Build({}, 0.4, 0.0);
  CheckEqual("of nothing", static_cast<double>(tree.GetEntries().size()), 0.0);
}

VTK_INDIRECT_TEST(ProxyTreeSenders)
{
  // A sender is one of the spheres that it represents, never a point between them; entries refer to
  // senders, or means of them.
  for (const int count : { 1, 5, 300, 5000 })
  {
    const Spheres spheres = MakeSpheres(count, 3);
    vtkIndirectProxyTree tree;
    tree.Build(spheres, 0.4, 15.0);
    const auto& senders = tree.GetSenders();
    int spheresAmongThem = 0;
    for (const auto& sender : senders)
    {
      spheresAmongThem += std::any_of(spheres.begin(), spheres.end(),
                            [&sender](const vtkIndirectProxySphere& sphere)
                            {
                              return glm::vec3(sphere.Center) == sender.Center &&
                                static_cast<float>(sphere.Radius) == sender.Radius;
                            })
        ? 1
        : 0;
    }
    const std::string name = std::to_string(count) + " spheres";
    const int number = static_cast<int>(senders.size());
    CheckEqual(name + ": senders that are spheres", spheresAmongThem, number);
    if (count <= 2048)
    {
      CheckEqual(name + ": senders", number, count);
    }
    else
    {
      CheckAtMost(name + ": senders", number, count / 2, "two to eight spheres each");
      CheckAtLeast(name + ": senders, at least", number, count / 8, "two to eight spheres each");
    }
    const int known = number + static_cast<int>(tree.GetMeans().size());
    Check(name + ": all entries have one",
      std::all_of(tree.GetEntries().begin(), tree.GetEntries().end(),
        [known](const Entry& entry) { return entry.Sender >= 0 && entry.Sender < known; }));
  }
}

VTK_INDIRECT_TEST(ProxyShapesOfMeshes)
{
  using Shapes = vtkIndirectProxyShapes;
  vtkNew<vtkAppendPolyData> both;
  double largest = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    vtkNew<vtkSphereSource> source;
    source->SetCenter(10.0 * i, 1e3, -2.0);
    source->SetRadius(1.0 + i);
    source->SetThetaResolution(8 + 3 * i);
    source->SetPhiResolution(8);
    source->Update();
    both->AddInputData(source->GetOutput());
  }
  both->Update();
  Shapes::Shape shape;
  Check("three spheres are found", Shapes::FindSpheres(both->GetOutput(), shape));
  CheckEqual("their number", static_cast<double>(shape.Spheres.size()), 3.0);
  for (size_t i = 0; i < shape.Spheres.size(); ++i)
  {
    const double n = static_cast<double>(i);
    largest = std::max({ largest, std::abs(shape.Spheres[i].Radius - 1.0 - n),
      glm::length(shape.Spheres[i].Center - glm::dvec3(10.0 * n, 1e3, -2.0)) });
  }
  CheckAtMost("places and radii are off", largest, 1e-3, "points in floats a thousand units away");

  vtkNew<vtkCubeSource> cube;
  cube->Update();
  Check("a cube is no sphere", !Shapes::FindSpheres(cube->GetOutput(), shape));
  CheckEqual("and nothing is left of the try", static_cast<double>(shape.Spheres.size()), 0.0);
  Check("nor is it flat", !Shapes::FindPolygon(cube->GetOutput(), shape));

  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(7, 3);
  plane->SetPoint1(3.0, 0.5, 1.0);
  plane->Update();
  Check("a plane is a polygon", Shapes::FindPolygon(plane->GetOutput(), shape));
  CheckEqual("with four corners", static_cast<double>(shape.Polygons.front().Corners.size()), 4.0);
  // Its disk, seen from above its middle, gives the polygon's irradiance.
  const std::vector<glm::dvec3>& corners = shape.Polygons.front().Corners;
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& corner : corners)
  {
    middle += 0.25 * corner;
  }
  const glm::dvec3 normal = vtkIndirectProxyLight::FindNormal(shape.Polygons.front());
  const glm::dvec3 eye = middle + 0.7 * normal;
  vec3 sum(0.0f);
  for (size_t i = 0; i < 4; ++i)
  {
    sum += vtkiPolygonEdge(
      vec3(glm::normalize(corners[i] - eye)), vec3(glm::normalize(corners[(i + 1) % 4] - eye)));
  }
  const vec4 disk = vtkiPolygonDisk(sum);
  CheckRelative("squared sine of its disk", disk.w * disk.w,
    std::abs(PolygonFormFactor(eye, -normal, corners)), 1e-4, "Lambert's formula");
  CheckRelative("its direction", std::abs(glm::dot(glm::dvec3(disk.x, disk.y, disk.z), normal)),
    1.0, 1e-5, "rounding");

  vtkNew<vtkDiskSource> ring;
  ring->SetCircumferentialResolution(40);
  ring->Update();
  Check("a ring has a hole", !Shapes::FindPolygon(ring->GetOutput(), shape));
  vtkNew<vtkRegularPolygonSource> round;
  round->SetNumberOfSides(100);
  round->SetRadius(2.0);
  round->GeneratePolylineOff();
  round->Update();
  Check("a disk has none", Shapes::FindPolygon(round->GetOutput(), shape));
  double area = 0.0;
  const std::vector<glm::dvec3>& outline = shape.Polygons.front().Corners;
  for (size_t i = 2; i < outline.size(); ++i)
  {
    area += 0.5 * glm::length(glm::cross(outline[i - 1] - outline[0], outline[i] - outline[0]));
  }
  CheckRelative("area of eight corners for a hundred", area, 4.0 * vtkMath::Pi(), 2e-3,
    "a polygon of a hundred sides: 1 - 2 pi^2 / 3 / 100^2");
}

VTK_INDIRECT_TEST(ProxyLightOfAnEnvironment)
{
  vtkNew<vtkEnvironmentLight> sky;
  sky->SetRadiance(2.0, 1.0, 0.5);
  const vtkIndirectProxyLight::Coefficients light = vtkIndirectProxyLight::Project(sky);
  CheckRelative(
    "a uniform sky", light[0].x * VTKI_HARMONICS_Y00, 2.0, 1e-5, "cells tile the sphere");
  double rest = 0.0;
  for (size_t i = 1; i < light.size(); ++i)
  {
    rest = std::max(rest, glm::length(light[i]));
  }
  CheckAtMost("and nothing else", rest, 1e-2, "cells of 1.4 degrees");
  // Irradiance by its gradient, about a normal.
  Random random(3);
  vtkiHarmonics4 any;
  any.A = vec4(3.0f, 0.3f, -0.2f, 0.5f);
  any.B = vec4(0.2f, -0.4f, 0.1f, 0.3f);
  any.C = vec4(0.25f, 0.0f, 0.0f, 0.0f);
  any.D = vec4(0.0f);
  double worst = 0.0;
  double exact = 0.0;
  for (int trial = 0; trial < 20; ++trial)
  {
    const glm::dvec3 n = random.NextDirection();
    const glm::dvec3 near = glm::normalize(n + 0.1 * random.NextDirection());
    const double at = vtkiHarmonicsDot(any, vtkiClampedCosine(vec3(n)));
    const double there = vtkiHarmonicsDot(any, vtkiClampedCosine(vec3(near)));
    const vec3 gradient = vtkiIrradianceGradient(any, vec3(n));
    worst = std::max(worst, std::abs(at + glm::dot(glm::dvec3(gradient), near - n) - there));
    exact = std::max(exact, std::abs(there - at));
  }
  CheckAtMost("irradiance 6 degrees away, by its gradient", worst, 0.003,
    "0.1^2 / 2 times second derivatives of about 0.5");
  CheckAtLeast("what it would be without", exact, 0.02, "so the test can fail");
}
