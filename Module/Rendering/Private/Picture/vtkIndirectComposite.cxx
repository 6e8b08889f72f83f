// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Picture/vtkIndirectComposite.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Maps/vtkIndirectLightMap.h"
#include "Maps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "Scene/vtkIndirectEyeUniforms.h"
#include "Sums/vtkIndirectReceiverGrid.h"
#include "vtkImageData.h"
#include "vtkTextureObject.h"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

// Channels for viewing: names, debug views, PrintSelf and the documentation use this table.
struct vtkIndirectShownChannel
{
  const char* Name;
  const char* Meaning;
  const char* Unit;
  int Number; // number in shaders
  int Components;
  // Shown colour: value * scale + bias. Lengths are shown over the far plane; see ShowImage.
  float Scale;
  float Bias;
};

using namespace vtkIndirectKernels;
namespace
{
const vtkIndirectChannels ImageChannels = {
  { "image", "vtkiImage", "one channel of the frame", GL_RGBA32F, "world", "world units" },
};
const vtkIndirectChannels BlockChannels = {
  { "balance.sums", "vtkiSums", "light of blocks of pixels", GL_RGBA32F, "-", "VTK radiance" },
  { "balance.rooms", "vtkiRooms", "strengths that make channels one", GL_RGBA32F, "-", "1" },
};

// Pixels along an edge of a block.
constexpr int BlockEdge = 8;

const vtkIndirectShownChannel FrameChannels[] = {
  { "final", "the picture of the opaque props", "VTK radiance", VTKI_CHANNEL_FINAL, 3, 1.0f, 0.0f },
  { "direct", "VTK's own shading, shadowed", "VTK radiance", VTKI_CHANNEL_DIRECT, 3, 1.0f, 0.0f },
  { "indirect", "albedo E + glossy, what the pass adds", "VTK radiance", VTKI_CHANNEL_INDIRECT, 3,
    1.0f, 0.0f },
  { "irradiance", "E, all irradiance that the pass adds: sky, area and bounce",
    "VTK irradiance, physical over pi", VTKI_CHANNEL_IRRADIANCE, 3, 1.0f, 0.0f },
  { "sky", "its part that comes directly from the environment", "VTK irradiance", VTKI_CHANNEL_SKY,
    3, 1.0f, 0.0f },
  { "area", "its part that comes directly from area lights", "VTK irradiance", VTKI_CHANNEL_AREA, 3,
    1.0f, 0.0f },
  { "bounce", "its part that surfaces reflect", "VTK irradiance", VTKI_CHANNEL_BOUNCE, 3, 1.0f,
    0.0f },
  { "glossy", "what receivers reflect specularly", "VTK radiance", VTKI_CHANNEL_GLOSSY, 3, 1.0f,
    0.0f },
  { "albedo", "diffuse reflectance, of PBR times 1 - metallic", "1", VTKI_CHANNEL_ALBEDO, 3, 1.0f,
    0.0f },
  { "normal", "unit shading normal in world coordinates", "1", VTKI_CHANNEL_NORMAL, 3, 0.5f, 0.5f },
  { "depth", "distance along the view axis", "world units", VTKI_CHANNEL_DEPTH, 1, 1.0f, 0.0f },
  { "specular", "specular reflectance, power of the lobe or of PBR minus its roughness", "1",
    VTKI_CHANNEL_SPECULAR, 4, 1.0f, 0.0f },
  { "caught", "share of the background that props that catch light show", "1", VTKI_CHANNEL_CAUGHT,
    3, 1.0f, 0.0f },
};
const vtkIndirectShownChannel MapChannels[] = {
  { "depth", "depth along a face's axis", "world units", VTKI_MAP_CHANNEL_DEPTH, 1, 1.0f, 0.0f },
  { "normal", "unit shading normal in world coordinates", "1", VTKI_MAP_CHANNEL_NORMAL, 3, 0.5f,
    0.5f },
  { "density", "reflected density per unit light intensity", "1; world units squared",
    VTKI_MAP_CHANNEL_DENSITY, 3, 1.0f, 0.0f },
};
}

//------------------------------------------------------------------------------
struct vtkIndirectComposite::Internals : vtkIndirectResource
{
  using vtkIndirectResource::vtkIndirectResource;

