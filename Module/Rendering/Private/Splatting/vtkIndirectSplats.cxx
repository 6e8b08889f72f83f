// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Splatting/vtkIndirectSplats.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Splatting/vtkIndirectSplatTable.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace
{
constexpr int RowLength = vtkIndirectSampler::RowLength;
// Lights in one draw: long draws stall a desktop, and some drivers end them.
constexpr int SplatsPerDraw = 16 * RowLength;
constexpr int TileSize = 16;

// Draws back faces that lie behind a surface, not clipped at the near and far planes, with additive
// blending. Restores the state of vtkIndirectFullScreenState.
class SplatState
{
public:
  explicit SplatState(vtkOpenGLRenderWindow* window)
    : State(window->GetState())
    , Cull(this->State, GL_CULL_FACE)
    , Mask(this->State)
    , Func(this->State)
    , Addition(window)
  {
    this->State->vtkglEnable(GL_DEPTH_TEST);
    this->State->vtkglDepthFunc(GL_GREATER);
    this->State->vtkglDepthMask(GL_FALSE);
    this->State->vtkglEnable(GL_CULL_FACE);
    this->State->vtkglCullFace(GL_FRONT);
    glEnable(GL_DEPTH_CLAMP);
  }
  ~SplatState()
  {
    glDisable(GL_DEPTH_CLAMP);
    this->State->vtkglCullFace(GL_BACK);
    this->State->vtkglDisable(GL_DEPTH_TEST);
  }
  SplatState(const SplatState&) = delete;
  void operator=(const SplatState&) = delete;

private:
  vtkOpenGLState* State;
  vtkOpenGLState::ScopedglEnableDisable Cull;
  vtkOpenGLState::ScopedglDepthMask Mask;
  vtkOpenGLState::ScopedglDepthFunc Func;
  vtkIndirectAddition Addition;
};
}

//------------------------------------------------------------------------------
bool vtkIndirectSplats::Sum(
  const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table, vtkIndirectTarget& sum)
{
  return vtkIndirectComputeProgram::IsSupported() ? SumInTiles(input, table, this->Tiles, sum)
                                                  : this->SumBlended(input, table, sum);
}

//------------------------------------------------------------------------------
bool vtkIndirectSplats::SumGlossy(const vtkIndirectEstimateInput& input,
  const vtkIndirectSplatTable& table, vtkIndirectTarget& glossy)
{
  return SumInTiles(input, table, this->GlossyTiles, glossy);
}

//------------------------------------------------------------------------------
bool vtkIndirectSplats::SumBlended(
  const vtkIndirectEstimateInput& input, const vtkIndirectSplatTable& table, vtkIndirectTarget& sum)
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  const std::string definitions =
    std::string(input.Visibility.GetDefinitions()) + input.Lights->GetDefinitions();
  sum.Begin();
  sum.Clear();
  bool done = false;
  {
    const SplatState splats(window);
    done = this->Draw(
      input, table, this->OfLights.Use(window, definitions + table.GetDefinitions(false)));
    if (done && input.Lights->HasLobes())
    {
      done = this->Draw(
        input, table, this->OfLobes.Use(window, definitions + table.GetDefinitions(true)));
    }
  }
  sum.End();
  return done;
}

//------------------------------------------------------------------------------
bool vtkIndirectSplats::Draw(const vtkIndirectEstimateInput& input,
  const vtkIndirectSplatTable& table, const vtkIndirectProgram& program)
{
  if (!program)
  {
    return false;
  }
  const vtkIndirectFrame& frame = input.Frame;
  table.Activate(input, program);
  vtkIndirectSetUniform(program, "vtkiSceneToClip", frame.FindSceneToClip());
  // Normalized device coordinates are twice depths; the surface's and the splat's are both rounded.
  program->SetUniformf(
    "vtkiDepthMargin", static_cast<float>(8.0 * input.Geometry.GetTarget().GetDepthStep()));
  const int attribute = program->FindAttributeArray("vtkiCorner");
  const int lights = input.Lights->GetNumberOfLights();
  for (int first = 0; first < lights; first += SplatsPerDraw)
  {
    program->SetUniformi("vtkiFirstLight", first);
    this->Mesh.Draw(frame.Window, attribute, false, std::min(SplatsPerDraw, lights - first));
    if (lights > SplatsPerDraw)
    {
      glFlush();
    }
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectSplats::SumInTiles(const vtkIndirectEstimateInput& input,
  const vtkIndirectSplatTable& table, vtkIndirectComputeProgram& tiles, vtkIndirectTarget& sum)
{
  const vtkIndirectFrame& frame = input.Frame;
  tiles.SetDefinitions(std::string(input.Visibility.GetDefinitions()) +
    input.Lights->GetDefinitions() + table.GetDefinitions(input.Lights->HasLobes()));
  const vtkIndirectProgram program = tiles.Use(frame.Window);
  if (!program)
  {
    return false;
  }
  table.Activate(input, program);
  if (program->IsUniformUsed("vtkiSpecular"))
  {
    input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Specular, program);
  }
  const int rows = input.Lights->GetNumberOfRows();
  const int rowsPerDraw = input.Visibility.GetMaximumNumberOfSenders() / RowLength;
  for (int row = 0; row < rows; row += rowsPerDraw)
  {
    const int block[2] = { row, std::min(row + rowsPerDraw, rows) };
    program->SetUniform2i("vtkiLightRows", block);
    program->SetUniformi("vtkiAdds", row > 0);
    tiles.AddImages(sum);
    tiles.Run(frame.Size[0], frame.Size[1], TileSize);
  }
  return true;
}
