// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkReflectiveShadowMapPass
 * @brief Senders: the surfaces that each light sees, and how much light they reflect
 *
 * One map a light, after Dachsbacher and Stamminger 2005, "Reflective shadow maps": a perspective
 * map for spots of up to 60 degrees half angle, the faces of a cube for wider spots (five) and
 * point lights (six), a parallel map for directional lights. All faces of all lights are layers of
 * the same array textures, so a shader that samples them needs one unit a channel:
 * - rsm.albedo, RGBA16F: diffuse reflectance (of PBR over pi, as VTK shades it)
 * - rsm.surface, RGBA32F: octahedral normal (the face's view coordinates), linear depth along its
 * axis
 * - rsm.slope, RG16F: slope of the depth, from which follows the facet's normal n_g
 * - rsm.specular, RGBA16F: specular colour and power of VTK's Phong model, for its PBR F0 and minus
 *   the roughness; exists only if senders have lobes
 * and a depth array for percentage-closer shadow look-ups.
 *
 * When the maps are sampled, albedo (n_s.l)/(n_g.l) times att(d) d^2 cone (positional lights) is
 * the reflected density. Times the texel's solid angle (directional: its area) and the light's
 * intensity it is the reflected radiance times area, B A. The density does not depend on the
 * resolution: the sum of B A over a map is the light's reflected flux at any number of texels.
 *
 * A face is drawn again only when its light's place, anything that the face can see or the
 * resolution has changed. A light's strength, falloff and exponent redraw nothing.
 */

#ifndef vtkReflectiveShadowMapPass_h
#define vtkReflectiveShadowMapPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingIndirectModule.h" // For export macro

#include <memory> // for the maps

class vtkIndirectLightMaps;

class VTKRENDERINGINDIRECT_EXPORT vtkReflectiveShadowMapPass final : public vtkOpenGLRenderPass
{
public:
  static vtkReflectiveShadowMapPass* New();
  vtkTypeMacro(vtkReflectiveShadowMapPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Texels along an edge of a map. Default 0: 512, or, where shadows are looked up and the cost of
   * bounces does not grow with the maps, the next power of two from the frame's longer edge, at
   * most 2048 and less if all maps would have more than 8 million texels. Range 1 to 16384 besides;
   * OpenGL's own limit is reported as an error when a frame is drawn. If more than six faces of all
   * maps together would have more than 32 million texels (1.3 GB with shadows: 128 faces of 512),
   * they have a half, a quarter and so on along an edge, and the report says so.
   */
  virtual void SetResolution(int texels);
  virtual int GetResolution() const { return this->Settings.Resolution; }
  ///@}

  /** Returns the number of lights that have a map in the last frame. */
  int GetNumberOfMaps() const;

  /** Draws the maps of a state's lights. */
  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkReflectiveShadowMapPass();
  ~vtkReflectiveShadowMapPass() override;

private:
  vtkReflectiveShadowMapPass(const vtkReflectiveShadowMapPass&) = delete;
  void operator=(const vtkReflectiveShadowMapPass&) = delete;

  struct SettingsType
  {
    int Resolution = 0;
  };
  SettingsType Settings;

  friend class vtkIndirectLightMaps;
  const std::unique_ptr<vtkIndirectLightMaps> Maps;
};

#endif
