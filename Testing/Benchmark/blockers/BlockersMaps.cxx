// SPDX-License-Identifier: BSD-3-Clause
#include "BlockersMaps.h"

#include "OpenGL/vtkIndirectKernels.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectKernels;

namespace
{
// Tangents of a texel's center in a view.
glm::dvec2 FindTangents(const vtkIndirectDepthTile& view, const glm::ivec2& size, int x, int y)
{
  const glm::dvec2 place = 2.0 * (glm::dvec2(x, y) + 0.5) / glm::dvec2(size) - 1.0;
  return view.Middle + place * view.HalfWidth;
}
}

//------------------------------------------------------------------------------
void BlockersMaps::Draw(const BlockersScene& scene)
{
  constexpr size_t size = static_cast<size_t>(Texels) * Rows;
  this->Tiles.clear();
  this->Inverse.assign(size * scene.Lights.size(), 1.0f / VTKI_TILE_FAR);
  for (const BlockersPlace& light : scene.Lights)
  {
    const vtkIndirectDepthTile tile =
      vtkIndirectDepthTile::FromPlace(light.Position, glm::dvec3(glm::vec3(light.Normal)));
    float* texels = &this->Inverse[size * this->Tiles.size()];
    this->Tiles.push_back(tile);
    for (int view = 0; view < vtkIndirectDepthTile::NumberOfViews; ++view)
    {
      if (scene.IsMesh())
      {
        DrawMesh(scene, tile, view, texels);
      }
      else
      {
        DrawSpheres(scene, tile, view, texels);
      }
    }
  }
}

//------------------------------------------------------------------------------
void BlockersMaps::DrawMesh(
  const BlockersScene& scene, const vtkIndirectDepthTile& tile, int number, float* texels)
{
  const vtkIndirectDepthTile view = tile.GetView(number);
  const glm::ivec2 size = vtkIndirectDepthTile::GetSizeOfView(number, Texels);
  const glm::ivec2 first = vtkIndirectDepthTile::GetPlaceOfView(number, Texels, true);
  for (int y = 0; y < size.y; ++y)
  {
    for (int x = 0; x < size.x; ++x)
    {
      const glm::dvec2 tangents = FindTangents(view, size, x, y);
      const glm::dvec3 ray = tangents.x * view.Right + tangents.y * view.Up + view.Forward;
      const double length = glm::length(ray);
      // What is nearer than the map's near plane is not in it.
      const double near = VTKI_TILE_NEAR;
      const double distance =
        scene.FindDistance(tile.Place + near * ray, ray / length, 2.0 * length);
      if (distance > 0.0)
      {
        texels[Texels * (first.y + y) + first.x + x] =
          std::max(static_cast<float>(1.0 / (near + distance / length)), 1.0f / VTKI_TILE_FAR);
      }
    }
  }
}

