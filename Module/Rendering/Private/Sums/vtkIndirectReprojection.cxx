// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Sums/vtkIndirectReprojection.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectEyeUniforms.h"
#include "Scene/vtkIndirectFrame.h"

namespace
{
const vtkIndirectChannels SurfaceChannels = {
  { "reprojection.surface", "vtkiSurfaceBefore", "linear depth, octahedral normal and kind",
    GL_RG32F, "view", "scene units" },
};

// Returns the number of the strip that a frame sums anew. Bits in reverse order: strips of
// consecutive frames lie far apart.
int FindStrip(unsigned int round)
{
  int strip = 0;
  for (int bit = 1; bit < vtkIndirectReprojection::NumberOfStrips; bit *= 2)
  {
    strip = 2 * strip + static_cast<int>(round % 2);
    round /= 2;
  }
  return strip;
}
}

//------------------------------------------------------------------------------
vtkIndirectReprojection::vtkIndirectReprojection(vtkIndirectResource* owner, bool withRadius)
  : vtkIndirectResource(owner)
  , Surface(this, SurfaceChannels, false)
{
  this->Reproject.SetDefinitions(withRadius ? "#define VTKI_REPROJECT_RADIUS\n" : "");
}

//------------------------------------------------------------------------------
std::string vtkIndirectReprojection::Meaning()
{
  return "pixels that show places of the last frame keep the irradiance there; 1 of " +
    std::to_string(NumberOfStrips) + " strips of the picture is summed anew";
}

//------------------------------------------------------------------------------
bool vtkIndirectReprojection::Has(const vtkIndirectFrame& frame, double unit) const
{
  return this->IsThere && this->Unit == unit && this->Surface.GetWidth() == frame.Size[0] &&
    this->Surface.GetHeight() == frame.Size[1];
}

//------------------------------------------------------------------------------
bool vtkIndirectReprojection::Keep(
  const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry, double unit)
{
  this->IsThere = this->Surface.Resize(frame.Window, frame.Size[0], frame.Size[1]) &&
    this->Surface.CopyFrom(geometry.GetTarget(), vtkIndirectGeometryBuffer::Surface);
  this->Unit = unit;
  this->ViewToScene = frame.ViewToScene;
  this->SceneToClip = frame.FindSceneToClip();
  this->RayOrigin = glm::mat3(frame.RayOrigin);
  this->RayDirection = glm::mat3(frame.RayDirection);
  return this->IsThere;
}

//------------------------------------------------------------------------------
bool vtkIndirectReprojection::Draw(const vtkIndirectFrame& frame,
  const vtkIndirectGeometryBuffer& geometry, const vtkIndirectTarget& before,
  vtkIndirectTarget& irradiance)
{
  vtkIndirectProgram program = this->Reproject.Use(frame.Window);
  if (!program)
  {
    return false;
  }
  vtkOpenGLState* state = frame.Window->GetState();
  irradiance.Begin();
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthFunc(GL_ALWAYS);
  state->vtkglDepthMask(GL_TRUE);
  vtkIndirectSetEyeUniforms(program, frame);
  geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Surface, program);
  this->Surface.Activate(0, program);
  before.Activate(0, program, "vtkiIrradianceBefore");
  const glm::mat4 toBefore(glm::inverse(this->ViewToScene) * frame.ViewToScene);
  vtkIndirectSetUniform(program, "vtkiViewToBefore", toBefore);
  vtkIndirectSetUniform(
    program, "vtkiViewToClipBefore", this->SceneToClip * glm::mat4(frame.ViewToScene));
  vtkIndirectSetUniform(program, "vtkiRayOriginBefore", this->RayOrigin);
  vtkIndirectSetUniform(program, "vtkiRayDirectionBefore", this->RayDirection);
  const int strip = FindStrip(this->Round++);
  const int rows[2] = { frame.Size[1] * strip / NumberOfStrips,
    frame.Size[1] * (strip + 1) / NumberOfStrips };
  program->SetUniform2i("vtkiRowsAnew", rows);
  this->Reproject.Draw();
  state->vtkglDisable(GL_DEPTH_TEST);
  irradiance.End();
  return true;
}
