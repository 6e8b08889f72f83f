// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkProxyAccumulationPass
 * @brief Light of the sky, occluded and reflected by spheres that represent the props
 *
 * Sloan, Govindaraju, Nowrouzezahrai and Snyder 2007, "Image-Based Proxy Accumulation for Real-Time
 * Soft Global Illumination": at each receiver the logarithms of each sphere's visibility of the sky
 * are added in spherical harmonics of order 4. Their exponential is the visible sky, and its
 * product with the environment's light and the cosine (Eq 10) is the irradiance. There are no maps:
 * props that move in every frame cost no more than still ones.
 *
 * The pass replaces the sky's maps (buffer `sky`), and virtual lights under the sky (buffer
 * `bounce`, one bounce of the sky's light; see IndirectLight). The environment is that of
 * vtkIndirectIlluminationPass. Lights of the renderer shade and cast shadows as usual, but none of
 * their light is reflected.
 *
 * *Spheres* are taken from the data in every frame: atoms (vtkMoleculeMapper),
 * vtkOpenGLSphereMapper, glyphs that are spheres (vtkGlyph3DMapper), points of
 * vtkPointGaussianMapper whose shader code cuts them off by `discard`. Bonds and other sticks of
 * vtkOpenGLStickMapper are rows of spheres that hide as much in the mean over directions. A mesh of
 * spheres is replaced by these; a flat and convex mesh is a polygon. For any other mesh a
 * vtkSphereProxyFilter makes spheres, if the module IndirectProxies is loaded, or the user gives
 * them (SetProxies). They are kept while the mesh is the same, and move with its actor and with its
 * points.
 *
 * Differences from the paper, by default:
 * - Groups of distant spheres are summed as one (Groups): thousands of spheres cost as much as
 *   hundreds, and logarithms of spheres behind each other stay small enough for their exponential.
 *   Without Groups each sphere counts within InfluenceScale radii.
 * - Spheres reflect the sky's light that other spheres let through, not all of it (IndirectLight).
 * - Receivers interpolate light by direction, not irradiance: pixels use their own normal.
 *
 * The preset PAPER (SetPreset) has the paper's choices in place of these: no groups, radii of 15
 * and 4 within which spheres hide and send light, AVERAGED light of spheres, and a receiver for
 * every sixteenth pixel with BILATERAL upsampling.
 *
 * Approximations: order 4 blurs shadows (either sign). Spheres behind each other within reach of
 * GroupAngle hide twice (too dark). Ten or more spheres around a receiver hide too little (too
 * bright). Among dense spheres groups hide too little (sky up to 4 % too bright, up to 22 % where
 * less than a tenth of it is left), and holes between them are filled (up to 4 % too dark). Spheres
 * send light through the spheres in front of them (bounce off by 4 % RMS, up to 15 %; with 1,479
 * atoms 16 %). Bodies of fitted spheres send half of the right light to the ground. The light that
 * spheres send is not reflected again (too dark). Glyphs other than spheres, lines and points hide
 * nothing. Order 4 broadens a sun. Documentation/methods/sphere-proxies.md has figures.
 *
 * Memory: 16 bytes a pixel, twice that with IndirectLight, 64 bytes a receiver and 4 a pixel if
 * there are fewer receivers than pixels, and about 270 bytes a sphere (with 5,469 spheres,
 * SHADOWED).
 */

#ifndef vtkProxyAccumulationPass_h
#define vtkProxyAccumulationPass_h

#include "vtkIndirectEstimatorPass.h"
#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro

class vtkPolyData;
class vtkProp;

