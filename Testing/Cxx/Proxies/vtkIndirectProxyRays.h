// SPDX-License-Identifier: BSD-3-Clause
// A ground and spheres over it in a window, and rays that meet both in double precision.
#ifndef vtkIndirectProxyRays_h
#define vtkIndirectProxyRays_h

#include "vtkIndirectBalls.h"
#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"
#include "vtkDoubleArray.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkProxyAccumulationPass.h"

#include <algorithm>
#include <cmath>

namespace vtkIndirectTest
{
const glm::dvec3 White(0.8);

// A ground at y = 0, seen from above, and spheres over it, from points.
struct ProxyScene : Scene
{
  vtkNew<vtkProxyAccumulationPass> Proxies;
  vtkNew<vtkEnvironmentLight> Sky;
  vtkNew<vtkPolyData> Points;
  vtkSmartPointer<vtkActor> Atoms;

  explicit ProxyScene(double scale = 1.0, int size = 72)
    : Scene(size, size)
  {
    auto at = [scale](double x, double y, double z) { return scale * glm::dvec3(x, y, z); };
    this->AddQuad(at(-3, 0, 3), at(3, 0, 3), at(-3, 0, -3), White);
    this->SetEye(at(0, 9, 5), at(0, 0, 0), { 0, 1, 0 }, 38, scale, 30 * scale);
    this->Proxies->SetReceiverStep(1);
    this->Pass->SetEstimator(this->Proxies);
    this->Pass->SetEnvironment(this->Sky);
    this->Pass->SetVisibilityToAuto();
    vtkNew<vtkOpenGLSphereMapper> mapper;
    mapper->SetInputData(this->Points);
    mapper->SetScaleArray("size");
    this->Atoms = vtkSmartPointer<vtkActor>::New();
    this->Atoms->SetMapper(mapper);
    this->Atoms->GetProperty()->SetColor(1.0, 1.0, 1.0);
    this->Renderer->AddActor(this->Atoms);
  }
  ~ProxyScene() { this->Pass->SetEnvironment(nullptr); }

  void SetBalls(const std::vector<Ball>& balls) { vtkIndirectTest::SetBalls(this->Points, balls); }
};

// True on the ground, false on top of a sphere.
inline bool OnGround(const Scene::Receiver& r)
{
  return r.Normal.y > 0.99 && std::abs(r.Position.y) < 1e-3 * glm::length(r.Position);
}

// Share of the cosine-weighted upper half space that spheres leave visible, by rays.
inline double Open(const std::vector<Ball>& balls, const glm::dvec3& p)
{
  constexpr int count = 1500;
  int open = 0;
  for (int i = 0; i < count; ++i)
  {
    const double e = (i + 0.5) / count;
    const double turn = 2.399963229728653 * i;
    const double s = std::sqrt(e);
    const glm::dvec3 d(s * std::cos(turn), std::sqrt(1.0 - e), s * std::sin(turn));
    const bool hit = std::any_of(balls.begin(), balls.end(),
      [&](const Ball& ball)
      {
        const glm::dvec3 c = ball.Center - p;
        const double along = glm::dot(c, d);
        return along > 0.0 && glm::dot(c, c) - along * along < ball.Radius * ball.Radius;
      });
    open += hit ? 0 : 1;
  }
  return static_cast<double>(open) / count;
}

// End of a ray: at one of the balls or on the ground of half width 3, if they face the normal.
struct Hit
{
  bool Any = false;
  bool OnGround = false;
  glm::dvec3 Place;
  glm::dvec3 Normal;
};

inline Hit Trace(const std::vector<Ball>& balls, const glm::dvec3& p, const glm::dvec3& d)
{
  Hit hit;
  double nearest = 1e300;
  for (const Ball& ball : balls)
  {
    const glm::dvec3 c = ball.Center - p;
    const double along = glm::dot(c, d);
    const double room = along * along - glm::dot(c, c) + ball.Radius * ball.Radius;
    const double t = along - std::sqrt(std::max(room, 0.0));
    if (room > 0.0 && t > 0.0 && t < nearest)
    {
      nearest = t;
      hit = { true, false, p + t * d, (t * d - c) / ball.Radius };
    }
  }
  const double t = -p.y / d.y;
  const glm::dvec3 at = p + t * d;
  if (t > 0.0 && t < nearest && std::abs(at.x) < 3.0 && std::abs(at.z) < 3.0)
  {
    hit = { true, true, at, glm::dvec3(0.0, d.y < 0.0 ? 1.0 : -1.0, 0.0) };
  }
  return hit;
}

// Cosine-distributed directions about a normal.
inline std::vector<glm::dvec3> AboutNormal(const glm::dvec3& n, int count, double turn)
{
  const glm::dvec3 x =
    glm::normalize(glm::cross(n, std::abs(n.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
  const glm::dvec3 y = glm::cross(n, x);
  std::vector<glm::dvec3> ways;
  for (int i = 0; i < count; ++i)
  {
    const double e = (i + 0.5) / count;
    const double phi = turn + 2.399963229728653 * i;
    ways.push_back(std::sqrt(e) * (std::cos(phi) * x + std::sin(phi) * y) + std::sqrt(1.0 - e) * n);
  }
  return ways;
}

// Light of a uniform sky that white balls and the ground reflect to a position.
inline double Bounce(
  const std::vector<Ball>& balls, const glm::dvec3& p, const glm::dvec3& n, double ground)
{
  constexpr int seen = 64;
  constexpr int open = 48;
  constexpr double lift = 1e-4;
  double sum = 0.0;
  double turn = 0.0;
  for (const glm::dvec3& way : AboutNormal(n, seen, 0.0))
  {
    const Hit hit = Trace(balls, p + lift * n, way);
    turn += 1.0;
    if (hit.Any)
    {
      for (const glm::dvec3& on : AboutNormal(hit.Normal, open, turn))
      {
        sum += Trace(balls, hit.Place + lift * hit.Normal, on).Any ? 0.0
          : hit.OnGround                                           ? ground
                                                                   : 1.0;
      }
    }
  }
  return sum / (seen * open);
}
}

#endif
