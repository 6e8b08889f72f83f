// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectCaptureLights.h"

#include "Capture/vtkIndirectShadowMaps.h"
#include "Frame/vtkIndirectFrame.h"
#include "vtkMath.h"
#include "vtkShaderProgram.h"

#include <cmath>
#include <glm/gtc/type_ptr.hpp>

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
std::string vtkIndirectCaptureLights::GetDeclarations(int light, bool shadows, bool penumbra)
{
  const std::string n = std::to_string(light);
  std::string text = "uniform float " + GetConeCosine(light) + ";\n";
  if (shadows)
  {
    for (const char* name :
      { "vtkiToLightX", "vtkiToLightY", "vtkiToLightZ", "vtkiShadowMap", "vtkiShadowDepth" })
    {
      text += "uniform vec4 " + (name + n) + ";\n";
    }
  }
  if (shadows && penumbra)
  {
    text += "uniform vec4 vtkiLightSize" + n + ";\n";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string vtkIndirectCaptureLights::GetConeCosine(int light)
{
  return "vtkiConeCosine" + std::to_string(light);
}

//------------------------------------------------------------------------------
std::string vtkIndirectCaptureLights::GetArguments(int light, bool penumbra)
{
  const std::string n = std::to_string(light);
  return "mat3x4(vtkiToLightX" + n + ", vtkiToLightY" + n + ", vtkiToLightZ" + n +
    "), vtkiShadowMap" + n + ", vtkiShadowDepth" + n + (penumbra ? ", vtkiLightSize" + n : "");
}

//------------------------------------------------------------------------------
void vtkIndirectCaptureLights::SetUniforms(vtkShaderProgram* program) const
{
  auto set = [program](const std::string& name, const glm::vec4& value)
  { program->SetUniform4f(name.c_str(), glm::value_ptr(value)); };
  for (size_t i = 0; i < this->Lights.size(); ++i)
  {
    const Light& light = this->Lights[i];
    const std::string n = std::to_string(i);
    const std::string cone = GetConeCosine(static_cast<int>(i));
    if (program->IsUniformUsed(cone.c_str()))
    {
      program->SetUniformf(cone.c_str(), light.ConeCosine);
    }
    const std::string map = "vtkiShadowMap" + n;
    if (program->IsUniformUsed(map.c_str()))
    {
      const glm::mat4 rows = glm::transpose(light.ViewToLight);
      set("vtkiToLightX" + n, rows[0]);
      set("vtkiToLightY" + n, rows[1]);
      set("vtkiToLightZ" + n, rows[2]);
      set(map, light.ShadowMap);
      set("vtkiShadowDepth" + n, light.ShadowDepth);
    }
    const std::string size = "vtkiLightSize" + n;
    if (program->IsUniformUsed(size.c_str()))
    {
      set(size, light.Size);
    }
  }
}
