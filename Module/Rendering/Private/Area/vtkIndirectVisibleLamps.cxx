// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Area/vtkIndirectVisibleLamps.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Emitters/vtkIndirectEmitterAccess.h"
#include "Emitters/vtkIndirectRectangle.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <string>

namespace
{
bool IsSeen(const vtkSmartPointer<vtkAreaLight>& light)
{
  return light->GetVisible() && light->GetSwitch();
}

// Returns true if the eye is on a side that sends light.
bool IsFacing(const vtkIndirectFrame& frame, const vtkIndirectRectangle& lamp)
{
  const glm::dmat4 toWorld = glm::inverse(frame.WorldToView);
  const glm::dvec3 toEye =
    frame.Parallel ? glm::dvec3(toWorld[2]) : glm::dvec3(toWorld[3]) - lamp.Corner;
  return lamp.TwoSided || glm::dot(lamp.Normal, toEye) > 0.0;
}

// During the object's lifetime surfaces are not clipped at the near and far planes, and are drawn
// over coplanar surfaces: a lamp on a wall is visible.
struct LampState
{
  LampState()
  {
    glEnable(GL_DEPTH_CLAMP);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(-1.0f, -4.0f);
  }
  ~LampState()
  {
    glPolygonOffset(0.0f, 0.0f);
    glDisable(GL_POLYGON_OFFSET_FILL);
    glDisable(GL_DEPTH_CLAMP);
  }
  LampState(const LampState&) = delete;
  void operator=(const LampState&) = delete;
};
}

//------------------------------------------------------------------------------
int vtkIndirectVisibleLamps::Count(const Lights& lights)
{
  return static_cast<int>(std::count_if(lights.begin(), lights.end(), IsSeen));
}

//------------------------------------------------------------------------------
// Makes a texture of a light's image. A pixel of the image is a piece of one radiance: it has edges
// when seen from near by, and pixels that share a pixel of the picture give their mean.
vtkTextureObject* vtkIndirectVisibleLamps::FindPicture(
  vtkOpenGLRenderWindow* window, vtkAreaLight* light)
{
  int columns;
  int rows;
  const std::vector<float>& radiances =
    vtkIndirectEmitterAccess::GetRadiances(light, columns, rows);
  if (columns * rows == 1)
  {
    return nullptr;
  }
  Picture& picture = this->Pictures[light];
  if (picture.Light.Take({ "light", light }))
  {
    picture.Texture = vtkSmartPointer<vtkTextureObject>::New();
    picture.Texture->SetContext(window);
    picture.Texture->SetMaxLevel(1000); // all levels
    picture.Texture->SetMinificationFilter(vtkTextureObject::LinearMipmapLinear);
    picture.Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
    picture.Texture->SetWrapS(vtkTextureObject::ClampToEdge);
    picture.Texture->SetWrapT(vtkTextureObject::ClampToEdge);
    if (!picture.Texture->Create2DFromRaw(static_cast<unsigned int>(columns),
          static_cast<unsigned int>(rows), 3, VTK_FLOAT, const_cast<float*>(radiances.data())))
    {
      this->Pictures.erase(light);
      return nullptr;
    }
    picture.Texture->Bind();
    glGenerateMipmap(GL_TEXTURE_2D);
  }
  return picture.Texture;
}

//------------------------------------------------------------------------------
bool vtkIndirectVisibleLamps::DrawLamp(
  const vtkIndirectFrame& frame, vtkAreaLight* light, const vtkIndirectGeometryBuffer& geometry)
{
  const vtkIndirectRectangle place(light);
  if (!IsFacing(frame, place))
  {
    return true;
  }
  vtkTextureObject* const picture = this->FindPicture(frame.Window, light);
  vtkIndirectPointProgram& kernel = this->Kernels[picture != nullptr];
  vtkIndirectProgram program = kernel.Use(frame.Window,
    std::string(geometry.GetAlbedoDefinitions()) +
      (geometry.HasEncoded() ? "#define VTKI_ENCODED\n" : "") +
      (picture ? "#define VTKI_LAMP_IMAGE\n" : ""));
  if (!program)
  {
    return false;
  }
  float corners[4][4];
  glm::vec4 depths;
  for (int i = 0; i < 4; ++i)
  {
    const glm::dvec4 inView =
      frame.WorldToView * glm::dvec4(place.GetPlace({ i & 1, i >> 1 }), 1.0);
    const glm::vec4 inClip(frame.Projection * inView);
    std::copy(&inClip.x, &inClip.x + 4, corners[i]);
    depths[i] = static_cast<float>(-inView.z * frame.SceneScale);
  }
  program->SetUniform4fv("vtkiLampCorner", 4, corners);
  program->SetUniform4f("vtkiLampDepth", &depths.x);
  const glm::dvec3 inView = glm::dmat3(frame.WorldToView) * place.Normal;
  vtkIndirectSetUniform(program, "vtkiLampNormal", glm::vec3(glm::normalize(inView)));
  if (picture)
  {
    program.Bind(picture, "vtkiLampImage");
  }
  else
  {
    glm::dvec3 radiance;
    light->GetMeanRadiance(&radiance[0]);
    vtkIndirectSetUniform(program, "vtkiLampRadiance", glm::vec3(radiance));
  }
  kernel.DrawRectangle();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectVisibleLamps::Draw(
  const vtkIndirectFrame& frame, const Lights& lights, vtkIndirectGeometryBuffer& geometry)
{
  Lights seen;
  std::copy_if(lights.begin(), lights.end(), std::back_inserter(seen), IsSeen);
  for (auto it = this->Pictures.begin(); it != this->Pictures.end();)
  {
    const bool kept = std::find(seen.begin(), seen.end(), it->first) != seen.end();
    it = kept ? std::next(it) : this->Pictures.erase(it);
  }
  if (seen.empty())
  {
    return true;
  }
  // Lamps are drawn from back to front: beyond the far plane depth cannot order them.
  auto depth = [&](const vtkSmartPointer<vtkAreaLight>& light)
  {
    const glm::dvec3 middle = vtkIndirectRectangle(light).GetPlace(glm::dvec2(0.5));
    return (frame.WorldToView * glm::dvec4(middle, 1.0)).z;
  };
  std::stable_sort(
    seen.begin(), seen.end(), [&](const auto& a, const auto& b) { return depth(a) < depth(b); });
  return geometry.DrawMore(frame,
    [&]()
    {
      const LampState state;
      return std::all_of(seen.begin(), seen.end(),
        [&](const auto& light) { return this->DrawLamp(frame, light, geometry); });
    });
}

//------------------------------------------------------------------------------
size_t vtkIndirectVisibleLamps::GetOwnBytes() const
{
  size_t bytes = 0;
  for (const auto& picture : this->Pictures)
  {
    vtkTextureObject* const texture = picture.second.Texture;
    // The levels with means take a third more.
    bytes += static_cast<size_t>(texture->GetWidth()) * texture->GetHeight() * 16;
  }
  return bytes;
}

//------------------------------------------------------------------------------
void vtkIndirectVisibleLamps::ReleaseOwn(vtkWindow* window)
{
  for (const auto& picture : this->Pictures)
  {
    picture.second.Texture->ReleaseGraphicsResources(window);
  }
  this->Pictures.clear();
}
