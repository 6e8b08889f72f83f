// SPDX-License-Identifier: BSD-3-Clause
// Shared parts of the contract tests of vtkIndirectIlluminationPass: checks, headless windows,
// read-back and small scenes.
#ifndef vtkIndirectContractUtilities_h
#define vtkIndirectContractUtilities_h

#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkIndirectHarness.h"
#include "vtkIndirectIlluminationPass.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"

#include <array>
#include <cmath>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkProp3D;
class vtkTexture;

namespace contract
{
/** Counts a failure; only the first few of a test are printed. */
void Fail(const char* file, int line, const std::string& what);
using vtkIndirectTest::Skip;

/** Steps by which a colour may be off that OpenGL has rounded to a byte: a GPU rounds a float with
 * few bits more, measured 0.56 on an H100. */
constexpr double ByteRounding = 0.6;

#define CONTRACT_CHECK(condition, message)                                                         \
  do                                                                                               \
  {                                                                                                \
    if (!(condition))                                                                              \
    {                                                                                              \
      std::ostringstream contractText;                                                             \
      contractText << #condition << ": " << message;                                               \
      contract::Fail(__FILE__, __LINE__, contractText.str());                                      \
    }                                                                                              \
  } while (false)

/** Ignores warnings that contain this text: a driver's, about VTK's own shaders. */
void AllowWarning(const std::string& text);

/**
 * During the lifetime of such an object, errors and warnings are counted and not printed. Otherwise
 * any of them fails the test.
 */
class ExpectedErrors
{
public:
  ExpectedErrors();
  ~ExpectedErrors();
  int GetCount() const;
  std::string GetText() const;
};

/** An image with the first row at the bottom. */
template <typename T>
struct Image
{
  int Width = 0;
  int Height = 0;
  int Components = 0;
  std::vector<T> Values;

  const T* At(int x, int y) const
  {
    return &this->Values[(static_cast<size_t>(y) * this->Width + x) * this->Components];
  }
  T Get(int x, int y, int c) const { return this->At(x, y)[c]; }
};
using Pixels = Image<unsigned char>; // RGBA
using Floats = Image<float>;

/** A window without display and one renderer in it; no multisampling. */
struct View
{
  vtkSmartPointer<vtkEGLHeadlessRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;

  explicit View(int width = 160, int height = 160);
  ~View();
  View(const View&) = delete;
  View& operator=(const View&) = delete;
  /** Renders and reads back. */
  Pixels Grab();
};

/** Reads a window back, after rendering it; checks that OpenGL has no error to report. */
Pixels Grab(vtkRenderWindow* window, bool render = true);
std::vector<float> GrabDepth(vtkRenderWindow* window);
Pixels Crop(const Pixels& image, int x, int y, int width, int height);
/** A channel of the last frame; fails the test if it does not exist. */
Floats Read(vtkIndirectIlluminationPass* pass, const std::string& name);

struct Difference
{
  double Max = 0.0;
  double Mean = 0.0; // over all components
  size_t Pixels = 0; // number of differing pixels
  int X = -1;        // position of the largest difference
  int Y = -1;
};
std::ostream& operator<<(std::ostream& os, const Difference& difference);

/** Differing sizes count as the largest difference. */
template <typename T>
Difference Compare(const Image<T>& a, const Image<T>& b)
{
  Difference result;
  if (a.Width != b.Width || a.Height != b.Height || a.Components != b.Components ||
    a.Values.empty())
  {
    result.Max = result.Mean = 1e30;
    return result;
  }
  for (int y = 0; y < a.Height; ++y)
  {
    for (int x = 0; x < a.Width; ++x)
    {
      bool differs = false;
      for (int c = 0; c < a.Components; ++c)
      {
        const double d =
          std::abs(static_cast<double>(a.Get(x, y, c)) - static_cast<double>(b.Get(x, y, c)));
        result.Mean += d;
        differs = differs || !(d == 0.0);
        if (!(d <= result.Max))
        {
          result.Max = d;
          result.X = x;
          result.Y = y;
        }
      }
      result.Pixels += differs ? 1 : 0;
    }
  }
  result.Mean /= static_cast<double>(a.Values.size());
  return result;
}

/** Mean of a component over the image. */
double Mean(const Floats& image, int component);
double Mean(const Pixels& image, int component);
bool IsFinite(const Floats& image);

using Vec3 = std::array<double, 3>;

vtkSmartPointer<vtkActor> MakeActor(vtkAlgorithm* source, const Vec3& color = { 0.8, 0.8, 0.8 });
/** A parallelogram; its normal is (point1 - origin) x (point2 - origin). */
vtkSmartPointer<vtkActor> MakeQuad(const Vec3& origin, const Vec3& point1, const Vec3& point2,
  const Vec3& color = { 0.8, 0.8, 0.8 }, int resolution = 1);
/** A texture of 4 x 4 texels of different colours. */
vtkSmartPointer<vtkTexture> MakeColorfulTexture();
vtkSmartPointer<vtkActor> MakeSphere(
  const Vec3& center, double radius, const Vec3& color = { 0.8, 0.8, 0.8 }, int resolution = 32);
vtkSmartPointer<vtkActor> MakeBox(
  const Vec3& lower, const Vec3& upper, const Vec3& color = { 0.8, 0.8, 0.8 });

enum class LightKind
{
  Directional,
  Spot,
  WideSpot,
  Point
};
const char* GetName(LightKind kind);
vtkSmartPointer<vtkLight> MakeLight(
  LightKind kind, const Vec3& position, const Vec3& focalPoint, double coneAngle = 40.0);

/** The unit room: red left and green right wall, a sphere, a spot below the ceiling, an eye. */
void AddRoom(vtkRenderer* renderer);
/** The room without its light. */
void AddRoomSurfaces(vtkRenderer* renderer);

/** A letter that turns to the renderer's camera. */
vtkSmartPointer<vtkProp3D> MakeFollower(vtkRenderer* renderer, double scale);

/** Adds one actor or prop of each kind that VTK draws as opaque, in a grid; names returns their
 * kinds. */
void AddKinds(vtkRenderer* renderer, std::vector<std::string>* names = nullptr,
  const std::string& only = std::string());
}

#endif
