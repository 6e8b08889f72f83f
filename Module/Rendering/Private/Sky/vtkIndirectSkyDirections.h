// SPDX-License-Identifier: BSD-3-Clause
// The directions that a frame sums the sky over, and the light of each. The directions of a moving
// frame are the first ones of a still frame, so that both use the same depth maps. A direction
// represents the part of the sky that is nearer to it than to other summed directions. A direction
// with much of all light, such as a sun's, is summed by itself, in the same way in both frames.
#pragma once

#include "OpenGL/vtkIndirectKey.h" // for a member

#include <glm/glm.hpp> // for directions
#include <map>         // for kept results
#include <vector>      // for lists

class vtkEnvironmentLight;
class vtkIndirectSkyProjection;

class vtkIndirectSkyDirections
{
public:
  /** A direction, and its light: radiance times solid angle. */
  struct Summand
  {
    size_t Number; // number of the direction
    glm::dvec3 Light;
    glm::dvec3 Direction; // unit, to the light's origin: for strong and narrow light its middle
    bool operator==(const Summand& other) const
    {
      return this->Number == other.Number && this->Light == other.Light &&
        this->Direction == other.Direction;
    }
  };

  /**
   * Finds the light of the first `count` of `still` directions, and of those that were added where
   * strong light is wide. Returns true if anything has changed since the last call.
   */
  bool Update(
    vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment, int count, int still);
  /**
   * Finds the same light, the strong directions' apart, by a finer lattice of `count` directions.
   */
  bool UpdateFiner(
    vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment, int count, int still);

  /** Returns the unit directions to the light that all frames together sum. */
  const std::vector<glm::dvec3>& GetLattice() const { return this->Lattice; }
  /** Returns the directions that have more than a 32nd of all light. */
  const std::vector<Summand>& GetStrong() const { return this->Strong; }
  /** Returns the other directions with light, without the light of the strong ones. */
  const std::vector<Summand>& GetOthers() const { return this->Others; }
  /**
   * Distributes the same light over fewer directions, given by ascending numbers: each represents
   * the part of the sky that is nearer to it than to the others. Fast if the numbers extend those
   * of the last call.
   */
  std::vector<Summand> Share(const std::vector<size_t>& numbers);

  /**
   * Unoccluded light of the others by the direction of a normal: that of the whole sky, and that of
   * the summed directions. Both are sums over the colours, divided by GetUnit. As in
   * vtkIndirectLibSky.glsl: four values for each texel, of which the first two count, and the
   * vectors.
   */
  struct OpenSky
  {
    std::vector<float> Texels;
    glm::vec3 Flux{ 0.0f };
    glm::vec3 SummedFlux{ 0.0f };
  };
  OpenSky MakeOpenSky(const std::vector<Summand>& summed);
  /** The same for the colours of these directions by themselves: three values of each texel count.
   */
  struct OpenColors
  {
    std::vector<float> Texels;
    glm::mat3 Flux{ 0.0f }; // a column for each colour
  };
  OpenColors MakeOpenColors(const std::vector<Summand>& summed) const;
  /** Returns a positive irradiance of the order of the others' irradiance. */
  double GetUnit() const { return this->Unit; }

  /** Makes the next Update find everything again. */
  void Forget() { this->Environment.Clear(); }

private:
  void FindLight(vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment);
  void ShareLattice();
  std::vector<Summand> FindLit(const std::vector<glm::dvec3>& light) const;
  void FindOthers(int count);

  std::vector<glm::dvec3> Lattice; // a still frame's directions, and added ones
  std::vector<Summand> Strong;
  std::vector<Summand> Others;
  std::map<int, std::vector<Summand>> Known; // others, by number of directions
  // These are the pieces of the environment that the others share. Each piece has the number of the
  // direction that it was last given to, and the cosine to that direction.
  struct Cell
  {
    glm::dvec3 Direction;
    glm::dvec3 Light;
    size_t Nearest;
    double Cosine;
  };
  std::vector<Cell> Cells;
  std::vector<size_t> Sharing;   // numbers of the last Share
  std::vector<glm::dvec3> Flux;  // of pieces of the sky: irradiance of surfaces that face them
  std::vector<float> OpenTexels; // made from Flux on the first request
  double Unit = 1.0;

  vtkIndirectKey Environment; // the last environment
  int Count = 0;
  int Still = 0;
};
