// SPDX-License-Identifier: BSD-3-Clause
// The text that vtkSurfaceCapturePass adds to the shaders of mappers.
#pragma once

#include <string>

class vtkIndirectLightConstants;

struct vtkIndirectCaptureText
{
  const vtkIndirectLightConstants& LightConstants;
  bool Shadows;       // shadows are looked up
  bool Specular;      // the specular colour and power are written
  bool SpecularOfPBR; // F0 and roughness are written in the same place
  bool FlatUniforms;  // uniforms come as flat varyings
  bool Soft;          // alpha tells where the mapper draws a surface
  bool MapsOnly;      // the program draws maps, never the view: compilers drop the code of lights

  /**
   * Leaves a marker in front of VTK's light code: the mapper's declarations are known only after it
   * has written its own text.
   */
  static void Prepare(std::string& fragmentShader);
  /** Returns true if a shader has the text already. */
  static bool IsAdded(const std::string& fragmentShader);
  /** Adds the text to shaders that are prepared and otherwise complete. */
  void Add(
    std::string& vertexShader, std::string& geometryShader, std::string& fragmentShader) const;
};
