// SPDX-License-Identifier: BSD-3-Clause
// The representation of a mesh: the spheres or the flat polygon that it consists of, or else
// spheres that a filter fits to it. It is kept while the mesh is the same; if only its points move,
// the filter's spheres move with them.
#pragma once

#include "OpenGL/vtkIndirectKey.h"          // for members
#include "Proxies/vtkIndirectProxySphere.h" // for shapes

#include "vtkSmartPointer.h" // for the filter
#include "vtkType.h"         // for ids

#include <map>     // for known shapes
#include <string>  // for reasons
#include <utility> // for pairs
#include <vector>  // for lists

class vtkPolyData;
class vtkPolyDataAlgorithm;

class vtkIndirectProxyShapes
{
public:
  struct Shape
  {
    /** In the mesh's coordinates; albedos are not set. */
    std::vector<vtkIndirectProxySphere> Spheres;
    std::vector<vtkIndirectProxyPolygon> Polygons;
    ///@{
    /** This is a point and a cell of each sphere's surface, empty for the filter's spheres. */
    std::vector<vtkIdType> Points;
    std::vector<vtkIdType> Cells;
    ///@}
    std::string LeftOut; // reason for an empty shape
    int Kind = 0;
  };
  enum KindType
  {
    NOTHING, // the mesh has no representation, or no exact one
    SPHERES, // the mesh consists of spheres
    POLYGON, // the mesh is a flat polygon
    FITTED,  // spheres fitted by a filter
    SHEET    // a sheet, which has no representation
  };

  /** Returns the representation of a mesh. exact: without the spheres of a filter. */
  const Shape& Find(vtkPolyData* mesh, bool exact);

  /** Ends a frame: forgets meshes not used since the last call. */
  void Forget();

  ///@{
  /** The parts of Find: false if the mesh has no such shape. */
  static bool FindSpheres(vtkPolyData* mesh, Shape& shape);
  static bool FindPolygon(vtkPolyData* mesh, Shape& shape);
  /** Returns true if a mesh encloses no volume, by the length of its border. */
  static bool IsSheet(vtkPolyData* mesh);
  ///@}

private:
  struct Known
  {
    Shape Made;
    vtkIndirectKey Mesh;
    vtkIndirectKey Cells; // all of the mesh that does not move with its points
    vtkSmartPointer<vtkPolyDataAlgorithm> Filter;
    bool Used = false;
  };

  static void Fit(Known& known, vtkPolyData* mesh, bool exact);
  static void Move(Known& known, vtkPolyData* mesh);

  std::map<std::pair<vtkPolyData*, bool>, Known> All; // by mesh and `exact`
};
