// SPDX-License-Identifier: BSD-3-Clause
// Directions that represent parts of the sky, and the irradiance of an open sky, against integrals.
#include "Emitters/vtkIndirectEmitterAccess.h"
#include "Emitters/vtkIndirectSkyProjection.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "Sky/vtkIndirectSkyDirections.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <functional>

using namespace vtkIndirectTest;

namespace
{
// Makes a sky whose radiance depends on the direction's height.
void MakeImage(vtkImageData* image, const std::function<double(double)>& radiance)
{
  const int columns = 512;
  const int rows = 256;
  image->SetDimensions(columns, rows, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* p = static_cast<float*>(image->GetScalarPointer());
  for (int j = 0; j < rows; ++j)
  {
    const double height = std::sin(vtkMath::Pi() * ((j + 0.5) / rows - 0.5));
    std::fill(p + 3 * j * columns, p + 3 * (j + 1) * columns, static_cast<float>(radiance(height)));
  }
}

glm::dvec3 SumOf(const std::vector<vtkIndirectSkyDirections::Summand>& summands)
{
  glm::dvec3 sum(0.0);
  for (const auto& summand : summands)
  {
    sum += summand.Light;
  }
  return sum;
}

glm::dvec3 SumOf(vtkEnvironmentLight* environment)
{
  glm::dvec3 sum(0.0);
  for (const vtkIndirectEmitterAccess::Cell& cell : vtkIndirectEmitterAccess::GetCells(environment))
  {
    sum += glm::dvec3(cell.Light[0], cell.Light[1], cell.Light[2]);
  }
  return sum;
}

// Bilinear look-up of a texel table, as textures do it.
double LookUp(const vtkIndirectSkyDirections::OpenSky& sky, const glm::dvec3& normal, int channel)
{
  const std::vector<float>& texels = sky.Texels;
  using namespace vtkIndirectKernels;
  const vec2 place = vtkiOpenSkyPlace(vec3(normal));
  const double x = place.x * VTKI_OPEN_SKY_TEXELS - 0.5;
  const double y = place.y * VTKI_OPEN_SKY_TEXELS - 0.5;
  const int i = std::clamp(static_cast<int>(x), 0, VTKI_OPEN_SKY_TEXELS - 2);
  const int j = std::clamp(static_cast<int>(y), 0, VTKI_OPEN_SKY_TEXELS - 2);
  auto get = [&](int a, int b)
  { return texels[4 * static_cast<size_t>(b * VTKI_OPEN_SKY_TEXELS + a) + channel]; };
  return glm::dot(glm::dvec3(channel == 0 ? sky.Flux : sky.SummedFlux), normal) +
    glm::mix(glm::mix(get(i, j), get(i + 1, j), static_cast<float>(x - i)),
      glm::mix(get(i, j + 1), get(i + 1, j + 1), static_cast<float>(x - i)),
      static_cast<float>(y - j));
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(SkyLosesNothing)
{
  vtkNew<vtkImageData> image;
  MakeImage(image, [](double height) { return height > 0.0 ? 1.0 + height : 0.1; });
  auto* sun = static_cast<float*>(image->GetScalarPointer(100, 200, 0));
  sun[0] = 4e4f;
  sun[1] = 3e4f;
  sun[2] = 2e4f;
  vtkNew<vtkEnvironmentLight> environment;
  environment->SetImage(image);
  const glm::dvec3 total = SumOf(environment);
  vtkIndirectSkyProjection projection;
  vtkIndirectSkyDirections sky;
  Check("the first is another", sky.Update(projection, environment, 64, 256));
  Check("the second is not", !sky.Update(projection, environment, 64, 256));
  const auto strong = sky.GetStrong();
  CheckEqual("directions of the sun", static_cast<double>(strong.size()), 1);
  const int counts[][2] = { { 16, 16 }, { 16, 64 }, { 64, 64 }, { 64, 256 }, { 256, 256 } };
  for (const auto& count : counts)
  {
    Check("another number", sky.Update(projection, environment, count[0], count[1]));
    const std::string name = std::to_string(count[0]) + " of " + std::to_string(count[1]);
    const glm::dvec3 sum = SumOf(sky.GetStrong()) + SumOf(sky.GetOthers());
    for (int c = 0; c < 3; ++c)
    {
      CheckRelative(name + ": all of the light", sum[c], total[c], 1e-12, "rounding of a sum");
    }
    Check(name + ": the sun is the same",
      sky.GetStrong().size() == 1 && sky.GetStrong()[0].Number == strong[0].Number &&
        sky.GetStrong()[0].Light == strong[0].Light);
    Check(name + ": no others but these",
      std::all_of(sky.GetOthers().begin(), sky.GetOthers().end(),
        [&](const auto& other) { return other.Number < static_cast<size_t>(count[0]); }));
  }
  // Half a sky is no sun, in any number of directions.
  MakeImage(image, [](double height) { return height > 0.0 ? 1.0 : 0.0; });
  image->Modified();
  for (const int count : { 16, 64, 256, 1024 })
  {
    Check("a changed image", sky.Update(projection, environment, count, count));
    CheckEqual("strong directions of half a sky", static_cast<double>(sky.GetStrong().size()), 0);
  }
}

//------------------------------------------------------------------------------
// A bright window of 23 x 23 degrees has a quarter of the light: each of the usual directions in
// the window has more than a 32nd, and is too wide for one sharp shadow.
VTK_INDIRECT_TEST(SkyHasMoreDirectionsWhereStrongLightIsWide)
{
  vtkNew<vtkImageData> image;
  MakeImage(image, [](double) { return 1.0; });
  for (int j = 112; j < 144; ++j)
  {
    for (int i = 96; i < 128; ++i)
    {
      auto* const window = static_cast<float*>(image->GetScalarPointer(i, j, 0));
      std::fill(window, window + 3, 27.0f);
    }
  }
  vtkNew<vtkEnvironmentLight> environment;
  environment->SetImage(image);
  const glm::dvec3 total = SumOf(environment);
  vtkIndirectSkyProjection projection;
  vtkIndirectSkyDirections sky;
  size_t added[2];
  const int counts[][2] = { { 16, 64 }, { 64, 256 } };
  for (int i = 0; i < 2; ++i)
  {
    sky.Update(projection, environment, counts[i][0], counts[i][1]);
    const std::string name = std::to_string(counts[i][0]);
    CheckEqual(name + ": strong", static_cast<double>(sky.GetStrong().size()), 0);
    CheckRelative(
      name + ": all of the light", SumOf(sky.GetOthers()).x, total.x, 1e-12, "rounding of a sum");
    added[i] = sky.GetLattice().size() - static_cast<size_t>(counts[i][1]);
    Check(name + ": several were added", added[i] >= 8);
  }
  CheckEqual(
    "both frames have the same", static_cast<double>(added[0]), static_cast<double>(added[1]));
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(SkyOpen)
{
  struct Case
  {
    const char* Name;
    std::function<double(double)> Radiance;
    std::function<double(double)> Irradiance; // by the height of the normal
  };
  const Case cases[] = {
    { "uniform", [](double) { return 1.0; }, [](double) { return 1.0; } },
    // Band 1 of spherical harmonics is weakened to two thirds.
    { "brighter above", [](double h) { return 1.0 + h; },
      [](double y) { return 1.0 + y * 2.0 / 3.0; } },
    { "half", [](double h) { return h > 0.0 ? 1.0 : 0.0; },
      [](double y) { return 0.5 + 0.5 * y; } },
  };
  Random random(5);
  for (const Case& one : cases)
  {
    vtkNew<vtkImageData> image;
    MakeImage(image, one.Radiance);
    vtkNew<vtkEnvironmentLight> environment;
    environment->SetImage(image);
    vtkIndirectSkyProjection projection;
    vtkIndirectSkyDirections sky;
    sky.Update(projection, environment, 64, 256);
    const vtkIndirectSkyDirections::OpenSky open = sky.MakeOpenSky(sky.GetOthers());
    double worst = 0.0;
    double worstOfSummed = 0.0;
    for (int i = 0; i < 4000; ++i)
    {
      const glm::dvec3 n = random.NextDirection();
      const double expected = one.Irradiance(n.y);
      worst = std::max(worst, std::abs(LookUp(open, n, 0) * sky.GetUnit() / 3.0 - expected));
      worstOfSummed =
        std::max(worstOfSummed, std::abs(LookUp(open, n, 1) * sky.GetUnit() / 3.0 - expected));
    }
    CheckAtMost(std::string(one.Name) + ": irradiance of an open sky", worst, 0.003,
      "interpolation 0.0013, pieces 0.0003, cells 0.0005");
    CheckAtMost(
      std::string(one.Name) + ": by 64 directions", worstOfSummed, 0.1, "cells of 14 degrees");
  }
}
