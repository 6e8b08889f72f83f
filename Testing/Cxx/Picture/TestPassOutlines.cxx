// SPDX-License-Identifier: BSD-3-Clause
// Antialiasing finds edges where surfaces end: data on a surface stays as it is, bit for bit.
#include "vtkIndirectContractUtilities.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkImageData.h"
#include "vtkImageProperty.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkLineSource.h"
#include "vtkLookupTable.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderWindow.h"
#include "vtkScalarBarActor.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <functional>

using namespace contract;

namespace
{
// Random colours.
vtkSmartPointer<vtkUnsignedCharArray> MakeNoise(vtkIdType count)
{
  auto colors = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colors->SetNumberOfComponents(3);
  colors->SetNumberOfTuples(count);
  unsigned int state = 1;
  for (vtkIdType i = 0; i < 3 * count; ++i)
  {
    state = 1664525u * state + 1013904223u; // Numerical Recipes' generator
    colors->SetValue(i, static_cast<unsigned char>(state >> 24u));
  }
  return colors;
}

vtkSmartPointer<vtkActor> MakeNoisy(vtkPolyDataAlgorithm* source, bool lit)
{
  source->Update();
  vtkPolyData* data = source->GetOutput();
  data->GetCellData()->SetScalars(MakeNoise(data->GetNumberOfCells()));
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetLighting(lit);
  return actor;
}

// A square with a texture of random pixels.
vtkSmartPointer<vtkActor> MakeTextured(bool lit)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(60, 60, 1);
  image->GetPointData()->SetScalars(MakeNoise(3600));
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(plane->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->SetTexture(texture);
  actor->GetProperty()->SetLighting(lit);
  return actor;
}

struct Scene : View
{
  vtkNew<vtkIndirectIlluminationPass> Pass;

  Scene()
    : View(120, 100)
  {
    this->Renderer->SetBackground(0.2, 0.2, 0.2);
    this->Renderer->AddLight(MakeLight(LightKind::Directional, { 1, 2, 3 }, { 0, 0, 0 }));
    this->Renderer->SetPass(this->Pass);
  }
  void Look(const Vec3& from, double angle = 30.0)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(from[0], from[1], from[2]);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewAngle(angle);
    this->Renderer->ResetCameraClippingRange();
  }
  Pixels Grab(bool antialiasing)
  {
    this->Pass->SetAntialiasing(antialiasing);
    return View::Grab();
  }
};

// Counts pixels that antialiasing changes within a surface, and beside the background.
void Count(Scene& scene, int& within, int& beside)
{
  const Pixels off = scene.Grab(false);
  const Pixels on = scene.Grab(true);
  const std::vector<float> depth = GrabDepth(scene.Window);
  within = beside = 0;
  for (int y = 0; y < on.Height; ++y)
  {
    for (int x = 0; x < on.Width; ++x)
    {
      if (std::equal(on.At(x, y), on.At(x, y) + 4, off.At(x, y)))
      {
        continue;
      }
      bool drawn = false;
      bool empty = false;
      for (const auto& at :
        { std::array<int, 2>{ x, y }, { x - 1, y }, { x + 1, y }, { x, y - 1 }, { x, y + 1 } })
      {
        const int column = std::min(std::max(at[0], 0), on.Width - 1);
        const int row = std::min(std::max(at[1], 0), on.Height - 1);
        const bool here = depth[static_cast<size_t>(row) * on.Width + column] < 1.0f;
        drawn = drawn || here;
        empty = empty || !here;
      }
      ++(drawn && empty ? beside : within);
    }
  }
}
}

