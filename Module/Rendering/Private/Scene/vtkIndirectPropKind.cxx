// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectPropKind.h"

#include "Scene/vtkIndirectActors.h"
#include "Scene/vtkIndirectInformationKeys.h"
#include "vtkAbstractVolumeMapper.h"
#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkLODProp3D.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp3DCollection.h"
#include "vtkProp3DFollower.h"
#include "vtkPropAssembly.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkVersion.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace
{
const char* const ColorAlone =
  "drawn as colour without surfaces, such as annotation, 3D widgets and "
  "skies: casts no shadow, neither sends nor receives indirect light";
const char* const Turns = "turns to the camera: casts no shadow and sends no light";
const char* const LinesOrPoints =
  "lines and points are sized in pixels, so they neither cast shadows nor send light; points "
  "drawn as spheres do both";
const char* const Splats =
  "splats have no surface: in maps they cast no shadows and send no light, "
  "and they receive no indirect light; splats that shader code cuts off by `discard` are spheres";

// Returns true if a mapper is VTK's own for polygons, not of a derived class.
bool IsPlain(vtkMapper* mapper)
{
  return mapper && std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0;
}

bool IsPlain(vtkActor* actor)
{
  return std::strcmp(actor->GetClassName(), "vtkOpenGLActor") == 0 && IsPlain(actor->GetMapper());
}

// Returns the polygons, lines and points that an actor draws unchanged; null if they are unknown,
// as before a mapper of data sets has extracted them.
vtkPolyData* FindDrawn(vtkMapper* mapper)
{
  auto* dataSetMapper = vtkDataSetMapper::SafeDownCast(mapper);
  if (!dataSetMapper && !IsPlain(mapper))
  {
    return nullptr;
  }
  if (auto* data = vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)))
  {
    return data;
  }
  vtkPolyDataMapper* inner = dataSetMapper ? dataSetMapper->GetPolyDataMapper() : nullptr;
  return inner ? inner->GetInput() : nullptr;
}

// Returns true if VTK's own polygons draw a prop with alpha 1 everywhere. Textures have soft edges,
// and so do not count; neither do props with shader text or passes of other classes, nor props that
// are forced to be opaque.
bool ActorCoversFully(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  vtkInformation* keys = actor->GetPropertyKeys();
  return !actor->GetTexture() && actor->GetProperty()->GetNumberOfTextures() == 0 &&
    !actor->GetForceOpaque() && !(keys && keys->Has(vtkOpenGLRenderPass::RenderPasses())) &&
    shaders->GetNumberOfShaderReplacements() == 0 && !shaders->HasVertexShaderCode() &&
    !shaders->HasFragmentShaderCode() && !shaders->HasGeometryShaderCode();
}

// Counts triangles. A polygon or strip of n points is n - 2 triangles; each line or point counts as
// one.
double CountTriangles(vtkPolyData* data)
{
  if (!data)
  {
    return 0.0;
  }
  double triangles = 0.0;
  for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
  {
    triangles += static_cast<double>(cells->GetNumberOfConnectivityIds()) -
      2.0 * static_cast<double>(cells->GetNumberOfCells());
  }
  for (vtkCellArray* cells : { data->GetVerts(), data->GetLines() })
  {
    triangles += static_cast<double>(cells->GetNumberOfConnectivityIds());
  }
  return triangles;
}

// Counts the triangles of glyphs, as if each point had one of the mean number of triangles.
double CountTriangles(vtkGlyph3DMapper* mapper)
{
  double points = 0.0;
  vtkIndirectActors::ForEachBlockOfPort<vtkDataSet>(mapper, 0,
    [&points](vtkDataSet* data) { points += static_cast<double>(data->GetNumberOfPoints()); });
  double triangles = 0.0;
  double sources = 0.0;
  vtkIndirectActors::ForEachBlockOfPort<vtkPolyData>(mapper, 1,
    [&](vtkPolyData* source)
    {
      triangles += CountTriangles(source);
      sources += 1.0;
    });
  return sources > 0.0 ? points * triangles / sources : points;
}

// Returns the triangles that a depth map costs. Maps draw dense meshes in parts and by coarse
// levels (vtkIndirectMeshParts): in 0.25 of the time in a room, and in 0.42 where nothing else is
// seen. Meshes below 20,000 triangles count in full, although maps draw those of DenseTriangles and
// more by levels, too: fewer maps are drawn in a frame than would fit.
double FindDepthTriangles(double triangles)
{
  constexpr double fewest = 20000.0;
  return triangles < fewest ? triangles : fewest + 0.4 * (triangles - fewest);
}

// VTK lights all of its interpolations but PBR by Phong's model.
bool IsSpecular(vtkProperty* property)
{
  const double* color = property ? property->GetSpecularColor() : nullptr;
  return color && property->GetLighting() && property->GetInterpolation() != VTK_PBR &&
    property->GetSpecular() > 0.0 && (color[0] > 0.0 || color[1] > 0.0 || color[2] > 0.0);
}

