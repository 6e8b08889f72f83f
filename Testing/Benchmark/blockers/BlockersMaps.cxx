// SPDX-License-Identifier: BSD-3-Clause
#include "BlockersMaps.h"

#include "OpenGL/vtkIndirectKernels.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectKernels;

namespace
{
// Tangent of a texel's center.
double FindTangent(int texel)
{
  return VTKI_TILE_TANGENT * (2.0 * (texel + 0.5) / BlockersMaps::Texels - 1.0);
}
}

//------------------------------------------------------------------------------
void BlockersMaps::Draw(const BlockersScene& scene)
{
  constexpr size_t size = static_cast<size_t>(Texels) * Texels;
  this->Tiles.clear();
  this->Inverse.assign(size * scene.Lights.size(), 1.0f / VTKI_TILE_FAR);
  for (const BlockersPlace& light : scene.Lights)
  {
    Tile tile;
    tile.Axis = glm::vec3(light.Normal);
    tile.Place = glm::vec3(light.Position);
    vtkiFrameAlong(tile.Axis, tile.Up, tile.Right);
    float* texels = &this->Inverse[size * this->Tiles.size()];
    this->Tiles.push_back(tile);
    if (!scene.IsMesh())
    {
      this->DrawSpheres(scene, tile, texels);
      continue;
    }
    for (int y = 0; y < Texels; ++y)
    {
      for (int x = 0; x < Texels; ++x)
      {
        const glm::dvec3 ray = FindTangent(x) * glm::dvec3(tile.Right) +
          FindTangent(y) * glm::dvec3(tile.Up) + glm::dvec3(tile.Axis);
        const double length = glm::length(ray);
        // What is nearer than the map's near plane is not in it.
        const double near = VTKI_TILE_NEAR;
        const double distance =
          scene.FindDistance(light.Position + near * ray, ray / length, 2.0 * length);
        if (distance > 0.0)
        {
          texels[Texels * y + x] =
            std::max(static_cast<float>(1.0 / (near + distance / length)), 1.0f / VTKI_TILE_FAR);
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void BlockersMaps::DrawSpheres(const BlockersScene& scene, const Tile& tile, float* texels) const
{
  for (const glm::dvec4& sphere : scene.Spheres)
  {
    const glm::dvec3 away = glm::dvec3(sphere) - glm::dvec3(tile.Place);
    const glm::dvec3 c(glm::dot(away, glm::dvec3(tile.Right)), glm::dot(away, glm::dvec3(tile.Up)),
      glm::dot(away, glm::dvec3(tile.Axis)));
    const double r = sphere.w;
    if (c.z + r <= VTKI_TILE_NEAR)
    {
      continue;
    }
    // Texels that it may cover: all where it reaches behind the light, else the bounds of its box.
    int first[2] = { 0, 0 };
    int last[2] = { Texels - 1, Texels - 1 };
    for (int axis = 0; c.z - r > VTKI_TILE_NEAR && axis < 2; ++axis)
    {
      const double lower = std::min((c[axis] - r) / (c.z - r), (c[axis] - r) / (c.z + r));
      const double upper = std::max((c[axis] + r) / (c.z - r), (c[axis] + r) / (c.z + r));
      const double scale = 0.5 * Texels / VTKI_TILE_TANGENT;
      first[axis] = static_cast<int>(std::max(0.0, std::floor(0.5 * Texels + scale * lower)));
      last[axis] = static_cast<int>(
        std::min(Texels - 1.0, std::max(-1.0, std::floor(0.5 * Texels + scale * upper))));
    }
    const double beside = glm::dot(c, c) - r * r;
    for (int y = first[1]; y <= last[1]; ++y)
    {
      for (int x = first[0]; x <= last[0]; ++x)
      {
        const glm::dvec3 ray(FindTangent(x), FindTangent(y), 1.0);
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
          float& texel = texels[Texels * y + x];
          texel = std::max(texel, static_cast<float>(1.0 / depth));
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
bool BlockersMaps::IsSeen(size_t light, const glm::vec3& position, const glm::vec3& normal) const
{
  const Tile& tile = this->Tiles[light];
  const glm::vec3 way = position - tile.Place;
  const glm::vec3 away(glm::dot(tile.Right, way), glm::dot(tile.Up, way), glm::dot(tile.Axis, way));
  const glm::vec3 n(
    glm::dot(tile.Right, normal), glm::dot(tile.Up, normal), glm::dot(tile.Axis, normal));
  const float border = std::max(std::abs(away.x), std::abs(away.y)) * (1.0f / VTKI_TILE_TANGENT);
  const float scale =
    (0.499995f / VTKI_TILE_TANGENT) * Texels / std::max(std::max(away.z, border), VTKI_TILE_NEAR);
  const float x = std::floor(away.x * scale);
  const float y = std::floor(away.y * scale);
  const size_t at = static_cast<size_t>(Texels) *
      (light * Texels + static_cast<size_t>(static_cast<int>(y) + Texels / 2)) +
    static_cast<size_t>(static_cast<int>(x) + Texels / 2);
  const float texel = 2.0f * VTKI_TILE_TANGENT / Texels;
  const float along = n.x * (x + 0.5f) * texel + n.y * (y + 0.5f) * texel + n.z;
  return vtkiIsSeenInPerspectiveTile(
    this->Inverse[at], away.z, border, glm::dot(n, away), along, VTKI_TILE_ROUGHNESS * texel);
}

//------------------------------------------------------------------------------
std::vector<float> BlockersMaps::GetAtlas(int columns) const
{
  const size_t width = static_cast<size_t>(columns) * Texels;
  std::vector<float> atlas(width * width, 0.0f);
  for (size_t i = 0; i < this->Inverse.size(); ++i)
  {
    const size_t tile = i / (Texels * Texels);
    const size_t x = tile % columns * Texels + i % Texels;
    const size_t y = tile / columns * Texels + i / Texels % Texels;
    atlas[width * y + x] =
      (1.0f / VTKI_TILE_NEAR - this->Inverse[i]) / (1.0f / VTKI_TILE_NEAR - 1.0f / VTKI_TILE_FAR);
  }
  return atlas;
}
