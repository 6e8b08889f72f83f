// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Capture/vtkSurfaceCapturePass.h"

#include "Capture/vtkIndirectCaptureLights.h"
#include "Capture/vtkIndirectCaptureText.h"
#include "Capture/vtkIndirectDepthTile.h"
#include "Capture/vtkIndirectGeometryChannels.h"
#include "Capture/vtkIndirectLightConstants.h"
#include "Capture/vtkIndirectPixelRays.h"
#include "Capture/vtkIndirectShadowMaps.h"
#include "Capture/vtkIndirectTexelTriangles.h"
#include "Capture/vtkIndirectUnclipped.h"
#include "Capture/vtkIndirectWithin.h"
#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectPropKind.h"
#include "Scene/vtkIndirectRendererAccess.h"
#include "vtkAbstractMapper.h"
#include "vtkActor.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLHelper.h"
#include "vtkOpenGLPolyDataMapper.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkPointGaussianMapper.h"
#include "vtkProp.h"
#include "vtkProperty.h"
#include "vtkRenderState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureUnitManager.h"
#include "vtkWeakPointer.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <unordered_map>
#include <vector>

vtkStandardNewMacro(vtkSurfaceCapturePass);
vtkCxxSetObjectMacro(vtkSurfaceCapturePass, DelegatePass, vtkRenderPass);

//------------------------------------------------------------------------------
struct vtkSurfaceCapturePass::Internals
{
  std::vector<vtkWeakPointer<vtkProp>> Attached;

  enum StageType
  {
    Eye,
    Map,
    Depth
  };

  // Uniforms of the current stage.
  int Stage = Eye;
  int Channels = 0; // number of the geometry buffer's channels
  float SceneScale = 1.0f;
  float Magnitude = 0.0f;
  float DepthRange[3] = { 0.0f, 1.0f, 0.0f };
  int StageIsParallel = 0;
  vtkIndirectPixelRays PixelRays;
  bool Encoded = false; // the stage has drawn encoded colours
  vtkIndirectCaptureLights Lights;
  int ShadowUnit = -1;
  bool OwnsUnit = false;
  int TileUnit = -1;
  bool OwnsTileUnit = false;

  // Number of each prop, in the order in which the eye's stage has drawn them: antialiasing tells
  // surfaces without a normal apart by these numbers.
  std::unordered_map<vtkProp*, int> Numbers;

  // Each prop has two numbers: lines and points drawn onto its faces count as separate shapes.
  int FindNumber(vtkProp* prop, bool triangles, bool catches)
  {
    const int next = static_cast<int>(this->Numbers.size());
    const int number = 2 * this->Numbers.emplace(prop, next).first->second + (triangles ? 1 : 0);
    return catches ? -1 - number : number;
  }

  vtkIndirectUnclipped Unclipped;

  // Framebuffer of the geometry buffer.
  vtkOpenGLFramebufferObject* Framebuffer = nullptr;
  bool Redirected = false;
  std::unique_ptr<vtkOpenGLState::ScopedglBlendFuncSeparate> Blending; // while only colour is drawn

  // Draws a shader's outputs to `count` channels from `first` on, and to no others. VTK's state
  // caches draw buffers by their place in the list and misses a shorter list: the list always has
  // all channels.
  void UseChannels(int first, int count)
  {
    unsigned int buffers[vtkIndirectGeometryChannels::Specular + 1];
    for (int i = 0; i < this->Channels; ++i)
    {
      buffers[i] =
        i < count ? GL_COLOR_ATTACHMENT0 + static_cast<unsigned int>(first + i) : GL_NONE;
    }
    this->Window->GetState()->vtkglDrawBuffers(static_cast<unsigned int>(this->Channels), buffers);
  }

  // Selects the writes of the map stage's next draw.
  void UseMap(bool colors, bool depth)
  {
    vtkOpenGLState* state = this->Window->GetState();
    const GLboolean mask = colors ? GL_TRUE : GL_FALSE;
    state->vtkglColorMask(mask, mask, mask, mask);
    state->vtkglDepthMask(depth ? GL_TRUE : GL_FALSE);
  }
  glm::vec3 MapLight{ 0.0f };
  float LightOfPBR = 1.0f;
  vtkIndirectTexelTriangles Triangles;
  vtkIndirectLightConstants LightConstants;
  vtkOpenGLRenderWindow* Window = nullptr;

