// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Visibility/vtkIndirectOccupancyVolume.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Visibility/vtkIndirectDistanceField.h"
#include "vtkActor.h"
#include "vtkAssemblyPath.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSetMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolygon.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProgram.h"
#include "vtkShaderProperty.h"
#include "vtkTextureObject.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>

namespace
{
// Separating axes of a triangle and the cube of half edge `half` about the origin, but for the
// cube's own faces and the triangle's plane, which the caller has tested.
bool EdgesOverlap(const glm::dvec3 v[3], double half)
{
  for (int e = 0; e < 3; ++e)
  {
    const glm::dvec3 edge = v[(e + 1) % 3] - v[e];
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 unit(0.0);
      unit[axis] = 1.0;
      const glm::dvec3 a = glm::cross(unit, edge);
      const double p0 = glm::dot(a, v[e]);
      const double p1 = glm::dot(a, v[(e + 2) % 3]);
      const double radius = half * (std::abs(a.x) + std::abs(a.y) + std::abs(a.z));
      if (std::min(p0, p1) > radius || std::max(p0, p1) < -radius)
      {
        return false;
      }
    }
  }
  return true;
}

// Whether what an actor draws is no more than its data's polygons and strips. Of derived classes
// nothing is known; lines and vertices lie where no triangle does.
bool DrawsPolygonsAlone(vtkActor* actor, vtkMapper* mapper)
{
  static const char* const mappers[] = { "vtkOpenGLPolyDataMapper", "vtkCompositePolyDataMapper",
    "vtkCompositePolyDataMapper2" };
  const std::string name = mapper->GetClassName();
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return std::strcmp(actor->GetClassName(), "vtkOpenGLActor") == 0 &&
    std::find(std::begin(mappers), std::end(mappers), name) != std::end(mappers) &&
    shaders->GetNumberOfShaderReplacements() == 0 && !shaders->HasVertexShaderCode() &&
    !shaders->HasGeometryShaderCode();
}
}

//------------------------------------------------------------------------------
struct vtkIndirectOccupancyVolume::Source
{
  vtkMapper* Mapper;
  glm::dmat4 ToWorld;
  glm::dvec3 SceneCenter;
  double SceneScale;
  glm::dvec3 Color; // what is reflected of light without scalars
  double Diffuse;   // diffuse coefficient
  double Reflected = 1.0;
  bool Encoded = false; // scalars' colours are, times the coefficient, with gamma 2.2
};

