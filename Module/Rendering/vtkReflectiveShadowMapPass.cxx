// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkReflectiveShadowMapPass.h"

#include "Capture/vtkIndirectShadowMaps.h"
#include "Capture/vtkSurfaceCapturePass.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectKey.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectRendererAccess.h"
#include "Frame/vtkIndirectReport.h"
#include "LightMaps/vtkIndirectLightMap.h"
#include "LightMaps/vtkIndirectLobeTable.h"
#include "LightMaps/vtkIndirectShadowRows.h"
#include "OpenGL/vtkIndirectContextGuard.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectLayeredTarget.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLCamera.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkProp.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkReflectiveShadowMapPass);

namespace
{
const vtkIndirectChannel Channels[] = {
  { "rsm.albedo", "vtkiMapAlbedo", "diffuse reflectance", GL_RGBA16F, "-", "1" },
  { "rsm.surface", "vtkiMapSurface", "linear depth, octahedral normal and kind", GL_RG32F,
    "face view", "1, 1, scene units" },
  { "rsm.slope", "vtkiMapSlope", "slope of depth over a texel's width", GL_RG16F, "face view",
    "1" },
  // Only where senders have lobes.
  { "rsm.specular", "vtkiMapSpecular", "specular reflectance, power of the lobe or -roughness",
    GL_RGBA16F, "-", "1" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};

constexpr int SlopeChannel = 2;
constexpr int ChannelsOfDiffuse = 3;

// Of all maps together, texels, of about 40 bytes with shadows: 1.3 GB. A light that is alone has
// what the user asks for.
constexpr double MostTexelsOfAll = 32.0 * 1024.0 * 1024.0;
constexpr int MostFacesOfLight = 6;
constexpr int LeastTexels = 16;

// As many as are asked for, or a half, a quarter and so on where there are many layers.
int FindTexels(int resolution, int layers)
{
  int texels = resolution;
  while (layers > MostFacesOfLight && texels / 2 >= LeastTexels &&
    1.0 * layers * texels * texels > MostTexelsOfAll)
  {
    texels /= 2;
  }
  return texels;
}

}

//------------------------------------------------------------------------------
struct vtkReflectiveShadowMapPass::Internals
{
  vtkIndirectLayeredTarget Target{ Channels };
  vtkIndirectShadowRows Rows; // of the target's depths, for shadow look-ups
  std::vector<std::unique_ptr<vtkIndirectLightMap>> Maps;
  int NumberOfMaps = 0;
  int NumberOfLayers = 0;
  std::vector<vtkIndirectKey> Faces; // the inputs of each layer's image; empty: not drawn
  std::vector<float> Table;
  vtkSmartPointer<vtkTextureObject> TableTexture;
  vtkSmartPointer<vtkTextureObject> FresnelTexture; // where senders have lobes
  vtkNew<vtkIndirectContextGuard> Guard;
};

vtkReflectiveShadowMapPass::vtkReflectiveShadowMapPass()
  : Internal(new Internals)
{
  this->Internal->Guard->Release = [this](vtkWindow* window)
  { this->ReleaseGraphicsResources(window); };
}

vtkReflectiveShadowMapPass::~vtkReflectiveShadowMapPass() = default;

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Resolution: " << this->Resolution << "\n";
  os << indent << "NumberOfMaps: " << this->GetNumberOfMaps() << "\n";
  vtkIndirectPrintChannels(os, indent, Channels);
}

//------------------------------------------------------------------------------
int vtkReflectiveShadowMapPass::GetNumberOfMaps() const
{
  return this->Internal->NumberOfMaps;
}

//------------------------------------------------------------------------------
int vtkReflectiveShadowMapPass::GetNumberOfLayers() const
{
  return this->Internal->NumberOfLayers;
}

//------------------------------------------------------------------------------
const vtkIndirectLightMap& vtkReflectiveShadowMapPass::GetMap(int i) const
{
  return *this->Internal->Maps[i];
}

//------------------------------------------------------------------------------
bool vtkReflectiveShadowMapPass::HasSpecular() const
{
  return this->Internal->Target.GetNumberOfChannels() > ChannelsOfDiffuse;
}

