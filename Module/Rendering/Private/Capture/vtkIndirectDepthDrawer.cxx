// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Capture/vtkIndirectDepthDrawer.h"

#include "OpenGL/vtkIndirectShaderLibrary.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkActor.h"
#include "vtkDataSetMapper.h"
#include "vtkInformation.h"
#include "vtkOpenGLIndexBufferObject.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkOpenGLVertexArrayObject.h"
#include "vtkOpenGLVertexBufferObject.h"
#include "vtkOpenGLVertexBufferObjectGroup.h"
#include "vtkPlaneCollection.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkVersionMacros.h"

#include <cstring>

namespace
{
// Access to private members of mappers and props.
class MapperAccess : public vtkOpenGLPolyDataMapper
{
public:
  static vtkOpenGLVertexBufferObject* GetPositions(vtkOpenGLPolyDataMapper* mapper)
  {
    return (mapper->*(&MapperAccess::VBOs))->GetVBO("vertexMC");
  }
  static int CountPositions(vtkOpenGLPolyDataMapper* mapper)
  {
    return (mapper->*(&MapperAccess::VBOs))->GetNumberOfTuples("vertexMC");
  }
  static vtkMTimeType GetBuildTime(vtkOpenGLPolyDataMapper* mapper)
  {
    return (mapper->*(&MapperAccess::VBOBuildTime)).GetMTime();
  }
  static vtkOpenGLIndexBufferObject* GetIndices(vtkOpenGLPolyDataMapper* mapper, int primitive)
  {
    return (mapper->*(&MapperAccess::Primitives))[primitive].IBO;
  }
  static void SetIndices(
    vtkOpenGLPolyDataMapper* mapper, int primitive, vtkOpenGLIndexBufferObject* indices)
  {
    (mapper->*(&MapperAccess::Primitives))[primitive].IBO = indices;
  }
  static bool HasCellData(vtkOpenGLPolyDataMapper* mapper)
  {
    return mapper->*(&MapperAccess::HaveCellScalars) || mapper->*(&MapperAccess::HaveCellNormals);
  }
  static constexpr int Kinds[2] = { PrimitiveTris, PrimitiveTriStrips };
};

class PropAccess : public vtkProp
{
public:
  // The prop's getter would create a property.
  static vtkShaderProperty* GetShaders(vtkProp* prop)
  {
    return prop->*(&PropAccess::ShaderProperty);
  }
};

bool HasShaders(vtkProp* prop)
{
  vtkShaderProperty* shaders = PropAccess::GetShaders(prop);
  return shaders &&
    (shaders->HasVertexShaderCode() || shaders->HasFragmentShaderCode() ||
      shaders->HasGeometryShaderCode() || shaders->GetNumberOfShaderReplacements() > 0);
}

vtkMapper* FindOwnMapper(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor ? actor->GetMapper() : nullptr;
}

// Returns VTK's own mapper of polygons, or the one that VTK's own mapper of data sets draws with.
// Subclasses may draw something else.
vtkOpenGLPolyDataMapper* FindMapper(vtkProp* prop)
{
  vtkMapper* mapper = FindOwnMapper(prop);
  auto* dataSetMapper = vtkDataSetMapper::SafeDownCast(mapper);
  if (dataSetMapper && std::strcmp(mapper->GetClassName(), "vtkDataSetMapper") == 0)
  {
    mapper = dataSetMapper->GetPolyDataMapper();
  }
  const bool plain = mapper && std::strcmp(prop->GetClassName(), "vtkOpenGLActor") == 0 &&
    std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0;
  return plain ? static_cast<vtkOpenGLPolyDataMapper*>(mapper) : nullptr;
}

// Returns true if the buffers of a mapper hold what the prop's own mapper would draw now.
bool IsBuilt(vtkProp* prop, vtkOpenGLPolyDataMapper* mapper)
{
  vtkMapper* own = FindOwnMapper(prop);
  vtkDataObject* data = own->GetInputDataObject(0, 0);
  vtkPolyData* input = mapper->GetInput();
  vtkOpenGLVertexBufferObject* positions = MapperAccess::GetPositions(mapper);
  const vtkMTimeType built = MapperAccess::GetBuildTime(mapper);
  return data && input && positions && MapperAccess::CountPositions(mapper) > 0 &&
    positions->GetHandle() != 0 && built > mapper->GetMTime() && built > input->GetMTime() &&
    built > own->GetMTime() && built > data->GetMTime();
}
}

