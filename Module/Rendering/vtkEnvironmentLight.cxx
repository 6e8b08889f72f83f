// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEnvironmentLight.h"

#include "Emitters/vtkIndirectRadianceImage.h"
#include "vtkImageData.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkEnvironmentLight);
vtkInformationKeyRestrictedMacro(
  vtkEnvironmentLight, ENVIRONMENT, ObjectBase, "vtkEnvironmentLight");

namespace
{
// Number of cells of the whole sky: 1.4 degrees across at the horizon.
constexpr int Columns = 256;
constexpr int Rows = 128;

// Makes a frame with these columns: right, up, and behind the middle of the image. Uses VTK's axes
// if Up has no length, and any right vector if Right is along Up.
glm::dmat3 MakeFrame(const double up[3], const double right[3])
{
  glm::dvec3 y(up[0], up[1], up[2]);
  const double length = glm::length(y);
  y = length > 0.0 && std::isfinite(length) ? y / length : glm::dvec3(0.0, 1.0, 0.0);
  glm::dvec3 x(right[0], right[1], right[2]);
  x -= glm::dot(x, y) * y;
  if (!(glm::length(x) > 1e-12 * std::max(1.0, std::abs(right[0]))))
  {
    const glm::dvec3 helper =
      std::abs(y.x) < 0.9 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
    x = helper - glm::dot(helper, y) * y;
  }
  x = glm::normalize(x);
  return { x, y, glm::cross(x, y) };
}

// Returns the direction of a place in an equirectangular image: longitude from the middle to the
// right, latitude.
glm::dvec3 ToDirection(double longitude, double latitude)
{
  const double c = std::cos(latitude);
  return { c * std::sin(longitude), std::sin(latitude), -c * std::cos(longitude) };
}
}

//------------------------------------------------------------------------------
vtkEnvironmentLight::vtkEnvironmentLight() = default;

vtkEnvironmentLight::~vtkEnvironmentLight() = default;

//------------------------------------------------------------------------------
void vtkEnvironmentLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto print = [&](const char* name, const double v[3])
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  print("Up", this->Up);
  print("Right", this->Right);
}

//------------------------------------------------------------------------------
void vtkEnvironmentLight::GetRadianceFrom(const double direction[3], double radiance[3])
{
  glm::dvec3 result(this->Radiance[0], this->Radiance[1], this->Radiance[2]);
  if (this->GetCells().empty())
  {
    // The image cannot be read, which an error has reported, or all of it is dark.
    std::fill(radiance, radiance + 3, 0.0);
    return;
  }
  if (vtkImageData* image = this->FindImage())
  {
    vtkIndirectRadianceImage pixels(image, this->IsEncoded());
    const glm::dvec3 d = glm::transpose(MakeFrame(this->Up, this->Right)) *
      glm::dvec3(direction[0], direction[1], direction[2]);
    const double u = 0.5 * std::atan2(d.x, -d.z) / vtkMath::Pi() + 0.5;
    const double v = std::atan2(d.y, std::hypot(d.x, d.z)) / vtkMath::Pi() + 0.5;
    result = pixels.Get(std::min(static_cast<int>(u * pixels.GetWidth()), pixels.GetWidth() - 1),
      std::min(static_cast<int>(v * pixels.GetHeight()), pixels.GetHeight() - 1));
  }
  for (int c = 0; c < 3; ++c)
  {
    radiance[c] = this->GetScale() * result[c];
  }
}

