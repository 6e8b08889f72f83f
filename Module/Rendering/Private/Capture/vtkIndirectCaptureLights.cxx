// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectCaptureLights.h"

#include "Capture/vtkIndirectShadowMaps.h"
#include "Frame/vtkIndirectFrame.h"
#include "vtkMath.h"
#include "vtkShaderProgram.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

namespace
{
// Rows of a light: three of the matrix, map, depths, and of penumbrae the size.
int CountRows(const vtkIndirectLightConstants::Group& group)
{
  return group.Penumbra ? 6 : 5;
}

std::string GetName(const vtkIndirectLightConstants::Group& group)
{
  return (group.Penumbra ? "vtkiSoftShadows" : "vtkiShadows") + std::to_string(group.Projection);
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
    Light& light = this->Lights[map.Light];
    light.ViewToLight = glm::mat4(m);
    light.ShadowMap = glm::vec4(map.FirstLayer, map.Projection, map.HalfWidth, texels);
    light.ShadowDepth = glm::vec4(map.Near, map.Far, map.Attenuation, map.NumberOfFaces);
  };
  for (const vtkIndirectShadowMap& map : shadows->Maps)
  {
    set(map, shadows->Texels);
  }
  for (const vtkIndirectPenumbraMap& penumbra : shadows->Penumbrae)
  {
    set(penumbra.Map, shadows->TileTexels);
    this->Lights[penumbra.Map.Light].Size = glm::vec4(
      penumbra.Size, penumbra.HoldsAll ? 1.0 : 0.0, shadows->TileColumns, shadows->TileRows);
  }
}

//------------------------------------------------------------------------------
std::string vtkIndirectCaptureLights::GetConeCosine(int light)
{
  return "vtkiConeCosine" + std::to_string(light);
}

//------------------------------------------------------------------------------
// One light's rows are uniforms of their own: no array can be a varying.
std::string vtkIndirectCaptureLights::GetDeclarations(const vtkIndirectLightConstants::Group& group)
{
  const int rows = CountRows(group);
  if (group.Lights.size() > 1)
  {
    return "uniform vec4 " + GetName(group) + "[" +
      std::to_string(rows * static_cast<int>(group.Lights.size())) + "];\n";
  }
  std::string text;
  for (int row = 0; row < rows; ++row)
  {
    text += "uniform vec4 " + GetName(group) + "_" + std::to_string(row) + ";\n";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string vtkIndirectCaptureLights::GetLookUps(const vtkIndirectLightConstants::Group& group)
{
  const std::string name = GetName(group);
  const bool single = group.Lights.size() == 1;
  auto row = [&](int i)
  { return name + (single ? "_" + std::to_string(i) : "[vtkiFirst + " + std::to_string(i) + "]"); };
  const std::string call = (group.Penumbra ? "vtkiPenumbra(mat3x4(" : "vtkiVisibility(mat3x4(") +
    row(0) + ", " + row(1) + ", " + row(2) + "), " + row(3) + ", " + row(4) +
    (group.Penumbra ? ", " + row(5) : "") + ", " + std::to_string(group.Projection) +
    ", vertexVC.xyz, normalVCVSOutput, vtkiFacetNormalVC)";
  auto factor = [](int light, const std::string& seen)
  {
    const std::string color = "lightColor" + std::to_string(light);
    return "  vec3 " + color + " = " + color + " * " + seen + ";\n";
  };
  if (single)
  {
    return factor(group.Lights.front(), call);
  }
  // The end is no constant: the loop stays one. Pixels of maps take no step of it.
  const std::string count = std::to_string(group.Lights.size());
  std::string ones = "1.0";
  for (size_t i = 1; i < group.Lights.size(); ++i)
  {
    ones += ", 1.0";
  }
  std::string text = "  float " + name + "Seen[" + count + "] = float[" + count + "](" + ones +
    ");\n  for (int vtkiLight = 0; vtkiLight < (vtkiStage != 0 ? 0 : " + count +
    "); ++vtkiLight)\n  {\n    int vtkiFirst = " + std::to_string(CountRows(group)) +
    " * vtkiLight;\n    " + name + "Seen[vtkiLight] = " + call + ";\n  }\n";
  for (size_t i = 0; i < group.Lights.size(); ++i)
  {
    text += factor(group.Lights[i], name + "Seen[" + std::to_string(i) + "]");
  }
  return text;
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
    const bool single = group.Lights.size() == 1;
    if (!program->IsUniformUsed((single ? name + "_3" : name).c_str()))
    {
      continue;
    }
    const int count = CountRows(group);
    std::vector<glm::vec4> rows;
    for (const int number : group.Lights)
    {
      const Light& light = this->Lights[static_cast<size_t>(number)];
      const glm::mat4 toLight = glm::transpose(light.ViewToLight);
      const glm::vec4 all[] = { toLight[0], toLight[1], toLight[2], light.ShadowMap,
        light.ShadowDepth, light.Size };
      rows.insert(rows.end(), all, all + count);
    }
    for (int row = 0; single && row < count; ++row)
    {
      program->SetUniform4f(
        (name + "_" + std::to_string(row)).c_str(), glm::value_ptr(rows[static_cast<size_t>(row)]));
    }
    if (!single)
    {
      program->SetUniform4fv(name.c_str(), static_cast<int>(rows.size()),
        reinterpret_cast<const float(*)[4]>(glm::value_ptr(rows.front())));
    }
  }
}
