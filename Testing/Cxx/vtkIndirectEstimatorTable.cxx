// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectEstimatorTable.h"

#include "vtkIndirectIlluminationPass.h"
#include "vtkNew.h"
#include "vtkRSMGatherPass.h"
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
  pass->SetSampler(sampler);
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
}

const std::vector<EstimatorEntry>& GetEstimators()
{
  using Gather = vtkRSMGatherPass;
  using Sampler = vtkUniformLightSampler;
  using Entry = EstimatorEntry;
  static const std::vector<EstimatorEntry> table = {
    { "gather, all texels", Entry::ALL_TEXELS, true, false,
      InstallGather<Gather::ALL_TEXELS, Sampler::GRID, false> },
    { "gather, grid", Entry::LIGHTS, true, false,
      InstallGather<Gather::VIRTUAL_LIGHTS, Sampler::GRID, false> },
    { "gather, jittered", Entry::LIGHTS, true, false,
      InstallGather<Gather::VIRTUAL_LIGHTS, Sampler::JITTERED, false> },
    { "gather, low discrepancy", Entry::LIGHTS, true, false,
      InstallGather<Gather::VIRTUAL_LIGHTS, Sampler::LOW_DISCREPANCY, false> },
    // The error of interpolation stays, however many lights there are.
    { "gather, interpolated", Entry::OTHER, false, false,
      InstallGather<Gather::VIRTUAL_LIGHTS, Sampler::LOW_DISCREPANCY, true> },
    // Converges to the sum in its disk, which Radiometry.Neighborhood shows.
    { "gather, neighborhood", Entry::OTHER, false, true,
      InstallGather<Gather::NEIGHBORHOOD, Sampler::LOW_DISCREPANCY, false> },
  };
  return table;
}
}
