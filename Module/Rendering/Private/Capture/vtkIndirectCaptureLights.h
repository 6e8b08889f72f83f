// SPDX-License-Identifier: BSD-3-Clause
// What a surface mapper's shader reads of the lights beside VTK's own uniforms: the cosine of each
// cone, and where each light's shadow map is.
#ifndef vtkIndirectCaptureLights_h
#define vtkIndirectCaptureLights_h

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

  /** Declarations of one light's uniforms, each of its own: those in arrays would be as many in
   * every shader as the scene has lights, and none could be a varying. */
  static std::string GetDeclarations(int light, bool shadows, bool penumbra);

  /** Name of VTK's cosine of the cone's angle, which its own code takes at every pixel. */
  static std::string GetConeCosine(int light);

  /** What stands for the light in a call of vtkiVisibility, or of vtkiPenumbra. */
  static std::string GetArguments(int light, bool penumbra);

  /** Sets what the program has of them. */
  void SetUniforms(vtkShaderProgram* program) const;

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
