// SPDX-License-Identifier: BSD-3-Clause
// Glyphs, and impostors of spheres and sticks, at a distance of millions of their sizes from the
// origin, as in maps of the earth: direct light with its shadows and indirect light equal those at
// the origin.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkConeSource.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMolecule.h"
#include "vtkMoleculeMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
// Floats represent these positions, and halves around them, without rounding: any remaining
// rounding is the shaders'.
const glm::dvec3 Far(450000, 5400000, 300);

enum KindType
{
  GLYPHS,
  SPHERES,
  MOLECULE
};

vtkSmartPointer<vtkActor> MakeInstances(int kind, const glm::dvec3& at, bool byMatrix)
{
  std::vector<glm::dvec3> places;
  for (int i = 0; i < 9; ++i)
  {
    places.push_back(glm::dvec3(3.5 * (i % 3) - 3.5, 3.0 * (i / 3) - 3.0, 1.5 + 0.5 * (i % 2)));
  }
  auto actor = vtkSmartPointer<vtkActor>::New();
  const glm::dvec3 inData = byMatrix ? glm::dvec3(0.0) : at;
  if (byMatrix)
  {
    actor->SetPosition(at.x, at.y, at.z);
  }
  if (kind == MOLECULE)
  {
    vtkNew<vtkMolecule> molecule;
    for (size_t i = 0; i < places.size(); ++i)
    {
      const glm::dvec3 p = inData + places[i];
      molecule->AppendAtom(6, p.x, p.y, p.z);
      if (i % 3 > 0)
      {
        molecule->AppendBond(static_cast<vtkIdType>(i - 1), static_cast<vtkIdType>(i), 1);
      }
    }
    auto mapper = vtkSmartPointer<vtkMoleculeMapper>::New();
    mapper->SetInputData(molecule);
    mapper->SetAtomicRadiusTypeToUnitRadius();
    mapper->SetAtomicRadiusScaleFactor(0.75f);
    mapper->SetBondRadius(0.25f);
    actor->SetMapper(mapper);
    return actor;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const glm::dvec3& place : places)
  {
    const glm::dvec3 p = inData + place;
    const vtkIdType id = points->InsertNextPoint(p.x, p.y, p.z);
    cells->InsertNextCell(1, &id);
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(cells);
  if (kind == SPHERES)
  {
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetRadius(1.0f);
    actor->SetMapper(mapper);
  }
  else
  {
    vtkNew<vtkConeSource> cone;
    cone->SetResolution(12);
    cone->SetHeight(2.0);
    vtkNew<vtkGlyph3DMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetSourceConnection(cone->GetOutputPort());
    mapper->ScalingOff();
    actor->SetMapper(mapper);
  }
  actor->GetProperty()->SetColor(0.9, 0.5, 0.2);
  return actor;
}

struct View
{
  Image Direct;
  Image Irradiance;
};

View Draw(int kind, const glm::dvec3& at, bool byMatrix)
{
  Scene scene(96, 72);
  scene.AddQuad(at + glm::dvec3(-8, -8, 0), at + glm::dvec3(8, -8, 0), at + glm::dvec3(-8, 8, 0),
    { 0.7, 0.7, 0.6 });
  scene.Renderer->AddActor(MakeInstances(kind, at, byMatrix));
  scene.AddDirectional({ -1, 0.7, -1.5 });
  scene.SetEye(at + glm::dvec3(0, -16, 10), at, { 0, 0, 1 }, 36, 5, 40);
  scene.Pass->SetReflectiveShadowMapResolution(256);
  scene.Gather->SetModeToVirtualLights();
  scene.Render();
  return { scene.Copy("direct"), scene.Copy("irradiance") };
}

// Share of pixels that differ by a hundredth of the brightest.
double FindShare(const Image& image, const Image& expected)
{
  const float most = *std::max_element(expected.Values.begin(), expected.Values.end());
  size_t differ = 0;
  for (size_t i = 0; i < image.Values.size(); ++i)
  {
    differ += std::abs(image.Values[i] - expected.Values[i]) <= 0.01f * most ? 0 : 1;
  }
  return static_cast<double>(differ) / static_cast<double>(image.Values.size());
}
}

VTK_INDIRECT_TEST(InstancesFarFromOrigin)
{
  const char* const names[] = { "glyphs", "spheres", "molecule" };
  for (int kind = GLYPHS; kind <= MOLECULE; ++kind)
  {
    const View expected = Draw(kind, glm::dvec3(0.0), false);
    CheckAtLeast("direct light", expected.Direct.Mean(), 0.05, "the test's own power");
    CheckAtLeast("irradiance", expected.Irradiance.Mean(), 1e-3, "the test's own power");
    for (const bool byMatrix : { false, true })
    {
      if (byMatrix && kind != SPHERES)
      {
        continue;
      }
      const View view = Draw(kind, Far, byMatrix);
      const std::string what =
        std::string(names[kind]) + (byMatrix ? ", by the actor's matrix: " : ", by points: ");
      CheckAtMost(what + "direct light", FindShare(view.Direct, expected.Direct), 0.004,
        "pixels on outlines and rims of shadows, where the last bit decides");
      CheckAtMost(
        what + "irradiance", FindShare(view.Irradiance, expected.Irradiance), 0.004, "the same");
    }
  }
}
