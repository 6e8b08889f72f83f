// SPDX-License-Identifier: BSD-3-Clause
// Shared parts of the numeric tests: checks that print their measurements, deterministic numbers,
// quadrature, closed forms, and small scenes in a window without a display.
//
#ifndef vtkIndirectTestUtilities_h
#define vtkIndirectTestUtilities_h

#include "vtkIndirectHarness.h"          // for tests
#include "vtkIndirectIlluminationPass.h" // for members
#include "vtkNew.h"                      // for members
#include "vtkRenderer.h"                 // for members
#include "vtkSmartPointer.h"             // for members

#include <cstdint>     // for the generator
#include <functional>  // for integrands
#include <glm/glm.hpp> // for vectors
#include <string>      // for names
#include <vector>      // for pixels

class vtkActor;
class vtkAlgorithm;
class vtkLight;
class vtkRenderWindow;
class vtkRSMGatherPass;
class vtkUniformLightSampler;

namespace vtkIndirectTest
{
// Checks print the measured and the expected value, the tolerance and its origin.
bool Check(const std::string& what, bool condition, const std::string& origin = "");
bool CheckEqual(const std::string& what, double measured, double expected);
/** |measured - expected| <= tolerance */
bool CheckAbsolute(const std::string& what, double measured, double expected, double tolerance,
  const std::string& origin);
/** |measured - expected| <= tolerance |expected| */
bool CheckRelative(const std::string& what, double measured, double expected, double tolerance,
  const std::string& origin);
/** measured <= limit */
bool CheckAtMost(const std::string& what, double measured, double limit, const std::string& origin);
bool CheckAtLeast(
  const std::string& what, double measured, double limit, const std::string& origin);
/** The result of CheckRelative without a message, to show that a test can fail. */
bool WouldPass(double measured, double expected, double tolerance);

// Numbers -----------------------------------------------------------------------------------------
/** PCG32 (O'Neill 2014): the same numbers everywhere. */
class Random
{
public:
  explicit Random(std::uint64_t seed);
  std::uint32_t NextBits();
  double Next(double lower = 0.0, double upper = 1.0); // [lower, upper)
  /** lower * (upper / lower)^u: all magnitudes equally often. */
  double NextMagnitude(double lower, double upper);
  glm::dvec3 NextDirection(); // uniform on the sphere

private:
  std::uint64_t State = 0;
};

/** Gauss-Legendre, 16 points in each of `panels` panels. */
double Integrate(
  double lower, double upper, const std::function<double(double)>& f, int panels = 8);

/** Form factor from a surface element to a polygon in front of it (Lambert 1760). */
double PolygonFormFactor(
  const glm::dvec3& position, const glm::dvec3& normal, const std::vector<glm::dvec3>& polygon);
/** Between equal facing squares, ratio = edge over distance. */
double FacingSquaresFormFactor(double ratio);
/** Between unit squares that share an edge at a right angle. */
double PerpendicularSquaresFormFactor();
/** From coaxial disk 1 to disk 2, radii over distance. */
double FacingDisksFormFactor(double radius1, double radius2);

/** The value that a share of the values does not exceed; sorts the vector. */
double Percentile(std::vector<double>& values, double share);

// Images ------------------------------------------------------------------------------------------
struct Image
{
  int Width = 0;
  int Height = 0;
  int Components = 0;
  std::vector<float> Values;

  const float* At(int x, int y) const
  {
    return &this->Values[static_cast<size_t>(this->Components) * (y * this->Width + x)];
  }
  glm::dvec3 Color(int x, int y) const
  {
    const float* v = this->At(x, y);
    return { v[0], v[1], v[2] };
  }
  /** Mean of a component over all pixels. */
  double Mean(int component = 0) const;
};

/** RMS of the difference over the mean of the expected image, where `normal` has a surface. */
double FindRelativeError(const Image& image, const Image& expected, const Image& normal);

/** A row of the buffer "lights". */
struct VirtualLight
{
  glm::dvec3 Position;
  double Area;
  glm::dvec3 Normal;
  glm::dvec3 DensityArea;
  int Source;
};

// Scenes ------------------------------------------------------------------------------------------
/** A window without a display, a renderer without lights, and the pass. Skips the test if there is
 * no window.
 */
class Scene
{
public:
  Scene(int width, int height);
  ~Scene();

  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkNew<vtkIndirectIlluminationPass> Pass; // without visibility of senders
  vtkNew<vtkRSMGatherPass> Gather;          // set as the pass's estimator, all texels
  vtkNew<vtkUniformLightSampler> Sampler;   // set as the pass's sampler

  /** Parallelogram; its normal is (point1 - origin) x (point2 - origin). */
  vtkActor* AddQuad(const glm::dvec3& origin, const glm::dvec3& point1, const glm::dvec3& point2,
    const glm::dvec3& color);
  vtkActor* AddSphere(
    const glm::dvec3& center, double radius, int resolution, const glm::dvec3& color);
  vtkActor* AddBox(const glm::dvec3& lower, const glm::dvec3& upper, const glm::dvec3& color);
  vtkActor* AddDisk(const glm::dvec3& center, const glm::dvec3& normal, double radius, int sides,
    const glm::dvec3& color);
  vtkActor* AddSource(vtkAlgorithm* source, const glm::dvec3& color);

  vtkLight* AddPoint(const glm::dvec3& position, const glm::dvec3& attenuation);
  vtkLight* AddSpot(const glm::dvec3& position, const glm::dvec3& target, double coneAngle,
    double exponent, const glm::dvec3& attenuation);
  vtkLight* AddDirectional(const glm::dvec3& direction);
  /** Sets the intensity of all lights. */
  void SetIntensities(double intensity);

  /** viewAngle: vertical, degrees. */
  void SetEye(const glm::dvec3& position, const glm::dvec3& target, const glm::dvec3& up,
    double viewAngle, double nearPlane, double farPlane);
  void SetParallelEye(double scale);

  void Render();
  Image Copy(const std::string& name);
  std::vector<VirtualLight> CopyLights();
  /** Sum of the virtual lights' reflected density times area. */
  glm::dvec3 GetReflectedFlux();

  /** World position and normal of each lit pixel, in double from the buffers; kind < 0: background.
   */
  struct Receiver
  {
    bool Lit;
    glm::dvec3 Position;
    glm::dvec3 Normal;
    int X; // pixel
    int Y;
  };
  std::vector<Receiver> GetReceivers();

  /** A number of the last frame's report, by its key; -1 if there is none. */
  double ReadReport(const std::string& key);
  /** Checks that every buffer of the last frame is finite, and nonnegative except for signed
   * quantities. */
  void CheckBuffers(int numberOfMaps);
};

/** Tolerance of a mean, and of an RMS error over it, with its origin. */
struct LightTolerance
{
  double Mean;
  double RMS;
  std::string Origin;
};
/** Renders, and compares the red of a buffer with `expect` at each receiver that counts. */
void CompareLight(Scene& scene, const std::string& buffer,
  const std::function<bool(const Scene::Receiver&)>& counts,
  const std::function<double(const Scene::Receiver&)>& expect, const LightTolerance& tolerance,
  const std::string& name = "");

/** Sum of the virtual lights at a receiver in double precision, by an independent kernel. */
glm::dvec3 Gather(
  const std::vector<VirtualLight>& lights, const glm::dvec3& position, const glm::dvec3& normal);
}

#endif
