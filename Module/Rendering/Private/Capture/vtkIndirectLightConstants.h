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

  /**
   * Lights whose shadows are looked up alike: a shader has the look-up once for all of them, in a
   * loop. Compilers put functions in place of their calls, and took 80 seconds for eight lights
   * with a look-up each.
   */
  struct Group
  {
    int Projection; // what vtkIndirectLight::FindMapProjection says
    bool Penumbra;
    std::vector<int> Lights; // by vtkIndirectLight::Index
    bool operator==(const Group& other) const
    {
      return this->Projection == other.Projection && this->Penumbra == other.Penumbra &&
        this->Lights == other.Lights;
    }
  };
  /** All lights that cast shadows; none where no shadows are looked up. */
  const std::vector<Group>& GetGroups() const { return this->Groups; }

  /** Whether the shadows of any light have penumbrae. */
  bool HasPenumbrae() const;

private:
  struct Constant
  {
    std::string Uniform;     // as VTK declares it
    std::string Declaration; // the local variable
    bool operator==(const Constant& other) const { return this->Declaration == other.Declaration; }
  };
  std::vector<Constant> Constants;
  std::vector<Group> Groups;
  bool Specular = true;
};

#endif
