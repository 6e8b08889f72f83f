// SPDX-License-Identifier: BSD-3-Clause
// Scenes of the tests of radiance hints.
#ifndef vtkIndirectHintScenes_h
#define vtkIndirectHintScenes_h

#include "RadianceHints/vtkIndirectHintSum.h" // for hints
#include "vtkIndirectTestUtilities.h"

#include "vtkRadianceHintsPass.h"

namespace vtkIndirectTest
{
struct HintScene : Scene
{
  vtkNew<vtkRadianceHintsPass> Hints;

  HintScene(int width, int height)
    : Scene(width, height)
  {
    this->Pass->SetEstimator(this->Hints);
    this->Pass->SetVisibilityToAuto();
  }
  ~HintScene() { this->Pass->SetEstimator(nullptr); }

  void SetGrid(int n) { this->Hints->SetGridResolution(n, n, n); }
  std::vector<vtkIndirectHintSum::Hint> ReadHints()
  {
    return static_cast<vtkIndirectHintSum&>(vtkIndirectSum::Get(this->Hints)).ReadHints();
  }
};

// Two rooms along x with a thin wall between them, the first lit by a light. The wall may have a
// door.
struct TwoRooms : HintScene
{
  explicit TwoRooms(bool open, int width = 96, int height = 48)
    : HintScene(width, height)
  {
    const glm::dvec3 white(0.8);
    // The faces point inwards.
    this->AddQuad({ 0, 0, 0 }, { 4, 0, 0 }, { 0, 2, 0 }, white); // floor
    this->AddQuad({ 0, 0, 2 }, { 0, 2, 2 }, { 4, 0, 2 }, white); // ceiling
    this->AddQuad({ 0, 0, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, white); // x = 0
    this->AddQuad({ 4, 0, 0 }, { 4, 0, 2 }, { 4, 2, 0 }, white); // x = 4
    this->AddQuad({ 0, 2, 0 }, { 4, 2, 0 }, { 0, 2, 2 }, white); // y = 2
    this->AddQuad({ 0, 0, 0 }, { 0, 0, 2 }, { 4, 0, 0 }, white); // y = 0, behind the eye
    const double x = 2.02;
    const double gap = open ? 0.7 : 0.0;
    this->AddQuad({ x, gap, 0 }, { x, 2, 0 }, { x, gap, 2 }, white);
    if (open)
    {
      this->AddQuad({ x, 0, 1.4 }, { x, 0.7, 1.4 }, { x, 0, 2 }, white);
    }
    this->AddPoint({ 1.0, 1.0, 1.7 }, { 0.0, 0.0, 1.0 });
    this->Pass->SetReflectiveShadowMapResolution(128);
    // Parallel, from the front through the near wall.
    this->SetEye({ 2.0, -5.0, 1.0 }, { 2.0, 1.0, 1.0 }, { 0, 0, 1 }, 30.0, 5.02, 7.5);
    this->SetParallelEye(1.0);
  }

  // Light of the dark room's receivers over that of all, seen through the near wall, which the near
  // plane removes.
  double GetLeak(double& dark)
  {
    this->Render();
    const Image image = this->Copy("irradiance");
    const std::vector<Receiver> receivers = this->GetReceivers();
    double total = 0.0;
    dark = 0.0;
    for (size_t i = 0; i < receivers.size(); ++i)
    {
      if (receivers[i].Lit)
      {
        const double e = image.Values[image.Components * i];
        total += e;
        dark += receivers[i].Position.x > 2.02 + 1e-3 ? e : 0.0;
      }
    }
    return dark / total;
  }
};

/** Number of values that two images share. */
inline int CountSame(const Image& a, const Image& b)
{
  int same = 0;
  for (size_t i = 0; i < a.Values.size(); ++i)
  {
    same += a.Values[i] == b.Values[i];
  }
  return same;
}
}

#endif
