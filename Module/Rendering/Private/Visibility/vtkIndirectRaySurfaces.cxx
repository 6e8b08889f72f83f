// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectRaySurfaces.h"

#include "Frame/vtkIndirectActors.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectPropKind.h"
#include "Visibility/vtkIndirectRayPiece.h"
#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{
bool IsOfSpheres(const vtkIndirectBlockingSpheres* spheres, const vtkMapper* mapper)
{
  return spheres &&
    std::find(spheres->Mappers.begin(), spheres->Mappers.end(), mapper) != spheres->Mappers.end();
}
}

//------------------------------------------------------------------------------
vtkIndirectRaySurfaces::vtkIndirectRaySurfaces() = default;
vtkIndirectRaySurfaces::~vtkIndirectRaySurfaces() = default;

//------------------------------------------------------------------------------
void vtkIndirectRaySurfaces::Clear()
{
  this->Pieces.clear();
  this->Triangles = {};
  this->Spheres = {};
  this->Tree.Clear();
  this->Key.clear();
  this->Shape.clear();
  this->LeftOut.clear();
}

//------------------------------------------------------------------------------
void vtkIndirectRaySurfaces::LeaveOut(const std::string& what, const std::string& why)
{
  const std::pair<std::string, std::string> entry(what, why);
  if (std::find(this->LeftOut.begin(), this->LeftOut.end(), entry) == this->LeftOut.end())
  {
    this->LeftOut.push_back(entry);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectRaySurfaces::Update(
  const vtkIndirectFrame& frame, const vtkIndirectBlockingSpheres* spheres)
{
  std::vector<double> key(frame.SceneBounds, frame.SceneBounds + 6);
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    key.push_back(static_cast<double>(reinterpret_cast<uintptr_t>(caster.Prop)));
    key.push_back(static_cast<double>(caster.Revision));
    key.push_back(caster.SendsLight ? 1.0 : 0.0);
  }
  // Splats may be drawn as spheres, and are no casters.
  key.push_back(spheres ? static_cast<double>(spheres->NumberOfUpdates) : -1.0);
  key.push_back(spheres ? static_cast<double>(spheres->NumberOfLooks) : -1.0);
  if (key == this->Key)
  {
    return false;
  }
  std::vector<double> shape;
  this->Read(frame, spheres, shape);
  this->Key = key;
  if (shape != this->Shape)
  {
    this->MakeTree();
    this->Shape = shape;
  }
  for (const auto& piece : this->Pieces)
  {
    piece->ForgetTriangles();
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectRaySurfaces::MakeTree()
{
  this->Tree.Clear();
  this->Triangles.clear();
  for (size_t number = 0; number < this->Pieces.size(); ++number)
  {
    const vtkIndirectPolygons& piece = this->Pieces[number]->GetPolygons();
    for (const vtkIndirectPolygons::Triangle& triangle : piece.Triangles)
    {
      const glm::dvec3 corners[3] = { piece.Positions[static_cast<size_t>(triangle.Points[0])],
        piece.Positions[static_cast<size_t>(triangle.Points[1])],
        piece.Positions[static_cast<size_t>(triangle.Points[2])] };
      if (this->Tree.Add(corners))
      {
        this->Triangles.push_back(
          { static_cast<uint32_t>(number), static_cast<uint32_t>(triangle.Cell),
            { static_cast<uint32_t>(triangle.Points[0]), static_cast<uint32_t>(triangle.Points[1]),
              static_cast<uint32_t>(triangle.Points[2]) } });
      }
    }
  }
  // Who found them has left out those without radius or place.
  for (const Sphere& sphere : this->Spheres)
  {
    this->Tree.AddSphere(sphere.Center, sphere.Radius);
  }
  this->Tree.Finish(true);
  ++this->NumberOfBuilds;
}

//------------------------------------------------------------------------------
void vtkIndirectRaySurfaces::Read(const vtkIndirectFrame& frame,
  const vtkIndirectBlockingSpheres* spheres, std::vector<double>& shape)
{
  this->Pieces.clear();
  this->LeftOut.clear();
  size_t mostTriangles = MostTrianglesOfGlyphs;
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    const size_t before = this->Pieces.size();
    vtkIndirectPolygons::Read(frame, caster.Prop,
      [&](vtkIndirectPolygons& taken)
      {
        if (!taken.Material.GetLeftOut().empty())
        {
          this->LeaveOut(
            vtkIndirectPropKind::GetFullName(caster.Prop), taken.Material.GetLeftOut());
        }
        this->Pieces.push_back(std::make_unique<vtkIndirectRayPiece>(std::move(taken)));
        this->Pieces.back()->Sends = caster.SendsLight;
      });
    this->ReadGlyphs(frame, caster, spheres, mostTriangles);
    size_t triangles = 0;
    for (size_t i = before; i < this->Pieces.size(); ++i)
    {
      triangles += this->Pieces[i]->GetPolygons().Triangles.size();
    }
    bool met = triangles > 0;
    vtkIndirectActors::ForEach(caster.Prop,
      [&](vtkActor* actor, vtkMatrix4x4*)
      { met = met || IsOfSpheres(spheres, actor->GetMapper()); });
    if (!met)
    {
      this->LeaveOut(vtkIndirectPropKind::GetFullName(caster.Prop),
        "its mapper has no polygons that the processor can read; rays pass through it");
    }
  }
  this->ReadSpheres(spheres);
  shape = { frame.SceneCenter.x, frame.SceneCenter.y, frame.SceneCenter.z, frame.SceneScale,
    spheres ? static_cast<double>(spheres->NumberOfUpdates) : -1.0 };
  for (const auto& piece : this->Pieces)
  {
    piece->AppendShape(shape);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectRaySurfaces::ReadGlyphs(const vtkIndirectFrame& frame,
  const vtkIndirectCaster& caster, const vtkIndirectBlockingSpheres* spheres, size_t& mostTriangles)
{
  vtkIndirectActors::ForEach(caster.Prop,
    [&](vtkActor* actor, vtkMatrix4x4* matrix)
    {
      if (IsOfSpheres(spheres, actor->GetMapper()))
      {
        return;
      }
      if (!actor->GetMapper()->IsA("vtkGlyph3DMapper"))
      {
        // Of a whole prop of them its name is said.
        const bool impostors = actor != caster.Prop &&
          (actor->GetMapper()->IsA("vtkOpenGLSphereMapper") ||
            actor->GetMapper()->IsA("vtkOpenGLStickMapper") ||
            actor->GetMapper()->IsA("vtkMoleculeMapper"));
        if (impostors)
        {
          this->LeaveOut(actor->GetMapper()->GetClassName(), "rays pass through what it draws");
        }
        return;
      }
      const bool all = vtkIndirectRayPiece::ReadGlyphs(frame, actor,
        vtkIndirectFrame::ToGLM(matrix), mostTriangles,
        [&](std::unique_ptr<vtkIndirectRayPiece> piece)
        {
          piece->Sends = caster.SendsLight;
          if (!piece->GetPolygons().Material.GetLeftOut().empty())
          {
            this->LeaveOut(vtkIndirectPropKind::GetFullName(caster.Prop),
              piece->GetPolygons().Material.GetLeftOut());
          }
          this->Pieces.push_back(std::move(piece));
        });
      if (!all)
      {
        this->LeaveOut("glyphs",
          "they have more than " + std::to_string(MostTrianglesOfGlyphs) +
            " triangles; rays pass through those beyond");
      }
    });
}

//------------------------------------------------------------------------------
void vtkIndirectRaySurfaces::ReadSpheres(const vtkIndirectBlockingSpheres* spheres)
{
  this->Spheres.clear();
  for (size_t i = 0; spheres && i < spheres->Spheres.size(); ++i)
  {
    const glm::dvec4& sphere = spheres->Spheres[i];
    this->Spheres.push_back({ glm::dvec3(sphere), sphere.w,
      i < spheres->Looks.size() ? spheres->Looks[i] : vtkIndirectBlockingSpheres::Look() });
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectRaySurfaces::Meet(
  const glm::dvec3& start, const glm::dvec3& direction, uint32_t except, Meeting& meeting) const
{
  glm::dvec3 from = start;
  double passed = 0.0;
  uint32_t last = except;
  vtkIndirectTriangleTree::Hit hit;
  // Through what is culled; layers of it without end would be rounding's.
  for (int layer = 0; layer < 64 && this->Tree.FindNearest(from, direction, last, hit); ++layer)
  {
    meeting.Triangle = hit.Triangle;
    meeting.Distance = passed + hit.Distance;
    if (hit.Triangle >= this->Triangles.size())
    {
      const Sphere& sphere = this->Spheres[hit.Triangle - this->Triangles.size()];
      meeting.Normal = meeting.FacetNormal =
        glm::dvec3(hit.Weights[0], hit.Weights[1], hit.Weights[2]);
      meeting.Position = sphere.Center + sphere.Radius * meeting.Normal;
      meeting.Albedo = glm::dvec3(sphere.Look.Albedo);
      meeting.PhysicallyBased = sphere.Look.PhysicallyBased;
      meeting.Sends = true;
      return true;
    }
    const Triangle& triangle = this->Triangles[hit.Triangle];
    const vtkIndirectRayPiece& piece = *this->Pieces[triangle.Piece];
    const std::vector<glm::dvec3>& positions = piece.GetPolygons().Positions;
    const glm::dvec3& a = positions[triangle.Points[0]];
    const glm::dvec3& b = positions[triangle.Points[1]];
    const glm::dvec3& c = positions[triangle.Points[2]];
    const glm::dvec3 facet = glm::normalize(glm::cross(b - a, c - a));
    const bool front = glm::dot(facet, direction) < 0.0;
    meeting.Position = hit.Weights[0] * a + hit.Weights[1] * b + hit.Weights[2] * c;
    if (piece.Culls(front))
    {
      from = meeting.Position;
      passed += hit.Distance;
      last = hit.Triangle;
      continue;
    }
    meeting.FacetNormal = front ? facet : -facet;
    const vtkIndirectMaterial& material = piece.GetPolygons().Material;
    const vtkIndirectMaterial::Place place = { static_cast<vtkIdType>(triangle.Cell),
      { static_cast<vtkIdType>(triangle.Points[0]), static_cast<vtkIdType>(triangle.Points[1]),
        static_cast<vtkIdType>(triangle.Points[2]) },
      { hit.Weights[0], hit.Weights[1], hit.Weights[2] }, front };
    meeting.Sends = piece.FindNormal(place, meeting.FacetNormal, meeting.Normal) && piece.Sends &&
      material.IsLit();
    meeting.Albedo = piece.FindAlbedo(place);
    meeting.PhysicallyBased = material.IsPhysicallyBased();
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
size_t vtkIndirectRaySurfaces::GetBytes() const
{
  size_t bytes = this->Tree.GetBytes() + this->Triangles.size() * sizeof(Triangle) +
    this->Spheres.size() * sizeof(Sphere);
  for (const auto& piece : this->Pieces)
  {
    bytes += piece->GetBytes();
  }
  return bytes;
}
