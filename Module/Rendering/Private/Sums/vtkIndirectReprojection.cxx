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

// Names of a picture's uniforms: the last frame's, the key picture's.
struct Names
{
  const char* Surface;
  const char* Irradiance;
  const char* ToView;
  const char* ToClip;
  const char* RayOrigin;
  const char* RayDirection;
};
const Names OfLast = { "vtkiSurfaceBefore", "vtkiIrradianceBefore", "vtkiViewToBefore",
  "vtkiViewToClipBefore", "vtkiRayOriginBefore", "vtkiRayDirectionBefore" };
const Names OfKey = { "vtkiSurfaceOfKey", "vtkiIrradianceOfKey", "vtkiViewToKey",
  "vtkiViewToClipOfKey", "vtkiRayOriginOfKey", "vtkiRayDirectionOfKey" };

// Returns the number of the strip that a frame sums anew. Bits in reverse order: strips of
// consecutive frames lie far apart. strips: a power of two.
int FindStrip(unsigned int round, int strips)
{
  int strip = 0;
  for (int bit = 1; bit < strips; bit *= 2)
  {
    strip = 2 * strip + static_cast<int>(round % 2);
    round /= 2;
  }
  return strip;
}
}

//------------------------------------------------------------------------------
vtkIndirectReprojection::vtkIndirectReprojection(
  vtkIndirectResource* owner, int strips, bool withRadius)
  : vtkIndirectResource(owner)
  , NumberOfStrips(strips)
  , Definitions(withRadius ? "#define VTKI_REPROJECT_RADIUS\n" : "")
{
  for (Picture* picture : { &this->Last, &this->Key })
  {
    picture->Surface = std::make_unique<vtkIndirectTarget>(this, SurfaceChannels, false);
  }
}

//------------------------------------------------------------------------------
std::string vtkIndirectReprojection::GetMeaning() const
{
  return "pixels that show places of earlier frames keep the irradiance there; 1 of " +
    std::to_string(this->NumberOfStrips) + " strips of the picture is summed anew";
}

//------------------------------------------------------------------------------
bool vtkIndirectReprojection::Has(const vtkIndirectFrame& frame, double unit) const
{
  const vtkIndirectTarget& surface = *this->Last.Surface;
  return this->Last.IsThere && this->Last.Unit == unit && surface.GetWidth() == frame.Size[0] &&
    surface.GetHeight() == frame.Size[1];
}

//------------------------------------------------------------------------------
bool vtkIndirectReprojection::Keep(
  const vtkIndirectFrame& frame, const vtkIndirectGeometryBuffer& geometry, double unit)
{
  Picture& last = this->Last;
  last.IsThere = last.Surface->Resize(frame.Window, frame.Size[0], frame.Size[1]) &&
    last.Surface->CopyFrom(geometry.GetTarget(), vtkIndirectGeometryBuffer::Surface);
  last.Unit = unit;
  last.ViewToScene = frame.ViewToScene;
  last.SceneToClip = frame.FindSceneToClip();
  last.RayOrigin = glm::mat3(frame.RayOrigin);
  last.RayDirection = glm::mat3(frame.RayDirection);
  return last.IsThere;
}

//------------------------------------------------------------------------------
void vtkIndirectReprojection::Drop()
{
  for (Picture* picture : { &this->Last, &this->Key })
  {
    picture->IsThere = false;
    picture->Irradiance.reset();
  }
}

//------------------------------------------------------------------------------
void vtkIndirectReprojection::RenewKey()
{
  if (!this->Key.IsThere || ++this->FramesOfKey >= FramesPerKey)
  {
    std::swap(this->Last, this->Key);
    this->Last.IsThere = false;
    this->FramesOfKey = 0;
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectReprojection::Draw(const vtkIndirectFrame& frame,
  const vtkIndirectGeometryBuffer& geometry, vtkIndirectTarget& irradiance)
{
  this->RenewKey();
  const bool hasLast = this->Last.IsThere;
  const bool hasKey = this->Key.IsThere;
  this->Reproject.SetDefinitions(
    this->Definitions + (hasLast && hasKey ? "#define VTKI_REPROJECT_KEY\n" : ""));
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
  const auto set = [&](const Names& names, const Picture& picture)
  {
    picture.Surface->Activate(0, program, names.Surface);
    picture.Irradiance->Activate(0, program, names.Irradiance);
    const glm::mat4 toView(glm::inverse(picture.ViewToScene) * frame.ViewToScene);
    vtkIndirectSetUniform(program, names.ToView, toView);
    vtkIndirectSetUniform(
      program, names.ToClip, picture.SceneToClip * glm::mat4(frame.ViewToScene));
    vtkIndirectSetUniform(program, names.RayOrigin, picture.RayOrigin);
    vtkIndirectSetUniform(program, names.RayDirection, picture.RayDirection);
  };
  if (hasLast)
  {
    set(OfLast, this->Last);
  }
  if (hasKey)
  {
    set(hasLast ? OfKey : OfLast, this->Key);
  }
  const int strips = this->NumberOfStrips;
  const int strip = FindStrip(this->Round++, strips);
  const int rows[2] = { frame.Size[1] * strip / strips, frame.Size[1] * (strip + 1) / strips };
  program->SetUniform2i("vtkiRowsAnew", rows);
  this->Reproject.Draw();
  state->vtkglDisable(GL_DEPTH_TEST);
  irradiance.End();
  return true;
}
