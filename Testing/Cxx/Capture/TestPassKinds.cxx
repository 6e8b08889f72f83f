// SPDX-License-Identifier: BSD-3-Clause
// All kinds of actors that VTK draws, and the buffers' values of known surfaces.
#include "vtkIndirectContractUtilities.h"

#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkPlaneSource.h"
#include "vtkRenderWindow.h"
#include "vtkTexture.h"

#include <algorithm>
#include <functional>

using namespace contract;

namespace
{
void AddKindLights(vtkRenderer* renderer)
{
  renderer->AddLight(MakeLight(LightKind::Directional, { 1.0, 2.0, 6.0 }, { 0, 0, 0 }));
  renderer->SetBackground(0.1, 0.2, 0.3);
}

// True for kinds that neither cast shadows nor send light.
bool IsNoCaster(const std::string& name)
{
  return name == "points" || name == "wireframe" || name == "lines" || name == "tubes" ||
    name == "follower";
}

// True for kinds drawn without lighting: such props neither reflect nor receive.
bool IsUnlit(const std::string& name)
{
  return name == "unlit" || name == "lines" || name == "image slice";
}
}

//------------------------------------------------------------------------------
// IndirectScale 0 and Shadows off: the delegate's picture, bit for bit.
VTK_INDIRECT_TEST(KindsDelegate)
{
  View view(250, 250);
  AddKinds(view.Renderer);
  AddKindLights(view.Renderer);
  const Pixels plain = view.Grab();
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetIndirectScale(0.0);
  pass->ShadowsOff();
  view.Renderer->SetPass(pass);
  const Pixels image = view.Grab();
  CONTRACT_CHECK(Mean(plain, 0) > 20.0, "nothing to see");
  const Difference difference = Compare(plain, image);
  CONTRACT_CHECK(difference.Max == 0.0, difference);
}

//------------------------------------------------------------------------------
// The whole path through float buffers, with no light to add and no shadow.
VTK_INDIRECT_TEST(KindsComposite)
{
  std::vector<std::string> names;
  {
    View view(16, 16);
    AddKinds(view.Renderer, &names);
  }
  CONTRACT_CHECK(names.size() >= 15, names.size() << " kinds");
  names.emplace_back(); // all of them
  for (const std::string& name : names)
  {
    View view(250, 250);
    AddKinds(view.Renderer, nullptr, name);
    // A light at the eye: each kind alone has no visible shadow.
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    light->SetPosition(view.Renderer->GetActiveCamera()->GetPosition());
    light->SetFocalPoint(view.Renderer->GetActiveCamera()->GetFocalPoint());
    light->SetShadowAttenuation(0.0); // casts no shadow
    view.Renderer->AddLight(light);
    view.Renderer->SetBackground(0.1, 0.2, 0.3);
    const Pixels plain = view.Grab();
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->AntialiasingOff(); // the same pixels as without the pass
    pass->SetIndirectScale(0.0);
    pass->ShadowsOn();
    view.Renderer->SetPass(pass);
    const Pixels image = view.Grab();
    const Difference difference = Compare(plain, image);
    std::cout << (name.empty() ? "all" : name) << ": " << difference << "\n";
    // A single kind that neither casts shadows nor sends light is left to the delegate.
    if (!IsNoCaster(name))
    {
      CONTRACT_CHECK(Mean(Read(pass, "depth"), 0) > 0.0, name << ": no buffers");
    }
    CONTRACT_CHECK(difference.Max <= 1.0, name << ": " << difference);
  }
}

