// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkProxyAccumulationPass
 * @brief Light of the sky, hidden and sent on by spheres that stand for what is drawn
 *
 * Sloan, Govindaraju, Nowrouzezahrai and Snyder 2007, "Image-Based Proxy Accumulation for Real-Time
 * Soft Global Illumination": at each receiver the logarithms of what each sphere leaves of the sky
 * are added in spherical harmonics of order 4; their exponential is what is seen, and its product
 * with the environment's light and the cosine (Eq 10) is the irradiance. There are no maps: what
 * moves in every frame costs no more than what stands.
 *
 * It takes the place of the sky's maps (buffer `sky`), and of virtual lights under the sky (buffer
 * `bounce`, one bounce of the sky's light; see IndirectLight). The environment is that of
 * vtkIndirectIlluminationPass. Lights of the renderer shade and cast shadows as ever, but none of
 * their light is reflected.
 *
 * *Spheres* are taken from the data in every frame: atoms (vtkMoleculeMapper),
 * vtkOpenGLSphereMapper, glyphs that are spheres (vtkGlyph3DMapper), points of
 * vtkPointGaussianMapper whose shader code cuts them off by `discard`. Bonds and other sticks of
 * vtkOpenGLStickMapper are rows of spheres that hide as much in the mean over directions. A mesh
 * that consists of spheres is these; one that is flat and convex is a polygon. For any other a
 * vtkSphereProxyFilter makes spheres, where the module IndirectProxies is loaded, or they are given
 * (SetProxies); they are kept while the mesh is the same, and move with its actor and with its
 * points.
 *
 * Where this differs from the paper, by default:
 * - Groups of spheres that are far away are summed as one (Groups): thousands of spheres cost
 *   hundreds, and logarithms of what lies behind each other stay short enough for their
 * exponential. Without them each sphere counts within InfluenceScale radii.
 * - Spheres send what others leave of the sky, not all of it (IndirectLight).
 * - What is interpolated between receivers is light by direction, not irradiance: pixels use their
 *   own normal.
 *
 * Approximations: order 4 blurs shadows (either sign); what lies behind each other within reach
 * of GroupAngle hides twice (too dark); ten or more spheres around a receiver hide too little (too
 * bright); from among dense spheres groups hide too little (sky up to 4 % too bright, up to 22 %
 * where less than a tenth of it is left), and holes between them are filled (up to 4 % too dark);
 * what spheres send is not told from what is in front of it (bounce off by 4 % RMS, up to 15 %; of
 * 1,479 atoms 16 %); bodies of fitted spheres send to the ground half of what they should; none of
 * the light that spheres send is reflected again (too dark); glyphs that are no spheres, lines and
 * points hide nothing. A sun is as broad as order 4 makes it.
 * Documentation/methods/sphere-proxies.md has figures.
 *
 * Memory: 16 bytes a pixel, twice that with IndirectLight, 64 bytes a receiver and 4 a pixel where
 * receivers are fewer than pixels, and about 270 bytes a sphere (5,469 of them, SHADOWED).
 */

#ifndef vtkProxyAccumulationPass_h
#define vtkProxyAccumulationPass_h

#include "vtkIndirectEstimatorPass.h"
#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro

class vtkPolyData;
class vtkProp;