bool IsPhysicallyBased(vtkProperty* property)
{
  return property && property->GetLighting() && property->GetInterpolation() == VTK_PBR;
}

// Returns true if data have lines or points and nothing else. Data sets other than polygons become
// polygons in their mappers; data without cells are unknown, so the result is false.
bool IsLinesOrPoints(vtkDataObject* data)
{
  if (auto* cells = vtkPolyData::SafeDownCast(data))
  {
    return cells->GetNumberOfLines() + cells->GetNumberOfVerts() > 0 &&
      cells->GetNumberOfPolys() + cells->GetNumberOfStrips() == 0;
  }
  bool any = false;
  bool all = data && data->IsA("vtkCompositeDataSet");
  vtkIndirectActors::ForEachBlock<vtkDataObject>(all ? data : nullptr,
    [&](vtkDataObject* block)
    {
      any = true;
      all = all && IsLinesOrPoints(block);
    });
  return any && all;
}

// Returns the same for the sources of glyphs.
bool IsLinesOrPoints(vtkGlyph3DMapper* mapper)
{
  const int count = mapper->GetNumberOfInputConnections(1);
  for (int i = 0; i < count; ++i)
  {
    if (!IsLinesOrPoints(mapper->GetInputDataObject(1, i)))
    {
      return false;
    }
  }
  return count > 0;
}

// Returns the reason why an actor draws no surfaces; null if it draws some. drawn: see FindDrawn.
const char* FindNoSurface(vtkActor* actor, vtkPolyData* drawn)
{
  vtkMapper* mapper = actor->GetMapper();
  if (vtkPointGaussianMapper::SafeDownCast(mapper))
  {
    return Splats;
  }
  if (actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    return LinesOrPoints;
  }
  // Other mappers for polygons draw other shapes at the points, such as spheres.
  bool none = IsLinesOrPoints(drawn);
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    none = IsLinesOrPoints(glyphs);
  }
  else if (mapper->IsA("vtkCompositePolyDataMapper") || mapper->IsA("vtkCompositePolyDataMapper2"))
  {
    none = IsLinesOrPoints(mapper->GetInputDataObject(0, 0));
  }
  return none ? LinesOrPoints : nullptr;
}

// VTK lights lines and points only with normals, or as tubes and spheres. drawn: see FindDrawn.
bool IsUnlit(vtkProperty* property, vtkPolyData* drawn)
{
  return !property->GetLighting() ||
    (IsLinesOrPoints(drawn) && !drawn->GetPointData()->GetNormals() &&
      !property->GetRenderLinesAsTubes() && !property->GetRenderPointsAsSpheres());
}

// Collects the props that are drawn in place of a prop with parts, including all levels of detail.
void CollectParts(vtkProp* prop, std::vector<vtkProp*>& parts)
{
  auto addAll = [&parts](auto* props)
  {
    vtkCollectionSimpleIterator it;
    props->InitTraversal(it);
    while (vtkObject* part = props->GetNextItemAsObject(it))
    {
      CollectParts(vtkProp::SafeDownCast(part), parts);
    }
  };
  if (!prop)
  {
    return;
  }
  if (auto* assembly = vtkAssembly::SafeDownCast(prop))
  {
    addAll(assembly->GetParts());
  }
  else if (auto* propAssembly = vtkPropAssembly::SafeDownCast(prop))
  {
    addAll(propAssembly->GetParts());
  }
  else if (vtkLODProp3D::SafeDownCast(prop))
  {
    vtkNew<vtkPropCollection> levels;
    prop->GetActors(levels);
    addAll(levels.Get());
  }
  else
  {
    parts.push_back(prop);
  }
}

bool IsCaptured(vtkProp* part)
{
  if (auto* actor = vtkActor::SafeDownCast(part))
  {
    // Axes and similar actors have no mapper, and draw actors of their own.
    return !actor->IsA("vtkSkybox") &&
      (actor->GetMapper() || std::strcmp(actor->GetClassName(), "vtkOpenGLActor") == 0);
  }
  // In a stack of images, only the stack has keys.
  return part->IsA("vtkImageSlice") && !part->IsA("vtkImageStack");
}
}

//------------------------------------------------------------------------------
std::string vtkIndirectPropKind::Describe(vtkProp* prop)
{
  std::string name;
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 0)
  name = prop->GetObjectName();
