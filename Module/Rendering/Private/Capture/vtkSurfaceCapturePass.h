// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceCapturePass
 * @brief Draws surfaces into the bound target, from the eye or from a light
 *
 * The only object of the module that hooks into mappers' shaders. A light's map is a geometry
 * buffer seen from the light: one object attached to the props serves both, and a uniform tells the
 * stage. Two alternating objects would make VTK rebuild every actor's shader source twice a frame.
 *
 * From the eye it writes VTK's own shading times each light's visibility, the surface (unit normal
 * in view coordinates, linear depth, kind of shading, albedo). From a light it writes the
 * reflected density per unit light intensity, the surface and the cosine at the geometric normal.
 *
 * Visibility enters VTK's shading by a local variable that shadows the uniform lightColorN.
 * Constants in the same place let the compiler drop cones, powers and lobes that no light or
 * material of the frame has. VTK's own code is matched as text only for the cosine of a cone's
 * angle, the width of faces' edges and the declaration of an environment's irradiance; without a
 * match nothing changes, so every material of VTK keeps working.
 *
 * Approximations: PBR's diffuse part is taken as albedo (1 - metallic) / pi, without VTK's (1 - F):
 * high by the Fresnel reflectance, about 4 %.
 *
 * @sa vtkIndirectGeometryBuffer vtkReflectiveShadowMapPass
 */

#pragma once

#include "vtkOpenGLRenderPass.h"

#include <memory> // for the internals
#include <vector> // for casters

struct vtkIndirectCaster;
struct vtkIndirectDepthTile;
struct vtkIndirectFrame;
struct vtkIndirectShadowMaps;
class vtkOpenGLFramebufferObject;

class vtkSurfaceCapturePass : public vtkOpenGLRenderPass
{
public:
  static vtkSurfaceCapturePass* New();
  vtkTypeMacro(vtkSurfaceCapturePass, vtkOpenGLRenderPass);

  /**
   * Sets the pass that draws the opaque props from the eye. Default: null, all opaque props of the
   * state.
   */
  virtual void SetDelegatePass(vtkRenderPass* delegate);

  /**
   * Draws the opaque props of the state in the current stage. Unattached props are drawn as VTK
   * draws them.
   */
  void Render(const vtkRenderState* s) override;

  void ReleaseGraphicsResources(vtkWindow* window) override;

  /**
   * Number of shader sources that VTK has requested since construction. A frame in which only
   * lights, the camera or float properties changed requests none, except for a light that becomes
   * or ceases to be positional, a cone or of exponent 0 or 1, and for the scene's first or last
   * specular material.
   */
  vtkGetMacro(NumberOfShaderBuilds, vtkIdType);

  /** These are the contents of the outputs that mappers write; a change rebuilds shaders. */
  struct Outputs
  {
    bool Shadows = true; // mappers look up shadows
    // This is the specular colour and power, as a third output of the eye's stage and of light
    // maps; in light maps also F0 and minus the roughness of VTK's PBR.
    bool Specular = false;
    bool SpecularOfPBR = false; // F0 and minus the roughness in the eye's stage, too; else zero
    bool MapsOnly = false;      // programs draw maps alone, and compute no light of the view

    bool operator!=(const Outputs& other) const
    {
      return this->Shadows != other.Shadows || this->Specular != other.Specular ||
        this->SpecularOfPBR != other.SpecularOfPBR || this->MapsOnly != other.MapsOnly;
    }
  };
  void SetOutputs(const Outputs& outputs);
  const Outputs& GetOutputs() const { return this->Written; }

  /**
   * Lets VTK's physically based shading add diffuse light of the renderer's environment texture,
   * without occlusion. Default true.
   */
  void SetImageLight(bool imageLight) { this->ImageLight = imageLight; }

  vtkMTimeType GetShaderStageMTime() override { return this->SourceTime.GetMTime(); }
  bool PreReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool PostReplaceShaderValues(std::string& vertexShader, std::string& geometryShader,
    std::string& fragmentShader, vtkAbstractMapper* mapper, vtkProp* prop) override;
  bool SetShaderParameters(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop,
    vtkOpenGLVertexArrayObject* VAO = nullptr) override;

  ///@{
  /**
   * Attaches this object to those props of a frame whose surfaces it can capture, and detaches it
   * from all. Between the two calls mappers of these props write the capture's outputs.
   */
  void Attach(const vtkIndirectFrame& frame);
  void Detach();
  ///@}

  /**
   * Begins the eye's stage: draws into the first channels of the bound framebuffer, with shadows
   * from the maps unless null. Props without the capture's outputs draw only into the first
   * channel.
   */
  void BeginEye(const vtkIndirectFrame& frame, const vtkIndirectShadowMaps* shadows,
    vtkOpenGLFramebufferObject* framebuffer, int channels);
  /** Output of the next draw of unattached props from the eye; see vtkIndirectColorOnlyProp. */
  enum UnattachedChannel
  {
    Color,    // the picture
    NoSurface // a zero surface
  };
  void DrawChannel(UnattachedChannel channel);
  /**
   * Begins the stage after the eye's: draws the same again into the bound framebuffer, whose
   * colours are masked.
   */
  void BeginDepth();
  /**
   * Draws casters into a view of a map, which has this many texels along an edge. ofVTKLight: the
   * map is of a vtkLight, whose light VTK's PBR divides by pi.
   */
  void DrawMap(const vtkIndirectFrame& frame, const vtkIndirectDepthTile& view, int texels,
    const std::vector<const vtkIndirectCaster*>& casters, bool ofVTKLight = true);
  /** Ends a stage; unbinds its textures. */
  void EndStage();
  /** Returns true if the last stage drew physically based materials, whose colours are encoded. */
  bool HasEncoded() const;
  /**
   * Returns true if attached props were drawn into another framebuffer in the last stage from the
   * eye.
   */
  bool IsRedirected() const;

protected:
  vtkSurfaceCapturePass();
  ~vtkSurfaceCapturePass() override;

  vtkRenderPass* DelegatePass = nullptr;
  vtkIdType NumberOfShaderBuilds = 0;
  Outputs Written;
  bool ImageLight = true;
  vtkTimeStamp SourceTime; // time of the last change to injected text

private:
  vtkSurfaceCapturePass(const vtkSurfaceCapturePass&) = delete;
  void operator=(const vtkSurfaceCapturePass&) = delete;

  void UseEyeChannels(vtkProp* prop);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
