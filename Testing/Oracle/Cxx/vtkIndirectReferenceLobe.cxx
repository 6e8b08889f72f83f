// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectReferenceLobe.h"

#include "OpenGL/vtkIndirectTarget.h"
#include "Senders/vtkIndirectSampler.h"
#include "Senders/vtkIndirectVirtualLights.h"

#include <algorithm>
#include <cmath>

namespace
{
// Returns the log of cos^2 of an angle from its sine, without loss of digits.
double LogOfRest(double sine)
{
  return std::log1p(-std::min(sine * sine, 1.0 - 1e-15));
}
}

//------------------------------------------------------------------------------
double vtkIndirectReferenceLobe::FindStrength(const glm::dvec3& toReceiver) const
{
  constexpr double pi = 3.14159265358979323846;
  const double r2 = glm::dot(toReceiver, toReceiver);
  const double r = std::sqrt(r2);
  if (!(r > 0.0) || glm::dot(this->Normal, toReceiver) <= 0.0 ||
    glm::dot(this->Direction, toReceiver) <= 0.0)
  {
    return 0.0;
  }
  // A lobe narrower than half the light is widened to that.
  const double reach = 0.5 * std::sqrt(this->Exponent * this->Area);
  const double exponent = reach > r ? this->Exponent * r2 / (reach * reach) : this->Exponent;
  const double sine = glm::length(glm::cross(this->Direction, toReceiver)) / r;
  const double height = std::max(glm::dot(this->Normal, this->Direction), 0.0);
  const double freedom = exponent + 1.0;
  const double z = (8.0 * freedom + 1.0) / (8.0 * freedom + 3.0) *
    std::sqrt(-freedom * LogOfRest(std::min(height, 1.0)));
  const double integral = 2.0 * pi / freedom * 0.5 * std::erfc(-z / std::sqrt(2.0));
  return std::exp(0.5 * exponent * LogOfRest(sine)) / integral /
    (r2 + this->Area / (pi * std::max(exponent, 1.0)));
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectReferenceLobe> vtkIndirectReferenceLobe::Read(
  const vtkIndirectVirtualLights& lights)
{
  std::vector<vtkIndirectReferenceLobe> senders;
  if (!lights.HasLobes())
  {
    return senders;
  }
  const size_t count = static_cast<size_t>(lights.GetNumberOfLights());
  const vtkIndirectTarget& table = lights.GetTable();
  const vtkIndirectTarget& lobes = *lights.GetLobes();
  const std::vector<float> position = table.ReadBack(vtkIndirectSampler::PositionArea);
  const std::vector<float> normal = table.ReadBack(vtkIndirectSampler::NormalChildDistance);
  const std::vector<float> direction = lobes.ReadBack(vtkIndirectSampler::LobeDirectionExponent);
  const std::vector<float> density = lobes.ReadBack(vtkIndirectSampler::LobeDensityArea);
  for (size_t i = 0; i < count; ++i)
  {
    const float* d = &density[4 * i];
    if (std::max({ d[0], d[1], d[2] }) > 0.0f)
    {
      const float* p = &position[4 * i];
      const float* n = &normal[4 * i];
      const float* w = &direction[4 * i];
      senders.push_back({ { p[0], p[1], p[2] }, glm::normalize(glm::dvec3(n[0], n[1], n[2])), p[3],
        glm::normalize(glm::dvec3(w[0], w[1], w[2])), w[3], { d[0], d[1], d[2] } });
    }
  }
  return senders;
}
