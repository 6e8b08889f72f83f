// SPDX-License-Identifier: BSD-3-Clause
// The scene's surfaces on the processor: rays meet the first triangle, glyph or sphere, with its
// colour and its side; nothing leaves a closed box; and the scene is read once.
#include "Scene/vtkIndirectSurfaces.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "vtkIndirectSurfaceFrame.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkGlyph3DMapper.h"
#include "vtkPlaneSource.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace vtkIndirectTest;

VTK_INDIRECT_TEST(SurfacesSameAsLoop)
{
  // Against every triangle by itself, with another formula: the plane, and the three areas.
  Random random(17);
  SurfaceFrame scene;
  std::vector<SurfaceFrame::Corners> triangles;
  for (int i = 0; i < 300; ++i)
  {
    const glm::dvec3 at(random.Next(), random.Next(), random.Next());
    const double size = i % 3 == 0 ? 0.6 : 0.03;
    triangles.push_back(
      { at, at + size * random.NextDirection(), at + size * random.NextDirection() });
    scene.Add({ triangles.back() }, i / 300.0);
  }
  vtkIndirectSurfaces surfaces;
  surfaces.Update(scene.Frame);
  int wrong = 0;
  int met = 0;
  int compared = 0;
  for (int i = 0; i < 6000; ++i)
  {
    const double span = i % 4 == 0 ? 3.0 : 1.0; // some start outside
    const glm::dvec3 start =
      span * (glm::dvec3(random.Next(), random.Next(), random.Next()) - 0.5) + 0.5;
    const glm::dvec3 direction =
      i % 10 == 0 ? glm::dvec3(0.0, 0.0, i % 20 ? 1.0 : -1.0) : random.NextDirection();
    double nearest = INFINITY;
    int expected = -1;
    bool close = false; // to an edge, or to another triangle
    for (size_t k = 0; k < triangles.size(); ++k)
    {
      const auto& v = triangles[k];
      const glm::dvec3 normal = glm::cross(v[1] - v[0], v[2] - v[0]);
      const double along = glm::dot(normal, direction);
      const double t = glm::dot(normal, v[0] - start) / along;
      if (!(t > 0.0))
      {
        continue;
      }
      const glm::dvec3 p = start + t * direction;
      double least = INFINITY;
      for (int e = 0; e < 3; ++e)
      {
        const glm::dvec3& a = v[e];
        least = std::min(least,
          glm::dot(glm::cross(v[(e + 1) % 3] - a, p - a), normal) / glm::dot(normal, normal));
      }
      close = close || std::abs(least) < 1e-3 || (least > 0.0 && std::abs(t - nearest) < 1e-4);
      if (least > 0.0 && t < nearest)
      {
        nearest = t;
        expected = static_cast<int>(k);
      }
    }
    if (close)
    {
      continue;
    }
    ++compared;
    vtkIndirectSurfaces::Meeting meeting;
    const bool found = surfaces.Meet(start, direction, vtkIndirectTriangleTree::None, meeting);
    met += found;
    wrong += found != (expected >= 0);
    if (found && expected >= 0)
    {
      wrong += glm::length(meeting.Position - (start + nearest * direction)) > 1e-9 ||
        std::abs(meeting.Albedo.x - expected / 300.0) > 1e-12 ||
        glm::dot(meeting.FacetNormal, direction) > 0.0;
    }
  }
  CheckEqual("rays that meet another triangle, or from another side", wrong, 0);
  CheckAtLeast("rays that meet one", met, 1500, "the test's own power");
  CheckAtLeast("rays that meet none", compared - met, 1500, "the test's own power");
}

