// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkIndirectCompositePass
 * @brief Direct light plus albedo times irradiance, and every channel of a frame as an image
 *
 * Draws over what the target holds: background, gradients and transparency stay as they are, and
 * the depth of the opaque props is written. Pixels of VTK's PBR are decoded with gamma 2.2, added
 * to and encoded again; others are linear. VTK divides PBR's diffuse reflection by pi in its
 * lights, while the irradiance here is physical over pi, so both kinds add albedo times E.
 *
 * Channels, as floats in world units and coordinates, background 0: `final`, `direct`, `indirect`
 * (albedo E + glossy), `irradiance`, `glossy` (what receivers reflect specularly), `albedo`,
 * `normal`, `depth` (along the view axis), `specular` (reflectance, and the power of the lobe in a
 * fourth component; zero where SpecularTransport computes nothing).
 */

#ifndef vtkIndirectCompositePass_h
#define vtkIndirectCompositePass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingIndirectModule.h" // For export macro

#include <memory> // for the internals
#include <string> // for names

class vtkGeometryBufferPass;
class vtkImageData;
class vtkIndirectEstimatorPass;
class vtkIndirectTarget;
class vtkReflectiveShadowMapPass;
struct vtkIndirectFrame;

class VTKRENDERINGINDIRECT_EXPORT vtkIndirectCompositePass : public vtkOpenGLRenderPass
{
public:
  static vtkIndirectCompositePass* New();
  vtkTypeMacro(vtkIndirectCompositePass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** A composite needs the other stages: this is an error. See Composite. */
  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

#ifndef __VTK_WRAP__
  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkGeometryBufferPass& Geometry;
    vtkReflectiveShadowMapPass* Maps;    // null without maps
    vtkIndirectEstimatorPass* Estimator; // of the irradiance; null for none
    double IndirectScale;
    bool DepthCleared; // of the framebuffer that is bound: nothing is drawn there yet
  };

  /** Index of a channel of the frame, or -1. */
  static int FindChannel(const std::string& name);
  /** Map and channel (0 depth, 1 normal, 2 density) of a name such as rsm0.depth. */
  static bool ParseMapChannel(const std::string& name, int& map, int& channel);
  /** Names that FindChannel and ParseMapChannel know, for messages. */
  static std::string GetChannelNames();

  /** Draws the frame into the framebuffer that is bound. */
  bool Composite(const Input& input);

  /**
   * Renders a channel into an image of this pass's own. Returns false for unknown names and maps
   * that the frame does not have.
   */
  bool RenderChannel(const Input& input, const std::string& name);
  /** The same for a buffer of the estimator's own. */
  bool RenderChannel(
    const Input& input, vtkIndirectEstimatorPass* estimator, const std::string& name);
  /** Copies that image: float, one component for lengths, three for colours and vectors,
   * four for specular. */
  void CopyImage(vtkImageData* image);
  /** Shows that image in the framebuffer that is bound. */
  bool ShowImage(const Input& input);
#endif

protected:
  vtkIndirectCompositePass();
  ~vtkIndirectCompositePass() override;

private:
  vtkIndirectCompositePass(const vtkIndirectCompositePass&) = delete;
  void operator=(const vtkIndirectCompositePass&) = delete;

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
