// SPDX-License-Identifier: BSD-3-Clause
#include "Error/vtkIndirectPathImage.h"

#include "Senders/vtkIndirectSamplePattern.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace
{
// Paths of a pixel in a round: with fewer their variance is unknown, and small pictures need no
// more.
constexpr int FewestPaths = 4;
constexpr double MostPaths = 16.0;
constexpr std::uint32_t Seed = 0x3c6ef372u;
}

//------------------------------------------------------------------------------
void vtkIndirectPathImage::Clear()
{
  this->Tracer.reset();
  this->Pixels = {};
  this->Correction = {};
  for (vtkImageData* image : { this->GetNormal(), this->GetDepth(), this->GetIrradiance() })
  {
    image->Initialize();
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectPathImage::GetBytes() const
{
  size_t bytes = this->Pixels.size() * sizeof(Pixel) + this->Correction.size() * sizeof(glm::vec3);
  for (vtkImageData* image : { this->GetNormal(), this->GetDepth(), this->GetIrradiance() })
  {
    bytes += static_cast<size_t>(image->GetActualMemorySize()) * 1024;
  }
  return bytes;
}

//------------------------------------------------------------------------------
int vtkIndirectPathImage::GetColumns(const vtkIndirectFrame& frame) const
{
  return (frame.Size[0] + this->Step - 1) / this->Step;
}

//------------------------------------------------------------------------------
// Returns the number of a pixel with paths among all pixels of the picture.
vtkIdType vtkIndirectPathImage::GetIndex(const vtkIndirectFrame& frame, size_t pixel) const
{
  const auto columns = static_cast<size_t>(this->GetColumns(frame));
  return static_cast<vtkIdType>(pixel / columns) * this->Step * frame.Size[0] +
    static_cast<vtkIdType>(pixel % columns) * this->Step;
}

//------------------------------------------------------------------------------
void vtkIndirectPathImage::Begin(const vtkIndirectFrame& frame, vtkIndirectPathTracer tracer)
{
  this->Tracer.emplace(std::move(tracer));
  const double pixels = static_cast<double>(frame.Size[0]) * frame.Size[1];
  const auto count = [&] { return PathsOfRound * this->Step * this->Step / pixels; };
  for (this->Step = 1; count() < FewestPaths;)
  {
    this->Step *= 2;
  }
  this->PathsOfPixel = static_cast<int>(std::min(count(), MostPaths));
  const int rows = (frame.Size[1] + this->Step - 1) / this->Step;
  this->Pixels.assign(static_cast<size_t>(this->GetColumns(frame)) * rows, Pixel());
  this->Correction = {};
}

//------------------------------------------------------------------------------
void vtkIndirectPathImage::AddPaths(const vtkIndirectFrame& frame, int part, int parts)
{
  const auto all = static_cast<vtkIdType>(this->Pixels.size());
  vtkSMPTools::For(all * part / parts, all * (part + 1) / parts,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        Pixel& pixel = this->Pixels[static_cast<size_t>(i)];
        const vtkIdType index = this->GetIndex(frame, static_cast<size_t>(i));
        vtkIndirectPathTracer::Place place;
        if (vtkIndirectErrorProbe::FindPlace(
              frame, this->Tracer->GetSurfaces(), this->GetImages(), index, place))
        {
          pixel.Position = place.Position;
          pixel.Normal = place.Normal;
          const std::uint32_t seed =
            vtkIndirectSamplePattern::Hash(static_cast<std::uint32_t>(index) + Seed);
          this->Tracer->AddPaths(
            place, seed, pixel.Paths, this->PathsOfPixel, pixel.Sum, pixel.Squares);
          pixel.Paths += this->PathsOfPixel;
        }
      }
    });
}

//------------------------------------------------------------------------------
long long vtkIndirectPathImage::CountPaths() const
{
  long long paths = 0;
  for (const Pixel& pixel : this->Pixels)
  {
    paths += pixel.Paths;
  }
  return paths;
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectResidual> vtkIndirectPathImage::FindResiduals(
  const vtkIndirectFrame& frame) const
{
  const Images images = this->GetImages();
  std::vector<vtkIndirectResidual> residuals(this->Pixels.size());
  for (size_t i = 0; i < residuals.size(); ++i)
  {
    const Pixel& pixel = this->Pixels[i];
    if (pixel.Paths > 1 && std::isfinite(pixel.Squares))
    {
      const auto count = static_cast<float>(pixel.Paths);
      const glm::vec3 mean = pixel.Sum / count;
      const float variance = pixel.Squares / count - glm::dot(mean, mean) / 3.0f;
      residuals[i] = { pixel.Position, pixel.Normal,
        mean - glm::vec3(images.GetIrradiance(this->GetIndex(frame, i))),
        std::max(variance, 0.0f) / (count - 1.0f) };
    }
  }
  return residuals;
}

//------------------------------------------------------------------------------
// Interpolates between the four pixels with paths around one, as far as they show its surface.
glm::vec3 vtkIndirectPathImage::Interpolate(const vtkIndirectFrame& frame,
  const std::vector<vtkIndirectResidual>& image, vtkIdType index) const
{
  vtkIndirectResidual own;
  const Images images = this->GetImages();
  own.Normal = images.GetNormal(index);
  const double depth = images.GetDepth(index);
  if (!own.HasSurface() || !(depth > 0.0))
  {
    return glm::vec3(0.0f);
  }
  own.Position =
    frame.FindPlace(vtkIndirectErrorProbe::FindMiddle(frame, index), depth * frame.SceneScale);
  const int columns = this->GetColumns(frame);
  const int rows = static_cast<int>(image.size()) / columns;
  const glm::dvec2 at =
    glm::dvec2(index % frame.Size[0], index / frame.Size[0]) / static_cast<double>(this->Step);
  const glm::ivec2 first(at);
  glm::vec3 sum(0.0f);
  float weights = 0.0f;
  for (int corner = 0; corner < 4; ++corner)
  {
    const glm::ivec2 place = first + glm::ivec2(corner & 1, corner >> 1);
    if (place.x < columns && place.y < rows)
    {
      const vtkIndirectResidual& other = image[static_cast<size_t>(place.y) * columns + place.x];
      const glm::vec2 near = 1.0 - glm::abs(at - glm::dvec2(place));
      const float weight = other.HasSurface() ? near.x * near.y * own.FindLikeness(other) : 0.0f;
      sum += weight * other.Value;
      weights += weight;
    }
  }
  return weights > 0.0f ? sum / weights : glm::vec3(0.0f);
}

//------------------------------------------------------------------------------
std::vector<float> vtkIndirectPathImage::ChangeCorrection(const vtkIndirectFrame& frame)
{
  std::vector<vtkIndirectResidual> image = this->FindResiduals(frame);
  vtkIndirectResidual::Filter(image, this->GetColumns(frame));
  const size_t pixels = static_cast<size_t>(frame.Size[0]) * frame.Size[1];
  this->Correction.resize(pixels, glm::vec3(0.0f));
  std::vector<float> change(4 * pixels, 0.0f);
  const Images images = this->GetImages();
  vtkSMPTools::For(0, static_cast<vtkIdType>(pixels),
    [&](vtkIdType begin, vtkIdType end)
    {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const auto place = static_cast<size_t>(i);
        const glm::vec3 correction =
          glm::max(this->Step == 1 ? image[place].Value : this->Interpolate(frame, image, i),
            -glm::vec3(images.GetIrradiance(i)));
        const glm::vec3 added = correction - this->Correction[place];
        std::copy(&added.x, &added.x + 3, &change[4 * place]);
        this->Correction[place] = correction;
      }
    });
  return change;
}
