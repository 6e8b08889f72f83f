// SPDX-License-Identifier: BSD-3-Clause
// The distance of each voxel of an occupancy volume to the nearest occupied one, so that a segment
// leaps over empty space. A distance is the greatest of the three along the axes (chessboard), and
// 0 in occupied voxels. The columns of bits, grown by a voxel at a time, give the distances.
#ifndef vtkIndirectDistanceField_h
#define vtkIndirectDistanceField_h

#include "vtkSmartPointer.h" // for the texture

#include <cstddef>     // for size_t
#include <glm/glm.hpp> // for vectors
#include <vector>      // for distances

class vtkIndirectOccupancyVolume;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkIndirectDistanceField
{
public:
  vtkIndirectDistanceField();
  ~vtkIndirectDistanceField();

  void Build(const vtkIndirectOccupancyVolume& volume);

  int Get(const glm::ivec3& voxel) const
  {
    return this->Voxels[voxel.x +
      static_cast<size_t>(this->Size.x) * (voxel.y + static_cast<size_t>(this->Size.y) * voxel.z)];
  }

  /**
   * Returns true if a segment (voxel coordinates) meets no occupied voxel except those of its ends.
   */
  bool IsFree(const glm::vec3& start, const glm::vec3& end) const;
  /** An end of a segment: a place on a surface. */
  struct End
  {
    glm::vec3 Position; // voxels
    glm::vec3 Normal;
    glm::vec3 Open; // place nearby where no voxel of its own surface blocks; see FindEnd
  };

  /**
   * Makes an end from a position in scene units and a unit normal. Its open place lies above the
   * surface's own voxels and, if another surface occupies that place, beside the voxels of that
   * surface where possible.
   */
  End FindEnd(const glm::vec3& position, const glm::vec3& normal) const;
  /**
   * Returns true if nothing blocks the segment between two places that face each other; the voxels
   * of their own planes do not count.
   */
  bool IsVisible(const End& receiver, const End& sender) const;

  /** Binds the distances for vtkIndirectVisibility.glsl; pair with Deactivate. */
  void Activate(vtkOpenGLRenderWindow* window, vtkShaderProgram* program) const;
  void Deactivate() const;
  size_t GetBytes() const { return this->Uploaded ? this->Voxels.size() : 0; }
  size_t GetMainMemoryBytes() const { return this->Voxels.size(); }
  void Release(vtkWindow* window);

private:
  glm::ivec3 Size{ 0 };
  glm::vec3 Origin{ 0.0f };
  float VoxelsPerUnit = 1.0f;
  std::vector<unsigned char> Voxels;
  mutable vtkSmartPointer<vtkTextureObject> Texture;
  mutable bool Uploaded = false;
};

#endif
