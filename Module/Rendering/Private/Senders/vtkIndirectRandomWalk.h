// SPDX-License-Identifier: BSD-3-Clause
// A random walk of light through the scene, on the processor: rays leave the lights, and where they
// meet a surface they are reflected diffusely to the next one. Each place where a path meets a
// surface is a vertex, a virtual light of one more bounce than the vertex before (Keller 1997,
// "Instant radiosity").
//
// Weights are exact: the sum over all vertices of a bounce is an unbiased estimate of the light
// that surfaces reflect after this many bounces. A path that carries less light than most others
// goes on with a probability, and then carries the light that ended paths would have carried: as
// much as the others, whatever the albedos, colours and distances before. So no few vertices decide
// how bright a surface is, which would be bright spots in creases. A vertex represents:
//
//   first bounce   rays are uniform in the light's solid angle (or over the area that a directional
//                  light shines through, or by the power of a spot's cosine): the share w of one
//                  ray, at distance d and cosine c to the facet, is an area A = w d^2 / c, and
//                  B A = albedo I(d) A max(n.l, 0).
//   later bounces  directions go by the cosine, so a ray carries all remaining light: B A is the
//                  albedo times B A of the vertex before, over the probability of having gone on.
//                  All vertices carry about the same, of whatever bounce, so the area is one over
//                  the density of all of them, from the nearest ones on the same surface.
//
// A path depends on its number and its light alone: it moves smoothly with the light, and more
// paths leave the first ones as they are.
#pragma once

#include "Senders/vtkIndirectEmitters.h" // for emitters

#include <glm/glm.hpp> // for vectors
#include <vector>      // for lists

class vtkIndirectSurfaces;

class vtkIndirectRandomWalk
{
public:
  struct Vertex
  {
    glm::dvec3 Position; // scene units
    glm::dvec3 Normal;   // unit normal of the facet, on the side that light leaves by
    double Area;
    glm::dvec3 DensityArea; // B A, for each colour
    int Emitter;            // its place in the list
    int Bounce;             // from 1
    double Footprint;       // of its ray, over that of a ray made without regard to what is seen
  };
  struct Settings
  {
    /** This is the wanted number of vertices, approximately, of bounces First to Last. */
    int NumberOfVertices = 1000;
    int FirstBounce = 1;
    int LastBounce = 1;
  };

  /**
   * Walks from all emitters, with more paths from emitters whose light is reflected more. Vertices
   * that send nothing are left out.
   */
  void Walk(const vtkIndirectSurfaces& surfaces, const vtkIndirectFrame& frame,
    const vtkIndirectEmitters::List& emitters, const Settings& settings);

  const std::vector<Vertex>& GetVertices() const { return this->Vertices; }
  size_t GetNumberOfPaths() const { return this->NumberOfPaths; }
  /**
   * Returns an estimate of the share of light beyond the walk's last bounce in all light of the
   * walk's bounces and later ones. It assumes that each bounce reflects the walk's mean share of
   * the bounce before.
   */
  double GetTail() const { return this->Tail; }

private:
  class Emission;
  using List = std::vector<Vertex>;

  /**
   * Traces paths of one emitter. A path that carries less than its share of `flux` goes on with the
   * probability that keeps this share.
   */
  List Trace(const vtkIndirectSurfaces& surfaces, const Emission& emission, int place, size_t paths,
    double flux, int firstBounce, int lastBounce) const;
  /** Traces more and more paths until they have enough vertices; paths: their number. */
  List TracePilot(const vtkIndirectSurfaces& surfaces, const Emission& emission, int place,
    double flux, int firstBounce, int lastBounce, size_t& paths) const;
  void FindAreas();
  void FindTail(int lastBounce);

  List Vertices;
  size_t NumberOfPaths = 0;
  double Tail = 0.0;
};
