// SPDX-License-Identifier: BSD-3-Clause
// The packed surface: normals, kinds, positions from linear depth.
#include "OpenGL/vtkIndirectKernels.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderState.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
// Random, axes, diagonals, planes of the octahedron's edges, and all of these slightly off.
std::vector<glm::dvec3> Directions()
{
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < 27; ++i)
  {
    const glm::dvec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (glm::length(d) > 0.0)
    {
      for (double off : { 0.0, 1e-9, 1e-7, 1e-5, -1e-6 })
      {
        directions.push_back(glm::normalize(d + off * glm::dvec3(1.0, -2.0, 3.0)));
      }
    }
  }
  Random random(1);
  for (int i = 0; i < 400000; ++i)
  {
    directions.push_back(random.NextDirection());
  }
  return directions;
}

double RoundTrip(const glm::dvec3& n)
{
  const vec3 decoded = vtkiOctahedralDecode(vtkiOctahedralEncode(vec3(n)));
  return glm::length(glm::dvec3(decoded) - n);
}
}

VTK_INDIRECT_TEST(OctahedralRoundTrip)
{
  double worst = 0.0;
  double longest = 0.0;
  for (const glm::dvec3& n : Directions())
  {
    worst = std::max(worst, RoundTrip(n));
    const vec2 p = vtkiOctahedralEncode(vec3(n));
    longest = std::max(longest, static_cast<double>(std::max(std::abs(p.x), std::abs(p.y))));
  }
  // Five roundings of half a step of floats near one, 6e-8, through the decoder's gain of 2.5 at
  // most.
  CheckAtMost("worst distance between a direction and its decoded code", worst, 4e-7, "rounding");
  CheckAtMost("largest coordinate", longest, 1.0, "definition");
  const vec3 zero = vtkiOctahedralDecode(vtkiOctahedralEncode(vec3(0.0f)));
  Check("a zero vector decodes as +z", zero == vec3(0.0f, 0.0f, 1.0f));
  double unit = 0.0;
  Random random(2);
  for (int i = 0; i < 100000; ++i)
  {
    const vec2 p(random.Next(-1.0, 1.0), random.Next(-1.0, 1.0));
    unit = std::max(unit, std::abs(glm::length(glm::dvec3(vtkiOctahedralDecode(p))) - 1.0));
  }
  CheckAtMost("deviation of any decoded vector from length one", unit, 2e-7, "rounding");
}

VTK_INDIRECT_TEST(PackSurface)
{
  Random random(3);
  const float kinds[] = { VTKI_SURFACE_LINEAR, VTKI_SURFACE_ENCODED, VTKI_SURFACE_UNLIT };
  double worst = 0.0;
  int wrong = 0;
  int numbers = 0;
  for (const glm::dvec3& n : Directions())
  {
    const float depth = static_cast<float>(random.NextMagnitude(1e-18, 1e18));
    for (float kind : kinds)
    {
      const vec4 packed = vtkiPackSurface(vec3(n), vec3(-n.y, n.z, n.x), depth, kind);
      wrong +=
        vtkiSurfaceKind(packed) != kind || vtkiSurfaceDepth(packed) != depth || packed.w != 1.0f;
      numbers += !std::isnormal(packed.y) + !std::isnormal(packed.z);
      wrong +=
        vtkiSurfaceIsLit(packed) != (kind == VTKI_SURFACE_LINEAR || kind == VTKI_SURFACE_ENCODED);
      worst = std::max(worst, glm::length(glm::dvec3(vtkiSurfaceNormal(packed)) - n));
      worst = std::max(
        worst, glm::length(glm::dvec3(vtkiSurfaceFacet(packed)) - glm::dvec3(-n.y, n.z, n.x)));
    }
  }
  CheckEqual("wrong kinds, depths or alphas", wrong, 0);
  CheckEqual("codes that are no normal numbers", numbers, 0);
  // Half a step of each coordinate; the fold gives the third coordinate the error of both, at a
  // vector length of one over root three.
  CheckAtMost("worst error of a packed normal", worst,
    3.0 * glm::length(glm::dvec2(0.5 / VTKI_CODE_STEPS_X, 0.5 / VTKI_CODE_STEPS_Y)), "half a step");
  for (const vec3& axis : { vec3(1.0f, 0.0f, 0.0f), vec3(0.0f, -1.0f, 0.0f), vec3(0.0f, 0.0f, 1.0f),
         vec3(0.0f, 0.0f, -1.0f) })
  {
    Check("a normal along an axis is exact",
      vtkiSurfaceNormal(vtkiPackSurface(axis, axis, 1.0f, VTKI_SURFACE_LINEAR)) == axis);
  }
  CheckEqual("kind of a cleared texel", vtkiSurfaceKind(vec4(0.0f)), VTKI_SURFACE_NONE);
  Check("a cleared texel is not lit", !vtkiSurfaceIsLit(vec4(0.0f)));
}

