// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectFillValues.h"

#include "Scene/vtkIndirectActors.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkGraph.h"
#include "vtkLODProp3D.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#if __has_include("vtkMoleculeMapper.h")
#include "vtkMoleculeMapper.h"
#define VTKI_ATOMS
#endif

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// No float within it overflows when it is squared.
const double Largest = std::sqrt(static_cast<double>(std::numeric_limits<float>::max()));

bool IsWithin(const glm::dvec3& point)
{
  return std::abs(point.x) <= Largest && std::abs(point.y) <= Largest &&
    std::abs(point.z) <= Largest;
}

// Returns how far what a mapper draws at a point reaches from it, at most, in its data's units.
double FindReach(vtkMapper* mapper)
{
  double reach = 0.0;
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    vtkIndirectActors::ForEachBlockOfPort<vtkDataSet>(glyphs, 1,
      [&reach](vtkDataSet* source)
      {
        const double* b = source->GetBounds();
        const glm::dvec3 most(std::max(std::abs(b[0]), std::abs(b[1])),
          std::max(std::abs(b[2]), std::abs(b[3])), std::max(std::abs(b[4]), std::abs(b[5])));
        reach = source->GetNumberOfPoints() > 0 ? std::max(reach, glm::length(most)) : reach;
      });
    // An array of sizes has fill values, too: sizes in data count as one.
    reach *= glyphs->GetScaling() ? std::abs(glyphs->GetScaleFactor()) : 1.0;
  }
#ifdef VTKI_ATOMS
  else if (auto* molecule = vtkMoleculeMapper::SafeDownCast(mapper))
  {
    constexpr double largestAtom = 3.5; // francium's radius by van der Waals, in angstroms
    reach = largestAtom * static_cast<double>(molecule->GetAtomicRadiusScaleFactor());
  }
#endif
  return std::isfinite(reach) ? reach : 0.0;
}

struct Search
{
  vtkBoundingBox Box;
  vtkIdType Within = 0;
  vtkIdType Beyond = 0;

  template <typename Data>
  void AddBlock(Data* data, const glm::dmat4& toWorld, double reach)
  {
    const double stretch = std::max({ glm::length(glm::dvec3(toWorld[0])),
      glm::length(glm::dvec3(toWorld[1])), glm::length(glm::dvec3(toWorld[2])) });
    const glm::dvec3 margin(reach * stretch);
    for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
    {
      double p[3];
      data->GetPoint(i, p);
      const glm::dvec3 world(toWorld * glm::dvec4(p[0], p[1], p[2], 1.0));
      if (!IsWithin(world))
      {
        ++this->Beyond;
        continue;
      }
      ++this->Within;
      const glm::dvec3 lower = world - margin;
      const glm::dvec3 upper = world + margin;
      this->Box.AddPoint(lower.x, lower.y, lower.z);
      this->Box.AddPoint(upper.x, upper.y, upper.z);
    }
  }

  void AddActor(vtkActor* actor, vtkMatrix4x4* matrix)
  {
    vtkMapper* mapper = actor->GetMapper();
    const bool has = mapper && actor->GetUseBounds() && mapper->GetNumberOfInputPorts() > 0 &&
      mapper->GetNumberOfInputConnections(0) > 0;
    if (!has)
    {
      return;
    }
    const glm::dmat4 toWorld = vtkIndirectFrame::ToGLM(matrix);
    const double reach = FindReach(mapper);
    vtkIndirectActors::ForEachBlock<vtkDataObject>(mapper->GetInputDataObject(0, 0),
      [&](vtkDataObject* block)
      {
        if (auto* data = vtkDataSet::SafeDownCast(block))
        {
          this->AddBlock(data, toWorld, reach);
        }
        else if (auto* molecule = vtkGraph::SafeDownCast(block))
        {
          this->AddGraph(molecule, toWorld, reach);
        }
      });
  }

  void AddGraph(vtkGraph* graph, const glm::dmat4& toWorld, double reach)
  {
    struct Vertices
    {
      vtkGraph* Graph;
      vtkIdType GetNumberOfPoints() const { return this->Graph->GetNumberOfVertices(); }
      void GetPoint(vtkIdType i, double p[3]) const { this->Graph->GetPoint(i, p); }
    } vertices{ graph };
    this->AddBlock(&vertices, toWorld, reach);
  }
};
}

//------------------------------------------------------------------------------
bool vtkIndirectFillValues::IsWithin(const double bounds[6])
{
  return ::IsWithin({ bounds[0], bounds[2], bounds[4] }) &&
    ::IsWithin({ bounds[1], bounds[3], bounds[5] });
}

//------------------------------------------------------------------------------
vtkIndirectFillValues::Points vtkIndirectFillValues::FindBounds(vtkProp* prop, double bounds[6])
{
  Search search;
  if (auto* levels = vtkLODProp3D::SafeDownCast(prop))
  {
    // Its path ends at the prop itself, and its levels have its matrix only while they are drawn.
    vtkNew<vtkPropCollection> actors;
    levels->GetActors(actors);
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkProp* level = actors->GetNextProp(it))
    {
      if (auto* actor = vtkActor::SafeDownCast(level))
      {
        search.AddActor(actor, levels->GetMatrix());
      }
    }
  }
  else
  {
    vtkIndirectActors::ForEach(
      prop, [&search](vtkActor* actor, vtkMatrix4x4* matrix) { search.AddActor(actor, matrix); });
  }
  if (search.Beyond == 0)
  {
    return Points::NONE;
  }
  if (search.Within == 0)
  {
    return Points::ALL;
  }
  search.Box.GetBounds(bounds);
  return Points::SOME;
}
