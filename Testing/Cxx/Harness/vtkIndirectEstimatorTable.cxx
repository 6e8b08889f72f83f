// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectEstimatorTable.h"
#include "vtkIndirectDetails.h"

#include "vtkImportanceLightSampler.h"
#include "vtkIndirectIlluminationPass.h"
#include "vtkIndirectSplattingPass.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkNew.h"
#include "vtkProxyAccumulationPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkRandomWalkLightSampler.h"
#include "vtkUniformLightSampler.h"

namespace vtkIndirectTest
{
namespace
{
void InstallSampler(vtkIndirectIlluminationPass* pass, int pattern, int numberOfLights)
{
  vtkNew<vtkUniformLightSampler> sampler;
  sampler->SetPattern(pattern);
  sampler->SetNumberOfLights(numberOfLights);
  // With warping, random samples hit some texels twice, whatever their number.
  sampler->SetLitTexels(pattern != vtkUniformLightSampler::JITTERED);
  pass->SetSampler(sampler);
  pass->SetErrorTolerance(0.0);
  pass->SetVisibilityToNone();
  pass->SetNumberOfBounces(1);
}

template <int Mode, int Pattern, bool Interpolated>
void InstallGather(vtkIndirectIlluminationPass* pass, int numberOfLights)
{
  vtkNew<vtkRSMGatherPass> gather;
  gather->SetMode(Mode);
  gather->SetInterpolation(Interpolated);
  gather->SetNumberOfSamples(numberOfLights);
  pass->SetEstimator(gather);
  InstallSampler(pass, Pattern, numberOfLights);
}

void InstallImportance(vtkIndirectIlluminationPass* pass, int numberOfLights)
{
  InstallGather<vtkRSMGatherPass::VIRTUAL_LIGHTS, 0, false>(pass, numberOfLights);
  vtkNew<vtkImportanceLightSampler> sampler;
  sampler->SetNumberOfLights(numberOfLights);
  pass->SetSampler(sampler);
}

// Drivers may truncate bits, 2^-10 each time that an interpolated value is stored: four levels.
constexpr double HalfFloats = 4e-3;

template <bool Finest>
void InstallMultiresolution(vtkIndirectIlluminationPass* pass, int numberOfLights)
{
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  if (Finest)
  {
    splatting->SetPlaneThreshold(0.0);
    SET_DETAIL(splatting, HalfFloats, false);
  }
  pass->SetEstimator(splatting);
  InstallSampler(pass, vtkUniformLightSampler::LOW_DISCREPANCY, numberOfLights);
}

template <bool All>
void InstallSplatting(vtkIndirectIlluminationPass* pass, int numberOfLights)
{
  vtkNew<vtkIndirectSplattingPass> splatting;
  if (All)
  {
    splatting->SetIntensityThreshold(0.0);
  }
  pass->SetEstimator(splatting);
  InstallSampler(pass, vtkUniformLightSampler::LOW_DISCREPANCY, numberOfLights);
}

// 11 and 16 hints along an edge, with fewer rays and voxels than by default, which would take most
// of these tests' time: extreme numbers are as hard at every hint.
template <bool Finer>
void InstallHints(vtkIndirectIlluminationPass* pass, int)
{
  vtkNew<vtkRadianceHintsPass> hints;
  pass->SetErrorTolerance(Finer ? 0.05 : 0.1);
  SET_DETAIL(hints, NumberOfRays, Finer ? 144 : 64);
  hints->SetOccupancyResolution(64);
  pass->SetEstimator(hints);
  pass->SetVisibilityToAuto(); // the grid needs its voxels to place hints
  pass->SetNumberOfBounces(1);
}

void InstallDefaults(vtkIndirectIlluminationPass* pass)
{
  const vtkNew<vtkIndirectIlluminationPass> fresh;
  pass->SetEstimator(nullptr);
  pass->SetSampler(nullptr);
  pass->SetVisibility(fresh->GetVisibility());
  pass->SetNumberOfBounces(fresh->GetNumberOfBounces());
  pass->SetErrorTolerance(fresh->GetErrorTolerance());
}

template <class Method, bool Paper>
void InstallMethod(vtkIndirectIlluminationPass* pass)
{
  InstallDefaults(pass);
  vtkNew<Method> method;
  if (Paper)
  {
    method->SetPresetToPaper();
  }
  pass->SetEstimator(method);
}

template <class Sampler>
void InstallSamplerAlone(vtkIndirectIlluminationPass* pass)
{
  InstallDefaults(pass);
  vtkNew<Sampler> sampler;
  pass->SetSampler(sampler);
}
}

const std::vector<EstimatorEntry>& GetEstimators()
{
  using Gather = vtkRSMGatherPass;
  using Sampler = vtkUniformLightSampler;
  using Entry = EstimatorEntry;
  static const std::vector<EstimatorEntry> table = {
    { "gather, all texels", Entry::ALL_TEXELS, true, false, 0.0, 0.0,
      InstallGather<Gather::ALL_TEXELS, Sampler::GRID, false> },
    { "gather, grid", Entry::LIGHTS, true, false, 0.0, 0.0,
      InstallGather<Gather::VIRTUAL_LIGHTS, Sampler::GRID, false> },
    { "gather, jittered", Entry::LIGHTS, true, false, 0.0, 0.0,
      InstallGather<Gather::VIRTUAL_LIGHTS, Sampler::JITTERED, false> },
    { "gather, low discrepancy", Entry::LIGHTS, true, false, 0.0, 0.0,
      InstallGather<Gather::VIRTUAL_LIGHTS, Sampler::LOW_DISCREPANCY, false> },
    { "gather, importance", Entry::LIGHTS, true, false, 0.0, 0.0, InstallImportance },
    // The error of interpolation is independent of the number of lights.
    { "gather, interpolated", Entry::OTHER, false, false, 0.0, 0.0,
      InstallGather<Gather::VIRTUAL_LIGHTS, Sampler::LOW_DISCREPANCY, true> },
    // Converges to the sum in its disk, see Radiometry.Neighborhood.
    { "gather, neighborhood", Entry::OTHER, false, true, 0.0, 0.0,
      InstallGather<Gather::NEIGHBORHOOD, Sampler::LOW_DISCREPANCY, false> },
    // As the interpolated gather; see Multiresolution.Defaults.
    { "multiresolution", Entry::OTHER, false, false, HalfFloats, 0.0,
      InstallMultiresolution<false> },
    // The error of the far field's interpolation is constant.
    { "splatting", Entry::OTHER, false, false, 0.0, 0.0, InstallSplatting<false> },
    { "splatting, all", Entry::LIGHTS, true, false, 0.0, 0.0, InstallSplatting<true> },
    // A field of a few harmonics at points of a grid, which is no sum over lights, for any number
    // of them. Order 2 leaves out band two of a hemisphere, an eighth of it at the horizon; lit
    // parts of a plane fill at most half a hemisphere: 1/16 and a little. Where the harmonics
    // cancel, rounding is that of the whole sum: 1e-6 over a hundredth of it.
    { "hints", Entry::OTHER, false, false, 1e-4, 0.07, InstallHints<false> },
    { "hints, finer", Entry::OTHER, false, false, 1e-4, 0.07, InstallHints<true> },
    { "multiresolution, finest", Entry::LIGHTS, true, false, 0.0, 0.0,
      InstallMultiresolution<true> },
  };
  return table;
}

const std::vector<UserChoice>& GetUserChoices()
{
  static const std::vector<UserChoice> choices = {
    { "default", false, InstallDefaults },
    { "default gather", false, InstallMethod<vtkRSMGatherPass, false> },
    { "default splatting", false, InstallMethod<vtkIndirectSplattingPass, false> },
    { "default hints", false, InstallMethod<vtkRadianceHintsPass, false> },
    { "gather of the paper", true, InstallMethod<vtkRSMGatherPass, true> },
    { "splatting of the paper", true, InstallMethod<vtkIndirectSplattingPass, true> },
    { "multiresolution of the paper", false, InstallMethod<vtkMultiresolutionSplattingPass, true> },
    { "hints of the paper", false, InstallMethod<vtkRadianceHintsPass, true> },
    { "random walk", false, InstallSamplerAlone<vtkRandomWalkLightSampler> },
    { "sky", false, InstallDefaults, UserChoice::SKY },
    { "sky by proxies", false, InstallMethod<vtkProxyAccumulationPass, false>, UserChoice::SKY },
    { "sky by proxies of the paper", false, InstallMethod<vtkProxyAccumulationPass, true>,
      UserChoice::SKY },
    { "area light", false, InstallDefaults, UserChoice::AREA_LIGHT },
    { "area light as virtual lights", false, InstallDefaults, UserChoice::VIRTUAL_LIGHTS },
    { "area light of the paper", false, InstallMethod<vtkMultiresolutionSplattingPass, true>,
      UserChoice::AREA_LIGHT },
    { "glass", false, InstallDefaults, UserChoice::GLASS },
  };
  return choices;
}

double GetRounding(const std::string& text)
{
  // The longest of several matching names counts.
  size_t longest = 0;
  double rounding = 0.0;
  for (const EstimatorEntry& estimator : GetEstimators())
  {
    const std::string name = estimator.Name;
    if (name.size() > longest && text.compare(0, name.size(), name) == 0)
    {
      longest = name.size();
      rounding = estimator.Rounding;
    }
  }
  return rounding;
}
}
