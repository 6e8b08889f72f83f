// SPDX-License-Identifier: BSD-3-Clause
#include "Visibility/vtkIndirectRaySurfaces.h"

#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectRevision.h"
#include "Visibility/vtkIndirectPolygons.h"
#include "vtkActor.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkSmartPointer.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>

namespace
{
glm::dvec3 ReadTuple(vtkDataArray* array, vtkIdType at)
{
  double values[9] = {};
  if (at < array->GetNumberOfTuples() && array->GetNumberOfComponents() <= 9)
  {
    array->GetTuple(at, values);
  }
  return { values[0], values[1], values[2] };
}

bool IsFinite(const glm::dvec3& v)
{
  return std::isfinite(v.x + v.y + v.z);
}

// Where a texture coordinate falls among so many pixels.
vtkIdType FindPixel(vtkIdType i, vtkIdType count, int wrap)
{
  if (wrap == vtkTexture::Repeat)
  {
    return (i % count + count) % count;
  }
  if (wrap == vtkTexture::MirroredRepeat)
  {
    const vtkIdType at = (i % (2 * count) + 2 * count) % (2 * count);
    return at < count ? at : 2 * count - 1 - at;
  }
  return std::min(std::max<vtkIdType>(i, 0), count - 1);
}
}

//------------------------------------------------------------------------------
// What a mapper draws of one vtkPolyData: its arrays, held, and its material.
struct vtkIndirectRaySurfaces::Piece
{
  vtkIndirectPolygons Polygons;
  glm::dmat3 NormalsToWorld{ 1.0 };
  vtkSmartPointer<vtkDataArray> PointNormals;
  vtkSmartPointer<vtkDataArray> CellNormals;
  bool SendsLight = true;
  bool Lit = true;
  bool CullsFront = false;
  bool CullsBack = false;
  bool HasBackColor = false;
  glm::dvec3 BackColor{ 0.0 };
  // Scalars that are interpolated before they are mapped.
  vtkSmartPointer<vtkScalarsToColors> Table;
  std::vector<double> Scalars;
  // Texture of the actor.
  vtkSmartPointer<vtkDataArray> Coordinates;
  std::vector<unsigned char> Pixels; // rgb
  vtkIdType PixelCounts[2] = { 0, 0 };
  int Wrap = vtkTexture::Repeat;
  bool Smooth = false;
  bool TextureOnBack = true;

  void ReadScalars();
  void ReadTexture();
  glm::dvec3 FindTexture(const glm::dvec3& at) const;
};

