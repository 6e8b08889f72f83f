// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Capture/vtkIndirectTexelTriangles.h"

#include "Capture/vtkIndirectDepthTile.h"
#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkPolyData.h"
#include "vtkProp.h"

#include <glm/gtc/matrix_transform.hpp>

namespace
{
// With fewer triangles for a texel, many of them cover its centre.
constexpr double LeastTrianglesOfTexel = 4.0;
// To send the indices of so few takes as long as to draw them all.
constexpr size_t FewestTriangles = 1000;

// Returns the share of a parallel view's picture that the bounds of a prop span, at most one.
double FindShare(const glm::dmat4& worldToClip, const double bounds[6])
{
  glm::dvec2 lower(1.0);
  glm::dvec2 upper(-1.0);
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec4 corner(vtkIndirectFrame::GetCorner(bounds, i), 1.0);
    const glm::dvec2 place = glm::clamp(glm::dvec2(worldToClip * corner), -1.0, 1.0);
    lower = glm::min(lower, place);
    upper = glm::max(upper, place);
  }
  return 0.25 * (upper.x - lower.x) * (upper.y - lower.y);
}
}

//------------------------------------------------------------------------------
vtkIndirectTexelTriangles::Scope::Scope(vtkIndirectTexelTriangles& triangles,
  const vtkIndirectFrame& frame, const vtkIndirectDepthTile& view, int texels, vtkProp* prop)
{
  if (!view.Parallel || !CanChoose(prop))
  {
    return;
  }
  const glm::dmat4 worldToClip = view.GetWorldToClip(frame);
  const double seen = FindShare(worldToClip, prop->GetBounds()) * texels * texels;
  if (static_cast<double>(vtkIndirectDepthDrawer::CountTriangles(prop)) <
    LeastTrianglesOfTexel * seen)
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
  const glm::dmat4 toClip = worldToClip * vtkIndirectFrame::ToGLM(prop->GetMatrix());
  triangles.Small.SetView(glm::mat4(glm::translate(toClip, mesh.First)), glm::ivec2(texels));
  triangles.Small.Project(mesh.Points);
  size_t first = 0;
  std::vector<unsigned int> chosen;
  for (size_t i = 0; i < this->Own.size(); ++i)
  {
    const size_t count = this->Own[i]->IndexCount / 3;
    chosen.clear();
    triangles.Small.Choose(&mesh.Triangles[first][0], 3 * count, chosen);
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
bool vtkIndirectTexelTriangles::CanChoose(vtkProp* prop)
{
  using namespace vtkIndirectBackEndChoices;
  return Get(Triangles) == TrianglesOfTexels && vtkIndirectDepthDrawer::CanDraw(prop) &&
    vtkIndirectDepthDrawer::CountTriangles(prop) >= FewestTriangles &&
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
