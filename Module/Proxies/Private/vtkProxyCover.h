// SPDX-License-Identifier: BSD-3-Clause
// Covers a surface with spheres: candidates, a greedy choice, steps towards the least squared
// distance.
#pragma once

#include "vtkProxySolid.h" // for the interior

/**
 * Each sphere extends beyond the solid by at most an error, and each sample of the surface is
 * outside of a sphere by at most that. Lengths are those of vtkProxySurface.
 */
class vtkProxyCover
{
public:
  vtkProxyCover(const vtkProxySurface& surface, const vtkProxySolid& solid, int samples);

  /** The spheres of the greedy choice for an error; empty if they are more than `most`.
   */
  std::vector<vtkProxySphere> CoverWithin(double error, int most) const;
  /** The least error for which there are at most `count` spheres, within 1 % of it or 2 % of them.
   */
  double CoverWith(int count, std::vector<vtkProxySphere>& spheres) const;
  /** Moves and resizes spheres towards the least mean squared distance of surface and union. */
  void Refine(std::vector<vtkProxySphere>& spheres, double error, int steps) const;
  /** Adds spheres until denser samples are covered, too. */
  void Repair(std::vector<vtkProxySphere>& spheres, double error, int samples) const;

private:
  struct Sample
  {
    glm::dvec3 Point{ 0.0 };
    double Weight = 0.0;
    enum
    {
      Skin,    // surface of a solid
      Sheet,   // surface that encloses no volume
      Interior // inside of a solid
    } Kind = Skin;
    double Depth = 0.0;       // distance of an interior sample from the surface
    glm::dvec3 Inward{ 0.0 }; // inward direction of a skin sample
  };
  struct Candidate
  {
    glm::dvec3 Center{ 0.0 };
    double Depth = 0.0;
    bool Sheet = false;
  };

  std::vector<Sample> MakeSamples(int count) const;
  Candidate MakeCandidate(const Sample& sample) const;
  std::vector<Candidate> FindDepths(const std::vector<Candidate>& candidates) const;
  /** Merges candidates that differ little compared with an error: keeps the deepest. */
  static std::vector<Candidate> Thin(const std::vector<Candidate>& candidates, double error);
  static vtkProxySphere MakeSphere(const Candidate& candidate, double error);
  static bool Covers(const vtkProxySphere& sphere, const Sample& sample, double error);
  bool Choose(const std::vector<Sample>& samples, const std::vector<Candidate>& all, double error,
    int most, std::vector<vtkProxySphere>& spheres) const;

  const vtkProxySurface& Surface;
  const vtkProxySolid& Solid;
  std::vector<Sample> Samples;
  std::vector<Candidate> Candidates;
};
