// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Capture/vtkIndirectTexelTriangles.h"

#include "Capture/vtkIndirectDepthTile.h"
#include "Frame/vtkIndirectFrame.h"
#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkPolyData.h"
#include "vtkProp.h"

#include <algorithm>

namespace
{
// With fewer triangles for a texel, many of them cover its centre.
constexpr size_t LeastTrianglesOfTexel = 4;

// Places lie this many texels farther from the view's edge, so that none of those near the view is
// negative; farther ones stay as far outside.
constexpr float Shift = 16.0f;
constexpr float MostOutside = 8.0f;
// OpenGL places corners at steps of 1/256 of a texel or less, and matrices are rounded.
constexpr float CenterMargin = 0.125f;

// Returns true if a texel's centre lies between two places along an axis; centres have whole
// numbers.
bool HoldsCenter(float a, float b, float c, float last)
{
  const float lower = std::min(std::min(a, b), c) - CenterMargin;
  const float upper = std::max(std::max(a, b), c) + CenterMargin;
  return static_cast<float>(static_cast<int>(upper)) >= lower && upper >= Shift && lower <= last;
}
}

//------------------------------------------------------------------------------
vtkIndirectTexelTriangles::Scope::Scope(vtkIndirectTexelTriangles& triangles,
  const vtkIndirectFrame& frame, const vtkIndirectDepthTile& view, int texels, vtkProp* prop)
{
  if (!IsWorthIt(view, texels, prop))
  {
    return;
  }
  const Mesh& mesh = triangles.Read(prop);
  if (mesh.Triangles.empty())
  {
    return;
  }
  this->Prop = prop;
  this->Own = vtkIndirectDepthDrawer::GetIndices(prop);
  triangles.Project(
    mesh, view.GetWorldToClip(frame) * vtkIndirectFrame::ToGLM(prop->GetMatrix()), texels);
  size_t first = 0;
  for (size_t i = 0; i < this->Own.size(); ++i)
  {
    const size_t count = this->Own[i]->IndexCount / 3;
    const std::vector<unsigned int> chosen = triangles.Choose(mesh, first, count, texels);
    first += count;
    this->Short[i]->IndexCount = chosen.size();
    if (!chosen.empty())
    {
      this->Short[i]->Upload(chosen, vtkOpenGLBufferObject::ElementArrayBuffer);
    }
  }
  vtkIndirectDepthDrawer::SetIndices(prop, { this->Short[0], this->Short[1] });
}

//------------------------------------------------------------------------------
vtkIndirectTexelTriangles::Scope::~Scope()
{
  if (this->Prop)
  {
    vtkIndirectDepthDrawer::SetIndices(this->Prop, this->Own);
    for (const auto& buffer : this->Short)
    {
      buffer->ReleaseGraphicsResources();
    }
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectTexelTriangles::IsWorthIt(
  const vtkIndirectDepthTile& view, int texels, vtkProp* prop)
{
  using namespace vtkIndirectBackEndChoices;
  const size_t least = LeastTrianglesOfTexel * static_cast<size_t>(texels) * texels;
  return view.Parallel && Get(Triangles) == TrianglesOfTexels &&
    vtkIndirectDepthDrawer::CanDraw(prop) &&
    vtkIndirectDepthDrawer::CountTriangles(prop) >= least &&
    !vtkIndirectDepthDrawer::NumbersTriangles(prop);
}

//------------------------------------------------------------------------------
const vtkIndirectTexelTriangles::Mesh& vtkIndirectTexelTriangles::Read(vtkProp* prop)
{
  const auto [found, fresh] = this->Meshes.try_emplace(prop);
  Mesh& mesh = found->second;
  if (fresh)
  {
    mesh.Triangles = vtkIndirectDepthDrawer::ReadTriangles(prop);
    vtkPolyData* data = vtkIndirectDepthDrawer::FindMesh(prop);
    data->GetPoint(0, &mesh.First[0]);
    mesh.Points.reserve(static_cast<size_t>(data->GetNumberOfPoints()));
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      glm::dvec3 p;
      data->GetPoint(i, &p[0]);
      mesh.Points.emplace_back(p - mesh.First);
    }
  }
  return mesh;
}

//------------------------------------------------------------------------------
// Finds the places of a mesh's points.
void vtkIndirectTexelTriangles::Project(const Mesh& mesh, const glm::dmat4& toClip, int texels)
{
  const double half = 0.5 * texels;
  const glm::dvec4 first = toClip * glm::dvec4(mesh.First, 1.0);
  // The centre of a view's first texel has the place Shift.
  const glm::vec2 origin(half * (glm::dvec2(first) + 1.0) - 0.5 + static_cast<double>(Shift));
  const glm::vec2 x(half * glm::dvec2(toClip[0]));
  const glm::vec2 y(half * glm::dvec2(toClip[1]));
  const glm::vec2 z(half * glm::dvec2(toClip[2]));
  const glm::vec2 lower(Shift - MostOutside);
  const glm::vec2 upper(static_cast<float>(texels) + Shift + MostOutside);
  this->Places.resize(mesh.Points.size());
  for (size_t i = 0; i < mesh.Points.size(); ++i)
  {
    const glm::vec3& p = mesh.Points[i];
    this->Places[i] = glm::clamp(origin + p.x * x + p.y * y + p.z * z, lower, upper);
  }
}

//------------------------------------------------------------------------------
// Returns the indices of those triangles, of so many from the first on, whose bounds hold the
// centre of a texel.
std::vector<unsigned int> vtkIndirectTexelTriangles::Choose(
  const Mesh& mesh, size_t first, size_t count, int texels) const
{
  std::vector<unsigned int> chosen;
  const float last = static_cast<float>(texels - 1) + Shift;
  for (size_t i = first; i < first + count; ++i)
  {
    const vtkIndirectMeshParts::Triangle& t = mesh.Triangles[i];
    const glm::vec2& a = this->Places[t[0]];
    const glm::vec2& b = this->Places[t[1]];
    const glm::vec2& c = this->Places[t[2]];
    if (HoldsCenter(a.x, b.x, c.x, last) && HoldsCenter(a.y, b.y, c.y, last))
    {
      chosen.insert(chosen.end(), t.begin(), t.end());
    }
  }
  return chosen;
}
