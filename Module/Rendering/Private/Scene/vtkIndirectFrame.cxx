// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectFrame.h"
#include "OpenGL/vtkIndirectKey.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Scene/vtkIndirectCasterBounds.h"
#include "Scene/vtkIndirectFillValues.h"
#include "Scene/vtkIndirectImpostors.h"
#include "Scene/vtkIndirectInformationKeys.h"
#include "Scene/vtkIndirectPropKind.h"
#include "Scene/vtkIndirectRevision.h"
#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkInformation.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPropCollection.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>

namespace
{
// Number of props that an entry of the report lists by name; a scene may have thousands.
constexpr size_t MostNamed = 3;

bool IsFinite(const double bounds[6])
{
  return std::all_of(bounds, bounds + 6, [](double bound) { return std::isfinite(bound); }) &&
    vtkMath::AreBoundsInitialized(bounds) != 0;
}
}

//------------------------------------------------------------------------------
int vtkIndirectLight::FindMapProjection() const
{
  using namespace vtkIndirectKernels;
  return !this->Positional                      ? VTKI_MAP_PARALLEL
    : this->ConeAngle <= MaximumSingleFaceAngle ? VTKI_MAP_SINGLE
                                                : VTKI_MAP_FACES;
}

//------------------------------------------------------------------------------
double vtkIndirectLight::FindFalloff(const glm::dvec3& direction, double distance) const
{
  const glm::dvec3& a = this->Attenuation;
  const double divisor = a.x + distance * (a.y + distance * a.z);
  double falloff = divisor > 0.0 ? 1.0 / divisor : 0.0;
  if (this->ConeAngle < 90.0)
  {
    const double cosine = glm::dot(direction, this->DirectionWC);
    // VTK's shader gives a spot a hard rim, and powers of the cosine within.
    falloff *= cosine < std::cos(vtkMath::RadiansFromDegrees(this->ConeAngle))
      ? 0.0
      : std::pow(std::max(cosine, 0.0), this->Exponent);
  }
  return falloff;
}

//------------------------------------------------------------------------------
glm::dmat4 vtkIndirectFrame::ToGLM(vtkMatrix4x4* matrix)
{
  return glm::transpose(glm::make_mat4(matrix->GetData()));
}

//------------------------------------------------------------------------------
double vtkIndirectFrame::FindDiagonal(const vtkBoundingBox& box)
{
  return box.IsValid() ? box.GetDiagonalLength() : 0.0;
}

