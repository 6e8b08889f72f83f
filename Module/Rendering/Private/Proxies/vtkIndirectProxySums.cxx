// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Proxies/vtkIndirectProxySums.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Proxies/vtkIndirectProxyChannels.h"
#include "Scene/vtkIndirectFrame.h"

#include <algorithm>

using namespace vtkIndirectProxyChannels;

namespace
{
constexpr int RowLength = vtkIndirectKernels::VTKI_ROW_LENGTH;
constexpr int TileSize = 16;
constexpr int SharedTile = vtkIndirectKernels::VTKI_PROXY_TILE;
constexpr int SharedBlock = vtkIndirectKernels::VTKI_PROXY_BLOCK;
// First image unit of images of pixels, after those of receivers.
constexpr int PixelUnit = 4;
// Entries in one draw: long draws stall a desktop.
constexpr int EntriesPerDraw = 16 * RowLength;
enum ModeType
{
  COARSE,
  PIXELS,
  REST,
  SENDERS
};
}

//------------------------------------------------------------------------------
vtkIndirectProxySums::vtkIndirectProxySums(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , SenderLight(this, SenderLightChannels, false)
  , AllLight(this, SentLightChannels, false)
  , Coarse(this, CoarseChannels)
  , Shared(this, SharedChannels, false)
  , Counts(this, CountChannels, false)
  , Blended(this, BlendedChannels, false)
{
}

//------------------------------------------------------------------------------
bool vtkIndirectProxySums::Update(vtkOpenGLRenderWindow* window, const vtkIndirectProxyTree& tree,
  const std::vector<vtkIndirectProxyPolygon>& polygons)
{
  this->Changed = true;
  return this->Tables.Update(window, tree, polygons);
}

//------------------------------------------------------------------------------
void vtkIndirectProxySums::SetEnvironment(
  vtkOpenGLRenderWindow* window, vtkEnvironmentLight* environment)
{
  const bool changed = this->Light.Update(
    window, environment, this->Tables.GetPolygons(), this->Tables.GetFirstPlace(), this->Changed);
  this->SendersAreLit = this->SendersAreLit && !changed;
  this->Changed = false;
}

//------------------------------------------------------------------------------
// Finds the light that falls on senders, and its means.
bool vtkIndirectProxySums::LightSenders(const Input& input)
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  if (this->SendersAreLit)
  {
    return true;
  }
  const vtkIndirectTarget& entries = this->Tables.GetEntries();
  const vtkIndirectTarget& ranges = this->Tables.GetRanges();
  const int rows = this->Tables.GetSenders().GetHeight();
  if (!this->SenderLight.Resize(window, RowLength, rows) ||
    !this->AllLight.Resize(window, RowLength, entries.GetHeight() + rows))
  {
    return false;
  }
  if (vtkIndirectComputeProgram::IsSupported())
  {
    if (!this->SumInTiles(input, "#define VTKI_PROXY_SENDERS\n", this->SenderLight, SENDERS))
    {
      return false;
    }
  }
  for (int i = vtkIndirectComputeProgram::IsSupported() ? 1 : 0; i < 2; ++i)
  {
    vtkIndirectFullScreenProgram& kernel = i == 0 ? this->Sending : this->Averaging;
    vtkIndirectTarget& target = i == 0 ? this->SenderLight : this->AllLight;
    kernel.SetDefinitions(i > 0    ? "#define VTKI_PROXY_MEANS\n"
        : this->Tables.HasGroups() ? "#define VTKI_PROXY_TREE\n"
                                   : "");
    const bool drawn = kernel.Run(window, target,
      [&](const vtkIndirectProgram& program)
      {
        ranges.Activate(0, program);
        if (i == 0)
        {
          this->Activate(input, program);
          return;
        }
        program->SetUniformi("vtkiSenderRow", entries.GetHeight());
        program->SetUniformi("vtkiFirstMean", this->Tables.GetFirstPlace());
        program->SetUniformi("vtkiProxyCount", this->Tables.GetNumberOfEntries());
        entries.Activate(2, program);
        for (int k = 0; k < 4; ++k)
        {
          this->SenderLight.Activate(k, program);
        }
      });
    if (!drawn)
    {
      return false;
    }
  }
  this->SendersAreLit = true;
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectProxySums::Activate(const Input& input, const vtkIndirectProgram& program) const
{
  input.Geometry.ActivateReceivers(program, input.Frame);
  program->SetUniform2i("vtkiCoarseSize", this->CoarseSize);
  program->SetUniformi("vtkiStep", input.Step);
  if (program->IsUniformUsed("vtkiSentLight0"))
  {
    program->SetUniformi("vtkiSenderRow", this->Tables.GetEntries().GetHeight());
    for (int i = 0; i < this->AllLight.GetNumberOfChannels(); ++i)
    {
      this->AllLight.Activate(i, program);
    }
  }
  this->Light.Activate(program);
  this->Tables.Activate(program);
  vtkIndirectProxyTreeTables::SetTexelSize(program, "vtkiLightScale", this->AllLight);
  program->SetUniformi("vtkiProxyHides", input.Hides ? 1 : 0);
  program->SetUniformi("vtkiEyeIsInside", input.EyeIsInside ? 1 : 0);
  program->SetUniformf("vtkiProxyLightReach", static_cast<float>(input.LightReach));
}

//------------------------------------------------------------------------------
bool vtkIndirectProxySums::Sum(const Input& input, vtkIndirectTarget& image)
{
  const vtkIndirectFrame& frame = input.Frame;
  if (!image.Resize(frame.Window, frame.Size[0], frame.Size[1], &input.Geometry.GetTarget()))
  {
    return false;
  }
  const bool sends = image.GetNumberOfChannels() > 1;
  const bool shadowed = sends && input.Shadowed && input.Hides;
  const std::string definitions = std::string(sends ? "#define VTKI_PROXY_LIGHT\n" : "") +
    (input.Middle ? "#define VTKI_PROXY_MIDDLE\n" : "") +
    (input.Exact ? "#define VTKI_PROXY_EXACT\n" : "") +
    (shadowed ? "#define VTKI_PROXY_SHADOWED\n" : "");
  if (shadowed && !this->LightSenders(input))
  {
    return false;
  }
  // Receivers from border to border.
  for (int i = 0; i < 2; ++i)
  {
    this->CoarseSize[i] = vtkIndirectReceiverGrid::Count(frame.Size[i], input.Step);
  }
  const bool coarse = input.Step > 1;
  if (!coarse)
  {
    this->Coarse.Release(frame.Window);
    this->Shared.Release(frame.Window);
    this->Counts.Release(frame.Window);
    this->Rest.Release(frame.Window);
  }
  else
  {
    this->Coarse.SetNumberOfChannels(sends ? 4 : 3);
    if (!this->Coarse.Resize(frame, input.Step))
    {
      return false;
    }
  }
  if (!vtkIndirectComputeProgram::IsSupported())
  {
    return this->SumBlended(input, definitions, image);
  }
  this->Blended.Release(frame.Window);
  if (!coarse)
  {
    return this->SumInTiles(input, definitions, image, PIXELS);
  }
  return this->SumInTiles(input, definitions, this->Coarse, COARSE) &&
    this->Upsample(input, definitions, image) && this->SumRest(input, definitions, image);
}

//------------------------------------------------------------------------------
// Sums the light of pixels that no coarse receiver represents.
bool vtkIndirectProxySums::SumRest(
  const Input& input, const std::string& definitions, vtkIndirectTarget& image)
{
  const int* const size = input.Frame.Size;
  const int tiles[2] = { (size[0] + SharedTile - 1) / SharedTile,
    (size[1] + SharedTile - 1) / SharedTile };
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  return this->Counts.Resize(window, tiles[0], tiles[1]) &&
    this->Shared.Resize(window, SharedBlock * tiles[0], SharedBlock * tiles[1]) &&
    this->ChooseRest(input, image) && this->SumInTiles(input, definitions, image, REST) &&
    this->ShareRest(input, definitions, image);
}

//------------------------------------------------------------------------------
bool vtkIndirectProxySums::ChooseRest(const Input& input, vtkIndirectTarget& image)
{
  const vtkIndirectFrame& frame = input.Frame;
  const vtkIndirectProgram program = this->Choosing.Use(frame.Window);
  if (!program)
  {
    return false;
  }
  const size_t pixels = static_cast<size_t>(frame.Size[0]) * static_cast<size_t>(frame.Size[1]);
  this->Rest.Begin(frame.Window, 2 * pixels);
  this->Activate(input, program);
  this->Rest.Activate(program, "vtkiProxyPixels");
  this->Choosing.AddImages(image);
  this->Choosing.AddImages(this->Counts, 1);
  this->Choosing.Run(this->Counts.GetWidth(), this->Counts.GetHeight(), SharedTile);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectProxySums::ShareRest(
  const Input& input, const std::string& definitions, vtkIndirectTarget& image)
{
  this->Sharing.SetDefinitions(definitions);
  const vtkIndirectProgram program = this->Sharing.Use(input.Frame.Window);
  if (!program)
  {
    return false;
  }
  this->Activate(input, program);
  this->Counts.Activate(0, program);
  for (int i = 0; i < this->Shared.GetNumberOfChannels(); ++i)
  {
    this->Shared.Activate(i, program);
  }
  this->Rest.Activate(program, "vtkiProxyPixels");
  this->Sharing.AddImages(image);
  this->Sharing.Run(this->Rest, 1);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectProxySums::SumInTiles(
  const Input& input, const std::string& definitions, vtkIndirectTarget& image, int mode)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectComputeProgram& tiles = this->Tiles[mode];
  tiles.SetDefinitions(definitions + (this->Tables.HasGroups() ? "#define VTKI_PROXY_TREE\n" : "") +
    (mode == PIXELS ? "#define VTKI_PROXY_PIXELS\n" : "") +
    (mode == REST ? "#define VTKI_PROXY_REST\n" : ""));
  const vtkIndirectProgram program = tiles.Use(frame.Window);
  if (!program)
  {
    return false;
  }
  this->Activate(input, program);
  tiles.AddImages(image, mode == PIXELS || mode == REST ? PixelUnit : 0);
  if (mode == REST)
  {
    tiles.AddImages(this->Shared);
    this->Rest.Activate(program, "vtkiProxyPixels");
    tiles.Run(this->Rest, 0);
    return true;
  }
  const int senders[2] = {
    (this->Tables.GetNumberOfSenders() + RowLength - 1) / RowLength * TileSize, TileSize
  };
  const int* const size = mode == COARSE ? this->CoarseSize
    : mode == SENDERS                    ? senders
                                         : frame.Size;
  tiles.Run(size[0], size[1], TileSize);
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectProxySums::Splat(const Input& input, const std::string& definitions)
{
  const vtkIndirectFrame& frame = input.Frame;
  vtkIndirectTarget& target = this->Blended;
  if (!target.Resize(frame.Window, this->CoarseSize[0], this->CoarseSize[1]))
  {
    return false;
  }
  const vtkIndirectProgram program = this->Splatting.Use(frame.Window, definitions);
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable cull(state, GL_CULL_FACE);
  state->vtkglDisable(GL_CULL_FACE);
  target.Begin();
  target.Clear();
  const vtkIndirectAddition addition(frame.Window);
  this->Activate(input, program);
  vtkIndirectSetUniform(program, "vtkiSceneToClip", frame.FindSceneToClip());
  vtkIndirectSetUniform(program, "vtkiProxyMargin",
    glm::vec2(4.0f / static_cast<float>(this->CoarseSize[0]),
      4.0f / static_cast<float>(this->CoarseSize[1])));
  const int attribute = program->FindAttributeArray("vtkiCorner");
  for (int first = 0; first < this->Tables.GetNumberOfEntries(); first += EntriesPerDraw)
  {
    program->SetUniformi("vtkiFirstProxy", first);
    this->Mesh.Draw(frame.Window, attribute, true,
      std::min(EntriesPerDraw, this->Tables.GetNumberOfEntries() - first));
    glFlush();
  }
  target.End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectProxySums::SumBlended(
  const Input& input, const std::string& definitions, vtkIndirectTarget& image)
{
  const vtkIndirectFrame& frame = input.Frame;
  if (!this->Splat(input, definitions))
  {
    return false;
  }
  const bool coarse = input.Step > 1;
  vtkIndirectTarget& target = coarse ? this->Coarse : image;
  this->Resolving.SetDefinitions(definitions + (coarse ? "" : "#define VTKI_PROXY_PIXELS\n"));
  const bool resolved = this->Resolving.Run(frame.Window, target,
    [&](const vtkIndirectProgram& program)
    {
      this->Activate(input, program);
      for (int i = 0; i < this->Blended.GetNumberOfChannels(); ++i)
      {
        this->Blended.Activate(i, program);
      }
    });
  return resolved &&
    (!coarse || this->Upsample(input, definitions + "#define VTKI_PROXY_GATHER\n", image));
}

//------------------------------------------------------------------------------
bool vtkIndirectProxySums::Upsample(
  const Input& input, const std::string& definitions, vtkIndirectTarget& image)
{
  const std::string upsampling = input.Upsampling > 0
    ? "#define VTKI_UPSAMPLING " + std::to_string(input.Upsampling) + "\n"
    : std::string();
  this->Upsampling.SetDefinitions(
    definitions + upsampling + vtkIndirectReceiverGrid::DefineStep(input.Step));
  return this->Upsampling.RunOnSurfaces(input.Frame.Window, image,
    [&](const vtkIndirectProgram& program)
    {
      this->Activate(input, program);
      this->Coarse.ActivateAll(program);
    });
}

//------------------------------------------------------------------------------
void vtkIndirectProxySums::ReleaseOwn(vtkWindow*)
{
  this->Changed = true;
  this->SendersAreLit = false;
}
