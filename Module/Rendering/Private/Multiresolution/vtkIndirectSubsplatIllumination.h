// SPDX-License-Identifier: BSD-3-Clause
// Illuminates the subsplats of a pyramid and interpolates from them down to pixels. Nichols and
// Wyman 2009, "Multiresolution splatting for indirect illumination", sections 3.4 and 3.5.
#ifndef vtkIndirectSubsplatIllumination_h
#define vtkIndirectSubsplatIllumination_h

#include "Multiresolution/vtkIndirectSubsplatPyramid.h" // for the pyramid
#include "OpenGL/vtkIndirectComputeProgram.h"           // for members
#include "OpenGL/vtkIndirectPointProgram.h"             // for members

class vtkIndirectSubsplatIllumination
{
public:
  enum Renderer
  {
    Points,    // one for each leaf and light, added by blending
    Fragments, // full-screen passes in which leaves sum over the lights
    Compute    // invocations for lists of split texels, four leaves each
  };

  using Input = vtkIndirectEstimateInput;
  using Settings = vtkIndirectSubsplatSettings;

  /** Creates or resizes the levels; pixels: the image to be filled, whose depth they share. */
  bool Resize(vtkOpenGLRenderWindow* window, const vtkIndirectSubsplatPyramid& pyramid,
    const vtkIndirectTarget& pixels, bool halfFloats);

  /** Illuminates all levels but pixels, coarse to fine. */
  bool FillLevels(const Input& input, const Settings& settings, Renderer renderer,
    vtkIndirectSubsplatPyramid& pyramid, vtkIndirectLightBlock& lights);
  /** Then the image. */
  bool FillPixels(const Input& input, const Settings& settings, Renderer renderer,
    vtkIndirectSubsplatPyramid& pyramid, vtkIndirectLightBlock& lights, vtkIndirectTarget& pixels);

  /** Irradiance, vector irradiance and what they are, of level `number`, from 1 on. */
  const vtkIndirectTarget& GetLevel(size_t number) const { return *this->Levels[number - 1]; }

  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  // What the steps below share.
  struct Work
  {
    const Input& In;
    const Settings& Set;
    vtkIndirectSubsplatPyramid& Pyramid;
    vtkIndirectLightBlock& Lights;
    vtkIndirectTarget& Target; // of the level that is written
    size_t Number;             // of that level, 0 for pixels
  };
  // Whether leaves side by side share what they ask of depth maps: in moving frames, where the
  // look-ups are half of the time and a shadow's border may be a leaf aside.
  static bool SharesLooks(const Work& work);
  void Define(const Work& work, Renderer renderer);
  bool Fill(const Work& work, Renderer renderer);
  bool Interpolate(const Work& work);
  bool EvaluateBlocks(const Work& work);
  bool SplatPoints(const Work& work);
  void SetUniforms(vtkShaderProgram* program, const Work& work) const;
  const vtkIndirectTarget& ActivateSurface(vtkShaderProgram* program, const Work& work) const;

  std::vector<std::unique_ptr<vtkIndirectTarget>> Levels; // [i] is level i + 1
  bool HalfFloats = true;
  vtkIndirectFullScreenProgram SmoothTexels{ "vtkIndirectSubsplatSmoothFS.glsl" };
  vtkIndirectFullScreenProgram OtherTexels{ "vtkIndirectSubsplatLevelFS.glsl" };
  vtkIndirectFullScreenProgram SmoothPixels{ "vtkIndirectSubsplatSmoothFS.glsl" };
  vtkIndirectFullScreenProgram OtherPixels{ "vtkIndirectSubsplatPixelFS.glsl" };
  vtkIndirectPointProgram TexelPoints{ "vtkIndirectSubsplatPointVS.glsl",
    "vtkIndirectSubsplatPointFS.glsl" };
  vtkIndirectPointProgram PixelPoints{ "vtkIndirectSubsplatPointVS.glsl",
    "vtkIndirectSubsplatPointFS.glsl" };
  // Of still frames, and of those that share looks into depth maps.
  vtkIndirectComputeProgram TexelBlocks[2] = { vtkIndirectComputeProgram(
                                                 "vtkIndirectSubsplatBlockCS.glsl"),
    vtkIndirectComputeProgram("vtkIndirectSubsplatBlockCS.glsl") };
  vtkIndirectComputeProgram PixelBlocks[2] = { vtkIndirectComputeProgram(
                                                 "vtkIndirectSubsplatBlockCS.glsl"),
    vtkIndirectComputeProgram("vtkIndirectSubsplatBlockCS.glsl") };
};

#endif
