// SPDX-License-Identifier: BSD-3-Clause
// A scene at the limits of the formulas, rendered with every estimator of the table.
#ifndef vtkIndirectHardCase_h
#define vtkIndirectHardCase_h

#include "vtkIndirectEstimatorTable.h"
#include "vtkIndirectTestUtilities.h"

#include <functional> // for additional checks
#include <string>     // for names

namespace vtkIndirectTest
{
/** Diffuse reflectance of most surfaces. */
const glm::dvec3 Albedo(0.75, 0.5, 0.25);

struct HardCase : Scene
{
  explicit HardCase(const std::string& name, int width = 40, int height = 30);

  /** Floor and two walls of edge one with the origin as their vertex; the eye before them. */
  void AddCorner(const glm::dvec3& color = glm::dvec3(1.0));

  /** Triangles; normals, three floats a point, may be null. */
  vtkActor* AddTriangles(const std::vector<glm::dvec3>& points, const std::vector<float>& normals,
    const std::vector<int>& corners, const glm::dvec3& color);

  /**
   * Renders with every estimator. Each time every buffer is finite, nonnegative quantities are not
   * negative, the buffers are consistent, and the irradiance is the sum of vtkRSMReferencePass in
   * double precision over the senders that the estimator promises; then `more` is called. Returns
   * the sum over all texels.
   */
  Image CheckEstimators(
    int numberOfMaps, const std::function<void(const EstimatorEntry&)>& more = nullptr);

  /** Virtual lights in the next CheckEstimators; texels of all maps are summed as well. */
  int NumberOfLights = 64;
  /** False if VTK normalizes a zero vector: then buffers are only checked for validity. */
  bool NormalsAreDefined = true;
  /**
   * Differences of the irradiance are relative to at least this: for scenes whose light comes only
   * from senders so near, or so nearly in the same plane, that its cosines are rounding.
   */
  double Radiance = 0.0;

private:
  Image Sum(int mode);
  void CheckBuffersFit();
  void CheckMaps(int numberOfMaps);
  /** Renders with every choice of users; every buffer is valid and fits the others. */
  void CheckUserChoices(int numberOfMaps);

  std::string Name;
};

/** Options of the comparison of images, pixel by pixel, as vectors. */
struct Comparison
{
  double Factor = 1.0; // the image's unit over the expected one's
  /** Differences are relative to at least this, and to a five-thousandth of the largest value:
   * smaller values come from senders in nearly the same plane, whose cosines are the steps of
   * normals, 1.3e-4 at most (Unit.PackSurface), with few digits. */
  double Least = 0.0;
  int FirstComponent = 0;
  int LastComponent = 2;
};

/** Share of the pixels that differ by more than a share of the expected value. */
double GetShareOfDifferent(const Image& image, const Image& expected, double tolerance,
  const Comparison& how = Comparison());

double GetLargest(const Image& image);
}

#endif