//------------------------------------------------------------------------------
// Every kind under the full pass, above a floor that reflects: no error, and light arrives.
VTK_INDIRECT_TEST(KindsFull)
{
  std::vector<std::string> names;
  {
    View view(16, 16);
    AddKinds(view.Renderer, &names);
  }
  // All kinds share one window and its shaders.
  View view(100, 100);
  for (const std::string& name : names)
  {
    view.Window->RemoveRenderer(view.Renderer);
    view.Renderer = vtkSmartPointer<vtkRenderer>::New();
    view.Window->AddRenderer(view.Renderer);
    AddKinds(view.Renderer, nullptr, name);
    vtkRenderer* renderer = view.Renderer;
    double bounds[6];
    renderer->ComputeVisiblePropBounds(bounds);
    const double x = 0.5 * (bounds[0] + bounds[1]);
    const double y = 0.5 * (bounds[2] + bounds[3]);
    renderer->AddActor(
      MakeQuad({ x - 1, y - 0.5, -1 }, { x - 1, y - 0.5, 1 }, { x + 1, y - 0.5, -1 }));
    renderer->AddLight(MakeLight(LightKind::Spot, { x, y + 2, 1.5 }, { x, y, 0 }, 50.0));
    renderer->AddLight(MakeLight(LightKind::Directional, { 0.2, 1, 1 }, { 0, 0, 0 }));
    renderer->AddLight(MakeLight(LightKind::Point, { x + 0.7, y + 1, 1 }, { x, y, 0 }));
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->SetPosition(x, y + 0.4, 4);
    camera->SetFocalPoint(x, y, 0);
    renderer->ResetCameraClippingRange();
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->SetReflectiveShadowMapResolution(128);
    renderer->SetPass(pass);
    view.Grab();
    view.Grab();
    for (const char* buffer : { "final", "direct", "indirect", "irradiance", "albedo", "normal",
           "depth", "rsm0.density", "rsm1.density", "rsm2.density", "lights" })
    {
      Read(pass, buffer); // checks that all values are finite
    }
    const double mean = Mean(Read(pass, "indirect"), 1);
    std::cout << name << ": mean indirect light " << mean << "\n";
    // The floor alone reflects onto nothing: this light is reflected by the kind, or falls on it.
    CONTRACT_CHECK((mean > 1e-4) != IsUnlit(name), name << ": mean indirect light " << mean);
  }
}

//------------------------------------------------------------------------------
// A texture's colour is in the albedo; so are vertex colours.
VTK_INDIRECT_TEST(AlbedoValues)
{
  struct Case
  {
    const char* Name;
    std::function<void(vtkActor*)> Change;
    Vec3 Albedo;
  };
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(2, 2, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 4; ++i)
  {
    auto* pixel = static_cast<unsigned char*>(picture->GetScalarPointer()) + 3 * i;
    pixel[0] = 51;
    pixel[1] = 102;
    pixel[2] = 204;
  }
  const Case cases[] = {
    { "colour", [](vtkActor*) {}, { 0.5, 0.25, 0.75 } },
    { "diffuse coefficient", [](vtkActor* actor) { actor->GetProperty()->SetDiffuse(0.5); },
      { 0.25, 0.125, 0.375 } },
    { "texture",
      [&](vtkActor* actor)
      {
        vtkNew<vtkTexture> texture;
        texture->SetInputData(picture);
        actor->SetTexture(texture);
      },
      { 0.1, 0.1, 0.6 } },
    { "physically based", [](vtkActor* actor) { actor->GetProperty()->SetInterpolationToPBR(); },
      { 0.5, 0.25, 0.75 } },
    { "half metal",
      [](vtkActor* actor)
      {
        actor->GetProperty()->SetInterpolationToPBR();
        actor->GetProperty()->SetMetallic(0.5);
      },
      { 0.25, 0.125, 0.375 } },
    { "unlit", [](vtkActor* actor) { actor->GetProperty()->LightingOff(); }, { 0, 0, 0 } },
  };
  for (const Case& c : cases)
  {
    View view(40, 40);
    auto actor = MakeQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, { 0.5, 0.25, 0.75 });
    c.Change(actor);
    view.Renderer->AddActor(actor);
    view.Renderer->AddActor(MakeQuad({ -1, -1, 0 }, { -1, -1, 2 }, { -1, 1, 0 }));
    view.Renderer->AddLight(MakeLight(LightKind::Directional, { 0.5, 0, 1 }, { 0, 0, 0 }));
    vtkCamera* camera = view.Renderer->GetActiveCamera();
    camera->SetPosition(0, 0, 3);
    view.Renderer->ResetCameraClippingRange();
    vtkNew<vtkIndirectIlluminationPass> pass;
    view.Renderer->SetPass(pass);
    view.Grab();
    const Floats albedo = Read(pass, "albedo");
    const Floats indirect = Read(pass, "indirect");
    const Floats irradiance = Read(pass, "irradiance");
    const bool unlit = std::string(c.Name) == "unlit";
    for (int k = 0; k < 3; ++k)
    {
      const double value = albedo.Get(20, 20, k);
      // PBR takes colours as encoded with gamma 2.2 only when they come from textures or scalars.
      CONTRACT_CHECK(std::abs(value - c.Albedo[k]) < 2e-3,
        c.Name << " component " << k << ": " << value << " for " << c.Albedo[k]);
      const double product = value * irradiance.Get(20, 20, k);
      CONTRACT_CHECK(std::abs(indirect.Get(20, 20, k) - product) <= 1e-3 * product + 1e-9,
        c.Name << ": indirect " << indirect.Get(20, 20, k) << ", albedo times E " << product);
    }
    CONTRACT_CHECK((irradiance.Get(20, 20, 0) > 0.01f) != unlit,
      c.Name << ": irradiance " << irradiance.Get(20, 20, 0));
  }
}

