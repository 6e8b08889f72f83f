// SPDX-License-Identifier: BSD-3-Clause
// The light that the hints hold: brought to them from the maps, bounced, and looked up.
#ifndef vtkIndirectHintFields_h
#define vtkIndirectHintFields_h

#include "Frame/vtkIndirectEstimate.h"           // for the input
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members

#include <memory> // for targets
#include <vector> // for read-back

class vtkIndirectHintGrid;

class vtkIndirectHintFields
{
public:
  using Input = vtkIndirectEstimateInput;

  /** As the properties of vtkRadianceHintsPass of these names. */
  struct Settings
  {
    int Layout = 0; // VTKI_HINT_LAYOUT
    int Bounces = 1;
    int NumberOfSamples = 40;
    double Coverage = 1.0;
    bool Softening = true;
    bool Deringing = true;
    bool FacingWeights = true;
    bool Visibility = false; // the grid has masks and rays
    bool AlbedoVolume = true;
    bool FromHints = false; // bounces
    int NumberOfBounceSamples = 32;
    double BounceRange = 1.0;
    int NumberOfLookups = 1;
    bool LookupRotation = false;
    int NumberOfDepthSamples = 0; // 0: off
    double DepthAttenuation = 0.6;
  };

  vtkIndirectHintFields();
  ~vtkIndirectHintFields();

  /** Computes the fields of all active hints. Returns false, after an error, when it cannot. */
  bool Fill(const Input& input, const Settings& settings, vtkIndirectHintGrid& grid);

  /** What a stage with vtkIndirectHintLookup.glsl begins with, to be built anew for others. */
  static std::string GetLookupDefinitions(const Settings& settings, int grids);
  /** Binds what it reads; pair with Deactivate. */
  void ActivateLookup(const Input& input, const Settings& settings, vtkIndirectHintGrid& grid,
    vtkShaderProgram* program);
  void Deactivate(const Input& input, vtkIndirectHintGrid& grid);

  /** Textures of the field that is looked up, four floats a hint; empty before the first Fill. */
  std::vector<std::vector<float>> ReadBack() const;
  int GetLayout() const { return this->Layout; }

  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  bool Resize(const Input& input, const Settings& settings, int rows);
  bool Inject(const Input& input, const Settings& settings, vtkIndirectHintGrid& grid);
  bool Reflect(
    const Input& input, const Settings& settings, vtkIndirectHintGrid& grid, const float albedo[4]);
  bool Bounce(const Input& input, const Settings& settings, vtkIndirectHintGrid& grid);
  void ActivateField(int field, vtkShaderProgram* program);

  // The first bounce, all bounces, and those before while bounces go from hint to hint.
  std::unique_ptr<vtkIndirectTarget> Fields[3];
  int Layout = -1;
  int Current = 0; // which of them is looked up
  vtkIndirectTarget Radiosity;
  vtkIndirectFullScreenProgram DenseKernel;
  vtkIndirectFullScreenProgram SampledKernel;
  vtkIndirectFullScreenProgram CopyKernel;
  vtkIndirectFullScreenProgram RadiosityKernel;
  vtkIndirectFullScreenProgram SurfacesKernel;
  vtkIndirectFullScreenProgram ExchangeKernel;
};

#endif
