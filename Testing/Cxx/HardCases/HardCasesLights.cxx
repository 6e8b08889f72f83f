// SPDX-License-Identifier: BSD-3-Clause
// Scenes at the edge of what the formulas allow: whatever comes out is finite and not negative.
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkLight.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkTrivialProducer.h"
#include "vtkUniformLightSampler.h"

#include <cmath>

using namespace vtkIndirectTest;

namespace
{
const glm::dvec3 White(1.0);

// Floor and two walls, and the eye before them.
struct HardScene : Scene
{
  explicit HardScene(int width = 32, int height = 24)
    : Scene(width, height)
  {
    this->AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, White);
    this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, White);
    this->AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, White);
    this->SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 32, 0.5, 6);
    this->Pass->SetReflectiveShadowMapResolution(32);
  }

  // All modes, and interpolation.
  void CheckModes(const char* what, int maps)
  {
    std::printf("       %s\n", what);
    for (int mode = 0; mode < 3; ++mode)
    {
      this->Gather->SetMode(mode);
      this->Gather->SetInterpolation(mode != vtkRSMGatherPass::ALL_TEXELS);
      this->Gather->SetNumberOfSamples(64);
      this->Render();
      this->CheckBuffers(maps);
    }
  }
};
}

VTK_INDIRECT_TEST(HardLights)
{
  {
    HardScene scene;
    scene.AddPoint({ 0.5, 0.0, 0.5 }, { 0, 0, 1 });
    scene.CheckModes("a point light on the floor", 1);
  }
  {
    HardScene scene;
    scene.AddPoint({ 0.0, 0.0, 0.0 }, { 0, 0, 1 });
    scene.CheckModes("a point light in the corner's vertex", 1);
  }
  {
    HardScene scene;
    scene.AddSpot({ 0.5, 0.0, 0.5 }, { 0.2, 0.0, 0.2 }, 45, 1, { 1, 0, 0 });
    scene.CheckModes("a spot on the floor that shines along it", 1);
  }
  {
    HardScene scene;
    scene.AddSpot({ 0.5, 0.5, 0.5 }, { 0.5, 0.5, 0.5 }, 45, 1, { 1, 0, 0 });
    scene.CheckModes("a spot without a direction", 1);
  }
  {
    HardScene scene;
    scene.AddSpot({ 0.5, 0.5, 0.5 }, { 0, 0, 0 }, 0.01, 128, { 1, 0, 0 });
    scene.CheckModes("a spot of a hundredth of a degree", 1);
  }
  {
    HardScene scene;
    scene.AddDirectional({ 1, 0, 0 });
    scene.CheckModes("a directional light along two of the planes", 1);
  }
  {
    HardScene scene;
    scene.AddPoint({ 1e6, 1e6, 1e6 }, { 1, 0, 0 });
    scene.CheckModes("a point light a million sizes away", 1);
  }
  {
    HardScene scene;
    scene.AddSpot({ 0.5, 0.5, 0.5 }, { 0.5, 0.5, 2.0 }, 30, 1, { 1, 0, 0 });
    scene.CheckModes("a spot that shines on nothing", 1);
  }
  {
    HardScene scene;
    scene.AddPoint({ 2.2, 1.6, 2.3 }, { 0, 1, 0 });
    scene.CheckModes("a point light in the eye", 1);
  }
  {
    HardScene scene;
    for (int i = 0; i < 6; ++i)
    {
      scene.AddPoint({ 0.1 + 0.1 * i, 0.5, 0.5 }, { 0, 0, 1 })->SetIntensity(1e-3);
    }
    scene.CheckModes("six point lights", 6);
  }
}

VTK_INDIRECT_TEST(HardSurfaces)
{
  {
    HardScene scene(1, 1);
    scene.AddPoint({ 0.5, 0.5, 0.5 }, { 0, 0, 1 });
    scene.CheckModes("a window of one pixel", 1);
  }
  {
    HardScene scene(33, 2);
    scene.AddPoint({ 0.5, 0.5, 0.5 }, { 0, 0, 1 });
    scene.Pass->SetReflectiveShadowMapResolution(1);
    scene.CheckModes("maps of one texel, two rows of pixels", 1);
  }
  {
    HardScene scene;
    scene.AddQuad({ 0, 1e-7, 0 }, { 0, 1e-7, 1 }, { 1, 1e-7, 0 }, White);
    scene.AddPoint({ 0.5, 0.5, 0.5 }, { 0, 0, 1 });
    scene.CheckModes("two floors in one place", 1);
  }
  {
    // Triangles without area, a normal of zero, one that is not a number, and one that is too long.
    HardScene scene;
    vtkNew<vtkPolyData> data;
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    const double p[][3] = { { 0.2, 0.3, 0.2 }, { 0.6, 0.3, 0.2 }, { 0.2, 0.3, 0.6 },
      { 0.2, 0.3, 0.2 }, { 0.7, 0.3, 0.2 }, { 0.7, 0.3, 0.2 } };
    const float n[][3] = { { 0, 0, 0 }, { 0, NAN, 0 }, { 0, 1e20f, 0 }, { 0, 1, 0 }, { 0, 1, 0 },
      { 0, 1, 0 } };
    for (int i = 0; i < 6; ++i)
    {
      points->InsertNextPoint(p[i]);
      normals->InsertNextTuple(n[i]);
    }
    const vtkIdType triangles[][3] = { { 0, 1, 2 }, { 3, 4, 5 }, { 3, 3, 3 } };
    for (const auto& triangle : triangles)
    {
      cells->InsertNextCell(3, triangle);
    }
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->SetNormals(normals);
    vtkNew<vtkTrivialProducer> source;
    source->SetOutput(data);
    scene.AddSource(source, White);
    scene.AddSpot({ 0.5, 0.9, 0.5 }, { 0.4, 0, 0.4 }, 50, 1, { 1, 0, 0 });
    std::printf("       bad normals and triangles without area\n");
    // Of a lit surface with such normals VTK itself draws nothing finite: what may not spread is
    // the indirect light.
    scene.Render();
    for (const char* name : { "irradiance", "indirect", "normal", "rsm0.normal", "rsm0.density" })
    {
      int bad = 0;
      for (float v : scene.Copy(name).Values)
      {
        bad += !std::isfinite(v);
      }
      CheckEqual(std::string("values of ") + name + " that are not finite", bad, 0);
    }
  }
  {
    HardScene scene;
    scene.AddPoint({ 0.5, 0.5, 0.5 }, { 0, 0, 1 })->SetColor(0.0, 0.0, 1e-30);
    scene.CheckModes("next to no light", 1);
    const Image irradiance = scene.Copy("irradiance");
    CheckEqual("red irradiance of a blue light", irradiance.Mean(0), 0.0);
  }
}