//------------------------------------------------------------------------------
size_t vtkReflectiveShadowMapPass::GetBytes() const
{
  return this->Internal->Target.GetBytes() + this->Internal->Rows.GetBytes();
}

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::AddToReport(vtkIndirectReport& report) const
{
  report.Bytes += this->GetBytes();
  static const char* const names[] = { "a parallel map", "a perspective map", "faces of a cube" };
  for (int i = 0; i < this->GetNumberOfMaps(); ++i)
  {
    const vtkIndirectLightMap& map = this->GetMap(i);
    report.Modelled.emplace_back("light " + std::to_string(map.Light.Index),
      std::string(names[map.Projection]) + ", " + std::to_string(map.NumberOfFaces) + " of " +
        std::to_string(this->GetTexels()) + " texels squared");
  }
  if (this->GetTexels() < this->Resolution)
  {
    report.LeftOut.emplace_back("light maps of " + std::to_string(this->Resolution) + " texels",
      "for " + std::to_string(this->GetNumberOfLayers()) +
        " of them there is no memory; they have " + std::to_string(this->GetTexels()));
  }
  if (this->LightsTooMany > 0)
  {
    report.LeftOut.emplace_back(
      "shadows and indirect light of " + std::to_string(this->LightsTooMany) + " lights",
      "this OpenGL holds no more than " + std::to_string(this->GetNumberOfLayers()) +
        " faces of light maps");
  }
}

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::Render(const vtkRenderState* s)
{
  vtkIndirectFrame frame;
  frame.Build(s);
  const vtkIndirectPlan plan = vtkIndirectPlan::Make(frame, {}, {}, {});
  if (!plan.WhyDelegate.empty())
  {
    this->Internal->NumberOfMaps = 0;
    return;
  }
  vtkNew<vtkSurfaceCapturePass> capture;
  capture->ShadowsOff();
  capture->Attach(frame);
  this->Update(frame, plan, capture);
  capture->Detach();
}