//------------------------------------------------------------------------------
// Colours of cells and pixels, lit and unlit, flat, curved and at a grazing angle.
// Data that VTK does not light are VTK's picture, too.
VTK_INDIRECT_TEST(OutlinesAreNotInData)
{
  auto check = [](const std::string& what, const Vec3& eye, const std::function<void(Scene&)>& add,
                 bool lit = false)
  {
    Scene scene;
    add(scene);
    scene.Look(eye);
    int within = 0;
    int beside = 0;
    Count(scene, within, beside);
    std::cout << what << ": " << within << " pixels changed within, " << beside << " beside\n";
    CONTRACT_CHECK(within == 0, what << ": " << within << " pixels of data are changed");
    CONTRACT_CHECK(beside > 20, what << ": its outline is not antialiased");
    if (!lit)
    {
      const Pixels off = scene.Grab(false);
      scene.Renderer->SetPass(nullptr);
      const Pixels plain = scene.View::Grab();
      CONTRACT_CHECK(off.Values == plain.Values, what << ": not the picture of VTK");
    }
  };
  for (bool lit : { false, true })
  {
    const std::string suffix = lit ? ", lit" : ", not lit";
    auto addPlane = [lit](Scene& scene)
    {
      vtkNew<vtkPlaneSource> plane;
      plane->SetResolution(60, 60);
      scene.Renderer->AddActor(MakeNoisy(plane, lit));
    };
    check("a plane" + suffix, { 0.2, 0.3, 2.6 }, addPlane, lit);
    check("a plane at a grazing angle" + suffix, { 0.3, 1.6, 0.25 }, addPlane, lit);
    check(
      "a ball" + suffix, { 0.2, 0.3, 2.6 },
      [lit](Scene& scene)
      {
        vtkNew<vtkSphereSource> sphere;
        sphere->SetThetaResolution(48);
        sphere->SetPhiResolution(48);
        scene.Renderer->AddActor(MakeNoisy(sphere, lit));
      },
      lit);
    check(
      "a texture" + suffix, { 0.2, 0.3, 2.6 },
      [lit](Scene& scene) { scene.Renderer->AddActor(MakeTextured(lit)); }, lit);
  }
  check("a scalar bar", { 0.2, 0.3, 2.6 },
    [](Scene& scene)
    {
      scene.Renderer->AddActor(MakeTextured(false));
      vtkNew<vtkLookupTable> table;
      table->SetNumberOfTableValues(60);
      table->Build();
      vtkNew<vtkScalarBarActor> bar;
      bar->SetLookupTable(table);
      bar->SetPosition(0.7, 0.1);
      bar->SetWidth(0.25);
      scene.Renderer->AddActor2D(bar);
    });
  check("an image", { 0.2, 0.3, 2.6 },
    [](Scene& scene)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(50, 50, 1);
      image->SetSpacing(0.02, 0.02, 0.02);
      image->SetOrigin(-0.5, -0.5, 0.0);
      image->GetPointData()->SetScalars(MakeNoise(2500));
      vtkNew<vtkImageSliceMapper> mapper;
      mapper->SetInputData(image);
      vtkNew<vtkImageSlice> slice;
      slice->SetMapper(mapper);
      slice->GetProperty()->SetInterpolationTypeToNearest();
      scene.Renderer->AddViewProp(slice);
    });
}

//------------------------------------------------------------------------------
// Shapes have outlines in front of each other, too: by depth, by a crease, by their kind.
VTK_INDIRECT_TEST(OutlinesOfShapes)
{
  auto check = [](const std::string& what, const std::function<void(Scene&)>& add)
  {
    Scene scene;
    add(scene);
    scene.Look({ 0.0, 0.0, 3.0 }, 20.0);
    int within = 0;
    int beside = 0;
    Count(scene, within, beside);
    std::cout << what << ": " << within << " pixels changed\n";
    CONTRACT_CHECK(within > 40, what << ": only " << within << " pixels are changed");
  };
  auto makeWall = [](bool lit)
  {
    auto wall = MakeQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, { 0.9, 0.2, 0.2 });
    wall->GetProperty()->SetLighting(lit);
    return wall;
  };
  for (bool lit : { false, true })
  {
    check(lit ? "a leap of depth, lit" : "a leap of depth, not lit",
      [lit, makeWall](Scene& scene)
      {
        // Parts of one prop, which only depth distinguishes.
        vtkNew<vtkPolyData> data;
        vtkNew<vtkPoints> points;
        vtkNew<vtkCellArray> cells;
        auto add = [&](double z, double tilt, double half)
        {
          const vtkIdType first = points->GetNumberOfPoints();
          for (int i = 0; i < 4; ++i)
          {
            const double x = i == 0 || i == 3 ? -half : half;
            points->InsertNextPoint(x, (i < 2 ? -half : half) + tilt * x, z);
          }
          const vtkIdType ids[] = { first, first + 1, first + 2, first + 3 };
          cells->InsertNextCell(4, ids);
        };
        add(0.0, 0.0, 2.0);
        add(0.3, 0.2, 0.3);
        data->SetPoints(points);
        data->SetPolys(cells);
        data->GetCellData()->SetScalars(MakeNoise(2));
        vtkNew<vtkPolyDataMapper> mapper;
        mapper->SetInputData(data);
        vtkNew<vtkActor> actor;
        actor->SetMapper(mapper);
        actor->GetProperty()->SetLighting(lit);
        scene.Renderer->AddActor(actor);
      });
  }
  check("a crease",
    [](Scene& scene)
    {
      // From below: the upper face would shade the lower one.
      scene.Renderer->RemoveAllLights();
      scene.Renderer->AddLight(MakeLight(LightKind::Directional, { 0.5, -3, 1 }, { 0, 0, 0 }));
      scene.Renderer->AddActor(
        MakeQuad({ -2, -1.8, 0 }, { 2, -2.2, 0 }, { -2, 0.2, 0 }, { 1, 1, 1 }));
      scene.Renderer->AddActor(
        MakeQuad({ -2, 0.2, 0 }, { 2, -0.2, 0 }, { -2, 1.2, 2 }, { 1, 1, 1 }));
    });
  check("a line on a picture",
    [makeWall](Scene& scene)
    {
      scene.Renderer->AddActor(makeWall(false));
      vtkNew<vtkLineSource> source;
      source->SetPoint1(-2, -0.3, 1e-3);
      source->SetPoint2(2, 0.4, 1e-3);
      vtkNew<vtkPolyDataMapper> mapper;
      mapper->SetInputConnection(source->GetOutputPort());
      vtkNew<vtkActor> line;
      line->SetMapper(mapper);
      line->GetProperty()->SetColor(1, 1, 1);
      scene.Renderer->AddActor(line);
    });
}
