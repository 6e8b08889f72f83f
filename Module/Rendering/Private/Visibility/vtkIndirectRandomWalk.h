// SPDX-License-Identifier: BSD-3-Clause
// Light on its way through the scene, on the processor: rays from the lights, and from where they
// end on, reflected by diffusion, to the next surface. Where a path meets a surface is a vertex, a
// virtual light of one more bounce than the one before it (Keller 1997, "Instant radiosity").
//
// Weights are exact: the sum over all vertices of a bounce is an estimate, without bias, of the
// light that surfaces reflect after so many bounces. A path goes on with the probability of its
// albedo's largest colour, and carries the light that ended paths would have. What a vertex stands
// for:
//
//   first bounce   rays are even in the light's solid angle (or over the area that a directional
//                  light shines through, or by the power of a spot's cosine): the share w of one of
//                  them, at distance d and cosine c to the facet, is an area A = w d^2 / c, and
//                  B A = albedo I(d) A max(n.l, 0).
//   later bounces  directions go by the cosine, so a ray carries all that is left: B A is the
//                  albedo times B A of the vertex before, over the probability of having gone on.
//                  They all carry about the same, of whatever bounce, so the area is one over the
//                  density of all of them, from the nearest ones on the same surface.
//
// A path is made of its number and its light alone: it moves smoothly with the light, and with more
// paths the first ones stay.
#ifndef vtkIndirectRandomWalk_h
#define vtkIndirectRandomWalk_h

#include "Frame/vtkIndirectFrame.h" // for lights

#include <glm/glm.hpp> // for vectors
#include <vector>      // for lists

class vtkIndirectSurfaces;

class vtkIndirectRandomWalk
{
public:
  /** A light that paths begin at. */
  struct Source
  {
    vtkIndirectLight Light;
    glm::dvec3 Strength; // VTK's colour times intensity
    int FirstBounce = 1; // whose vertices are kept
  };
  struct Vertex
  {
    glm::dvec3 Position; // scene units
    glm::dvec3 Normal;   // of the facet, unit: light leaves by it
    double Area;
    glm::dvec3 DensityArea; // B A, of all colours
    int Source;
    int Bounce; // from 1
  };
  struct Settings
  {
    /** Vertices that are asked for, about, of bounces First to Last. */
    int NumberOfVertices = 1000;
    int FirstBounce = 1;
    int LastBounce = 1;
  };

  /**
   * Walks from all sources; more paths from where more light is reflected. Vertices that send
   * nothing are left out.
   */
  void Walk(const vtkIndirectSurfaces& surfaces, const vtkIndirectFrame& frame,
    const std::vector<Source>& sources, const Settings& settings);

  const std::vector<Vertex>& GetVertices() const { return this->Vertices; }
  size_t GetNumberOfPaths() const { return this->NumberOfPaths; }
  /**
   * The share of all light of the walk's bounces, and of those after its last one, that the latter
   * have: about, as if each reflected as much of the one before it as the walk's did on the mean.
   */
  double GetTail() const { return this->Tail; }

private:
  class Emission;
  using List = std::vector<Vertex>;

  List Trace(const vtkIndirectSurfaces& surfaces, const Emission& emission, int source,
    size_t paths, int firstBounce, int lastBounce) const;
  void FindAreas();
  void FindTail(int lastBounce);

  List Vertices;
  size_t NumberOfPaths = 0;
  double Tail = 0.0;
};

#endif
