// SPDX-License-Identifier: BSD-3-Clause
// Points that look like spheres take part as spheres: splats that shader code cuts off, and points
// that VTK draws as spheres.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkAssembly.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkEnvironmentLight.h"
#include "vtkFloatArray.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace contract;

namespace
{
constexpr vtkIdType Side = 3;
constexpr double Diameter = 20.0; // of points, in pixels

// Nine points over a white ground, under a sky.
struct CloudView : View
{
  vtkNew<vtkIndirectIlluminationPass> Pass;
  vtkNew<vtkEnvironmentLight> Sky;
  vtkNew<vtkPolyData> Cloud;
  vtkNew<vtkFloatArray> Sizes; // by component: a number that does not count, and half of the radii
  vtkNew<vtkUnsignedCharArray> Colors; // of cells
  vtkNew<vtkActor> Actor;

  CloudView()
    : View(160, 120)
  {
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->AddActor(MakeQuad({ -1.5, 0, 1.5 }, { 1.5, 0, 1.5 }, { -1.5, 0, -1.5 }));
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    this->Sizes->SetName("size");
    this->Sizes->SetNumberOfComponents(2);
    this->Colors->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < Side * Side; ++i)
    {
      points->InsertNextPoint(0.6 * (static_cast<double>(i % Side) - 1.0), 0.25,
        0.6 * (static_cast<double>(i / Side) - 1.0));
      cells->InsertNextCell(1, &i);
      this->Sizes->InsertNextTuple2(7.0, 0.05 + 0.005 * static_cast<double>(i));
      this->Colors->InsertNextTuple3(255.0, 25.0 * static_cast<double>(i), 50.0);
    }
    this->Cloud->SetPoints(points);
    this->Cloud->SetVerts(cells);
    this->Cloud->GetPointData()->AddArray(this->Sizes);
    this->Actor->GetProperty()->SetColor(0.9, 0.2, 0.1);
    this->Renderer->AddActor(this->Actor);
    this->Renderer->AddLight(MakeLight(LightKind::Spot, { 1.0, 2.5, 1.5 }, { 0.0, 0.2, 0.0 }));
    this->Pass->SetEnvironment(this->Sky);
    this->Renderer->SetPass(this->Pass);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.5, 2.4, 3.2);
    camera->SetFocalPoint(0.0, 0.1, 0.0);
    camera->SetViewAngle(40.0);
    this->Renderer->ResetCameraClippingRange(-1.6, 1.6, -0.2, 0.6, -1.6, 1.6);
  }
  ~CloudView() { this->Pass->SetEnvironment(nullptr); }

  void DrawPointsAsSpheres()
  {
    vtkNew<vtkPolyDataMapper> points;
    points->SetInputData(this->Cloud);
    this->Actor->SetMapper(points);
    this->Actor->GetProperty()->SetPointSize(static_cast<float>(Diameter));
    this->Actor->GetProperty()->RenderPointsAsSpheresOn();
  }

  // The radius of a point of so many pixels: half of the width that these have at its depth.
  double FindRadius(const double at[3])
  {
    double place[4] = { at[0], at[1], at[2], 1.0 };
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->GetModelViewTransformMatrix()->MultiplyPoint(place, place);
    const double half = std::tan(0.5 * camera->GetViewAngle() * std::acos(-1.0) / 180.0);
    return Diameter / 120.0 * half * (camera->GetParallelProjection() ? 1.0 : -place[2]) *
      (camera->GetParallelProjection() ? camera->GetParallelScale() / half : 1.0);
  }
  // Gives an array with the radii of a mapper of spheres.
  void AddRadii(const std::function<double(vtkIdType)>& find)
  {
    vtkNew<vtkFloatArray> radii;
    radii->SetName("radius");
    for (vtkIdType i = 0; i < this->Cloud->GetNumberOfPoints(); ++i)
    {
      radii->InsertNextValue(static_cast<float>(find(i)));
    }
    this->Cloud->GetPointData()->AddArray(radii);
  }
};

vtkSmartPointer<vtkPointGaussianMapper> MakeSplats(vtkPolyData* cloud)
{
  auto splats = vtkSmartPointer<vtkPointGaussianMapper>::New();
  splats->SetInputData(cloud);
  splats->SetScaleArray("size");
  splats->SetScaleArrayComponent(1);
  splats->SetScaleFactor(2.0);
  splats->EmissiveOff();
  splats->SetSplatShaderCode("//VTK::Color::Impl\n"
                             "float dist = dot(offsetVCVSOutput.xy, offsetVCVSOutput.xy);\n"
                             "if (dist > 1.0) { discard; }\n"
                             "ambientColor *= 1.0 - dist;\n"
                             "diffuseColor *= 1.0 - dist;\n");
  return splats;
}
}

