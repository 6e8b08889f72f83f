// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectFrame.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPolyData.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProperty.h"

#include <cmath>
#include <cstring>

namespace
{
bool IsFinite(const double bounds[6])
{
  for (int i = 0; i < 6; ++i)
  {
    if (!std::isfinite(bounds[i]))
    {
      return false;
    }
  }
  return vtkMath::AreBoundsInitialized(bounds) != 0;
}

// Sizes of points are pixels of the target: in a light's map they would be sprites of any size that
// shadow themselves.
bool IsDrawnAsPoints(vtkProp* prop)
{
  vtkActor* actor = vtkActor::SafeDownCast(prop);
  return actor &&
    (actor->GetProperty()->GetRepresentation() == VTK_POINTS ||
      actor->GetProperty()->GetRenderPointsAsSpheres());
}

// Whether an actor and its mapper are VTK's own for polygons, not classes derived from them.
bool IsPlain(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  return mapper && std::strcmp(actor->GetClassName(), "vtkOpenGLActor") == 0 &&
    std::strcmp(mapper->GetClassName(), "vtkOpenGLPolyDataMapper") == 0;
}

// Whether a prop is drawn by VTK's own polygons with alpha 1 wherever it draws: no texture, which
// has soft edges, no shader text or pass of somebody else's, and nothing that is forced to be
// opaque.
bool IsSolid(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor || !IsPlain(actor))
  {
    return false;
  }
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  return !actor->GetTexture() && actor->GetProperty()->GetNumberOfTextures() == 0 &&
    !actor->GetForceOpaque() &&
    !actor->GetPropertyKeys()->Has(vtkOpenGLRenderPass::RenderPasses()) &&
    shaders->GetNumberOfShaderReplacements() == 0 && !shaders->HasVertexShaderCode() &&
    !shaders->HasFragmentShaderCode() && !shaders->HasGeometryShaderCode();
}

// About how many triangles a prop draws; 1e9 where its mapper alone knows.
double CountTriangles(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  if (!actor || !IsPlain(actor))
  {
    return 1e9;
  }
  actor->GetBounds(); // brings the mapper's data up to date
  auto* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInput());
  if (!data)
  {
    return 0.0;
  }
  // A polygon or strip of n points is n - 2 triangles; lines and points are as many of their own.
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

// VTK lights all of its interpolations but PBR by Phong's model.
bool IsSpecular(vtkProperty* property)
{
  const double* color = property ? property->GetSpecularColor() : nullptr;
  return color && property->GetLighting() && property->GetInterpolation() != VTK_PBR &&
    property->GetSpecular() > 0.0 && (color[0] > 0.0 || color[1] > 0.0 || color[2] > 0.0);
}

