// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectSurfaces.h"

#include "Scene/vtkIndirectActors.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectPropKind.h"
#include "vtkActor.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"

#include <algorithm>
#include <iterator>

namespace
{
// Returns true if the mapper draws spheres alone, which are in the list of spheres.
bool IsOfSpheres(const vtkIndirectBlockingSpheres* spheres, const vtkMapper* mapper)
{
  return spheres &&
    std::find(spheres->Mappers.begin(), spheres->Mappers.end(), mapper) != spheres->Mappers.end();
}
}

//------------------------------------------------------------------------------
void vtkIndirectSurfaces::Clear()
{
  if (!this->Key.IsEmpty())
  {
    const size_t builds = this->NumberOfBuilds;
    *this = vtkIndirectSurfaces();
    this->NumberOfBuilds = builds;
    this->Time.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSurfaces::LeaveOut(const std::string& what, const std::string& why)
{
  const std::pair<std::string, std::string> entry(what, why);
  if (std::find(this->LeftOut.begin(), this->LeftOut.end(), entry) == this->LeftOut.end())
  {
    this->LeftOut.push_back(entry);
  }
}

//------------------------------------------------------------------------------
vtkIndirectKey vtkIndirectSurfaces::MakeKey(const vtkIndirectFrame& frame)
{
  vtkIndirectKey key;
  key.Add("bounds of the scene", frame.SceneBounds, 6);
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    caster.AppendTo(key);
  }
  return key;
}

//------------------------------------------------------------------------------
void vtkIndirectSurfaces::Update(
  const vtkIndirectFrame& frame, const vtkIndirectBlockingSpheres* spheres)
{
  const vtkIndirectKey key = MakeKey(frame);
  vtkIndirectKey spheresKey;
  spheresKey.Add("spheres", spheres != nullptr)
    .Add("spheres", spheres ? spheres->NumberOfUpdates : 0);
  spheresKey.Add("spheres", spheres ? spheres->NumberOfLooks : 0);
  const bool same = key == this->Key && spheresKey == this->SpheresKey;
  if (same && this->IsThere)
  {
    return;
  }
  vtkIndirectKey shape;
  this->Read(frame, spheres, shape);
  if (shape != this->Shape || !this->IsThere)
  {
    this->MakeTree();
  }
  this->Key = key;
  this->SpheresKey = spheresKey;
  this->Shape = shape;
  this->IsThere = true;
  if (!same)
  {
    this->Time.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectSurfaces::MakeTree()
{
  this->Tree.Clear();
  for (const Piece& piece : this->Pieces)
  {
    const std::vector<glm::dvec3>& positions = piece.Polygons.Positions;
    for (const vtkIndirectPolygons::Triangle& triangle : piece.Polygons.Triangles)
    {
      const glm::dvec3 corners[3] = { positions[triangle.Points[0]], positions[triangle.Points[1]],
        positions[triangle.Points[2]] };
      this->Tree.Add(corners);
    }
  }
  for (const glm::dvec4& sphere : this->Spheres)
  {
    this->Tree.AddSphere(glm::dvec3(sphere), sphere.w);
  }
  this->Tree.Finish();
  ++this->NumberOfBuilds;
}

//------------------------------------------------------------------------------
void vtkIndirectSurfaces::Take(
  const vtkIndirectCaster& caster, size_t number, vtkIndirectPolygons& polygons)
{
  if (!polygons.Material.GetLeftOut().empty())
  {
    this->LeaveOut(vtkIndirectPropKind::GetFullName(caster.Prop), polygons.Material.GetLeftOut());
  }
  polygons.Sends = caster.SendsLight;
  const uint32_t triangles = static_cast<uint32_t>(polygons.Triangles.size());
  this->Pieces.push_back({ std::move(polygons), number, this->NumberOfTriangles });
  this->NumberOfTriangles += triangles;
}

//------------------------------------------------------------------------------
void vtkIndirectSurfaces::Read(
  const vtkIndirectFrame& frame, const vtkIndirectBlockingSpheres* spheres, vtkIndirectKey& shape)
{
  this->Pieces.clear();
  this->DrawPolygonsAlone.clear();
  this->NumberOfTriangles = 0;
  this->LeftOut.clear();
  size_t mostTriangles = MostTrianglesOfGlyphs;
  for (size_t number = 0; number < frame.Casters.size(); ++number)
  {
    const vtkIndirectCaster& caster = frame.Casters[number];
    const uint32_t before = this->NumberOfTriangles;
    this->DrawPolygonsAlone.push_back(vtkIndirectPolygons::Read(frame, caster.Prop,
      [&](vtkIndirectPolygons& polygons) { this->Take(caster, number, polygons); }));
    this->ReadGlyphs(frame, number, spheres, mostTriangles);
    bool met = this->NumberOfTriangles > before;
    vtkIndirectActors::ForEach(caster.Prop,
      [&](vtkActor* actor, vtkMatrix4x4*)
      { met = met || IsOfSpheres(spheres, actor->GetMapper()); });
    if (!met)
    {
      this->LeaveOut(vtkIndirectPropKind::GetFullName(caster.Prop),
        "its mapper has no polygons that the processor can read; rays pass through it");
    }
  }
  this->Spheres = spheres ? spheres->Spheres : std::vector<glm::dvec4>();
  this->Looks = spheres ? spheres->Looks : std::vector<vtkIndirectBlockingSpheres::Look>();
  this->Looks.resize(this->Spheres.size());
  frame.AppendUnitsTo(shape);
  shape.Add("spheres", spheres != nullptr).Add("spheres", spheres ? spheres->NumberOfUpdates : 0);
  for (const Piece& piece : this->Pieces)
  {
    piece.Polygons.AppendShape(shape);
  }
}

//------------------------------------------------------------------------------
std::vector<bool> vtkIndirectSurfaces::ReadPolygons(const vtkIndirectFrame& frame,
  const std::function<void(size_t caster, const vtkIndirectPolygons& piece)>& take) const
{
  if (this->IsThere && MakeKey(frame) == this->Key)
  {
    for (const Piece& piece : this->Pieces)
    {
      take(piece.Caster, piece.Polygons);
    }
    return this->DrawPolygonsAlone;
  }
  std::vector<bool> alone;
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    alone.push_back(vtkIndirectPolygons::Read(
      frame, caster.Prop, [&](const vtkIndirectPolygons& piece) { take(alone.size(), piece); }));
  }
  return alone;
}

//------------------------------------------------------------------------------
void vtkIndirectSurfaces::ReadGlyphs(const vtkIndirectFrame& frame, size_t number,
  const vtkIndirectBlockingSpheres* spheres, size_t& mostTriangles)
{
  const vtkIndirectCaster& caster = frame.Casters[number];
  vtkIndirectActors::ForEach(caster.Prop,
    [&](vtkActor* actor, vtkMatrix4x4* matrix)
    {
      if (IsOfSpheres(spheres, actor->GetMapper()))
      {
        return;
      }
      if (!actor->GetMapper()->IsA("vtkGlyph3DMapper"))
      {
        // A prop that draws nothing else is reported as a whole.
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
      const bool all = vtkIndirectPolygons::ReadGlyphs(frame, actor,
        vtkIndirectFrame::ToGLM(matrix), mostTriangles,
        [&](vtkIndirectPolygons& polygons) { this->Take(caster, number, polygons); });
      if (!all)
      {
        this->LeaveOut("glyphs",
          "they have more than " + std::to_string(MostTrianglesOfGlyphs) +
            " triangles; rays pass through those beyond");
      }
    });
}

//------------------------------------------------------------------------------
bool vtkIndirectSurfaces::Meet(const glm::dvec3& start, const glm::dvec3& direction,
  uint32_t except, Meeting& meeting, bool culled) const
{
  glm::dvec3 from = start;
  double passed = 0.0;
  uint32_t last = except;
  vtkIndirectTriangleTree::Hit hit;
  // Rays pass through culled faces. The number of layers is limited, because rounding could make it
  // infinite.
  for (int layer = 0; layer < 64 && this->Tree.FindNearest(from, direction, last, hit); ++layer)
  {
    meeting.Triangle = hit.Triangle;
    meeting.Distance = passed + hit.Distance;
    if (hit.Triangle >= this->NumberOfTriangles)
    {
      const size_t number = hit.Triangle - this->NumberOfTriangles;
      const glm::dvec4& sphere = this->Spheres[number];
      meeting.Normal = meeting.FacetNormal =
        glm::dvec3(hit.Weights[0], hit.Weights[1], hit.Weights[2]);
      meeting.Position = glm::dvec3(sphere) + sphere.w * meeting.Normal;
      meeting.Albedo = glm::dvec3(this->Looks[number].Albedo);
      meeting.PhysicallyBased = this->Looks[number].PhysicallyBased;
      meeting.Sends = true;
      return true;
    }
    const auto next = std::upper_bound(this->Pieces.begin(), this->Pieces.end(), hit.Triangle,
      [](uint32_t triangle, const Piece& one) { return triangle < one.FirstTriangle; });
    const vtkIndirectPolygons& piece = std::prev(next)->Polygons;
    const vtkIndirectPolygons::Triangle& triangle =
      piece.Triangles[hit.Triangle - std::prev(next)->FirstTriangle];
    const std::vector<glm::dvec3>& positions = piece.Positions;
    const glm::dvec3& a = positions[triangle.Points[0]];
    const glm::dvec3& b = positions[triangle.Points[1]];
    const glm::dvec3& c = positions[triangle.Points[2]];
    const glm::dvec3 facet = glm::normalize(glm::cross(b - a, c - a));
    const bool front = glm::dot(facet, direction) < 0.0;
    meeting.Position = hit.Weights[0] * a + hit.Weights[1] * b + hit.Weights[2] * c;
    if (!culled && piece.Culls(front))
    {
      from = meeting.Position;
      passed += hit.Distance;
      last = hit.Triangle;
      continue;
    }
    meeting.FacetNormal = front ? facet : -facet;
    const vtkIndirectMaterial& material = piece.Material;
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
size_t vtkIndirectSurfaces::GetBytes() const
{
  size_t bytes = this->Tree.GetBytes() + this->Spheres.size() * sizeof(glm::dvec4) +
    this->Looks.size() * sizeof(vtkIndirectBlockingSpheres::Look);
  for (const Piece& piece : this->Pieces)
  {
    bytes += piece.Polygons.GetBytes();
  }
  return bytes;
}
