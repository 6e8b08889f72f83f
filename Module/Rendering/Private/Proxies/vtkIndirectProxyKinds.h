// SPDX-License-Identifier: BSD-3-Clause
// The kinds of mappers that spheres represent, and whether spheres can represent everything that a
// prop draws: known without collecting them, by mappers and by the shapes of meshes.
#pragma once

#include "OpenGL/vtkIndirectKey.h"          // for places
#include "Proxies/vtkIndirectProxyShapes.h" // for shapes

#include <string> // for reasons

class vtkMapper;
class vtkProp;

namespace vtkIndirectProxyKinds
{
enum MapperType
{
  MESH,
  BALLS,
  STICKS,
  GLYPHS,
  SPLATS,
  MOLECULE
};
MapperType FindType(vtkMapper* mapper);

/** The mappers by which a molecule's mapper draws, null where it draws none. */
struct Molecule
{
  vtkMapper* Bonds = nullptr;
  vtkMapper* Atoms = nullptr;
};
Molecule FindMolecule(vtkMapper* mapper);

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
Kind FindSpheres(vtkProp* prop);
/** Examines all of a prop, meshes with `shapes`. */
Kind Find(vtkProp* prop, vtkIndirectProxyShapes& shapes);
/** Returns the reason why the glyphs of a vtkGlyph3DMapper are not spheres; empty if they are. */
std::string FindWhyNoGlyphs(vtkMapper* mapper, vtkIndirectProxyShapes& shapes);
}
