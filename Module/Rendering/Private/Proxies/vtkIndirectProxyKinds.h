// SPDX-License-Identifier: BSD-3-Clause
// Tells if spheres can represent everything that a prop draws, without collecting them: by its
// mappers, and by the shapes of meshes, each examined once.
#pragma once

#include "Frame/vtkIndirectKey.h"           // for places
#include "Proxies/vtkIndirectProxyShapes.h" // for a member

#include <string> // for reasons

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
    vtkIndirectKey Places; // the inputs of the spheres' positions
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
  void Forget() { this->Shapes.Forget(); }

private:
  void AddActor(vtkActor* actor, Kind& kind);
  void AddMesh(vtkMapper* mapper, Kind& kind);
  const vtkIndirectProxyShapes::Shape& FindShape(vtkPolyData* mesh);

  vtkIndirectProxyShapes Shapes;
};
