// SPDX-License-Identifier: BSD-3-Clause
// What stands for a mesh: the spheres or the flat polygon that it is made of, where it is, or else
// spheres that a filter makes of it. Kept while the mesh is the same; where its points alone have
// moved the filter's spheres move with them.
#ifndef vtkIndirectProxyShapes_h
#define vtkIndirectProxyShapes_h

#include "Proxies/vtkIndirectProxySphere.h" // for shapes

#include "vtkSmartPointer.h" // for the filter
#include "vtkType.h"         // for times

#include <map>     // for what is kept
#include <string>  // for reasons
#include <utility> // for pairs
#include <vector>  // for lists

class vtkPolyData;
class vtkPolyDataAlgorithm;
class vtkProp;

class vtkIndirectProxyShapes
{
public:
  struct Shape
  {
    /** In the mesh's coordinates; albedos are not set. */
    std::vector<vtkIndirectProxySphere> Spheres;
    std::vector<vtkIndirectProxyPolygon> Polygons;
    ///@{
    /** A point and a cell of each sphere's surface, empty where the filter made them. */
    std::vector<vtkIdType> Points;
    std::vector<vtkIdType> Cells;
    ///@}
    std::string LeftOut; // why there is nothing
    int Kind = 0;
  };
  enum KindType
  {
    NOTHING,
    SPHERES, // it is made of them
    POLYGON, // it is one
    FITTED,  // by a filter
    SHEET    // for which nothing stands
  };

  /** What stands for a mesh that this prop draws. */
  const Shape& Find(vtkProp* prop, vtkPolyData* mesh);
  /** The same of a body that is one sphere or is left out. */
  const Shape& FindBody(vtkProp* prop, vtkPolyData* mesh);

  /** Ends a frame: forgets what was not asked for since the last call. */
  void Forget();
  /** How often a mesh has been looked into. */
  int GetNumberOfFits() const { return this->NumberOfFits; }

  ///@{
  /** The parts of Find: false where the mesh is no such thing. */
  static bool FindSpheres(vtkPolyData* mesh, Shape& shape);
  static bool FindPolygon(vtkPolyData* mesh, Shape& shape);
  /** Whether a mesh encloses nothing, by the length of its border. */
  static bool IsSheet(vtkPolyData* mesh);
  ///@}

private:
  struct Known
  {
    Shape Made;
    vtkMTimeType Time = 0;      // of the mesh
    vtkMTimeType CellsTime = 0; // and of its cells
    vtkIdType NumberOfPoints = 0;
    vtkSmartPointer<vtkPolyDataAlgorithm> Filter;
    bool Used = false;
  };

  void Fit(Known& known, vtkPolyData* mesh);
  bool Move(Known& known, vtkPolyData* mesh);

  std::map<std::pair<vtkProp*, vtkPolyData*>, Known> All;
  int NumberOfFits = 0;
};
#endif
