// SPDX-License-Identifier: BSD-3-Clause
// Corrects a picture by path tracing: paths from its pixels, on the processor, tell its error, and
// vtkIndirectResidual takes the noise of the paths out. So a picture of virtual lights with maps,
// which has no noise, and paths, which have no other error, become one that is nearer to the truth
// than either.
#pragma once

#include "Error/vtkIndirectErrorProbe.h" // for images
#include "Error/vtkIndirectResidual.h"   // for differences
#include "vtkImageData.h"                // for members
#include "vtkNew.h"                      // for members

#include <cstddef>     // for sizes
#include <glm/glm.hpp> // for vectors
#include <optional>    // for a member
#include <vector>      // for lists

class vtkIndirectPathImage
{
public:
  /** At most so many paths make a round, whatever the picture's size. */
  static constexpr int PathsOfRound = 1 << 21;

  /** These images are copied to before Begin. */
  vtkImageData* GetNormal() const { return this->Normal; }
  vtkImageData* GetDepth() const { return this->Depth; }
  vtkImageData* GetIrradiance() const { return this->Irradiance; } // of the picture to correct

  /** Forgets a picture. */
  void Clear();
  bool IsEmpty() const { return this->Pixels.empty(); }
  /** The picture to correct is another one, of the same surfaces. */
  void ForgetCorrection() { this->Correction = {}; }
  /** Begins the paths of a picture of these normals and depths; keeps the tracer until Clear. */
  void Begin(const vtkIndirectFrame& frame, vtkIndirectPathTracer tracer);
  /** Adds the paths of one of several parts of a round. */
  void AddPaths(const vtkIndirectFrame& frame, int part, int parts);
  /**
   * Returns the change of the correction since the last call, of pictures with this irradiance
   * before any correction: four floats a pixel.
   */
  std::vector<float> ChangeCorrection(const vtkIndirectFrame& frame);
  /** Returns the number of paths from all pixels. */
  long long CountPaths() const;
  size_t GetBytes() const;

private:
  struct Pixel
  {
    glm::vec3 Position{ 0.0f }; // of its surface, scene units
    glm::vec3 Normal{ 0.0f };
    glm::vec3 Sum{ 0.0f }; // VTK irradiance of all paths
    float Squares = 0.0f;
    int Paths = 0;
  };

  using Images = vtkIndirectErrorProbe::Images;
  Images GetImages() const { return { this->Irradiance, this->Normal, this->Depth }; }
  int GetColumns(const vtkIndirectFrame& frame) const;
  vtkIdType GetIndex(const vtkIndirectFrame& frame, size_t pixel) const;
  std::vector<vtkIndirectResidual> FindResiduals(const vtkIndirectFrame& frame) const;
  glm::vec3 Interpolate(const vtkIndirectFrame& frame,
    const std::vector<vtkIndirectResidual>& image, vtkIdType index) const;

  vtkNew<vtkImageData> Normal;
  vtkNew<vtkImageData> Depth;
  vtkNew<vtkImageData> Irradiance;
  std::optional<vtkIndirectPathTracer> Tracer;
  int Step = 1;              // from one pixel with paths to the next, along rows and columns
  int PathsOfPixel = 1;      // in a round
  std::vector<Pixel> Pixels; // those with paths
  std::vector<glm::vec3> Correction; // the last one
};
