// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Area/vtkIndirectAreaBlock.h"

#include "Area/vtkIndirectAreaLamps.h"
#include "Area/vtkIndirectAreaMaps.h"
#include "OpenGL/vtkIndirectKernels.h"

#include <algorithm>
#include <vector>

namespace
{
constexpr size_t RowsOfLamp = 19;
constexpr size_t RowsOfPoint = 5;

glm::vec4 Row(const glm::dvec3& v, double w)
{
  return glm::vec4(glm::dvec4(v, w));
}
}

//------------------------------------------------------------------------------
vtkIndirectAreaBlock::vtkIndirectAreaBlock(vtkIndirectResource* owner, size_t lamps, size_t points)
  : vtkIndirectResource(owner)
  , Lamps(lamps)
  , Points(points)
{
}

//------------------------------------------------------------------------------
std::string vtkIndirectAreaBlock::GetDefinitions() const
{
  return "#define VTKI_AREA_LAMPS " + std::to_string(this->Lamps) + "\n#define VTKI_AREA_POINTS " +
    std::to_string(this->Points) + "\n";
}

//------------------------------------------------------------------------------
void vtkIndirectAreaBlock::Update(vtkOpenGLRenderWindow* window, const vtkIndirectAreaLamps& lamps,
  size_t first, size_t count, const vtkIndirectAreaMaps* maps)
{
  const size_t n = this->Lamps;
  const size_t all = n * this->Points;
  std::vector<glm::vec4> block(n * RowsOfLamp + all * RowsOfPoint, glm::vec4(0.0f));
  for (size_t i = 0; i < count; ++i)
  {
    const vtkIndirectAreaLamps::Lamp& lamp = *lamps.Get()[first + i];
    const size_t points =
      maps ? std::min(this->Points, maps->GetPoints(first + i).size()) : this->Points;
    glm::vec4* rows = block.data();
    rows[i] = Row(lamp.Corner, lamp.TwoSided ? 1.0 : 0.0);
    rows[n + i] = Row(lamp.Edge1, lamp.Row >= 0 ? lamp.Pyramid.GetTop() : -1);
    rows[2 * n + i] = Row(lamp.Edge2, lamp.Row);
    const double share = lamp.GetArea() / static_cast<double>(points);
    // Disks of further rounds lie between those of other rounds.
    const bool further = maps && maps->GetRound() > 0;
    rows[3 * n + i] =
      Row(lamp.Normal, further ? share / vtkIndirectAreaLamps::NumberOfRounds : share);
    rows[4 * n + i] = Row(lamp.Radiance, 0.0);
    rows += 5 * n;
    for (size_t side = 0; side < 2; ++side)
    {
      glm::vec3 right;
      glm::vec3 up;
      vtkIndirectKernels::vtkiFrameAlong(
        glm::vec3(side == 0 ? lamp.Normal : -lamp.Normal), up, right);
      const glm::dvec4 range = maps ? maps->GetRange(first + i, side) : glm::dvec4(0.0);
      rows[2 * i + side] = glm::vec4(right, static_cast<float>(range.x));
      rows[2 * n + 2 * i + side] = glm::vec4(up, static_cast<float>(range.y));
      rows[4 * n + 2 * i + side] = glm::vec4(glm::dvec4(range.z, range.w, 0.0, 0.0));
      for (size_t k = 0; maps && k < 4; ++k)
      {
        rows[6 * n + 4 * (2 * i + side) + k] = maps->GetStripWindow(first + i, side, k);
      }
      for (size_t k = 0; k < this->Points; ++k)
      {
        glm::vec4* row = rows + 14 * n + i * this->Points + k;
        row[side * all] = glm::vec4(-1.0f);
        row[(2 + side) * all] = glm::vec4(1.0f, 1.0f, 0.0f, 0.0f);
        if (maps && k < points)
        {
          const vtkIndirectAreaLamps::Point& point = maps->GetPoints(first + i)[k];
          const glm::vec3 place(point.Place.x * lamp.Edge1 + point.Place.y * lamp.Edge2);
          row[side * all] =
            glm::vec4(glm::dot(right, place), glm::dot(up, place), maps->GetMiddle(point, side));
          row[(2 + side) * all] = maps->GetWindow(point, side);
          row[4 * all] = Row(point.Weight * lamp.Radiance * share, 0.0);
        }
      }
    }
  }
  this->Block.Update(window, block.data(), block.size() * sizeof(glm::vec4));
}
