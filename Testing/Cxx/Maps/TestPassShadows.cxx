// SPDX-License-Identifier: BSD-3-Clause
// Position and darkness of shadows, and lit surfaces without any.
#include "vtkIndirectContractUtilities.h"

#include "vtkMath.h"
#include "vtkRenderWindow.h"

#include <algorithm>
#include <functional>

using namespace contract;

namespace
{
// A square plane at z = 0 seen by a parallel camera from above, and a square over it.
struct ShadowScene
{
  View Window;
  vtkNew<vtkIndirectIlluminationPass> Pass;
  double Extent;    // half an edge of the view
  double Center[2]; // centre of the view
  vtkSmartPointer<vtkActor> Plane;
  vtkSmartPointer<vtkActor> Blocker;
  Vec3 BlockerCenter{ { 0, 0, 0 } };
  double BlockerHalf = 0.0;

  explicit ShadowScene(double extent, int width = 200, int height = 200)
    : Window(width, height)
    , Extent(extent)
    , Center{ 0.0, 0.0 }
  {
    this->Pass->SetIndirectScale(0.0);
    this->Window.Renderer->SetPass(this->Pass);
    this->Window.Renderer->AutomaticLightCreationOff();
  }

  void AddPlane(double half)
  {
    this->Plane = MakeQuad({ -half, -half, 0 }, { half, -half, 0 }, { -half, half, 0 });
    this->Window.Renderer->AddActor(this->Plane);
  }

  void AddBlocker(const Vec3& center, double half)
  {
    this->BlockerCenter = center;
    this->BlockerHalf = half;
    this->Blocker = MakeQuad({ center[0] - half, center[1] - half, center[2] },
      { center[0] + half, center[1] - half, center[2] },
      { center[0] - half, center[1] + half, center[2] });
    this->Window.Renderer->AddActor(this->Blocker);
  }

  void LookDown(double height)
  {
    vtkCamera* camera = this->Window.Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(this->Extent);
    camera->SetPosition(this->Center[0], this->Center[1], height);
    camera->SetFocalPoint(this->Center[0], this->Center[1], 0);
    camera->SetViewUp(0, 1, 0);
    camera->SetClippingRange(0.1 * height, 1.5 * height);
  }

  // Direct light with shadows over direct light without.
  Floats Visibility()
  {
    this->Pass->ShadowsOn();
    this->Window.Grab();
    Floats shadowed = Read(this->Pass, "direct");
    // Without shadows and without indirect light only the delegate would run.
    this->Pass->ShadowsOff();
    this->Pass->SetIndirectScale(1e-6);
    this->Window.Grab();
    const Floats lit = Read(this->Pass, "direct");
    this->Pass->SetIndirectScale(0.0);
    for (size_t i = 0; i < shadowed.Values.size(); ++i)
    {
      shadowed.Values[i] = lit.Values[i] > 0.0f ? shadowed.Values[i] / lit.Values[i] : -1.0f;
    }
    return shadowed;
  }

  // Centre of a pixel on the plane.
  void GetPoint(int x, int y, double point[2]) const
  {
    const int* size = this->Window.Window->GetActualSize();
    const double pixel = 2.0 * this->Extent / size[1];
    point[0] = this->Center[0] + (x + 0.5 - 0.5 * size[0]) * pixel;
    point[1] = this->Center[1] + (y + 0.5 - 0.5 * size[1]) * pixel;
  }

  // Distance of a point of the plane from the edge of the blocker's shadow, positive inside.
  double GetDepthInShadow(const double point[2], vtkLight* light) const
  {
    // Intersection of the ray from the point to the light with the blocker's plane, and the scale
    // of lengths on the plane there.
    double position[3];
    light->GetPosition(position);
    double at[2];
    double shrink = 1.0;
    if (light->GetPositional())
    {
      const double t = this->BlockerCenter[2] / position[2];
      at[0] = point[0] + t * (position[0] - point[0]);
      at[1] = point[1] + t * (position[1] - point[1]);
      shrink = 1.0 - t;
    }
    else
    {
      double focal[3];
      light->GetFocalPoint(focal);
      const double t = this->BlockerCenter[2] / (position[2] - focal[2]);
      at[0] = point[0] + t * (position[0] - focal[0]);
      at[1] = point[1] + t * (position[1] - focal[1]);
    }
    const double dx = std::abs(at[0] - this->BlockerCenter[0]) - this->BlockerHalf;
    const double dy = std::abs(at[1] - this->BlockerCenter[1]) - this->BlockerHalf;
    return -std::max(dx, dy) / shrink;
  }

