// SPDX-License-Identifier: BSD-3-Clause
// What of VTK's lighting is the same at every pixel of a frame, as shader text: a compiler leaves
// out what it makes needless. A processor without branches evaluates every cone and power of VTK's
// light code at every pixel, whatever the lights and materials are: with one lamp and no specular
// material, a quarter of what an opaque pixel takes.
#ifndef vtkIndirectLightConstants_h
#define vtkIndirectLightConstants_h

#include <string>
#include <vector>

struct vtkIndirectFrame;

class vtkIndirectLightConstants
{
public:
  /**
   * Reads the frame's lights and materials; shadows: whether shadows are looked up. Returns whether
   * a text has changed since the last call: shaders that have it must be built anew. A light that
   * moves, turns or changes its colour, attenuation, cone or size changes none, one that gets a
   * size does.
   */
  bool Update(const vtkIndirectFrame& frame, bool shadows);

  /**
   * Local variables to go in front of VTK's light code, which hide its uniforms; `fragmentShader`
   * has that code. Only what the shader declares is hidden.
   */
  std::string GetDeclarations(const std::string& fragmentShader) const;

  /** What vtkIndirectLight::FindMapProjection says of a light; -1: it casts no shadow. Light code
   * may be of more lights than the frame has, of which no map exists: 0. */
  int GetProjection(int light) const
  {
    return static_cast<size_t>(light) < this->Projections.size() ? this->Projections[light] : 0;
  }

  /** Whether a light's shadows have penumbrae. */
  bool HasPenumbra(int light) const
  {
    return static_cast<size_t>(light) < this->Penumbrae.size() && this->Penumbrae[light];
  }
  bool HasPenumbrae() const;

private:
  struct Constant
  {
    std::string Uniform;     // as VTK declares it
    std::string Declaration; // the local variable
    bool operator==(const Constant& other) const { return this->Declaration == other.Declaration; }
  };
  std::vector<Constant> Constants;
  std::vector<int> Projections; // empty without shadows
  std::vector<bool> Penumbrae;  // the same
  bool Specular = true;
};

#endif