// Nothing gets out of a closed box, not through its edges and corners either.
VTK_INDIRECT_TEST(SurfacesClosedBox)
{
  Random random(19);
  std::vector<SurfaceFrame::Corners> triangles;
  constexpr int pieces = 7;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const double side : { 0.1, 0.9 })
    {
      const auto at = [&](int i, int j)
      {
        glm::dvec3 p(0.0);
        p[axis] = side;
        p[(axis + 1) % 3] = 0.1 + 0.8 / pieces * i;
        p[(axis + 2) % 3] = 0.1 + 0.8 / pieces * j;
        return p;
      };
      for (int i = 0; i < pieces; ++i)
      {
        for (int j = 0; j < pieces; ++j)
        {
          triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
          triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
        }
      }
    }
  }
  SurfaceFrame scene;
  scene.Add(triangles, 0.5);
  vtkIndirectSurfaces surfaces;
  surfaces.Update(scene.Frame);
  int out = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const glm::dvec3 start(random.Next(0.2, 0.8), random.Next(0.2, 0.8), random.Next(0.2, 0.8));
    glm::dvec3 end(random.Next(0.1, 0.9), random.Next(0.1, 0.9), random.Next(0.1, 0.9));
    for (int axis = 0; axis < 3; ++axis)
    {
      // On vertices of the pieces, on their edges, and anywhere.
      end[axis] = (i >> axis & 1) ? 0.1 + 0.8 / pieces * std::floor(7.999 * (end[axis] - 0.1) / 0.8)
                                  : end[axis];
    }
    end[i % 3] = i & 8 ? 0.1 : 0.9;
    vtkIndirectSurfaces::Meeting meeting;
    out +=
      !surfaces.Meet(start, glm::normalize(end - start), vtkIndirectTriangleTree::None, meeting);
  }
  CheckEqual("rays that leave a closed box", out, 0);
}

// One list and one tree: triangles, glyphs and spheres stop rays and segments alike, and what rays
// pass through, a culled face, blocks segments still.
VTK_INDIRECT_TEST(SurfacesOfAllKinds)
{
  SurfaceFrame scene;
  const auto wall = [](double x)
  {
    return std::vector<SurfaceFrame::Corners>{ { glm::dvec3(x, 0, 0), glm::dvec3(x, 1, 0),
      glm::dvec3(x, 0, 1) } };
  };
  vtkActor* const triangle = scene.Add(wall(0.2), 0.2);
  triangle->GetProperty()->BackfaceCullingOn();
  vtkNew<vtkPlaneSource> square;
  square->SetNormal(1, 0, 0);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.4, 0.25, 0.25);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  vtkNew<vtkGlyph3DMapper> glyphs;
  glyphs->SetInputData(data);
  glyphs->SetSourceConnection(square->GetOutputPort());
  glyphs->Update();
  square->Update();
  vtkNew<vtkActor> actor;
  actor->SetMapper(glyphs);
  actor->GetProperty()->SetColor(0.4, 0.4, 0.4);
  scene.Add(actor);
  vtkIndirectBlockingSpheres spheres;
  spheres.Spheres = { { 0.7, 0.25, 0.25, 0.1 } };
  spheres.Looks = { { glm::vec3(0.6f), false } };
  spheres.NumberOfUpdates = 1;
  vtkIndirectSurfaces surfaces;
  surfaces.Update(scene.Frame, &spheres);
  CheckEqual("triangles", surfaces.GetTree().GetNumberOfTriangles(), size_t(3));
  CheckEqual("spheres", surfaces.GetTree().GetNumberOfSpheres(), size_t(1));
  const auto meet = [&](double from, double towards, double place, double albedo)
  {
    vtkIndirectSurfaces::Meeting meeting;
    const std::string name = "from " + std::to_string(from);
    Check(name,
      surfaces.Meet(
        { from, 0.25, 0.25 }, { towards, 0.0, 0.0 }, vtkIndirectTriangleTree::None, meeting));
    CheckRelative(
      name + ": where", meeting.Position.x, place, 1e-7, "floats of the glyph's source");
    CheckRelative(name + ": colour", meeting.Albedo.x, albedo, 1e-2, "bytes of glyphs' colours");
    Check(name + ": it sends", meeting.Sends);
  };
  meet(0.9, -1.0, 0.8, 0.6);
  meet(0.55, 1.0, 0.6, 0.6);
  meet(0.55, -1.0, 0.4, 0.4);
  meet(0.3, 1.0, 0.4, 0.4);
  meet(0.3, -1.0, 0.2, 0.2);
  vtkIndirectSurfaces::Meeting meeting;
  // The triangle's normal is +x: its back is culled.
  meet(0.1, 1.0, 0.4, 0.4);
  const auto blocks = [&](double from, double to) {
    return surfaces.GetTree().IsBlocked({ from, 0.25, 0.25 }, { to, 0.25, 0.25 });
  };
  Check("both sides of a triangle block", blocks(0.1, 0.3) && blocks(0.3, 0.1));
  Check("a glyph blocks", blocks(0.3, 0.5));
  Check("a sphere blocks", blocks(0.5, 0.9) && blocks(0.9, 0.5));
  Check("a sphere hides nothing of its own", !blocks(0.5, 0.6) && !blocks(0.7, 0.9));
  Check("between them is nothing", !blocks(0.21, 0.39) && !blocks(0.41, 0.59));

  // Voxels have the polygons of the list, and its glyphs where hints ask for them.
  vtkIndirectOccupancyVolume volume;
  volume.Update(scene.Frame, surfaces, 32);
  const auto occupied = [&](double x) {
    return volume.IsOccupied(glm::ivec3(glm::floor(volume.ToVoxels({ x, 0.25, 0.25 }))));
  };
  Check("voxels hold triangles", occupied(0.2));
  Check("they hold no glyphs, and no spheres", !occupied(0.4) && !occupied(0.6));
  Check("which is known", !volume.HoldsAll() && volume.GetLeftOut().size() == 1);
  volume.KeepSurfaces(true);
  volume.Update(scene.Frame, surfaces, 32);
  Check("they hold glyphs for hints", occupied(0.2) && occupied(0.4) && !occupied(0.6));
}

