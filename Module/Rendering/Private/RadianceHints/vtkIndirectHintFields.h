// SPDX-License-Identifier: BSD-3-Clause
// The light stored in the hints: injected from the maps, bounced, and looked up.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h"  // for members
#include "OpenGL/vtkIndirectResource.h"           // for the base class
#include "OpenGL/vtkIndirectTarget.h"             // for members
#include "Plan/vtkIndirectEstimate.h"             // for the input
#include "RadianceHints/vtkIndirectHintDetails.h" // for settings

#include <memory> // for targets
#include <vector> // for read-back

class vtkIndirectHintGrid;

class vtkIndirectHintFields : public vtkIndirectResource
{
public:
  using Input = vtkIndirectEstimateInput;

  struct Settings : vtkIndirectHintDetails
  {
    int Layout = 0; // VTKI_HINT_LAYOUT
    int Bounces = 1;
    bool Visibility = false; // the grid has masks and rays
    int NumberOfSamples = 40;
    double MapCoverage = 1.0;
    int NumberOfBounceSamples = 32;
    double BounceRange = 1.0; // over the scene's diagonal; the unit of stored distances
    bool LookupRotation = false;
    int NumberOfDepthSamples = 0; // 0: the eye's depth hides nothing
    double DepthAttenuation = 0.6;
  };

  explicit vtkIndirectHintFields(vtkIndirectResource* owner);
  ~vtkIndirectHintFields() override;

  /** Computes the fields of all active hints. Returns false, after an error, if it cannot. */
  bool Fill(const Input& input, const Settings& settings, vtkIndirectHintGrid& grid);

  /** Definitions for a stage with vtkIndirectHintLookup.glsl, which must be rebuilt if they
   * change. */
  static std::string GetLookupDefinitions(const Settings& settings, int grids);
  /** Binds the stage's textures. */
  void ActivateLookup(const Input& input, const Settings& settings, vtkIndirectHintGrid& grid,
    const vtkIndirectProgram& program);

  /** Returns the textures of the current field, four floats a hint; empty before the first Fill. */
  std::vector<std::vector<float>> ReadBack() const;
  int GetLayout() const { return this->Layout; }

private:
  bool Resize(const Input& input, const Settings& settings, int rows);
  bool Inject(const Input& input, const Settings& settings, vtkIndirectHintGrid& grid);
  bool Reflect(
    const Input& input, const Settings& settings, vtkIndirectHintGrid& grid, const float albedo[4]);
  bool Bounce(const Input& input, const Settings& settings, vtkIndirectHintGrid& grid);
  void ActivateField(int field, const vtkIndirectProgram& program);

  // The first bounce, all bounces, and the previous sum while bounces go from hint to hint.
  std::unique_ptr<vtkIndirectTarget> Fields[3];
  int Layout = -1;
  int Current = 0; // field for look-ups
  vtkIndirectTarget Radiosity;
  vtkIndirectFullScreenProgram DenseKernel;
  vtkIndirectFullScreenProgram SampledKernel;
  vtkIndirectFullScreenProgram CopyKernel;
  vtkIndirectFullScreenProgram RadiosityKernel;
  vtkIndirectFullScreenProgram SurfacesKernel;
  vtkIndirectFullScreenProgram ExchangeKernel;
};
