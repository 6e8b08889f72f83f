// SPDX-License-Identifier: BSD-3-Clause
// Draws samples from the texels of lights' maps that send light: warps an even pattern by sums over
// squares of texels (vtkIndirectLibImportance.glsl). All work is done on the GPU; nothing is read
// back.
//
// A map of one face is sampled directly, a map of several faces by a chart of its directions. Nodes
// of four cells and their sums lie in two textures, which alternate from level to level, so that no
// texture is read while it is drawn to.
#pragma once

#include "OpenGL/vtkIndirectDataTexture.h"       // for a member
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "Senders/vtkIndirectMapSampler.h"       // for charts
#include "Senders/vtkIndirectPatternTexture.h"   // for the pattern

#include <vector> // for charts

class vtkIndirectLightMaps;

class vtkIndirectSampleWarp : public vtkIndirectResource
{
public:
  explicit vtkIndirectSampleWarp(vtkIndirectResource* owner);

  /**
   * This is the largest number of cells along the edge of a chart: one texel represents several
   * texels of larger maps. Drawing from all of 512 x 512 takes Mesa's llvmpipe 18 ms each time that
   * a map changes, from 1024 x 1024 directions 86 ms; the surfaces that this size resolves too
   * coarsely send a thousandth of the flux.
   */
  static constexpr int MostCells = 256;

  /**
   * Brings the samples up to date: turns the pattern's samples, whose layers are charts, into
   * samples of texels. Returns false, after an error, when OpenGL refuses.
   */
  bool Update(vtkOpenGLRenderWindow* window, const vtkIndirectLightMaps& maps,
    const vtkIndirectMapSampler::Drawing& drawing, const vtkIndirectPatternTexture& pattern);

  /** Binds the samples in place of a pattern. */
  void Activate(const vtkIndirectProgram& program) const { this->Samples.Activate(0, program); }

  /** Returns the cells along the edge of a chart, after Update. */
  int GetCells() const { return this->Cells; }

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  bool UpdateCharts(vtkOpenGLRenderWindow* window, const vtkIndirectLightMaps& maps);
  bool SumNodes(vtkOpenGLRenderWindow* window, const vtkIndirectLightMaps& maps, double occlusion);
  bool Warp(vtkOpenGLRenderWindow* window, const vtkIndirectLightMaps& maps,
    const vtkIndirectMapSampler::Drawing& drawing, const vtkIndirectPatternTexture& pattern);
  void ActivateCharts(const vtkIndirectProgram& program) const;
  void ActivateNodes(
    int parity, const vtkIndirectProgram& program, const char* lit, const char* flux) const;
  int FindLevelWidth(int level) const { return this->Columns * (this->Cells / 2) >> level; }

  // These are the inputs of the nodes.
  vtkMTimeType MapTime = 0;
  bool WithFlux = false;
  double Occlusion = 0.0;

  std::vector<float> Charts; // four numbers each
  int Cells = 2;             // along an edge of a chart, a power of two
  int Levels = 1;
  int Columns = 1; // columns of charts
  int Rows = 1;
  double Strongest = 1.0; // strength of the strongest light
  vtkIndirectDataTexture ChartTexture{ this };
  vtkIndirectTarget Even;
  vtkIndirectTarget Odd;
  vtkIndirectTarget Samples;
  vtkIndirectFullScreenProgram ImportanceProgram{ this, "vtkIndirectImportanceFS.glsl" };
  vtkIndirectFullScreenProgram SumProgram{ this, "vtkIndirectImportanceSumFS.glsl" };
  vtkIndirectFullScreenProgram WarpProgram{ this, "vtkIndirectWarpFS.glsl" };
};