//------------------------------------------------------------------------------
void vtkIndirectFrame::Build(
  const vtkRenderState* state, vtkIndirectCasterBounds* casterBounds, bool interactive)
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
  this->CollectProps(casterBounds, interactive);
  if (this->Size[0] > 0 && this->Size[1] > 0 &&
    (!this->Casters.empty() || this->NumberOfOtherReceivers > 0))
  {
    this->SetUpEye();
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectFrame::IsFurtherPart() const
{
  const double* tile = this->Window->GetTileViewport();
  const bool rightEye =
    this->Window->GetStereoRender() && !this->Renderer->GetActiveCamera()->GetLeftEye();
  return rightEye || tile[0] > 0.0 || tile[1] > 0.0;
}

//------------------------------------------------------------------------------
bool vtkIndirectFrame::IsWhole() const
{
  const double* tile = this->Window->GetTileViewport();
  return tile[0] <= 0.0 && tile[1] <= 0.0 && tile[2] >= 1.0 && tile[3] >= 1.0;
}

//------------------------------------------------------------------------------
void vtkIndirectFrame::LeaveOut(vtkProp* prop, const std::string& why)
{
  const std::string what = prop->GetClassName();
  auto entry = std::find_if(this->LeftOut.begin(), this->LeftOut.end(),
    [&](const LeftOutEntry& known) { return known.What == what && known.Why == why; });
  if (entry == this->LeftOut.end())
  {
    entry = this->LeftOut.insert(entry, { what, why, 0, {} });
  }
  ++entry->Count;
  std::vector<std::string>& named = entry->Which;
  if (named.size() > MostNamed)
  {
    return;
  }
  const std::string which = vtkIndirectPropKind::Describe(prop);
  if (!which.empty() && std::find(named.begin(), named.end(), which) == named.end())
  {
    named.push_back(which);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectFrame::CollectProps(vtkIndirectCasterBounds* casterBounds, bool interactive)
{
  vtkBoundingBox box;
  this->CoversFully = !this->Window->GetPointSmoothing() && !this->Window->GetLineSmoothing() &&
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
    // Passes attach themselves to a prop through its property keys. Setting the keys modifies the
    // prop, so they are set before the prop's times are read.
    if (!prop->GetPropertyKeys())
    {
      vtkNew<vtkInformation> keys;
      prop->SetPropertyKeys(keys);
    }
    this->Props.push_back(prop);
    // Volumes and flat props draw nothing opaque, though both report that they may.
    if (prop->IsA("vtkVolume"))
    {
      this->LeaveOut(prop, "volumes neither send nor receive indirect light");
      continue;
    }
    if (vtkIndirectPropKind::IsFlat(prop))
    {
      continue;
    }
    if (prop->HasTranslucentPolygonalGeometry())
    {
      vtkActor* refractor = vtkIndirectPropKind::FindRefractor(prop);
      if (refractor)
      {
        this->Refractors.push_back(refractor);
      }
      this->LeaveOut(prop,
        refractor
          ? "glass casts no shadows and receives no indirect light"
          : "translucent geometry casts no shadows, and neither sends nor receives indirect light");
    }
    if (!prop->HasOpaqueGeometry())
    {
      continue;
    }
    this->AddOpaque(prop, box);
  }
  if (casterBounds)
  {
    casterBounds->Give(this->Casters, interactive);
  }
  for (const vtkIndirectCaster& caster : this->Casters)
  {
    box.AddBounds(caster.GetFit());
  }
  if (box.IsValid())
  {
    box.GetBounds(this->SceneBounds);
    box.GetCenter(&this->SceneCenter[0]);
    const double diagonal = FindDiagonal(box);
    // A scene of one point has no length to scale by.
    this->SceneScale = diagonal > 0.0 ? 1.0 / diagonal : 1.0;
  }
}

//------------------------------------------------------------------------------
void vtkIndirectFrame::AddOpaque(vtkProp* prop, vtkBoundingBox& box)
{
  const vtkIndirectPropKind kind = vtkIndirectPropKind::Find(prop);
  this->CoversFully = this->CoversFully && kind.CoversFully;
  if (vtkIndirectPropKind::CatchesLight(prop) && this->AddCatcher(prop, kind))
  {
    return;
  }
  this->NumberOfTriangles += kind.NumberOfTriangles;
  this->Specular = this->Specular || (kind.Captured && kind.Specular);
  this->PhysicallyBased = this->PhysicallyBased || (kind.Captured && kind.PhysicallyBased);
  (kind.Captured ? this->Captured : this->ColorOnly).push_back(prop);
  if (kind.HasBackface)
  {
    this->WithBackface.push_back(prop);
  }
  if (!prop->GetUseBounds())
  {
    this->NumberOfOtherReceivers += kind.Captured && kind.Lit ? 1 : 0;
    return;
  }
  const double* bounds = prop->GetBounds();
  double most[6];
  double wide[6];
  if (kind.Captured && bounds && !vtkIndirectFillValues::IsWithin(bounds))
  {
    using vtkIndirectFillValues::Points;
    const Points beyond = vtkIndirectFillValues::FindBounds(prop, most);
    if (beyond == Points::ALL && IsFinite(bounds))
    {
      this->LeaveOut(prop, "all of its points lie beyond 1e19");
      return;
    }
    if (beyond == Points::SOME)
    {
      bounds = most;
      this->LeaveOut(prop, "some of its points lie beyond 1e19: faces at these");
    }
  }
  if (kind.Captured && !(bounds && IsFinite(bounds)))
  {
    this->LeaveOut(prop, "its bounds are empty or not finite");
    return;
  }
  const double reach = kind.Captured ? vtkIndirectImpostors::FindReach(prop) : 0.0;
  for (int i = 0; reach > 0.0 && i < 6; ++i)
  {
    wide[i] = bounds[i] + (i % 2 == 0 ? -reach : reach);
  }
  bounds = reach > 0.0 ? wide : bounds;
  const bool casts = vtkIndirectInformationKeys::IsSet(
    prop, vtkIndirectInformationKeys::CastsShadows(), kind.NoCaster == nullptr);
  if (casts && kind.Captured && kind.Surface)
  {
    vtkIndirectCaster caster;
    caster.Prop = prop;
    std::copy(bounds, bounds + 6, caster.Bounds);
    caster.Revision = vtkIndirectRevision::Find(prop);
    caster.SendsLight =
      vtkIndirectInformationKeys::IsSet(prop, vtkIndirectInformationKeys::SendsLight(), true);
    caster.Triangles = kind.DepthTriangles;
    this->AllSendLight = this->AllSendLight && caster.SendsLight;
    this->CastersArePhysicallyBased = this->CastersArePhysicallyBased && kind.PhysicallyBased;
    this->SendersAreSpecular =
      this->SendersAreSpecular || (caster.SendsLight && (kind.Specular || kind.PhysicallyBased));
    this->Casters.push_back(caster);
    return;
  }
  this->LeaveOut(prop,
    kind.NoCaster ? kind.NoCaster
                  : "its property key CASTS_SHADOWS is 0: it sends no light either");
  this->AllSendLight = this->AllSendLight && kind.NoCaster != nullptr;
  if (kind.Captured && kind.Lit)
  {
    ++this->NumberOfOtherReceivers;
    box.AddBounds(bounds);
  }
}

//------------------------------------------------------------------------------
// Adds a prop that catches light. Returns true if the prop is nothing else.
bool vtkIndirectFrame::AddCatcher(vtkProp* prop, const vtkIndirectPropKind& kind)
{
  if (!kind.Captured || !kind.Surface || !kind.Lit)
  {
    this->LeaveOut(prop, "its property key CATCHES_LIGHT has no effect: it has no lit faces");
    return false;
  }
  this->Catchers.push_back(prop);
  if (vtkIndirectInformationKeys::IsSet(prop, vtkIndirectInformationKeys::CastsShadows(), false))
  {
    return false;
  }
  this->Captured.push_back(prop);
  this->NumberOfTriangles += kind.NumberOfTriangles;
  if (kind.HasBackface)
  {
    this->WithBackface.push_back(prop);
  }
  this->AllSendLight = false; // the picture shows it, and no light's map does
  ++this->NumberOfOtherReceivers;
  return true;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectFrame::RoundDirection(const glm::dvec3& direction)
{
  constexpr double steps = 1 << 26; // finer than a float
  return glm::normalize(glm::round(direction * steps));
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
    entry.Headlight = light->LightTypeIsHeadlight() != 0;
    entry.ShadowAttenuation = light->GetShadowAttenuation();
    double position[3];
    double focal[3];
    light->GetTransformedPosition(position);
    light->GetTransformedFocalPoint(focal);
    const glm::dvec3 place(position[0], position[1], position[2]);
    const glm::dvec3 direction = glm::dvec3(focal[0], focal[1], focal[2]) - place;
    const double length = glm::length(direction);
    entry.DirectionWC = length > 0.0 ? direction / length : glm::dvec3(0.0, 0.0, -1.0);
    if (entry.Positional)
    {
      entry.PositionWC = place;
    }
    else if (entry.FollowsCamera)
    {
      entry.DirectionWC = RoundDirection(entry.DirectionWC);
    }
    const double* color = light->GetDiffuseColor();
    entry.Color = light->GetIntensity() * glm::dvec3(color[0], color[1], color[2]);
    const double* attenuation = light->GetAttenuationValues();
    entry.Attenuation = glm::dvec3(attenuation[0], attenuation[1], attenuation[2]);
    entry.ConeAngle = light->GetConeAngle();
    entry.Exponent = light->GetExponent();
    entry.Size = entry.Positional
      ? vtkIndirectInformationKeys::Get(light, vtkIndirectInformationKeys::LightRadius())
      : vtkMath::RadiansFromDegrees(
          vtkIndirectInformationKeys::Get(light, vtkIndirectInformationKeys::LightAngle()));
    const double fill =
      vtkIndirectInformationKeys::Get(light, vtkIndirectInformationKeys::LightFill());
    entry.Fill = fill >= 1.0;
    // Surfaces reflect only the share of a light that casts shadows.
    entry.Color *= entry.Fill ? 1.0 : 1.0 - fill;
    const glm::dvec3 sums = place + entry.Attenuation + entry.Color;
    if (!std::isfinite(length + glm::dot(sums, glm::dvec3(1.0)) + entry.ConeAngle + entry.Exponent))
    {
      const int index = entry.Index;
      entry = vtkIndirectLight();
      entry.Light = light;
      entry.Index = index;
      entry.Finite = false;
    }
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

  // Finds rays from the near to the far plane at three points of the image: rays are affine in
  // between.
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
  this->RaysMeet = glm::dvec3(0.0);
  if (!this->Parallel && this->Projection[2][3] != 0.0)
  {
    // All rays of a perspective meet where both coordinates of the image and the divisor are zero:
    // at the origin, or in stereo beside it. Rays made from this point have no rounding errors.
    const glm::dmat4 rows = glm::transpose(this->Projection);
    const glm::dmat3 meeting =
      glm::transpose(glm::dmat3{ glm::dvec3(rows[0]), glm::dvec3(rows[1]), glm::dvec3(rows[3]) });
    const glm::dvec3 eye =
      this->SceneScale * (glm::inverse(meeting) * -glm::dvec3{ rows[0].w, rows[1].w, rows[3].w });
    this->RaysMeet = eye;
    this->RayOrigin = eye.z * this->RayDirection;
    this->RayOrigin[2] += eye;
  }
  this->Near = -unproject(0.0, 0.0, -1.0).z;
  this->Far = -unproject(0.0, 0.0, 1.0).z;
}

//------------------------------------------------------------------------------
glm::mat4 vtkIndirectFrame::FindSceneToClip() const
{
  const glm::dmat4 toView = glm::scale(glm::dmat4(1.0), glm::dvec3(1.0 / this->SceneScale)) *
    glm::inverse(this->ViewToScene);
  return glm::mat4((this->Parallel ? 1.0 : this->SceneScale) * (this->Projection * toView));
}

//------------------------------------------------------------------------------
glm::dmat4 vtkIndirectFrame::ToScene(const glm::dmat4& frameToWorld) const
{
  glm::dmat4 result = frameToWorld;
  result[3] = glm::dvec4(this->ToScene(glm::dvec3(frameToWorld[3])), 1.0);
  return result;
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> vtkIndirectFrame::FindCorners(
  const glm::dmat3& axes, const glm::dvec3& place) const
{
  std::vector<glm::dvec3> corners;
  corners.reserve(8 * this->Casters.size());
  for (const vtkIndirectCaster& caster : this->Casters)
  {
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec3 corner = this->ToScene(GetCorner(caster.GetFit(), i));
      corners.push_back(glm::transpose(axes) * (corner - place));
    }
  }
  return corners;
}

//------------------------------------------------------------------------------
void vtkIndirectFrame::AppendTo(vtkIndirectKey& key) const
{
  key.Add("eye", this->WorldToView);
  key.Add("eye", this->Projection);
  key.Add("bounds of the scene", this->SceneBounds, 6);
  for (const vtkIndirectLight& light : this->Lights)
  {
    light.AppendTo(key);
  }
  // Casters are a part of the props, in the same order, and already have revisions.
  auto caster = this->Casters.begin();
  for (vtkProp* prop : this->Props)
  {
    const bool casts = caster != this->Casters.end() && caster->Prop == prop;
    key.AddAddress("props", prop);
    key.Add("props", casts ? caster->Revision : vtkIndirectRevision::Find(prop));
    caster += casts ? 1 : 0;
  }
}

//------------------------------------------------------------------------------
void vtkIndirectFrame::AppendUnitsTo(vtkIndirectKey& key) const
{
  key.Add("scene units", this->SceneScale).Add("scene units", this->SceneCenter);
}

//------------------------------------------------------------------------------
double vtkIndirectFrame::CountDepthTriangles() const
{
  double triangles = 0.0;
  for (const vtkIndirectCaster& caster : this->Casters)
  {
    triangles += caster.Triangles;
  }
  return triangles;
}

//------------------------------------------------------------------------------
void vtkIndirectFrame::AppendFitsTo(vtkIndirectKey& key) const
{
  this->AppendUnitsTo(key);
  for (const vtkIndirectCaster& caster : this->Casters)
  {
    key.Add("caster bounds", caster.GetFit(), 6);
  }
  this->Seen.Box.AppendTo(key);
}

//------------------------------------------------------------------------------
void vtkIndirectCaster::AppendTo(vtkIndirectKey& key) const
{
  key.AddAddress("casters", this->Prop);
  key.Add("casters", this->Revision).Add("casters", this->SendsLight);
}

//------------------------------------------------------------------------------
void vtkIndirectLight::AppendTo(vtkIndirectKey& key) const
{
  constexpr const char* name = "lights";
  key.Add(name, this->Positional).Add(name, this->PositionWC).Add(name, this->DirectionWC);
  key.Add(name, this->Color).Add(name, this->Attenuation).Add(name, this->ConeAngle);
  key.Add(name, this->Exponent).Add(name, this->Fill);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::string>> vtkIndirectFrame::DescribeLeftOut() const
{
  std::vector<std::pair<std::string, std::string>> entries;
  for (const LeftOutEntry& entry : this->LeftOut)
  {
    std::string what = entry.What;
    what += entry.Count > 1 ? ", " + std::to_string(entry.Count) + " props" : "";
    for (size_t i = 0; i < entry.Which.size(); ++i)
    {
      what += (i == 0 ? " (" : "; ") + (i < MostNamed ? entry.Which[i] : "and others");
    }
    what += entry.Which.empty() ? "" : ")";
    entries.emplace_back(what, entry.Why);
  }
  return entries;
}
