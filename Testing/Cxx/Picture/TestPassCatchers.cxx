// SPDX-License-Identifier: BSD-3-Clause
// Props that catch light: they show the background, times the light on them over the light that
// they would receive alone.
#include "vtkIndirectContractRoom.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkAreaLight.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkProxyAccumulationPass.h"
#include "vtkTexture.h"

#include <algorithm>
#include <functional>

using namespace contract;

namespace
{
// A white plane at y = 0, or what catches light in its place.
vtkSmartPointer<vtkActor> MakeCatcher(bool catches)
{
  auto ground = MakeQuad({ -30, 0, -30 }, { -30, 0, 30 }, { 30, 0, -30 }, { 1, 1, 1 });
  vtkNew<vtkInformation> keys;
  keys->Set(vtkIndirectIlluminationPass::CASTS_SHADOWS(), 0);
  if (catches)
  {
    keys->Remove(vtkIndirectIlluminationPass::CASTS_SHADOWS());
    keys->Set(vtkIndirectIlluminationPass::CATCHES_LIGHT(), 1);
  }
  ground->SetPropertyKeys(keys);
  ground->UseBoundsOff();
  ground->GetProperty()->SetAmbient(0.0);
  ground->GetProperty()->SetSpecular(0.0);
  return ground;
}

// A sphere that stands on the plane or lies below it, seen from above.
struct CatcherScene : View
{
  vtkNew<vtkIndirectIlluminationPass> Pass;
  vtkSmartPointer<vtkActor> Ground;
  vtkSmartPointer<vtkActor> Sphere;

  CatcherScene(bool catches, double height)
    : View(160, 120)
    , Ground(MakeCatcher(catches))
    , Sphere(MakeSphere({ 0, height, 0 }, 0.5, { 0.8, 0.3, 0.2 }))
  {
    this->Renderer->AddActor(this->Sphere);
    this->Renderer->AddActor(this->Ground);
    this->Renderer->SetBackground(1.0, 1.0, 1.0);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 1.5, 3.0);
    camera->SetFocalPoint(0.0, 0.2, 0.0);
    // The plane goes on beyond the near and the far plane only where it catches light.
    camera->SetClippingRange(catches ? 2.0 : 0.01, catches ? 5.0 : 200.0);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Pass);
    this->Pass->SetNumberOfRefinements(0);
    this->Pass->SetErrorTolerance(0.035); // as many directions of the sky in all frames
  }

  void AddLight(LightKind kind, double size = 0.0)
  {
    auto light = MakeLight(kind, { 2.0, 4.0, 1.0 }, { 0.0, 0.0, 0.0 });
    vtkIndirectIlluminationPass::SetLightRadius(light, size);
    vtkIndirectIlluminationPass::SetLightAngle(light, 20.0 * size);
    this->Renderer->AddLight(light);
  }

  // A sky of many colours.
  void AddSky()
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(16, 8, 1);
    image->AllocateScalars(VTK_FLOAT, 3);
    auto* value = static_cast<float*>(image->GetScalarPointer());
    for (int i = 0; i < 3 * 16 * 8; ++i)
    {
      value[i] = 0.1f + 0.07f * static_cast<float>((i * 37) % 11);
    }
    vtkNew<vtkEnvironmentLight> sky;
    sky->SetImage(image);
    this->Pass->SetEnvironment(sky);
  }

  void AddLamp()
  {
    vtkNew<vtkAreaLight> lamp;
    lamp->SetOrigin(-0.5, 2.0, -0.5);
    lamp->SetPoint1(0.5, 2.0, -0.5);
    lamp->SetPoint2(-0.5, 2.0, 0.5);
    lamp->SetRadiance(5.0, 4.0, 3.0);
    this->Pass->AddAreaLight(lamp);
  }
};

using CatcherLight = std::pair<const char*, std::function<void(CatcherScene&)>>;
const CatcherLight CatcherLights[] = {
  { "sun", [](CatcherScene& scene) { scene.AddLight(LightKind::Directional); } },
  { "spot", [](CatcherScene& scene) { scene.AddLight(LightKind::Spot); } },
  { "point", [](CatcherScene& scene) { scene.AddLight(LightKind::Point, 0.1); } },
  { "wide sun", [](CatcherScene& scene) { scene.AddLight(LightKind::Directional, 0.1); } },
  { "sky", [](CatcherScene& scene) { scene.AddSky(); } },
  { "lamp", [](CatcherScene& scene) { scene.AddLamp(); } },
  { "full", [](CatcherScene& scene) { scene.Pass->SetLightingToFull(); } },
};
}

