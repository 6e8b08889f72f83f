// SPDX-License-Identifier: BSD-3-Clause
// Light from the sky in still and in moving frames: equal for all forced paths, with shared maps,
// and without remains of one kind of frame in the other.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"

#include <algorithm>
#include <cstdlib>

using namespace contract;

namespace
{
// A room that is open to the eye, under a sky with a sun.
struct SkyView : View
{
  vtkNew<vtkIndirectIlluminationPass> Pass;
  vtkNew<vtkEnvironmentLight> Sky;

  SkyView(int width, int height, bool sun)
    : View(width, height)
  {
    AddRoomSurfaces(this->Renderer);
    this->Renderer->AddActor(MakeSphere({ 0.7, 0.25, 0.6 }, 0.15, { 0.9, 0.7, 0.3 }));
    if (sun)
    {
      vtkNew<vtkImageData> image;
      image->SetDimensions(64, 32, 1);
      image->AllocateScalars(VTK_FLOAT, 3);
      auto* p = static_cast<float*>(image->GetScalarPointer());
      for (int i = 0; i < 64 * 32; ++i)
      {
        p[3 * i] = p[3 * i + 1] = p[3 * i + 2] = 0.2f + 0.5f * static_cast<float>(i) / (64 * 32);
      }
      auto* bright = static_cast<float*>(image->GetScalarPointer(6, 22, 0));
      bright[0] = bright[1] = bright[2] = 500.0f;
      this->Sky->SetImage(image);
    }
    this->Pass->SetEnvironment(this->Sky);
    this->Renderer->SetPass(this->Pass);
    this->Renderer->ResetCameraClippingRange();
  }
  ~SkyView() { this->Pass->SetEnvironment(nullptr); }

