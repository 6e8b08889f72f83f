// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectCoarseLevels.h"

#include "Capture/vtkIndirectDepthDrawer.h"
#include "OpenGL/vtkIndirectKey.h"
#include "Plan/vtkIndirectReport.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectRevision.h"
#include "Scene/vtkIndirectTriangles.h"
#include "vtkActor.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
vtkPolyData* FindMesh(vtkActor* actor)
{
  auto* mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  return mapper ? mapper->GetInput() : nullptr;
}
}

//------------------------------------------------------------------------------
vtkIndirectCoarseLevels::vtkIndirectCoarseLevels(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
{
}

vtkIndirectCoarseLevels::~vtkIndirectCoarseLevels() = default;

//------------------------------------------------------------------------------
bool vtkIndirectCoarseLevels::IsCurrent(const Entry& entry)
{
  return entry.Actor && entry.Mesh && FindMesh(entry.Actor) == entry.Mesh &&
    vtkIndirectRevision::FindShape(entry.Mesh) == entry.MeshRevision;
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::DiscardBuffers(vtkIndirectMeshParts* parts)
{
  if (parts && parts->PointBuffer)
  {
    this->Unused.insert(this->Unused.end(), { parts->PointBuffer, parts->IndexBuffer });
    parts->PointBuffer = parts->IndexBuffer = nullptr;
  }
}

//------------------------------------------------------------------------------
template <typename Test>
void vtkIndirectCoarseLevels::RemoveEntries(const Test& goes)
{
  const auto discard = [&](const Entry& entry)
  {
    this->DiscardBuffers(goes(entry) ? entry.Parts.get() : nullptr);
    return goes(entry);
  };
  this->Entries.erase(
    std::remove_if(this->Entries.begin(), this->Entries.end(), discard), this->Entries.end());
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::ReleaseUnused()
{
  for (const auto& buffer : this->Unused)
  {
    buffer->ReleaseGraphicsResources();
  }
  this->Unused.clear();
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectMeshParts*> vtkIndirectCoarseLevels::GetAll() const
{
  std::vector<vtkIndirectMeshParts*> all;
  for (const Entry& entry : this->Entries)
  {
    all.push_back(entry.Parts.get());
  }
  for (const auto& made : this->MadeOf)
  {
    if (made.second.Parts)
    {
      all.push_back(made.second.Parts.get());
    }
  }
  return all;
}

//------------------------------------------------------------------------------
// Reads a level's mesh. Returns the reason if it is refused, else empty.
std::string vtkIndirectCoarseLevels::Read(vtkPolyData* mesh, Given& level)
{
  level.Source = mesh;
  const vtkIdType size = mesh->GetPolys()->IsHomogeneous(); // 0 without cells
  if (size != 3 && size != 0)
  {
    return "polygons of a coarse level are triangles";
  }
  if (size == 0 || mesh->GetNumberOfStrips() > 0)
  {
    return "a coarse level has triangles, and no strips";
  }
  vtkIndirectTriangles::ForEach(mesh,
    [&level](vtkIdType, const vtkIndirectTriangles::Points& points)
    {
      for (const vtkIdType point : points)
      {
        level.Indices.push_back(static_cast<unsigned int>(point));
      }
    });
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    glm::dvec3 p;
    mesh->GetPoint(i, &p[0]);
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z))
    {
      return "points of a coarse level are finite";
    }
    level.Points.push_back(p);
  }
  return "";
}

//------------------------------------------------------------------------------
// Puts an entry's levels into one part.
void vtkIndirectCoarseLevels::Join(Entry& entry)
{
  entry.Parts = std::make_unique<vtkIndirectMeshParts>();
  vtkIndirectMeshParts& parts = *entry.Parts;
  parts.Parts.emplace_back();
  entry.Mesh->GetBounds(parts.Parts.front().Bounds.data());
  double middle[3];
  entry.Mesh->GetCenter(middle);
  parts.Middle = { middle[0], middle[1], middle[2] };
  parts.NumberOfLevels = entry.Levels.size();
  for (const Given& level : entry.Levels)
  {
    const auto first = static_cast<unsigned int>(parts.CountPoints());
    for (const glm::dvec3& p : level.Points)
    {
      parts.AddPoint(p);
    }
    parts.Parts.front().Levels.push_back(
      { parts.Indices.size(), level.Indices.size(), level.Error });
    for (const unsigned int i : level.Indices)
    {
      parts.Indices.push_back(first + i);
    }
  }
}

//------------------------------------------------------------------------------
std::string vtkIndirectCoarseLevels::Add(vtkProp* prop, vtkPolyData* mesh, double error)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (actor && vtkPolyDataMapper::SafeDownCast(actor->GetMapper()))
  {
    actor->GetMapper()->Update();
  }
  vtkPolyData* whole = FindMesh(actor);
  if (!whole)
  {
    return "only actors whose vtkPolyDataMapper has an input have coarse levels";
  }
  if (!mesh || mesh == whole || !(error >= 0.0) || !std::isfinite(error))
  {
    return "a coarse level is another mesh, and its error a finite number of at least 0";
  }
  Given level;
  level.Error = error;
  std::string wrong = Read(mesh, level);
  if (!wrong.empty())
  {
    return wrong;
  }
  auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [actor](const Entry& entry) { return entry.Actor == actor; });
  if (found == this->Entries.end())
  {
    found = this->Entries.insert(this->Entries.end(), Entry());
  }
  else if (!IsCurrent(*found))
  {
    found->Levels.clear();
  }
  found->Actor = actor;
  found->Mesh = whole;
  found->MeshRevision = vtkIndirectRevision::FindShape(whole);
  vtkTimeStamp now;
  now.Modified();
  found->Time = now.GetMTime();
  found->Levels.erase(std::remove_if(found->Levels.begin(), found->Levels.end(),
                        [mesh](const Given& other) { return other.Source == mesh; }),
    found->Levels.end());
  found->Levels.push_back(std::move(level));
  std::stable_sort(found->Levels.begin(), found->Levels.end(),
    [](const Given& a, const Given& b) { return a.Indices.size() < b.Indices.size(); });
  this->DiscardBuffers(found->Parts.get());
  Join(*found);
  return "";
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::Remove(vtkProp* prop)
{
  this->RemoveEntries([prop](const Entry& entry) { return entry.Actor == prop; });
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::Update(vtkIndirectFrame& frame)
{
  this->RemoveEntries([](const Entry& entry) { return !IsCurrent(entry); });
  for (const Entry& entry : this->Entries)
  {
    // Release as renderers release a removed prop's mapper.
    if (!frame.Renderer->HasViewProp(entry.Actor))
    {
      this->DiscardBuffers(entry.Parts.get());
    }
    for (vtkIndirectCaster& caster : frame.Casters)
    {
      // Maps drawn before the level was added are stale, and so are maps drawn with it after it is
      // gone.
      caster.Revision = caster.Prop == entry.Actor
        ? vtkIndirectRevision::Join(caster.Revision, entry.Time)
        : caster.Revision;
    }
  }
  this->RemoveUnneeded(frame);
  this->ReleaseUnused();
  frame.Levels = this;
}

//------------------------------------------------------------------------------
// Removes the parts of meshes that have changed or that no caster has.
void vtkIndirectCoarseLevels::RemoveUnneeded(const vtkIndirectFrame& frame)
{
  std::set<vtkPolyData*> needed;
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    needed.insert(vtkIndirectDepthDrawer::FindMesh(caster.Prop));
  }
  for (auto it = this->MadeOf.begin(); it != this->MadeOf.end();)
  {
    const Made& made = it->second;
    const bool stays = made.Mesh && needed.count(made.Mesh) > 0 &&
      vtkIndirectRevision::FindShape(made.Mesh) == made.MeshRevision;
    this->DiscardBuffers(stays ? nullptr : made.Parts.get());
    it = stays ? std::next(it) : this->MadeOf.erase(it);
  }
}