//------------------------------------------------------------------------------
// As VTK does where lines of constant colour run through triangles: colours of interpolated
// scalars.
void vtkIndirectRaySurfaces::Piece::ReadScalars()
{
  vtkMapper* mapper = this->Polygons.Mapper;
  if (!mapper->GetInterpolateScalarsBeforeMapping() || !this->Polygons.HasColorsOfPoints() ||
    !mapper->CanUseTextureMapForColoring(this->Polygons.Data))
  {
    return;
  }
  int cellFlag = 0;
  auto* scalars = vtkDataArray::SafeDownCast(
    vtkAbstractMapper::GetAbstractScalars(this->Polygons.Data, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cellFlag));
  if (!scalars)
  {
    return;
  }
  this->Table = mapper->GetLookupTable();
  const bool magnitude = this->Table->GetVectorMode() == vtkScalarsToColors::MAGNITUDE &&
    scalars->GetNumberOfComponents() > 1;
  const int component =
    std::min(std::max({ this->Table->GetVectorComponent(), mapper->GetArrayComponent(), 0 }),
      scalars->GetNumberOfComponents() - 1);
  this->Scalars.resize(static_cast<size_t>(scalars->GetNumberOfTuples()));
  for (size_t i = 0; i < this->Scalars.size(); ++i)
  {
    const vtkIdType at = static_cast<vtkIdType>(i);
    this->Scalars[i] =
      magnitude ? glm::length(ReadTuple(scalars, at)) : scalars->GetComponent(at, component);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectRaySurfaces::Piece::ReadTexture()
{
  vtkTexture* texture = this->Polygons.Actor->GetTexture();
  vtkDataArray* coordinates = this->Polygons.Data->GetPointData()->GetTCoords();
  vtkImageData* image = texture && !texture->GetCubeMap() ? texture->GetInput() : nullptr;
  vtkDataArray* values = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!coordinates || !values || values->GetNumberOfTuples() == 0)
  {
    return;
  }
  int size[3];
  image->GetDimensions(size);
  // A texture lies in a plane of any two axes.
  int counts[2] = { 1, 1 };
  for (int axis = 0, next = 0; axis < 3 && next < 2; ++axis)
  {
    if (size[axis] > 1)
    {
      counts[next++] = size[axis];
    }
  }
  const size_t count = static_cast<size_t>(counts[0]) * static_cast<size_t>(counts[1]);
  const bool mapped = texture->GetColorMode() == VTK_COLOR_MODE_MAP_SCALARS ||
    !vtkUnsignedCharArray::SafeDownCast(values);
  const unsigned char* bytes = mapped ? texture->MapScalarsToColors(values)
                                      : vtkUnsignedCharArray::SafeDownCast(values)->GetPointer(0);
  const int components = mapped ? 4 : values->GetNumberOfComponents();
  if (!bytes || count > static_cast<size_t>(values->GetNumberOfTuples()))
  {
    return;
  }
  this->Coordinates = coordinates;
  this->PixelCounts[0] = counts[0];
  this->PixelCounts[1] = counts[1];
  this->Wrap = texture->GetWrap();
  this->Smooth = texture->GetInterpolate() != 0;
  this->TextureOnBack = this->Polygons.Actor->GetProperty()->GetShowTexturesOnBackface();
  this->Pixels.resize(3 * count);
  for (size_t i = 0; i < count; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      this->Pixels[3 * i + static_cast<size_t>(c)] =
        bytes[static_cast<size_t>(components) * i + static_cast<size_t>(components < 3 ? 0 : c)];
    }
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectRaySurfaces::Piece::FindTexture(const glm::dvec3& at) const
{
  const auto read = [this](vtkIdType x, vtkIdType y)
  {
    const size_t i = static_cast<size_t>(FindPixel(x, this->PixelCounts[0], this->Wrap) +
      this->PixelCounts[0] * FindPixel(y, this->PixelCounts[1], this->Wrap));
    return glm::dvec3(this->Pixels[3 * i], this->Pixels[3 * i + 1], this->Pixels[3 * i + 2]) /
      255.0;
  };
  glm::dvec2 p = glm::dvec2(at) * glm::dvec2(this->PixelCounts[0], this->PixelCounts[1]);
  if (!std::isfinite(p.x + p.y) || glm::length(p) > 1e15)
  {
    return glm::dvec3(1.0);
  }
  if (!this->Smooth)
  {
    return read(static_cast<vtkIdType>(std::floor(p.x)), static_cast<vtkIdType>(std::floor(p.y)));
  }
  p -= 0.5;
  const glm::dvec2 first = glm::floor(p);
  const glm::dvec2 f = p - first;
  const vtkIdType x = static_cast<vtkIdType>(first.x);
  const vtkIdType y = static_cast<vtkIdType>(first.y);
  return glm::mix(glm::mix(read(x, y), read(x + 1, y), f.x),
    glm::mix(read(x, y + 1), read(x + 1, y + 1), f.x), f.y);
}

//------------------------------------------------------------------------------
vtkIndirectRaySurfaces::vtkIndirectRaySurfaces() = default;
vtkIndirectRaySurfaces::~vtkIndirectRaySurfaces() = default;

//------------------------------------------------------------------------------
void vtkIndirectRaySurfaces::Clear()
{
  this->Pieces.clear();
  this->Triangles = {};
  this->Tree.Clear();
  this->Key.clear();
  this->Shape.clear();
  this->LeftOut.clear();
}

//------------------------------------------------------------------------------
bool vtkIndirectRaySurfaces::Update(const vtkIndirectFrame& frame)
{
  std::vector<double> key(frame.SceneBounds, frame.SceneBounds + 6);
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    key.push_back(static_cast<double>(reinterpret_cast<uintptr_t>(caster.Prop)));
    key.push_back(static_cast<double>(caster.Revision));
    key.push_back(caster.SendsLight ? 1.0 : 0.0);
  }
  if (key == this->Key)
  {
    return false;
  }
  std::vector<double> shape;
  this->Read(frame, shape);
  this->Key = key;
  if (shape != this->Shape)
  {
    this->MakeTree();
    this->Shape = shape;
  }
  for (const auto& piece : this->Pieces)
  {
    piece->Polygons.Triangles = {};
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
    vtkIndirectPolygons& piece = this->Pieces[number]->Polygons;
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
  this->Tree.Finish(true);
  ++this->NumberOfBuilds;
}

//------------------------------------------------------------------------------
void vtkIndirectRaySurfaces::Read(const vtkIndirectFrame& frame, std::vector<double>& shape)
{
  this->Pieces.clear();
  this->LeftOut.clear();
  shape = { frame.SceneCenter.x, frame.SceneCenter.y, frame.SceneCenter.z, frame.SceneScale };
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    size_t triangles = 0;
    vtkIndirectPolygons::Read(frame, caster.Prop,
      [&](vtkIndirectPolygons& taken)
      {
        auto piece = std::make_unique<Piece>();
        piece->Polygons = std::move(taken);
        const vtkIndirectPolygons& polygons = piece->Polygons;
        triangles += polygons.Triangles.size();
        piece->SendsLight = caster.SendsLight;
        vtkProperty* property = polygons.Actor->GetProperty();
        vtkPolyData* data = polygons.Data;
        if (property->GetInterpolation() != VTK_FLAT)
        {
          piece->PointNormals = data->GetPointData()->GetNormals();
        }
        if (!piece->PointNormals)
        {
          piece->CellNormals = data->GetCellData()->GetNormals();
        }
        piece->NormalsToWorld = glm::transpose(glm::inverse(glm::dmat3(polygons.ToWorld)));
        piece->Lit = property->GetLighting();
        piece->CullsFront = property->GetFrontfaceCulling() != 0;
        piece->CullsBack = property->GetBackfaceCulling() != 0;
        if (vtkProperty* back = polygons.Actor->GetBackfaceProperty())
        {
          const double* color = back->GetDiffuseColor();
          piece->HasBackColor = true;
          piece->BackColor = back->GetDiffuse() * glm::dvec3(color[0], color[1], color[2]);
        }
        piece->ReadScalars();
        piece->ReadTexture();
        vtkIndirectRevision::AppendTo(shape, data);
        shape.push_back(static_cast<double>(polygons.Triangles.size()));
        vtkPlaneCollection* planes = polygons.Mapper->GetClippingPlanes();
        for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
        {
          vtkIndirectRevision::AppendTo(shape, planes->GetItem(i));
        }
        for (int column = 0; column < 4; ++column)
        {
          for (int row = 0; row < 3; ++row)
          {
            shape.push_back(polygons.ToWorld[column][row]);
          }
        }
        this->Pieces.push_back(std::move(piece));
      });
    if (triangles == 0)
    {
      this->LeftOut.emplace_back(caster.Prop->GetClassName(),
        "its mapper has no polygons that the processor can read; rays pass through it");
    }
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
    const Triangle& triangle = this->Triangles[hit.Triangle];
    const Piece& piece = *this->Pieces[triangle.Piece];
    const std::vector<glm::dvec3>& positions = piece.Polygons.Positions;
    const glm::dvec3& a = positions[triangle.Points[0]];
    const glm::dvec3& b = positions[triangle.Points[1]];
    const glm::dvec3& c = positions[triangle.Points[2]];
    const glm::dvec3 facet = glm::normalize(glm::cross(b - a, c - a));
    const bool front = glm::dot(facet, direction) < 0.0;
    meeting.Position = hit.Weights[0] * a + hit.Weights[1] * b + hit.Weights[2] * c;
    if (front ? piece.CullsFront : piece.CullsBack)
    {
      from = meeting.Position;
      passed += hit.Distance;
      last = hit.Triangle;
      continue;
    }
    meeting.FacetNormal = front ? facet : -facet;
    meeting.Triangle = hit.Triangle;
    meeting.Distance = passed + hit.Distance;
    this->Shade(triangle, hit, front, meeting);
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
void vtkIndirectRaySurfaces::Shade(const Triangle& triangle,
  const vtkIndirectTriangleTree::Hit& hit, bool front, Meeting& meeting) const
{
  const Piece& piece = *this->Pieces[triangle.Piece];
  const auto interpolate = [&](vtkDataArray* array)
  {
    glm::dvec3 sum(0.0);
    for (int i = 0; i < 3; ++i)
    {
      sum += hit.Weights[i] * ReadTuple(array, static_cast<vtkIdType>(triangle.Points[i]));
    }
    return sum;
  };
  meeting.Sends = piece.SendsLight && piece.Lit;
  meeting.Normal = meeting.FacetNormal;
  if (piece.PointNormals || piece.CellNormals)
  {
    const glm::dvec3 normal = piece.NormalsToWorld *
      (piece.PointNormals ? interpolate(piece.PointNormals)
                          : ReadTuple(piece.CellNormals, static_cast<vtkIdType>(triangle.Cell)));
    const double length = glm::length(normal);
    if (length > 0.0 && std::isfinite(length))
    {
      meeting.Normal = (front ? 1.0 : -1.0) / length * normal;
    }
    else
    {
      meeting.Sends = false; // a zero or undefined normal
    }
  }
  glm::dvec3 albedo(0.0);
  if (!front && piece.HasBackColor && !piece.Polygons.HasColorsOfPoints() &&
    !piece.Polygons.HasColorsOfCells())
  {
    albedo = piece.BackColor;
  }
  else if (piece.Table)
  {
    double scalar = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const size_t point = triangle.Points[i];
      scalar += hit.Weights[i] * (point < piece.Scalars.size() ? piece.Scalars[point] : 0.0);
    }
    double color[3];
    piece.Table->GetColor(scalar, color);
    albedo =
      piece.Polygons.Actor->GetProperty()->GetDiffuse() * glm::dvec3(color[0], color[1], color[2]);
  }
  else
  {
    for (int i = 0; i < 3; ++i)
    {
      albedo += hit.Weights[i] *
        piece.Polygons.GetAlbedo(
          static_cast<vtkIdType>(triangle.Cell), static_cast<vtkIdType>(triangle.Points[i]));
    }
  }
  if (piece.Coordinates && !piece.Polygons.PhysicallyBased && (front || piece.TextureOnBack))
  {
    albedo *= piece.FindTexture(interpolate(piece.Coordinates));
  }
  meeting.Albedo = IsFinite(albedo) ? glm::max(albedo, glm::dvec3(0.0)) : glm::dvec3(0.0);
  meeting.PhysicallyBased = piece.Polygons.PhysicallyBased;
}

//------------------------------------------------------------------------------
size_t vtkIndirectRaySurfaces::GetBytes() const
{
  size_t bytes = this->Tree.GetBytes() + this->Triangles.size() * sizeof(Triangle);
  for (const auto& piece : this->Pieces)
  {
    bytes += piece->Polygons.Positions.size() * sizeof(glm::dvec3) +
      piece->Scalars.size() * sizeof(double) + piece->Pixels.size();
  }
  return bytes;
}
