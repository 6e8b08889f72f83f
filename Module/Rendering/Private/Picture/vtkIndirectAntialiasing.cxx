// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Picture/vtkIndirectAntialiasing.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectPointProgram.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <string>

namespace
{
// The picture has the format of the framebuffer that it is copied from: eight bits, or floats,
// which keep values above white.
vtkIndirectChannels MakePicture(unsigned int format)
{
  return { { "antialiasing.picture", "vtkiPicture", "the picture before", format, "view",
    "VTK radiance" } };
}
const vtkIndirectChannels Pictures[] = { MakePicture(GL_RGBA8), MakePicture(GL_RGBA16F),
  MakePicture(GL_RGBA32F) };

const vtkIndirectChannels ContrastChannels = {
  { "antialiasing.contrasts", "vtkiContrasts", "contrasts with the left and the lower neighbour",
    GL_RGBA8, "view", "1" },
};

const vtkIndirectChannels EdgeChannels = {
  { "antialiasing.edges", "vtkiEdges", "edges of rows and columns, 32 in a word", GL_RGBA32UI, "-",
    "bits" },
};

const vtkIndirectChannels TileChannels = {
  { "antialiasing.tiles", "vtkiTiles", "1 where a tile has contrasts, then edges", GL_R32F, "-",
    "1" },
};

// Pixels along an edge of a tile, a divisor of 32: smaller tiles skip more pixels, larger tiles are
// fewer points.
constexpr int Tile = 8;
}

//------------------------------------------------------------------------------
struct vtkIndirectAntialiasing::Internals : vtkIndirectResource
{
  using vtkIndirectResource::vtkIndirectResource;
  void ReleaseOwn(vtkWindow*) override
  {
    this->Refused = false;
    this->Picture.reset();
  }

  std::unique_ptr<vtkIndirectTarget> Picture;
  unsigned int Format = 0; // OpenGL format of the picture
  vtkIndirectTarget Contrasts{ this, ContrastChannels, false };
  vtkIndirectFullScreenProgram FindContrasts{ this, "vtkIndirectContrastFS.glsl" };
  vtkIndirectFullScreenProgram FindContrastTiles{ this, "vtkIndirectContrastTilesFS.glsl" };
  vtkIndirectPointProgram KeepOutlines{ this, "vtkIndirectEdgePointVS.glsl",
    "vtkIndirectOutlinePointFS.glsl" };
  vtkIndirectTarget Edges{ this, EdgeChannels, false };
  vtkIndirectFullScreenProgram FindEdges{ this, "vtkIndirectEdgesFS.glsl" };
  vtkIndirectTarget Tiles{ this, TileChannels, false };
  vtkIndirectFullScreenProgram FindTiles{ this, "vtkIndirectEdgeTilesFS.glsl" };
  vtkIndirectPointProgram Blend{ this, "vtkIndirectEdgePointVS.glsl",
    "vtkIndirectEdgePointFS.glsl" };

  bool Refused = false; // OpenGL has refused, and an error was reported
  std::string WhyNot;   // reason of the last frame

  // Sizes and shader definitions of all stages of a frame.
  int Rows = 0; // rows of the edges' image before those of columns
  int TileCount[2] = { 0, 0 };
  std::string Definitions;

  bool Apply(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry);
  bool FindOutlines(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry);
  bool FindEdgeWords(const vtkIndirectFrame& frame);
  bool BlendEdges(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry);

  // Sets the uniforms of a program that draws one point for each tile.
  void SetTileUniforms(
    const vtkIndirectProgram& program, const vtkIndirectFrame& frame, const int origin[2])
  {
    this->Tiles.Activate(0, program);
    program->SetUniform2i("vtkiTileCount", this->TileCount);
    const int edgeSize[2] = { this->Edges.GetWidth(), this->Edges.GetHeight() };
    program->SetUniform2i("vtkiEdgeSize", edgeSize);
    program->SetUniform2i("vtkiSize", frame.Size);
    program->SetUniform2i("vtkiOrigin", origin);
    program->SetUniformi("vtkiRows", this->Rows);
  }

  // Copies the frame's part of the framebuffer that is bound for drawing.
  bool Copy(const vtkIndirectFrame& frame)
  {
    const unsigned int format = vtkIndirectTarget::FindBoundColorFormat();
    if (!this->Picture || format != this->Format)
    {
      this->Format = format;
      this->Picture = std::make_unique<vtkIndirectTarget>(this,
        Pictures[format == GL_RGBA8 ? 0
            : format == GL_RGBA16F  ? 1
                                    : 2],
        false);
    }
    return this->Picture->Resize(frame.Window, frame.Size[0], frame.Size[1]) &&
      this->Picture->CopyBoundColor(frame.Origin);
  }
};

