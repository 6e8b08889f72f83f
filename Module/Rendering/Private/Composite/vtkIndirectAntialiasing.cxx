// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Composite/vtkIndirectAntialiasing.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Frame/vtkIndirectFrame.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectPointProgram.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <string>

namespace
{
// The picture comes in the format of the framebuffer that it is copied from: eight bits, or floats,
// where what is brighter than white must stay so.
const vtkIndirectChannel Pictures[][2] = {
  { { "antialiasing.picture", "vtkiPicture", "the picture before", GL_RGBA8, "view",
      "VTK radiance" },
    { nullptr, nullptr, nullptr, 0, nullptr, nullptr } },
  { { "antialiasing.picture", "vtkiPicture", "the picture before", GL_RGBA16F, "view",
      "VTK radiance" },
    { nullptr, nullptr, nullptr, 0, nullptr, nullptr } },
  { { "antialiasing.picture", "vtkiPicture", "the picture before", GL_RGBA32F, "view",
      "VTK radiance" },
    { nullptr, nullptr, nullptr, 0, nullptr, nullptr } },
};

const vtkIndirectChannel EdgeChannels[] = {
  { "antialiasing.edges", "vtkiEdges", "edges of rows and columns, 32 in a word", GL_RGBA32UI, "-",
    "bits" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};

const vtkIndirectChannel TileChannels[] = {
  { "antialiasing.tiles", "vtkiTiles", "1 where a tile has edges", GL_R32F, "-", "1" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};

// Pixels along an edge of a tile, a divisor of 32: smaller ones leave more pixels alone, larger
// ones are fewer points.
constexpr int Tile = 8;
}

//------------------------------------------------------------------------------
struct vtkIndirectAntialiasing::Internals
{
  std::unique_ptr<vtkIndirectTarget> Picture;
  unsigned int Format = 0; // of OpenGL, of the picture
  vtkIndirectTarget Edges{ EdgeChannels, false };
  vtkIndirectFullScreenProgram FindEdges{ "vtkIndirectEdgesFS.glsl" };
  vtkIndirectTarget Tiles{ TileChannels, false };
  vtkIndirectFullScreenProgram FindTiles{ "vtkIndirectEdgeTilesFS.glsl" };
  vtkIndirectPointProgram Blend{ "vtkIndirectEdgePointVS.glsl", "vtkIndirectEdgePointFS.glsl" };

  bool Refused = false; // something has been, and an error has said so
  std::string WhyNot;   // of the last frame

  bool Apply(const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry);
  // A copy of the frame's part of the framebuffer that is bound for drawing.
  bool Copy(const vtkIndirectFrame& frame)
  {
    const unsigned int format = vtkIndirectTarget::FindBoundColorFormat();
    if (this->Picture && format != this->Format)
    {
      this->Picture->Release(frame.Window);
      this->Picture = nullptr;
    }
    if (!this->Picture)
    {
      this->Format = format;
      this->Picture = std::make_unique<vtkIndirectTarget>(Pictures[format == GL_RGBA8 ? 0
                                                              : format == GL_RGBA16F  ? 1
                                                                                      : 2],
        false);
    }
    return this->Picture->Resize(frame.Window, frame.Size[0], frame.Size[1]) &&
      this->Picture->CopyBoundColor(frame.Origin);
  }
};

vtkIndirectAntialiasing::vtkIndirectAntialiasing()
  : Internal(new Internals)
{
}

vtkIndirectAntialiasing::~vtkIndirectAntialiasing() = default;

//------------------------------------------------------------------------------
void vtkIndirectAntialiasing::Apply(
  const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry)
{
  Internals& in = *this->Internal;
  // Lines of both directions lie below each other in one image.
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
  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  const int words = (std::max(frame.Size[0], frame.Size[1]) + 31) / 32 + 2;
  const int rows = frame.Size[1] + 1;
  const int tiles[2] = { (frame.Size[0] + Tile - 1) / Tile, (frame.Size[1] + Tile - 1) / Tile };
  if (!this->Copy(frame) || !this->Edges.Resize(frame.Window, words, rows + frame.Size[0] + 1) ||
    !this->Tiles.Resize(frame.Window, tiles[0], tiles[1]))
  {
    return false;
  }
  const std::string definitions = this->Format == GL_RGBA8 ? "" : "#define VTKI_FLOATS\n";
  {
    vtkOpenGLState::ScopedglScissor scissor(state);
    vtkIndirectFullScreenState kernelState(frame.Window);
    vtkShaderProgram* program = this->FindEdges.Use(frame.Window, definitions);
    if (!program)
    {
      return false;
    }
    this->Edges.Begin();
    this->Picture->Activate(0, program);
    program->SetUniform2i("vtkiSize", frame.Size);
    program->SetUniformi("vtkiRows", rows);
    this->FindEdges.Draw();
    this->Picture->Deactivate();
    this->Edges.End();
    program = this->FindTiles.Use(frame.Window);
    if (!program)
    {
      return false;
    }
    this->Tiles.Begin();
    this->Edges.Activate(0, program);
    program->SetUniformi("vtkiRows", rows);
    program->SetUniformi("vtkiTile", Tile);
    this->FindTiles.Draw();
    this->Edges.Deactivate();
    this->Tiles.End();
  }
  vtkOpenGLState::ScopedglEnableDisable depthTest(state, GL_DEPTH_TEST);
  vtkOpenGLState::ScopedglEnableDisable blend(state, GL_BLEND);
  vtkShaderProgram* program = this->Blend.Use(frame.Window, definitions);
  if (!program)
  {
    return false;
  }
  // Without the test no depth is written.
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglDisable(GL_BLEND);
  // All tiles; the scissor of the frame leaves out what is not the frame's.
  state->vtkglViewport(frame.Origin[0], frame.Origin[1], tiles[0] * Tile, tiles[1] * Tile);
  this->Picture->Activate(0, program);
  geometry.GetTarget().ActivateDepth(program, "vtkiDepth");
  this->Edges.Activate(0, program);
  this->Tiles.Activate(0, program);
  program->SetUniform2i("vtkiTileCount", tiles);
  const int edgeSize[2] = { this->Edges.GetWidth(), this->Edges.GetHeight() };
  program->SetUniform2i("vtkiEdgeSize", edgeSize);
  program->SetUniform2i("vtkiSize", frame.Size);
  program->SetUniform2i("vtkiOrigin", frame.Origin);
  program->SetUniformi("vtkiRows", rows);
  this->Blend.Draw(tiles[0] * tiles[1], Tile);
  this->Tiles.Deactivate();
  geometry.GetTarget().Deactivate();
  this->Edges.Deactivate();
  this->Picture->Deactivate();
  return true;
}

//------------------------------------------------------------------------------
size_t vtkIndirectAntialiasing::GetBytes() const
{
  const Internals& in = *this->Internal;
  return in.Edges.GetBytes() + in.Tiles.GetBytes() + (in.Picture ? in.Picture->GetBytes() : 0);
}

//------------------------------------------------------------------------------
void vtkIndirectAntialiasing::Release(vtkWindow* window)
{
  Internals& in = *this->Internal;
  in.Refused = false;
  if (in.Picture)
  {
    in.Picture->Release(window);
    in.Picture = nullptr;
  }
  in.Edges.Release(window);
  in.FindEdges.Release();
  in.Tiles.Release(window);
  in.FindTiles.Release();
  in.Blend.Release();
}
