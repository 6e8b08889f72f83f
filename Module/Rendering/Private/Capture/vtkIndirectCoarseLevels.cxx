// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectCoarseLevels.h"

#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectKey.h"
#include "Frame/vtkIndirectReport.h"
#include "Frame/vtkIndirectRevision.h"
#include "vtkActor.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkOpenGLBufferObject.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkRenderer.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <cmath>

namespace
{
vtkPolyData* FindMesh(vtkActor* actor)
{
  auto* mapper = actor ? vtkPolyDataMapper::SafeDownCast(actor->GetMapper()) : nullptr;
  return mapper ? mapper->GetInput() : nullptr;
}

// Largest scale of the actor's matrix, or a bound of it.
double FindScale(vtkActor* actor)
{
  const glm::dmat3 m(vtkIndirectFrame::ToGLM(actor->GetMatrix()));
  return std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]));
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
void vtkIndirectCoarseLevels::DiscardBuffers(Level& level)
{
  for (auto* buffer : { &level.PositionBuffer, &level.IndexBuffer })
  {
    if (*buffer)
    {
      this->Unused.push_back(*buffer);
      *buffer = nullptr;
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::DiscardBuffers(Entry& entry)
{
  for (const auto& level : entry.Levels)
  {
    this->DiscardBuffers(*level);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::Discard(Entry& entry)
{
  this->DiscardBuffers(entry);
  entry.Levels.clear();
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
  auto level = std::make_unique<Level>();
  level->Error = error;
  level->Source = mesh;
  double middle[3];
  mesh->GetCenter(middle);
  level->Middle = { middle[0], middle[1], middle[2] };
  auto it = vtkSmartPointer<vtkCellArrayIterator>::Take(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* points = nullptr;
    it->GetCurrentCell(size, points);
    if (size != 3)
    {
      return "polygons of a coarse level are triangles";
    }
    for (int i = 0; i < 3; ++i)
    {
      level->Indices.push_back(static_cast<unsigned int>(points[i]));
    }
  }
  if (level->Indices.empty() || mesh->GetNumberOfStrips() > 0)
  {
    return "a coarse level has triangles, and no strips";
  }
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    double p[3];
    mesh->GetPoint(i, p);
    for (int c = 0; c < 3; ++c)
    {
      if (!std::isfinite(p[c]))
      {
        return "points of a coarse level are finite";
      }
      level->Positions.push_back(static_cast<float>(p[c] - middle[c]));
    }
  }
  auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
    [actor](const Entry& entry) { return entry.Actor == actor; });
  if (found == this->Entries.end())
  {
    found = this->Entries.insert(this->Entries.end(), Entry());
  }
  else if (!IsCurrent(*found))
  {
    this->Discard(*found);
  }
  found->Actor = actor;
  found->Mesh = whole;
  found->MeshRevision = vtkIndirectRevision::FindShape(whole);
  vtkTimeStamp now;
  now.Modified();
  found->Time = now.GetMTime();
  const auto same = std::find_if(found->Levels.begin(), found->Levels.end(),
    [mesh](const auto& other) { return other->Source == mesh; });
  if (same != found->Levels.end())
  {
    this->DiscardBuffers(**same);
    found->Levels.erase(same);
  }
  found->Levels.push_back(std::move(level));
  std::stable_sort(found->Levels.begin(), found->Levels.end(),
    [](const auto& a, const auto& b) { return a->Indices.size() < b->Indices.size(); });
  return "";
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::Remove(vtkProp* prop)
{
  for (auto it = this->Entries.begin(); it != this->Entries.end();)
  {
    if (it->Actor == prop)
    {
      this->Discard(*it);
      it = this->Entries.erase(it);
    }
    else
    {
      ++it;
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::Update(vtkIndirectFrame& frame)
{
  for (auto it = this->Entries.begin(); it != this->Entries.end();)
  {
    if (!IsCurrent(*it))
    {
      this->Discard(*it);
      it = this->Entries.erase(it);
      continue;
    }
    // Release as renderers release a removed prop's mapper.
    if (!frame.Renderer->HasViewProp(it->Actor))
    {
      this->DiscardBuffers(*it);
    }
    for (vtkIndirectCaster& caster : frame.Casters)
    {
      // Maps drawn before the level was added are stale, and so are maps drawn with it after it is
      // gone.
      caster.Revision = caster.Prop == it->Actor
        ? vtkIndirectRevision::Join(caster.Revision, it->Time)
        : caster.Revision;
    }
    ++it;
  }
  for (const auto& buffer : this->Unused)
  {
    buffer->ReleaseGraphicsResources();
  }
  this->Unused.clear();
  frame.Levels = this;
}

//------------------------------------------------------------------------------
bool vtkIndirectCoarseLevels::Has(vtkProp* prop) const
{
  return std::any_of(this->Entries.begin(), this->Entries.end(),
    [prop](const Entry& entry) { return entry.Actor == prop; });
}

//------------------------------------------------------------------------------
vtkIndirectCoarseLevels::Level* vtkIndirectCoarseLevels::Find(
  vtkProp* prop, double mostError, double& error) const
{
  for (const Entry& entry : this->Entries)
  {
    if (entry.Actor != prop)
    {
      continue;
    }
    const double scale = FindScale(entry.Actor);
    for (const auto& level : entry.Levels)
    {
      error = level->Error * scale;
      if (error <= mostError)
      {
        return level.get();
      }
    }
  }
  return nullptr;
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::Count(size_t drawn, size_t full) const
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
  if (this->Entries.empty())
  {
    return;
  }
  for (const Entry& entry : this->Entries)
  {
    for (const auto& level : entry.Levels)
    {
      const size_t bytes =
        level->Positions.size() * sizeof(float) + level->Indices.size() * sizeof(unsigned int);
      report.MainMemoryBytes += bytes;
      report.Bytes += level->PositionBuffer ? bytes : 0;
    }
  }
  report.Modelled.emplace_back("coarse geometry in depth maps",
    this->Full > 0.0 ? std::to_string(static_cast<long long>(this->Drawn)) +
        " triangles drawn in place of " + std::to_string(static_cast<long long>(this->Full)) +
        " so far, half a texel from them at most"
                     : "levels of " + std::to_string(this->Entries.size()) +
        " props, used by no map: half a texel from what they draw at most");
}

//------------------------------------------------------------------------------
void vtkIndirectCoarseLevels::ReleaseOwn(vtkWindow*)
{
  for (Entry& entry : this->Entries)
  {
    for (const auto& level : entry.Levels)
    {
      for (auto* buffer : { &level->PositionBuffer, &level->IndexBuffer })
      {
        if (*buffer)
        {
          (*buffer)->ReleaseGraphicsResources();
          *buffer = nullptr;
        }
      }
    }
  }
  for (const auto& buffer : this->Unused)
  {
    buffer->ReleaseGraphicsResources();
  }
  this->Unused.clear();
}
