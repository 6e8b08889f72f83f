// SPDX-License-Identifier: BSD-3-Clause
// The text that vtkSurfaceCapturePass adds to the shaders of mappers.
#ifndef vtkIndirectCaptureText_h
#define vtkIndirectCaptureText_h

#include <string>

class vtkIndirectLightConstants;

struct vtkIndirectCaptureText
{
  const vtkIndirectLightConstants& LightConstants;
  bool Shadows;       // whether shadows are looked up
  bool Specular;      // whether the specular colour and power are written
  bool SpecularOfPBR; // whether F0 and roughness are, in the same place
  bool FlatUniforms;  // whether uniforms come as flat varyings
  bool Soft;          // whether alpha says where the mapper draws a surface

  /**
   * Leaves a marker in front of VTK's light code: what the mapper declares is known only after it
   * has written its own text.
   */
  static void Prepare(std::string& fragmentShader);
  /** Whether a shader has the text already. */
  static bool IsAdded(const std::string& fragmentShader);
  /** Adds the text to shaders that are prepared and otherwise complete. */
  void Add(
    std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader) const;
};

#endif
