// SPDX-License-Identifier: BSD-3-Clause
// The light that the hints hold: brought to them from the maps, bounced, and looked up.
#ifndef vtkIndirectHintFields_h
#define vtkIndirectHintFields_h

#include "Frame/vtkIndirectEstimate.h"            // for the input
#include "OpenGL/vtkIndirectFullScreenProgram.h"  // for members
#include "OpenGL/vtkIndirectTarget.h"             // for members
#include "RadianceHints/vtkIndirectHintDetails.h" // for settings

#include <memory> // for targets
#include <vector> // for read-back

class vtkIndirectHintGrid;

class vtkIndirectHintFields
{
public:
  using Input = vtkIndirectEstimateInput;

  struct Settings : vtkIndirectHintDetails
  {
    int Layout = 0; // VTKI_HINT_LAYOUT
    int Bounces = 1;
    int NumberOfSamples = 40;
    bool Visibility = false; // the grid has masks and rays
    bool DepthOcclusion = false;
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
