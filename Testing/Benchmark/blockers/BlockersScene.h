// SPDX-License-Identifier: BSD-3-Clause
// A scene of spheres, or of a mesh with spheres that stand for it; places on its surface that a
// light and an eye see, and whether they see each other. Lengths are scene units (diagonal = 1).
#ifndef BlockersScene_h
#define BlockersScene_h

#include "Visibility/vtkIndirectTriangleTree.h" // for members
#include "vtkIndirectTestUtilities.h"           // for numbers

#include <array>       // for triangles
#include <glm/glm.hpp> // for vectors
#include <string>      // for names
#include <vector>      // for spheres

struct BlockersPlace
{
  glm::dvec3 Position;
  glm::dvec3 Normal;
  double Cosine; // to what sees it
};

struct BlockersPair
{
  int Receiver;
  int Light;
  double Weight; // of the light in the receiver's sum
  bool Visible;  // by the true geometry
};

class BlockersScene
{
public:
  using Triangle = std::array<glm::dvec3, 3>;

  /** Files of doubles: x, y, z, radius; nine numbers a triangle, none: spheres are the geometry. */
  bool Read(const std::string& spheres, const std::string& triangles);

  /** Places in turn: lights that a distant light sees, and receivers that a distant eye sees, both
   * evenly in the picture of who sees them; and all pairs that face each other. */
  void MakePairs(int receivers, int lights);

  bool IsMesh() const { return this->HasMesh; }
  /** What a gather weighs a light by, 0 where they do not face each other; and its area. */
  double GetWeight(const BlockersPlace& receiver, const BlockersPlace& light) const;
  double GetLightArea(const BlockersPlace& light) const;
  /** What the eye sees of spheres in a square picture of that edge; Cosine 0: nothing. */
  std::vector<BlockersPlace> MakePicture(int edge) const;

  /** By the true geometry, in double precision: a loop over all spheres, or a tree of triangles. */
  bool IsFree(const glm::dvec3& start, const glm::dvec3& end) const;
  /** Of the first thing on the way, in units of `direction`; 0: nothing before `most`. */
  double FindDistance(const glm::dvec3& start, const glm::dvec3& direction, double most) const;

  /** Turned about the vertical: the spheres and triangles of a frame of motion. */
  std::vector<glm::dvec4> TurnSpheres(double angle) const;
  std::vector<Triangle> TurnTriangles(double angle) const;

  std::vector<glm::dvec4> Spheres;
  std::vector<Triangle> Triangles; // of the mesh, or 120 a sphere
  glm::dvec3 Lower{ 0.0 };         // of all that moves, turned or not
  glm::dvec3 Upper{ 0.0 };
  std::vector<BlockersPlace> Lights;
  std::vector<BlockersPlace> Receivers;
  std::vector<BlockersPair> Pairs;

private:
  BlockersPlace DrawPlace(vtkIndirectTest::Random& random) const;
  std::vector<BlockersPlace> DrawSeen(
    vtkIndirectTest::Random& random, const glm::dvec3& toEye, int count, double& area) const;
  bool IsSeen(const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& toEye) const;
  void Tessellate();

  bool HasMesh = false;
  double LitArea = 0.0;      // across the light's way
  std::vector<double> Areas; // sums, of spheres or triangles
  vtkIndirectTriangleTree Tree;
};

#endif
