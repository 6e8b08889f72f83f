// SPDX-License-Identifier: BSD-3-Clause
#include "Error/vtkIndirectErrorProbe.h"

#include "Senders/vtkIndirectSamplePattern.h"
#include "vtkImageData.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

namespace
{
constexpr int PathsOfEstimate = 256;
constexpr size_t PixelsAtATime = 128;
constexpr size_t FewestPixels = 256;
constexpr size_t MostPixels = 1024;
// Where most of a picture shows no surface, no more candidates are looked at.
constexpr std::uint32_t MostCandidates = 16384;
// More pixels are traced while the squared error is known less well than this.
constexpr double WantedPrecision = 0.25;
// Largest relative departure of the depth from a plane through the pixels around, and least cosine
// between their normals, on a smooth surface: as of vtk-indirect compare.
constexpr double MostBend = 0.02;
constexpr double LeastCosineAround = 0.95;
// Greatest difference, of what a pixel shows and what its ray meets: of depths, as a share, and of
// normals, a cosine.
constexpr double MostDifference = 0.01;
constexpr double LeastCosine = 0.9;

const float* GetPixel(vtkImageData* image, vtkIdType index)
{
  return static_cast<const float*>(image->GetScalarPointer()) +
    index * image->GetNumberOfScalarComponents();
}

// Returns true if a pixel and those around it show one smooth surface: no silhouette, no crease. On
// a plane the inverse depth is linear over the image.
bool IsSmooth(const vtkIndirectErrorProbe::Images& images, int x, int y)
{
  const int* size = images.Depth->GetDimensions();
  if (x < 1 || y < 1 || x >= size[0] - 1 || y >= size[1] - 1)
  {
    return false;
  }
  const vtkIdType index = static_cast<vtkIdType>(y) * size[0] + x;
  const double depth = images.GetDepth(index);
  const glm::dvec3 normal = images.GetNormal(index);
  bool smooth = depth > 0.0 && glm::dot(normal, normal) > 0.5;
  for (const vtkIdType step : { 1, size[0], size[0] + 1, size[0] - 1 })
  {
    const double before = images.GetDepth(index - step);
    const double after = images.GetDepth(index + step);
    smooth = smooth && before > 0.0 && after > 0.0 &&
      std::abs(0.5 * (1.0 / before + 1.0 / after) * depth - 1.0) < MostBend &&
      glm::dot(images.GetNormal(index - step), normal) > LeastCosineAround &&
      glm::dot(images.GetNormal(index + step), normal) > LeastCosineAround;
  }
  return smooth;
}
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectErrorProbe::Images::GetIrradiance(vtkIdType index) const
{
  return glm::make_vec3(GetPixel(this->Irradiance, index));
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectErrorProbe::Images::GetNormal(vtkIdType index) const
{
  return glm::make_vec3(GetPixel(this->Normal, index));
}

//------------------------------------------------------------------------------
double vtkIndirectErrorProbe::Images::GetDepth(vtkIdType index) const
{
  return *GetPixel(this->Depth, index);
}

//------------------------------------------------------------------------------
glm::dvec2 vtkIndirectErrorProbe::FindMiddle(const vtkIndirectFrame& frame, vtkIdType index)
{
  const glm::dvec2 pixel(
    static_cast<double>(index % frame.Size[0]), static_cast<double>(index / frame.Size[0]));
  return (pixel + 0.5) / glm::dvec2(frame.Size[0], frame.Size[1]) * 2.0 - 1.0;
}

//------------------------------------------------------------------------------
void vtkIndirectErrorProbe::Clear()
{
  this->Pixels.clear();
  this->Candidates = 0;
}

//------------------------------------------------------------------------------
// Finds the surface of a candidate. Returns false if it is none whose light can be compared.
bool vtkIndirectErrorProbe::FindPixel(const vtkIndirectFrame& frame,
  const vtkIndirectSurfaces& surfaces, const Images& images, Pixel& pixel) const
{
  const glm::dvec2 at = vtkIndirectSamplePattern::ScrambledPoint(pixel.Candidate, 0x2f6b1d37u);
  const glm::dvec2 size(frame.Size[0], frame.Size[1]);
  const glm::dvec2 place = glm::min(glm::floor(at * size), size - 1.0);
  pixel.Index = static_cast<vtkIdType>(place.y) * frame.Size[0] + static_cast<vtkIdType>(place.x);
  if (!IsSmooth(images, static_cast<int>(place.x), static_cast<int>(place.y)))
  {
    return false;
  }
  return FindPlace(frame, surfaces, images, pixel.Index, pixel.Place);
}

//------------------------------------------------------------------------------
bool vtkIndirectErrorProbe::FindPlace(const vtkIndirectFrame& frame,
  const vtkIndirectSurfaces& surfaces, const Images& images, vtkIdType index,
  vtkIndirectPathTracer::Place& place)
{
  const glm::dvec3 normal = images.GetNormal(index);
  const double depth = images.GetDepth(index) * frame.SceneScale;
  if (!(depth > 0.0) || !(glm::dot(normal, normal) > 0.5))
  {
    return false;
  }
  const glm::dvec2 ndc = FindMiddle(frame, index);
  // A ray from just before the surface passes all that clips, culls or hides nothing of it.
  const glm::dvec3 start = frame.FindPlace(ndc, depth * (1.0 - MostDifference));
  const glm::dvec3 end = frame.FindPlace(ndc, depth * (1.0 + MostDifference));
  const glm::dvec3 direction = glm::normalize(end - start);
  if (!surfaces.Meet(start, direction, vtkIndirectTriangleTree::None, place) ||
    place.Distance > glm::length(end - start) || glm::dot(place.Normal, normal) < LeastCosine)
  {
    return false;
  }
  place.Normal = glm::normalize(normal);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectErrorProbe::AddPixels(
  const vtkIndirectFrame& frame, const vtkIndirectPathTracer& tracer, const Images& images)
{
  const size_t first = this->Pixels.size();
  while (this->Pixels.size() < first + PixelsAtATime && this->Candidates < MostCandidates)
  {
    Pixel pixel;
    pixel.Candidate = this->Candidates++;
    if (this->FindPixel(frame, tracer.GetSurfaces(), images, pixel))
    {
      this->Pixels.push_back(pixel);
    }
  }
  vtkSMPTools::For(static_cast<vtkIdType>(first), static_cast<vtkIdType>(this->Pixels.size()),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Pixel& pixel = this->Pixels[static_cast<size_t>(i)];
        for (std::uint32_t k = 0; k < 2; ++k)
        {
          const std::uint32_t seed =
            vtkIndirectSamplePattern::Hash(2u * pixel.Candidate + k + 0x68bc21ebu);
          pixel.Traced[k] = tracer.FindIrradiance(pixel.Place, seed, PathsOfEstimate);
        }
      }
    });
  return this->Pixels.size() > first;
}

//------------------------------------------------------------------------------
double vtkIndirectErrorProbe::Estimate(
  const vtkIndirectFrame& frame, const vtkIndirectPathTracer& tracer, const Images& images)
{
  // The pixels of an earlier estimate may suffice.
  bool adds = true;
  for (bool knows = this->Pixels.size() >= FewestPixels; adds; knows = false)
  {
    adds = knows || (this->Pixels.size() < MostPixels && this->AddPixels(frame, tracer, images));
    double mean = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (const Pixel& pixel : this->Pixels)
    {
      const glm::dvec3 shown = images.GetIrradiance(pixel.Index);
      const double product = glm::dot(shown - pixel.Traced[0], shown - pixel.Traced[1]) / 3.0;
      mean += glm::dot(pixel.Traced[0] + pixel.Traced[1], glm::dvec3(1.0 / 6.0));
      sum += product;
      squares += product * product;
    }
    const auto count = static_cast<double>(this->Pixels.size());
    if (!(count > 1.0) || !(mean > 0.0))
    {
      continue;
    }
    mean /= count;
    const double squared = sum / count;
    const double spread =
      std::sqrt(std::max(squares / count - squared * squared, 0.0) / (count - 1.0));
    if (!adds || (this->Pixels.size() >= FewestPixels && spread < WantedPrecision * squared))
    {
      return std::sqrt(std::max(squared, spread)) / mean;
    }
  }
  return -1.0;
}