  vtkIndirectTarget Image{ this, ImageChannels, false };
  // One program for linear colours only, one for encoded colours too.
  vtkIndirectFullScreenProgram Composite[2] = { { this, "vtkIndirectCompositeFS.glsl" },
    { this, "vtkIndirectCompositeFS.glsl" } };
  // One program darkens the background, one brightens it.
  vtkIndirectFullScreenProgram Catch[2] = { { this, "vtkIndirectCatchFS.glsl" },
    { this, "vtkIndirectCatchFS.glsl" } };
  vtkIndirectFullScreenProgram DrawChannel{ this, "vtkIndirectChannelFS.glsl" };
  vtkIndirectFullScreenProgram DrawMapChannel{ this, "vtkIndirectMapChannelFS.glsl" };
  vtkIndirectTarget Blocks{ this, BlockChannels, false };
  vtkIndirectFullScreenProgram Measure{ this, "vtkIndirectMeasureFS.glsl" };
  vtkIndirectFullScreenProgram Display{ this, "vtkIndirectDisplayFS.glsl" };
  const vtkIndirectShownChannel* Channel = nullptr;
  double Farthest = 1.0; // world units

  // Returns the text by which vtkIndirectAddedLight.glsl adds the light up.
  static std::string DefineLights(const Input& input)
  {
    static const char* const sums[] = { "sky", "area", "bounce", "radiance", "radiance" };
    std::string added[2]; // to irradiance, to radiance
    std::string open;     // to the irradiance if nothing hid light
    for (size_t i = 0; i < input.Lights.size(); ++i)
    {
      const vtkIndirectContribution& light = input.Lights[i];
      const std::string index = "[" + std::to_string(i) + "]";
      const bool isRadiance = light.Kind >= vtkIndirectContribution::REFLECTED;
      added[isRadiance] += sums[light.Kind] + std::string(" += ") +
        (light.Kind == vtkIndirectContribution::LOBE ? "specular * " : "") +
        (light.Coarse ? "vtkiFetchCoarse(vtkiLights" + index + ", position)"
                      : "textureLod(vtkiLights" + index + ", place, 0.0f).rgb") +
        (light.Unit == 1.0 ? "" : " * vtkiUnits" + index) + (isRadiance ? " * scale; " : "; ");
      open += light.Open ? "open += textureLod(vtkiOpenLights" + index +
          ", place, 0.0f).rgb * vtkiUnits" + index + "; "
                         : "";
    }
    const bool isSpecular = !added[1].empty() && input.Geometry.HasSpecular();
    return input.Lights.empty() ? std::string()
                                : "#define VTKI_LIGHTS " + std::to_string(input.Lights.size()) +
        "\n#define VTKI_ADD_IRRADIANCE " + added[0] + "\n#define VTKI_ADD_RADIANCE " + added[1] +
        "\n#define VTKI_ADD_OPEN " + open + (isSpecular ? "\n#define VTKI_SPECULAR\n" : "\n");
  }

  static vtkIndirectProgram Use(
    vtkIndirectFullScreenProgram& kernel, const Input& input, const std::string& definitions)
  {
    const std::string lamps = input.LampsAreReplaceable
      ? "#define VTKI_LAMPS " + std::to_string(input.Frame.Lights.size()) + "\n"
      : std::string();
    const char* const encoded = input.Geometry.HasEncoded() ? "#define VTKI_ENCODED\n" : "";
    return kernel.Use(input.Frame.Window,
      input.Geometry.GetAlbedoDefinitions() + DefineLights(input) + lamps + encoded + definitions);
  }

  static void ActivateFrame(const vtkIndirectProgram& program, const Input& input)
  {
    const vtkIndirectTarget& geometry = input.Geometry.GetTarget();
    input.Geometry.ActivateAlbedo(program);
    geometry.Activate(vtkIndirectGeometryBuffer::Surface, program);
    if (input.Geometry.HasSpecular())
    {
      geometry.Activate(vtkIndirectGeometryBuffer::Specular, program);
    }
    for (size_t i = 0; i < input.Lights.size(); ++i)
    {
      const vtkIndirectContribution& light = input.Lights[i];
      const std::string index = "[" + std::to_string(i) + "]";
      light.Target->Activate(light.Channel, program, ("vtkiLights" + index).c_str());
      program->SetUniformf(("vtkiUnits" + index).c_str(), static_cast<float>(light.Unit));
      if (light.Coarse)
      {
        light.Coarse->ActivateAll(program);
      }
      if (light.Open && program->IsUniformUsed(("vtkiOpenLights" + index).c_str()))
      {
        light.Open->Activate(0, program, ("vtkiOpenLights" + index).c_str());
      }
    }
    if (input.OpenLit && program->IsUniformUsed("vtkiOpenLit"))
    {
      input.OpenLit->Activate(0, program);
    }
    vtkIndirectSetEyeUniforms(program, input.Frame);
    program->SetUniformf(
      "vtkiIndirectScale", input.Lights.empty() ? 0.0f : static_cast<float>(input.IndirectScale));
    vtkIndirectSetUniform(program, "vtkiGreatest", glm::vec3(input.Greatest));
    if (input.LampsAreReplaceable)
    {
      ActivateLamps(program, input);
    }
  }

