// SPDX-License-Identifier: BSD-3-Clause
#include "Senders/vtkIndirectRefractionSampler.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Plan/vtkIndirectReport.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectRevision.h"
#include "vtkActor.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

//------------------------------------------------------------------------------
void vtkIndirectRefractionSampler::SetNumberOfLights(int number)
{
  // A request for all texels gives no number of paths through glass.
  this->NumberOfLights = number == VTK_INT_MAX ? 256 : number;
}

//------------------------------------------------------------------------------
bool vtkIndirectRefractionSampler::Update(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectKey key;
  key.Add("number of lights", this->NumberOfLights);
  frame.AppendUnitsTo(key);
  for (const vtkIndirectLight& light : frame.Lights)
  {
    light.AppendTo(key);
  }
  for (vtkActor* actor : frame.Refractors)
  {
    key.AddAddress("refractors", actor).Add("refractors", vtkIndirectRevision::Find(actor));
  }
  if (key == this->Key)
  {
    return true;
  }
  this->Key.Clear();
  std::vector<Row> rows;
  this->Bodies.resize(frame.Refractors.size());
  for (size_t i = 0; i < this->Bodies.size(); ++i)
  {
    vtkActor* const actor = frame.Refractors[i];
    vtkIndirectRefraction& body = this->Bodies[i];
    body.SetBody(frame, actor);
    for (const vtkIndirectLight& light : frame.Lights)
    {
      if (light.IsReflected())
      {
        this->Add(frame, light, actor, body, rows);
      }
    }
  }
  if (!this->Write(frame, rows))
  {
    return false;
  }
  this->Key = key;
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectRefractionSampler::Add(const vtkIndirectFrame& frame, const vtkIndirectLight& light,
  vtkActor* actor, const vtkIndirectRefraction& body, std::vector<Row>& rows) const
{
  double bounds[6];
  actor->GetBounds(bounds);
  const glm::dvec3 lower(bounds[0], bounds[2], bounds[4]);
  const glm::dvec3 upper(bounds[1], bounds[3], bounds[5]);
  const glm::dvec3 center = 0.5 * (lower + upper);
  const double radius = 0.5 * glm::length(upper - lower);
  const double distance = glm::length(center - light.PositionWC);
  if (!(radius > 0.0) || (light.Positional && distance <= radius))
  {
    return; // a light within the bounds of the glass
  }
  const glm::dvec3 axis =
    light.Positional ? (center - light.PositionWC) / distance : light.DirectionWC;
  const glm::dvec3 other =
    std::abs(axis.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 right = glm::normalize(glm::cross(axis, other));
  const glm::dvec3 up = glm::cross(right, axis);
  // The half width is a tangent, or the length for a directional light.
  const double halfWidth =
    light.Positional ? radius / std::sqrt(distance * distance - radius * radius) : radius;
  const int edge = std::max(2, static_cast<int>(std::sqrt(2.0 * this->NumberOfLights) + 0.5));
  const double step = 2.0 * halfWidth / edge;
  const double s = frame.SceneScale;
  std::vector<vtkIndirectRefraction::Path> paths(static_cast<size_t>(edge) * edge);
  std::vector<double> fluxes(paths.size(), 0.0);
  // The areas, across the path, of the squares where light enters.
  std::vector<double> areas(paths.size(), 0.0);
  for (int j = 0; j < edge; ++j)
  {
    for (int i = 0; i < edge; ++i)
    {
      const double x = (i + 0.5) * step - halfWidth;
      const double y = (j + 0.5) * step - halfWidth;
      const size_t at = static_cast<size_t>(j) * edge + i;
      const glm::dvec3 ray = axis + x * right + y * up;
      const glm::dvec3 way = light.Positional ? glm::normalize(ray) : axis;
      const glm::dvec3 origin =
        light.Positional ? light.PositionWC : center - 2.0 * radius * axis + x * right + y * up;
      paths[at] = body.Trace(frame.ToScene(origin), way);
      const double length = glm::length(ray);
      const double angle = step * step / (length * length * length);
      areas[at] = light.Positional ? angle * distance * distance : step * step;
      fluxes[at] =
        paths[at].Share * areas[at] * (light.Positional ? light.FindFalloff(way, distance) : 1.0);
    }
  }
  // A roughness that is not finite counts as zero.
  const double roughness = actor->GetProperty()->GetRoughness();
  const double base = vtkIndirectKernels::vtkiExponentOfRoughness(
    std::isfinite(roughness) ? static_cast<float>(roughness) : 0.0f);
  for (int j = 0; j < edge; ++j)
  {
    for (int i = 0; i < edge; ++i)
    {
      const size_t at = static_cast<size_t>(j) * edge + i;
      const vtkIndirectRefraction::Path& path = paths[at];
      if (!(fluxes[at] > 0.0))
      {
        continue;
      }
      // The lobes of neighbours meet, as for mirrors in light maps.
      double turn = 0.0;
      const int neighbors[4][2] = { { i - 1, j }, { i + 1, j }, { i, j - 1 }, { i, j + 1 } };
      for (const auto& n : neighbors)
      {
        if (n[0] >= 0 && n[0] < edge && n[1] >= 0 && n[1] < edge)
        {
          const auto& beside = paths[static_cast<size_t>(n[1]) * edge + n[0]];
          const glm::dvec3 d = beside.Direction - path.Direction;
          turn = beside.Share > 0.0 && glm::dot(d, d) < 0.5 ? std::max(turn, glm::dot(d, d)) : turn;
        }
      }
      Row row = {};
      const double across = std::max(glm::dot(path.Normal, path.Direction), 0.2);
      for (int c = 0; c < 3; ++c)
      {
        row.Position[c] = path.Position[c];
        row.Normal[c] = path.Normal[c];
        row.LobeDirection[c] = path.Direction[c];
        row.LobeDensityArea[c] = fluxes[at] * light.Color[c] * s * s;
      }
      row.Area = areas[at] / across * s * s;
      row.LobeExponent = base / (1.0 + base * turn / 12.0);
      rows.push_back(row);
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectRefractionSampler::AddToReport(vtkIndirectReport& report) const
{
  for (const vtkIndirectRefraction& body : this->Bodies)
  {
    report.MainMemoryBytes += body.GetBytes();
  }
}
