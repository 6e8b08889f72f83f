// SPDX-License-Identifier: BSD-3-Clause
// Receivers: what the eye sees, as VTK shades it, with the surfaces it is made of
//
// Textures of the size of the viewport, read by the stages that follow:
// - geometry.lit, RGBA32F: VTK's own shading, each light times its visibility, premultiplied alpha;
// where all that is drawn is solid and nothing is specular, the bits of the albedo in place of
// alpha
// - geometry.surface, RGBA32F: linear depth in scene units, in bits the octahedral normal (view
// coordinates) with the kind of shading, and in bits the octahedral normal of the facet that is
// drawn
// - geometry.albedo, R32F: the bits of the albedo (of PBR times 1 - metallic), ten a channel; there
// only when the lit texels do not hold them
// - geometry.specular, RGBA16F: specular reflectance of Phong's model and the power of its lobe,
// of VTK's PBR, where that is asked for, F0 and minus the roughness; there only when the capture's
// Specular is on
// and a depth texture, of the format of the framebuffer that the frame goes to.

#ifndef vtkIndirectGeometryBuffer_h
#define vtkIndirectGeometryBuffer_h

#include "Capture/vtkIndirectGeometryChannels.h" // for its channels

#include <functional> // for what else is drawn
#include <memory>     // for the target

struct vtkIndirectFrame;
struct vtkIndirectPlan;
struct vtkIndirectShadowMaps;
class vtkIndirectFullScreenProgram;
class vtkIndirectTarget;
class vtkOpenGLRenderWindow;
class vtkRenderState;
class vtkShaderProgram;
class vtkSurfaceCapturePass;
class vtkWindow;

class vtkIndirectGeometryBuffer : public vtkIndirectGeometryChannels
{
public:
  vtkIndirectGeometryBuffer();
  ~vtkIndirectGeometryBuffer();

  /**
   * Draws the opaque props, attached to `capture`, into the buffer. shadows: where they
   * are looked up, or null for light that nothing blocks. Returns false, after an error, when
   * OpenGL refuses.
   */
  bool Update(const vtkRenderState* s, const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    vtkSurfaceCapturePass* capture, const vtkIndirectShadowMaps* shadows);

  /**
   * Draws more of what the eye sees, into the buffer as the last Update has left it: `draw` writes
   * all channels, tested by depth and not blended. Returns what it returns.
   */
  bool DrawMore(const vtkIndirectFrame& frame, const std::function<bool()>& draw);

  /**
   * Where something in the scene looks depths up, the framebuffer that is bound has several samples
   * a pixel, and nothing is drawn there yet: draws the depth of the opaque props into it, as VTK
   * does, while they are attached. Whoever looks depths up then finds VTK's own, not those of
   * pixels' centres. Returns whether it has drawn.
   */
  bool DrawDepthOfSamples(
    const vtkRenderState* s, const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture);

  const vtkIndirectTarget& GetTarget() const { return *this->Target; }
  /** Whether the lit texels of the last frame hold the albedo, and there is no channel for it. */
  bool HasAlbedoInLit() const { return IsAlbedoInLit(this->NumberOfChannels); }
  /** What shaders that include vtkIndirectAlbedo.glsl are built with, and the textures it reads. */
  const char* GetAlbedoDefinitions() const
  {
    return this->HasAlbedoInLit() ? "#define VTKI_ALBEDO_IN_ALPHA\n" : "";
  }
  void ActivateAlbedo(vtkShaderProgram* program) const;
  /** Whether the buffer may hold encoded colours. */
  bool HasEncoded() const { return this->Encoded; }
  /** Whether the last frame has the channel Specular. */
  bool HasSpecular() const { return this->NumberOfChannels > Specular; }

  int GetNumberOfRenderedProps() const { return this->NumberOfRenderedProps; }
  void Release(vtkWindow* window);

private:
  // Whether a depth of one can only be that of the clear, but for a sliver in front of the far
  // plane.
  bool DepthTellsBackground(const vtkIndirectFrame& frame) const;
  // All pixels, or those whose depth is still that of the clear. Returns false when OpenGL refuses.
  bool Clear(vtkOpenGLRenderWindow* window, bool background);

  std::unique_ptr<vtkIndirectTarget> Target;
  std::unique_ptr<vtkIndirectFullScreenProgram> ClearKernel;
  bool Encoded = false;
  int NumberOfRenderedProps = 0;
  int NumberOfChannels = 2; // of the table, from the first on
};

#endif
