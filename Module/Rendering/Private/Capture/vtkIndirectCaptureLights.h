// SPDX-License-Identifier: BSD-3-Clause
// What a surface mapper's shader reads of the lights beside VTK's own uniforms: the cosine of each
// cone, and where each light's shadow map is.
#ifndef vtkIndirectCaptureLights_h
#define vtkIndirectCaptureLights_h

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
  /** Takes the frame's lights, and the maps that their shadows are looked up in, or null. */
  void Update(const vtkIndirectFrame& frame, const vtkIndirectShadowMaps* shadows);

  /** Name of VTK's cosine of the cone's angle, which its own code takes at every pixel. */
  static std::string GetConeCosine(int light);

  /**
   * Declarations of what a look-up of these lights' shadows reads. named: each row is a uniform by
   * itself, which can be a varying, and the loop chooses among them; else rows of several lights
   * are an array.
   */
  static std::string GetDeclarations(const vtkIndirectLightConstants::Group& group, bool named);

  /**
   * Text in front of VTK's light code: shares of the lights that are seen, as factors on VTK's own
   * colours of them.
   */
  static std::string GetLookUps(const vtkIndirectLightConstants::Group& group, bool named);

  /** Sets what the program has of them. */
  void SetUniforms(
    vtkShaderProgram* program, const std::vector<vtkIndirectLightConstants::Group>& groups) const;

private:
  struct Light
  {
    float ConeCosine = 0.0f;
    glm::mat4 ViewToLight{ 1.0f }; // scene units
    glm::vec4 ShadowMap{ -1.0f };
    glm::vec4 ShadowDepth{ 0.0f };
    glm::vec4 Size{ 0.0f };
  };
  std::vector<Light> Lights; // by vtkIndirectLight::Index
};

#endif