//------------------------------------------------------------------------------
// A plane that receives all light, and hides a sphere, is the background bit for bit, though the
// far plane lies before its end.
VTK_INDIRECT_TEST(CatchersAreTheBackground)
{
  const vtkSmartPointer<vtkTexture> texture = MakeColorfulTexture();
  const std::pair<const char*, std::function<void(vtkRenderer*)>> backgrounds[] = {
    { "white", [](vtkRenderer* renderer) { renderer->SetBackground(1.0, 1.0, 1.0); } },
    { "black", [](vtkRenderer* renderer) { renderer->SetBackground(0.0, 0.0, 0.0); } },
    { "gradient",
      [](vtkRenderer* renderer)
      {
        renderer->SetBackground(0.1, 0.2, 0.3);
        renderer->SetBackground2(0.9, 0.8, 0.2);
        renderer->GradientBackgroundOn();
      } },
    { "half transparent", [](vtkRenderer* renderer) { renderer->SetBackgroundAlpha(0.5); } },
    { "picture",
      [&](vtkRenderer* renderer)
      {
        renderer->SetBackgroundTexture(texture);
        renderer->TexturedBackgroundOn();
      } },
  };
  for (const CatcherLight& lighting : CatcherLights)
  {
    for (const auto& background : backgrounds)
    {
      CatcherScene scene(true, -0.6);
      lighting.second(scene);
      background.second(scene.Renderer);
      for (double rate : { 0.0001, 15.0 })
      {
        // A pixel of a moving frame sums a part of the sky's directions, and a part of its colours.
        if (rate > 1.0 && std::string(lighting.first) == "sky")
        {
          continue;
        }
        scene.Window->SetDesiredUpdateRate(rate);
        const Pixels image = scene.Grab();
        scene.Ground->VisibilityOff();
        scene.Sphere->VisibilityOff();
        const Pixels empty = scene.Grab();
        scene.Ground->VisibilityOn();
        scene.Sphere->VisibilityOn();
        const Difference difference = Compare(image, empty);
        CONTRACT_CHECK(difference.Max == 0.0,
          lighting.first << " on " << background.first << " at " << rate << ": " << difference);
      }
    }
  }
}

//------------------------------------------------------------------------------
// The share of the background is the light on a white plane that hides nothing, over that on the
// same plane without the sphere.
VTK_INDIRECT_TEST(CatchersCompareLight)
{
  for (const CatcherLight& lighting : CatcherLights)
  {
    // A preset finds its lights by the colour of the plane, too, unless the plane catches light.
    if (std::string(lighting.first) == "full")
    {
      continue;
    }
    CatcherScene scene(true, 0.51);
    lighting.second(scene);
    scene.Grab();
    const Floats share = Read(scene.Pass, "caught");
    const Floats albedo = Read(scene.Pass, "albedo");
    CatcherScene plane(false, 0.51);
    lighting.second(plane);
    plane.Grab();
    const Floats with = Read(plane.Pass, "final");
    // A sphere below the plane changes no light on the plane.
    plane.Sphere->SetPosition(0.0, -2.0, 0.0);
    plane.Grab();
    const Floats alone = Read(plane.Pass, "final");
    double worst = 0.0;
    double least = 1.0;
    int compared = 0;
    for (size_t i = 0; i < share.Values.size(); ++i)
    {
      // The sphere is not white.
      if (albedo.Values[i - i % 3 + 1] < 0.99f)
      {
        continue;
      }
      ++compared;
      const double expected = alone.Values[i] > 0.0f ? with.Values[i] / alone.Values[i] : 1.0;
      worst = std::max(worst, std::abs(share.Values[i] - expected));
      least = std::min(least, expected);
    }
    std::cout << lighting.first << ": " << compared << " values, least " << least << ", off by "
              << worst << "\n";
    CONTRACT_CHECK(compared > 20000, lighting.first << ": " << compared << " values");
    CONTRACT_CHECK(least < 0.9, lighting.first << ": no shadow, " << least);
    CONTRACT_CHECK(worst < 2.0 / 255.0, lighting.first << ": off by " << worst);
    CheckReported(scene.Pass, "props that catch light");
  }
}

