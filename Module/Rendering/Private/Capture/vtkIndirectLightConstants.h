// SPDX-License-Identifier: BSD-3-Clause
// Constants of VTK's lighting over a frame, as shader text that lets compilers drop code. A
// processor without branches evaluates every cone and power of VTK's light code at every pixel,
// even if no light or material needs it: with one light and no specular material, a quarter of an
// opaque pixel's time.
#pragma once

#include <string>
#include <vector>

struct vtkIndirectFrame;

class vtkIndirectLightConstants
{
public:
  /**
   * Reads the frame's lights and materials; shadows: shadows are looked up. Returns true if a text
   * has changed since the last call, so that shaders with it must be rebuilt. A light that moves,
   * turns or changes its colour, attenuation, cone or size changes no text; a light that gets a
   * size does.
   */
  bool Update(const vtkIndirectFrame& frame, bool shadows);

  /**
   * Returns the local variables that hide VTK's uniforms in `fragmentShader`, for the place in
   * front of its light code. Only uniforms that the shader declares are hidden.
   */
  std::string GetDeclarations(const std::string& fragmentShader) const;

  /**
   * Lights with the same kind of shadow look-up, which a shader runs in one loop. Compilers inline
   * the look-up's calls, and took 80 seconds for eight lights with a look-up each.
   */
  struct Group
  {
    int Projection; // see vtkIndirectLight::FindMapProjection
    bool Penumbra;
    std::vector<int> Lights; // values of vtkIndirectLight::Index
    bool operator==(const Group& other) const
    {
      return this->Projection == other.Projection && this->Penumbra == other.Penumbra &&
        this->Lights == other.Lights;
    }
  };
  /** All lights that cast shadows; empty without shadow look-ups. */
  const std::vector<Group>& GetGroups() const { return this->Groups; }

  /** Returns true if the shadows of any light have penumbrae. */
  bool HasPenumbrae() const;

private:
  struct Constant
  {
    std::string Uniform;     // VTK's declaration
    std::string Declaration; // the local variable
    bool operator==(const Constant& other) const { return this->Declaration == other.Declaration; }
  };
  std::vector<Constant> Constants;
  std::vector<Group> Groups;
  bool Specular = true;
};