  Floats Render(bool moving)
  {
    this->Window->SetDesiredUpdateRate(moving ? 15.0 : 1e-4);
    this->Grab();
    return Read(this->Pass, "sky");
  }
};

void Force(const std::string& paths)
{
  paths.empty() ? unsetenv("VTK_INDIRECT_PATHS") : setenv("VTK_INDIRECT_PATHS", paths.c_str(), 1);
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(SkyChoicesSame)
{
  for (const bool sun : { false, true })
  {
    for (const bool moving : { false, true })
    {
      const std::string name =
        std::string(sun ? "sun, " : "uniform, ") + (moving ? "moving" : "still");
      Force("uniforms=plain");
      const Floats usual = SkyView(121, 91, sun).Render(moving);
      double scale = 0.0;
      for (const float value : usual.Values)
      {
        scale = std::max(scale, static_cast<double>(value));
      }
      CONTRACT_CHECK(scale > 0.3 && IsFinite(usual), name << ": " << scale);
      Force("uniforms=flat");
      const Floats same = SkyView(121, 91, sun).Render(moving);
      const Difference difference = Compare(same, usual);
      std::cout << name << ": " << difference.Mean / scale << " in the mean, "
                << difference.Max / scale << " at most\n";
      // Sums of 256 terms; a shadow's edge may move over a pixel.
      CONTRACT_CHECK(difference.Mean <= 1e-4 * scale, name << difference);
    }
  }
  Force("");
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(SkyMovingIsPartOfStill)
{
  SkyView view(121, 91, true);
  auto count = [&]() { return CountOf(view.Pass, "sky_tiles_drawn"); };
  // Maps arrive over frames.
  Floats moving = view.Render(true);
  for (long long before = 0; before != count();)
  {
    before = count();
    moving = view.Render(true);
  }
  const long long first = count();
  // A quarter of 256, and the sun's own.
  CONTRACT_CHECK(first >= 60 && first <= 66, "tiles of a moving frame: " << first);
  CONTRACT_CHECK(
    Report(view.Pass).FindReason("modelled", "light from the sky").find("64") != std::string::npos,
    Report(view.Pass).GetText());
  const Floats still = view.Render(false);
  const long long all = count();
  CONTRACT_CHECK(all >= 252 && all <= 258, "tiles of both: " << all);
  const double apart = Compare(still, moving).Mean;
  CONTRACT_CHECK(apart > 0.0, "the still frame is the moving one's");
  for (int i = 0; i < 3; ++i)
  {
    // A moving frame after a still one keeps the still shares, but for a strip.
    const double kept = Compare(view.Render(true), still).Mean;
    std::cout << "difference to the still frame: " << kept << " of " << apart << "\n";
    CONTRACT_CHECK(kept > 0.0 && kept < 0.25 * apart, "a moving frame after a still one");
    CONTRACT_CHECK(Compare(view.Render(false), still).Max == 0.0, "and a still one after that");
  }
  CONTRACT_CHECK(count() == all, "tiles are drawn again: " << count());
  // Brightness does not jump when the camera stops.
  for (int c = 0; c < 3; ++c)
  {
    const double jump = std::abs(Mean(moving, c) - Mean(still, c)) / Mean(still, c);
    std::cout << "jump: " << jump << "\n";
    CONTRACT_CHECK(jump < 0.02, "the mean jumps by " << jump);
  }
}

//------------------------------------------------------------------------------
// A sky of only a sun, without other directions; and a sky without shadows.
VTK_INDIRECT_TEST(SkySunAlone)
{
  SkyView view(64, 48, false);
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 32, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* p = static_cast<float*>(image->GetScalarPointer());
  std::fill(p, p + 3 * 64 * 32, 0.0f);
  auto* bright = static_cast<float*>(image->GetScalarPointer(6, 22, 0));
  bright[0] = bright[1] = bright[2] = 500.0f;
  view.Sky->SetImage(image);
  const Floats still = view.Render(false);
  CONTRACT_CHECK(Mean(still, 0) > 0.01 && IsFinite(still), Mean(still, 0));
  const Floats moving = view.Render(true);
  const Difference stops = Compare(still, moving);
  std::cout << "a sun, still and moving: " << stops << "\n";
  // Moving frames find creases at every fourth pixel: measured 1 pixel of 3072.
  CONTRACT_CHECK(stops.Pixels <= 3, "a sun is the same in both: " << stops);
  view.Sky->SetImage(nullptr);
  view.Pass->SetVisibilityToNone();
  for (const bool moves : { false, true })
  {
    const Floats open = view.Render(moves);
    double most = 0.0;
    for (const float value : open.Values)
    {
      most = std::max(most, std::abs(value > 0.0f ? value - 1.0 : 0.0));
    }
    std::cout << "open sky off by " << most << "\n";
    CONTRACT_CHECK(most < 0.002, "an open sky of radiance 1 gives 1: off by " << most);
  }
}

//------------------------------------------------------------------------------
// A sky's resources are released with it, and made again.
VTK_INDIRECT_TEST(SkyGoesAway)
{
  SkyView view(64, 48, true);
  vtkNew<vtkLight> lamp;
  lamp->SetPositional(true);
  lamp->SetConeAngle(30.0);
  lamp->SetPosition(0.5, 0.9, 0.9);
  lamp->SetFocalPoint(0.5, 0.0, 0.5);
  view.Renderer->AddLight(lamp);
  auto bytes = [&]() { return Report(view.Pass).GetNumber("bytes"); };
  const Floats first = view.Render(false);
  const double with = bytes();
  view.Pass->SetEnvironment(nullptr);
  view.Grab();
  const double without = bytes();
  std::cout << with << " bytes with a sky, " << without << " without\n";
  // 256 directions' maps of 128 texels squared, and the sun's.
  CONTRACT_CHECK(with - without >= 256 * 128 * 128 * 4 + 1024 * 1024 * 4, "too much is left");
  SkyView never(64, 48, false);
  never.Pass->SetEnvironment(nullptr);
  never.Renderer->AddLight(lamp);
  never.Window->SetDesiredUpdateRate(1e-4);
  never.Grab();
  CONTRACT_CHECK(without == Report(never.Pass).GetNumber("bytes"), "of a pass without a sky");
  view.Pass->SetEnvironment(view.Sky);
  const Floats again = view.Render(false);
  CONTRACT_CHECK(Compare(again, first).Max == 0.0, "the sky that comes back is another");
  CONTRACT_CHECK(bytes() == with, "it takes another amount");
  view.Pass->SetIndirectScale(0.0);
  view.Grab();
  CONTRACT_CHECK(bytes() <= without, "IndirectScale 0 leaves " << bytes());
}
