// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Visibility/vtkIndirectDistanceField.h"

#include "OpenGL/vtkIndirectUniforms.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace
{
// A column of 128 voxels along z.
struct Column
{
  std::uint64_t Low = 0;
  std::uint64_t High = 0;

  Column operator|(const Column& other) const
  {
    return { this->Low | other.Low, this->High | other.High };
  }
};

// Grows a column by a voxel along z.
Column GrowColumn(const Column& c)
{
  return { c.Low | c.Low << 1 | c.Low >> 1 | c.High << 63,
    c.High | c.High << 1 | c.High >> 1 | c.Low >> 63 };
}

using Columns = std::vector<Column>;

// Joins every column with its neighbours along x (axis 0) or y (axis 1).
void GrowAcross(const Columns& from, Columns& to, const glm::ivec3& size, int axis)
{
  const int step = axis == 0 ? 1 : size.x;
  vtkSMPTools::For(0, size.y,
    [&](vtkIdType begin, vtkIdType end)
    {
      for (int y = static_cast<int>(begin); y < static_cast<int>(end); ++y)
      {
        for (int x = 0; x < size.x; ++x)
        {
          const int at = axis == 0 ? x : y;
          const size_t i = x + static_cast<size_t>(size.x) * y;
          Column sum = from[i];
          sum = at > 0 ? sum | from[i - step] : sum;
          to[i] = at + 1 < size[axis] ? sum | from[i + step] : sum;
        }
      }
    });
}
}

//------------------------------------------------------------------------------
void vtkIndirectDistanceField::Build(const vtkIndirectOccupancyVolume& volume)
{
  this->Size = volume.GetSize();
  this->Origin = glm::vec3(volume.ToScene(glm::dvec3(0.0)));
  this->VoxelsPerUnit = static_cast<float>(1.0 / volume.GetVoxelSize());
  this->Texture.Clear();
  const glm::ivec3 size = this->Size;
  const size_t count = static_cast<size_t>(size.x) * size.y;
  // A voxel far from all occupied ones keeps the largest distance that is stored.
  constexpr int most = std::numeric_limits<unsigned char>::max();
  this->Voxels.assign(count * size.z, most);
  Columns known(count); // voxels whose distance is known
  Columns grown(count); // voxels within the current distance
  Columns across(count);
  for (size_t i = 0; i < count; ++i)
  {
    const glm::uvec4& bits = volume.GetColumns()[i];
    grown[i].Low = bits.x | static_cast<std::uint64_t>(bits.y) << 32;
    grown[i].High = bits.z | static_cast<std::uint64_t>(bits.w) << 32;
  }
  const int longest = std::max({ size.x, size.y, size.z });
  for (int distance = 0; distance < longest; ++distance)
  {
    if (distance > 0)
    {
      for (Column& column : grown)
      {
        column = GrowColumn(column);
      }
      GrowAcross(grown, across, size, 0);
      GrowAcross(across, grown, size, 1);
    }
    std::vector<char> rowsWithNew(size.y, 0);
    vtkSMPTools::For(0, size.y,
      [&](vtkIdType begin, vtkIdType end)
      {
        for (size_t i = begin * size.x; i < static_cast<size_t>(end) * size.x; ++i)
        {
          const Column fresh = { grown[i].Low & ~known[i].Low, grown[i].High & ~known[i].High };
          for (int z = 0; (fresh.Low | fresh.High) != 0 && z < size.z; ++z)
          {
            const std::uint64_t word = z < 64 ? fresh.Low : fresh.High;
            if (word >> (z & 63) & 1u)
            {
              this->Voxels[i + count * z] = static_cast<unsigned char>(distance);
              rowsWithNew[i / size.x] = 1;
            }
          }
          known[i] = grown[i];
        }
      });
    if (std::find(rowsWithNew.begin(), rowsWithNew.end(), 1) == rowsWithNew.end())
    {
      break;
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectDistanceField::Activate(
  vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program) const
{
  if (this->Texture.IsEmpty())
  {
    this->Texture.Set(
      window, vtkIndirectDataTexture::INTEGER_BYTES, 1, this->Size, this->Voxels.data());
  }
  this->Texture.Activate(program, "vtkiDistanceField");
  vtkIndirectSetUniform(
    program, "vtkiDistanceFieldOrigin", glm::vec4(this->Origin, this->VoxelsPerUnit));
  vtkIndirectSetUniform(program, "vtkiDistanceFieldSize", glm::vec3(this->Size));
}