VTK_INDIRECT_TEST(PackAlbedo)
{
  Random random(4);
  double worst = 0.0;
  int numbers = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const glm::dvec3 albedo(random.Next(), random.NextMagnitude(1e-6, 1.0), random.Next());
    const float code = vtkiPackAlbedo(vec3(albedo));
    numbers += std::isnormal(code);
    const glm::dvec3 read(vtkiUnpackAlbedo(code));
    for (int k = 0; k < 3; ++k)
    {
      worst = std::max(worst, std::abs(std::sqrt(read[k]) - std::sqrt(albedo[k])));
    }
  }
  CheckAtMost("worst error of a root", worst, 0.5 / 1023.0 + 1e-6, "half a step and rounding");
  CheckEqual("codes that are normal numbers", numbers, 100000);
  // Values of real scenes, and values out of range.
  CheckEqual("black", glm::length(vtkiUnpackAlbedo(vtkiPackAlbedo(vec3(0.0f)))), 0.0f);
  Check("white", vtkiUnpackAlbedo(vtkiPackAlbedo(vec3(1.0f))) == vec3(1.0f));
  Check("more than white", vtkiUnpackAlbedo(vtkiPackAlbedo(vec3(2.0f))) == vec3(1.0f));
  Check("less than black", vtkiUnpackAlbedo(vtkiPackAlbedo(vec3(-1.0f))) == vec3(0.0f));
  Check("a cleared texel is black", vtkiUnpackAlbedo(0.0f) == vec3(0.0f));
}

namespace
{
// Positions through the frame's rays in float against the inverse projection in double.
void CheckRays(const char* what, vtkCamera* camera, double size, const glm::dvec3& center)
{
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  window->SetSize(320, 200);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  renderer->SetActiveCamera(camera);
  vtkNew<vtkLight> light;
  renderer->AddLight(light);
  vtkNew<vtkSphereSource> sphere;
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->SetRadius(0.5 * size);
  sphere->SetCenter(center.x, center.y, center.z);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);

  vtkRenderState state(renderer);
  vtkIndirectFrame frame;
  frame.Build(&state);
  if (!Check(std::string(what) + " builds a frame", !frame.Casters.empty()))
  {
    return;
  }
  const glm::dmat4 projection =
    vtkIndirectFrame::ToGLM(camera->GetProjectionTransformMatrix(1.6, -1, 1));
  const glm::dmat4 inverse = glm::inverse(projection);
  double worst = 0.0;
  double viewToScene = 0.0;
  Random random(4);
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec2 ndc(random.Next(-1.0, 1.0), random.Next(-1.0, 1.0));
    const glm::dvec4 clip(ndc, random.Next(-1.0, 1.0), 1.0);
    glm::dvec4 view = inverse * clip;
    view /= view.w;
    const glm::dvec3 expected = glm::dvec3(view) * frame.SceneScale;
    const vec3 p = vtkiReconstruct(
      vec2(ndc), static_cast<float>(-expected.z), mat3(frame.RayOrigin), mat3(frame.RayDirection));
    worst = std::max(worst, glm::length(glm::dvec3(p) - expected) / glm::length(expected));
    const glm::dvec3 scene = glm::dvec3(frame.ViewToScene * glm::dvec4(expected, 1.0));
    const glm::dvec3 world = glm::dvec3(glm::inverse(frame.WorldToView) * view);
    viewToScene =
      std::max(viewToScene, glm::length(scene - (world - frame.SceneCenter) * frame.SceneScale));
  }
  // Four products and sums of floats, and the rounding of the matrices and of the coordinates.
  CheckAtMost(std::string(what) + ": worst relative error of a position", worst, 1e-6, "rounding");
  // Double precision of world coordinates: 1e5 sizes away, steps of 1e-11 sizes, a few of them.
  CheckAtMost(std::string(what) + ": view to scene against world to scene", viewToScene, 1e-9,
    "steps of double precision at 1e5 sizes");
}
}

VTK_INDIRECT_TEST(Reconstruct)
{
  for (double size : { 1e-3, 1.0, 1e3 })
  {
    for (double away : { 0.0, 1e5 })
    {
      const glm::dvec3 center = glm::dvec3(0.3, -0.2, 0.7) * (away * size);
      vtkNew<vtkCamera> camera;
      auto aim = [&](vtkCamera* c)
      {
        c->SetPosition(center.x + 2 * size, center.y + 1.5 * size, center.z + 1.1 * size);
        c->SetFocalPoint(center.x, center.y, center.z);
        c->SetClippingRange(0.5 * size, 5 * size);
      };
      aim(camera);
      CheckRays("perspective", camera, size, center);
      camera->SetWindowCenter(0.4, -0.7);
      CheckRays("off-centre perspective", camera, size, center);
      vtkNew<vtkCamera> parallel;
      aim(parallel);
      parallel->ParallelProjectionOn();
      parallel->SetParallelScale(0.8 * size);
      CheckRays("parallel", parallel, size, center);
      parallel->SetWindowCenter(-0.3, 0.2);
      CheckRays("off-centre parallel", parallel, size, center);
      parallel->SetWindowCenter(0.0, 0.0);
      parallel->SetViewShear(0.3, 0.2, 1.0);
      CheckRays("sheared parallel", parallel, size, center);
    }
  }
}
