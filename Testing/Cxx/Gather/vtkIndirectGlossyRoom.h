// SPDX-License-Identifier: BSD-3-Clause
// The scene of the tests of specular indirect light.
#ifndef vtkIndirectGlossyRoom_h
#define vtkIndirectGlossyRoom_h

#include "vtkIndirectTestUtilities.h"

#include "vtkActor.h"               // for members
#include "vtkProperty.h"            // for members
#include "vtkRSMGatherPass.h"       // for members
#include "vtkUniformLightSampler.h" // for members

#include <algorithm> // for differences
#include <cmath>     // for differences

namespace vtkIndirectTest
{
// A matt red wall, lit, beside a floor and a ball that are specular.
struct GlossyRoom : Scene
{
  GlossyRoom(int width, int height, double specular, double power)
    : Scene(width, height)
  {
    this->Wall =
      this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.9, 0.3, 0.2 }); // faces +x
    this->Floor = this->AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.4, 0.5, 0.6 });
    this->Ball = this->AddSphere({ 0.55, 0.5, 0.25 }, 0.2, 48, { 0.5, 0.5, 0.3 });
    for (vtkActor* actor : { this->Floor, this->Ball })
    {
      actor->GetProperty()->SetSpecular(specular);
      actor->GetProperty()->SetSpecularPower(power);
      actor->GetProperty()->SetSpecularColor(1.0, 0.75, 0.5);
    }
    this->AddSpot({ 1.2, 0.4, 1.1 }, { 0.0, 0.5, 0.5 }, 30, 1, { 0.3, 0.2, 1 });
    this->SetEye({ 1.9, 0.2, 0.9 }, { 0.4, 0.5, 0.2 }, { 0, 0, 1 }, 34, 0.1, 6);
    this->Gather->SetModeToVirtualLights();
    this->Gather->InterpolationOff();
    this->Sampler->SetNumberOfLights(96);
    this->Pass->SetReflectiveShadowMapResolution(64);
  }

  vtkActor* Wall;
  vtkActor* Floor;
  vtkActor* Ball;
};

inline double Largest(const Image& image)
{
  return *std::max_element(image.Values.begin(), image.Values.end());
}

/** Largest difference of two values, infinite for images of different sizes. */
inline double Difference(const Image& a, const Image& b)
{
  double worst = a.Values.size() == b.Values.size() ? 0.0 : 1e30;
  for (size_t i = 0; i < std::min(a.Values.size(), b.Values.size()); ++i)
  {
    const double d = std::abs(static_cast<double>(a.Values[i]) - b.Values[i]);
    // Also where it is no number.
    worst = d <= worst ? worst : d;
  }
  return worst;
}
}

#endif