//------------------------------------------------------------------------------
bool vtkReflectiveShadowMapPass::Update(
  const vtkIndirectFrame& frame, const vtkIndirectPlan& plan, vtkSurfaceCapturePass* capture)
{
  Internals& in = *this->Internal;
  in.Guard->SetContext(frame.Window);
  in.NumberOfMaps = 0;
  in.NumberOfLayers = 0;
  int mostLayers = 0;
  frame.Window->GetState()->vtkglGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &mostLayers);
  int tooMany = 0;
  for (const int index : plan.MapLights)
  {
    const vtkIndirectLight& light = frame.Lights[index];
    if (in.NumberOfMaps == static_cast<int>(in.Maps.size()))
    {
      in.Maps.emplace_back(new vtkIndirectLightMap);
    }
    vtkIndirectLightMap& map = *in.Maps[in.NumberOfMaps];
    map.Fit(frame, light);
    if (in.NumberOfLayers + map.NumberOfFaces > mostLayers)
    {
      ++tooMany;
      continue;
    }
    ++in.NumberOfMaps;
    map.FirstLayer = in.NumberOfLayers;
    in.NumberOfLayers += map.NumberOfFaces;
  }
  if (tooMany != this->LightsTooMany && tooMany > 0)
  {
    vtkErrorMacro(<< tooMany << " light(s) have no map, and cast neither shadows nor indirect "
                  << "light: this OpenGL holds " << mostLayers << " faces of maps.");
  }
  this->LightsTooMany = tooMany;
  this->Texels = FindTexels(this->Resolution, in.NumberOfLayers);
  if (in.NumberOfMaps == 0)
  {
    return true;
  }

  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  bool lost = false;
  in.Target.SetNumberOfChannels(ChannelsOfDiffuse + (this->Specular ? 1 : 0));
  if (!in.Target.Resize(frame.Window, this->Texels, in.NumberOfLayers, lost))
  {
    in.NumberOfMaps = in.NumberOfLayers = 0;
    return false;
  }
  if (lost)
  {
    in.Rows.Release(frame.Window);
    in.Faces.clear();
  }
  in.Faces.resize(in.Target.GetLayers());

  for (int i = 0; i < in.NumberOfMaps; ++i)
  {
    vtkIndirectLightMap& map = *in.Maps[i];
    for (int face = 0; face < map.NumberOfFaces; ++face)
    {
      vtkIndirectKey key;
      map.AppendTo(key);
      std::vector<const vtkIndirectCaster*> casters;
      for (const vtkIndirectCaster& caster : frame.Casters)
      {
        if (map.CanHold(face, caster.Bounds, this->Texels))
        {
          caster.AppendTo(key);
          casters.push_back(&caster);
        }
      }
      vtkIndirectKey& last = in.Faces[map.FirstLayer + face];
      if (plan.Caching && last == key)
      {
        continue;
      }
      last = key;
      this->DrawFace(frame, capture, map, face, casters);
      in.Rows.Forget(map.FirstLayer + face);
      ++this->NumberOfFacesDrawn;
      this->ContentTime.Modified();
    }
  }
  this->UpdateTable(frame);
  this->UpdateFresnel(frame);
  return true;
}

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::DrawFace(const vtkIndirectFrame& frame,
  vtkSurfaceCapturePass* capture, vtkIndirectLightMap& map, int face,
  const std::vector<const vtkIndirectCaster*>& casters)
{
  Internals& in = *this->Internal;
  vtkOpenGLState* state = frame.Window->GetState();
  in.Target.BeginLayer(map.FirstLayer + face);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDisable(GL_BLEND);

  vtkCamera*& active = vtkIndirectRendererAccess::Camera(frame.Renderer);
  vtkCamera* const eye = active;
  active = map.GetCamera(face, frame.Parallel);
  capture->BeginMap(frame, map.GetView(this->Texels));
  for (const vtkIndirectCaster* caster : casters)
  {
    capture->BeginCaster(caster->SendsLight);
    caster->Prop->RenderOpaqueGeometry(frame.Renderer);
  }
  capture->EndStage();
  active = eye;
  in.Target.End();
}

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::UpdateTable(const vtkIndirectFrame& frame)
{
  using namespace vtkIndirectKernels;
  Internals& in = *this->Internal;
  std::vector<float> table(static_cast<size_t>(in.NumberOfLayers) * VTKI_MAP_TABLE_WIDTH * 4);
  for (int i = 0; i < in.NumberOfMaps; ++i)
  {
    const vtkIndirectLightMap& map = *in.Maps[i];
    for (int face = 0; face < map.NumberOfFaces; ++face)
    {
      const int layer = map.FirstLayer + face;
      glm::vec4 row[VTKI_MAP_TABLE_WIDTH];
      const glm::dmat4 toScene = map.FaceToScene[face];
      const glm::dmat4 fromScene = glm::inverse(toScene);
      for (int r = 0; r < 3; ++r)
      {
        for (int c = 0; c < 4; ++c)
        {
          row[VTKI_MAP_TO_SCENE + r][c] = static_cast<float>(toScene[c][r]);
          row[VTKI_MAP_FROM_SCENE + r][c] = static_cast<float>(fromScene[c][r]);
        }
      }
      const vtkIndirectLight& light = map.Light;
      const double s = frame.SceneScale;
      const bool cone = light.Positional && light.ConeAngle < 90.0;
      row[VTKI_MAP_SHAPE] = glm::vec4(map.Projection, map.HalfWidth, this->Texels, light.Exponent);
      row[VTKI_MAP_LIGHT] = glm::vec4(glm::vec3(light.Color), light.Index);
      // Distances reach the shader in scene units: c + l (d'/s) + q (d'/s)^2.
      row[VTKI_MAP_FALLOFF] =
        glm::vec4(light.Attenuation.x, light.Attenuation.y / s, light.Attenuation.z / (s * s),
          cone ? std::pow(std::tan(glm::radians(light.ConeAngle)), 2.0) : -1.0);
      row[VTKI_MAP_AXIS] = glm::vec4(glm::vec3(map.FaceAxis[face]), face);
      std::copy(&row[0][0], &row[0][0] + 4 * VTKI_MAP_TABLE_WIDTH,
        table.begin() + 4 * VTKI_MAP_TABLE_WIDTH * layer);
    }
  }
  if (in.TableTexture && table == in.Table)
  {
    return;
  }
  in.Table = table;
  this->ContentTime.Modified();
  if (!in.TableTexture)
  {
    in.TableTexture = vtkSmartPointer<vtkTextureObject>::New();
  }
  in.TableTexture->SetContext(frame.Window);
  in.TableTexture->SetMinificationFilter(vtkTextureObject::Nearest);
  in.TableTexture->SetMagnificationFilter(vtkTextureObject::Nearest);
  in.TableTexture->Create2DFromRaw(
    VTKI_MAP_TABLE_WIDTH, in.NumberOfLayers, 4, VTK_FLOAT, in.Table.data());
}

