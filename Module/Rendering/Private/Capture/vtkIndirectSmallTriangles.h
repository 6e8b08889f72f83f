// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a mesh in a view of few texels, of which many cover no texel's centre and the
// others few: for OpenGL on the processor, which takes longer to transform and set up a triangle
// than this takes to leave it out or to write its depths.
#pragma once

#include <cstddef> // for size_t
#include <glm/glm.hpp>
#include <vector> // for lists

class vtkIndirectSmallTriangles
{
public:
  /** Sets a view, by the matrix from points to clip coordinates. emitter: its place and 1, or the
   * direction to it and 0. */
  void SetView(
    const glm::mat4& toClip, const glm::ivec2& texels, const glm::vec4& emitter = glm::vec4(0.0f));

  /** Finds the places of points in the view: of x, y, z alone. */
  void Project(const std::vector<glm::vec3>& points);
  /** Finds the places of points as vtkIndirectDepthVS.glsl reads them: six floats for each, of
   * which three are its inset. */
  void ProjectInsets(const float* points, size_t count);

  /** Appends the triangles with these indices that may cover a texel's centre, in their order. */
  void Choose(const unsigned int* indices, size_t count, std::vector<unsigned int>& chosen) const;
  /**
   * Writes the nearest depths of triangles to the texels of the view, rows from the bottom, by
   * OpenGL's rules. Triangles that are large, or cut by the near or the far plane, are left:
   * appends the place of the first index of each.
   */
  void Draw(
    const unsigned int* indices, size_t count, float* depths, std::vector<size_t>& left) const;

private:
  // This is a point's place in the view, in texels from the centre of the view's first one, and its
  // depth; a negative depth lies in front of the near plane.
  struct Place
  {
    float X;
    float Y;
    float Z;
  };
  // Range of texels whose centres lie within the bounds of a triangle.
  struct Centers
  {
    int Left;
    int Right;
    int Bottom;
    int Top;
  };

  glm::mat4 ToClip{ 1.0f };
  glm::vec4 Emitter{ 0.0f };
  glm::vec2 Half{ 0.0f };
  glm::vec2 Last{ 0.0f }; // place of the last texel's centre
  int Width = 0;
  std::vector<Place> Places;

  Place Find(const glm::vec3& point) const;
  bool FindCenters(
    const Place& a, const Place& b, const Place& c, float margin, Centers& found) const;
  bool DrawTriangle(
    const Place& a, const Place& b, const Place& c, const Centers& centers, float* depths) const;
};
