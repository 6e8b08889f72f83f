// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAreaLight.h"

#include "Emitters/vtkIndirectRadianceImage.h"
#include "vtkImageData.h"
#include "vtkInformationObjectBaseKey.h"
#include "vtkObjectFactory.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>
#include <string>

vtkStandardNewMacro(vtkAreaLight);
vtkInformationKeyRestrictedMacro(vtkAreaLight, AREA_LIGHTS, ObjectBase, "vtkCollection");

namespace
{
// Returns a vector across the rectangle, as long as its area.
glm::dvec3 Span(const double origin[3], const double point1[3], const double point2[3])
{
  const glm::dvec3 o(origin[0], origin[1], origin[2]);
  return glm::cross(glm::dvec3(point1[0], point1[1], point1[2]) - o,
    glm::dvec3(point2[0], point2[1], point2[2]) - o);
}
}

//------------------------------------------------------------------------------
vtkAreaLight::vtkAreaLight() = default;

vtkAreaLight::~vtkAreaLight() = default;

//------------------------------------------------------------------------------
void vtkAreaLight::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  auto print = [&](const char* name, const double v[3])
  { os << indent << name << ": (" << v[0] << ", " << v[1] << ", " << v[2] << ")\n"; };
  print("Origin", this->Origin);
  print("Point1", this->Point1);
  print("Point2", this->Point2);
  const char* const methods[] = { "Automatic", "ClosedForm", "VirtualLights" };
  os << indent << "Method: " << methods[this->Settings.Method] << "\n";
  os << indent << "TwoSided: " << (this->Settings.TwoSided ? "On" : "Off") << "\n";
  os << indent << "Visible: " << (this->Settings.Visible ? "On" : "Off") << "\n";
  os << indent << "Switch: " << (this->Settings.Switch ? "On" : "Off") << "\n";
}

//------------------------------------------------------------------------------
void vtkAreaLight::GetNormal(double normal[3]) const
{
  const glm::dvec3 span = Span(this->Origin, this->Point1, this->Point2);
  const double length = glm::length(span);
  for (int i = 0; i < 3; ++i)
  {
    normal[i] = length > 0.0 ? span[i] / length : 0.0;
  }
}

//------------------------------------------------------------------------------
double vtkAreaLight::GetArea() const
{
  return glm::length(Span(this->Origin, this->Point1, this->Point2));
}

//------------------------------------------------------------------------------
bool vtkAreaLight::ShinesInto(const double center[3], double size)
{
  if (!this->Settings.Switch)
  {
    return false;
  }
  const glm::dvec3 middle(center[0], center[1], center[2]);
  const glm::dvec3 origin(this->Origin[0], this->Origin[1], this->Origin[2]);
  const glm::dvec3 point1(this->Point1[0], this->Point1[1], this->Point1[2]);
  const glm::dvec3 point2(this->Point2[0], this->Point2[1], this->Point2[2]);
  const glm::dvec3 farthest = glm::max(
    glm::abs(origin - middle), glm::max(glm::abs(point1 - middle), glm::abs(point2 - middle)));
  const double shortest = std::min(glm::length(point1 - origin), glm::length(point2 - origin));
  std::string why;
  // Beyond these limits floats cannot hold the squares of areas and the fourth powers of distances.
  if (!std::isfinite(glm::dot(farthest, glm::dvec3(1.0))))
  {
    why = "a corner is not finite";
  }
  else if (std::max({ farthest.x, farthest.y, farthest.z }) > 1e9 * size)
  {
    why = "a corner is farther away than a thousand million times the size of the scene";
  }
  else if (!(this->GetArea() > 0.0))
  {
    why = "its corners span no area";
  }
  else if (shortest < 1e-9 * size)
  {
    why = "an edge is shorter than a thousand millionth of the size of the scene";
  }
  const vtkMTimeType time = this->GetMTime();
  if (!why.empty() && this->FaultTime != time)
  {
    vtkErrorMacro("The area light with its corner at (" << origin.x << ", " << origin.y << ", "
                                                        << origin.z << ") is off: " << why << ".");
    this->FaultTime = time;
  }
  int columns;
  int rows;
  return why.empty() && !this->GetRadiances(columns, rows).empty();
}

//------------------------------------------------------------------------------
void vtkAreaLight::GetMeanRadiance(double radiance[3])
{
  int columns;
  int rows;
  this->GetRadiances(columns, rows);
  std::copy(this->Mean, this->Mean + 3, radiance);
}

//------------------------------------------------------------------------------
const std::vector<float>& vtkAreaLight::GetRadiances(int& columns, int& rows)
{
  vtkImageData* image = this->FindImage(); // the call may change the time
  const vtkMTimeType time = this->GetMTime();
  if (time != this->RadiancesTime)
  {
    this->RadiancesTime = time;
    this->Radiances.clear();
    this->Columns = this->Rows = 0;
    std::fill(this->Mean, this->Mean + 3, 0.0);
    if (image && !vtkIndirectRadianceImage::CanRead(image))
    {
      vtkErrorMacro("The area light's image is not used: it must be of one slice, with a scalar "
                    "for each point. The light is off.");
    }
    else
    {
      this->ReadRadiances();
    }
    if (!std::all_of(this->Radiances.begin(), this->Radiances.end(),
          [](float value) { return value <= vtkIndirectRadianceImage::MostRadiance; }))
    {
      vtkErrorMacro("The area light's radiance is not used: with its scale it is beyond "
        << vtkIndirectRadianceImage::MostRadiance << ". The light is off.");
      this->Radiances.clear();
      this->Columns = this->Rows = 0;
    }
    if (!this->Radiances.empty())
    {
      for (size_t i = 0; i < this->Radiances.size(); ++i)
      {
        this->Mean[i % 3] += this->Radiances[i];
      }
      for (double& mean : this->Mean)
      {
        mean /= static_cast<double>(this->Columns) * this->Rows;
      }
    }
  }
  columns = this->Columns;
  rows = this->Rows;
  return this->Radiances;
}

//------------------------------------------------------------------------------
void vtkAreaLight::ReadRadiances()
{
  auto add = [this](const glm::dvec3& share)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Radiances.push_back(
        static_cast<float>(this->GetScale() * this->Radiance[c] * share[c]));
    }
  };
  vtkImageData* image = this->FindImage();
  if (!image)
  {
    this->Columns = this->Rows = 1;
    add(glm::dvec3(1.0));
    return;
  }
  vtkIndirectRadianceImage pixels(image, this->IsEncoded());
  this->Columns = pixels.GetWidth();
  this->Rows = pixels.GetHeight();
  this->Radiances.reserve(3 * static_cast<size_t>(this->Columns) * this->Rows);
  for (int row = 0; row < this->Rows; ++row)
  {
    for (int column = 0; column < this->Columns; ++column)
    {
      add(pixels.Get(column, row));
    }
  }
  if (pixels.GetNumberOfInvalid() > 0)
  {
    vtkWarningMacro(<< pixels.GetNumberOfInvalid() << " value(s) of the area light's image are "
                    << "negative or not finite, and count as zero.");
  }
}
