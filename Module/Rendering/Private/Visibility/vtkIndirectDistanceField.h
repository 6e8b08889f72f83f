// SPDX-License-Identifier: BSD-3-Clause
// The distance of each voxel of an occupancy volume to the nearest occupied one, so that a segment
// leaps over empty space. A distance is the greatest of the three along the axes (chessboard), and
// 0 in occupied voxels. The columns of bits, grown by a voxel at a time, give the distances.
#pragma once

#include "OpenGL/vtkIndirectDataTexture.h" // for a member
#include "OpenGL/vtkIndirectResource.h"    // for the base class

#include <cstddef>     // for size_t
#include <glm/glm.hpp> // for vectors
#include <vector>      // for distances

class vtkIndirectOccupancyVolume;
class vtkOpenGLRenderWindow;

class vtkIndirectDistanceField : public vtkIndirectResource
{
public:
  using vtkIndirectResource::vtkIndirectResource;

  void Build(const vtkIndirectOccupancyVolume& volume);

  int Get(const glm::ivec3& voxel) const
  {
    return this->Voxels[voxel.x +
      static_cast<size_t>(this->Size.x) * (voxel.y + static_cast<size_t>(this->Size.y) * voxel.z)];
  }

  const glm::ivec3& GetSize() const { return this->Size; }
  glm::vec3 ToVoxels(const glm::vec3& position) const
  {
    return (position - this->Origin) * this->VoxelsPerUnit;
  }

  /** Binds the distances for vtkIndirectVisibility.glsl. */
  void Activate(vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program) const;
  size_t GetMainMemoryBytes() const { return this->Voxels.size(); }

private:
  glm::ivec3 Size{ 0 };
  glm::vec3 Origin{ 0.0f };
  float VoxelsPerUnit = 1.0f;
  std::vector<unsigned char> Voxels;
  mutable vtkIndirectDataTexture Texture{ this };
};