//------------------------------------------------------------------------------
namespace
{
// The point of a pixel's ray: eye + depth * ray, depth along the view axis.
void GetRay(View& view, int x, int y, double eye[3], double ray[3])
{
  vtkCamera* camera = view.Renderer->GetActiveCamera();
  const int* size = view.Window->GetActualSize();
  double forward[3];
  double up[3];
  double right[3];
  camera->GetDirectionOfProjection(forward);
  camera->GetViewUp(up);
  vtkMath::Cross(forward, up, right);
  vtkMath::Normalize(right);
  vtkMath::Cross(right, forward, up);
  camera->GetPosition(eye);
  const double u = (2.0 * (x + 0.5) / size[0] - 1.0) * size[0] / size[1];
  const double v = 2.0 * (y + 0.5) / size[1] - 1.0;
  const bool parallel = camera->GetParallelProjection() != 0;
  const double half = parallel
    ? camera->GetParallelScale()
    : std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
  for (int k = 0; k < 3; ++k)
  {
    const double across = half * (u * right[k] + v * up[k]);
    ray[k] = forward[k] + (parallel ? 0.0 : across);
    eye[k] += parallel ? across : 0.0;
  }
}

// Checks the buffers of an ellipsoid (a unit sphere that an actor scales, turns and moves) and a
// plane.
void CheckSurfaces(bool parallel, double scale, const Vec3& shift)
{
  View view(120, 90);
  vtkRenderer* renderer = view.Renderer;
  auto sphere = MakeSphere({ 0, 0, 0 }, 1.0, { 0.6, 0.6, 0.6 }, 400);
  sphere->SetScale(0.5 * scale, 1.0 * scale, 0.25 * scale);
  sphere->RotateZ(30);
  sphere->SetPosition(shift[0], shift[1], shift[2]);
  renderer->AddActor(sphere);
  auto plane = MakeQuad({ -2, -1.2, -2 }, { -2, -1.2, 2 }, { 2, -1.2, -2 });
  plane->SetScale(scale);
  plane->SetPosition(shift[0], shift[1], shift[2]);
  renderer->AddActor(plane);
  auto light = MakeLight(LightKind::Directional, { 1, 2, 2 }, { 0, 0, 0 });
  renderer->AddLight(light);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(shift[0] + scale, shift[1] + 0.8 * scale, shift[2] + 4 * scale);
  camera->SetFocalPoint(shift[0], shift[1] - 0.2 * scale, shift[2]);
  camera->SetViewAngle(35);
  camera->SetParallelProjection(parallel);
  camera->SetParallelScale(1.6 * scale);
  renderer->ResetCameraClippingRange();
  vtkNew<vtkIndirectIlluminationPass> pass;
  renderer->SetPass(pass);
  view.Grab();
  const Floats depth = Read(pass, "depth");
  const Floats normal = Read(pass, "normal");
  const Floats direct = Read(pass, "direct");

  // World to the unit sphere: undo shift, turn, scale.
  const double angle = vtkMath::RadiansFromDegrees(30.0);
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const double scales[3] = { 0.5 * scale, scale, 0.25 * scale };
  auto toUnit = [&](const double v[3], double out[3])
  {
    out[0] = (cosine * v[0] + sine * v[1]) / scales[0];
    out[1] = (-sine * v[0] + cosine * v[1]) / scales[1];
    out[2] = v[2] / scales[2];
  };
  size_t counts[2] = { 0, 0 };
  double worstDepth[2] = { 0, 0 };
  double worstAngle[2] = { 0, 0 };
  for (int y = 0; y < depth.Height; ++y)
  {
    for (int x = 0; x < depth.Width; ++x)
    {
      double eye[3];
      double ray[3];
      GetRay(view, x, y, eye, ray);
      double local[3];
      for (int k = 0; k < 3; ++k)
      {
        local[k] = eye[k] - shift[k];
      }
      double o[3];
      double d[3];
      toUnit(local, o);
      toUnit(ray, d);
      const double a = vtkMath::Dot(d, d);
      const double b = vtkMath::Dot(o, d);
      const double discriminant = b * b - a * (vtkMath::Dot(o, o) - 1.0);
      double expectedDepth;
      double expected[3] = { 0, 1, 0 };
      int which;
      // Near the silhouette a facet or half a pixel decide.
      if (std::abs(discriminant) < 0.06 * a)
      {
        continue;
      }
      if (discriminant > 0.0)
      {
        which = 0;
        expectedDepth = (-b - std::sqrt(discriminant)) / a;
        double n[3];
        for (int k = 0; k < 3; ++k)
        {
          n[k] = (o[k] + expectedDepth * d[k]) / scales[k];
        }
        expected[0] = cosine * n[0] - sine * n[1];
        expected[1] = sine * n[0] + cosine * n[1];
        expected[2] = n[2];
        vtkMath::Normalize(expected);
      }
      else
      {
        which = 1;
        expectedDepth = (-1.2 * scale - local[1]) / ray[1];
        const double px = (local[0] + expectedDepth * ray[0]) / scale;
        const double pz = (local[2] + expectedDepth * ray[2]) / scale;
        if (!(expectedDepth > 0.0) || std::max(std::abs(px), std::abs(pz)) > 1.9)
        {
          continue;
        }
      }
      ++counts[which];
      double found[3] = { normal.Get(x, y, 0), normal.Get(x, y, 1), normal.Get(x, y, 2) };
      const double length = vtkMath::Norm(found);
      CONTRACT_CHECK(std::abs(length - 1.0) < 1e-4, "length of a normal " << length);
      worstAngle[which] = std::max(worstAngle[which],
        vtkMath::DegreesFromRadians(vtkMath::AngleBetweenVectors(found, expected)));
      worstDepth[which] =
        std::max(worstDepth[which], std::abs(depth.Get(x, y, 0) - expectedDepth) / (4.0 * scale));
    }
  }
  std::cout << (parallel ? "parallel" : "perspective") << ", scale " << scale << ": sphere "
            << counts[0] << " pixels, depth off by " << worstDepth[0] << ", normal by "
            << worstAngle[0] << " degrees; plane " << counts[1] << ", " << worstDepth[1] << ", "
            << worstAngle[1] << "\n";
  CONTRACT_CHECK(counts[0] > 300 && counts[1] > 300, "nothing to see");
  // Facets of 1/400 of a turn lie up to 1 - cos(pi/400) = 3e-5 inside the sphere; the view, which
  // is four deep, shows less. Normals are interpolated over 0.9 degrees, with an error of the
  // second order.
  CONTRACT_CHECK(worstDepth[0] < 3e-5 && worstDepth[1] < 2e-6, "depth");
  CONTRACT_CHECK(worstAngle[0] < 0.1 && worstAngle[1] < 0.001, "normal");
}
}

VTK_INDIRECT_TEST(SurfaceBuffers)
{
  CheckSurfaces(false, 1.0, { 0, 0, 0 });
  CheckSurfaces(true, 1.0, { 0, 0, 0 });
  CheckSurfaces(false, 1e-6, { 0, 0, 0 });
  CheckSurfaces(false, 1e5, { 3e5, -1e5, 2e5 });
}