class VTKRENDERINGINDIRECT_EXPORT vtkProxyAccumulationPass : public vtkIndirectEstimatorPass
{
public:
  static vtkProxyAccumulationPass* New();
  vtkTypeMacro(vtkProxyAccumulationPass, vtkIndirectEstimatorPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  const char* GetMethodName() const override { return "proxies"; }

  ///@{
  /**
   * Pixels from one receiver to the next: 1, or 2, 4, 8 for a quarter, a sixteenth, a sixty-fourth
   * of them, with bilateral interpolation between (Eq 11); pixels that no receiver stands for are
   * summed from scratch. 0: as many as leave about 16,000 receivers, at most 8; up to four times
   * as many receivers where that is more than the median radius of the spheres before the camera,
   * in pixels. A step is kept until radii are 0.15 beyond its limits, so that light does not
   * flicker while the camera or spheres move; another size of the picture has its own. Default 0,
   * range 0 to 16.
   */
  vtkIndirectClampMacro(ReceiverStep, int, 0, 16);
  ///@}

  ///@{
  /** Sum groups of spheres as one from afar. Default on. */
  vtkIndirectFlagMacro(Groups);
  ///@}

  ///@{
  /**
   * The largest radius of a group over its distance under which it is one. Smaller is slower, 0.2
   * by half, and hardly more exact but for receivers deep among dense spheres. Default 0.4, range
   * 0.05 to 1.
   */
  vtkIndirectClampMacro(GroupAngle, double, 0.05, 1.0);
  ///@}

  ///@{
  /**
   * Without Groups: radii within which a sphere hides light, with a smooth end over the last fifth.
   * 0: as few as cut off, of one sphere, at most 1/256 of the largest irradiance that the open
   * environment gives any normal, in each colour, wherever the sphere is and whatever the
   * receiver's normal: 16.6 under a uniform sky, 28.3 under a sun alone. The paper's 15 cut off
   * 1/209 and 1/72. What thousands of spheres lose adds up. With Groups nothing is cut off.
   * Default 0, range 0, and 2 to 1000; what is between is 2.
   */
  virtual void SetInfluenceScale(double scale);
  virtual double GetInfluenceScale() const { return this->Settings.InfluenceScale; }
  ///@}

  ///@{
  /**
   * Without Groups: radii within which a sphere sends light, and no farther than it hides light. 0:
   * as few as cut off the same share of what a white sphere sends under the open environment: 16.6
   * under a uniform sky, fewer under a sun. The paper's 4 cut off 1/15. Default 0, range 0, and 2
   * to 1000; what is between is 2.
   */
  virtual void SetIndirectInfluenceScale(double scale);
  virtual double GetIndirectInfluenceScale() const { return this->Settings.IndirectInfluenceScale; }
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
   * Light that spheres reflect of the sky: none (OFF); as if all of a sphere sent what its middle
   * sends (MIDDLE, Eq 13), or its mean over the visible disk (AVERAGED, Eq 15), or each place of it
   * what its own normal makes of the light (EXACT, Eq 17), all three as if nothing hid the sky from
   * them, and what overlaps counted once (Eq 12); or the mean of what other spheres leave of the
   * sky, found at one sphere for every two to eight, of all that spheres hide (SHADOWED). Default
   * SHADOWED.
   */
  vtkIndirectClampMacro(IndirectLight, int, OFF, EXACT);
  void SetIndirectLightToOff() { this->SetIndirectLight(OFF); }
  void SetIndirectLightToMiddle() { this->SetIndirectLight(MIDDLE); }
  void SetIndirectLightToAveraged() { this->SetIndirectLight(AVERAGED); }
  void SetIndirectLightToShadowed() { this->SetIndirectLight(SHADOWED); }
  void SetIndirectLightToExact() { this->SetIndirectLight(EXACT); }
  ///@}

  /**
   * Spheres for a prop in place of what would be found for it: points in its own coordinates with
   * the point data "Radius", such as the output of vtkSphereProxyFilter. They move with the prop,
   * and are read again when they are modified. Null: what is found for it. Data without that array
   * is an error, and nothing changes.
   */
  void SetProxies(vtkProp* prop, vtkPolyData* spheres);
  /** The spheres that SetProxies gave a prop, or null. */
  vtkPolyData* GetProxies(vtkProp* prop);
  void RemoveAllProxies();

  ///@{
  /** Number of spheres, and of flat polygons, in the last frame. */
  int GetNumberOfSpheres() const;
  int GetNumberOfPolygons() const;
  /** Pixels from one of its receivers to the next; 0 before a frame. */
  int GetActiveReceiverStep() const;
  /** Radii within which a sphere hides and sends light; 0 with Groups and before a frame. */
  double GetActiveInfluenceScale() const;
  double GetActiveIndirectInfluenceScale() const;
  ///@}

protected:
  vtkProxyAccumulationPass();
  ~vtkProxyAccumulationPass() override = default;

private:
  vtkProxyAccumulationPass(const vtkProxyAccumulationPass&) = delete;
  void operator=(const vtkProxyAccumulationPass&) = delete;

  struct SettingsType
  {
    int ReceiverStep = 0;
    bool Groups = true;
    double GroupAngle = 0.4;
    double InfluenceScale = 0.0;
    double IndirectInfluenceScale = 0.0;
    int IndirectLight = SHADOWED;
  };
  SettingsType Settings;
};

#endif
