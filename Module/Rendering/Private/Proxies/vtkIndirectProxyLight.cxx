// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxyLight.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "vtkEnvironmentLight.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

using namespace vtkIndirectKernels;

namespace
{
float Get(const vtkiHarmonics4& f, int i)
{
  const vec4& part = i < 4 ? f.A : i < 8 ? f.B : i < 12 ? f.C : f.D;
  return part[i % 4];
}

void Append(std::vector<glm::vec4>& rows, const vtkiHarmonics4& f)
{
  rows.insert(rows.end(), { f.A, f.B, f.C, f.D });
}

// Of no particular length: compares sizes.
glm::dvec3 FindNormal(const vtkIndirectProxyPolygon& polygon)
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
  for (const vtkEnvironmentLight::Cell& cell : environment->GetCells())
  {
    const vtkiHarmonics4 y =
      vtkiHarmonics4At(glm::vec3(cell.Direction[0], cell.Direction[1], cell.Direction[2]));
    const glm::dvec3 sent(cell.Light[0], cell.Light[1], cell.Light[2]);
    for (int i = 0; i < NumberOfCoefficients; ++i)
    {
      light[static_cast<size_t>(i)] += static_cast<double>(Get(y, i)) * sent;
    }
  }
  return light;
}

//------------------------------------------------------------------------------
// Rows as vtkIndirectProxyBlock.glsl has them.
void vtkIndirectProxyLight::AddPolygons(
  std::vector<glm::vec4>& rows, std::vector<vtkIndirectProxyPolygon> polygons)
{
  std::stable_sort(polygons.begin(), polygons.end(),
    [](const vtkIndirectProxyPolygon& a, const vtkIndirectProxyPolygon& b)
    { return glm::length(FindNormal(a)) > glm::length(FindNormal(b)); });
  this->NumberLeftOut = polygons.size() > MostPolygons ? polygons.size() - MostPolygons : 0;
  this->NumberOfPolygons = 0;
  for (const vtkIndirectProxyPolygon& polygon : polygons)
  {
    const glm::dvec3 normal = FindNormal(polygon);
    const double length = glm::length(normal);
    if (!(length > 0.0) || static_cast<size_t>(this->NumberOfPolygons) == MostPolygons)
    {
      continue;
    }
    ++this->NumberOfPolygons;
    const size_t corners = std::min(polygon.Corners.size(), MostCorners);
    rows.emplace_back(glm::vec3(normal / length), static_cast<float>(corners));
    rows.emplace_back(polygon.Albedo, static_cast<float>(std::sqrt(0.5 * length)));
    for (size_t i = 0; i < MostCorners; ++i)
    {
      rows.emplace_back(glm::vec3(polygon.Corners[std::min(i, corners - 1)]), 0.0f);
    }
  }
  rows.resize(rows.size() +
    (MostPolygons - static_cast<size_t>(this->NumberOfPolygons)) * (2 + MostCorners));
}

//------------------------------------------------------------------------------
void vtkIndirectProxyLight::Update(vtkOpenGLRenderWindow* window, vtkEnvironmentLight* environment,
  const std::vector<vtkIndirectProxyPolygon>& polygons, bool changed)
{
  const vtkMTimeType time = environment ? environment->GetMTime() : 0;
  const bool same = environment == this->Environment && time == this->Time;
  if (same && !changed && this->Block.GetBytes() > 0)
  {
    return;
  }
  if (!same || this->Block.GetBytes() == 0)
  {
    this->Light.fill(glm::dvec3(0.0));
    if (environment)
    {
      this->Light = Project(environment);
    }
    this->Environment = environment;
    this->Time = time;
  }
  std::vector<glm::vec4> rows;
  for (int color = 0; color < 3; ++color)
  {
    vtkiHarmonics4 light;
    for (int i = 0; i < 4; ++i)
    {
      const size_t k = static_cast<size_t>(i);
      light.A[i] = static_cast<float>(this->Light[k][color]);
      light.B[i] = static_cast<float>(this->Light[4 + k][color]);
      light.C[i] = static_cast<float>(this->Light[8 + k][color]);
      light.D[i] = static_cast<float>(this->Light[12 + k][color]);
    }
    const vtkiLightMatrix matrix = vtkiMakeLightMatrix(light);
    for (const vtkiHarmonics4& column : matrix.Columns)
    {
      Append(rows, column);
    }
    Append(rows, light);
  }
  this->AddPolygons(rows, polygons);
  this->Block.Update(window, rows.data(), rows.size() * sizeof(glm::vec4));
}

//------------------------------------------------------------------------------
void vtkIndirectProxyLight::Activate(vtkShaderProgram* program) const
{
  this->Block.Activate(program);
  program->SetUniformi("vtkiPolygonCount", this->NumberOfPolygons);
}

//------------------------------------------------------------------------------
void vtkIndirectProxyLight::Release()
{
  this->Block.Release();
  this->Environment = nullptr;
}
