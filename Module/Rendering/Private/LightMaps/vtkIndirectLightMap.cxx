// SPDX-License-Identifier: BSD-3-Clause
#include "LightMaps/vtkIndirectLightMap.h"
#include "Frame/vtkIndirectKey.h"

#include "LightMaps/vtkIndirectFootprint.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace
{
// A face aimed at the scene replaces a light's own faces if it is at most this share as wide: then
// the scene gets twice the texels, or more.
constexpr double AimedShare = 0.5;

// Finds the direction to the sphere around all casters, and returns the tangent of the half angle
// in which a positional light sees it; infinity from within the sphere.
double AimAtCasters(const vtkIndirectFrame& frame, const vtkIndirectLight& light, glm::dvec3& aim)
{
  glm::dvec3 lower(VTK_DOUBLE_MAX);
  glm::dvec3 upper(-VTK_DOUBLE_MAX);
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    lower = glm::min(lower, vtkIndirectFrame::GetCorner(caster.GetFit(), 0));
    upper = glm::max(upper, vtkIndirectFrame::GetCorner(caster.GetFit(), 7));
  }
  const double none = std::numeric_limits<double>::infinity();
  if (!light.Positional || frame.Casters.empty())
  {
    return none;
  }
  const glm::dvec3 toCentre = 0.5 * (lower + upper) - light.PositionWC;
  const double distance = glm::length(toCentre);
  // A margin keeps surfaces that touch the sphere off the map's edge.
  const double radius = 0.505 * glm::length(upper - lower);
  if (!(distance > radius))
  {
    return none;
  }
  aim = toCentre / distance;
  return radius / std::sqrt((distance - radius) * (distance + radius));
}

// Makes a frame whose -z axis is the direction; the smallest component makes the most robust cross
// product.
glm::dmat3 FrameAlong(const glm::dvec3& direction)
{
  const glm::dvec3 a = glm::abs(direction);
  glm::dvec3 helper(0.0, 0.0, 1.0);
  if (a.y <= a.x && a.y <= a.z)
  {
    helper = glm::dvec3(0.0, 1.0, 0.0);
  }
  else if (a.x <= a.y && a.x <= a.z)
  {
    helper = glm::dvec3(1.0, 0.0, 0.0);
  }
  const glm::dvec3 right = glm::normalize(glm::cross(direction, helper));
  return { right, glm::cross(right, direction), -direction };
}
}

vtkIndirectLightMap::vtkIndirectLightMap() = default;
vtkIndirectLightMap::~vtkIndirectLightMap() = default;

//------------------------------------------------------------------------------
glm::dmat3 vtkIndirectLightMap::GetFaceRotation(int face) const
{
  glm::dmat3 rotation;
  for (int i = 0; i < 3; ++i)
  {
    glm::vec3 axis(0.0f);
    axis[i] = 1.0f;
    rotation[i] = glm::dvec3(vtkIndirectKernels::vtkiToFace(axis, face));
  }
  return rotation;
}