// A scene is read again when it has changed, its tree is made again when shapes have.
VTK_INDIRECT_TEST(SurfacesAreReadOnce)
{
  SurfaceFrame scene;
  vtkActor* const actor =
    scene.Add({ { glm::dvec3(0.5, 0, 0), glm::dvec3(0.5, 1, 0), glm::dvec3(0.5, 0, 1) } }, 0.2);
  vtkIndirectSurfaces surfaces;
  surfaces.Update(scene.Frame);
  const vtkMTimeType first = surfaces.GetTime();
  surfaces.Update(scene.Frame);
  Check("nothing changes", surfaces.GetTime() == first && surfaces.GetNumberOfBuilds() == 1);
  const auto albedo = [&]()
  {
    vtkIndirectSurfaces::Meeting meeting;
    surfaces.Meet({ 0.1, 0.2, 0.2 }, { 1, 0, 0 }, vtkIndirectTriangleTree::None, meeting);
    return meeting.Albedo.x;
  };
  actor->GetProperty()->SetColor(0.7, 0.7, 0.7);
  scene.Frame.Casters[0].Revision = 7;
  surfaces.Update(scene.Frame);
  Check("a colour", surfaces.GetTime() > first && surfaces.GetNumberOfBuilds() == 1);
  CheckRelative("it is there", albedo(), 0.7, 1e-12, "no rounding");
  actor->SetPosition(0.1, 0.0, 0.0);
  scene.Frame.Casters[0].Revision = 8;
  surfaces.Update(scene.Frame);
  CheckEqual("trees after a move", surfaces.GetNumberOfBuilds(), size_t(2));
  const vtkMTimeType moved = surfaces.GetTime();
  surfaces.Forget();
  surfaces.Update(scene.Frame);
  Check(
    "read anew, it is the same", surfaces.GetTime() == moved && surfaces.GetNumberOfBuilds() == 3);
  surfaces.Clear();
  Check("cleared, it has changed", surfaces.GetTime() > moved && surfaces.GetBytes() == 0);
}
