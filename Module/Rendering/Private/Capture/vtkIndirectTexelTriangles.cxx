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
constexpr size_t LeastTrianglesOfTexel = 4;
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
  const glm::dmat4 toClip = view.GetWorldToClip(frame) * vtkIndirectFrame::ToGLM(prop->GetMatrix());
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