  // Reserves a texture unit for shaders' shadow samplers in a stage without shadow maps: samplers
  // of different types cannot share a unit.
  void ReserveUnit()
  {
    this->ShadowUnit = this->Window->GetState()->GetTextureUnitManager()->Allocate();
    this->OwnsUnit = true;
    this->ReserveTileUnit();
  }
  // Reserves a unit for the depths of penumbrae in the same way, if shaders have that sampler.
  void ReserveTileUnit()
  {
    if (this->LightConstants.HasPenumbrae())
    {
      this->TileUnit = this->Window->GetState()->GetTextureUnitManager()->Allocate();
      this->OwnsTileUnit = true;
    }
  }

  // True if uniforms come as flat varyings, which pays if triangles cover enough pixels.
  bool FlatUniforms = false;

  // Updates FlatUniforms and returns true if it has changed, which rebuilds all shaders: with
  // hysteresis, to make this rare.
  bool UpdateFlatUniforms(const vtkIndirectFrame& frame)
  {
    const double pixels = static_cast<double>(frame.Size[0]) * frame.Size[1];
    const bool flat = vtkIndirectBackEndChoices::Get(vtkIndirectBackEndChoices::Uniforms) ==
        vtkIndirectBackEndChoices::UniformsFlat &&
      pixels > (this->FlatUniforms ? 2.0 : 4.0) * frame.NumberOfTriangles;
    const bool changed = flat != this->FlatUniforms;
    this->FlatUniforms = flat;
    return changed;
  }

  std::vector<vtkProp*> WithBackface; // props to be compared only

  // Returns true if other props have a backface property than in the last frame: VTK does not build
  // the shaders of a prop anew when it gets one.
  bool UpdateBackfaces(const vtkIndirectFrame& frame)
  {
    const bool changed = frame.WithBackface != this->WithBackface;
    this->WithBackface = frame.WithBackface;
    return changed;
  }

  // The camera for which a program's lighting uniforms were last set.
  std::unordered_map<vtkShaderProgram*, vtkCamera*> ProgramCameras;
  vtkLightCollection* LightsInUse = nullptr; // to be compared only
  vtkCamera* Camera = nullptr;
  vtkNew<vtkOpenGLCamera> MapCamera;
  vtkRenderer* Renderer = nullptr;
  glm::dvec3 SceneCenter{ 0.0 };
};

namespace
{
// Tells which of its primitives a mapper is about to draw.
class MapperPrimitive : public vtkOpenGLPolyDataMapper
{
public:
  static bool IsTriangles(vtkAbstractMapper* mapper, vtkProp* prop)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    auto* polygons = vtkOpenGLPolyDataMapper::SafeDownCast(mapper);
    const vtkOpenGLHelper* drawn = polygons ? polygons->*(&MapperPrimitive::LastBoundBO) : nullptr;
    // VTK up to 9.3 draws splats as triangles.
    return (!actor || actor->GetProperty()->GetRepresentation() == VTK_SURFACE) && drawn &&
      !mapper->IsA("vtkOpenGLPointGaussianMapperHelper") &&
      (drawn->PrimitiveType == PrimitiveTris || drawn->PrimitiveType == PrimitiveTriStrips);
  }
};

vtkPointGaussianMapper* FindSplats(vtkProp* prop)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  return actor ? vtkPointGaussianMapper::SafeDownCast(actor->GetMapper()) : nullptr;
}
}

//------------------------------------------------------------------------------
vtkSurfaceCapturePass::vtkSurfaceCapturePass()
  : Internal(new Internals)
{
}

//------------------------------------------------------------------------------
vtkSurfaceCapturePass::~vtkSurfaceCapturePass()
{
  this->Detach();
  this->SetDelegatePass(nullptr);
}

