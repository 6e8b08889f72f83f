// SPDX-License-Identifier: BSD-3-Clause
// Tells if spheres can represent everything that a prop draws, without collecting them: by its
// mappers, and by the shapes of meshes, each examined once.
#pragma once

#include "vtkType.h" // for times

#include <string>        // for reasons
#include <unordered_map> // for known meshes
#include <vector>        // for numbers

class vtkActor;
class vtkMapper;
class vtkPolyData;
class vtkProp;

class vtkIndirectProxyKinds
{
public:
  struct Kind
  {
    /** Balls that a mapper draws by itself: atoms, particles, spherical glyphs. */
    double NumberOfSpheres = 0.0;
    size_t NumberOfPolygons = 0; // flat and convex
    /** This is the content for which vtkProxyAccumulationPass has no exact representation; empty if
     * there is none. */
    std::string Other;
    /** Changes with the positions of these spheres: times of data, elements of matrices. */
    std::vector<double> Places;
  };

  /** Counts the spheres of mappers that draw only spheres; without reasons in Other, and without
   * examining meshes. */
  static Kind FindSpheres(vtkProp* prop);
  /** Returns true if an actor draws opaque splats that its shader code clips by `discard`, so that
   * they look like spheres. Other splats fade out and are translucent. */
  static bool IsOfCutSplats(vtkActor* actor);
  /** Examines all of a prop. */
  Kind Find(vtkProp* prop);
  /** Reason why the glyphs of a vtkGlyph3DMapper are not spheres; empty if they are. */
  std::string FindWhyNoGlyphs(vtkMapper* mapper);
  /** Ends a frame: forgets unused meshes. */
  void Forget();

private:
  enum ShapeType
  {
    NEITHER,
    POLYGON,
    SPHERES,
    CENTERED_SPHERE // one, about the origin
  };
  struct Known
  {
    vtkMTimeType Time = 0;
    int Shape = NEITHER;
    bool Used = false;
  };

  void AddActor(vtkActor* actor, Kind& kind);
  void AddMesh(vtkMapper* mapper, Kind& kind);
  int FindShape(vtkPolyData* mesh);

  std::unordered_map<vtkPolyData*, Known> Meshes;
};
