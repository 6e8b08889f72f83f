// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Maps/vtkIndirectLightMaps.h"

#include "Capture/vtkIndirectShadowMaps.h"
#include "Capture/vtkSurfaceCapturePass.h"
#include "Maps/vtkIndirectLobeTable.h"
#include "OpenGL/vtkIndirectContextGuard.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectPlan.h"
#include "Plan/vtkIndirectReport.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace
{
// Programs for maps alone pay from so many lights times faces on: a light costs 2 ms in a map of
// 512 by 512 texels (OpenGL on the processor), a program some 300 ms to compile, and its text 3 ms
// for each caster, for there and back.
constexpr size_t LightsOfOneBuild = 200;
constexpr size_t LightsOfOneCaster = 2;

const vtkIndirectChannels Channels = {
  { "rsm.slope", "vtkiMapSlope", "slope of depth over a texel's width", GL_RG16F, "face view",
    "1" },
  // Maps for shadows alone have no further channels.
  { "rsm.surface", "vtkiMapSurface", "linear depth, octahedral normal and kind", GL_RG32F,
    "face view", "1, 1, scene units" },
  { "rsm.albedo", "vtkiMapAlbedo", "diffuse reflectance", GL_RGBA16F, "-", "1" },
  // This channel exists only if senders have lobes.
  { "rsm.specular", "vtkiMapSpecular", "specular reflectance, power of the lobe or -roughness",
    GL_RGBA16F, "-", "1" },
};

const vtkIndirectChannels RowChannels = {
  { "rsm.rows", "vtkiShadowMaps", "depths of neighbours and their slopes", GL_RGBA32F, "face view",
    "depth buffer" },
};

// Coarse levels deviate from their mesh by at most this many texels in moving frames' maps for
// shadows alone. Still frames draw the mesh itself, as the first frame does, whose mappers have no
// buffers yet.
constexpr double MostErrorInMotion = 1.0;

constexpr int SlopeChannel = 0;
constexpr int ChannelsOfContent[] = { 1, 3, 4 };

// Number of texels of all maps together, of about 40 bytes each with shadows: 1.3 GB. The map of a
// single light has as many texels as the user asks for.
constexpr double MostTexelsOfAll = 32.0 * 1024.0 * 1024.0;
constexpr int MostFacesOfLight = 6;
constexpr int LeastMapTexels = 16;
// Number of texels of all maps together whose resolution follows the frame: 335 MB.
constexpr double MostTexelsOfAutomatic = 8.0 * 1024.0 * 1024.0;
constexpr int LeastTexelsOfAutomatic = 512;

// Widths of windows, as shares of the next larger one. A shadow is finest in a window no wider than
// what the eye sees. Senders beside the window light what the eye sees, too.
constexpr double ShareOfShadows = 0.8;
constexpr double ShareOfSenders = 0.5;

double FindMostError(const vtkIndirectPlan& plan)
{
  return plan.Interactive ? MostErrorInMotion : 0.0;
}

// Returns the wanted texels along an edge, or a half, a quarter and so on down to the least, so
// that all layers together have no more than `most` texels.
int FindTexels(int texels, int layers, double most, int least)
{
  while (texels / 2 >= least && 1.0 * layers * texels * texels > most)
  {
    texels /= 2;
  }
  return texels;
}
}

//------------------------------------------------------------------------------
vtkIndirectLightMaps::vtkIndirectLightMaps(vtkIndirectResource* owner, vtkObject* caller)
  : vtkIndirectResource(owner)
  , Caller(caller)
  , Target(this, Channels, true)
  , Rows(this, RowChannels, false)
  , Guard(vtkSmartPointer<vtkIndirectContextGuard>::New())
{
  this->Guard->Release = [this](vtkWindow* window) { this->Release(window); };
}

vtkIndirectLightMaps::~vtkIndirectLightMaps() = default;

//------------------------------------------------------------------------------
vtkIndirectLightMaps& vtkIndirectLightMaps::Get(const vtkReflectiveShadowMapPass* pass)
{
  return *pass->Maps;
}

//------------------------------------------------------------------------------
void vtkIndirectLightMaps::Print(ostream& os, vtkIndent indent) const
{
  os << indent << "NumberOfMaps: " << this->GetNumberOfMaps() << "\n";
  vtkIndirectPrintChannels(os, indent, Channels);
}

//------------------------------------------------------------------------------
bool vtkIndirectLightMaps::HasSenders() const
{
  return this->Target.GetNumberOfChannels() >= ChannelsOfContent[SENDERS];
}

//------------------------------------------------------------------------------
bool vtkIndirectLightMaps::HasSpecular() const
{
  return this->Target.GetNumberOfChannels() >= ChannelsOfContent[SPECULAR_SENDERS];
}