//------------------------------------------------------------------------------
void vtkIndirectLightMap::Fit(const vtkIndirectFrame& frame, const vtkIndirectLight& light)
{
  using namespace vtkIndirectKernels;
  this->Light = light;
  this->SceneScale = frame.SceneScale;
  const bool omnidirectional = light.Positional && light.ConeAngle >= 90.0;
  const bool narrow = light.FindMapProjection() == VTKI_MAP_SINGLE;
  const double cone = narrow ? std::tan(light.ConeAngle * vtkMath::Pi() / 180.0) : 1.0;
  glm::dvec3 aim;
  const double tangent = AimAtCasters(frame, light, aim);
  const bool aimed = tangent <= AimedShare * cone;

  // A point light's faces stay along the world's axes, so that they never turn.
  const glm::dmat3 rotation = aimed ? FrameAlong(aim)
    : omnidirectional               ? glm::dmat3(1.0)
                                    : FrameAlong(light.DirectionWC);
  const glm::dvec3 origin = light.Positional ? light.PositionWC : frame.SceneCenter;
  this->LightToWorld = glm::dmat4(rotation);
  this->LightToWorld[3] = glm::dvec4(origin, 1.0);
  this->WorldToLight = glm::dmat4(glm::transpose(rotation));
  this->WorldToLight[3] = glm::dvec4(-(glm::transpose(rotation) * origin), 1.0);

  glm::dvec3 lower(VTK_DOUBLE_MAX);
  glm::dvec3 upper(-VTK_DOUBLE_MAX);
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec3 p = glm::transpose(rotation) *
        (vtkIndirectFrame::GetCorner(caster.GetFit(), i) - origin) * frame.SceneScale;
      lower = glm::min(lower, p);
      upper = glm::max(upper, p);
    }
  }

  if (!light.Positional)
  {
    this->Projection = VTKI_MAP_PARALLEL;
    this->NumberOfFaces = 1;
    // Centres the map on the casters; a margin keeps the outermost off its edge.
    const glm::dvec3 centre = 0.5 * (lower + upper);
    const glm::dvec3 half = 0.5 * (upper - lower);
    constexpr double margin = 1.01;
    this->HalfWidth = margin * std::max({ half.x, half.y, 1e-3 * half.z });
    const double depth = std::max(half.z, 1e-3 * this->HalfWidth);
    this->Near = 0.0;
    this->Far = 2.0 * margin * depth;
    const glm::dvec3 eye =
      origin + rotation * (centre + glm::dvec3(0.0, 0.0, margin * depth)) / frame.SceneScale;
    this->LightToWorld[3] = glm::dvec4(eye, 1.0);
    this->WorldToLight[3] = glm::dvec4(-(glm::transpose(rotation) * eye), 1.0);
  }
  else
  {
    const bool single = narrow || aimed;
    this->Projection = single ? VTKI_MAP_SINGLE : VTKI_MAP_FACES;
    // A spot of less than 90 degrees has no face that looks backward.
    this->NumberOfFaces = single ? 1 : (omnidirectional ? 6 : 5);
    this->HalfWidth = aimed ? tangent : cone;
    const glm::dvec3 outside = glm::max(glm::max(lower, -upper), glm::dvec3(0.0));
    if (single)
    {
      this->Far = -lower.z;
      this->Near = -upper.z;
    }
    else
    {
      this->Far = std::max({ -lower.x, -lower.y, -lower.z, upper.x, upper.y, upper.z });
      // The nearest depth at which any face may find a caster along its own axis.
      this->Near = std::max({ outside.x, outside.y, outside.z });
    }
    // If all casters lie behind a spot its map is empty, and any range will do.
    this->Far = this->Far > 0.0 ? 1.001 * this->Far : 1.0;
    this->Near =
      std::min(std::max(0.999 * this->Near, NearestFraction * this->Far), 0.5 * this->Far);
  }

  for (int face = 0; face < this->NumberOfFaces; ++face)
  {
    const glm::dmat3 toFace = this->GetFaceRotation(face);
    this->FaceToScene[face] =
      frame.ToScene(this->LightToWorld * glm::dmat4(glm::transpose(toFace)));
    this->FaceAxis[face] = toFace * (glm::transpose(rotation) * light.DirectionWC);
  }
}

//------------------------------------------------------------------------------
vtkOpenGLCamera* vtkIndirectLightMap::GetCamera(int face, bool eyeIsParallel)
{
  if (!this->Cameras[face])
  {
    this->Cameras[face] = vtkSmartPointer<vtkOpenGLCamera>::New();
  }
  vtkOpenGLCamera* camera = this->Cameras[face];
  const glm::dmat3 faceToWorld =
    glm::dmat3(this->LightToWorld) * glm::transpose(this->GetFaceRotation(face));
  const glm::dvec3 position(this->LightToWorld[3]);
  // VTK stores the direction as a difference of points: far from the origin it needs a long one.
  const glm::dvec3 focal = position - faceToWorld[2] * (this->Far / this->SceneScale);
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(focal.x, focal.y, focal.z);
  camera->SetViewUp(faceToWorld[1].x, faceToWorld[1].y, faceToWorld[1].z);
  // Mappers put this flag into the key of their shader source: a map that changed it would rebuild
  // every actor's source twice a frame. The projection itself is set below.
  camera->SetParallelProjection(eyeIsParallel ? 1 : 0);

  const double n = this->Near / this->SceneScale;
  const double f = this->Far / this->SceneScale;
  const bool parallel = this->Projection == vtkIndirectKernels::VTKI_MAP_PARALLEL;
  const double halfWidth = parallel ? this->HalfWidth / this->SceneScale : this->HalfWidth;
  camera->SetClippingRange(std::max(n, 1e-6 * f), f);
  SetProjection(camera, MakeProjection(parallel, glm::dvec2(halfWidth), n, f));
  camera->Modified();
  return camera;
}

