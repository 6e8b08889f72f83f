// SPDX-License-Identifier: BSD-3-Clause
// The directions that a frame sums the sky over, and what each of them stands for. Those of a
// moving frame are the first ones of a still frame's, so that both look into the same depth maps;
// each stands for what is nearer to it than to the others that are summed. What much of all light
// comes from, such as a sun, is summed by itself, and is the same in both.
#ifndef vtkIndirectSkyDirections_h
#define vtkIndirectSkyDirections_h

#include "vtkType.h" // for times

#include <glm/glm.hpp> // for directions
#include <map>         // for what is kept
#include <vector>      // for lists

class vtkEnvironmentLight;
class vtkIndirectSkyProjection;

class vtkIndirectSkyDirections
{
public:
  /** A direction, and what comes from there: radiance times solid angle. */
  struct Summand
  {
    size_t Number; // of the direction
    glm::dvec3 Light;
    glm::dvec3 Direction; // unit, to where it comes from: of what is strong and narrow its middle
    bool operator==(const Summand& other) const
    {
      return this->Number == other.Number && this->Light == other.Light &&
        this->Direction == other.Direction;
    }
  };

  /**
   * Finds what the first `count` of `still` directions stand for. Returns whether anything has
   * changed since the last call.
   */
  bool Update(
    vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment, int count, int still);

  /** Unit, to where the light comes from. */
  const glm::dvec3& GetDirection(size_t number) const { return this->Lattice[number]; }
  /** Whether more than a 32nd of an environment's light comes from one of 256 directions. */
  static bool HasStrong(vtkEnvironmentLight* environment);
  /** Those that more than a 32nd of all light comes from. */
  const std::vector<Summand>& GetStrong() const { return this->Strong; }
  /** The others from which light comes; without what the strong ones have. */
  const std::vector<Summand>& GetOthers() const { return this->Others; }
  /**
   * The same light in fewer directions, given by ascending numbers: each stands for what is nearer
   * to it than to the rest of these. Fast where there are more of them than last time.
   */
  std::vector<Summand> Share(const std::vector<size_t>& numbers);

  /**
   * Light of the others by the direction of a normal where nothing hides it: by all that they stand
   * for, and by those of the directions that are summed; both are sums over the colours, divided by
   * GetUnit. As in vtkIndirectLibSky.glsl: four values for each texel, of which the first two
   * count, and the vectors.
   */
  struct OpenSky
  {
    std::vector<float> Texels;
    glm::vec3 Flux{ 0.0f };
    glm::vec3 SummedFlux{ 0.0f };
  };
  OpenSky MakeOpenSky(const std::vector<Summand>& summed);
  /** Irradiance of the order of that of the others; positive. */
  double GetUnit() const { return this->Unit; }

  /** Says that nothing of it is to be kept. */
  void Forget() { this->Environment = nullptr; }

private:
  void FindLight(vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment);
  void FindOthers(int count);

  std::vector<glm::dvec3> Lattice; // at least 256 of them
  std::vector<Summand> Strong;
  std::vector<Summand> Others;
  std::map<int, std::vector<Summand>> Known; // others, by their number
  // Pieces of the environment that the others have between them; and by which direction's number
  // each was shared, last, and the cosine to it.
  struct Cell
  {
    glm::dvec3 Direction;
    glm::dvec3 Light;
    size_t Nearest;
    double Cosine;
  };
  std::vector<Cell> Cells;
  std::vector<size_t> Sharing;   // between which
  std::vector<glm::dvec3> Flux;  // of pieces of the sky: irradiance of what faces them
  std::vector<float> OpenTexels; // of these; empty before it is asked for
  double Unit = 1.0;

  vtkEnvironmentLight* Environment = nullptr; // whose light it is, and its time
  vtkMTimeType Time = 0;
  int Count = 0;
  int Still = 0;
};

#endif
