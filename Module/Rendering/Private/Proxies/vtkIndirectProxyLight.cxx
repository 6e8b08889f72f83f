// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxyLight.h"

#include "Emitters/vtkIndirectEmitterAccess.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "Proxies/vtkIndirectCoefficient.h"
#include "vtkEnvironmentLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectKernels;

namespace
{
void Append(std::vector<glm::vec4>& rows, const vtkiHarmonics4& f)
{
  rows.insert(rows.end(), { f.A, f.B, f.C, f.D });
}

// Returns twice the area, along the normal.
glm::dvec3 FindArea(const vtkIndirectProxyPolygon& polygon)
{
  glm::dvec3 sum(0.0);
  for (size_t i = 2; i < polygon.Corners.size(); ++i)
  {
    sum += glm::cross(
      polygon.Corners[i - 1] - polygon.Corners[0], polygon.Corners[i] - polygon.Corners[0]);
  }
  return sum;
}
}

//------------------------------------------------------------------------------
vtkIndirectProxyLight::Coefficients vtkIndirectProxyLight::Project(vtkEnvironmentLight* environment)
{
  Coefficients light;
  light.fill(glm::dvec3(0.0));
  for (const vtkIndirectEmitterAccess::Cell& cell : vtkIndirectEmitterAccess::GetCells(environment))
  {
    const vtkiHarmonics4 y =
      vtkiHarmonics4At(glm::vec3(cell.Direction[0], cell.Direction[1], cell.Direction[2]));
    const glm::dvec3 sent(cell.Light[0], cell.Light[1], cell.Light[2]);
    for (int i = 0; i < NumberOfCoefficients; ++i)
    {
      light[static_cast<size_t>(i)] += static_cast<double>(vtkIndirectCoefficient(y, i)) * sent;
    }
  }
  return light;
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectProxyPolygon> vtkIndirectProxyLight::ChoosePolygons(
  std::vector<vtkIndirectProxyPolygon> polygons)
{
  polygons.erase(std::remove_if(polygons.begin(), polygons.end(),
                   [](const vtkIndirectProxyPolygon& polygon)
                   { return !(glm::length(FindArea(polygon)) > 0.0); }),
    polygons.end());
  std::stable_sort(polygons.begin(), polygons.end(),
    [](const vtkIndirectProxyPolygon& a, const vtkIndirectProxyPolygon& b)
    { return glm::length(FindArea(a)) > glm::length(FindArea(b)); });
  if (polygons.size() > MostPolygons)
  {
    polygons.resize(MostPolygons);
  }
  return polygons;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectProxyLight::FindNormal(const vtkIndirectProxyPolygon& polygon)
{
  return glm::normalize(FindArea(polygon));
}

//------------------------------------------------------------------------------
// Triangles about the polygon's middle, each divided into m^2 equal ones.
std::vector<glm::dvec3> vtkIndirectProxyLight::FindPlaces(
  const vtkIndirectProxyPolygon& polygon, size_t numberOfPolygons)
{
  const int m = numberOfPolygons <= MostFinePolygons ? 2 : 1;
  const size_t corners = std::min(polygon.Corners.size(), MostCorners);
  glm::dvec3 middle(0.0);
  for (size_t i = 0; i < corners; ++i)
  {
    middle += polygon.Corners[i] / static_cast<double>(corners);
  }
  std::vector<glm::dvec3> places;
  for (size_t k = 0; k < corners; ++k)
  {
    const glm::dvec3 a = (polygon.Corners[k] - middle) / static_cast<double>(m);
    const glm::dvec3 b = (polygon.Corners[(k + 1) % corners] - middle) / static_cast<double>(m);
    for (int i = 0; i < m; ++i)
    {
      for (int j = 0; i + j < m; ++j)
      {
        places.push_back(middle + (i + 1.0 / 3.0) * a + (j + 1.0 / 3.0) * b);
        if (i + j + 1 < m)
        {
          places.push_back(middle + (i + 2.0 / 3.0) * a + (j + 2.0 / 3.0) * b);
        }
      }
    }
  }
  return places;
}

//------------------------------------------------------------------------------
double vtkIndirectProxyLight::FindSize(const vtkIndirectProxyPolygon& polygon)
{
  return 0.5 * glm::length(FindArea(polygon));
}

//------------------------------------------------------------------------------
// Rows in the layout of vtkIndirectProxyBlock.glsl.
void vtkIndirectProxyLight::AddPolygons(std::vector<glm::vec4>& rows,
  const std::vector<vtkIndirectProxyPolygon>& polygons, int firstPlace)
{
  this->NumberOfPolygons = static_cast<int>(polygons.size());
  for (size_t k = 0; k < polygons.size(); ++k)
  {
    const vtkIndirectProxyPolygon& polygon = polygons[k];
    const glm::dvec3 area = FindArea(polygon);
    const size_t corners = std::min(polygon.Corners.size(), MostCorners);
    const int places = static_cast<int>(FindPlaces(polygon, polygons.size()).size());
    rows.emplace_back(glm::vec3(glm::normalize(area)), static_cast<float>(corners));
    rows.emplace_back(polygon.Albedo, static_cast<float>(std::sqrt(0.5 * glm::length(area))));
    for (size_t i = 0; i < MostCorners; ++i)
    {
      rows.emplace_back(glm::vec3(polygon.Corners[std::min(i, corners - 1)]),
        static_cast<float>(i == 0 ? firstPlace : places));
    }
    firstPlace += 2 * places;
  }
  rows.resize(rows.size() + (MostPolygons - polygons.size()) * (2 + MostCorners));
}

//------------------------------------------------------------------------------
bool vtkIndirectProxyLight::Update(vtkOpenGLRenderWindow* window, vtkEnvironmentLight* environment,
  const std::vector<vtkIndirectProxyPolygon>& polygons, int firstPlace, bool changed)
{
  const bool same = !this->Environment.Take({ "environment", environment });
  if (same && !changed && this->Block.GetBytes() > 0)
  {
    return false;
  }
  if (!same || this->Block.GetBytes() == 0)
  {
    this->Light.fill(glm::dvec3(0.0));
    if (environment)
    {
      this->Light = Project(environment);
    }
  }
  std::vector<glm::vec4> rows;
  for (int color = 0; color < 3; ++color)
  {
    vtkiHarmonics4 light;
    for (int i = 0; i < NumberOfCoefficients; ++i)
    {
      vtkIndirectCoefficient(light, i) =
        static_cast<float>(this->Light[static_cast<size_t>(i)][color]);
    }
    const vtkiLightMatrix matrix = vtkiMakeLightMatrix(light);
    for (const vtkiHarmonics4& column : matrix.Columns)
    {
      Append(rows, column);
    }
    Append(rows, light);
  }
  this->AddPolygons(rows, polygons, firstPlace);
  this->Block.Update(window, rows.data(), rows.size() * sizeof(glm::vec4));
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectProxyLight::Activate(const vtkIndirectProgram& program) const
{
  this->Block.Activate(program);
  program->SetUniformi("vtkiPolygonCount", this->NumberOfPolygons);
}
