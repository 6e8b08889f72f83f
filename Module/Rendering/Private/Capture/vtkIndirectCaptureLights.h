// SPDX-License-Identifier: BSD-3-Clause
// Uniforms of the lights that a surface mapper's shader reads beside VTK's own: the cosine of each
// cone, and the place of each light's shadow map.
#pragma once

#include "Capture/vtkIndirectLightConstants.h"

#include <glm/glm.hpp>
#include <string>
#include <vector>

class vtkShaderProgram;
struct vtkIndirectFrame;
struct vtkIndirectShadowMaps;

class vtkIndirectCaptureLights
{
public:
  /** Takes the frame's lights, and the maps for their shadows, or null. */
  void Update(const vtkIndirectFrame& frame, const vtkIndirectShadowMaps* shadows);

  /**
   * Returns the name of VTK's cosine of the cone's angle, which its own code takes at every pixel.
   */
  static std::string GetConeCosine(int light) { return "vtkiConeCosine" + std::to_string(light); }

  /**
   * Declarations for a shadow look-up of these lights. named: each row is a separate uniform, which
   * can be a varying, and the loop chooses among them; otherwise the rows of several lights are an
   * array.
   */
  static std::string GetDeclarations(const vtkIndirectLightConstants::Group& group, bool named);

  /**
   * Text in front of VTK's light code: visibilities of the lights, as factors on VTK's own light
   * colours.
   */
  static std::string GetLookUps(const vtkIndirectLightConstants::Group& group, bool named);

  /** Sets those uniforms that the program has. */
  void SetUniforms(
    vtkShaderProgram* program, const std::vector<vtkIndirectLightConstants::Group>& groups) const;

private:
  struct Light
  {
    float ConeCosine = 0.0f;
    glm::mat4 ViewToLight{ 1.0f }; // scene units
    glm::vec4 ShadowMap{ -1.0f };
    glm::vec4 ShadowDepth{ 0.0f };
    glm::vec4 Shape{ 0.0f }; // of a penumbra, or the window of a map
  };
  std::vector<Light> Lights; // indexed by vtkIndirectLight::Index
};
