// SPDX-License-Identifier: BSD-3-Clause
// Casters between an area light and its receivers, and the part of the light's view that holds
// them.
#include "Capture/vtkIndirectDepthTile.h"
#include "Maps/vtkIndirectCasterWindow.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAppendPolyData.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
vtkSmartPointer<vtkActor> MakeActor(vtkAlgorithm* source)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  mapper->Update();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor> MakeBox(const double bounds[6])
{
  vtkNew<vtkCubeSource> source;
  source->SetBounds(bounds);
  return MakeActor(source);
}

// Unmoving boxes, in world units that equal scene units.
vtkIndirectFrame MakeFrame(const std::vector<vtkSmartPointer<vtkActor>>& actors)
{
  vtkIndirectFrame frame;
  std::fill(frame.SceneBounds, frame.SceneBounds + 6, 0.0);
  for (const auto& actor : actors)
  {
    vtkIndirectCaster caster;
    caster.Prop = actor;
    actor->GetBounds(caster.Bounds);
    for (int i = 0; i < 3; ++i)
    {
      frame.SceneBounds[2 * i] = std::min(frame.SceneBounds[2 * i], caster.Bounds[2 * i]);
      frame.SceneBounds[2 * i + 1] =
        std::max(frame.SceneBounds[2 * i + 1], caster.Bounds[2 * i + 1]);
    }
    frame.Casters.push_back(caster);
  }
  return frame;
}
}

VTK_INDIRECT_TEST(CasterWindowConvex)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(3, 3);
  Check("a plane", vtkIndirectCasterWindow::IsConvex(MakeActor(plane)), "it is flat");
  const double bounds[6] = { 0, 1, 0, 2, 0, 3 };
  Check("a box", vtkIndirectCasterWindow::IsConvex(MakeBox(bounds)), "it is closed and convex");
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(12);
  Check("a cone", vtkIndirectCasterWindow::IsConvex(MakeActor(cone)), "it is closed and convex");
  cone->CappingOff();
  Check("a tent", !vtkIndirectCasterWindow::IsConvex(MakeActor(cone)), "it hides its inside");
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);
  Check("a sphere", !vtkIndirectCasterWindow::IsConvex(MakeActor(sphere)), "of too many points");
  vtkNew<vtkCubeSource> one;
  vtkNew<vtkCubeSource> other;
  other->SetCenter(2, 0, 0);
  vtkNew<vtkAppendPolyData> both;
  both->AddInputConnection(one->GetOutputPort());
  both->AddInputConnection(other->GetOutputPort());
  Check("two boxes", !vtkIndirectCasterWindow::IsConvex(MakeActor(both)),
    "one hides the other from light beside them");
}

// A lamp over a table with a box on it: the window fits the box, for any size of the table.
VTK_INDIRECT_TEST(CasterWindowFits)
{
  const double table[6] = { -5, 5, -5, 5, -0.2, 0 };
  const double box[6] = { -0.1, 0.1, 0.2, 0.4, 0, 0.5 };
  const double below[6] = { -0.1, 0.1, 0.2, 0.4, -1.5, -1 };
  std::vector<vtkSmartPointer<vtkActor>> actors = { MakeBox(table), MakeBox(box) };
  vtkIndirectCasterWindow window;
  const std::vector<glm::dvec3> lamp = { { -1, -1, 2 }, { 1, -1, 2 }, { -1, 1, 2 }, { 1, 1, 2 } };
  Check("it is new", window.Update(MakeFrame(actors), lamp), "there was none");
  Check("and stays", !window.Update(MakeFrame(actors), lamp), "nothing has changed");
  vtkIndirectDepthTile tile = vtkIndirectDepthTile::FromPlace({ 0, 0, 2 }, { 0, 0, -1 });
  window.Fit({ &tile });
  // The box's top is nearest: 1.5 away; 0.1 and 0.4 to the sides.
  const glm::dvec3 across = tile.Right * tile.HalfWidth.x + tile.Up * tile.HalfWidth.y;
  CheckRelative("half its width", std::abs(across.x), 0.1 / 1.5, 0.03, "a margin");
  CheckRelative(
    "half its height", std::abs(across.y), 0.5 * (0.4 / 1.5 - 0.2 / 2.0), 0.03, "a margin");
  const glm::dvec3 middle = tile.Right * tile.Middle.x + tile.Up * tile.Middle.y;
  CheckRelative("its middle", middle.y, 0.5 * (0.4 / 1.5 + 0.2 / 2.0), 0.01, "a margin");
  CheckAtMost("it begins before the box", tile.Near, 1.5, "what hides is drawn");
  CheckAtLeast("and ends behind the table", tile.Far, 2.2, "what receives is drawn");
  actors.push_back(MakeBox(below));
  Check("something below the table changes it", window.Update(MakeFrame(actors), lamp),
    "the table hides that");
  vtkIndirectDepthTile whole = vtkIndirectDepthTile::FromPlace({ 0, 0, 2 }, { 0, 0, -1 });
  window.Fit({ &whole });
  CheckAtLeast("then it holds the table", whole.HalfWidth.x, 2.4, "half of 10 over 2");
}

// A lamp seen by a box at 85 degrees from its normal, and from a second position at 50: the box is
// in a strip of both together, and in the second position's forward view.
VTK_INDIRECT_TEST(CasterWindowFitsStrips)
{
  const double far[6] = { 5.9, 6.1, -0.2, 0.2, -0.6, -0.4 };
  // The first box hides this one from the lamp.
  const double behind[6] = { 7, 8, -1, 1, -0.7, -0.5 };
  const std::vector<vtkSmartPointer<vtkActor>> actors = { MakeBox(far), MakeBox(behind) };
  vtkIndirectCasterWindow window;
  window.Update(MakeFrame(actors), { { 0, 0, 0 }, { 5.5, 0, 0 } });
  vtkIndirectDepthTile first = vtkIndirectDepthTile::FromPlace({ 0, 0, 0 }, { 0, 0, -1 });
  vtkIndirectDepthTile second = vtkIndirectDepthTile::FromPlace({ 5.5, 0, 0 }, { 0, 0, -1 });
  window.Fit({ &first, &second });
  int strips = 0;
  for (int k = 1; k < vtkIndirectDepthTile::NumberOfViews; ++k)
  {
    const vtkIndirectDepthTile view = first.GetView(k);
    if (view.HalfWidth.x > 0.0)
    {
      ++strips;
      Check("the strip looks to the box", view.Forward.x > 0.99);
      CheckAtMost(
        "it holds the box alone: its width", view.HalfWidth.x, 0.2 / 5.9 * 1.1, "a margin");
      CheckAtLeast("and its width", view.HalfWidth.x, 0.2 / 5.9, "all of it");
      CheckAtLeast("its upper end", view.Middle.y + view.HalfWidth.y, 0.6 / 5.9, "all of it");
      CheckAtMost("its lower end", view.Middle.y - view.HalfWidth.y, 0.4 / 6.1, "all of it");
      CheckAtMost("it begins before the box", view.Near, 5.9, "what hides is drawn");
    }
  }
  CheckEqual("strips that hold something", strips, 1);
  Check("of both places one", first.Strips == second.Strips);
  CheckAtLeast("the second place sees the box ahead", second.HalfWidth.x + second.HalfWidth.y, 0.2,
    "half of 0.6 and of 0.2 over half a unit");
}
