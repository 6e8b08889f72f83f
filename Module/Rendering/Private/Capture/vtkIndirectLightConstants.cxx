// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectLightConstants.h"

#include "Scene/vtkIndirectFrame.h"

#include <algorithm>

//------------------------------------------------------------------------------
bool vtkIndirectLightConstants::Update(const vtkIndirectFrame& frame, bool shadows)
{
  std::vector<Constant> constants;
  std::vector<Group> groups;
  auto add = [&constants](
               const std::string& type, const std::string& name, int light, const char* value)
  {
    const std::string variable = type + " " + name + std::to_string(light);
    constants.push_back({ "uniform " + variable + ";", "  " + variable + " = " + value + ";\n" });
  };
  for (const vtkIndirectLight& light : frame.Lights)
  {
    const int n = light.Index;
    if (shadows && !light.Fill)
    {
      const int projection = light.FindMapProjection();
      const bool penumbra = light.Size > 0.0;
      auto group = std::find_if(groups.begin(), groups.end(),
        [&](const Group& known)
        { return known.Projection == projection && known.Penumbra == penumbra; });
      group = group == groups.end() ? groups.insert(group, { projection, penumbra, {} }) : group;
      group->Lights.push_back(n);
    }
    add("int", "lightPositional", n, light.Positional ? "1" : "0");
    if (!light.Positional)
    {
      continue;
    }
    if (light.ConeAngle >= 90.0)
    {
      add("float", "lightConeAngle", n, "90.0");
    }
    else if (light.Exponent == 0.0 || light.Exponent == 1.0)
    {
      add("float", "lightExponent", n, light.Exponent == 0.0 ? "0.0" : "1.0");
    }
  }
  const bool changed =
    constants != this->Constants || groups != this->Groups || frame.Specular != this->Specular;
  this->Groups = std::move(groups);
  this->Constants = std::move(constants);
  this->Specular = frame.Specular;
  return changed;
}

//------------------------------------------------------------------------------
bool vtkIndirectLightConstants::HasPenumbrae() const
{
  return std::any_of(
    this->Groups.begin(), this->Groups.end(), [](const Group& group) { return group.Penumbra; });
}

//------------------------------------------------------------------------------
std::string vtkIndirectLightConstants::GetDeclarations(const std::string& fragmentShader) const
{
  std::string text;
  for (const Constant& constant : this->Constants)
  {
    if (fragmentShader.find(constant.Uniform) != std::string::npos)
    {
      text += constant.Declaration;
    }
  }
  // specularColor is a local variable of VTK. If no material of the scene has a lobe, the compiler
  // drops its evaluation.
  if (!this->Specular && fragmentShader.find("vec3 specularColor =") != std::string::npos)
  {
    text += "  specularColor = vec3(0.0);\n";
  }
  return text;
}
