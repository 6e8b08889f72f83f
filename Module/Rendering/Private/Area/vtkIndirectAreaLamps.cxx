// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Area/vtkIndirectAreaLamps.h"

#include "Emitters/vtkIndirectEmitterAccess.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectSamplePattern.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

namespace
{
const vtkIndirectChannels PyramidChannels = {
  { "area.pyramid", "vtkiAreaPyramid", "mean radiance; three times its variance below", GL_RGBA32F,
    "-", "VTK radiance" },
};

// Rows of the images' common texture: half of what every OpenGL 4 allows, to be safe.
constexpr int MostRows = 8192;

// Makes a net of points of the square: any power of two of points is such a net, and so is any run
// of that many points from a multiple of it on. The flipped digits put the point of each cell of
// 16, 64 or 1024 points near the cell's middle.
glm::dvec2 PlaceOf(unsigned int number)
{
  constexpr unsigned int flipped = (1u << 27) | (1u << 25) | (1u << 21);
  return glm::dvec2(vtkIndirectSamplePattern::SobolDigits(number) ^ flipped) / 4294967296.0;
}
}

//------------------------------------------------------------------------------
vtkIndirectAreaLamps::vtkIndirectAreaLamps(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Texture(this, PyramidChannels, false)
{
}

//------------------------------------------------------------------------------
int vtkIndirectAreaLamps::GetNumberOfPoints() const
{
  const int count = static_cast<int>(this->Lamps.size());
  return std::max(MostPoints / std::max(count, 1), LeastPoints);
}

//------------------------------------------------------------------------------
// Weights of images come from a level that is as fine as the points of all rounds.
std::vector<vtkIndirectAreaLamps::Point> vtkIndirectAreaLamps::MakePoints(
  const Lamp& lamp, int round) const
{
  const int count = this->GetNumberOfPoints();
  std::vector<Point> points(static_cast<size_t>(count));
  for (int k = 0; k < count; ++k)
  {
    points[static_cast<size_t>(k)].Place = PlaceOf(static_cast<unsigned int>(round * count + k));
  }
  if (lamp.Pyramid.IsUniform())
  {
    return points;
  }
  const int level = std::max(lamp.Pyramid.GetTop() - 5, 0);
  const int edge = lamp.Pyramid.GetEdge(level);
  const glm::dvec3 unit = glm::max(lamp.Radiance, glm::dvec3(1e-300));
  if (round > 0)
  {
    for (Point& point : points)
    {
      const glm::ivec2 texel(point.Place * (1.0 * edge));
      point.Weight = glm::dvec3(lamp.Pyramid.GetMean(level, texel.x, texel.y)) / unit;
    }
    return points;
  }
  const glm::dvec2 lengths(glm::length(lamp.Edge1), glm::length(lamp.Edge2));
  for (Point& point : points)
  {
    point.Weight = glm::dvec3(0.0);
  }
  for (int y = 0; y < edge; ++y)
  {
    for (int x = 0; x < edge; ++x)
    {
      const glm::dvec2 place(glm::dvec2(x + 0.5, y + 0.5) / (1.0 * edge));
      Point* nearest = nullptr;
      double least = 0.0;
      for (Point& point : points)
      {
        const glm::dvec2 apart = (point.Place - place) * lengths;
        const double square = glm::dot(apart, apart);
        if (!nearest || square < least)
        {
          nearest = &point;
          least = square;
        }
      }
      nearest->Weight += glm::dvec3(lamp.Pyramid.GetMean(level, x, y)) / unit *
        (static_cast<double>(count) / (1.0 * edge * edge));
    }
  }
  return points;
}

//------------------------------------------------------------------------------
void vtkIndirectAreaLamps::UpdateLamp(Lamp& lamp, vtkAreaLight* light, int texels)
{
  static_cast<vtkIndirectRectangle&>(lamp) =
    vtkIndirectRectangle(light, this->SceneCenter, this->SceneScale);
  light->GetMeanRadiance(&lamp.Radiance[0]);
  if (lamp.Light.Take({ "light", light }) || lamp.Pyramid.GetEdge(0) > texels)
  {
    int columns;
    int rows;
    const std::vector<float>& radiances =
      vtkIndirectEmitterAccess::GetRadiances(light, columns, rows);
    lamp.Pyramid.Build(radiances, columns, rows, texels);
    lamp.TextureIsStale = true;
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaLamps::Update(
  const vtkIndirectFrame& frame, const std::vector<vtkSmartPointer<vtkAreaLight>>& lights)
{
  std::vector<vtkAreaLight*> lit;
  for (const auto& light : lights)
  {
    double mean[3];
    light->GetMeanRadiance(mean);
    if (light->GetSwitch() && std::max({ mean[0], mean[1], mean[2] }) > 0.0)
    {
      lit.push_back(light);
    }
  }
  bool same = lit.size() == this->Lamps.size() && frame.SceneScale == this->SceneScale &&
    frame.SceneCenter == this->SceneCenter;
  for (size_t i = 0; same && i < lit.size(); ++i)
  {
    same = this->Lamps[i]->Light == vtkIndirectKey("light", lit[i]);
  }
  if (same)
  {
    return false;
  }
  this->SceneScale = frame.SceneScale;
  this->SceneCenter = frame.SceneCenter;
  this->Lamps.resize(std::min(this->Lamps.size(), lit.size()));
  while (this->Lamps.size() < lit.size())
  {
    this->Lamps.push_back(std::make_unique<Lamp>());
  }
  const int count = static_cast<int>(lit.size());
  int texels = vtkIndirectAreaPyramid::MostTexels;
  while (texels > 1 && texels * count > MostRows)
  {
    texels /= 2;
  }
  for (size_t i = 0; i < lit.size(); ++i)
  {
    this->UpdateLamp(*this->Lamps[i], lit[i], texels);
  }
  this->PlaceImages();
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectAreaLamps::PlaceImages()
{
  this->Width = this->Height = 0;
  for (const auto& lamp : this->Lamps)
  {
    const int row = lamp->Pyramid.IsUniform() ? -1 : this->Height;
    lamp->TextureIsStale = lamp->TextureIsStale || row != lamp->Row;
    lamp->Row = row;
    if (row >= 0)
    {
      const int edge = lamp->Pyramid.GetEdge(0);
      this->Height += edge;
      this->Width = std::max(this->Width, edge + (edge + 1) / 2);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaLamps::UpdateTexture(const vtkIndirectFrame& frame)
{
  if (this->Height == 0)
  {
    this->Texture.Release(frame.Window);
    return true;
  }
  const bool anew = !this->Texture.GetFramebuffer() || this->Texture.GetWidth() != this->Width ||
    this->Texture.GetHeight() != this->Height;
  if (!this->Texture.Resize(frame.Window, this->Width, this->Height))
  {
    return false;
  }
  for (const auto& lamp : this->Lamps)
  {
    if (lamp->Row >= 0 && (anew || lamp->TextureIsStale))
    {
      this->Texture.Write(0, lamp->Pyramid.MakeTexture(this->Width), lamp->Row);
      lamp->TextureIsStale = false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectAreaLamps::ReleaseOwn(vtkWindow*)
{
  this->Lamps.clear();
  this->Width = this->Height = 0;
}
