// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxyKinds.h"

#include "Proxies/vtkIndirectProxySticks.h"
#include "Scene/vtkIndirectActors.h"
#include "vtkActor.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"

// Uses only headers of atoms, so that without molecules no library of chemistry is needed.
#if __has_include("vtkOpenGLMoleculeMapper.h")
#include "vtkOpenGLMoleculeMapper.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#define VTKI_MOLECULES
#endif

#include <cstring>

namespace
{
// Larger meshes are not examined for a shape: examining this many cells takes a millisecond.
constexpr vtkIdType MostCells = 20000;
// A sphere whose centre is farther off its origin than this many radii moves if its glyph is
// rotated.
constexpr double MostOffset = 1e-3;

#ifdef VTKI_MOLECULES
// Access to protected members of VTK.
struct MoleculeAccess : public vtkOpenGLMoleculeMapper
{
  static vtkMapper* GetBonds(vtkOpenGLMoleculeMapper* mapper)
  {
    return (mapper->*(&MoleculeAccess::FastBondMapper)).Get();
  }
};
#endif

double Count(vtkMapper* mapper, int elements)
{
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  return data ? static_cast<double>(data->GetNumberOfElements(elements)) : 0.0;
}

const vtkIndirectProxyShapes::Shape& FindShape(vtkPolyData* mesh, vtkIndirectProxyShapes& shapes)
{
  static const vtkIndirectProxyShapes::Shape none;
  return mesh && mesh->GetNumberOfCells() <= MostCells ? shapes.Find(mesh, true) : none;
}

// Mappers of other classes may draw other things.
void AddMesh(vtkMapper* mapper, vtkIndirectProxyShapes& shapes, vtkIndirectProxyKinds::Kind& kind)
{
  const bool plain = std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0 ||
    std::strcmp(mapper->GetClassName(), "vtkDataSetMapper") == 0;
  auto* mesh = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const int shape = FindShape(plain ? mesh : nullptr, shapes).Kind;
  kind.NumberOfPolygons += shape == vtkIndirectProxyShapes::POLYGON ? 1 : 0;
  if (shape == vtkIndirectProxyShapes::NOTHING)
  {
    kind.Other = "there is a mesh that is neither flat and convex nor made of spheres";
  }
}
}

//------------------------------------------------------------------------------
vtkIndirectProxyKinds::MapperType vtkIndirectProxyKinds::FindType(vtkMapper* mapper)
{
  return mapper->IsA("vtkOpenGLMoleculeMapper") ? MOLECULE
    : mapper->IsA("vtkOpenGLSphereMapper")      ? BALLS
    : mapper->IsA("vtkOpenGLStickMapper")       ? STICKS
    : mapper->IsA("vtkPointGaussianMapper")     ? SPLATS
    : mapper->IsA("vtkGlyph3DMapper")           ? GLYPHS
                                                : MESH;
}

//------------------------------------------------------------------------------
vtkIndirectProxyKinds::Molecule vtkIndirectProxyKinds::FindMolecule(
  [[maybe_unused]] vtkMapper* mapper)
{
  Molecule found;
#ifdef VTKI_MOLECULES
  if (auto* molecule = vtkOpenGLMoleculeMapper::SafeDownCast(mapper))
  {
    found.Bonds = molecule->GetRenderBonds() ? MoleculeAccess::GetBonds(molecule) : nullptr;
    found.Atoms = molecule->GetRenderAtoms() ? molecule->GetFastAtomMapper() : nullptr;
  }
#endif
  return found;
}

//------------------------------------------------------------------------------
vtkIndirectProxyKinds::Kind vtkIndirectProxyKinds::FindSpheres(vtkProp* prop)
{
  Kind kind;
  vtkIndirectActors::ForEach(prop,
    [&kind](vtkActor* actor, vtkMatrix4x4* matrix)
    {
      vtkMapper* mapper = actor->GetMapper();
      const MapperType type = FindType(mapper);
      if (type != MESH && type != SPLATS)
      {
        kind.NumberOfSpheres += (type == STICKS ? vtkIndirectProxySticks::MostSpheresOfAStick : 1) *
          Count(mapper, type == MOLECULE ? vtkDataObject::VERTEX : vtkDataObject::POINT);
        kind.Places.Add("data", mapper->GetInputDataObject(0, 0))
          .Add("matrix", matrix->GetData(), 16);
      }
    });
  return kind;
}

//------------------------------------------------------------------------------
vtkIndirectProxyKinds::Kind vtkIndirectProxyKinds::Find(
  vtkProp* prop, vtkIndirectProxyShapes& shapes)
{
  Kind kind = FindSpheres(prop);
  vtkIndirectActors::ForEach(prop,
    [&](vtkActor* actor, vtkMatrix4x4*)
    {
      vtkMapper* mapper = actor->GetMapper();
      const MapperType type = FindType(mapper);
      if (mapper->GetClippingPlanes() && mapper->GetClippingPlanes()->GetNumberOfItems() > 0)
      {
        kind.Other = "something is cut by clipping planes";
      }
      else if (type == GLYPHS)
      {
        const std::string why = FindWhyNoGlyphs(mapper, shapes);
        kind.Other = why.empty() ? kind.Other : why;
      }
      else if (type == MOLECULE && FindMolecule(mapper).Bonds)
      {
        // A bond has two sticks, one for each atom: this is an upper bound.
        kind.NumberOfSpheres +=
          2.0 * vtkIndirectProxySticks::MostSpheresOfAStick * Count(mapper, vtkDataObject::EDGE);
      }
      else if (type == MESH && actor->GetProperty()->GetRepresentation() == VTK_SURFACE)
      {
        AddMesh(mapper, shapes, kind);
      }
    });
  return kind;
}

//------------------------------------------------------------------------------
std::string vtkIndirectProxyKinds::FindWhyNoGlyphs(
  vtkMapper* mapper, vtkIndirectProxyShapes& shapes)
{
  auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper);
  const int count = glyphs->GetNumberOfInputConnections(1);
  bool balls = count > 0 && !glyphs->GetUseSourceTableTree();
  for (int i = 0; balls && i < count; ++i)
  {
    const auto& spheres = FindShape(glyphs->GetSource(i), shapes).Spheres;
    balls = spheres.size() == 1 &&
      glm::length(spheres.front().Center) <= MostOffset * spheres.front().Radius;
  }
  return !balls ? "there are glyphs that are no spheres"
    : glyphs->GetScaling() && glyphs->GetScaleMode() == vtkGlyph3DMapper::SCALE_BY_COMPONENTS
    ? "glyphs are stretched spheres"
    : "";
}