//------------------------------------------------------------------------------
glm::dmat4 vtkIndirectLightMap::MakeProjection(bool parallel, const glm::dvec2& halfWidth,
  double nearPlane, double farPlane, const glm::dvec2& middle)
{
  const double depth = farPlane - nearPlane;
  glm::dmat4 projection(0.0);
  projection[0][0] = 1.0 / halfWidth.x;
  projection[1][1] = 1.0 / halfWidth.y;
  projection[2][0] = parallel ? 0.0 : middle.x / halfWidth.x;
  projection[2][1] = parallel ? 0.0 : middle.y / halfWidth.y;
  projection[2][2] = -(parallel ? 2.0 : farPlane + nearPlane) / depth;
  projection[3][2] = -(parallel ? farPlane + nearPlane : 2.0 * farPlane * nearPlane) / depth;
  projection[2][3] = parallel ? 0.0 : -1.0;
  projection[3][3] = parallel ? 1.0 : 0.0;
  return projection;
}

//------------------------------------------------------------------------------
void vtkIndirectLightMap::SetProjection(vtkOpenGLCamera* camera, const glm::dmat4& projection)
{
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      matrix->SetElement(row, column, projection[column][row]);
    }
  }
  camera->SetExplicitProjectionTransformMatrix(matrix);
  camera->UseExplicitProjectionTransformMatrixOn();
}

//------------------------------------------------------------------------------
bool vtkIndirectLightMap::CanHold(int face, const double bounds[6], int texels) const
{
  const glm::dmat3 toFace = this->GetFaceRotation(face) * glm::dmat3(this->WorldToLight);
  const glm::dvec3 origin(this->LightToWorld[3]);
  vtkIndirectFootprint footprint;
  for (int i = 0; i < 8; ++i)
  {
    const glm::dvec3 p =
      toFace * (vtkIndirectFrame::GetCorner(bounds, i) - origin) * this->SceneScale;
    const double w =
      this->HalfWidth * (this->Projection == vtkIndirectKernels::VTKI_MAP_PARALLEL ? 1.0 : -p.z);
    footprint.Add(glm::dvec2(p), glm::dvec2(w), p.z > 0.0);
  }
  return footprint.IsHeld(glm::dvec2(texels));
}

//------------------------------------------------------------------------------
double vtkIndirectLightMap::FindTexelAt(const glm::dvec3& place, int texels) const
{
  const double width = 2.0 * this->HalfWidth / texels;
  return this->Projection == vtkIndirectKernels::VTKI_MAP_PARALLEL
    ? width / this->SceneScale
    : width * glm::distance(place, glm::dvec3(this->LightToWorld[3]));
}

//------------------------------------------------------------------------------
vtkIndirectMapView vtkIndirectLightMap::GetView(int texels) const
{
  return { this->Light.Positional, this->Projection == vtkIndirectKernels::VTKI_MAP_PARALLEL,
    this->Near, this->Far, this->HalfWidth, 2.0 * this->HalfWidth / texels };
}

//------------------------------------------------------------------------------
vtkIndirectShadowMap vtkIndirectLightMap::GetShadowMap() const
{
  return { this->Light.Index, this->WorldToLight, this->FirstLayer, this->NumberOfFaces,
    this->Projection, this->HalfWidth, this->Near, this->Far, this->Light.ShadowAttenuation };
}

//------------------------------------------------------------------------------
void vtkIndirectLightMap::AppendTo(vtkIndirectKey& key) const
{
  key.Add("projection", this->Projection).Add("layer", this->FirstLayer);
  key.Add("projection", this->HalfWidth).Add("projection", this->Near);
  key.Add("projection", this->Far).Add("scene units", this->SceneScale);
  key.Add("placement", this->LightToWorld);
}
