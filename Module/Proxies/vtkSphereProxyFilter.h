// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSphereProxyFilter
 * @brief Spheres that approximate a mesh, closed or not, and move with it.
 *
 * The output has a point and a vertex for each sphere, largest gain first, and the point data
 * - "Radius" (double, in the input's lengths)
 * - "ParentIds" (8 ids) and "ParentWeights" (8 doubles of sum one, some may be negative): points of
 *   the input whose weighted sum is the center; "ParentSpread" (their root mean square distance
 * from their mean) and "ParentOffset" (center minus weighted sum, zero unless the points lie in a
 * plane that the center is not in)
 *
 * and as field data, a double each, measures of the spheres (see the methods of these names):
 * "Error", "CoveredArea", "MaximumGap", "RootMeanSquareError", "MaximumProtrusion", "SolidVolume",
 * "CoveredVolume", "ProtrudingVolume".
 *
 * *Solids.* The interior of the surface is solid: all that a flood from outside cannot reach, over
 * walls of voxels; for a closed surface without the hollow of shells, and for an open one also
 * regions with a winding number above one half, up to MaximumOpening. Spheres are balls inside it,
 * enlarged by the error: they extend beyond it by at most that, and all of its surface is within
 * that distance of them. *Sheets.* A surface that encloses no volume gets spheres with their
 * centers on it and the error as radius, so many that all samples of it are well inside of them and
 * no light passes through.
 *
 * *Method.* Candidates are the medial voxels of a distance field and the largest inner balls that
 * touch the surface at samples; a greedy choice covers all samples; some Gauss-Newton steps bring
 * the union's surface nearer to the mesh. The result is deterministic: the same input gives the
 * same spheres. Related: Wang, Zhou, Snyder, Liu, Bao, Peng, Guo 2006, "Variational sphere set
 * approximation for solid objects".
 *
 * *Input.* Polygons and strips; vertices, lines and degenerate triangles are skipped. An input
 * without surface gives an output without spheres. A point that is not finite is one error.
 *
 * *Motion.* If port 1 is connected, its points, as many as the input's and in the same order, move
 * the spheres; they are fitted again only if the input or a property changes. Rigid and affine
 * motion is exact, any other as smooth as the points' own.
 *
 * Documentation/methods/sphere-proxies.md has measured errors and times.
 */

#ifndef vtkSphereProxyFilter_h
#define vtkSphereProxyFilter_h

#include "vtkIndirectProxiesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // For the fit

class vtkPointSet;

class VTKINDIRECTPROXIES_EXPORT vtkSphereProxyFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkSphereProxyFilter* New();
  vtkTypeMacro(vtkSphereProxyFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    NUMBER_OF_SPHERES = 0,
    MAXIMUM_ERROR
  };
  ///@{
  /**
   * Goal of the fit: at most NumberOfSpheres with the least error (default), or as few spheres as
   * are found for MaximumError.
   */
  vtkSetClampMacro(Target, int, NUMBER_OF_SPHERES, MAXIMUM_ERROR);
  vtkGetMacro(Target, int);
  void SetTargetToNumberOfSpheres() { this->SetTarget(NUMBER_OF_SPHERES); }
  void SetTargetToMaximumError() { this->SetTarget(MAXIMUM_ERROR); }
  ///@}

  ///@{
  /** Default: 256; from 1 to 100000, clamped. The choice ends a few below it. */
  vtkSetClampMacro(NumberOfSpheres, int, 1, 100000);
  vtkGetMacro(NumberOfSpheres, int);
  ///@}

  enum
  {
    SHARE_OF_DIAGONAL = 0,
    WORLD_UNITS
  };
  ///@{
  /**
   * Bound of the spheres' extent beyond the surface, and of the surface's distance outside of them,
   * as a share of the diagonal of the input's bounds (default) or in its own lengths. Default:
   * 0.02. The minimum is 0.001 of the diagonal.
   */
  vtkSetClampMacro(MaximumError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  vtkSetClampMacro(ErrorUnit, int, SHARE_OF_DIAGONAL, WORLD_UNITS);
  vtkGetMacro(ErrorUnit, int);
  void SetErrorUnitToShareOfDiagonal() { this->SetErrorUnit(SHARE_OF_DIAGONAL); }
  void SetErrorUnitToWorldUnits() { this->SetErrorUnit(WORLD_UNITS); }
  ///@}

  ///@{
  /** Voxels along the longest axis. Default: 64; from 8 to 256. More voxels close only smaller
   * holes. */
  vtkSetClampMacro(Resolution, int, 8, 256);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Largest share of a solid region's border that may have no surface. Default: 0.1, which closes a
   * body with holes and leaves a bowl a sheet; 0: only regions closed but for holes of a voxel.
   */
  vtkSetClampMacro(MaximumOpening, double, 0.0, 1.0);
  vtkGetMacro(MaximumOpening, double);
  ///@}

  ///@{
  /** Steps that move and resize the chosen spheres. Default: 10; from 0 to 100.
   */
  vtkSetClampMacro(RefinementSteps, int, 0, 100);
  vtkGetMacro(RefinementSteps, int);
  ///@}

  ///@{
  /** The moved points (port 1), optional: a point set with as many points as the input. */
  void SetMovedConnection(vtkAlgorithmOutput* port);
  void SetMovedData(vtkPointSet* points);
  ///@}

  /**
   * Moves this filter's spheres with moved points: writes their centers and radii into `moved`,
   * with all arrays. False, with an error, if arrays are missing or there are too few points.
   */
  static bool MoveSpheres(vtkPolyData* spheres, vtkPointSet* points, vtkPolyData* moved);

  ///@{
  /** Measures of the last update; lengths and volumes in the input's unit. */
  /** The error for which spheres were chosen. */
  double GetError() { return this->GetMeasure("Error"); }
  /** Share of the surface within the error outside of the spheres. */
  double GetCoveredArea() { return this->GetMeasure("CoveredArea"); }
  /** Largest distance of the surface outside of the spheres. */
  double GetMaximumGap() { return this->GetMeasure("MaximumGap"); }
  /** Distance between the surface and that of the spheres' union. */
  double GetRootMeanSquareError() { return this->GetMeasure("RootMeanSquareError"); }
  /** Largest extent of a sphere beyond the solid, or from a sheet. */
  double GetMaximumProtrusion() { return this->GetMeasure("MaximumProtrusion"); }
  double GetSolidVolume() { return this->GetMeasure("SolidVolume"); }
  /** Share of the solid inside of spheres; 1 without a solid. */
  double GetCoveredVolume() { return this->GetMeasure("CoveredVolume"); }
  /** Volume of the union of spheres outside of the solid. */
  double GetProtrudingVolume() { return this->GetMeasure("ProtrudingVolume"); }
  /** Number of fits of the spheres: motion does not count. */
  int GetNumberOfFits() { return this->NumberOfFits; }
  ///@}

protected:
  vtkSphereProxyFilter();
  ~vtkSphereProxyFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  int Target = NUMBER_OF_SPHERES;
  int NumberOfSpheres = 256;
  double MaximumError = 0.02;
  int ErrorUnit = SHARE_OF_DIAGONAL;
  int Resolution = 64;
  double MaximumOpening = 0.1;
  int RefinementSteps = 10;

private:
  vtkSphereProxyFilter(const vtkSphereProxyFilter&) = delete;
  void operator=(const vtkSphereProxyFilter&) = delete;

  bool Fit(vtkPolyData* input);
  double GetMeasure(const char* name);

  struct Fitted;
  std::unique_ptr<Fitted> Kept;
  int NumberOfFits = 0;
};

#endif