//------------------------------------------------------------------------------
// Splats that shader code cuts off give the same picture and the same light as the spheres of VTK's
// mapper of spheres; a part of an assembly, too.
VTK_INDIRECT_TEST(PointSpheresOfSplats)
{
  CloudView view;
  auto splats = MakeSplats(view.Cloud);
  view.Actor->SetMapper(splats);
  view.Actor->GetProperty()->SetRepresentationToPoints(); // as PyVista does
  vtkProperty* const property = view.Actor->GetProperty();
  const int references = splats->GetReferenceCount();
  view.Grab(); // the first frame sets keys
  const vtkMTimeType before = view.Actor->GetMTime();
  const Pixels image = view.Grab();
  CONTRACT_CHECK(view.Actor->GetMapper() == splats && view.Actor->GetProperty() == property,
    "the actor is left with another mapper");
  CONTRACT_CHECK(view.Actor->GetMTime() == before, "the frame has changed the actor");
  CONTRACT_CHECK(splats->GetReferenceCount() == references, splats->GetReferenceCount());
  const Floats sky = Read(view.Pass, "sky");
  const Floats bounce = Read(view.Pass, "bounce");
  const std::string left = Report(view.Pass).FindReason("left_out", "vtkOpenGLActor");
  CONTRACT_CHECK(left.empty(), left);

  vtkNew<vtkOpenGLSphereMapper> spheres;
  view.AddRadii([&](vtkIdType i) { return 2.0 * view.Sizes->GetComponent(i, 1); });
  spheres->SetInputData(view.Cloud);
  spheres->SetScaleArray("radius");
  view.Actor->GetProperty()->SetRepresentationToSurface();
  view.Actor->SetMapper(spheres);
  CONTRACT_CHECK(Compare(view.Grab(), image).Max <= 1.0, "another picture");
  const Difference ofSky = Compare(Read(view.Pass, "sky"), sky);
  const Difference ofBounce = Compare(Read(view.Pass, "bounce"), bounce);
  std::cout << "sky: " << ofSky << "\nbounce: " << ofBounce << "\n";
  CONTRACT_CHECK(Mean(sky, 0) > 0.1 && ofSky.Max <= 1e-5, "sky: " << ofSky);
  CONTRACT_CHECK(Mean(bounce, 0) > 0.01 && ofBounce.Max <= 1e-4, "bounce: " << ofBounce);

  view.Actor->SetMapper(splats);
  view.Renderer->RemoveActor(view.Actor);
  vtkNew<vtkAssembly> inner;
  inner->AddPart(view.Actor);
  vtkNew<vtkAssembly> outer;
  outer->AddPart(inner);
  view.Renderer->AddActor(outer);
  view.Grab();
  const Difference ofParts = Compare(Read(view.Pass, "sky"), sky);
  CONTRACT_CHECK(ofParts.Max <= 1e-5, "in assemblies: " << ofParts);
  view.Grab();
  const long long tiles = CountOf(view.Pass, "tiles_drawn");
  view.Grab();
  CONTRACT_CHECK(CountOf(view.Pass, "tiles_drawn") == tiles, "a still frame draws maps again");
  view.Renderer->RemoveActor(outer);
}

//------------------------------------------------------------------------------
// Splats that fade out stay VTK's, and a frame of the delegate alone shows VTK's own splats.
VTK_INDIRECT_TEST(PointSpheresOfOtherSplats)
{
  CloudView view;
  auto splats = MakeSplats(view.Cloud);
  view.Actor->SetMapper(splats);
  view.Renderer->SetPass(nullptr);
  const Pixels plain = view.Grab();
  view.Renderer->SetPass(view.Pass);
  view.Pass->SetIndirectScale(0.0);
  view.Pass->ShadowsOff();
  CONTRACT_CHECK(Compare(view.Grab(), plain).Max == 0.0, "another picture than the delegate's");
  view.Pass->SetIndirectScale(1.0);
  view.Pass->ShadowsOn();
  splats->SetSplatShaderCode("");
  view.Grab();
  CONTRACT_CHECK(
    Report(view.Pass).FindReason("left_out", "vtkOpenGLActor").find("splats have no surface") == 0,
    "splats without an edge are not left out");
}