//------------------------------------------------------------------------------
void BlockersMaps::DrawSpheres(
  const BlockersScene& scene, const vtkIndirectDepthTile& tile, int number, float* texels)
{
  const vtkIndirectDepthTile view = tile.GetView(number);
  const glm::ivec2 size = vtkIndirectDepthTile::GetSizeOfView(number, Texels);
  const glm::ivec2 place = vtkIndirectDepthTile::GetPlaceOfView(number, Texels, true);
  for (const glm::dvec4& sphere : scene.Spheres)
  {
    const glm::dvec3 away = glm::dvec3(sphere) - view.Place;
    const glm::dvec3 c(
      glm::dot(away, view.Right), glm::dot(away, view.Up), glm::dot(away, view.Forward));
    const double r = sphere.w;
    if (c.z + r <= VTKI_TILE_NEAR)
    {
      continue;
    }
    // Texels that it may cover: all where it reaches behind the light, else the bounds of its box.
    int first[2] = { 0, 0 };
    int last[2] = { size.x - 1, size.y - 1 };
    for (int axis = 0; c.z - r > VTKI_TILE_NEAR && axis < 2; ++axis)
    {
      const double lower = std::min((c[axis] - r) / (c.z - r), (c[axis] - r) / (c.z + r));
      const double upper = std::max((c[axis] + r) / (c.z - r), (c[axis] + r) / (c.z + r));
      const double scale = 0.5 * size[axis] / view.HalfWidth[axis];
      const double middle = 0.5 * size[axis] - scale * view.Middle[axis];
      first[axis] = static_cast<int>(std::max(0.0, std::floor(middle + scale * lower)));
      last[axis] = static_cast<int>(
        std::min(size[axis] - 1.0, std::max(-1.0, std::floor(middle + scale * upper))));
    }
    const double beside = glm::dot(c, c) - r * r;
    for (int y = first[1]; y <= last[1]; ++y)
    {
      for (int x = first[0]; x <= last[0]; ++x)
      {
        const glm::dvec3 ray(FindTangents(view, size, x, y), 1.0);
        const double b = glm::dot(ray, c);
        const double a = glm::dot(ray, ray);
        const double root = b * b - a * beside;
        if (root < 0.0)
        {
          continue;
        }
        double depth = (b - std::sqrt(root)) / a;
        depth = depth > VTKI_TILE_NEAR ? depth : (b + std::sqrt(root)) / a;
        if (depth > VTKI_TILE_NEAR)
        {
          float& texel = texels[Texels * (place.y + y) + place.x + x];
          texel = std::max(texel, static_cast<float>(1.0 / depth));
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
bool BlockersMaps::IsSeen(size_t light, const glm::vec3& position, const glm::vec3& normal) const
{
  const vtkIndirectDepthTile& tile = this->Tiles[light];
  const glm::vec3 axes[3] = { glm::vec3(tile.Right), glm::vec3(tile.Up), glm::vec3(tile.Forward) };
  const glm::vec3 way = position - glm::vec3(tile.Place);
  const vtkiTileView found = vtkiFindTileView(
    glm::vec3(glm::dot(axes[0], way), glm::dot(axes[1], way), glm::dot(axes[2], way)),
    glm::vec3(glm::dot(axes[0], normal), glm::dot(axes[1], normal), glm::dot(axes[2], normal)),
    VTKI_TILE_TANGENT);
  const int number = found.strip + 1;
  const vtkIndirectDepthTile view = tile.GetView(number);
  const glm::ivec2 size = vtkIndirectDepthTile::GetSizeOfView(number, Texels);
  const glm::ivec2 first = vtkIndirectDepthTile::GetPlaceOfView(number, Texels, true);
  const glm::vec2 place =
    (glm::vec2(found.away) / std::max(found.away.z, VTKI_TILE_NEAR) - glm::vec2(view.Middle)) /
    glm::vec2(view.HalfWidth);
  const glm::ivec2 at(
    glm::floor((glm::clamp(place, -0.99999f, 0.99999f) + 1.0f) * 0.5f * glm::vec2(size)));
  const glm::dvec2 tangents = FindTangents(view, size, at.x, at.y);
  const float along = found.normal.x * static_cast<float>(tangents.x) +
    found.normal.y * static_cast<float>(tangents.y) + found.normal.z;
  const glm::dvec2 texel = 2.0 * view.HalfWidth / glm::dvec2(size);
  const size_t row = light * Rows + static_cast<size_t>(first.y + at.y);
  return vtkiIsSeenInPerspectiveTile(
    this->Inverse[row * Texels + static_cast<size_t>(first.x + at.x)], found.away.z,
    glm::dot(found.normal, found.away), along,
    VTKI_TILE_ROUGHNESS * static_cast<float>(std::max(texel.x, texel.y)));
}

//------------------------------------------------------------------------------
std::vector<float> BlockersMaps::GetAtlas(int columns) const
{
  const size_t width = static_cast<size_t>(columns) * Texels;
  std::vector<float> atlas(width * static_cast<size_t>(columns) * Rows, 0.0f);
  for (size_t i = 0; i < this->Inverse.size(); ++i)
  {
    const size_t tile = i / (Texels * Rows);
    const size_t x = tile % columns * Texels + i % Texels;
    const size_t y = tile / columns * Rows + i / Texels % Rows;
    atlas[width * y + x] =
      (1.0f / VTKI_TILE_NEAR - this->Inverse[i]) / (1.0f / VTKI_TILE_NEAR - 1.0f / VTKI_TILE_FAR);
  }
  return atlas;
}