//------------------------------------------------------------------------------
// What VTK's PBR reflects of light from a direction, for vtkIndirectMapLobe.glsl.
void vtkReflectiveShadowMapPass::UpdateFresnel(const vtkIndirectFrame& frame)
{
  Internals& in = *this->Internal;
  if (!this->HasSpecular())
  {
    if (in.FresnelTexture)
    {
      in.FresnelTexture->ReleaseGraphicsResources(frame.Window);
      in.FresnelTexture = nullptr;
    }
    return;
  }
  if (in.FresnelTexture)
  {
    return;
  }
  std::vector<float> values;
  for (const auto& row : vtkIndirectLobeTable)
  {
    for (const auto& entry : row)
    {
      values.insert(values.end(), { entry[4], entry[5] });
    }
  }
  in.FresnelTexture = vtkSmartPointer<vtkTextureObject>::New();
  in.FresnelTexture->SetContext(frame.Window);
  in.FresnelTexture->SetWrapS(vtkTextureObject::ClampToEdge);
  in.FresnelTexture->SetWrapT(vtkTextureObject::ClampToEdge);
  in.FresnelTexture->SetMinificationFilter(vtkTextureObject::Linear);
  in.FresnelTexture->SetMagnificationFilter(vtkTextureObject::Linear);
  in.FresnelTexture->Create2DFromRaw(
    vtkIndirectLobeEntries, vtkIndirectLobeEntries, 2, VTK_FLOAT, values.data());
}

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::Activate(vtkShaderProgram* program) const
{
  Internals& in = *this->Internal;
  for (int i = 0; i < in.Target.GetNumberOfChannels(); ++i)
  {
    in.Target.Activate(i, program);
  }
  if (in.FresnelTexture && program->IsUniformUsed("vtkiMapFresnel"))
  {
    in.FresnelTexture->Activate();
    program->SetUniformi("vtkiMapFresnel", in.FresnelTexture->GetTextureUnit());
    const float shape[2] = { static_cast<float>(vtkIndirectLobeEntries),
      vtkIndirectLeastRoughness };
    program->SetUniform2f("vtkiMapFresnelShape", shape);
  }
  in.TableTexture->Activate();
  program->SetUniformi("vtkiMapTable", in.TableTexture->GetTextureUnit());
}

//------------------------------------------------------------------------------
vtkIndirectShadowMaps vtkReflectiveShadowMapPass::ActivateShadows(vtkOpenGLRenderWindow* window)
{
  Internals& in = *this->Internal;
  vtkIndirectShadowMaps shadows;
  for (int i = 0; i < in.NumberOfMaps; ++i)
  {
    shadows.Maps.push_back(in.Maps[i]->GetShadowMap());
  }
  shadows.Texels = this->Texels;
  const bool updated = in.Rows.Update(window, in.Target.ActivateShadow(),
    in.Target.Activate(SlopeChannel), this->Texels, in.Target.GetLayers());
  in.Target.Deactivate();
  shadows.Unit = updated ? in.Rows.Activate() : -1;
  return shadows;
}

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::Deactivate() const
{
  this->Internal->Target.Deactivate();
  this->Internal->Rows.Deactivate();
  if (this->Internal->TableTexture)
  {
    this->Internal->TableTexture->Deactivate();
  }
  if (this->Internal->FresnelTexture)
  {
    this->Internal->FresnelTexture->Deactivate();
  }
}

//------------------------------------------------------------------------------
void vtkReflectiveShadowMapPass::ReleaseGraphicsResources(vtkWindow* window)
{
  Internals& in = *this->Internal;
  if (!window || !in.Guard->CanBeOf(window))
  {
    return;
  }
  in.Target.Release(window);
  in.Rows.Release(window);
  in.Faces.clear();
  if (in.TableTexture)
  {
    in.TableTexture->ReleaseGraphicsResources(window);
    in.TableTexture = nullptr;
  }
  if (in.FresnelTexture)
  {
    in.FresnelTexture->ReleaseGraphicsResources(window);
    in.FresnelTexture = nullptr;
  }
}