class VTKRENDERINGINDIRECT_EXPORT vtkProxyAccumulationPass final : public vtkIndirectEstimatorPass
{
public:
  static vtkProxyAccumulationPass* New();
  vtkTypeMacro(vtkProxyAccumulationPass, vtkIndirectEstimatorPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetMethodName() const override { return "proxies"; }

  ///@{
  /**
   * Pixels from one receiver to the next: 1, or 2, 4, 8 for a quarter, a sixteenth, a sixty-fourth
   * of them, with bilateral interpolation between (Eq 11); pixels that no receiver represents are
   * summed from scratch. 0: as many as leave about 16,000 receivers, at most 8; up to four times as
   * many receivers if the step exceeds the median radius of the spheres before the camera, in
   * pixels. A step is kept until radii are 0.15 beyond its limits, so that light does not flicker
   * while the camera or spheres move; another size of the picture has its own step. The report has
   * the step in force. Default 0, range 0 to 16.
   */
  vtkIndirectClampMacro(ReceiverStep, int, 0, 16);
  ///@}

  ///@{
  /** Sum distant groups of spheres as one. Default on. */
  vtkIndirectFlagMacro(Groups);
  ///@}

  ///@{
  /**
   * The largest ratio of a group's radius to its distance at which it is summed as one. A smaller
   * ratio is slower, 0.2 by half, and hardly more exact, except for receivers deep among dense
   * spheres. Default 0.4, range 0.05 to 1.
   */
  vtkIndirectClampMacro(GroupAngle, double, 0.05, 1.0);
  ///@}

  ///@{
  /**
   * Without Groups: radii within which a sphere hides light, with a smooth end over the last
   * fifth. 0: the smallest number that cuts off, for one sphere, at most 1/256 of the largest
   * irradiance that the open environment gives any normal, in each colour, for any place of the
   * sphere and any normal of the receiver: 16.6 under a uniform sky, 28.3 under a sun alone. The
   * paper's 15 cut off 1/209 and 1/72. The losses of thousands of spheres add up. With Groups
   * nothing is cut off. Default 0, range 0, and 2 to 1000; values between become 2.
   */
  virtual void SetInfluenceScale(double scale);
  virtual double GetInfluenceScale() const { return this->Settings.InfluenceScale; }
  ///@}

  ///@{
  /**
   * Without Groups: radii within which a sphere sends light, no larger than those within which it
   * hides light. 0: the smallest number that cuts off the same share of a white sphere's light
   * under the open environment: 16.6 under a uniform sky, fewer under a sun. The paper's 4 cut off
   * 1/15. Default 0, range 0, and 2 to 1000; values between become 2.
   */
  virtual void SetIndirectInfluenceScale(double scale);
  virtual double GetIndirectInfluenceScale() const { return this->Settings.IndirectInfluenceScale; }
  ///@}

  enum UpsamplingType
  {
    PLANES = 0,
    BILATERAL = 1,
    BILINEAR = 2
  };

  ///@{
  /**
   * Chooses what pixels between receivers interpolate. PLANES: light by direction, from receivers
   * whose planes and normals agree, so that pixels use their own normal. BILATERAL: irradiance,
   * weighted by the power 32 of the normals' cosine and by the difference of depths (Eq 11).
   * BILINEAR: irradiance of all receivers around, which draws fringes along edges (Figure 7).
   * Default PLANES.
   */
  vtkIndirectClampMacro(Upsampling, int, PLANES, BILINEAR);
  void SetUpsamplingToPlanes() { this->SetUpsampling(PLANES); }
  void SetUpsamplingToBilateral() { this->SetUpsampling(BILATERAL); }
  void SetUpsamplingToBilinear() { this->SetUpsampling(BILINEAR); }
  ///@}

  enum IndirectLightType
  {
    OFF = 0,
    MIDDLE = 1,
    AVERAGED = 2,
    SHADOWED = 3,
    EXACT = 4
  };

  ///@{
  /**
   * Light that spheres reflect of the sky. OFF: none. MIDDLE (Eq 13): all of a sphere sends its
   * middle's light. AVERAGED (Eq 15): it sends the mean over the visible disk. EXACT (Eq 17): each
   * place sends light by its own normal. All three ignore what hides the sky from spheres, and
   * count overlaps once (Eq 12). SHADOWED: spheres send the mean light of the sky that other
   * spheres let through, found at one sphere for every two to eight, from all directions that
   * spheres hide. Default SHADOWED.
   */
  vtkIndirectClampMacro(IndirectLight, int, OFF, EXACT);
  void SetIndirectLightToOff() { this->SetIndirectLight(OFF); }
  void SetIndirectLightToMiddle() { this->SetIndirectLight(MIDDLE); }
  void SetIndirectLightToAveraged() { this->SetIndirectLight(AVERAGED); }
  void SetIndirectLightToShadowed() { this->SetIndirectLight(SHADOWED); }
  void SetIndirectLightToExact() { this->SetIndirectLight(EXACT); }
  ///@}

  /**
   * Sets spheres for a prop that replace those found for it: points in its own coordinates with the
   * point data "Radius", such as the output of vtkSphereProxyFilter. They move with the prop, and
   * are read again when they are modified. Null: the spheres found for it. Data without that array
   * cause an error, and nothing changes.
   */
  void SetProxies(vtkProp* prop, vtkPolyData* spheres);
  /** Returns the spheres that SetProxies gave a prop, or null. */
  vtkPolyData* GetProxies(vtkProp* prop);
  void RemoveAllProxies();

  ///@{
  /** Return the number of spheres, and of flat polygons, in the last frame. */
  int GetNumberOfSpheres() const;
  int GetNumberOfPolygons() const;
  ///@}

protected:
  vtkProxyAccumulationPass();
  ~vtkProxyAccumulationPass() override = default;

  void ApplyPreset() override;

private:
  vtkProxyAccumulationPass(const vtkProxyAccumulationPass&) = delete;
  void operator=(const vtkProxyAccumulationPass&) = delete;

  struct SettingsType
  {
    int ReceiverStep = 0;
    int Upsampling = PLANES;
    bool Groups = true;
    double GroupAngle = 0.4;
    double InfluenceScale = 0.0;
    double IndirectInfluenceScale = 0.0;
    int IndirectLight = SHADOWED;
  };
  SettingsType Settings;
};

#endif
