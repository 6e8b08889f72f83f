// SPDX-License-Identifier: BSD-3-Clause
// Visible area lights: the picture shows their radiance, and the rest of it is the same as without.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkPropCollection.h"
#include "vtkRSMGatherPass.h"

#include <algorithm>
#include <cmath>

using namespace contract;

namespace
{
constexpr int Size = 120;
constexpr double Radiance[3] = { 0.25, 0.5, 0.75 };
// The lamp's square extends a quarter of the picture's height to either side of its middle.
constexpr int Inside = Size / 2 + 6;
constexpr int Outside = Size / 2 + 40;

// A lamp that faces the eye in front of a wall, over a floor, with a ball before its left half.
struct LampView : View
{
  vtkNew<vtkIndirectIlluminationPass> Pass;
  vtkNew<vtkRSMGatherPass> Gather;
  vtkNew<vtkAreaLight> Lamp;
  vtkSmartPointer<vtkActor> Ball = MakeSphere({ -0.5, 0.0, 0.8 }, 0.3);

  LampView()
    : View(Size, Size)
  {
    this->Renderer->AddActor(MakeQuad({ -3, -3, -1 }, { 3, -3, -1 }, { -3, 3, -1 }));
    this->Renderer->AddActor(MakeQuad({ -3, -1.2, -1 }, { -3, -1.2, 2 }, { 3, -1.2, -1 }));
    this->Renderer->AddActor(this->Ball);
    this->Renderer->SetBackground(0.1, 0.1, 0.1);
    this->Renderer->AutomaticLightCreationOff();
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0, 0, 4);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetViewAngle(2.0 * std::atan(0.5) * 180.0 / std::acos(-1.0));
    this->Renderer->ResetCameraClippingRange();
    this->Lamp->SetOrigin(-1, -1, 0);
    this->Lamp->SetPoint1(1, -1, 0);
    this->Lamp->SetPoint2(-1, 1, 0);
    this->Lamp->SetRadiance(Radiance);
    this->Pass->AddAreaLight(this->Lamp);
    this->Pass->SetEstimator(this->Gather);
    this->Renderer->SetPass(this->Pass);
    this->Window->SetDesiredUpdateRate(1e-4);
  }
  ~LampView() { this->Pass->SetEstimator(nullptr); }
};

bool IsRadiance(const Floats& picture, int x, int y, double tolerance = 1e-6)
{
  bool same = true;
  for (int c = 0; c < 3; ++c)
  {
    same = same && std::abs(picture.Get(x, y, c) - Radiance[c]) <= tolerance;
  }
  return same;
}