vtkIndirectAntialiasing::vtkIndirectAntialiasing(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Internal(new Internals(this))
{
}

vtkIndirectAntialiasing::~vtkIndirectAntialiasing() = default;

//------------------------------------------------------------------------------
void vtkIndirectAntialiasing::Apply(
  const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry)
{
  Internals& in = *this->Internal;
  // The lines of both directions lie one below the other in one image.
  const int lines = frame.Size[0] + frame.Size[1] + 2;
  const int most = vtkTextureObject::GetMaximumTextureSize(frame.Window);
  if (lines > most)
  {
    const std::string why = "width and height of the picture are " + std::to_string(frame.Size[0]) +
      " and " + std::to_string(frame.Size[1]) + " pixels; together they may be " +
      std::to_string(most - 2) + " with this OpenGL";
    if (why != in.WhyNot)
    {
      vtkErrorWithObjectMacro(frame.Window, "Edges are not antialiased: " << why << ".");
    }
    in.WhyNot = why;
    return;
  }
  in.Refused = in.Refused || !in.Apply(frame, geometry);
  in.WhyNot = in.Refused ? "this OpenGL refuses what it takes" : "";
}

//------------------------------------------------------------------------------
const std::string& vtkIndirectAntialiasing::GetWhyNot() const
{
  return this->Internal->WhyNot;
}

//------------------------------------------------------------------------------
bool vtkIndirectAntialiasing::Internals::Apply(
  const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry)
{
  vtkOpenGLState::ScopedglViewport viewport(frame.Window->GetState());
  const int words = (std::max(frame.Size[0], frame.Size[1]) + 31) / 32 + 2;
  this->Rows = frame.Size[1] + 1;
  for (int i = 0; i < 2; ++i)
  {
    this->TileCount[i] = (frame.Size[i] + Tile - 1) / Tile;
  }
  if (!this->Copy(frame) || !this->Contrasts.Resize(frame.Window, frame.Size[0], frame.Size[1]) ||
    !this->Edges.Resize(frame.Window, words, this->Rows + frame.Size[0] + 1) ||
    !this->Tiles.Resize(frame.Window, this->TileCount[0], this->TileCount[1]))
  {
    return false;
  }
  this->Definitions = this->Format == GL_RGBA8 ? "" : "#define VTKI_FLOATS\n";
  return this->FindOutlines(frame, geometry) && this->FindEdgeWords(frame) &&
    this->BlendEdges(frame, geometry);
}

//------------------------------------------------------------------------------
// Finds visible contrasts, then multiplies those that are no outline by zero: surfaces are examined
// only in tiles with a contrast.
bool vtkIndirectAntialiasing::Internals::FindOutlines(
  const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkIndirectFullScreenState kernelState(frame.Window);
  this->FindContrasts.SetDefinitions(this->Definitions);
  const bool found = this->FindContrasts.Run(frame.Window, this->Contrasts,
    [&](const vtkIndirectProgram& program)
    {
      this->Picture->Activate(0, program);
      program->SetUniform2i("vtkiSize", frame.Size);
    });
  const bool divided = this->FindContrastTiles.Run(frame.Window, this->Tiles,
    [&](const vtkIndirectProgram& program)
    {
      this->Contrasts.Activate(0, program);
      program->SetUniform2i("vtkiSize", frame.Size);
      program->SetUniformi("vtkiTile", Tile);
    });
  const vtkIndirectProgram program = this->KeepOutlines.Use(frame.Window, "");
  if (!found || !divided || !program)
  {
    return false;
  }
  this->Contrasts.Begin();
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ZERO, GL_SRC_COLOR, GL_ZERO, GL_ZERO);
  // All tiles; the last may extend beyond the image.
  state->vtkglViewport(0, 0, this->TileCount[0] * Tile, this->TileCount[1] * Tile);
  geometry.GetTarget().ActivateDepth(program, "vtkiDepth");
  geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Surface, program);
  const int origin[2] = { 0, 0 };
  this->SetTileUniforms(program, frame, origin);
  this->KeepOutlines.Draw(this->TileCount[0] * this->TileCount[1], Tile);
  this->Contrasts.End();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectAntialiasing::Internals::FindEdgeWords(const vtkIndirectFrame& frame)
{
  vtkIndirectFullScreenState kernelState(frame.Window);
  const bool found = this->FindEdges.Run(frame.Window, this->Edges,
    [&](const vtkIndirectProgram& program)
    {
      this->Contrasts.Activate(0, program);
      program->SetUniform2i("vtkiSize", frame.Size);
      program->SetUniformi("vtkiRows", this->Rows);
    });
  return found &&
    this->FindTiles.Run(frame.Window, this->Tiles,
      [&](const vtkIndirectProgram& program)
      {
        this->Edges.Activate(0, program);
        program->SetUniformi("vtkiRows", this->Rows);
        program->SetUniformi("vtkiTile", Tile);
      });
}

//------------------------------------------------------------------------------
bool vtkIndirectAntialiasing::Internals::BlendEdges(
  const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry)
{
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkIndirectProgram program = this->Blend.Use(frame.Window, this->Definitions);
  if (!program)
  {
    return false;
  }
  // Disabling the test also disables writing depth.
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  // All tiles; the frame's scissor removes pixels outside the frame.
  state->vtkglViewport(
    frame.Origin[0], frame.Origin[1], this->TileCount[0] * Tile, this->TileCount[1] * Tile);
  this->Picture->Activate(0, program);
  geometry.GetTarget().ActivateDepth(program, "vtkiDepth");
  this->Edges.Activate(0, program);
  this->SetTileUniforms(program, frame, frame.Origin);
  this->Blend.Draw(this->TileCount[0] * this->TileCount[1], Tile);
  return true;
}
