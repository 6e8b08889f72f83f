// SPDX-License-Identifier: BSD-3-Clause
// Every estimator with what it promises. Tests of all estimators go over this table: a new one
// joins them by a line in vtkIndirectEstimatorTable.cxx.
#ifndef vtkIndirectEstimatorTable_h
#define vtkIndirectEstimatorTable_h

#include <string> // for names
#include <vector> // for the table

class vtkIndirectIlluminationPass;

namespace vtkIndirectTest
{
struct EstimatorEntry
{
  /** Which senders the irradiance is the sum over with the disk kernel, to rounding. */
  enum SumType
  {
    ALL_TEXELS, // of all maps
    LIGHTS,     // those of the sampler
    OTHER       // it approximates a sum: only what holds for any irradiance can be asked
  };

  const char* Name;
  SumType Sum;
  /** The error against all texels falls as virtual lights grow, as Convergence.* demands. */
  bool Converges;
  /** It reads the lights' maps themselves: a headlight, which has none, is an error. */
  bool NeedsMaps;
  /** Relative rounding of the irradiance, beyond that of 32-bit floats: of its storage, or of where
   * it is looked up. */
  double Rounding;
  /** Share of a sender's radiance that it may show where the sum over lights is exactly zero. */
  double Blur;
  /** Puts the estimator into the pass, with about this many virtual lights. */
  void (*Install)(vtkIndirectIlluminationPass* pass, int numberOfLights);
};

const std::vector<EstimatorEntry>& GetEstimators();

/** Rounding of the estimator whose name a text begins with; 0 when there is none. */
double GetRounding(const std::string& text);
}

#endif