//------------------------------------------------------------------------------
// Points as spheres shade a ground like polygonal spheres of the radius that they have at their
// depths, and receive as much; in perspective and parallel projection.
VTK_INDIRECT_TEST(PointSpheresOfPixels)
{
  vtkNew<vtkSphereSource> ball;
  ball->SetRadius(1.0);
  ball->SetThetaResolution(64);
  ball->SetPhiResolution(64);
  for (const bool parallel : { false, true })
  {
    CloudView view;
    view.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    view.Renderer->GetActiveCamera()->SetParallelScale(1.3);
    view.DrawPointsAsSpheres();
    view.Renderer->SetPass(nullptr);
    view.Renderer->RemoveActor(view.Actor);
    const Pixels ground = view.Grab();
    view.Renderer->AddActor(view.Actor);
    const Pixels drawn = view.Grab();
    view.Renderer->SetPass(view.Pass);
    view.Grab();
    const Floats sky = Read(view.Pass, "sky");
    const Floats direct = Read(view.Pass, "direct");
    const std::string left = Report(view.Pass).FindReason("left_out", "vtkOpenGLActor");
    CONTRACT_CHECK(left.empty(), left);
    view.Renderer->RemoveActor(view.Actor);
    view.Grab();
    const Floats open = Read(view.Pass, "sky");

    vtkNew<vtkGlyph3DMapper> glyphs;
    view.AddRadii([&](vtkIdType i) { return view.FindRadius(view.Cloud->GetPoint(i)); });
    glyphs->SetInputData(view.Cloud);
    glyphs->SetSourceConnection(ball->GetOutputPort());
    glyphs->SetScaleArray("radius");
    glyphs->SetScaleModeToScaleByMagnitude();
    glyphs->ScalarVisibilityOff();
    vtkNew<vtkActor> balls;
    balls->SetMapper(glyphs);
    balls->GetProperty()->SetColor(0.9, 0.2, 0.1);
    view.Renderer->AddActor(balls);
    view.Grab();
    const Floats expected = Read(view.Pass, "sky");
    const Floats lit = Read(view.Pass, "direct");
    // Where neither drawing shows a sphere, a pixel beside included, the ground is compared; where
    // both do, the spheres.
    double hidden = 0.0;
    double off = 0.0;
    double shadowed = 0.0;
    double own = 0.0;
    double ownExpected = 0.0;
    size_t pixels = 0;
    size_t ownPixels = 0;
    const auto isDrawn = [&](int x, int y)
    {
      const size_t at = 4 * static_cast<size_t>(y * 160 + x);
      return drawn.Values[at + 1] != ground.Values[at + 1];
    };
    for (int y = 2; y < 118; ++y)
    {
      for (int x = 2; x < 158; ++x)
      {
        int around = 0;
        for (int k = 0; k < 25; ++k)
        {
          around += isDrawn(x + k % 5 - 2, y + k / 5 - 2) ? 1 : 0;
        }
        const size_t at = 3 * static_cast<size_t>(y * 160 + x);
        if (around == 0 && expected.Values[at] > 0.0f)
        {
          hidden += open.Values[at] - expected.Values[at];
          off += std::abs(sky.Values[at] - expected.Values[at]);
          shadowed += std::abs(direct.Values[at] - lit.Values[at]) > 0.1 ? 1.0 : 0.0;
          ++pixels;
        }
        else if (around == 25)
        {
          own += sky.Values[at];
          ownExpected += expected.Values[at];
          ++ownPixels;
        }
      }
    }
    std::cout << (parallel ? "parallel" : "perspective") << ": " << pixels
              << " pixels of ground, mean of the hidden sky " << hidden / double(pixels)
              << ", of the difference " << off / double(pixels) << ", " << shadowed
              << " pixels in another shadow; " << ownPixels << " pixels of spheres get "
              << own / double(ownPixels) << " of the sky in place of "
              << ownExpected / double(ownPixels) << "\n";
    CONTRACT_CHECK(pixels > 3000 && hidden > 0.02 * double(pixels), "nothing is hidden");
    // Facets of 64 by 64 lie in the sphere by 0.1 % of its radius; texels of maps do the rest.
    CONTRACT_CHECK(off < 0.05 * hidden, off / hidden);
    CONTRACT_CHECK(shadowed < 0.01 * double(pixels), shadowed);
    CONTRACT_CHECK(ownPixels > 500 && std::abs(own / ownExpected - 1.0) < 0.03, own / ownExpected);
  }
}

//------------------------------------------------------------------------------
// Maps of points whose size is in pixels last while a camera turns, and a still view has the exact
// radii again.
VTK_INDIRECT_TEST(PointSpheresLast)
{
  CloudView view;
  view.DrawPointsAsSpheres();
  view.Grab();
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  for (int frame = 0; frame < 3; ++frame)
  {
    camera->Azimuth(1.0);
    view.Grab();
  }
  const long long tiles = CountOf(view.Pass, "sky_tiles_drawn");
  for (int frame = 0; frame < 8; ++frame)
  {
    camera->Azimuth(1.0);
    view.Grab();
  }
  CONTRACT_CHECK(
    CountOf(view.Pass, "sky_tiles_drawn") == tiles, "maps are drawn again at every turn");
  view.Grab();
  view.Grab();
  const Floats rests = Read(view.Pass, "sky");
  view.Pass->ReleaseGraphicsResources(view.Window);
  view.Grab();
  const Difference difference = Compare(Read(view.Pass, "sky"), rests);
  CONTRACT_CHECK(difference.Max <= 1e-5, "a still view keeps radii of motion: " << difference);
}

//------------------------------------------------------------------------------
// Points have the colours of their cells.
VTK_INDIRECT_TEST(PointSpheresOfColoredCells)
{
  CloudView view;
  view.Cloud->GetCellData()->SetScalars(view.Colors);
  view.DrawPointsAsSpheres();
  view.Grab();
  const Floats ofCells = Read(view.Pass, "bounce");
  view.Cloud->GetCellData()->SetScalars(nullptr);
  view.Cloud->GetPointData()->SetScalars(view.Colors);
  view.Grab();
  const Difference difference = Compare(Read(view.Pass, "bounce"), ofCells);
  CONTRACT_CHECK(Mean(ofCells, 0) > 1.1 * Mean(ofCells, 2), "no colour");
  CONTRACT_CHECK(difference.Max <= 1e-4, difference);
}