//------------------------------------------------------------------------------
void vtkSurfaceCapturePass::SetOutputs(const Outputs& outputs)
{
  if (outputs != this->Written)
  {
    this->Written = outputs;
    this->SourceTime.Modified();
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceCapturePass::Attach(const vtkIndirectFrame& frame)
{
  this->Detach();
  bool changed = this->Internal->LightConstants.Update(frame, this->Written.Shadows);
  changed = this->Internal->UpdateFlatUniforms(frame) || changed;
  changed = this->Internal->UpdateBackfaces(frame) || changed;
  if (changed)
  {
    this->SourceTime.Modified();
  }
  // Programs may hold uniforms of lights newer than these.
  if (this->Internal->LightsInUse != frame.Renderer->GetLights())
  {
    this->Internal->LightsInUse = frame.Renderer->GetLights();
    this->Internal->ProgramCameras.clear();
  }
  auto* key = vtkOpenGLRenderPass::RenderPasses();
  for (vtkProp* prop : frame.Captured)
  {
    vtkInformation* info = prop->GetPropertyKeys();
    // Assemblies share their information with their parts: a second entry would inject twice.
    bool attached = false;
    for (int i = 0; info->Has(key) && i < info->Length(key); ++i)
    {
      attached = attached || info->Get(key, i) == this;
    }
    if (!attached)
    {
      info->Append(key, this);
    }
    this->Internal->Attached.emplace_back(prop);
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceCapturePass::Detach()
{
  auto* key = vtkOpenGLRenderPass::RenderPasses();
  for (const auto& prop : this->Internal->Attached)
  {
    vtkInformation* info = prop ? prop->GetPropertyKeys() : nullptr;
    if (info && info->Has(key))
    {
      info->Remove(key, this);
      if (info->Length(key) == 0)
      {
        info->Remove(key);
      }
    }
  }
  this->Internal->Attached.clear();
  this->Internal->Triangles.Clear();
}

//------------------------------------------------------------------------------
void vtkSurfaceCapturePass::BeginEye(const vtkIndirectFrame& frame,
  const vtkIndirectShadowMaps* shadows, vtkOpenGLFramebufferObject* framebuffer, int channels)
{
  Internals& in = *this->Internal;
  in.Stage = Internals::Eye;
  in.Channels = channels;
  in.Framebuffer = framebuffer;
  in.Redirected = false;
  in.Numbers.clear();
  in.Window = frame.Window;
  // In a scene of opaque surfaces no prop writes only colour.
  in.UseChannels(vtkIndirectGeometryChannels::Lit,
    vtkIndirectGeometryChannels::IsAlbedoInLit(channels) ? channels : 1);
  in.Encoded = false;
  in.SceneScale = static_cast<float>(frame.SceneScale);
  in.StageIsParallel = frame.Parallel ? 1 : 0;
  in.DepthRange[0] = static_cast<float>(frame.Near);
  in.DepthRange[1] = static_cast<float>(frame.Far);
  in.DepthRange[2] = frame.Parallel ? 1.0f : 0.0f;
  in.PixelRays = vtkIndirectPixelRays::Make(frame);
  in.Camera = frame.Renderer->GetActiveCamera();
  in.Renderer = frame.Renderer;
  in.SceneCenter = frame.SceneCenter;
  // Vertices are floats in the data's own coordinates up to this distance from the origin, from
  // which VTK's mappers shift them.
  constexpr double shiftedFrom = 1e3;
  const double fromOrigin = glm::length(frame.SceneCenter) * frame.SceneScale;
  const double fromEye = glm::length(glm::dvec3(frame.ViewToScene[3]));
  in.Magnitude = static_cast<float>(1.0 + fromEye + (fromOrigin < shiftedFrom ? fromOrigin : 0.0));

  in.Lights.Update(frame, shadows);
  if (!shadows)
  {
    in.ReserveUnit();
    return;
  }
  in.ShadowUnit = shadows->Unit;
  in.TileUnit = shadows->TileUnit;
  if (in.TileUnit < 0)
  {
    in.ReserveTileUnit();
  }
}

//------------------------------------------------------------------------------
void vtkSurfaceCapturePass::BeginDepth()
{
  this->Internal->Stage = Internals::Depth;
  this->Internal->ReserveUnit();
}

//------------------------------------------------------------------------------
void vtkSurfaceCapturePass::DrawMap(const vtkIndirectFrame& frame, const vtkIndirectDepthTile& view,
  int texels, const std::vector<const vtkIndirectCaster*>& casters, bool ofVTKLight)
{
  Internals& in = *this->Internal;
  view.SetUp(in.MapCamera, frame);
  vtkCamera*& active = vtkIndirectRendererAccess::Camera(frame.Renderer);
  vtkCamera* const eye = active;
  active = in.MapCamera;
  in.Stage = Internals::Map;
  in.SceneScale = static_cast<float>(frame.SceneScale);
  in.StageIsParallel = view.Parallel ? 1 : 0;
  in.DepthRange[0] = static_cast<float>(view.Near);
  in.DepthRange[1] = static_cast<float>(view.Far);
  in.DepthRange[2] = static_cast<float>(in.StageIsParallel);
  const glm::dvec2 texel = 2.0 * view.HalfWidth / static_cast<double>(texels);
  in.PixelRays = { glm::vec4(glm::dvec4(texel, view.Middle - view.HalfWidth)), glm::vec3(0.0f) };
  in.Camera = in.MapCamera;
  in.Renderer = frame.Renderer;
  in.SceneCenter = frame.SceneCenter;
  in.MapLight = glm::vec3(view.Parallel ? 0.0 : 1.0, texel.x, 1.0);
  in.LightOfPBR = ofVTKLight ? 1.0f : glm::pi<float>();
  in.Window = frame.Window;
  in.ReserveUnit();
  for (const vtkIndirectCaster* caster : casters)
  {
    in.MapLight.z = caster->SendsLight ? 1.0f : 0.0f;
    // Every shader writes depth; colours are undefined without the capture's outputs.
    in.UseMap(false, true);
    const vtkIndirectTexelTriangles::Scope seen(in.Triangles, frame, view, texels, caster->Prop);
    caster->Prop->RenderOpaqueGeometry(frame.Renderer);
  }
  this->EndStage();
  active = eye;
}

//------------------------------------------------------------------------------
void vtkSurfaceCapturePass::DrawChannel(UnattachedChannel channel)
{
  Internals& in = *this->Internal;
  in.Unclipped.Set(false);
  in.Blending = nullptr;
  if (channel == Color)
  {
    in.UseChannels(vtkIndirectGeometryChannels::Lit, 1);
    return;
  }
  vtkOpenGLState* state = in.Window->GetState();
  in.Blending = std::make_unique<vtkOpenGLState::ScopedglBlendFuncSeparate>(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ZERO, GL_ZERO, GL_ZERO, GL_ZERO);
  in.UseChannels(vtkIndirectGeometryChannels::Surface, 1);
}

//------------------------------------------------------------------------------
void vtkSurfaceCapturePass::EndStage()
{
  Internals& in = *this->Internal;
  if (in.Stage == Internals::Eye)
  {
    in.Unclipped.Set(false);
    in.Blending = nullptr;
    in.UseChannels(vtkIndirectGeometryChannels::Lit, in.Channels);
    in.Framebuffer = nullptr;
  }
  else if (in.Stage == Internals::Map)
  {
    in.UseMap(true, true);
  }
  if (in.OwnsUnit)
  {
    in.Window->GetState()->GetTextureUnitManager()->Free(in.ShadowUnit);
  }
  if (in.OwnsTileUnit)
  {
    in.Window->GetState()->GetTextureUnitManager()->Free(in.TileUnit);
  }
  in.OwnsUnit = in.OwnsTileUnit = false;
  in.ShadowUnit = in.TileUnit = -1;
}

//------------------------------------------------------------------------------
void vtkSurfaceCapturePass::Render(const vtkRenderState* s)
{
  this->NumberOfRenderedProps = 0;
  if (this->DelegatePass && this->Internal->Stage == Internals::Eye)
  {
    this->DelegatePass->Render(s);
    this->NumberOfRenderedProps = this->DelegatePass->GetNumberOfRenderedProps();
    return;
  }
  for (int i = 0; i < s->GetPropArrayCount(); ++i)
  {
    this->NumberOfRenderedProps += s->GetPropArray()[i]->RenderOpaqueGeometry(s->GetRenderer());
  }
}

//------------------------------------------------------------------------------
bool vtkSurfaceCapturePass::HasEncoded() const
{
  return this->Internal->Encoded;
}

//------------------------------------------------------------------------------
bool vtkSurfaceCapturePass::IsRedirected() const
{
  return this->Internal->Redirected;
}

//------------------------------------------------------------------------------
void vtkSurfaceCapturePass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!window)
  {
    return;
  }
  if (this->DelegatePass)
  {
    this->DelegatePass->ReleaseGraphicsResources(window);
  }
  this->Internal->ProgramCameras.clear();
}

//------------------------------------------------------------------------------
bool vtkSurfaceCapturePass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (vtkOpenGLPolyDataMapper::SafeDownCast(mapper))
  {
    vtkIndirectCaptureText::Prepare(fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkSurfaceCapturePass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp*)
{
  if (!vtkOpenGLPolyDataMapper::SafeDownCast(mapper) ||
    vtkIndirectCaptureText::IsAdded(fragmentShader))
  {
    return true;
  }
  ++this->NumberOfShaderBuilds;
  const Internals& in = *this->Internal;
  const vtkIndirectCaptureText text{ in.LightConstants, this->Written.Shadows,
    this->Written.Specular, this->Written.SpecularOfPBR, in.FlatUniforms,
    mapper->IsA("vtkOpenGLPointGaussianMapperHelper") != 0, this->Written.MapsOnly };
  text.Add(vertexShader, geometryShader, fragmentShader);
  return true;
}

//------------------------------------------------------------------------------
bool vtkSurfaceCapturePass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  Internals& in = *this->Internal;
  // Programs of maps alone have no stage.
  if (program->IsUniformUsed("vtkiStage"))
  {
    program->SetUniformi("vtkiStage", in.Stage == Internals::Map ? 1 : 0);
  }
  else if (!program->IsUniformUsed("vtkiMapLight"))
  {
    return true;
  }
  program->SetUniformi("vtkiAlbedoInAlpha",
    in.Stage == Internals::Eye && vtkIndirectGeometryChannels::IsAlbedoInLit(in.Channels) ? 1 : 0);
  const bool triangles = MapperPrimitive::IsTriangles(mapper, prop);
  const bool catches = vtkIndirectPropKind::CatchesLight(prop);
  if (program->IsUniformUsed("vtkiNumber"))
  {
    program->SetUniformi(
      "vtkiNumber", in.Stage == Internals::Eye ? in.FindNumber(prop, triangles, catches) : 0);
  }
  program->SetUniformf("vtkiSceneScale", in.SceneScale);
  program->SetUniform3f("vtkiDepthRange", in.DepthRange);
  in.PixelRays.SetUniforms(program);
  vtkIndirectWithin::SetUniforms(program, prop, in.Renderer, in.SceneCenter);
  if (program->IsUniformUsed("vtkiMagnitude"))
  {
    program->SetUniformf("vtkiMagnitude", in.Magnitude);
  }
  if (program->IsUniformUsed("vtkiLightOfPBR"))
  {
    program->SetUniformf("vtkiLightOfPBR", in.LightOfPBR);
    in.Encoded = true;
  }
  if (program->IsUniformUsed("vtkiImageLight"))
  {
    program->SetUniformf("vtkiImageLight", this->ImageLight ? 1.0f : 0.0f);
  }
  if (program->IsUniformUsed("vtkiParallel"))
  {
    program->SetUniformi("vtkiParallel", in.StageIsParallel);
  }
  if (program->IsUniformUsed("vtkiShadowMaps"))
  {
    program->SetUniformi("vtkiShadowMaps", in.ShadowUnit);
  }
  if (program->IsUniformUsed("vtkiPenumbraTiles"))
  {
    program->SetUniformi("vtkiPenumbraTiles", in.TileUnit);
  }
  // Disable blending again, which other code may have enabled since the stage began: it would blend
  // bits.
  if (in.Stage == Internals::Eye)
  {
    in.Unclipped.Set(catches);
    in.Lights.SetUniforms(program,
      in.LightConstants.GetGroups()); // a map holds surfaces, independent of lights
    this->UseEyeChannels(prop);
  }
  else if (in.Stage == Internals::Map)
  {
    in.Window->GetState()->vtkglDisable(GL_BLEND);
    program->SetUniform3f("vtkiMapLight", glm::value_ptr(in.MapLight));
    in.UseMap(triangles, triangles);
  }

  // VTK sends light directions in view coordinates only if the camera or a light has changed, and
  // does not notice that the program last drew for another camera.
  vtkCamera*& last = in.ProgramCameras[program];
  if (last != in.Camera)
  {
    program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
    last = in.Camera;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkSurfaceCapturePass::UseEyeChannels(vtkProp* prop)
{
  Internals& in = *this->Internal;
  if (vtkIndirectGeometryChannels::IsAlbedoInLit(in.Channels))
  {
    vtkIndirectGeometryChannels::DisableBlending(in.Window->GetState(), in.Channels);
    return; // the stage's initial state holds
  }
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  if (!in.Framebuffer || static_cast<unsigned int>(bound) != in.Framebuffer->GetFBOIndex())
  {
    in.Redirected = true;
    return;
  }
  vtkPointGaussianMapper* splats = FindSplats(prop);
  if (splats && splats->GetEmissive())
  {
    // This prop adds light to the surface behind it and covers nothing.
    in.UseChannels(vtkIndirectGeometryChannels::Lit, 1);
    in.Window->GetState()->vtkglBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE, GL_ZERO, GL_ONE);
    return;
  }
  vtkIndirectGeometryChannels::DisableBlending(in.Window->GetState(), in.Channels);
  if (!splats)
  {
    in.UseChannels(vtkIndirectGeometryChannels::Lit, in.Channels);
    return;
  }
  // Their alpha is one or zero in these channels, see VTKI_SOFT, so that bits are kept whole. The
  // lobe's power takes the place of an alpha; splats have no lobe.
  in.UseChannels(vtkIndirectGeometryChannels::Lit, vtkIndirectGeometryChannels::Specular);
  glEnablei(GL_BLEND, vtkIndirectGeometryChannels::Surface);
  glEnablei(GL_BLEND, vtkIndirectGeometryChannels::Albedo);
}
