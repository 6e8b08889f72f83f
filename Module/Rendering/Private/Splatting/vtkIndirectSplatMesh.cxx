// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Splatting/vtkIndirectSplatMesh.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

//------------------------------------------------------------------------------
vtkIndirectSplatMesh::~vtkIndirectSplatMesh()
{
  if (this->Window)
  {
    this->Window->MakeCurrent();
    this->Release(this->Window);
  }
}

//------------------------------------------------------------------------------
vtkIndirectSplatMesh::Polyhedron vtkIndirectSplatMesh::MakePolyhedron()
{
  using Index = unsigned short;
  // The icosahedron: corners on three golden rectangles.
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  Polyhedron mesh;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int corner = 0; corner < 4; ++corner)
    {
      glm::dvec3 p(0.0);
      p[axis] = (corner & 1) ? 1.0 : -1.0;
      p[(axis + 1) % 3] = (corner & 2) ? golden : -golden;
      mesh.Corners.push_back(glm::normalize(p));
    }
  }
  // Its faces: corners an edge apart, which is 2 in the rectangles.
  const double edge = 2.0 / std::sqrt(1.0 + golden * golden);
  auto touch = [&](Index a, Index b)
  { return glm::length(mesh.Corners[a] - mesh.Corners[b]) < 1.1 * edge; };
  std::vector<std::array<Index, 3>> faces;
  for (Index a = 0; a < 12; ++a)
  {
    for (Index b = a + 1; b < 12; ++b)
    {
      for (Index c = b + 1; c < 12; ++c)
      {
        if (touch(a, b) && touch(b, c) && touch(a, c))
        {
          const glm::dvec3 normal =
            glm::cross(mesh.Corners[b] - mesh.Corners[a], mesh.Corners[c] - mesh.Corners[a]);
          const bool outward = glm::dot(normal, mesh.Corners[a]) > 0.0;
          faces.push_back({ a, outward ? b : c, outward ? c : b });
        }
      }
    }
  }
  // Splits each face into four at the middles of its edges.
  std::map<std::pair<Index, Index>, Index> middles;
  auto middle = [&](Index a, Index b)
  {
    const auto key = std::minmax(a, b);
    const auto found = middles.find(key);
    if (found != middles.end())
    {
      return found->second;
    }
    const auto index = static_cast<Index>(mesh.Corners.size());
    mesh.Corners.push_back(glm::normalize(mesh.Corners[a] + mesh.Corners[b]));
    middles[key] = index;
    return index;
  };
  for (const std::array<Index, 3>& f : faces)
  {
    const Index m[3] = { middle(f[0], f[1]), middle(f[1], f[2]), middle(f[2], f[0]) };
    mesh.Triangles.push_back({ f[0], m[0], m[2] });
    mesh.Triangles.push_back({ f[1], m[1], m[0] });
    mesh.Triangles.push_back({ f[2], m[2], m[1] });
    mesh.Triangles.push_back({ m[0], m[1], m[2] });
  }
  // Enlarges the polyhedron until its nearest face is outside the unit ball.
  double nearest = 1.0;
  for (const std::array<Index, 3>& t : mesh.Triangles)
  {
    const glm::dvec3 a = mesh.Corners[t[0]];
    const glm::dvec3 normal =
      glm::normalize(glm::cross(mesh.Corners[t[1]] - a, mesh.Corners[t[2]] - a));
    nearest = std::min(nearest, glm::dot(normal, a));
  }
  for (glm::dvec3& corner : mesh.Corners)
  {
    corner *= 1.0 / nearest;
  }
  return mesh;
}

//------------------------------------------------------------------------------
void vtkIndirectSplatMesh::Create(vtkOpenGLRenderWindow* window)
{
  const Polyhedron mesh = MakePolyhedron();
  std::vector<float> corners;
  auto add = [&corners](const glm::dvec3& corner)
  {
    for (int c = 0; c < 3; ++c)
    {
      // The corner is rounded outwards.
      corners.push_back(static_cast<float>(corner[c] * (1.0 + 1e-6)));
    }
  };
  std::for_each(mesh.Corners.begin(), mesh.Corners.end(), add);
  this->FirstOfRectangle = static_cast<int>(mesh.Corners.size());
  for (int i = 0; i < 4; ++i)
  {
    for (const float c : { (i & 1) ? 1.0f : -1.0f, (i & 2) ? 1.0f : -1.0f, 0.0f })
    {
      corners.push_back(c);
    }
  }
  const size_t sizes[2] = { corners.size() * sizeof(float),
    mesh.Triangles.size() * sizeof(mesh.Triangles[0]) };
  this->NumberOfIndices = static_cast<int>(3 * mesh.Triangles.size());
  this->Bytes = sizes[0] + sizes[1];
  this->Window = window;
  glGenVertexArrays(1, &this->VertexArray);
  glGenBuffers(2, this->Buffers);
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->Buffers[0]);
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(sizes[0]), corners.data(), GL_STATIC_DRAW);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->Buffers[1]);
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(sizes[1]), mesh.Triangles.data(),
    GL_STATIC_DRAW);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

//------------------------------------------------------------------------------
void vtkIndirectSplatMesh::Draw(
  vtkOpenGLRenderWindow* window, int attribute, bool rectangles, int instances)
{
  if (this->VertexArray == 0)
  {
    this->Create(window);
  }
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ARRAY_BUFFER, this->Buffers[0]);
  glEnableVertexAttribArray(static_cast<GLuint>(attribute));
  glVertexAttribPointer(static_cast<GLuint>(attribute), 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  if (rectangles)
  {
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, this->FirstOfRectangle, 4, instances);
  }
  else
  {
    glDrawElementsInstanced(
      GL_TRIANGLES, this->NumberOfIndices, GL_UNSIGNED_SHORT, nullptr, instances);
  }
  glDisableVertexAttribArray(static_cast<GLuint>(attribute));
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
void vtkIndirectSplatMesh::ReleaseOwn(vtkWindow*)
{
  if (this->VertexArray)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    glDeleteBuffers(2, this->Buffers);
    this->VertexArray = 0;
    this->Buffers[0] = this->Buffers[1] = 0;
  }
  this->Bytes = 0;
  this->Window = nullptr;
}
