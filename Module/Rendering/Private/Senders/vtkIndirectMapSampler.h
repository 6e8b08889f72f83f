// SPDX-License-Identifier: BSD-3-Clause
// Virtual lights chosen among the texels of the lights' maps. Subclasses make a pattern of map
// coordinates; this class turns it into lights on the GPU.
//
// A light drawn from M texels with probability density p counts 1/p texels, in B A and in A alike,
// so the sums over all lights do not depend on how many there are.
#pragma once

#include "Senders/vtkIndirectSampler.h"

#include <glm/glm.hpp> // for places
#include <memory>      // for the internals
#include <vector>      // for patterns

class vtkIndirectMapSampler : public vtkIndirectSampler
{
public:
  explicit vtkIndirectMapSampler(vtkVirtualLightSampler* owner = nullptr);
  ~vtkIndirectMapSampler() override;

  /**
   * This is a rectangle of texels that lights are drawn from: a face of a map, or the geometry
   * buffer.
   */
  struct Source
  {
    int Layer = 0;
    int Light = 0; // sources of one light share its lights
    int Size[2] = { 1, 1 };
    bool Disk = false; // only the inscribed disk is lit
    // For faces of a cube: cosine of the cone of light about the face's axis, -1 for all
    // directions. 2: the source is not of a cube.
    double CosCone = 2.0;
    // The part that a window shows again, which is another source: its middle, from 0 to 1, and
    // half its width; 0: none.
    glm::dvec2 MiddleOfWindow{ 0.0 };
    double HalfWindow = 0.0;

    bool operator==(const Source& other) const
    {
      return this->Layer == other.Layer && this->Light == other.Light &&
        this->Size[0] == other.Size[0] && this->Size[1] == other.Size[1] &&
        this->Disk == other.Disk && this->CosCone == other.CosCone &&
        this->MiddleOfWindow == other.MiddleOfWindow && this->HalfWindow == other.HalfWindow;
    }
  };

  /** A choice: map coordinates in [0,1), layer, number of texels that it represents. */
  struct Sample
  {
    float U;
    float V;
    float Layer;
    float Texels;
  };

  /**
   * Fills a pattern for these sources. The texels that a source's samples represent add up to the
   * source's texels, without those that its window shows.
   */
  virtual void MakePattern(const std::vector<Source>& sources, std::vector<Sample>& pattern) = 0;

  /**
   * Returns true if windows of parallel maps are sources too, after all faces; the default is
   * false.
   */
  virtual bool TakesWindows() const { return false; }

  /** Says how the pattern's places are warped, so that more of them lie where more light comes
   * from. */
  struct Drawing
  {
    enum Importance
    {
      NOTHING,    // the pattern's places are texels of the map, lit or not
      LIT_TEXELS, // texels that send light are drawn with equal probability
      FLUX // texels are drawn by the light that they send, over all lights of the scene together
    };
    Importance By = NOTHING;
    double Evenness = 0.0;    // share of samples drawn with equal probability within each light
    int Method = 0;           // VTKI_WARP_APART or VTKI_WARP_TOGETHER
    int Levels = VTK_INT_MAX; // number of levels of the warp, from the coarsest on
    bool Modulated = false;   // lights lose the part of their light that open surfaces would send
    double Occlusion = 0.0;   // how much more often surfaces near other surfaces are drawn
    double ShareOfArea = 1.0; // area of lights' disks over the area that they represent
  };
  virtual Drawing GetDrawing() const { return {}; }

  bool Update(const Input& input) override;
  vtkIndirectMapSampler* GetHeadlightPattern() override { return this; }

private:
  bool DrawLobes(const Input& input, bool warped);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
