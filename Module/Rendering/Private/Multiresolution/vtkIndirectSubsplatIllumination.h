// SPDX-License-Identifier: BSD-3-Clause
// Illuminates the subsplats of a pyramid and interpolates from them down to pixels. Nichols and
// Wyman 2009, "Multiresolution splatting for indirect illumination", sections 3.4 and 3.5. Compute
// shaders sum lights for lists of split texels, four leaves an invocation; without compute shaders
// full-screen passes, one for each level, sum the lights of their leaves.
#pragma once

#include "Multiresolution/vtkIndirectSubsplatPyramid.h" // for the pyramid
#include "OpenGL/vtkIndirectComputeProgram.h"           // for members
#include "OpenGL/vtkIndirectResource.h"                 // for the base class

class vtkIndirectSubsplatIllumination : public vtkIndirectResource
{
public:
  using vtkIndirectResource::vtkIndirectResource;
  using Input = vtkIndirectEstimateInput;
  using Settings = vtkIndirectSubsplatSettings;

  /** Creates or resizes the levels. */
  bool Resize(
    vtkOpenGLRenderWindow* window, const vtkIndirectSubsplatPyramid& pyramid, bool halfFloats);

  /** Illuminates all levels but pixels, coarse to fine. */
  bool FillLevels(const Input& input, const Settings& settings, vtkIndirectSubsplatPyramid& pyramid,
    vtkIndirectLightBlock& lights);
  /** Fills the image from these levels. */
  bool FillPixels(const Input& input, const Settings& settings, vtkIndirectSubsplatPyramid& pyramid,
    vtkIndirectLightBlock& lights, vtkIndirectTarget& pixels);

  /** Returns the irradiance, vector irradiance and their states at level `number`, from 1 on. */
  const vtkIndirectTarget& GetLevel(size_t number) const { return *this->Levels[number - 1]; }

protected:
  void ReleaseOwn(vtkWindow*) override { this->Levels.clear(); }

private:
  // This is the data that the steps below share.
  struct Work
  {
    const Input& In;
    const Settings& Set;
    vtkIndirectSubsplatPyramid& Pyramid;
    vtkIndirectLightBlock& Lights;
    vtkIndirectTarget& Target; // target of the written level
    size_t Number;             // number of that level, 0 for pixels
  };
  // Returns true if neighbouring leaves share shadow look-ups: in moving frames, where look-ups
  // take half of the time and a shadow's border may be off by a leaf.
  static bool SharesLooks(const Work& work);
  /** Returns true if the level above is not split. */
  static bool IsBelowFinest(const Work& work);
  /** Kinds of stages for texels that are not inside one surface. */
  enum OtherType
  {
    SPLITS,    // children of split texels are evaluated
    EVALUATES, // below the finest level: texels without a sample on their surface are evaluated
    NEAREST,   // below the finest level: such texels take the nearest sample
    NUMBER_OF_OTHERS
  };
  static OtherType FindOther(const Work& work);
  void Define(const Work& work);
  bool Fill(const Work& work);
  bool Interpolate(const Work& work);
  bool EvaluateBlocks(const Work& work);
  void SetUniforms(const vtkIndirectProgram& program, const Work& work) const;
  void ActivateSurface(const vtkIndirectProgram& program, const Work& work) const;

  std::vector<std::unique_ptr<vtkIndirectTarget>> Levels; // [i] is level i + 1
  bool HalfFloats = true;
  vtkIndirectFullScreenProgram SmoothTexels{ this, "vtkIndirectSubsplatSmoothFS.glsl" };
  vtkIndirectFullScreenProgram OtherTexels[NUMBER_OF_OTHERS] = {
    { this, "vtkIndirectSubsplatLevelFS.glsl" }, { this, "vtkIndirectSubsplatLevelFS.glsl" },
    { this, "vtkIndirectSubsplatLevelFS.glsl" }
  };
  vtkIndirectFullScreenProgram SmoothPixels{ this, "vtkIndirectSubsplatSmoothFS.glsl" };
  vtkIndirectFullScreenProgram OtherPixels[NUMBER_OF_OTHERS] = {
    { this, "vtkIndirectSubsplatPixelFS.glsl" }, { this, "vtkIndirectSubsplatPixelFS.glsl" },
    { this, "vtkIndirectSubsplatPixelFS.glsl" }
  };
  // For still frames, and for frames with shared look-ups.
  vtkIndirectComputeProgram TexelBlocks[2] = { { this, "vtkIndirectSubsplatBlockCS.glsl" },
    { this, "vtkIndirectSubsplatBlockCS.glsl" } };
  vtkIndirectComputeProgram PixelBlocks[2] = { { this, "vtkIndirectSubsplatBlockCS.glsl" },
    { this, "vtkIndirectSubsplatBlockCS.glsl" } };
};
