// SPDX-License-Identifier: BSD-3-Clause
// Irradiance that comes directly from an environment: summed over directions that are fixed in the
// world, each with a depth map of the scene. Turning or changing the environment changes weights
// alone; maps are kept while the camera moves.
//
// A pixel of a still frame looks up all directions. A pixel of a moving one looks up some of them,
// and the pixels of a block together look up all (Keller and Heidrich 2001, "Interleaved
// sampling"). Pixels with the same directions are drawn together (Segovia, Iehl, Mitanchey, Peroche
// 2006, "Non-interleaved deferred shading of interleaved sample patterns"), and then averaged over
// neighbours on their surface.
//
// The directions give the visible share of their light: the irradiance is this share of the
// unoccluded sky's irradiance, which is known. So directions that a frame cannot choose in number
// or place, such as those of neighbours, change the hidden share alone.
//
// A direction represents a part of the sky and has the sharp shadow of the part's middle: the share
// is smoothed over neighbours on the surface, by the part's width at the distance of what hides.
//
// Where the picture reaches far, each direction has a second map, of the nearer part of the picture
// alone.
//
// A direction with much of the light, such as a sun's, has a finer map and filtered edges of its
// shadows, at every pixel.
//
// The sky of a finer picture has more directions than maps fit into memory: each batch draws and
// sums some of them, and the last one makes the sum irradiance.
//
// Limits: shadows between those of the directions are lost, as are surfaces finer than a tile's
// texel (too dark in relief, too bright at contacts).
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectTarget.h"            // for a member
#include "OpenGL/vtkIndirectUniformBlock.h"      // for a member
#include "Sky/vtkIndirectSkyDirections.h"        // for a member
#include "Sky/vtkIndirectSkyMaps.h"              // for members
#include "Sky/vtkIndirectSkyReprojection.h"      // for a member
#include "Sky/vtkIndirectSkySmoothing.h"         // for a member
#include "Sums/vtkIndirectFrameLight.h"          // for the base class

#include <glm/glm.hpp> // for blocks
#include <string>      // for definitions
#include <vector>      // for lists

struct vtkIndirectFrame;

class vtkIndirectSkyGather : public vtkIndirectFrameLight
{
public:
  /**
   * first: null, or the sky of a picture that this one, summed in batches, is finer than. Its
   * estimate is REFINING, and without light, but for the last batch.
   */
  vtkIndirectSkyGather(vtkIndirectResource* owner, vtkIndirectDepthMaps& maps,
    const vtkIndirectSkyGather* first = nullptr);

  /**
   * Sets how a finer sky is summed, before its first batch: directions of a batch, texels along an
   * edge of a map, and the edge of the blocks of pixels that share directions.
   */
  void SetBatches(int directions, int texels, int step);
  /**
   * Keeps the shares of a finer sky, whose last batch is summed, for moving frames. Returns false,
   * after an error, when OpenGL refuses.
   */
  bool TakeShares(const Input& input, const vtkIndirectSkyGather& finer);
  /**
   * Returns the median of the shares of the sky that pixels see of which some is seen; 1 if a still
   * frame has not found them.
   */
  double FindMedianShare() const;

  void AppendTo(vtkIndirectKey& key, const Input& input) const override;
  /**
   * Asks for maps of strong directions, and for those of the other directions in an order that
   * spreads any number of them over the sky. The directions that have maps represent the whole sky.
   */
  bool Update(const Input& input) override;
  int GetNumberOfTilesLeft() const override
  {
    return this->Strong.GetAtlas().GetNumberOfTilesLeft() +
      this->Others.GetAtlas().GetNumberOfTilesLeft();
  }
  vtkIndirectEstimate MakeEstimate(const Input& input) override;
  void AddToReport(vtkIndirectReport& report) const override;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  using Summand = vtkIndirectSkyDirections::Summand;

  using Terms = vtkIndirectSkyMaps::Terms;

  // Largest number of directions that a pixel without neighbours on its surface looks up by itself;
  // further directions are skipped.
  static constexpr int OwnBlock = 64;

  void UpdateDirections(const Input& input);
  void UpdateFiner(const Input& input);
  const vtkIndirectSkyMaps& GetStrong() const
  {
    return this->First ? this->First->Strong : this->Strong;
  }
  void ChooseSummed();
  Terms MakeTerms(const std::vector<Summand>& summands, bool strong) const;
  Terms MakeBatch(const vtkIndirectLightBatch& batch) const;
  Terms MakeOwnBatch(const vtkIndirectLightBatch& batch) const;
  void SetBlock(const Input& input, const vtkIndirectProgram& program,
    const vtkIndirectSkyMaps& maps, const Terms& terms, size_t first, size_t size);
  bool UpdateOpenSky(const Input& input);
  bool Resize(const Input& input);
  bool SumAll(const Input& input);
  bool AddBatch(const Input& input);
  std::string GetDefinitions(int block, int step) const;
  bool MapsHaveChanged() const;
  void Activate(
    const Input& input, const vtkIndirectSkyMaps* maps, const vtkIndirectProgram& program);
  bool SumOthers(const Input& input, Terms terms);
  bool FilterRows(const Input& input);
  bool FilterColumns(const Input& input);
  double FindPartAngle(const Input& input) const;
  bool Smooth(const Input& input);
  bool SumStrong(const Input& input);
  bool SumOpen(const Input& input);

  const vtkIndirectSkyGather* const First;
  vtkIndirectTarget Irradiance;
  vtkIndirectTarget Sums[2]; // sums of pixels' own directions; of still and moving frames
  vtkIndirectTarget Rows;    // sums over neighbours in the row
  vtkIndirectSkySmoothing Smoothing{ this };
  vtkIndirectSkyReprojection Reprojection{ this };
  vtkIndirectTarget OpenSky;
  vtkIndirectTarget Open;       // Irradiance if nothing hid the sky, for surfaces that catch light
  vtkIndirectTarget OpenColors; // colours of the directions in OpenSky
  vtkIndirectSkyMaps Strong;    // of directions with much of the light
  vtkIndirectSkyMaps Others;
  vtkIndirectSkyDirections Directions;
  std::vector<Summand> Summed; // summed directions of the others: those with maps represent all
  vtkIndirectUniformBlock Block{ this, "vtkiSkyBlock" };

  // Programs for still and moving frames, which alternate too often to be built again each time.
  vtkIndirectFullScreenProgram SumKernels[2]{ { this, "vtkIndirectSkyFS.glsl" },
    { this, "vtkIndirectSkyFS.glsl" } };
  vtkIndirectFullScreenProgram ColumnKernels[2]{ { this, "vtkIndirectSkyFilterFS.glsl" },
    { this, "vtkIndirectSkyFilterFS.glsl" } };
  vtkIndirectFullScreenProgram RowKernel{ this, "vtkIndirectSkyFilterFS.glsl" };
  vtkIndirectFullScreenProgram StrongKernel{ this, "vtkIndirectSkyFS.glsl" };

  vtkIndirectFullScreenProgram OpenKernel{ this, "vtkIndirectSkyOpenFS.glsl" };

  bool OpenSkyIsThere = false;
  bool OpenColorsAreThere = false;
  glm::mat3 ColorFlux{ 0.0f };
  glm::vec3 OpenFlux{ 0.0f };
  glm::vec3 SummedFlux{ 0.0f };
  bool Visible = false;
  bool Keeps = false;      // the shares of a moving frame are kept for the next frame
  bool KeepsStill = false; // those of a still frame are
  int Step = 1;            // edge of the blocks of pixels that share directions, in the last frame
  int DirectionsOfBatch = 0;
  int TexelsOfBatch = 0;
};
