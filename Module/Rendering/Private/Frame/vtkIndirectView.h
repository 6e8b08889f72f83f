// SPDX-License-Identifier: BSD-3-Clause
// What a renderer without a pass does before and after it draws its opaque props.
#ifndef vtkIndirectView_h
#define vtkIndirectView_h

#include "vtkNew.h"          // for members
#include "vtkSmartPointer.h" // for members

#include <string> // for names

class vtkLightsPass;
class vtkOpenGLFXAAFilter;
class vtkRenderState;
class vtkWindow;

class vtkIndirectView
{
public:
  vtkIndirectView();
  ~vtkIndirectView();

  /**
   * Viewport, scissor, background (as vtkCameraPass) and the lights (as vtkLightsPass). Returns
   * whether the viewport's depth has been cleared.
   */
  bool Begin(const vtkRenderState* s);

  /**
   * What antialiases the picture after this pass, or empty: the renderer's FXAA, if RenderRemaining
   * follows, or a pass that the renderer's chain of passes begins with.
   */
  static std::string FindAntialiasing(const vtkRenderState* s, bool remaining);

  /**
   * What opaque props on the picture do where VTK draws opaque ones: labels choose by the depth
   * what is seen of their places. Returns how many props were drawn.
   */
  static int RenderFlat(const vtkRenderState* s);

  /**
   * Translucent props, FXAA when the renderer asks for it, volumes and overlays, as
   * vtkOpenGLRenderer::UpdateGeometry. Returns how many props were drawn.
   */
  int RenderRemaining(const vtkRenderState* s);

  void Release(vtkWindow* window);

private:
  vtkNew<vtkLightsPass> Lights;
  vtkSmartPointer<vtkOpenGLFXAAFilter> FXAA;
};

#endif