//------------------------------------------------------------------------------
void vtkIndirectLightMaps::AddToReport(vtkIndirectReport& report) const
{
  report.Bytes += this->GetBytes();
  static const char* const names[] = { "a parallel map", "a perspective map", "faces of a cube" };
  for (const vtkIndirectLightMap& map : this->Maps)
  {
    report.Modelled.emplace_back("light " + std::to_string(map.Light.Index),
      std::string(names[map.Projection]) + ", " + std::to_string(map.NumberOfFaces) + " of " +
        std::to_string(this->GetTexels()) + " texels squared" +
        (map.Window.Layer < 0 ? "" : ", and a window of the part that the camera sees"));
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
bool vtkIndirectLightMaps::Update(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
  vtkSurfaceCapturePass* capture, int resolution)
{
  this->Resolution = resolution;
  this->Guard->SetContext(frame.Window);
  this->Maps.clear();
  this->NumberOfLayers = 0;
  this->NumberOfWindows = 0;
  int mostLayers = 0;
  frame.Window->GetState()->vtkglGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &mostLayers);
  int tooMany = 0;
  for (const int index : plan.MapLights)
  {
    vtkIndirectLightMap map;
    map.Fit(frame, frame.Lights[index]);
    if (this->NumberOfLayers + map.NumberOfFaces > mostLayers)
    {
      ++tooMany;
      continue;
    }
    map.FirstLayer = this->NumberOfLayers;
    this->NumberOfLayers += map.NumberOfFaces;
    this->Maps.push_back(map);
  }
  if (tooMany != this->LightsTooMany && tooMany > 0)
  {
    vtkErrorWithObjectMacro(this->Caller ? this->Caller : frame.Window,
      << tooMany << " light(s) have no map, and cast neither shadows nor indirect "
      << "light: this OpenGL holds " << mostLayers << " faces of maps.");
  }
  this->LightsTooMany = tooMany;
  if (resolution == 0)
  {
    this->Resolution = FindTexels(
      plan.MapTexels, this->NumberOfLayers, MostTexelsOfAutomatic, LeastTexelsOfAutomatic);
  }
  this->Texels = this->NumberOfLayers > MostFacesOfLight
    ? FindTexels(this->Resolution, this->NumberOfLayers, MostTexelsOfAll, LeastMapTexels)
    : this->Resolution;
  if (this->Maps.empty())
  {
    return true;
  }
  // Windows come after all maps.
  vtkIndirectKey seen;
  frame.AppendUnitsTo(seen);
  seen.Add("texels", this->Texels);
  for (const vtkIndirectSeen::Place& place : frame.Seen.Places)
  {
    seen.Add("places", place.At).Add("places", place.Pixel);
  }
  if (this->SeenKey.Take(seen))
  {
    this->FittedWindows.clear();
  }
  this->FittedWindows.resize(this->Maps.size());
  // Further layers would take new images, and all maps be lost: frames that keep maps get none.
  const int mostWithWindows = frame.Seen.BoxesAreKept ? this->Target.GetLayers() : mostLayers;
  for (size_t i = 0; i < this->Maps.size(); ++i)
  {
    vtkIndirectLightMap& map = this->Maps[i];
    const int layer = this->NumberOfLayers + this->NumberOfWindows;
    // No stage reads the window of a positional light with a size: shadows come from its penumbra,
    // and senders from its map.
    const bool isRead = map.Light.Size == 0.0 || !map.Light.Positional;
    const bool sends = this->Content >= SENDERS && frame.Seen.Near.IsPart();
    if ((plan.Shadows || sends) && isRead && layer < mostWithWindows)
    {
      FittedWindow& fitted = this->FittedWindows[i];
      vtkIndirectKey inputs;
      map.AppendTo(inputs);
      if (fitted.Inputs.Take(inputs))
      {
        map.FitWindow(frame, this->Texels, plan.Shadows ? ShareOfShadows : ShareOfSenders);
        fitted.Window = map.Window;
      }
      map.Window = fitted.Window;
      map.Window.Layer = map.Window.HalfWidth > 0.0 ? layer : -1;
      this->NumberOfWindows += map.Window.HalfWidth > 0.0 ? 1 : 0;
    }
  }
  const int layers = this->NumberOfLayers + this->NumberOfWindows;

  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  vtkOpenGLState::ScopedglEnableDisable scissorTest(state, GL_SCISSOR_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglClearColor clearColor(state);
  bool lost = false;
  this->Target.SetNumberOfChannels(ChannelsOfContent[this->Content]);
  if (!this->Target.Resize(frame.Window, this->Texels, layers, lost))
  {
    this->Maps.clear();
    this->NumberOfLayers = 0;
    return false;
  }
  if (lost)
  {
    this->Faces.clear();
  }
  this->Faces.resize(this->Target.GetLayers());

  struct ChangedFace
  {
    vtkIndirectDepthTile View;
    int Layer;
    bool IsWindow;
    bool OfVTKLight;
    std::vector<const vtkIndirectCaster*> Casters;
  };
  std::vector<ChangedFace> changed;
  std::vector<vtkIndirectKey> windowKeys;
  for (const vtkIndirectLightMap& map : this->Maps)
  {
    const int windows = map.Window.Layer < 0 ? 0 : 1;
    for (int face = 0; face < map.NumberOfFaces + windows; ++face)
    {
      const bool isWindow = face == map.NumberOfFaces;
      const vtkIndirectDepthTile view = map.GetView(face);
      vtkIndirectKey key;
      map.AppendTo(key);
      key.Add("error of levels", this->HasSenders() ? 0.0 : FindMostError(plan));
      if (isWindow)
      {
        key.Add("window", map.Window.HalfWidth).Add("window", map.Window.Middle.x);
        key.Add("window", map.Window.Middle.y);
      }
      std::vector<const vtkIndirectCaster*> casters;
      for (const vtkIndirectCaster& caster : frame.Casters)
      {
        if (view.CanSee(frame, caster.Bounds, this->Texels))
        {
          caster.AppendTo(key);
          casters.push_back(&caster);
        }
      }
      if (isWindow && map.HasSenderWindow())
      {
        windowKeys.push_back(key);
      }
      const int layer = map.GetLayer(face);
      vtkIndirectKey& last = this->Faces[layer];
      if (plan.Caching && last == key)
      {
        continue;
      }
      last = key;
      changed.push_back({ view, layer, isWindow, map.Light.Light != nullptr, std::move(casters) });
    }
  }
  // The view's programs compute all lights at each texel of each map.
  const vtkSurfaceCapturePass::Outputs view = capture->GetOutputs();
  vtkSurfaceCapturePass::Outputs maps = view;
  maps.MapsOnly = changed.size() * frame.Lights.size() >
    LightsOfOneBuild + LightsOfOneCaster * frame.Casters.size();
  capture->SetOutputs(maps);
  for (const ChangedFace& face : changed)
  {
    this->Target.BeginLayer(face.Layer);
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglDisable(GL_BLEND);
    capture->DrawMap(frame, face.View, this->Texels,
      this->HasSenders() ? face.Casters : this->DrawShadows(frame, plan, face.View, face.Casters),
      face.OfVTKLight);
    this->Target.End();
    this->StaleRows.insert(face.Layer);
    ++this->NumberOfFacesDrawn;
    if (!face.IsWindow)
    {
      this->ContentTime.Modified();
    }
  }
  capture->SetOutputs(view);
  if (lost || windowKeys != this->WindowKeys)
  {
    this->WindowKeys = std::move(windowKeys);
    this->WindowTime.Modified();
  }
  this->UpdateTable(frame);
  this->UpdateFresnel(frame);
  return true;
}

//------------------------------------------------------------------------------
// Draws depths and slopes of casters into a face. Returns the casters that are left for their own
// mappers.
std::vector<const vtkIndirectCaster*> vtkIndirectLightMaps::DrawShadows(
  const vtkIndirectFrame& frame, const vtkIndirectPlan& plan, const vtkIndirectDepthTile& view,
  const std::vector<const vtkIndirectCaster*>& casters)
{
  if (!view.Parallel)
  {
    return casters;
  }
  return this->Drawer.Draw(frame, casters,
    { { frame, view, 0, glm::ivec2(0), glm::ivec2(this->Texels) } }, this->Texels,
    FindMostError(plan), true);
}

//------------------------------------------------------------------------------
void vtkIndirectLightMaps::UpdateTable(const vtkIndirectFrame& frame)
{
  using namespace vtkIndirectKernels;
  constexpr size_t rowSize = VTKI_MAP_TABLE_WIDTH * 4;
  const size_t layers = static_cast<size_t>(this->NumberOfLayers + this->NumberOfWindows);
  std::vector<float> table(layers * rowSize);
  for (const vtkIndirectLightMap& map : this->Maps)
  {
    const int windows = map.HasSenderWindow() ? 1 : 0;
    for (int face = 0; face < map.NumberOfFaces + windows; ++face)
    {
      glm::vec4 row[VTKI_MAP_TABLE_WIDTH];
      const vtkIndirectDepthTile view = map.GetView(face);
      const glm::dmat4 toScene = view.GetToScene();
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
      row[VTKI_MAP_SHAPE] =
        glm::vec4(map.Projection, view.HalfWidth.x, this->Texels, light.Exponent);
      row[VTKI_MAP_LIGHT] = glm::vec4(glm::vec3(light.Color), light.Index);
      // Distances reach the shader in scene units: c + l (d'/s) + q (d'/s)^2.
      row[VTKI_MAP_FALLOFF] =
        glm::vec4(light.Attenuation.x, light.Attenuation.y / s, light.Attenuation.z / (s * s),
          cone ? std::pow(std::tan(glm::radians(light.ConeAngle)), 2.0) : -1.0);
      row[VTKI_MAP_AXIS] = glm::vec4(glm::vec3(light.DirectionWC * glm::dmat3(toScene)), face);
      std::copy(&row[0][0], &row[0][0] + 4 * VTKI_MAP_TABLE_WIDTH,
        table.begin() + 4 * VTKI_MAP_TABLE_WIDTH * map.GetLayer(face));
    }
  }
  if (!this->TableTexture.IsEmpty() && table == this->Table)
  {
    return;
  }
  // A window's row tells nothing about the maps.
  const auto ofMaps = static_cast<std::ptrdiff_t>(rowSize * this->NumberOfLayers);
  if (this->TableTexture.IsEmpty() || this->NumberOfLayers != this->LayersOfTable ||
    !std::equal(table.begin(), table.begin() + ofMaps, this->Table.begin()))
  {
    this->ContentTime.Modified();
  }
  this->LayersOfTable = this->NumberOfLayers;
  this->Table = table;
  this->TableTexture.Set(frame.Window, vtkIndirectDataTexture::FLOATS, 4,
    { VTKI_MAP_TABLE_WIDTH, static_cast<int>(layers), 0 }, this->Table.data());
}

//------------------------------------------------------------------------------
// Tabulates the share of light from a direction that VTK's PBR reflects, for
// vtkIndirectMapLobe.glsl.
void vtkIndirectLightMaps::UpdateFresnel(const vtkIndirectFrame& frame)
{
  if (!this->HasSpecular())
  {
    this->FresnelTexture.Release(frame.Window);
    return;
  }
  if (!this->FresnelTexture.IsEmpty())
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
  this->FresnelTexture.Set(frame.Window, vtkIndirectDataTexture::FLOATS, 2,
    { vtkIndirectLobeEntries, vtkIndirectLobeEntries, 0 }, values.data(), true);
}

//------------------------------------------------------------------------------
void vtkIndirectLightMaps::Activate(const vtkIndirectProgram& program) const
{
  for (int i = 0; i < this->Target.GetNumberOfChannels(); ++i)
  {
    this->Target.Activate(i, program);
  }
  if (!this->FresnelTexture.IsEmpty() && program->IsUniformUsed("vtkiMapFresnel"))
  {
    this->FresnelTexture.Activate(program, "vtkiMapFresnel");
    const float shape[2] = { static_cast<float>(vtkIndirectLobeEntries),
      vtkIndirectLeastRoughness };
    program->SetUniform2f("vtkiMapFresnelShape", shape);
  }
  this->TableTexture.Activate(program, "vtkiMapTable");
}

//------------------------------------------------------------------------------
vtkIndirectShadowMaps vtkIndirectLightMaps::ActivateShadows(vtkOpenGLRenderWindow* window)
{
  vtkIndirectShadowMaps shadows;
  shadows.Maps.assign(this->Maps.begin(), this->Maps.end());
  shadows.Texels = this->Texels;
  shadows.Unit = this->UpdateRows(window) ? this->Rows.Activate(0) : -1;
  return shadows;
}

//------------------------------------------------------------------------------
bool vtkIndirectLightMaps::UpdateRows(vtkOpenGLRenderWindow* window)
{
  vtkIndirectFullScreenState kernelState(window);
  bool lost = false;
  if (!this->Rows.Resize(window, this->Texels, this->Target.GetLayers(), lost))
  {
    return false;
  }
  for (int layer = 0; lost && layer < this->Target.GetLayers(); ++layer)
  {
    this->StaleRows.insert(layer);
  }
  if (this->StaleRows.empty())
  {
    return true;
  }
  const vtkIndirectProgram program = this->RowKernel.Use(window);
  if (!program)
  {
    return false;
  }
  program->SetUniformi("vtkiShadowMaps", this->Target.ActivateShadow());
  program->SetUniformi("vtkiMapSlope", this->Target.Activate(SlopeChannel));
  for (const int layer : this->StaleRows)
  {
    this->Rows.BeginLayer(layer);
    program->SetUniformi("vtkiLayer", layer);
    this->RowKernel.Draw();
    this->Rows.End();
  }
  this->Target.Deactivate();
  this->StaleRows.clear();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectLightMaps::CanRelease(vtkWindow* window)
{
  return window && this->Guard->CanBeOf(window);
}