//------------------------------------------------------------------------------
const std::vector<vtkEnvironmentLight::Cell>& vtkEnvironmentLight::GetCells()
{
  vtkImageData* image = this->FindImage();
  const vtkMTimeType time = this->GetMTime();
  if (time == this->CellsTime)
  {
    return this->Cells;
  }
  this->CellsTime = time;
  this->Cells.clear();
  if (image && !vtkIndirectRadianceImage::CanRead(image))
  {
    vtkErrorMacro("The environment's image is not used: it must be of one slice, with a scalar "
                  "for each point. No light comes from it.");
    return this->Cells;
  }
  this->MakeCells();
  const bool bounded = std::all_of(this->Greatest, this->Greatest + 3,
    [](double radiance) { return radiance <= vtkIndirectRadianceImage::MostRadiance; });
  if (!bounded)
  {
    vtkErrorMacro("The environment's radiance is not used: with its scale it is beyond "
      << vtkIndirectRadianceImage::MostRadiance << ". No light comes from it.");
    this->Cells.clear();
  }
  return this->Cells;
}

//------------------------------------------------------------------------------
void vtkEnvironmentLight::GetGreatestRadiance(double radiance[3])
{
  this->GetCells();
  std::copy(this->Greatest, this->Greatest + 3, radiance);
}

//------------------------------------------------------------------------------
void vtkEnvironmentLight::MakeCells()
{
  struct Sum
  {
    glm::dvec3 Light{ 0.0 };
    glm::dvec3 Direction{ 0.0 };
  };
  std::vector<Sum> sums(static_cast<size_t>(Columns) * Rows);
  vtkImageData* image = this->FindImage();
  const double pi = vtkMath::Pi();
  glm::dvec3 greatest(0.0);
  auto add = [&](int columns, int rows, auto getRadiance)
  {
    for (int j = 0; j < rows; ++j)
    {
      const double below = pi * (static_cast<double>(j) / rows - 0.5);
      const double above = pi * (static_cast<double>(j + 1) / rows - 0.5);
      const double solidAngle = 2.0 * pi / columns * (std::sin(above) - std::sin(below));
      const int row = std::min(static_cast<int>((j + 0.5) / rows * Rows), Rows - 1);
      for (int i = 0; i < columns; ++i)
      {
        const glm::dvec3 radiance = this->GetScale() * getRadiance(i, j);
        const glm::dvec3 light = solidAngle * radiance;
        greatest = glm::max(greatest, radiance);
        const double strength = light.x + light.y + light.z;
        if (strength > 0.0)
        {
          const int column = std::min(static_cast<int>((i + 0.5) / columns * Columns), Columns - 1);
          Sum& sum = sums[static_cast<size_t>(row) * Columns + column];
          sum.Light += light;
          sum.Direction +=
            strength * ToDirection(2.0 * pi * ((i + 0.5) / columns - 0.5), 0.5 * (below + above));
        }
      }
    }
  };
  if (image)
  {
    vtkIndirectRadianceImage pixels(image, this->IsEncoded());
    // Pixels wider than a cell are cut into pieces.
    const int across = (Columns + pixels.GetWidth() - 1) / pixels.GetWidth();
    const int upward = (Rows + pixels.GetHeight() - 1) / pixels.GetHeight();
    add(across * pixels.GetWidth(), upward * pixels.GetHeight(),
      [&](int i, int j) { return pixels.Get(i / across, j / upward); });
    const vtkIdType invalid = pixels.GetNumberOfInvalid() / (across * upward);
    if (invalid > 0)
    {
      vtkWarningMacro(<< invalid << " value(s) of the environment's image are "
                      << "negative or not finite, and count as zero.");
    }
  }
  else
  {
    const glm::dvec3 radiance(this->Radiance[0], this->Radiance[1], this->Radiance[2]);
    add(Columns, Rows, [&](int, int) { return radiance; });
  }
  for (int c = 0; c < 3; ++c)
  {
    this->Greatest[c] = greatest[c];
  }
  const glm::dmat3 frame = MakeFrame(this->Up, this->Right);
  for (const Sum& sum : sums)
  {
    if (sum.Light == glm::dvec3(0.0))
    {
      continue;
    }
    const glm::dvec3 d = frame * glm::normalize(sum.Direction);
    this->Cells.push_back({ { d.x, d.y, d.z }, { sum.Light.x, sum.Light.y, sum.Light.z } });
  }
}
