// SPDX-License-Identifier: BSD-3-Clause
// Illuminates the subsplats of a pyramid and interpolates from them down to pixels. Nichols and
// Wyman 2009, "Multiresolution splatting for indirect illumination", sections 3.4 and 3.5.
//
// Compute shaders work through the lists of split texels, four leaves for each, where the settings
// have Compute; else the full-screen passes that interpolate also sum the lights at leaves.
#ifndef vtkIndirectSubsplatIllumination_h
#define vtkIndirectSubsplatIllumination_h

#include "Multiresolution/vtkIndirectSubsplatPyramid.h" // for the pyramid
#include "OpenGL/vtkIndirectComputeProgram.h"           // for members

class vtkIndirectSubsplatIllumination
{
public:
  using Input = vtkIndirectEstimateInput;
  using Settings = vtkIndirectSubsplatSettings;

  /** Creates or resizes the levels; pixels: the image to be filled, whose depth they share. */
  bool Resize(vtkOpenGLRenderWindow* window, const vtkIndirectSubsplatPyramid& pyramid,
    const vtkIndirectTarget& pixels, bool halfFloats);

  /** Illuminates all levels but pixels, coarse to fine. */
  bool FillLevels(const Input& input, const Settings& settings, vtkIndirectSubsplatPyramid& pyramid,
    vtkIndirectLightBlock& lights);
  /** Illuminates the image, after the levels. */
  bool FillPixels(const Input& input, const Settings& settings, vtkIndirectSubsplatPyramid& pyramid,
    vtkIndirectLightBlock& lights, vtkIndirectTarget& pixels);

  /** Returns irradiance and vector irradiance of level `number`, from 1 on. */
  const vtkIndirectTarget& GetLevel(size_t number) const { return *this->Levels[number - 1]; }

  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  // The arguments of the steps below.
  struct Work
  {
    const Input& In;
    const Settings& Set;
    vtkIndirectSubsplatPyramid& Pyramid;
    vtkIndirectLightBlock& Lights;
    vtkIndirectTarget& Target; // of the level that is written
    size_t Number;             // of that level, 0 for pixels
  };
  // Tells whether neighbouring leaves share their look-ups in depth maps. They do in moving frames,
  // where the look-ups are half of the time and a shadow's border may be off by a leaf.
  static bool SharesLooks(const Work& work);
  void Define(const Work& work);
  bool Fill(const Work& work);
  bool Interpolate(const Work& work);
  bool EvaluateBlocks(const Work& work);
  void SetUniforms(vtkShaderProgram* program, const Work& work) const;
  const vtkIndirectTarget& ActivateSurface(vtkShaderProgram* program, const Work& work) const;

  std::vector<std::unique_ptr<vtkIndirectTarget>> Levels; // [i] is level i + 1
  bool HalfFloats = true;
  vtkIndirectFullScreenProgram SmoothTexels{ "vtkIndirectSubsplatSmoothFS.glsl" };
  vtkIndirectFullScreenProgram OtherTexels{ "vtkIndirectSubsplatLevelFS.glsl" };
  vtkIndirectFullScreenProgram SmoothPixels{ "vtkIndirectSubsplatSmoothFS.glsl" };
  vtkIndirectFullScreenProgram OtherPixels{ "vtkIndirectSubsplatPixelFS.glsl" };
  // One program for still frames, one for frames in which leaves share look-ups in depth maps.
  vtkIndirectComputeProgram TexelBlocks[2] = { vtkIndirectComputeProgram(
                                                 "vtkIndirectSubsplatBlockCS.glsl"),
    vtkIndirectComputeProgram("vtkIndirectSubsplatBlockCS.glsl") };
  vtkIndirectComputeProgram PixelBlocks[2] = { vtkIndirectComputeProgram(
                                                 "vtkIndirectSubsplatBlockCS.glsl"),
    vtkIndirectComputeProgram("vtkIndirectSubsplatBlockCS.glsl") };
};

#endif