#endif
  vtkInformation* keys = prop->GetPropertyKeys();
  if (keys && keys->Has(vtkIndirectInformationKeys::Name()))
  {
    name = keys->Get(vtkIndirectInformationKeys::Name());
  }
  std::string text = name.empty() ? "" : "'" + name + "'";
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* volume = vtkVolume::SafeDownCast(prop);
  vtkAlgorithm* mapper = nullptr;
  if (actor)
  {
    mapper = actor->GetMapper();
  }
  else if (volume)
  {
    mapper = volume->GetMapper();
  }
  if (!mapper)
  {
    return text;
  }
  text += (text.empty() ? "" : ", ") + std::string(mapper->GetClassName());
  if (mapper->GetNumberOfInputPorts() > 0 && mapper->GetNumberOfInputConnections(0) > 0)
  {
    // Data that were set without a pipeline come from a trivial producer, whose class tells
    // nothing.
    vtkAlgorithm* source = mapper->GetInputAlgorithm(0, 0);
    vtkObject* data = mapper->GetInputDataObject(0, 0);
    vtkObject* named = source && !source->IsA("vtkTrivialProducer") ? source : data;
    text += named ? " of " + std::string(named->GetClassName()) : "";
  }
  return text;
}

//------------------------------------------------------------------------------
std::string vtkIndirectPropKind::GetFullName(vtkProp* prop)
{
  const std::string which = vtkIndirectPropKind::Describe(prop);
  return prop->GetClassName() + (which.empty() ? "" : " (" + which + ")");
}

//------------------------------------------------------------------------------
vtkIndirectPropKind vtkIndirectPropKind::Find(vtkProp* prop)
{
  vtkIndirectPropKind kind;
  auto* whole = vtkActor::SafeDownCast(prop);
  auto* follower = vtkProp3DFollower::SafeDownCast(prop);
  std::vector<vtkProp*> parts;
  CollectParts(follower ? follower->GetProp3D() : prop, parts);
  kind.Captured = std::all_of(parts.begin(), parts.end(), IsCaptured);
  kind.NumberOfTriangles = 1e9;
  const char* noSurface = ColorAlone;
  for (vtkProp* part : parts)
  {
    auto* actor = vtkActor::SafeDownCast(part);
    if (!actor || !actor->GetMapper())
    {
      kind.Surface = kind.Surface || (!actor && IsCaptured(part)); // such as an image
      continue;
    }
    actor->GetBounds(); // the call brings the mapper's data up to date
    vtkPolyData* drawn = FindDrawn(actor->GetMapper());
    auto* glyphs = vtkGlyph3DMapper::SafeDownCast(actor->GetMapper());
    // The guess is the number of one sheet of impostors.
    const double guess = glyphs ? CountTriangles(glyphs) : 20000.0;
    const double triangles = drawn ? CountTriangles(drawn) : guess;
    kind.DepthTriangles +=
      drawn && actor == whole && !actor->GetTexture() ? FindDepthTriangles(triangles) : triangles;
    kind.Specular =
      kind.Specular || IsSpecular(actor->GetProperty()) || IsSpecular(actor->GetBackfaceProperty());
    kind.PhysicallyBased = kind.PhysicallyBased || IsPhysicallyBased(actor->GetProperty()) ||
      IsPhysicallyBased(actor->GetBackfaceProperty());
    kind.HasBackface = kind.HasBackface || actor->GetBackfaceProperty();
    kind.Lit = kind.Lit || !IsUnlit(actor->GetProperty(), drawn);
    const char* why = FindNoSurface(actor, drawn);
    kind.Surface = kind.Surface || !why;
    noSurface = why ? why : noSurface;
    if (actor == whole && IsPlain(actor))
    {
      kind.CoversFully = ActorCoversFully(actor);
      kind.NumberOfTriangles = CountTriangles(drawn);
    }
  }
  const bool turns = follower || prop->IsA("vtkFollower");
  kind.NoCaster = !kind.Captured ? ColorAlone : !kind.Surface ? noSurface : turns ? Turns : nullptr;
  return kind;
}

//------------------------------------------------------------------------------
bool vtkIndirectPropKind::IsFlat(vtkProp* prop)
{
  return prop->IsA("vtkActor2D") && !prop->IsA("vtkCaptionActor2D");
}

//------------------------------------------------------------------------------
bool vtkIndirectPropKind::CatchesLight(vtkProp* prop)
{
  return vtkIndirectInformationKeys::IsSet(prop, vtkIndirectInformationKeys::CatchesLight(), false);
}

//------------------------------------------------------------------------------
vtkActor* vtkIndirectPropKind::FindRefractor(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  vtkProperty* property = actor && actor->GetMapper() ? actor->GetProperty() : nullptr;
  // A property with a NaN describes no glass.
  if (!property || property->GetInterpolation() != VTK_PBR || !(property->GetOpacity() < 1.0) ||
    !(property->GetBaseIOR() > 1.0) || !std::isfinite(property->GetBaseIOR()) ||
    property->GetRepresentation() != VTK_SURFACE)
  {
    return nullptr;
  }
  if (vtkIndirectActors::RunsPipeline(actor->GetMapper()))
  {
    actor->GetMapper()->Update();
  }
  auto* polygons = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
  return polygons && polygons->GetNumberOfPolys() > 0 ? actor : nullptr;
}
