// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectCaptureLights.h"

#include "Capture/vtkIndirectShadowMaps.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkMath.h"
#include "vtkShaderProgram.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

namespace
{
// Number of uniform rows of a light: three of the matrix, map, depths, and the size of a penumbra
// or the window of a map.
constexpr int NumberOfRows = 6;

std::string GetName(const vtkIndirectLightConstants::Group& group)
{
  return (group.Penumbra ? "vtkiSoftShadows" : "vtkiShadows") + std::to_string(group.Projection);
}

// A row of one light of the group, as a uniform of its own, because arrays cannot be varyings.
std::string GetRow(const vtkIndirectLightConstants::Group& group, size_t light, int row)
{
  return GetName(group) + "_" + std::to_string(light) + "_" + std::to_string(row);
}

// Returns the shader expression that chooses among the values of several lights by the loop's
// index.
std::string Choose(const std::vector<std::string>& values)
{
  std::string text = values.back();
  for (size_t i = values.size() - 1; i-- > 0;)
  {
    text = "vtkiLight == " + std::to_string(i) + " ? " + values[i] + " : " + text;
  }
  return text;
}
}

//------------------------------------------------------------------------------
void vtkIndirectCaptureLights::Update(
  const vtkIndirectFrame& frame, const vtkIndirectShadowMaps* shadows)
{
  this->Lights.assign(frame.Lights.size(), Light());
  for (const vtkIndirectLight& light : frame.Lights)
  {
    this->Lights[light.Index].ConeCosine =
      static_cast<float>(std::cos(vtkMath::RadiansFromDegrees(light.ConeAngle)));
  }
  if (!shadows)
  {
    return;
  }
  const glm::dmat4 viewToWorld = glm::inverse(frame.WorldToView);
  auto set = [&](const vtkIndirectShadowMap& map, int texels)
  {
    glm::dmat4 m = map.WorldToLight * viewToWorld;
    m *= frame.SceneScale;
    Light& light = this->Lights[map.Light.Index];
    light.ViewToLight = glm::mat4(m);
    light.ShadowMap = glm::vec4(map.FirstLayer, map.Projection, map.HalfWidth, texels);
    light.ShadowDepth =
      glm::vec4(map.Near, map.Far, map.Light.ShadowAttenuation, map.NumberOfFaces);
  };
  for (const vtkIndirectShadowMap& map : shadows->Maps)
  {
    set(map, shadows->Texels);
    const vtkIndirectShadowMap::WindowType& window = map.Window;
    this->Lights[map.Light.Index].Shape = glm::vec4(
      window.Middle.x, window.Middle.y, window.Layer < 0 ? -1.0 : window.HalfWidth, window.Layer);
  }
  for (const vtkIndirectPenumbraMap& penumbra : shadows->Penumbrae)
  {
    set(penumbra.Map, shadows->TileTexels);
    this->Lights[penumbra.Map.Light.Index].Shape = glm::vec4(
      penumbra.Size, penumbra.HoldsAll ? 1.0 : 0.0, shadows->TileColumns, shadows->TileRows);
  }
}

//------------------------------------------------------------------------------
std::string vtkIndirectCaptureLights::GetDeclarations(
  const vtkIndirectLightConstants::Group& group, bool named)
{
  const size_t lights = group.Lights.size();
  if (lights > 1 && !named)
  {
    return "uniform vec4 " + GetName(group) + "[" +
      std::to_string(NumberOfRows * static_cast<int>(lights)) + "];\n";
  }
  std::string text;
  for (size_t i = 0; i < lights; ++i)
  {
    for (int row = 0; row < NumberOfRows; ++row)
    {
      text += "uniform vec4 " + GetRow(group, i, row) + ";\n";
    }
  }
  return text;
}

//------------------------------------------------------------------------------
std::string vtkIndirectCaptureLights::GetLookUps(
  const vtkIndirectLightConstants::Group& group, bool named)
{
  const std::string name = GetName(group);
  const size_t lights = group.Lights.size();
  std::string rows;
  for (int row = 0; row < NumberOfRows; ++row)
  {
    std::vector<std::string> values;
    for (size_t i = 0; i < lights; ++i)
    {
      values.push_back(GetRow(group, i, row));
    }
    rows += "    vec4 vtkiRow" + std::to_string(row) + " = " +
      (lights > 1 && !named ? name + "[" + std::to_string(NumberOfRows) + " * vtkiLight + " +
            std::to_string(row) + "]"
                            : Choose(values)) +
      ";\n";
  }
  rows += std::string("    float vtkiSeen = ") +
    (group.Penumbra ? "vtkiPenumbra" : "vtkiVisibility") +
    "(mat3x4(vtkiRow0, vtkiRow1, vtkiRow2), vtkiRow3, vtkiRow4, vtkiRow5, " +
    std::to_string(group.Projection) + ", vtkiPlaceVC, normalVCVSOutput, vtkiFacetNormalVC);\n";
  std::string begin;
  std::string end;
  for (size_t i = 0; i < lights; ++i)
  {
    const std::string seen = name + "Seen" + std::to_string(i);
    const std::string color = "lightColor" + std::to_string(group.Lights[i]);
    begin += "  float " + seen + " = 1.0;\n";
    rows += "    " + seen + " = " +
      (lights > 1 ? "vtkiLight == " + std::to_string(i) + " ? vtkiSeen : " + seen : "vtkiSeen") +
      ";\n";
    end += "  vec3 " + color + " = " + color + " * " + seen + ";\n";
  }
  if (lights > 1)
  {
    // The loop's end is not a constant, so that compilers keep the loop. Pixels of maps run none of
    // it.
    begin +=
      "  for (int vtkiLight = 0; vtkiLight < (vtkiStage != 0 ? 0 : " + std::to_string(lights) +
      "); ++vtkiLight)\n";
  }
  return begin + "  {\n" + rows + "  }\n" + end;
}

//------------------------------------------------------------------------------
void vtkIndirectCaptureLights::SetUniforms(
  vtkShaderProgram* program, const std::vector<vtkIndirectLightConstants::Group>& groups) const
{
  for (size_t i = 0; i < this->Lights.size(); ++i)
  {
    const std::string cone = GetConeCosine(static_cast<int>(i));
    if (program->IsUniformUsed(cone.c_str()))
    {
      program->SetUniformf(cone.c_str(), this->Lights[i].ConeCosine);
    }
  }
  for (const vtkIndirectLightConstants::Group& group : groups)
  {
    const std::string name = GetName(group);
    std::vector<glm::vec4> rows;
    for (size_t i = 0; i < group.Lights.size(); ++i)
    {
      const Light& light = this->Lights[static_cast<size_t>(group.Lights[i])];
      const glm::mat4 toLight = glm::transpose(light.ViewToLight);
      const glm::vec4 all[] = { toLight[0], toLight[1], toLight[2], light.ShadowMap,
        light.ShadowDepth, light.Shape };
      rows.insert(rows.end(), all, all + NumberOfRows);
      const bool named = program->IsUniformUsed(GetRow(group, i, 3).c_str());
      for (int row = 0; named && row < NumberOfRows; ++row)
      {
        program->SetUniform4f(GetRow(group, i, row).c_str(), glm::value_ptr(all[row]));
      }
    }
    if (program->IsUniformUsed(name.c_str()))
    {
      program->SetUniform4fv(name.c_str(), static_cast<int>(rows.size()),
        reinterpret_cast<const float(*)[4]>(glm::value_ptr(rows.front())));
    }
  }
}
