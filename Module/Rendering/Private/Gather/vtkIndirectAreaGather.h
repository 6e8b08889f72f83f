// SPDX-License-Identifier: BSD-3-Clause
// The irradiance that comes directly from area lights, at every pixel: in closed form if nothing
// hid them (images: texels of a pyramid, as fine as the tolerance asks for), times the share of the
// light that is seen. That share is a ratio of two sums over a few points of the light, each with a
// depth map of its own: where nothing is hidden it is one, and there is no noise.
//
// Points stay where they are on the rectangle while its image changes, and with them their maps.
#ifndef vtkIndirectAreaGather_h
#define vtkIndirectAreaGather_h

#include "Gather/vtkIndirectAreaPyramid.h"       // for members
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "OpenGL/vtkIndirectUniformBlock.h"      // for members
#include "Visibility/vtkIndirectDepthAtlas.h"    // for members
#include "vtkSmartPointer.h"                     // for lights

#include <memory> // for lamps
#include <string> // for definitions
#include <vector> // for lists

class vtkAreaLight;
class vtkIndirectGeometryBuffer;
class vtkSurfaceCapturePass;
class vtkWindow;
struct vtkIndirectFrame;
struct vtkIndirectPlan;
struct vtkIndirectReport;

class vtkIndirectAreaGather
{
public:
  vtkIndirectAreaGather();

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectPlan& Plan;
    const vtkIndirectGeometryBuffer& Geometry;
    vtkSurfaceCapturePass* Capture;
    const std::vector<vtkSmartPointer<vtkAreaLight>>& Lights;
  };

  /**
   * Brings lights and depth maps up to date, at most so many of these. Returns false, after an
   * error, when OpenGL refuses.
   */
  bool Update(const Input& input, int most);
  /** Whether all maps are there and up to date. */
  bool IsComplete() const;
  /** Grows when lights or maps have changed. */
  size_t GetContentTime() const { return this->ContentTime; }
  /** Sums. Returns false, after an error. */
  bool Sum(const Input& input);

  /** Irradiance in VTK's units, a value for every pixel. */
  const vtkIndirectTarget& GetIrradiance() const { return this->Irradiance; }

  size_t GetNumberOfTilesDrawn() const { return this->Atlas.GetNumberOfTilesDrawn(); }
  size_t GetBytes() const;
  void AddToReport(vtkIndirectReport& report) const;
  void Release(vtkWindow* window);

private:
  // A point of a light: where, what it stands for, and its places in the atlas.
  struct Point
  {
    glm::dvec2 Place;          // in [0,1) along the edges
    glm::dvec3 Weight;         // radiance over the mean
    int Tiles[2] = { -1, -1 }; // of the front, and of the back
  };
  struct Lamp
  {
    vtkAreaLight* Light = nullptr; // to be compared only
    vtkMTimeType Time = 0;         // of the light that the rest was made from
    glm::dvec3 Corner{ 0.0 };      // scene units
    glm::dvec3 Edge1{ 0.0 };
    glm::dvec3 Edge2{ 0.0 };
    glm::dvec3 Normal{ 0.0 };
    glm::dvec3 Radiance{ 0.0 }; // mean
    bool TwoSided = false;
    vtkIndirectAreaPyramid Pyramid;
    std::unique_ptr<vtkIndirectTarget> Texture; // null where the radiance is one
    bool TextureIsStale = true;
    std::vector<Point> Points;
  };

  void UpdateLamps(const Input& input);
  void UpdatePoints(Lamp& lamp, int count);
  bool UpdateMaps(const Input& input, int most);
  bool UpdateTexture(const Input& input, Lamp& lamp);
  void SetLamp(const Input& input, vtkShaderProgram* program, const Lamp& lamp);
  void SetPoints(const Input& input, vtkShaderProgram* program, const Lamp& lamp);

  std::vector<std::unique_ptr<Lamp>> Lamps; // those that are on
  double SceneScale = 0.0;                  // that they were placed in
  glm::dvec3 SceneCenter{ 0.0 };
  vtkIndirectDepthAtlas Atlas;
  bool Visible = false; // something can hide them
  size_t ContentTime = 0;
  int NumberOfSummedPoints = 0; // of a lamp
  vtkIndirectUniformBlock Block{ "vtkiAreaBlock" };
  vtkIndirectFullScreenProgram Kernels[2]; // of one radiance, of images
  vtkIndirectTarget Irradiance;
};

#endif