bool IsSpecular(vtkProp* prop)
{
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    return IsSpecular(actor->GetProperty()) || IsSpecular(actor->GetBackfaceProperty());
  }
  vtkNew<vtkPropCollection> actors; // of assemblies and levels of detail
  auto* assembly = vtkPropAssembly::SafeDownCast(prop);
  vtkPropCollection* parts = assembly ? assembly->GetParts() : actors.Get();
  if (!assembly)
  {
    prop->GetActors(actors);
  }
  vtkCollectionSimpleIterator it;
  parts->InitTraversal(it);
  while (vtkProp* part = parts->GetNextProp(it))
  {
    if (part != prop && IsSpecular(part))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
glm::dmat4 vtkIndirectFrame::ToGLM(vtkMatrix4x4* matrix)
{
  glm::dmat4 result;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}

//------------------------------------------------------------------------------
bool vtkIndirectFrame::Build(const vtkRenderState* state, std::string& why)
{
  this->Renderer = state->GetRenderer();
  this->Window = vtkOpenGLRenderWindow::SafeDownCast(this->Renderer->GetRenderWindow());
  auto* framebuffer = vtkOpenGLFramebufferObject::SafeDownCast(state->GetFrameBuffer());
  if (framebuffer)
  {
    framebuffer->GetLastSize(this->Size);
    this->Origin[0] = this->Origin[1] = 0;
  }
  else
  {
    this->Renderer->GetTiledSizeAndOrigin(
      &this->Size[0], &this->Size[1], &this->Origin[0], &this->Origin[1]);
  }
  this->CollectLights();
  this->CollectProps();
  if (this->Size[0] < 1 || this->Size[1] < 1)
  {
    why = "the viewport is empty";
    return false;
  }
  if (this->Casters.empty())
  {
    why = "nothing opaque is visible";
    return false;
  }
  this->SetUpEye();
  if (this->Lights.empty())
  {
    why = "no light is on";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectFrame::CollectProps()
{
  vtkBoundingBox box;
  this->Solid = !this->Window->GetPointSmoothing() && !this->Window->GetLineSmoothing() &&
    !this->Window->GetPolygonSmoothing();
  vtkPropCollection* props = this->Renderer->GetViewProps();
  vtkCollectionSimpleIterator it;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    if (!prop->GetVisibility())
    {
      continue;
    }
    // Passes attach themselves to a prop through this; giving it one modifies the prop, so that
    // must not come after its times are read.
    if (!prop->GetPropertyKeys())
    {
      vtkNew<vtkInformation> keys;
      prop->SetPropertyKeys(keys);
    }
    this->Props.push_back(prop);
    if (!prop->HasOpaqueGeometry())
    {
      continue;
    }
    this->Solid = this->Solid && IsSolid(prop);
    this->NumberOfTriangles += CountTriangles(prop);
    this->Specular = this->Specular || IsSpecular(prop);
    // Annotation, which lies in the image's plane, has no bounds.
    this->NumberOfReceivers += prop->GetBounds() != nullptr;
    if (!prop->GetUseBounds())
    {
      continue;
    }
    const double* bounds = prop->GetBounds();
    if (!bounds)
    {
      continue;
    }
    if (!IsFinite(bounds))
    {
      this->LeftOut.emplace_back(prop->GetClassName(), "its bounds are empty or not finite");
      continue;
    }
    if (IsDrawnAsPoints(prop))
    {
      this->LeftOut.emplace_back(prop->GetClassName(),
        "points are sized in pixels, so they neither cast shadows nor reflect light");
      box.AddBounds(bounds);
      continue;
    }
    vtkIndirectCaster caster;
    caster.Prop = prop;
    std::copy(bounds, bounds + 6, caster.Bounds);
    caster.RedrawMTime = prop->GetRedrawMTime();
    this->Casters.push_back(caster);
    box.AddBounds(bounds);
  }
  if (box.IsValid())
  {
    box.GetBounds(this->SceneBounds);
    box.GetCenter(&this->SceneCenter[0]);
    const double diagonal = box.GetDiagonalLength();
    // A scene of one point has no length of its own.
    this->SceneScale = diagonal > 0.0 ? 1.0 / diagonal : 1.0;
  }
}

//------------------------------------------------------------------------------
void vtkIndirectFrame::CollectLights()
{
  vtkLightCollection* lights = this->Renderer->GetLights();
  vtkCollectionSimpleIterator it;
  lights->InitTraversal(it);
  while (vtkLight* light = lights->GetNextLight(it))
  {
    if (!light->GetSwitch())
    {
      continue;
    }
    vtkIndirectLight entry;
    entry.Light = light;
    entry.Index = static_cast<int>(this->Lights.size());
    entry.Positional = light->GetPositional() != 0;
    entry.FollowsCamera = !light->LightTypeIsSceneLight();
    double position[3];
    double focal[3];
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focal);
    entry.PositionWC = glm::dvec3(position[0], position[1], position[2]);
    const glm::dvec3 direction = glm::dvec3(focal[0], focal[1], focal[2]) - entry.PositionWC;
    const double length = glm::length(direction);
    entry.DirectionWC = length > 0.0 ? direction / length : glm::dvec3(0.0, 0.0, -1.0);
    const double* color = light->GetDiffuseColor();
    entry.Color = light->GetIntensity() * glm::dvec3(color[0], color[1], color[2]);
    const double* attenuation = light->GetAttenuationValues();
    entry.Attenuation = glm::dvec3(attenuation[0], attenuation[1], attenuation[2]);
    entry.ConeAngle = light->GetConeAngle();
    entry.Exponent = light->GetExponent();
    this->Lights.push_back(entry);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectFrame::SetUpEye()
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  this->Parallel = camera->GetParallelProjection() != 0;
  this->WorldToView = ToGLM(camera->GetModelViewTransformMatrix());
  this->Projection =
    ToGLM(camera->GetProjectionTransformMatrix(this->Renderer->GetTiledAspectRatio(), -1, 1));
  this->ViewToScene = this->ToScene(glm::inverse(this->WorldToView));

  // Rays from the near to the far plane, at three points of the image: they are affine in between.
  const glm::dmat4 inverse = glm::inverse(this->Projection);
  auto unproject = [&](double x, double y, double z)
  {
    const glm::dvec4 p = inverse * glm::dvec4(x, y, z, 1.0);
    return glm::dvec3(p) * (this->SceneScale / p.w);
  };
  auto ray = [&](double x, double y, glm::dvec3& origin, glm::dvec3& direction)
  {
    const glm::dvec3 nearPoint = unproject(x, y, -1.0);
    const glm::dvec3 farPoint = unproject(x, y, 1.0);
    direction = (farPoint - nearPoint) / (nearPoint.z - farPoint.z);
    origin = nearPoint + direction * nearPoint.z;
  };
  glm::dvec3 origin[3];
  glm::dvec3 direction[3];
  ray(0.0, 0.0, origin[2], direction[2]);
  ray(1.0, 0.0, origin[0], direction[0]);
  ray(0.0, 1.0, origin[1], direction[1]);
  for (int i = 0; i < 3; ++i)
  {
    this->RayOrigin[i] = i < 2 ? origin[i] - origin[2] : origin[2];
    this->RayDirection[i] = i < 2 ? direction[i] - direction[2] : direction[2];
  }
  if (!this->Parallel && this->Projection[2][3] != 0.0)
  {
    // All rays of a perspective meet in the eye; what is left here is rounding.
    this->RayOrigin = glm::dmat3(0.0);
  }
  this->Near = -unproject(0.0, 0.0, -1.0).z;
  this->Far = -unproject(0.0, 0.0, 1.0).z;
}

//------------------------------------------------------------------------------
glm::dmat4 vtkIndirectFrame::ToScene(const glm::dmat4& frameToWorld) const
{
  glm::dmat4 result = frameToWorld;
  result[3] = glm::dvec4((glm::dvec3(frameToWorld[3]) - this->SceneCenter) * this->SceneScale, 1.0);
  return result;
}
