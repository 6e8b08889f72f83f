// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMeshSimplificationFilter
 * @brief A mesh of fewer triangles within a bounded distance of the input.
 *
 * Edges are collapsed in the order of the quadrics of their points' planes (Garland and Heckbert
 * 1997, "Surface simplification using quadric error metrics"), by OpenMesh. The remaining points
 * are points of the input, with their point data, and the cells keep their data. Since the order
 * alone bounds no error, collapses are refused that leave a point of the input farther than the
 * bound from the triangles around it, or that turn a triangle over; the result is then measured,
 * both ways, at all points and at 20000 samples each, and made again with less tolerance if it is
 * off.
 *
 * The output has only triangles; vertices and lines of the input are left out. Points at the same
 * position are merged if all their data agree, so that meshes without connectivity simplify, while
 * seams of normals or texture coordinates remain borders. Points at edges of more than two
 * triangles stay. A point that is not finite is one error, with an empty output.
 *
 * Field data: "MaximumDistance" (double, in the input's lengths), as GetMaximumDistance.
 */

#ifndef vtkMeshSimplificationFilter_h
#define vtkMeshSimplificationFilter_h

#include "vtkIndirectProxiesModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKINDIRECTPROXIES_EXPORT vtkMeshSimplificationFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkMeshSimplificationFilter* New();
  vtkTypeMacro(vtkMeshSimplificationFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum
  {
    SHARE_OF_DIAGONAL = 0,
    WORLD_UNITS
  };
  ///@{
  /**
   * Bound of the distance between the surfaces, as a share of the diagonal of the input's bounds
   * (default) or in its own lengths. Default: 0.01; negative numbers are taken as 0, which merges
   * only flat parts.
   */
  vtkSetClampMacro(MaximumError, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MaximumError, double);
  vtkSetClampMacro(ErrorUnit, int, SHARE_OF_DIAGONAL, WORLD_UNITS);
  vtkGetMacro(ErrorUnit, int);
  void SetErrorUnitToShareOfDiagonal() { this->SetErrorUnit(SHARE_OF_DIAGONAL); }
  void SetErrorUnitToWorldUnits() { this->SetErrorUnit(WORLD_UNITS); }
  ///@}

  ///@{
  /** Least number of triangles. Default: 0, as few as the error allows. */
  vtkSetClampMacro(TargetNumberOfTriangles, vtkIdType, 0, VTK_ID_MAX);
  vtkGetMacro(TargetNumberOfTriangles, vtkIdType);
  ///@}

  ///@{
  /** Keeps points on borders in place. Default: on. */
  vtkSetMacro(PreserveBoundary, bool);
  vtkGetMacro(PreserveBoundary, bool);
  vtkBooleanMacro(PreserveBoundary, bool);
  ///@}

  /** Distance between the surfaces at the last update, the larger of both ways, measured. */
  vtkGetMacro(MaximumDistance, double);

protected:
  vtkMeshSimplificationFilter() = default;
  ~vtkMeshSimplificationFilter() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double MaximumError = 0.01;
  int ErrorUnit = SHARE_OF_DIAGONAL;
  vtkIdType TargetNumberOfTriangles = 0;
  bool PreserveBoundary = true;
  double MaximumDistance = 0.0;

private:
  vtkMeshSimplificationFilter(const vtkMeshSimplificationFilter&) = delete;
  void operator=(const vtkMeshSimplificationFilter&) = delete;
};

#endif
