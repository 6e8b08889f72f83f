// SPDX-License-Identifier: BSD-3-Clause
// Whether spheres stand for all that a prop draws, found without collecting them: by its mappers,
// and by shapes of meshes, which are looked into once.
#ifndef vtkIndirectProxyKinds_h
#define vtkIndirectProxyKinds_h

#include "vtkType.h" // for times

#include <string>        // for reasons
#include <unordered_map> // for what is known
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
    /** Balls that a mapper draws by itself: atoms, particles, glyphs that are spheres. */
    double NumberOfSpheres = 0.0;
    size_t NumberOfPolygons = 0; // flat and convex
    /** What vtkProxyAccumulationPass has nothing exact for; empty: there is no such thing. */
    std::string Other;
    /** Changes with the places of these spheres: times of data, and of matrices the elements. */
    std::vector<double> Places;
  };

  /** What draws spheres alone; without Other's reasons, and without looking into meshes. */
  static Kind FindSpheres(vtkProp* prop);
  /** Whether an actor draws opaque splats that its shader code cuts off by `discard`, so that they
   * look like spheres. Others fade out, and light comes through them. */
  static bool IsOfCutSplats(vtkActor* actor);
  /** All of a prop. */
  Kind Find(vtkProp* prop);
  /** Why what a vtkGlyph3DMapper draws are not spheres; empty where they are. */
  std::string FindWhyNoGlyphs(vtkMapper* mapper);
  /** Ends a frame: forgets meshes that it did not ask for. */
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
#endif
