// SPDX-License-Identifier: BSD-3-Clause
// Does the work that a renderer without a pass does before and after its opaque props.
#pragma once

#include "vtkNew.h"          // for members
#include "vtkSmartPointer.h" // for members

#include <string> // for names

class vtkLightsPass;
class vtkOpenGLFXAAFilter;
class vtkRenderState;
class vtkWindow;

class vtkIndirectRendererWork
{
public:
  vtkIndirectRendererWork();
  ~vtkIndirectRendererWork();

  /**
   * Sets up viewport, scissor, background (as vtkCameraPass) and the lights (as vtkLightsPass).
   * Returns true if the viewport's depth has been cleared.
   */
  bool Begin(const vtkRenderState* s);

  /**
   * Returns the stage that antialiases the picture after this pass, or an empty string: the
   * renderer's FXAA, if RenderRemaining follows, or a pass at the start of the renderer's chain of
   * passes.
   */
  static std::string FindAntialiasing(const vtkRenderState* s, bool remaining);

  /**
   * Draws the opaque geometry of flat props, at the time when VTK draws opaque props: labels find
   * by the depth which of their places are visible. Returns how many props were drawn.
   */
  static int RenderFlat(const vtkRenderState* s);

  /**
   * Draws translucent props, FXAA if the renderer asks for it, volumes and overlays, as
   * vtkOpenGLRenderer::UpdateGeometry. Returns how many props were drawn.
   */
  int RenderRemaining(const vtkRenderState* s);

  void Release(vtkWindow* window);

private:
  vtkNew<vtkLightsPass> Lights;
  vtkSmartPointer<vtkOpenGLFXAAFilter> FXAA;
};