  bool IsOnBlocker(const double point[2], double margin) const
  {
    return std::max(std::abs(point[0] - this->BlockerCenter[0]),
             std::abs(point[1] - this->BlockerCenter[1])) <= this->BlockerHalf + margin;
  }
};

struct ShadowErrors
{
  size_t Inside = 0;      // pixels well in the shadow
  size_t Outside = 0;     // pixels well out of it
  size_t Misplaced = 0;   // on the wrong side of one half, more than 1.5 texels from the edge
  double Brightest = 0.0; // visibility well in the shadow
  double Darkest = 1.0;   // and well out of it
};

// texel: size of a map's texel on the plane along either axis of the plane, an upper bound.
ShadowErrors Measure(const ShadowScene& scene, const Floats& visibility, vtkLight* light,
  double texel, const std::function<bool(const double*)>& ignore = {})
{
  ShadowErrors errors;
  const int* size = scene.Window.Window->GetActualSize();
  const double pixel = 2.0 * scene.Extent / size[1];
  for (int y = 0; y < visibility.Height; ++y)
  {
    for (int x = 0; x < visibility.Width; ++x)
    {
      double point[2];
      scene.GetPoint(x, y, point);
      const float v = visibility.Get(x, y, 0);
      if (v < 0.0f || scene.IsOnBlocker(point, 2 * pixel) || (ignore && ignore(point)))
      {
        continue;
      }
      const double depth = scene.GetDepthInShadow(point, light);
      if (std::abs(depth) > 1.5 * texel)
      {
        errors.Misplaced += (v < 0.5f) != (depth > 0.0) ? 1 : 0;
      }
      // The filter extends 1.5 texels along both axes of the map.
      if (std::abs(depth) > 1.5 * std::sqrt(2.0) * texel)
      {
        (depth > 0.0 ? errors.Inside : errors.Outside) += 1;
        errors.Brightest = depth > 0.0 ? std::max<double>(errors.Brightest, v) : errors.Brightest;
        errors.Darkest = depth > 0.0 ? errors.Darkest : std::min<double>(errors.Darkest, v);
      }
    }
  }
  return errors;
}

std::ostream& operator<<(std::ostream& os, const ShadowErrors& errors)
{
  return os << errors.Inside << " pixels in shadow, brightest " << errors.Brightest << "; "
            << errors.Outside << " out of it, darkest " << errors.Darkest << "; "
            << errors.Misplaced << " misplaced";
}

void CheckShadow(const ShadowErrors& errors, const std::string& what)
{
  std::cout << what << ": " << errors << "\n";
  CONTRACT_CHECK(errors.Inside > 100 && errors.Outside > 100, what << ": nothing to see");
  CONTRACT_CHECK(errors.Misplaced == 0, what << ": " << errors);
  CONTRACT_CHECK(errors.Brightest == 0.0, what << ": the umbra is not black: " << errors);
  // The filter's weights sum to one but for rounding.
  CONTRACT_CHECK(errors.Darkest > 1.0 - 1e-6, what << ": shadow where none is: " << errors);
}

// A texel's size on the plane z = 0 for a light that looks at it.
double TexelOnPlane(vtkLight* light, LightKind kind, int resolution, double sceneSize, double reach)
{
  double position[3];
  light->GetPosition(position);
  double focal[3];
  light->GetFocalPoint(focal);
  double toLight[3];
  vtkMath::Subtract(position, focal, toLight);
  const double distance = vtkMath::Norm(toLight);
  if (kind == LightKind::Directional)
  {
    return 1.01 * sceneSize / resolution * distance / toLight[2];
  }
  const double halfWidth =
    kind == LightKind::Spot ? std::tan(vtkMath::RadiansFromDegrees(light->GetConeAngle())) : 1.0;
  // The farthest tested point, seen at the smallest angle.
  const double farthest = std::sqrt(position[2] * position[2] + reach * reach);
  return 2.0 * halfWidth / resolution * farthest * farthest / position[2];
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ShadowPosition)
{
  for (LightKind kind :
    { LightKind::Directional, LightKind::Spot, LightKind::WideSpot, LightKind::Point })
  {
    for (int resolution : { 128, 512 })
    {
      ShadowScene scene(1.0);
      scene.AddPlane(1.5);
      scene.AddBlocker({ -0.55, -0.3, 0.5 }, 0.2);
      scene.LookDown(4.0);
      const Vec3 position =
        kind == LightKind::Directional ? Vec3{ -1.2, -0.5, 1.0 } : Vec3{ -1.3, -0.7, 1.5 };
      const Vec3 focal =
        kind == LightKind::Directional ? Vec3{ 0.0, 0.0, 0.0 } : Vec3{ 0.2, 0.0, 0.0 };
      auto light = MakeLight(kind, position, focal, 50.0);
      scene.Window.Renderer->AddLight(light);
      scene.Pass->SetReflectiveShadowMapResolution(resolution);
      const double texel = TexelOnPlane(light, kind, resolution, 4.3, 2.4);
      const Floats visibility = scene.Visibility();
      const ShadowErrors errors = Measure(scene, visibility, light, texel);
      CheckShadow(errors, std::string(GetName(kind)) + " " + std::to_string(resolution));
    }
  }
}

//------------------------------------------------------------------------------
// The umbra is as black far from the blocker as near to it.
VTK_INDIRECT_TEST(ShadowDistance)
{
  for (double height : { 0.2, 2.0, 20.0, 200.0 })
  {
    ShadowScene scene(1.0);
    scene.AddPlane(1.5);
    scene.AddBlocker({ -0.9, -0.9, height }, 0.3);
    scene.LookDown(2.0 * height + 4.0);
    auto light =
      MakeLight(LightKind::Directional, { -0.9 / height, -0.9 / height, 1.0 }, { 0.0, 0.0, 0.0 });
    scene.Window.Renderer->AddLight(light);
    const double slant = std::sqrt(2.0 * 0.81 / height / height + 1.0);
    // Along the light the scene is no wider than the plane and the blocker's offset.
    const double texel = 1.01 * std::sqrt(18.0) / 512.0 * slant;
    const Floats visibility = scene.Visibility();
    CheckShadow(Measure(scene, visibility, light, texel), "height " + std::to_string(height));
  }
}

//------------------------------------------------------------------------------
// The map is square for any window.
VTK_INDIRECT_TEST(ShadowAspect)
{
  const int sizes[][2] = { { 200, 200 }, { 400, 200 }, { 100, 200 }, { 200, 400 } };
  for (LightKind kind : { LightKind::Directional, LightKind::Spot, LightKind::Point })
  {
    Floats square;
    for (const auto& size : sizes)
    {
      const bool doubled = size[1] == 400;
      ShadowScene scene(doubled ? 2.0 : 1.0, size[0], size[1]);
      scene.Pass->SetReflectiveShadowMapResolution(512);
      scene.AddPlane(3.0);
      scene.AddBlocker({ -0.55, -0.3, 0.5 }, 0.2);
      scene.LookDown(4.0);
      auto light = MakeLight(kind, { -1.2, -0.5, 1.5 }, { 0.0, 0.0, 0.0 }, 55.0);
      scene.Window.Renderer->AddLight(light);
      const Floats visibility = scene.Visibility();
      const double texel = TexelOnPlane(light, kind, 512, 8.6, 3.0);
      CheckShadow(Measure(scene, visibility, light, texel),
        std::string(GetName(kind)) + " " + std::to_string(size[0]) + "x" + std::to_string(size[1]));
      if (square.Width == 0)
      {
        square = visibility;
      }
      // The middle of every window shows the same points in pixels of the same size.
      double largest = 0.0;
      const int shift[2] = { (size[0] - 200) / 2, (size[1] - 200) / 2 };
      for (int y = 0; y < 200; ++y)
      {
        for (int x = std::max(0, -shift[0]); x < std::min(200, size[0] - shift[0]); ++x)
        {
          largest = std::max<double>(
            largest, std::abs(square.Get(x, y, 0) - visibility.Get(x + shift[0], y + shift[1], 0)));
        }
      }
      std::cout << "  largest difference to the square window " << largest << "\n";
      // Positions differ only by rounding of the eye's own transform; 1e-3 of a quarter step.
      CONTRACT_CHECK(largest < 0.02, GetName(kind) << " " << size[0] << " x " << size[1]);
    }
  }
}

//------------------------------------------------------------------------------
namespace
{
// A single plane never shadows itself. Returns the darkest visibility; counts lit pixels.
double DarkestOnPlane(LightKind kind, double degrees, double scale, int resolution,
  const Vec3& shift, int cells, bool parallelEye, size_t& lit)
{
  View view(96, 96);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetReflectiveShadowMapResolution(resolution);
  view.Renderer->SetPass(pass);
  auto place = [&](double x, double y, double z) {
    return Vec3{ shift[0] + scale * x, shift[1] + scale * y, shift[2] + scale * z };
  };
  view.Renderer->AddActor(
    MakeQuad(place(-1, -1, 0), place(1, -1, 0), place(-1, 1, 0), { 0.8, 0.8, 0.8 }, cells));
  const double angle = vtkMath::RadiansFromDegrees(degrees);
  // An arbitrary direction, because special ones round exactly.
  const double distance = kind == LightKind::Spot ? 2.5 : 1.3;
  const Vec3 position = place(distance * std::sin(angle) * std::cos(0.7),
    distance * std::sin(angle) * std::sin(0.7), distance * std::cos(angle));
  view.Renderer->AddLight(MakeLight(kind, position, place(0, 0, 0), 40.0));
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  const Vec3 eye = place(0.4, -1.9, 1.8);
  const Vec3 focal = place(0, 0, 0);
  camera->SetPosition(eye[0], eye[1], eye[2]);
  camera->SetFocalPoint(focal[0], focal[1], focal[2]);
  camera->SetViewUp(0, 0, 1);
  camera->SetParallelProjection(parallelEye);
  camera->SetParallelScale(1.1 * scale);
  camera->SetViewAngle(55);
  view.Renderer->ResetCameraClippingRange();

  pass->SetIndirectScale(1e-6);
  pass->ShadowsOff();
  view.Grab();
  const Floats unshadowed = Read(pass, "direct");
  pass->ShadowsOn();
  view.Grab();
  const Floats shadowed = Read(pass, "direct");
  double darkest = 1.0;
  for (size_t i = 0; i < unshadowed.Values.size(); i += 3)
  {
    if (unshadowed.Values[i] > 0.0f)
    {
      ++lit;
      // Below 2 % of the light's strength the precision of the facet's normal, a difference of
      // floats, does not suffice for a decision; it may cost at most a quarter of a step of 255.
      const double lost = unshadowed.Values[i] - shadowed.Values[i];
      if (unshadowed.Values[i] < 0.02 * 0.8 && lost < 0.001)
      {
        continue;
      }
      darkest = std::min<double>(darkest, shadowed.Values[i] / unshadowed.Values[i]);
    }
  }
  return darkest;
}

void CheckNoSelfShadow(LightKind kind, double degrees, double scale, int resolution,
  const Vec3& shift, int cells, bool parallelEye)
{
  size_t lit = 0;
  const double darkest =
    DarkestOnPlane(kind, degrees, scale, resolution, shift, cells, parallelEye, lit);
  CONTRACT_CHECK(lit > 50, GetName(kind) << " " << degrees << ": nothing lit");
  CONTRACT_CHECK(darkest > 1.0 - 1e-6,
    GetName(kind) << ", " << degrees << " degrees, scale " << scale << ", " << resolution
                  << " texels, " << cells << " cells, "
                  << (parallelEye ? "parallel" : "perspective") << " eye: visibility " << darkest);
}
}

VTK_INDIRECT_TEST(ShadowNoSelf)
{
  for (LightKind kind :
    { LightKind::Directional, LightKind::Spot, LightKind::WideSpot, LightKind::Point })
  {
    for (double degrees : { 0.0, 30.0, 60.0, 80.0, 87.0, 89.5 })
    {
      for (int resolution : { 64, 512 })
      {
        CheckNoSelfShadow(kind, degrees, 1.0, resolution, { 0, 0, 0 }, 3, false);
      }
    }
    CheckNoSelfShadow(kind, 45.0, 1.0, 1024, { 0, 0, 0 }, 1, false);
    CheckNoSelfShadow(kind, 45.0, 1.0, 256, { 0, 0, 0 }, 7, true);
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ShadowNoSelfScales)
{
  for (LightKind kind : { LightKind::Directional, LightKind::Spot, LightKind::Point })
  {
    for (double scale : { 1e-3, 1e3 })
    {
      for (double degrees : { 20.0, 75.0 })
      {
        CheckNoSelfShadow(kind, degrees, scale, 256, { 0, 0, 0 }, 3, false);
      }
    }
    // VTK's own vertices are floats: at a thousand scene sizes their error is 1e-4 of a size.
    CheckNoSelfShadow(kind, 40.0, 1.0, 256, { 100, -200, 300 }, 3, false);
  }
}