//------------------------------------------------------------------------------
// Alpha is the share of the background that is lost, where only the plane is.
VTK_INDIRECT_TEST(CatchersAlpha)
{
  CatcherScene scene(true, 0.51);
  scene.AddSky();
  scene.AddLight(LightKind::Directional);
  const Pixels white = scene.Grab();
  scene.Renderer->SetBackground(0.0, 0.0, 0.0);
  const Pixels black = scene.Grab();
  const Floats share = Read(scene.Pass, "caught");
  double worst = 0.0;
  double worstColor = 0.0;
  int shadowed = 0;
  for (size_t i = 0; i < share.Values.size() / 3; ++i)
  {
    const double kept =
      std::min({ share.Values[3 * i], share.Values[3 * i + 1], share.Values[3 * i + 2] });
    // Pixels that antialiasing has mixed with the sphere are neither.
    if (kept == 0.0 || black.Values[4 * i] > 0 || black.Values[4 * i + 1] > 0)
    {
      continue;
    }
    shadowed += kept < 0.9 ? 1 : 0;
    const double alpha = 255.0 * (1.0 - std::min(kept, 1.0));
    worst = std::max(worst, std::abs(black.Values[4 * i + 3] - alpha));
    worst = std::max(worst, std::abs(white.Values[4 * i + 3] - alpha));
    for (size_t c = 0; c < 3; ++c)
    {
      const double color = 255.0 * std::min(static_cast<double>(share.Values[3 * i + c]), 1.0);
      worstColor = std::max(worstColor, std::abs(white.Values[4 * i + c] - color));
    }
  }
  std::cout << shadowed << " pixels in shadow, alpha off by " << worst << ", colours by "
            << worstColor << "\n";
  CONTRACT_CHECK(shadowed > 200, "no shadow");
  CONTRACT_CHECK(worst <= ByteRounding && worstColor <= ByteRounding,
    "alpha off by " << worst << ", colours by " << worstColor);
}

//------------------------------------------------------------------------------
// Neither depth nor maps nor the sphere's own light depend on what catches light.
VTK_INDIRECT_TEST(CatchersLeaveNoTrace)
{
  CatcherScene scene(true, 0.51);
  scene.AddLight(LightKind::Directional);
  scene.AddSky();
  scene.Grab();
  const std::vector<float> depth = GrabDepth(scene.Window);
  const Floats map = Read(scene.Pass, "rsm0.depth");
  const Floats final = Read(scene.Pass, "final");
  scene.Ground->VisibilityOff();
  scene.Grab();
  const std::vector<float> without = GrabDepth(scene.Window);
  size_t moved = 0;
  for (size_t i = 0; i < depth.size(); ++i)
  {
    moved += std::abs(depth[i] - without[i]) > 2.0f / (1 << 24) ? 1 : 0;
  }
  CONTRACT_CHECK(moved == 0, moved << " depths differ");
  CONTRACT_CHECK(Compare(map, Read(scene.Pass, "rsm0.depth")).Max == 0.0, "the map differs");
  const Difference difference = Compare(final, Read(scene.Pass, "final"));
  std::cout << difference << "\n";
  CONTRACT_CHECK(difference.Mean < 1e-3, "light on the sphere: " << difference);
  // A picture of the delegate alone does not show the plane either.
  scene.Pass->SetIndirectScale(0.0);
  scene.Pass->ShadowsOff();
  const Pixels plain = scene.Grab();
  scene.Ground->VisibilityOn();
  CONTRACT_CHECK(Compare(plain, scene.Grab()).Max == 0.0, "the delegate draws the plane");
}

//------------------------------------------------------------------------------
// With an estimator that does not tell the light of an open sky nothing is caught, and the report
// says so; props without faces stay what they are.
VTK_INDIRECT_TEST(CatchersThatCannot)
{
  CatcherScene scene(true, 0.51);
  scene.AddSky();
  vtkSmartPointer<vtkIndirectEstimatorPass> spheres =
    vtkSmartPointer<vtkProxyAccumulationPass>::New();
  scene.Pass->SetEstimator(spheres);
  scene.Grab();
  CheckReported(scene.Pass, "does not tell the light of a sky");
  const Floats share = Read(scene.Pass, "caught");
  CONTRACT_CHECK(*std::max_element(share.Values.begin(), share.Values.end()) == 1.0f &&
      std::none_of(share.Values.begin(), share.Values.end(),
        [](float value) { return value > 0.0f && value < 1.0f; }),
    "something is caught");
  scene.Pass->SetEstimator(nullptr);
  scene.Ground->GetProperty()->LightingOff();
  scene.Grab();
  CheckReported(scene.Pass, "CATCHES_LIGHT");
}