bool IsByte(const Pixels& picture, int x, int y, const Vec3& color)
{
  bool same = true;
  for (int c = 0; c < 3; ++c)
  {
    // Rounded by OpenGL, which may be off by half a step near one half.
    same =
      same && std::abs(picture.Get(x, y, c) - 255.0 * color[static_cast<size_t>(c)]) <= 0.501 + 0.1;
  }
  return same;
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(VisibleLampShowsItsRadiance)
{
  LampView view;
  const Pixels without = view.Grab();
  const Floats dark = Read(view.Pass, "final");
  CONTRACT_CHECK(!IsRadiance(dark, Inside, Inside), "seen by default");
  double bounds[6];
  view.Renderer->ComputeVisiblePropBounds(bounds);

  view.Lamp->VisibleOn();
  const Pixels with = view.Grab();
  const Floats picture = Read(view.Pass, "final");
  CONTRACT_CHECK(IsRadiance(picture, Inside, Inside), "its radiance");
  CONTRACT_CHECK(IsByte(with, Inside, Inside, { 0.25, 0.5, 0.75 }), "as it is shown");
  CONTRACT_CHECK(!IsRadiance(picture, Outside, Inside), "no more than the rectangle");
  // The ball stands before its left half.
  const int ball = Size / 2 - static_cast<int>(0.5 / 3.2 * Size);
  CONTRACT_CHECK(!IsRadiance(picture, ball, Size / 2), "hidden by the ball");
  size_t shown = 0;
  for (int y = 0; y < Size; ++y)
  {
    for (int x = 0; x < Size; ++x)
    {
      shown += IsRadiance(picture, x, y) ? 1 : 0;
    }
  }
  // A quarter of the picture minus the ball's disk, seen under its radius / distance, whose edge
  // pixels count to either.
  const double radius = 0.3 / std::sqrt(3.2 * 3.2 + 0.5 * 0.5 - 0.3 * 0.3) * Size;
  const double expected = 0.25 * Size * Size - std::acos(-1.0) * radius * radius;
  std::cout << shown << " pixels of " << expected << "\n";
  CONTRACT_CHECK(std::abs(static_cast<double>(shown) - expected) < 0.02 * expected, shown);

  double boundsWith[6];
  view.Renderer->ComputeVisiblePropBounds(boundsWith);
  CONTRACT_CHECK(std::equal(bounds, bounds + 6, boundsWith), "bounds that ResetCamera sees");
  const Report found(view.Pass);
  CONTRACT_CHECK(!found.FindReason("modelled", "area lights that are seen").empty(), "the report");

  view.Lamp->VisibleOff();
  CONTRACT_CHECK(Compare(view.Grab(), without).Pixels == 0, "turned off again");
  CONTRACT_CHECK(Compare(Read(view.Pass, "final"), dark).Pixels == 0, "turned off again, floats");
  view.Lamp->VisibleOn();
  view.Lamp->SwitchOff();
  CONTRACT_CHECK(!IsByte(view.Grab(), Inside, Inside, { 0.25, 0.5, 0.75 }), "seen while it is off");
}

//------------------------------------------------------------------------------
// Light on receivers that are visible in both cases.
VTK_INDIRECT_TEST(VisibleLampHidesNoLight)
{
  LampView view;
  view.Lamp->TwoSidedOn();
  // Another lamp, from before the first one to the wall behind it.
  vtkNew<vtkAreaLight> other;
  other->SetOrigin(-0.5, -0.5, 3);
  other->SetPoint1(-0.5, 0.5, 3);
  other->SetPoint2(0.5, -0.5, 3);
  view.Pass->AddAreaLight(other);
  for (const double rate : { 1e-4, 15.0 })
  {
    view.Window->SetDesiredUpdateRate(rate);
    view.Lamp->VisibleOff();
    view.Grab();
    const Floats before = Read(view.Pass, "area");
    view.Lamp->VisibleOn();
    view.Grab();
    const Floats after = Read(view.Pass, "area");
    const Floats picture = Read(view.Pass, "final");
    size_t compared = 0;
    double most = 0.0;
    for (int y = 0; y < Size; ++y)
    {
      for (int x = 0; x < Size; ++x)
      {
        if (IsRadiance(picture, x, y))
        {
          continue;
        }
        ++compared;
        for (int c = 0; c < 3; ++c)
        {
          const double d = std::abs(after.Get(x, y, c) - before.Get(x, y, c));
          most = std::max(most, d / std::max(before.Get(x, y, c), 0.01f));
        }
      }
    }
    std::cout << "rate " << rate << ": " << compared << " pixels, off by " << most << "\n";
    CONTRACT_CHECK(compared > Size * Size / 2, compared);
    // Still frames compute each pixel separately. In moving ones pixels beside the lamp no longer
    // interpolate from samples that it covers, and are computed: the difference is the error of
    // interpolation, 0.7 % RMS.
    CONTRACT_CHECK(most <= (rate < 1.0 ? 0.0 : 0.05), "rate " << rate << ": " << most);
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(VisibleLampShowsItsImage)
{
  LampView view;
  view.Renderer->RemoveActor(view.Ball);
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* values = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < 16; ++i)
  {
    values[3 * i] = 0.05f * static_cast<float>(i);
    values[3 * i + 1] = 2.0f; // brighter than the picture can show
    values[3 * i + 2] = 0.9f - 0.05f * static_cast<float>(i);
  }
  view.Lamp->SetImage(image);
  view.Lamp->SetRadiance(1.0, 1.0, 1.0);
  view.Lamp->VisibleOn();
  const Pixels shown = view.Grab();
  const Floats picture = Read(view.Pass, "final");
  const int quarter = Size / 8; // pixels of the picture along one of the image
  for (int i = 0; i < 16; ++i)
  {
    const int x = Size / 4 + quarter * (i % 4) + quarter / 2;
    const int y = Size / 4 + quarter * (i / 4) + quarter / 2;
    for (int c = 0; c < 3; ++c)
    {
      CONTRACT_CHECK(picture.Get(x, y, c) == values[3 * i + c], "image pixel " << i);
    }
    CONTRACT_CHECK(shown.Get(x, y, 1) == 255, "clamped, " << i);
  }
  // The next picture of a video.
  std::fill(values, values + 48, 0.5f);
  image->Modified();
  view.Grab();
  CONTRACT_CHECK(Read(view.Pass, "final").Get(Inside, Inside, 0) == 0.5f, "its next image");

  // From afar an image of fine black and white pixels is grey: the mean of the pixels that share a
  // pixel.
  constexpr int Edge = 512;
  vtkNew<vtkImageData> fine;
  fine->SetDimensions(Edge, Edge, 1);
  fine->AllocateScalars(VTK_FLOAT, 1);
  auto* dots = static_cast<float*>(fine->GetScalarPointer());
  for (int i = 0; i < Edge * Edge; ++i)
  {
    dots[i] = static_cast<float>((i % Edge + i / Edge) % 2);
  }
  view.Lamp->SetImage(fine);
  view.Grab();
  const Floats grey = Read(view.Pass, "final");
  CONTRACT_CHECK(std::abs(grey.Get(Inside, Inside, 0) - 0.5f) < 1e-3f, grey.Get(Inside, Inside, 0));
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(VisibleLampSides)
{
  LampView view;
  view.Lamp->VisibleOn();
  // Turned around, it sends no light to the eye.
  view.Lamp->SetPoint1(-1, 1, 0);
  view.Lamp->SetPoint2(1, -1, 0);
  for (const bool parallel : { false, true })
  {
    view.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
    view.Renderer->GetActiveCamera()->SetParallelScale(2.0);
    view.Lamp->TwoSidedOff();
    view.Grab();
    CONTRACT_CHECK(!IsRadiance(Read(view.Pass, "final"), Inside, Inside), "from behind");
    view.Lamp->TwoSidedOn();
    view.Grab();
    CONTRACT_CHECK(IsRadiance(Read(view.Pass, "final"), Inside, Inside), "two sides");
  }
}

//------------------------------------------------------------------------------
// The clipping range is not fitted to the lamp, which may intersect a wall.
VTK_INDIRECT_TEST(VisibleLampPlaces)
{
  LampView view;
  view.Lamp->VisibleOn();
  auto place = [&](double z, double half)
  {
    view.Lamp->SetOrigin(-half, -half, z);
    view.Lamp->SetPoint1(half, -half, z);
    view.Lamp->SetPoint2(-half, half, z);
    view.Grab();
    return IsRadiance(Read(view.Pass, "final"), Inside, Inside);
  };
  CONTRACT_CHECK(place(-1.0, 1.25), "in the wall");
  CONTRACT_CHECK(!place(-1.01, 1.25), "behind the wall");
  view.Renderer->GetActiveCamera()->SetClippingRange(2.0, 5.5);
  CONTRACT_CHECK(place(3.0, 0.25), "before the near plane");
  CONTRACT_CHECK(!place(-2.0, 1.5), "behind the wall and the far plane");
  // Without the wall only the floor is left.
  vtkPropCollection* props = view.Renderer->GetViewProps();
  props->InitTraversal();
  props->GetNextProp()->VisibilityOff();
  CONTRACT_CHECK(place(-2.0, 1.5), "behind the far plane");
  CONTRACT_CHECK(!place(5.0, 1.0), "behind the eye");
}

//------------------------------------------------------------------------------
// If VTK encodes its pixels, the lamp is encoded, too.
VTK_INDIRECT_TEST(VisibleLampInEncodedPictures)
{
  LampView view;
  view.Lamp->VisibleOn();
  view.Ball->GetProperty()->SetInterpolationToPBR();
  const Pixels shown = view.Grab();
  auto encode = [](double v) { return std::pow(v, 1.0 / 2.2); };
  CONTRACT_CHECK(IsByte(shown, Inside, Inside, { encode(0.25), encode(0.5), encode(0.75) }),
    static_cast<int>(shown.Get(Inside, Inside, 0)));
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(VisibleLampHasSmoothEdges)
{
  LampView view;
  view.Lamp->VisibleOn();
  view.Lamp->SetRadiance(2.0, 2.0, 2.0);
  view.Renderer->GetActiveCamera()->Roll(10.0);
  view.Pass->AntialiasingOff();
  const Pixels hard = view.Grab();
  view.Pass->AntialiasingOn();
  const Pixels soft = view.Grab();
  // Mixed pixels along a column over the lamp's upper edge.
  size_t mixed[2] = { 0, 0 };
  for (int i = 0; i < 2; ++i)
  {
    const Pixels& picture = i == 0 ? hard : soft;
    for (int x = Size / 2 - 10; x < Size / 2 + 20; ++x)
    {
      for (int y = Size / 2 + 20; y < Size / 2 + 45; ++y)
      {
        const int value = picture.Get(x, y, 0);
        mixed[i] += value < 250 && value > hard.Get(x, Size / 2 + 45, 0) + 30 ? 1 : 0;
      }
    }
  }
  std::cout << mixed[0] << " mixed pixels without antialiasing, " << mixed[1] << " with it\n";
  CONTRACT_CHECK(mixed[0] == 0 && mixed[1] >= 10, mixed[0] << ", " << mixed[1]);
}

//------------------------------------------------------------------------------
// If only the delegate draws, the report lists the lamp as not visible.
VTK_INDIRECT_TEST(VisibleLampInEmptyScene)
{
  LampView view;
  view.Renderer->RemoveAllViewProps();
  view.Lamp->VisibleOn();
  view.Grab();
  const Report found(view.Pass);
  CONTRACT_CHECK(
    !found.FindReason("left_out", "area lights that are seen").empty(), found.GetText());
}
