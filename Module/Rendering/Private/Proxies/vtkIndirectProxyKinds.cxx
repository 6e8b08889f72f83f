// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxyKinds.h"

#include "Frame/vtkIndirectActors.h"
#include "Proxies/vtkIndirectProxyMolecules.h"
#include "Proxies/vtkIndirectProxySticks.h"
#include "vtkActor.h"
#include "vtkDataSetMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkOpenGLStickMapper.h"
#include "vtkPlaneCollection.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <cstring>

namespace
{
// Larger meshes are not examined for a shape: examining this many cells takes a millisecond.
constexpr vtkIdType MostCells = 20000;
// A sphere whose centre is farther off its origin than this many radii moves if its glyph is
// rotated.
constexpr double MostOffset = 1e-3;

enum MapperType
{
  MESH,
  BALLS,
  STICKS,
  GLYPHS,
  MOLECULE
};

int FindType(vtkMapper* mapper)
{
#ifdef VTKI_MOLECULES
  if (vtkOpenGLMoleculeMapper::SafeDownCast(mapper))
  {
    return MOLECULE;
  }
#endif
  return vtkOpenGLSphereMapper::SafeDownCast(mapper) ? BALLS
    : vtkOpenGLStickMapper::SafeDownCast(mapper)     ? STICKS
    : vtkGlyph3DMapper::SafeDownCast(mapper)         ? GLYPHS
                                                     : MESH;
}

void AddSpheres(vtkMapper* mapper, vtkMatrix4x4* matrix, vtkIndirectProxyKinds::Kind& kind)
{
  vtkDataObject* data = mapper->GetInputDataObject(0, 0);
  if (!data)
  {
    return;
  }
  const int type = FindType(mapper);
  kind.NumberOfSpheres += (type == STICKS ? vtkIndirectProxySticks::MostSpheresOfAStick : 1) *
    static_cast<double>(
      data->GetNumberOfElements(type == MOLECULE ? vtkDataObject::VERTEX : vtkDataObject::POINT));
  kind.Places.Add("data", data).Add("matrix", matrix->GetData(), 16);
}
}

//------------------------------------------------------------------------------
vtkIndirectProxyKinds::Kind vtkIndirectProxyKinds::FindSpheres(vtkProp* prop)
{
  Kind kind;
  vtkIndirectActors::ForEach(prop,
    [&kind](vtkActor* actor, vtkMatrix4x4* matrix)
    {
      if (FindType(actor->GetMapper()) != MESH)
      {
        AddSpheres(actor->GetMapper(), matrix, kind);
      }
    });
  return kind;
}

//------------------------------------------------------------------------------
bool vtkIndirectProxyKinds::IsOfCutSplats(vtkActor* actor)
{
  auto* mapper = vtkPointGaussianMapper::SafeDownCast(actor->GetMapper());
  const char* code = mapper ? mapper->GetSplatShaderCode() : nullptr;
  return code && std::strstr(code, "discard") && mapper->GetScaleFactor() > 0.0 &&
    !mapper->GetEmissive() && actor->GetProperty()->GetOpacity() >= 1.0;
}

//------------------------------------------------------------------------------
vtkIndirectProxyKinds::Kind vtkIndirectProxyKinds::Find(vtkProp* prop)
{
  Kind kind = FindSpheres(prop);
  vtkIndirectActors::ForEach(
    prop, [this, &kind](vtkActor* actor, vtkMatrix4x4*) { this->AddActor(actor, kind); });
  return kind;
}

//------------------------------------------------------------------------------
void vtkIndirectProxyKinds::AddActor(vtkActor* actor, Kind& kind)
{
  vtkMapper* mapper = actor->GetMapper();
  if (mapper->GetClippingPlanes() && mapper->GetClippingPlanes()->GetNumberOfItems() > 0)
  {
    kind.Other = "something is cut by clipping planes";
    return;
  }
  switch (FindType(mapper))
  {
    case BALLS:
    case STICKS:
      return;
    case GLYPHS:
    {
      const std::string why = this->FindWhyNoGlyphs(mapper);
      kind.Other = why.empty() ? kind.Other : why;
      return;
    }
#ifdef VTKI_MOLECULES
    case MOLECULE:
      if (vtkOpenGLMoleculeMapper::SafeDownCast(mapper)->GetRenderBonds())
      {
        // A bond has two sticks, one for each atom: this is an upper bound.
        vtkDataObject* molecule = mapper->GetInputDataObject(0, 0);
        kind.NumberOfSpheres += !molecule ? 0.0
                                          : 2.0 * vtkIndirectProxySticks::MostSpheresOfAStick *
            static_cast<double>(molecule->GetNumberOfElements(vtkDataObject::EDGE));
      }
      return;
#endif
    default:
      if (actor->GetProperty()->GetRepresentation() == VTK_SURFACE)
      {
        this->AddMesh(mapper, kind);
      }
  }
}

//------------------------------------------------------------------------------
std::string vtkIndirectProxyKinds::FindWhyNoGlyphs(vtkMapper* mapper)
{
  auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper);
  const int count = glyphs->GetNumberOfInputConnections(1);
  bool balls = count > 0 && !glyphs->GetUseSourceTableTree();
  for (int i = 0; balls && i < count; ++i)
  {
    const std::vector<vtkIndirectProxySphere>& spheres =
      this->FindShape(glyphs->GetSource(i)).Spheres;
    balls = spheres.size() == 1 &&
      glm::length(spheres.front().Center) <= MostOffset * spheres.front().Radius;
  }
  return !balls ? "there are glyphs that are no spheres"
    : glyphs->GetScaling() && glyphs->GetScaleMode() == vtkGlyph3DMapper::SCALE_BY_COMPONENTS
    ? "glyphs are stretched spheres"
    : "";
}

//------------------------------------------------------------------------------
// Mappers of other classes may draw other things.
void vtkIndirectProxyKinds::AddMesh(vtkMapper* mapper, Kind& kind)
{
  const bool plain = std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0 ||
    std::strcmp(mapper->GetClassName(), "vtkDataSetMapper") == 0;
  auto* mesh = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const int shape = this->FindShape(plain ? mesh : nullptr).Kind;
  kind.NumberOfPolygons += shape == vtkIndirectProxyShapes::POLYGON ? 1 : 0;
  if (shape == vtkIndirectProxyShapes::NOTHING)
  {
    kind.Other = "there is a mesh that is neither flat and convex nor made of spheres";
  }
}

//------------------------------------------------------------------------------
const vtkIndirectProxyShapes::Shape& vtkIndirectProxyKinds::FindShape(vtkPolyData* mesh)
{
  static const vtkIndirectProxyShapes::Shape none;
  return mesh && mesh->GetNumberOfCells() <= MostCells ? this->Shapes.Find(mesh, true) : none;
}
