// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSphereProxyFilter
 * @brief   Spheres that stand for a mesh, closed or not, and move with it.
 *
 * The output has a point and a vertex for each sphere, largest gain first, and the point data
 * - "Radius" (double, in the input's lengths)
 * - "ParentIds" (8 ids) and "ParentWeights" (8 doubles of sum one, some may be negative): points of
 *   the input whose weighted sum is the center; "ParentSpread" (their root mean square distance
 * from their mean) and "ParentOffset" (center minus weighted sum, zero unless the points lie in a
 * plane that the center is not in)
 *
 * and as field data, a double each, what is true of the spheres (see the methods of these names):
 * "Error", "CoveredArea", "MaximumGap", "RootMeanSquareError", "MaximumProtrusion", "SolidVolume",
 * "CoveredVolume", "ProtrudingVolume".
 *
 * *Solids.* What the surface encloses is solid: all that a flood from outside cannot reach, over
 * walls of voxels; with a closed surface without the hollow of shells, and with an open one also
 * what it winds around but for MaximumOpening. Spheres are balls inside it, enlarged by the error:
 * they stick out by no more than that, and all of its surface is within that distance of them.
 * *Sheets.* A surface that encloses nothing gets spheres with their centers on it and the error as
 * radius, so many that all samples of it are well inside of them: no light gets through.
 *
 * *How.* Candidates are the medial voxels of a distance field and the largest inner balls that
 * touch the surface at samples; a greedy choice covers all samples; some steps of Gauss and Newton
 * bring the union's surface nearer to the mesh. Nothing is random: the same input gives the same
 * spheres. Related: Wang, Zhou, Snyder, Liu, Bao, Peng, Guo 2006, "Variational sphere set
 * approximation for solid objects".
 *
 * *Input.* Polygons and strips; vertices and lines have no surface and are passed over, as are
 * triangles without area. An input without surface gives an output without spheres. A point that is
 * not finite is one error.
 *
 * *Motion.* When port 1 is connected its points, as many as the input's and in the same order, take
 * the spheres with them; nothing is fitted again while the input and the properties are unchanged.
 * Rigid and affine motion is exact, any other as smooth as the points' own.
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
   * What is asked for: at most NumberOfSpheres with the least error (default), or as few spheres as
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
   * How far spheres may stick out, and how far the surface may be outside of them, as a share of
   * the diagonal of the input's bounds (default) or in its own lengths. Default: 0.02. Less than
   * 0.001 of the diagonal is taken as that.
   */
  vtkSetClampMacro(MaximumError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  vtkSetClampMacro(ErrorUnit, int, SHARE_OF_DIAGONAL, WORLD_UNITS);
  vtkGetMacro(ErrorUnit, int);
  void SetErrorUnitToShareOfDiagonal() { this->SetErrorUnit(SHARE_OF_DIAGONAL); }
  void SetErrorUnitToWorldUnits() { this->SetErrorUnit(WORLD_UNITS); }
  ///@}

  ///@{
  /** Voxels along the longest axis. Default: 64; from 8 to 256. Finer ones close smaller holes
   * only. */
  vtkSetClampMacro(Resolution, int, 8, 256);
  vtkGetMacro(Resolution, int);
  ///@}

  ///@{
  /**
   * Share of the border of a region that may have no surface for it to be solid all the same.
   * Default: 0.1, which closes a body with holes and leaves a bowl a sheet; 0: only what is closed
   * but for holes of a voxel.
   */
  vtkSetClampMacro(MaximumOpening, double, 0.0, 1.0);
  vtkGetMacro(MaximumOpening, double);
  ///@}

  ///@{
  /** Steps that spheres are moved and resized in after they are chosen. Default: 10; from 0 to 100.
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
   * Moves spheres that this filter has made with points that have moved: writes their centers and
   * radii into `moved`, with all arrays. False, with an error, where arrays are missing or points
   * are too few.
   */
  static bool MoveSpheres(vtkPolyData* spheres, vtkPointSet* points, vtkPolyData* moved);

  ///@{
  /** Of the last update; lengths and volumes in the input's unit. */
  /** The error that spheres were chosen for. */
  double GetError();
  /** Share of the surface no farther than the error outside of the spheres. */
  double GetCoveredArea();
  /** How far any place of the surface is outside of the spheres. */
  double GetMaximumGap();
  /** Distance of the surface and that of the spheres' union. */
  double GetRootMeanSquareError();
  /** How far any sphere sticks out of the solid, or from a sheet. */
  double GetMaximumProtrusion();
  double GetSolidVolume();
  /** Share of the solid that is inside of spheres; 1 where there is none. */
  double GetCoveredVolume();
  /** Volume of the union of spheres outside of the solid. */
  double GetProtrudingVolume();
  /** How often spheres were chosen: motion leaves it as it is. */
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