vtkIndirectOccupancyVolume::vtkIndirectOccupancyVolume() = default;
vtkIndirectOccupancyVolume::~vtkIndirectOccupancyVolume() = default;

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::Clear(
  const glm::dvec3& lower, const glm::dvec3& upper, int resolution)
{
  const glm::dvec3 extent = glm::max(upper - lower, glm::dvec3(0.0));
  const double longest = std::max({ extent.x, extent.y, extent.z });
  // Two voxels more than the scene, in unequal parts, so that walls on its bounds fall on no face
  // between voxels, which would set those of both sides.
  const double border = 0.87;
  this->VoxelSize = longest > 0.0 ? longest / (resolution - 2.0) : 1.0 / resolution;
  this->Origin = lower - border * this->VoxelSize;
  for (int axis = 0; axis < 3; ++axis)
  {
    this->Size[axis] =
      std::min(resolution, static_cast<int>(std::ceil(extent[axis] / this->VoxelSize)) + 2);
  }
  this->Columns.assign(static_cast<size_t>(this->Size.x) * this->Size.y, glm::uvec4(0u));
  this->Triangles.Clear(this->Size);
  this->Tree.Clear();
  this->Area = 0.0;
  this->MeanAlbedo = glm::dvec3(0.0);
  this->NumberOfTriangles = 0;
  this->LeftOut.clear();
  this->Uploaded = this->DistanceFieldIsCurrent = false;
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::Mark(const glm::ivec3& voxel)
{
  if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) ||
    glm::any(glm::greaterThanEqual(voxel, this->Size)))
  {
    return;
  }
  this->Columns[voxel.x + static_cast<size_t>(this->Size.x) * voxel.y][voxel.z / 32] |= 1u
    << (voxel.z % 32);
  this->Touched.push_back(voxel);
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::AddTriangle(const glm::dvec3 corners[3], const glm::dvec3& albedo)
{
  glm::dvec3 v[3];
  for (int i = 0; i < 3; ++i)
  {
    v[i] = this->ToVoxels(corners[i]);
    if (!std::isfinite(v[i].x + v[i].y + v[i].z))
    {
      return;
    }
  }
  ++this->NumberOfTriangles;
  if (this->TreeIsKept)
  {
    this->Tree.Add(corners);
  }
  const glm::dvec3 doubled = glm::cross(v[1] - v[0], v[2] - v[0]);
  const glm::dvec3 size = glm::abs(doubled);
  const int w = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
  const int u = (w + 1) % 3;
  const int t = (w + 2) % 3;
  const glm::dvec3 lower = glm::min(v[0], glm::min(v[1], v[2]));
  const glm::dvec3 upper = glm::max(v[0], glm::max(v[1], v[2]));
  const glm::ivec3 first = glm::max(glm::ivec3(glm::floor(lower)), glm::ivec3(0));
  const glm::ivec3 last = glm::min(glm::ivec3(glm::floor(upper)), this->Size - 1);
  this->Touched.clear();
  // Along the normal's largest part the plane meets each column in a short range only.
  const bool flat = size[w] > 0.0;
  const double su = flat ? -doubled[u] / doubled[w] : 0.0;
  const double st = flat ? -doubled[t] / doubled[w] : 0.0;
  const double spread = 0.5 * (std::abs(su) + std::abs(st));
  glm::ivec3 voxel;
  for (voxel[u] = first[u]; voxel[u] <= last[u]; ++voxel[u])
  {
    for (voxel[t] = first[t]; voxel[t] <= last[t]; ++voxel[t])
    {
      double low = lower[w];
      double high = upper[w];
      if (flat)
      {
        const double height =
          v[0][w] + su * (voxel[u] + 0.5 - v[0][u]) + st * (voxel[t] + 0.5 - v[0][t]);
        low = std::max(low, height - spread);
        high = std::min(high, height + spread);
      }
      const int begin = std::max(static_cast<int>(std::floor(low)), 0);
      const int end = std::min(static_cast<int>(std::floor(high)), this->Size[w] - 1);
      for (voxel[w] = begin; voxel[w] <= end; ++voxel[w])
      {
        const glm::dvec3 center = glm::dvec3(voxel) + 0.5;
        const glm::dvec3 relative[3] = { v[0] - center, v[1] - center, v[2] - center };
        if (EdgesOverlap(relative, 0.5))
        {
          this->Mark(voxel);
        }
      }
    }
  }
  const double area = 0.5 * glm::length(doubled);
  if (this->Touched.empty() || !(area > 0.0))
  {
    return;
  }
  this->Area += area;
  this->MeanAlbedo += area * albedo;
  if (this->TrianglesAreKept)
  {
    this->Triangles.Add(v, albedo, this->Touched);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::KeepTriangles()
{
  if (!this->TrianglesAreKept)
  {
    this->TrianglesAreKept = true;
    this->Forget();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::KeepTree(bool keep)
{
  if (this->TreeIsKept == keep)
  {
    return;
  }
  this->TreeIsKept = keep;
  if (keep)
  {
    this->Forget();
  }
  else
  {
    this->Tree.Clear();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::Finish()
{
  this->MeanAlbedo /= this->Area > 0.0 ? this->Area : 1.0;
  if (this->TrianglesAreKept)
  {
    this->Triangles.Finish();
  }
  this->Tree.Finish();
}

//------------------------------------------------------------------------------
bool vtkIndirectOccupancyVolume::Update(const vtkIndirectFrame& frame, int resolution)
{
  std::vector<double> key(frame.SceneBounds, frame.SceneBounds + 6);
  key.push_back(resolution);
  key.push_back(frame.NumberOfOtherReceivers);
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    key.push_back(static_cast<double>(reinterpret_cast<uintptr_t>(caster.Prop)));
    key.push_back(static_cast<double>(caster.RedrawMTime));
  }
  if (key == this->Key)
  {
    return false;
  }
  this->Key = key;
  glm::dvec3 lower;
  glm::dvec3 upper;
  for (int axis = 0; axis < 3; ++axis)
  {
    lower[axis] = (frame.SceneBounds[2 * axis] - frame.SceneCenter[axis]) * frame.SceneScale;
    upper[axis] = (frame.SceneBounds[2 * axis + 1] - frame.SceneCenter[axis]) * frame.SceneScale;
  }
  this->Clear(lower, upper, resolution);
  this->AllIsHeld = frame.NumberOfOtherReceivers == 0;
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    this->AddProp(frame, caster.Prop);
  }
  this->Finish();
  return true;
}

//------------------------------------------------------------------------------
const vtkIndirectDistanceField& vtkIndirectOccupancyVolume::GetDistanceField() const
{
  if (!this->DistanceField)
  {
    this->DistanceField = std::make_unique<vtkIndirectDistanceField>();
  }
  if (!this->DistanceFieldIsCurrent)
  {
    this->DistanceField->Build(*this);
    this->DistanceFieldIsCurrent = true;
  }
  return *this->DistanceField;
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::AddProp(const vtkIndirectFrame& frame, vtkProp* prop)
{
  const size_t before = this->NumberOfTriangles;
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* node = path->GetLastNode();
    vtkActor* actor = vtkActor::SafeDownCast(node->GetViewProp());
    if (actor && !actor->GetVisibility())
    {
      continue;
    }
    if (!actor || !actor->GetMapper())
    {
      this->AllIsHeld = false;
      continue;
    }
    vtkMapper* mapper = actor->GetMapper();
    if (auto* dataSetMapper = vtkDataSetMapper::SafeDownCast(mapper))
    {
      mapper = dataSetMapper->GetPolyDataMapper();
    }
    if (!mapper || mapper->GetNumberOfInputPorts() < 1 ||
      mapper->GetNumberOfInputConnections(0) < 1)
    {
      this->AllIsHeld = false;
      continue;
    }
    this->AllIsHeld = this->AllIsHeld && DrawsPolygonsAlone(actor, mapper);
    vtkProperty* property = actor->GetProperty();
    Source source;
    source.Mapper = mapper;
    source.ToWorld =
      vtkIndirectFrame::ToGLM(node->GetMatrix() ? node->GetMatrix() : actor->GetMatrix());
    source.SceneCenter = frame.SceneCenter;
    source.SceneScale = frame.SceneScale;
    source.Diffuse = property->GetDiffuse();
    if (property->GetInterpolation() == VTK_PBR)
    {
      // VTK's PBR divides its diffuse reflection by pi.
      source.Reflected = (1.0 - property->GetMetallic()) / vtkMath::Pi();
      source.Encoded = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0);
    }
    const double* color = property->GetDiffuseColor();
    source.Color = source.Reflected * source.Diffuse * glm::dvec3(color[0], color[1], color[2]);
    vtkDataObject* input = mapper->GetInputDataObject(0, 0);
    if (auto* data = vtkPolyData::SafeDownCast(input))
    {
      // Glyph mappers have points here and the polygons elsewhere.
      if (vtkPolyDataMapper::SafeDownCast(mapper))
      {
        this->AddPolyData(source, data);
      }
    }
    else if (auto* composite = vtkCompositeDataSet::SafeDownCast(input))
    {
      auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
      for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
      {
        if (auto* leaf = vtkPolyData::SafeDownCast(it->GetCurrentDataObject()))
        {
          this->AddPolyData(source, leaf);
        }
      }
    }
  }
  if (this->NumberOfTriangles == before)
  {
    this->LeftOut.emplace_back(prop->GetClassName(),
      "its mapper has no polygons that the processor can read; it blocks no indirect light");
  }
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::AddPolyData(const Source& source, vtkPolyData* data)
{
  vtkPoints* points = data->GetPoints();
  if (!points || points->GetNumberOfPoints() == 0)
  {
    return;
  }
  this->AllIsHeld =
    this->AllIsHeld && data->GetNumberOfVerts() == 0 && data->GetNumberOfLines() == 0;
  std::vector<glm::dvec3> positions(points->GetNumberOfPoints());
  std::vector<char> shown(positions.size(), 1);
  vtkPlaneCollection* planes = source.Mapper->GetClippingPlanes();
  for (size_t i = 0; i < positions.size(); ++i)
  {
    double p[3];
    points->GetPoint(static_cast<vtkIdType>(i), p);
    const glm::dvec4 local(p[0], p[1], p[2], 1.0);
    glm::dvec4 world = source.ToWorld * local;
    positions[i] = (glm::dvec3(world) - source.SceneCenter) * source.SceneScale;
    for (int k = 0; planes && k < planes->GetNumberOfItems(); ++k)
    {
      shown[i] = shown[i] && planes->GetItem(k)->EvaluateFunction(&world[0]) >= 0.0;
    }
  }

  vtkSmartPointer<vtkUnsignedCharArray> colors;
  int cellFlag = 0;
  if (source.Mapper->GetScalarVisibility())
  {
    vtkMapper* mapper = source.Mapper;
    vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cellFlag);
    if (scalars && mapper->GetLookupTable())
    {
      colors.TakeReference(mapper->GetLookupTable()->MapScalars(
        scalars, mapper->GetColorMode(), mapper->GetArrayComponent()));
    }
  }
  auto colorOf = [&](vtkIdType cell, vtkIdType point)
  {
    const vtkIdType at = cellFlag ? cell : point;
    if (!colors || at >= colors->GetNumberOfTuples() || colors->GetNumberOfComponents() < 3)
    {
      return source.Color;
    }
    const unsigned char* c = colors->GetPointer(at * colors->GetNumberOfComponents());
    const glm::dvec3 color = source.Diffuse / 255.0 * glm::dvec3(c[0], c[1], c[2]);
    return source.Reflected * (source.Encoded ? glm::pow(color, glm::dvec3(2.2)) : color);
  };
  auto add = [&](vtkIdType cell, vtkIdType a, vtkIdType b, vtkIdType c)
  {
    // A triangle that a plane cuts counts whole: it blocks at most its own length too much.
    if (!shown[a] && !shown[b] && !shown[c])
    {
      return;
    }
    const glm::dvec3 corners[3] = { positions[a], positions[b], positions[c] };
    const glm::dvec3 albedo =
      cellFlag ? colorOf(cell, a) : (colorOf(cell, a) + colorOf(cell, b) + colorOf(cell, c)) / 3.0;
    this->AddTriangle(corners, albedo);
  };

  // Cell data count vertices and lines first.
  vtkIdType cell = data->GetNumberOfVerts() + data->GetNumberOfLines();
  vtkIdType count;
  const vtkIdType* ids;
  auto polygons = vtk::TakeSmartPointer(data->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal();
       polygons->GoToNextCell(), ++cell)
  {
    polygons->GetCurrentCell(count, ids);
    for (vtkIdType i = 2; i < count; ++i)
    {
      add(cell, ids[0], ids[i - 1], ids[i]);
    }
  }
  auto strips = vtk::TakeSmartPointer(data->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell(), ++cell)
  {
    strips->GetCurrentCell(count, ids);
    for (vtkIdType i = 2; i < count; ++i)
    {
      add(cell, ids[i - 2], ids[i - 1], ids[i]);
    }
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectOccupancyVolume::IsOccupied(const glm::ivec3& voxel) const
{
  if (glm::any(glm::lessThan(voxel, glm::ivec3(0))) ||
    glm::any(glm::greaterThanEqual(voxel, this->Size)))
  {
    return false;
  }
  const glm::uvec4& column = this->Columns[voxel.x + static_cast<size_t>(this->Size.x) * voxel.y];
  return (column[voxel.z / 32] >> (voxel.z % 32) & 1u) != 0u;
}

//------------------------------------------------------------------------------
bool vtkIndirectOccupancyVolume::IsAnyOccupied(
  const glm::ivec3& lower, const glm::ivec3& upper) const
{
  const glm::ivec3 first = glm::max(lower, glm::ivec3(0));
  const glm::ivec3 last = glm::min(upper, this->Size - 1);
  const glm::uvec4 range = vtkIndirectKernels::vtkiBitRange(first.z, last.z);
  for (int y = first.y; y <= last.y && first.z <= last.z; ++y)
  {
    for (int x = first.x; x <= last.x; ++x)
    {
      if (vtkIndirectKernels::vtkiAnyBit(
            this->Columns[x + static_cast<size_t>(this->Size.x) * y], range))
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
bool vtkIndirectOccupancyVolume::IsFree(const glm::vec3& start, const glm::vec3& end) const
{
  vtkIndirectKernels::vtkiWalk walk = vtkIndirectKernels::vtkiBeginWalk(start, end);
  const int count = walk.remaining;
  for (int i = 0; i <= count; ++i)
  {
    const glm::ivec2 at = walk.column;
    if (at.x >= 0 && at.y >= 0 && at.x < this->Size.x && at.y < this->Size.y &&
      vtkIndirectKernels::vtkiAnyBit(this->Columns[at.x + static_cast<size_t>(this->Size.x) * at.y],
        vtkIndirectKernels::vtkiWalkBits(walk)))
    {
      return false;
    }
    vtkIndirectKernels::vtkiAdvance(walk);
  }
  return true;
}

//------------------------------------------------------------------------------
size_t vtkIndirectOccupancyVolume::GetNumberOfOccupiedVoxels() const
{
  size_t count = 0;
  for (const glm::uvec4& column : this->Columns)
  {
    for (int word = 0; word < 4; ++word)
    {
      for (glm::uint bits = column[word]; bits; bits &= bits - 1u)
      {
        ++count;
      }
    }
  }
  return count;
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::Activate(
  vtkOpenGLRenderWindow* window, vtkShaderProgram* program) const
{
  if (!this->Texture)
  {
    this->Texture = vtkSmartPointer<vtkTextureObject>::New();
    this->Uploaded = false;
  }
  if (!this->Uploaded)
  {
    this->Texture->SetContext(window);
    this->Texture->SetInternalFormat(GL_RGBA32UI);
    this->Texture->SetFormat(GL_RGBA_INTEGER);
    this->Texture->SetDataType(GL_UNSIGNED_INT);
    this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
    this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    this->Texture->Create2DFromRaw(static_cast<unsigned int>(this->Size.x),
      static_cast<unsigned int>(this->Size.y), 4, VTK_UNSIGNED_INT,
      const_cast<glm::uvec4*>(this->Columns.data()));
    this->Uploaded = true;
  }
  this->Texture->Activate();
  program->SetUniformi("vtkiOccupancy", this->Texture->GetTextureUnit());
  const float origin[4] = { static_cast<float>(this->Origin.x), static_cast<float>(this->Origin.y),
    static_cast<float>(this->Origin.z), static_cast<float>(1.0 / this->VoxelSize) };
  program->SetUniform4f("vtkiOccupancyOrigin", origin);
  const float size[3] = { static_cast<float>(this->Size.x), static_cast<float>(this->Size.y),
    static_cast<float>(this->Size.z) };
  program->SetUniform3f("vtkiOccupancySize", size);
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::Deactivate() const
{
  if (this->Texture)
  {
    this->Texture->Deactivate();
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectOccupancyVolume::GetBytes() const
{
  return (this->Uploaded ? this->Columns.size() * sizeof(glm::uvec4) : 0) +
    (this->DistanceField ? this->DistanceField->GetBytes() : 0);
}

//------------------------------------------------------------------------------
size_t vtkIndirectOccupancyVolume::GetMainMemoryBytes() const
{
  return this->Columns.size() * sizeof(glm::uvec4) + this->Triangles.GetBytes() +
    this->Tree.GetBytes() + (this->DistanceField ? this->DistanceField->GetMainMemoryBytes() : 0);
}

//------------------------------------------------------------------------------
void vtkIndirectOccupancyVolume::Release(vtkWindow* window)
{
  if (this->Texture)
  {
    this->Texture->ReleaseGraphicsResources(window);
    this->Texture = nullptr;
  }
  if (this->DistanceField)
  {
    this->DistanceField->Release(window);
  }
  this->Uploaded = false;
}