//------------------------------------------------------------------------------
vtkIndirectDepthDrawer::vtkIndirectDepthDrawer(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Vertices(vtkSmartPointer<vtkOpenGLVertexArrayObject>::New())
  , Indices(vtkSmartPointer<vtkOpenGLBufferObject>::New())
{
}

vtkIndirectDepthDrawer::~vtkIndirectDepthDrawer() = default;

//------------------------------------------------------------------------------
bool vtkIndirectDepthDrawer::CanDraw(vtkProp* prop)
{
  vtkOpenGLPolyDataMapper* mapper = FindMapper(prop);
  if (!mapper || HasShaders(prop))
  {
    return false;
  }
  auto* actor = static_cast<vtkActor*>(prop);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  if (actor->GetCoordinateSystem() != vtkProp3D::WORLD)
  {
    return false; // its matrix is not its only placement
  }
#endif
  vtkProperty* property = actor->GetProperty();
  vtkPlaneCollection* planes = actor->GetMapper()->GetClippingPlanes();
  if (property->GetRepresentation() != VTK_SURFACE || property->GetBackfaceCulling() ||
    property->GetFrontfaceCulling() || actor->GetTexture() || property->GetNumberOfTextures() > 0 ||
    (planes && planes->GetNumberOfItems() > 0))
  {
    return false;
  }
  return IsBuilt(prop, mapper);
}

//------------------------------------------------------------------------------
vtkPolyData* vtkIndirectDepthDrawer::FindMesh(vtkProp* prop)
{
  vtkOpenGLPolyDataMapper* mapper = FindMapper(prop);
  return mapper ? mapper->GetInput() : nullptr;
}

//------------------------------------------------------------------------------
size_t vtkIndirectDepthDrawer::CountTriangles(vtkProp* prop)
{
  size_t indices = 0;
  for (const int kind : MapperAccess::Kinds)
  {
    indices += MapperAccess::GetIndices(FindMapper(prop), kind)->IndexCount;
  }
  return indices / 3;
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectMeshParts::Triangle> vtkIndirectDepthDrawer::ReadTriangles(vtkProp* prop)
{
  std::vector<vtkIndirectMeshParts::Triangle> triangles;
  vtkOpenGLPolyDataMapper* mapper = FindMapper(prop);
  if (MapperAccess::CountPositions(mapper) != mapper->GetInput()->GetNumberOfPoints())
  {
    return triangles;
  }
  triangles.resize(CountTriangles(prop));
  size_t read = 0;
  for (const int kind : MapperAccess::Kinds)
  {
    vtkOpenGLIndexBufferObject* indices = MapperAccess::GetIndices(mapper, kind);
    if (indices->IndexCount)
    {
      const size_t bytes = indices->IndexCount / 3 * sizeof(vtkIndirectMeshParts::Triangle);
      indices->Bind();
      glGetBufferSubData(
        GL_ELEMENT_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes), &triangles[read]);
      indices->Release();
      read += indices->IndexCount / 3;
    }
  }
  return triangles;
}

//------------------------------------------------------------------------------
vtkIndirectDepthDrawer::IndexBuffers vtkIndirectDepthDrawer::GetIndices(vtkProp* prop)
{
  vtkOpenGLPolyDataMapper* mapper = FindMapper(prop);
  return { MapperAccess::GetIndices(mapper, MapperAccess::Kinds[0]),
    MapperAccess::GetIndices(mapper, MapperAccess::Kinds[1]) };
}

//------------------------------------------------------------------------------
void vtkIndirectDepthDrawer::SetIndices(vtkProp* prop, const IndexBuffers& buffers)
{
  vtkOpenGLPolyDataMapper* mapper = FindMapper(prop);
  for (size_t i = 0; i < buffers.size(); ++i)
  {
    MapperAccess::SetIndices(mapper, MapperAccess::Kinds[i], buffers[i]);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectDepthDrawer::NumbersTriangles(vtkProp* prop)
{
  return MapperAccess::HasCellData(FindMapper(prop)) ||
    static_cast<vtkActor*>(prop)->GetProperty()->GetEdgeVisibility();
}

//------------------------------------------------------------------------------
bool vtkIndirectDepthDrawer::Begin(
  vtkOpenGLRenderWindow* window, vtkProp* prop, vtkIndirectMeshParts* parts, bool slopes)
{
  this->Parts = parts;
  this->Mapper = FindMapper(prop);
  this->Program = window->GetShaderCache()->ReadyShaderProgram(
    vtkIndirectShaderLibrary::GetText("vtkIndirectDepthVS.glsl").c_str(),
    vtkIndirectShaderLibrary::GetText(
      slopes ? "vtkIndirectDepthSlopeFS.glsl" : "vtkIndirectDepthFS.glsl")
      .c_str(),
    "");
  if (!this->Program)
  {
    return false;
  }
  if (parts)
  {
    this->ToWorld = GetToWorld(prop, *parts);
    if (!parts->PointBuffer)
    {
      parts->PointBuffer = vtkSmartPointer<vtkOpenGLBufferObject>::New();
      parts->PointBuffer->Upload(parts->Points, vtkOpenGLBufferObject::ArrayBuffer);
      parts->IndexBuffer = vtkSmartPointer<vtkOpenGLBufferObject>::New();
      parts->IndexBuffer->Upload(parts->Indices, vtkOpenGLBufferObject::ElementArrayBuffer);
    }
    this->Vertices->Bind();
    const int stride = vtkIndirectMeshParts::FloatsOfPoint * sizeof(float);
    this->Vertices->AddAttributeArray(
      this->Program, parts->PointBuffer, "vertexMC", 0, stride, VTK_FLOAT, 3, false);
    this->Vertices->AddAttributeArray(
      this->Program, parts->PointBuffer, "insetMC", stride / 2, stride, VTK_FLOAT, 3, false);
    return true;
  }
  this->ToWorld = vtkIndirectFrame::ToGLM(prop->GetMatrix());
  vtkOpenGLVertexBufferObject* positions = MapperAccess::GetPositions(this->Mapper);
  if (positions->GetCoordShiftAndScaleEnabled())
  {
    // Mappers hold (position - shift) * scale.
    const std::vector<double>& shift = positions->GetShift();
    const std::vector<double>& scale = positions->GetScale();
    glm::dmat4 restore(1.0);
    for (int i = 0; i < 3; ++i)
    {
      restore[i][i] = 1.0 / scale[static_cast<size_t>(i)];
      restore[3][i] = shift[static_cast<size_t>(i)];
    }
    this->ToWorld *= restore;
  }
  this->Vertices->Bind();
  this->Vertices->AddAttributeArray(this->Program, positions, "vertexMC", 0, false);
  this->Vertices->RemoveAttributeArray("insetMC"); // then it is zero
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthDrawer::SetSlopeScale(const glm::dvec2& scale)
{
  vtkIndirectSetUniform(this->Program, "vtkiSlopeScale", glm::vec2(scale));
}

//------------------------------------------------------------------------------
size_t vtkIndirectDepthDrawer::Draw(const glm::dmat4& worldToClip)
{
  size_t triangles = 0;
  vtkIndirectSetUniform(this->Program, "vtkiToClip", glm::mat4(worldToClip * this->ToWorld));
  const auto last = static_cast<GLuint>(MapperAccess::CountPositions(this->Mapper) - 1);
  for (const int kind : MapperAccess::Kinds)
  {
    vtkOpenGLIndexBufferObject* indices = MapperAccess::GetIndices(this->Mapper, kind);
    if (indices->IndexCount)
    {
      indices->Bind();
      glDrawRangeElements(
        GL_TRIANGLES, 0, last, static_cast<GLsizei>(indices->IndexCount), GL_UNSIGNED_INT, nullptr);
      indices->Release();
      triangles += indices->IndexCount / 3;
    }
  }
  return triangles;
}

//------------------------------------------------------------------------------
size_t vtkIndirectDepthDrawer::Draw(const glm::dmat4& worldToClip, const glm::dvec4& emitter,
  const std::vector<vtkIndirectMeshParts::Level>& levels)
{
  size_t indices = 0;
  this->Counts.clear();
  this->Offsets.clear();
  for (const vtkIndirectMeshParts::Level& level : levels)
  {
    this->Counts.push_back(static_cast<GLsizei>(level.Count));
    this->Offsets.push_back(reinterpret_cast<const void*>(level.First * sizeof(unsigned int)));
    indices += level.Count;
  }
  this->SetView(worldToClip, emitter);
  this->Parts->IndexBuffer->Bind();
  glMultiDrawElements(GL_TRIANGLES, this->Counts.data(), GL_UNSIGNED_INT, this->Offsets.data(),
    static_cast<GLsizei>(levels.size()));
  this->Parts->IndexBuffer->Release();
  return indices / 3;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthDrawer::Draw(const glm::dmat4& worldToClip, const glm::dvec4& emitter,
  const std::vector<unsigned int>& indices)
{
  this->SetView(worldToClip, emitter);
  this->Indices->Upload(indices, vtkOpenGLBufferObject::ElementArrayBuffer);
  this->Indices->Bind();
  glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(indices.size()), GL_UNSIGNED_INT, nullptr);
  this->Indices->Release();
}

//------------------------------------------------------------------------------
void vtkIndirectDepthDrawer::SetView(const glm::dmat4& worldToClip, const glm::dvec4& emitter)
{
  vtkIndirectSetUniform(this->Program, "vtkiToClip", glm::mat4(worldToClip * this->ToWorld));
  vtkIndirectSetUniform(
    this->Program, "vtkiEmitter", glm::vec4(glm::inverse(this->ToWorld) * emitter));
}

//------------------------------------------------------------------------------
glm::dmat4 vtkIndirectDepthDrawer::GetToWorld(vtkProp* prop, const vtkIndirectMeshParts& parts)
{
  glm::dmat4 restore(1.0);
  restore[3] = glm::dvec4(parts.Middle, 1.0);
  return vtkIndirectFrame::ToGLM(prop->GetMatrix()) * restore;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthDrawer::End()
{
  this->Parts = nullptr;
  this->Vertices->Release();
  this->Mapper = nullptr;
}

//------------------------------------------------------------------------------
void vtkIndirectDepthDrawer::ReleaseOwn(vtkWindow*)
{
  this->Vertices->ReleaseGraphicsResources();
  this->Indices->ReleaseGraphicsResources();
  this->Program = nullptr;
}
