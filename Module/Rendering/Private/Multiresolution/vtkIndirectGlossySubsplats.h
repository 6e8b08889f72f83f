// SPDX-License-Identifier: BSD-3-Clause
// Indirect light in receivers' specular lobes, refined light by light. Nichols and Wyman 2009,
// "Multiresolution splatting for indirect illumination", section 4.1: a list of subsplats for each
// virtual light, refined by the computed illumination.
//
// From the coarsest level down, each listed texel holds the set of lights that its level does not
// resolve. A light ends at a texel if its values at the children agree with the interpolation of
// its coarse samples; otherwise the residual is added to the children's level. The picture of a
// level is the interpolated picture of the level above plus its residuals, so lights that end on
// different levels stay separate.
#pragma once

#include "Multiresolution/vtkIndirectGlossyLists.h"     // for members
#include "Multiresolution/vtkIndirectSubsplatPyramid.h" // for the pyramid
#include "OpenGL/vtkIndirectComputeProgram.h"           // for members
#include "OpenGL/vtkIndirectFullScreenProgram.h"        // for members
#include "OpenGL/vtkIndirectResource.h"                 // for the base class

#include <memory> // for levels
#include <vector> // for levels

class vtkIndirectGlossySubsplats : public vtkIndirectResource
{
public:
  using vtkIndirectResource::vtkIndirectResource;
  using Input = vtkIndirectEstimateInput;
  using Settings = vtkIndirectSubsplatSettings;

  /** Returns true if the lists of a frame fit into the largest buffer of the driver. */
  static bool Fits(const vtkIndirectSubsplatPyramid& pyramid, int numberOfLights);

  /** Creates or resizes the levels. Returns false, after an error, if OpenGL refuses. */
  bool Resize(
    vtkOpenGLRenderWindow* window, const vtkIndirectSubsplatPyramid& pyramid, bool halfFloats);

  /**
   * Fills `glossy`, of the frame's size. irradiance: of the same frame, in the same storage; a
   * light may be left out or interpolated up to an error of GlossyThreshold times the irradiance
   * over the number of lights.
   */
  bool Fill(const Input& input, const Settings& settings, const vtkIndirectSubsplatPyramid& pyramid,
    vtkIndirectLightBlock& lights, const vtkIndirectTarget& irradiance, vtkIndirectTarget& glossy);

  /** Returns the lights evaluated at texels and pixels in the last frame. Waits for the GPU. */
  double CountEvaluations() const;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  struct Work; // data that the steps below share
  bool FillLobes(const Work& work);
  bool ListFirst(const Work& work);
  bool Interpolate(const Work& work, size_t number, vtkIndirectTarget& target);
  bool Evaluate(const Work& work, size_t number, vtkIndirectTarget& target, bool whole);
  void SetLevelUniforms(const vtkIndirectProgram& program, const Work& work, size_t number) const;
  void ActivateLevel(const vtkIndirectProgram& program, const Work& work, size_t number) const;

  std::vector<std::unique_ptr<vtkIndirectTarget>> Lobes;  // [i] is level i + 1
  std::vector<std::unique_ptr<vtkIndirectTarget>> Levels; // the same
  bool HalfFloats = true;
  size_t FinestLevel = 0; // no light is resolved further than on this level
  vtkIndirectGlossyLists Lists{
    this
  }; // level n: list 2 n - 2 of split texels, 2 n - 1 of whole ones
  vtkIndirectFullScreenProgram LobeOfPixels{ this, "vtkIndirectGlossyLobeFS.glsl" };
  vtkIndirectFullScreenProgram Lobe{ this, "vtkIndirectGlossyLobeFS.glsl" };
  vtkIndirectFullScreenProgram UpsamplePixels{ this, "vtkIndirectGlossyUpsampleFS.glsl" };
  vtkIndirectFullScreenProgram Upsample{ this, "vtkIndirectGlossyUpsampleFS.glsl" };
  vtkIndirectComputeProgram First{ this, "vtkIndirectGlossyFirstCS.glsl" };
  // The first two are for texels, the others for pixels: under split texels, under whole ones.
  vtkIndirectComputeProgram Sums[4] = { { this, "vtkIndirectGlossyCS.glsl" },
    { this, "vtkIndirectGlossyCS.glsl" }, { this, "vtkIndirectGlossyCS.glsl" },
    { this, "vtkIndirectGlossyCS.glsl" } };
};