//------------------------------------------------------------------------------
vtkIndirectMeshParts* vtkIndirectCoarseLevels::Find(vtkProp* prop)
{
  const auto given = std::find_if(this->Entries.begin(), this->Entries.end(),
    [prop](const Entry& entry) { return entry.Actor == prop; });
  if (given != this->Entries.end())
  {
    return given->Parts.get();
  }
  vtkPolyData* mesh = vtkIndirectDepthDrawer::FindMesh(prop);
  if (!mesh)
  {
    return nullptr;
  }
  Made& made = this->MadeOf[mesh];
  const vtkTypeUInt64 revision = vtkIndirectRevision::FindShape(mesh);
  if (made.Mesh != mesh || made.MeshRevision != revision)
  {
    this->DiscardBuffers(made.Parts.get());
    made.Mesh = mesh;
    made.MeshRevision = revision;
    made.Parts =
      vtkIndirectDepthDrawer::CountTriangles(prop) < vtkIndirectMeshParts::FewestTriangles
      ? nullptr
      : vtkIndirectMeshParts::Make(mesh, vtkIndirectDepthDrawer::ReadTriangles(prop));
  }
  return made.Parts.get();
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::Count(size_t drawn, size_t full)
{
  this->Drawn += static_cast<double>(drawn);
  this->Full += static_cast<double>(full);
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::AppendTo(vtkIndirectKey& key) const
{
  for (const Entry& entry : this->Entries)
  {
    key.AddAddress("coarse levels", entry.Actor.Get()).Add("coarse levels", entry.Time);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::AddToReport(vtkIndirectReport& report) const
{
  const std::vector<vtkIndirectMeshParts*> all = this->GetAll();
  if (all.empty())
  {
    return;
  }
  for (const vtkIndirectMeshParts* parts : all)
  {
    report.MainMemoryBytes += parts->GetBytes();
    report.Bytes += parts->PointBuffer ? parts->GetBytes() : 0;
  }
  report.Modelled.emplace_back("coarse geometry in depth maps",
    this->Full > 0.0
      ? std::to_string(static_cast<long long>(this->Drawn)) + " triangles drawn in place of " +
        std::to_string(static_cast<long long>(this->Full)) + " so far, a texel from them at most"
      : "levels of " + std::to_string(all.size()) +
        " meshes, used by no map: too far from what they stand for");
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::ReleaseOwn(vtkWindow*)
{
  for (vtkIndirectMeshParts* parts : this->GetAll())
  {
    this->DiscardBuffers(parts);
  }
  this->ReleaseUnused();
}
