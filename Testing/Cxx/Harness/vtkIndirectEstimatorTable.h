// SPDX-License-Identifier: BSD-3-Clause
// Every estimator with its promises. Tests of all estimators use this table: a new estimator joins
// them by a line in vtkIndirectEstimatorTable.cxx.
#ifndef vtkIndirectEstimatorTable_h
#define vtkIndirectEstimatorTable_h

#include <string> // for names
#include <vector> // for the table

class vtkIndirectIlluminationPass;

namespace vtkIndirectTest
{
struct EstimatorEntry
{
  /** Senders whose sum with the disk kernel is the irradiance, up to rounding. */
  enum SumType
  {
    ALL_TEXELS, // of all maps
    LIGHTS,     // those of the sampler
    OTHER       // an approximation: only general properties of irradiance are tested
  };

  const char* Name;
  SumType Sum;
  /** The error against all texels falls as virtual lights grow, as Convergence.* demands. */
  bool Converges;
  /** It reads the lights' maps: a headlight, which has none, is an error. */
  bool NeedsMaps;
  /** Relative rounding of the irradiance, beyond that of 32-bit floats, by its storage or its
   * look-up. */
  double Rounding;
  /** Largest share of a sender's radiance at receivers where the sum over lights is exactly
   * zero. */
  double Blur;
  /** Puts the estimator into the pass, with about this many virtual lights. */
  void (*Install)(vtkIndirectIlluminationPass* pass, int numberOfLights);
};

const std::vector<EstimatorEntry>& GetEstimators();

/** A choice as users make it: visibility, bounces, tolerance and lights are left to the pass. */
struct UserChoice
{
  /** Additions to the scene. */
  enum AdditionType
  {
    NOTHING,
    SKY,            // a uniform one
    AREA_LIGHT,     // a rectangle over the scene, by its default method
    VIRTUAL_LIGHTS, // the same as virtual lights
    GLASS           // a ball of glass in the middle of the scene
  };

  const char* Name;
  /** It reads the lights' maps: a headlight, which has none, is an error. */
  bool NeedsMaps;
  void (*Install)(vtkIndirectIlluminationPass* pass);
  AdditionType Addition = NOTHING;
};

/**
 * Returns the methods and samplers at their defaults, the methods' presets PAPER, and the default
 * with each addition to the scene.
 */
const std::vector<UserChoice>& GetUserChoices();

/** Rounding of the estimator with whose name a text begins; 0 if there is none. */
double GetRounding(const std::string& text);
}

#endif
