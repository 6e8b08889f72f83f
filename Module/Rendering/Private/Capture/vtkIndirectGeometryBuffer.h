// SPDX-License-Identifier: BSD-3-Clause
// Receivers: the visible surfaces, with VTK's own shading of them
//
// Textures of the size of the viewport, read by the stages that follow:
// - geometry.lit, RGBA32F: VTK's own shading, each light times its visibility, premultiplied alpha;
// if everything is opaque and no material is specular, the bits of the albedo in place of alpha
// - geometry.surface, RGBA32F: linear depth in scene units, in bits the octahedral normal (view
// coordinates) with the kind of shading, and in bits the octahedral normal of the drawn facet
// - geometry.albedo, R32F: the bits of the albedo (of PBR times 1 - metallic), ten a channel; only
// if the lit texels do not hold them
// - geometry.specular, RGBA16F: specular reflectance of Phong's model and the power of its lobe, or
// for VTK's PBR, if requested, F0 and minus the roughness; only if the capture's Specular is on
// and a depth texture, of the format of the frame's target framebuffer.

#pragma once

#include "Capture/vtkIndirectGeometryChannels.h" // for its channels
#include "OpenGL/vtkIndirectResource.h"          // for a base class

#include <functional> // for additional draws
#include <memory>     // for the target

struct vtkIndirectFrame;
struct vtkIndirectPlan;
struct vtkIndirectShadowMaps;
class vtkIndirectFullScreenProgram;
class vtkIndirectTarget;
class vtkOpenGLRenderWindow;
class vtkRenderState;
class vtkIndirectProgram;
class vtkSurfaceCapturePass;

class vtkIndirectGeometryBuffer
  : public vtkIndirectGeometryChannels
  , public vtkIndirectResource
{
public:
  explicit vtkIndirectGeometryBuffer(vtkIndirectResource* owner = nullptr);
  ~vtkIndirectGeometryBuffer() override;

  /**
   * Draws the opaque props, attached to `capture`, into the buffer. shadows: maps for shadow
   * look-ups, or null for unshadowed light. Returns false, after an error, if OpenGL refuses.
   */
  bool Update(const vtkRenderState* s, const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    vtkSurfaceCapturePass* capture, const vtkIndirectShadowMaps* shadows);

  /**
   * Draws more surfaces into the buffer of the last Update: `draw` writes all channels, with depth
   * test and without blending. Returns the result of `draw`.
   */
  bool DrawMore(const vtkIndirectFrame& frame, const std::function<bool()>& draw);

  /**
   * Draws the depth of the opaque props into the framebuffer that is bound, as VTK does, while they
   * are attached: if something in the scene reads depths, the framebuffer has several samples a
   * pixel, and nothing has been drawn there yet. Readers of depths then find VTK's own, not those
   * of pixels' centres. Returns true if it has drawn.
   */
  bool DrawDepthOfSamples(
    const vtkRenderState* s, const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture);

  const vtkIndirectTarget& GetTarget() const { return *this->Target; }
  /**
   * Returns true if the lit texels of the last frame hold the albedo, in place of a channel of its
   * own.
   */
  bool HasAlbedoInLit() const { return IsAlbedoInLit(this->NumberOfChannels); }
  /** Definitions for shaders that include vtkIndirectAlbedo.glsl. */
  const char* GetAlbedoDefinitions() const
  {
    return this->HasAlbedoInLit() ? "#define VTKI_ALBEDO_IN_ALPHA\n" : "";
  }
  void ActivateAlbedo(const vtkIndirectProgram& program) const;
  /** Sets the eye's uniforms and binds the surfaces, for programs that compute light on them. */
  void ActivateReceivers(const vtkIndirectProgram& program, const vtkIndirectFrame& frame) const;
  /** Returns true if the buffer may hold encoded colours. */
  bool HasEncoded() const { return this->Encoded; }
  /** Returns true if the last frame has the channel Specular. */
  bool HasSpecular() const { return this->NumberOfChannels > Specular; }

  int GetNumberOfRenderedProps() const { return this->NumberOfRenderedProps; }

private:
  // Returns true if a depth of one can only be the cleared value, but for a sliver in front of the
  // far plane.
  bool DepthTellsBackground(const vtkIndirectFrame& frame) const;
  // Clears all pixels, or those whose depth is the cleared value. Returns false if OpenGL refuses.
  bool Clear(vtkOpenGLRenderWindow* window, bool background);

  std::unique_ptr<vtkIndirectTarget> Target;
  std::unique_ptr<vtkIndirectFullScreenProgram> ClearKernel;
  bool Encoded = false;
  int NumberOfRenderedProps = 0;
  int NumberOfChannels = 2; // channels of the table in use, from the first on
};
