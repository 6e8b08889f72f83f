// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceCapturePass
 * @brief Draws surfaces into whatever target is bound, from the eye or from a light
 *
 * The only object of the module that hooks into mappers' shaders. A light's map is a geometry
 * buffer seen from the light: one object attached to the props serves both, the stage being a
 * uniform. Two objects that alternate would make VTK rebuild every actor's shader source twice a
 * frame.
 *
 * From the eye it writes VTK's own shading times each light's visibility, the surface (unit normal
 * in view coordinates, linear depth, kind of shading, albedo). From a light it writes the
 * reflected density per unit light intensity, the surface and the cosine at the geometric normal.
 *
 * Visibility enters VTK's shading by a local variable that shadows the uniform lightColorN, and
 * what the frame's lights and materials make needless (cones, powers and lobes that none of them
 * has) leaves it the same way: by constants that a compiler folds. Of VTK's own code only the
 * cosine of a cone's angle, the width of faces' edges and the declaration of an environment's
 * irradiance are matched as text, and where these are not found nothing changes, so every material
 * of VTK keeps working.
 *
 * Approximations: PBR's diffuse part is taken as albedo (1 - metallic) / pi, without VTK's (1 - F):
 * high by the Fresnel reflectance, about 4 %.
 *
 * @sa vtkIndirectGeometryBuffer vtkReflectiveShadowMapPass
 */

#ifndef vtkSurfaceCapturePass_h
#define vtkSurfaceCapturePass_h

#include "vtkOpenGLRenderPass.h"

#include <memory> // for the internals

struct vtkIndirectFrame;
struct vtkIndirectMapView;
struct vtkIndirectShadowMaps;
class vtkOpenGLFramebufferObject;

class vtkSurfaceCapturePass : public vtkOpenGLRenderPass
{
public:
  static vtkSurfaceCapturePass* New();
  vtkTypeMacro(vtkSurfaceCapturePass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Pass that draws the opaque props from the eye. Default: null, all opaque props of the state.
   */
  virtual void SetDelegatePass(vtkRenderPass* delegate);
  vtkGetObjectMacro(DelegatePass, vtkRenderPass);
  ///@}

  /**
   * Draws the opaque props of the state in the current stage. Props that are not attached are drawn
   * as VTK draws them.
   */
  void Render(const vtkRenderState* s) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * How often VTK asked for a shader source since construction. A frame in which only lights, the
   * camera or float properties changed asks for none, but for a light that becomes or ceases to be
   * positional, a cone or of exponent 0 or 1, and the scene's first or last specular material.
   */
  vtkGetMacro(NumberOfShaderBuilds, vtkIdType);

  ///@{
  /**
   * Whether mappers look shadows up. Default on. Shader sources differ, so a change rebuilds them.
   */
  void SetShadows(bool shadows);
  vtkGetMacro(Shadows, bool);
  vtkBooleanMacro(Shadows, bool);
  ///@}

  ///@{
  /**
   * Whether mappers write the specular colour and power of what the eye sees, as a third output,
   * and of what a light sees, of VTK's PBR F0 and minus the roughness.
   * Default off. Shader sources differ, so a change rebuilds them.
   */
  void SetSpecular(bool specular);
  /**
   * Whether they write F0 and minus the roughness of VTK's PBR of what the eye sees, too; off:
   * zero. Default off.
   */
  void SetSpecularOfPBR(bool specular);
  vtkGetMacro(Specular, bool);
  vtkBooleanMacro(Specular, bool);
  ///@}

  ///@{
  /**
   * Whether VTK's physically based shading adds diffuse light of the renderer's environment
   * texture, which nothing hides. Default on.
   */
  vtkSetMacro(ImageLight, bool);
  vtkGetMacro(ImageLight, bool);
  vtkBooleanMacro(ImageLight, bool);
  ///@}

  vtkMTimeType GetShaderStageMTime() override { return this->SourceTime.GetMTime(); }
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;

#ifndef __VTK_WRAP__
  ///@{
  /**
   * Attaches this object to those props of a frame whose surfaces it can capture, and detaches it
   * from those it is attached to. Between the two, mappers of these props draw with the capture's
   * outputs.
   */
  void Attach(const vtkIndirectFrame& frame);
  void Detach();
  ///@}

  /**
   * Next stage: from the eye into the first channels of a framebuffer, which is bound, with shadows
   * from the maps unless null. Whatever does not write the capture's outputs draws into the first
   * channel alone.
   */
  void BeginEye(const vtkIndirectFrame& frame, const vtkIndirectShadowMaps* shadows,
    vtkOpenGLFramebufferObject* framebuffer, int channels);
  /** What the next draw from the eye writes that is not attached; see vtkIndirectColorOnlyProp. */
  enum UnattachedChannel
  {
    Color,    // the picture
    NoSurface // zero to the surface
  };
  void DrawChannel(UnattachedChannel channel);
  /**
   * Next stage, after that of the eye: the same once more into the framebuffer that is bound, whose
   * colours are masked.
   */
  void BeginDepth();
  /** Before each prop that is drawn into a map; whether it sends light too. */
  void BeginCaster(bool sendsLight);
  /** Next stage: one face of a light's map. */
  void BeginMap(const vtkIndirectFrame& frame, const vtkIndirectMapView& map);
  /** Ends a stage; unbinds its textures. */
  void EndStage();
  /** Whether the last stage drew physically based materials, whose colours are encoded. */
  bool HasEncoded() const;
  /** Whether what is attached was drawn into another framebuffer in the last stage from the eye. */
  bool IsRedirected() const;
#endif

protected:
  vtkSurfaceCapturePass();
  ~vtkSurfaceCapturePass() override;

  vtkRenderPass* DelegatePass = nullptr;
  vtkIdType NumberOfShaderBuilds = 0;
  bool Shadows = true;
  bool Specular = false;
  bool SpecularOfPBR = false;
  bool ImageLight = true;
  vtkTimeStamp SourceTime; // of the last change to injected text

private:
  vtkSurfaceCapturePass(const vtkSurfaceCapturePass&) = delete;
  void operator=(const vtkSurfaceCapturePass&) = delete;

  void UseEyeChannels(vtkProp* prop);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