  static void ActivateLamps(const vtkIndirectProgram& program, const Input& input)
  {
    const glm::dmat3 toView(input.Frame.WorldToView);
    std::vector<glm::vec3> directions;
    std::vector<glm::vec3> colors;
    for (const vtkIndirectLight& lamp : input.Frame.Lights)
    {
      directions.emplace_back(-glm::normalize(toView * lamp.DirectionWC));
      colors.emplace_back(lamp.Color);
    }
    using Row = const float(*)[3];
    const int count = static_cast<int>(directions.size());
    program->SetUniform3fv(
      "vtkiLampDirections", count, reinterpret_cast<Row>(glm::value_ptr(directions[0])));
    program->SetUniform3fv(
      "vtkiLampColors", count, reinterpret_cast<Row>(glm::value_ptr(colors[0])));
    program->SetUniformf("vtkiReplaced", static_cast<float>(input.Balance.Replaced));
    program->SetUniformf("vtkiStrength", static_cast<float>(input.Balance.Strength));
  }
};

vtkIndirectComposite::vtkIndirectComposite(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Internal(new Internals(this))
{
}

vtkIndirectComposite::~vtkIndirectComposite() = default;

//------------------------------------------------------------------------------
int vtkIndirectComposite::FindChannel(const std::string& name)
{
  int i = 0;
  for (const vtkIndirectShownChannel& channel : FrameChannels)
  {
    if (name == channel.Name)
    {
      return i;
    }
    ++i;
  }
  return -1;
}

//------------------------------------------------------------------------------
bool vtkIndirectComposite::ParseMapChannel(const std::string& name, int& map, int& channel)
{
  const size_t dot = name.find('.');
  if (name.compare(0, 3, "rsm") != 0 || dot == std::string::npos || dot < 4 || dot > 8)
  {
    return false;
  }
  map = 0;
  for (size_t i = 3; i < dot; ++i)
  {
    if (name[i] < '0' || name[i] > '9')
    {
      return false;
    }
    map = 10 * map + (name[i] - '0');
  }
  for (channel = 0; channel < 3; ++channel)
  {
    if (name.compare(dot + 1, std::string::npos, MapChannels[channel].Name) == 0)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::string vtkIndirectComposite::GetChannelNames()
{
  std::string names;
  for (const vtkIndirectShownChannel& channel : FrameChannels)
  {
    names += (names.empty() ? "" : ", ") + std::string(channel.Name);
  }
  for (const vtkIndirectShownChannel& channel : MapChannels)
  {
    names += ", rsm<i>." + std::string(channel.Name);
  }
  return names;
}

//------------------------------------------------------------------------------
void vtkIndirectComposite::PrintChannels(std::ostream& os, vtkIndent indent)
{
  auto print = [&](const char* prefix, const vtkIndirectShownChannel& channel)
  {
    os << indent << prefix << channel.Name << ": " << channel.Meaning << " (" << channel.Unit
       << ", " << channel.Components << (channel.Components == 1 ? " component" : " components")
       << ")\n";
  };
  for (const vtkIndirectShownChannel& channel : FrameChannels)
  {
    print("", channel);
  }
  for (const vtkIndirectShownChannel& channel : MapChannels)
  {
    print("rsm<i>.", channel);
  }
  os
    << indent
    << "lights: virtual lights, a row each of three texels: position, area; normal, lobe exponent; "
       "B A, source (world units, 4 components)\n";
}

//------------------------------------------------------------------------------
std::vector<vtkIndirectLightBalance::Block> vtkIndirectComposite::Measure(Input input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  input.Balance = vtkIndirectLightBalance();
  vtkIndirectFullScreenState kernelState(frame.Window);
  if (!in.Blocks.Resize(frame.Window, (frame.Size[0] + BlockEdge - 1) / BlockEdge,
        (frame.Size[1] + BlockEdge - 1) / BlockEdge))
  {
    return {};
  }
  vtkIndirectProgram program = Internals::Use(in.Measure, input, "");
  if (!program)
  {
    return {};
  }
  in.Blocks.Begin();
  Internals::ActivateFrame(program, input);
  program->SetUniformi("vtkiBlock", BlockEdge);
  program->SetUniformf("vtkiUnbounded", static_cast<float>(vtkIndirectLightBalance::Unbounded));
  in.Measure.Draw();
  in.Blocks.End();
  const std::vector<float> sums = in.Blocks.ReadBack(0);
  const std::vector<float> rooms = in.Blocks.ReadBack(1);
  std::vector<vtkIndirectLightBalance::Block> blocks;
  for (size_t i = 0; i < sums.size(); i += 4)
  {
    blocks.push_back({ sums[i], sums[i + 1], sums[i + 2], { rooms[i], rooms[i + 1] } });
  }
  return blocks;
}

//------------------------------------------------------------------------------
bool vtkIndirectComposite::Composite(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
  const bool encoded = input.Geometry.HasEncoded();
  vtkIndirectFullScreenProgram& kernel = in.Composite[encoded];
  // On an empty target, copying depth is cheaper than testing and writing it pixel by pixel.
  // Props that catch light have depths that the target does not get.
  const bool catches = !frame.Catchers.empty();
  const bool copied = input.DepthDrawn ||
    (input.DepthCleared && !catches &&
      vtkIndirectBackEndChoices::Get(vtkIndirectBackEndChoices::Depth) ==
        vtkIndirectBackEndChoices::DepthByCopy &&
      input.Geometry.GetTarget().CopyDepth(frame.Origin));
  vtkIndirectProgram program = Internals::Use(kernel, input,
    std::string(copied ? "#define VTKI_DEPTH_COPIED\n" : "") +
      (catches ? "#define VTKI_CATCHERS\n" : ""));
  if (!program)
  {
    return false;
  }
  if (copied)
  {
    state->vtkglDisable(GL_DEPTH_TEST);
  }
  else
  {
    // The depth test keeps earlier layers in front.
    state->vtkglEnable(GL_DEPTH_TEST);
    state->vtkglDepthFunc(GL_LEQUAL);
    state->vtkglDepthMask(GL_TRUE);
  }
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  state->vtkglViewport(frame.Origin[0], frame.Origin[1], frame.Size[0], frame.Size[1]);
  Internals::ActivateFrame(program, input);
  if (!copied)
  {
    input.Geometry.GetTarget().ActivateDepth(program, "vtkiDepth");
  }
  program->SetUniform2i("vtkiOrigin", frame.Origin);
  kernel.Draw();
  return !input.OpenLit || this->Catch(input);
}

//------------------------------------------------------------------------------
// Blending multiplies the background, whatever has drawn it: one draw by what is lost of it, and
// one by what is added to it. Images of bytes at most double it.
bool vtkIndirectComposite::Catch(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglDepthMask depthMask(state);
  state->vtkglEnable(GL_BLEND);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglDepthMask(GL_FALSE);
  for (int brightens = 0; brightens < 2; ++brightens)
  {
    vtkIndirectFullScreenProgram& kernel = this->Internal->Catch[brightens];
    vtkIndirectProgram program =
      Internals::Use(kernel, input, brightens ? "#define VTKI_BRIGHTENS\n" : "");
    if (!program)
    {
      return false;
    }
    if (brightens)
    {
      state->vtkglBlendFuncSeparate(GL_DST_COLOR, GL_ONE, GL_ZERO, GL_ONE);
    }
    else
    {
      state->vtkglBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    }
    Internals::ActivateFrame(program, input);
    input.Geometry.GetTarget().ActivateDepth(program, "vtkiDepth");
    program->SetUniform2i("vtkiOrigin", frame.Origin);
    kernel.Draw();
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectComposite::RenderChannel(const Input& input, const std::string& name)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  int map = 0;
  int mapChannel = 0;
  const int channel = FindChannel(name);
  const bool ofMap = channel < 0 && ParseMapChannel(name, map, mapChannel) && input.Maps &&
    map < input.Maps->GetNumberOfMaps() && input.Maps->HasSenders();
  if (channel < 0 && !ofMap)
  {
    return false;
  }
  int size[2] = { frame.Size[0], frame.Size[1] };
  if (ofMap)
  {
    size[1] = input.Maps->GetTexels();
    size[0] = input.Maps->GetMap(map).NumberOfFaces * size[1];
  }
  vtkIndirectFullScreenState kernelState(frame.Window);
  vtkIndirectFullScreenProgram& kernel = ofMap ? in.DrawMapChannel : in.DrawChannel;
  if (!in.Image.Resize(frame.Window, size[0], size[1]))
  {
    return false;
  }
  vtkIndirectProgram program = ofMap
    ? kernel.Use(frame.Window)
    : Internals::Use(kernel, input, input.OpenLit ? "#define VTKI_CATCHES\n" : "");
  if (!program)
  {
    return false;
  }
  in.Image.Begin();
  program->SetUniformf("vtkiSceneScale", static_cast<float>(frame.SceneScale));
  if (ofMap)
  {
    const vtkIndirectLightMap& lightMap = input.Maps->GetMap(map);
    input.Maps->Activate(program);
    program->SetUniformi("vtkiFirstLayer", lightMap.FirstLayer);
    program->SetUniformi("vtkiChannel", MapChannels[mapChannel].Number);
    kernel.Draw();
    in.Channel = &MapChannels[mapChannel];
    in.Farthest = lightMap.Far / frame.SceneScale;
  }
  else
  {
    const int origin[2] = { 0, 0 };
    Internals::ActivateFrame(program, input);
    program->SetUniform2i("vtkiOrigin", origin);
    program->SetUniformi("vtkiChannel", FrameChannels[channel].Number);
    vtkIndirectSetUniform(
      program, "vtkiViewToWorldDirection", glm::mat3(glm::inverse(glm::dmat3(frame.WorldToView))));
    kernel.Draw();
    in.Channel = &FrameChannels[channel];
    in.Farthest = frame.Far / frame.SceneScale;
  }
  in.Image.End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectComposite::RenderChannel(const Input& input, const std::function<int()>& draw)
{
  static const vtkIndirectShownChannel shown[] = { { "", "", "", 0, 1, 1.0f, 0.0f },
    { "", "", "", 0, 3, 1.0f, 0.0f } };
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectFullScreenState kernelState(frame.Window);
  if (!in.Image.Resize(frame.Window, frame.Size[0], frame.Size[1]))
  {
    return false;
  }
  in.Image.Begin();
  in.Image.Clear();
  const int components = draw();
  in.Image.End();
  in.Channel = &shown[components == 3];
  in.Farthest = 8.0; // scale of a component such as a level
  return components > 0;
}

//------------------------------------------------------------------------------
void vtkIndirectComposite::CopyImage(vtkImageData* image)
{
  vtkIndirectTarget& source = this->Internal->Image;
  const int components = this->Internal->Channel->Components;
  const std::vector<float> values = source.ReadBack(0);
  image->SetDimensions(source.GetWidth(), source.GetHeight(), 1);
  image->AllocateScalars(VTK_FLOAT, components);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  for (size_t i = 0; i < values.size(); i += 4)
  {
    out = std::copy(&values[i], &values[i] + components, out);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectComposite::ShowImage(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectFullScreenState kernelState(frame.Window);
  vtkIndirectProgram program = in.Display.Use(frame.Window);
  if (!program)
  {
    return false;
  }
  frame.Window->GetState()->vtkglViewport(
    frame.Origin[0], frame.Origin[1], frame.Size[0], frame.Size[1]);
  in.Image.Activate(0, program);
  program->SetUniform2i("vtkiOrigin", frame.Origin);
  vtkIndirectSetUniform(program, "vtkiViewSize", glm::vec2(frame.Size[0], frame.Size[1]));
  const bool isLength = in.Channel->Components == 1;
  vtkIndirectSetUniform(program, "vtkiScaleBias",
    glm::vec2(isLength ? 1.0 / in.Farthest : in.Channel->Scale, in.Channel->Bias));
  in.Display.Draw();
  return true;
}
