// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkIndirectIlluminationPass
 * @brief Real-time indirect illumination: the pass to give to vtkRenderer::SetPass
 *
 * A frame is one straight line: each light's reflective shadow map, the geometry buffer (VTK's own
 * shading, shadowed light by light), virtual lights, the estimator, the composite; then translucent
 * props (with depth peeling when the renderer asks for it), FXAA, volumes and overlays as in a
 * renderer without a pass.
 *
 * The pass models what the scene needs. It leaves the picture to the delegate alone when nothing is
 * lit, when nothing opaque is visible, and during hardware selection; a single headlight needs no
 * map, because the eye sees what it lights. GetReport says what was decided.
 *
 * Units: VTK's. Radiance is physical; irradiance and light strength are physical divided by pi.
 * With IndirectScale 1 and nothing else set the result agrees with a path tracer's diffuse bounces:
 * all of them, hidden by depth maps of the virtual lights (NumberOfBounces, Visibility), with lobes
 * of specular senders in the first. Where a light of the scene follows the camera there is one.
 *
 * Multisampling has no effect on the colours that this pass draws: its targets are float textures.
 * Edges are antialiased by their shapes instead (Antialiasing). vtkSSAAPass around the pass samples
 * more. Depth of several samples is VTK's own where something in the scene looks it up.
 *
 * @code
 * vtkNew<vtkIndirectIlluminationPass> pass;
 * renderer->SetPass(pass);
 * @endcode
 */

#ifndef vtkIndirectIlluminationPass_h
#define vtkIndirectIlluminationPass_h

#include "vtkIndirectSettings.h" // for members
#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingIndirectModule.h" // For export macro

#include <memory> // for the internals
#include <string> // for names and reports

class vtkAreaLight;
class vtkEnvironmentLight;
class vtkImageData;
class vtkInformationIntegerKey;
class vtkInformationStringKey;
class vtkIndirectEstimatorPass;
class vtkLight;
class vtkPolyData;
class vtkProp;
class vtkReflectiveShadowMapPass;
class vtkVirtualLightSampler;

class VTKRENDERINGINDIRECT_EXPORT vtkIndirectIlluminationPass : public vtkOpenGLRenderPass
{
public:
  static vtkIndirectIlluminationPass* New();
  vtkTypeMacro(vtkIndirectIlluminationPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  void Render(const vtkRenderState* s) override;

  /** Gives back what the pass holds in the window's context; without a window nothing happens. */
  void ReleaseGraphicsResources(vtkWindow* window) override;

  ///@{
  /**
   * The estimator, which computes the irradiance. Default null: automatic, a
   * vtkMultiresolutionSplattingPass, the fastest for its error.
   */
  virtual void SetEstimator(vtkIndirectEstimatorPass* estimator);
  vtkGetObjectMacro(Estimator, vtkIndirectEstimatorPass);
  ///@}

  ///@{
  /** The sampler, which chooses virtual lights. Default null: automatic, a vtkLightTreeSampler. */
  virtual void SetSampler(vtkVirtualLightSampler* sampler);
  vtkGetObjectMacro(Sampler, vtkVirtualLightSampler);
  ///@}

  ///@{
  /**
   * Light from all around. Default null: the renderer's environment texture where it uses
   * image-based lighting, unless that is a cube map; else none. The diffuse light that VTK's
   * physically based shading adds of that texture, which nothing hides, is left out then. The
   * direct part is summed over directions that are fixed in the world, hidden by depth maps of the
   * scene, and stands in the buffer `sky`; what surfaces reflect of it is summed with what they
   * reflect of lights (`bounce`). A frame with an environment needs no vtkLight. While the window
   * gives a frame a second or less (vtkRenderWindow::SetDesiredUpdateRate), it is summed over a
   * quarter of the directions, of which neighbouring pixels ask different ones.
   */
  virtual void SetEnvironment(vtkEnvironmentLight* environment);
  vtkGetObjectMacro(Environment, vtkEnvironmentLight);
  ///@}

  ///@{
  /**
   * Rectangles that send light, besides the renderer's lights. What comes directly from them is the
   * buffer `area`: Lambert's closed form at every pixel, times the share of the light that depth
   * maps of some of its points see (Visibility none: all of it). Surfaces reflect it: virtual
   * lights of what four points of each light see, or one where there are more than four, are summed
   * by the estimator (buffer `bounce`); those that read the lights' maps themselves leave these
   * out, and the report says so. One that is there already is not added again.
   */
  void AddAreaLight(vtkAreaLight* light);
  void RemoveAreaLight(vtkAreaLight* light);
  void RemoveAllAreaLights();
  int GetNumberOfAreaLights();
  /** Null where there are not so many. */
  vtkAreaLight* GetAreaLight(int index);
  ///@}

  ///@{
  /**
   * The opaque part of the picture. Default null: VTK's lights pass, then its opaque pass. It must
   * draw the props into the framebuffer that it is given: of a pass that draws them into one of its
   * own, such as vtkSSAOPass or vtkShadowMapPass, no surfaces can be had, and after one error only
   * its picture is shown. Passes that process images (vtkSSAAPass, vtkToneMappingPass and others)
   * take this pass as their delegate; under vtkSSAOPass and vtkOutlineGlowPass, which need what
   * VTK's mappers draw for them, the picture is theirs alone, after one error.
   */
  virtual void SetDelegatePass(vtkRenderPass* delegate);
  vtkGetObjectMacro(DelegatePass, vtkRenderPass);
  ///@}

  ///@{
  /** The estimator and the sampler in use, the automatic ones included; never null. */
  vtkIndirectEstimatorPass* GetActiveEstimator();
  vtkVirtualLightSampler* GetActiveSampler();
  ///@}

  enum LightingType
  {
    SCENE = vtkIndirectLightingScene,
    SOFT = vtkIndirectLightingSoft,
    FULL = vtkIndirectLightingFull,
    GENTLE = vtkIndirectLightingGentle,
    STUDIO = vtkIndirectLightingStudio
  };

  ///@{
  /**
   * The lights of the opaque props. SCENE (default): the renderer's lights, and Environment. The
   * others are presets, which take the place of the renderer's lights while the frame is drawn, and
   * follow the camera. Each keeps a share of the renderer's lights as VTK draws them, without
   * shadows: 0.6, GENTLE 0.8, and where all of them are headlights SOFT 0.4, GENTLE 0.7. In place
   * of the rest SOFT and GENTLE have a sky that is brighter where these lights come from in the
   * mean: no hard shadow. FULL has the brightest as a key light with shadows, and the others as
   * soft lobes of a sky; STUDIO has all of them as lobes. In place of a headlight FULL and STUDIO
   * have a key, a fill and rims of their own. The renderer's lights are those that are directional
   * and follow its camera, such as vtkLightKit's; where it has others a headlight of strength 1
   * stands for them.
   *
   * A ball that nothing hides is 1.08 to 1.10 (GENTLE 1.04 to 1.05) times as bright as in plain
   * VTK, which makes good for light that objects hide from themselves; see the guide. The kept
   * lights are too bright where something hides them, and nothing is reflected of them. An
   * Environment that is set takes the place of the preset's sky. Translucent props, volumes and
   * annotation keep the renderer's lights. With IndirectScale 0 there is no sky, and no preset.
   */
  vtkIndirectClampMacro(Lighting, int, SCENE, STUDIO);
  void SetLightingToScene() { this->SetLighting(SCENE); }
  void SetLightingToSoft() { this->SetLighting(SOFT); }
  void SetLightingToFull() { this->SetLighting(FULL); }
  void SetLightingToGentle() { this->SetLighting(GENTLE); }
  void SetLightingToStudio() { this->SetLighting(STUDIO); }
  ///@}

  ///@{
  /**
   * Let lights cast shadows. Default on: the maps send only from lit surfaces, so direct light
   * without shadows would not match the indirect light.
   */
  vtkIndirectFlagMacro(Shadows);
  ///@}

  enum VisibilityType
  {
    AUTO = vtkIndirectVisibilityAutomatic,
    NONE = vtkIndirectVisibilityNone,
    VOXELS = vtkIndirectVisibilityVoxels,
    MAPS = vtkIndirectVisibilityMaps
  };

  ///@{
  /**
   * The test that tells whether a receiver sees a sender of indirect light. NONE: light passes
   * through whatever stands between them, and is too bright. VOXELS: the scene's voxels
   * (vtkIndirectEstimatorPass::OccupancyResolution), for all estimators, and, for all but radiance
   * hints, spheres that mappers draw as such, as they are. MAPS: a depth map of each
   * virtual light, drawn by VTK's mappers and kept while the camera moves, for estimators that sum
   * virtual lights; others take voxels. A frame draws as many as the rate that the window asks
   * for leaves it (vtkRenderWindow::SetDesiredUpdateRate), those of the environment included. That
   * is a count of maps, props and triangles, so that a busy machine draws the same picture; until
   * all are there lights share them, as directions of the environment do, and the report says so.
   * AUTO (default): voxels where the estimator's Occupancy is on, else maps where the estimator can
   * take them, else none.
   */
  vtkIndirectClampMacro(Visibility, int, AUTO, MAPS);
  void SetVisibilityToAuto() { this->SetVisibility(AUTO); }
  void SetVisibilityToNone() { this->SetVisibility(NONE); }
  void SetVisibilityToVoxels() { this->SetVisibility(VOXELS); }
  void SetVisibilityToMaps() { this->SetVisibility(MAPS); }
  ///@}

  ///@{
  /**
   * Antialias edges of the opaque props: where surfaces end, against whatever lies behind, not
   * where data on a surface does. Default on. Off, or where the renderer's FXAA,
   * vtkOpenGLFXAAPass or vtkSSAAPass takes its place, pixels are as they were shaded, bitwise.
   * Buffers of CopyBuffer and depth are not filtered. Reshetov 2009, Jimenez et al. 2012 (SMAA):
   * steps of an outline that are up to 63 pixels long are replaced by the line that they stand for;
   * what is thinner than a pixel stays broken, for which vtkSSAAPass is there.
   */
  vtkIndirectFlagMacro(Antialiasing);
  ///@}

  ///@{
  /**
   * Texels along an edge of a light's map. Default 512, range 1 to 16384. Larger maps make sharper
   * shadows; the indirect light's mean does not depend on it.
   */
  void SetReflectiveShadowMapResolution(int texels);
  int GetReflectiveShadowMapResolution();
  ///@}

  ///@{
  /**
   * A light's own size, for the penumbrae of its shadows: LightRadius, in world units, of a
   * positional light, a sphere; LightAngle, the angular radius in degrees, of a directional one
   * (the sun's is 0.27). Defaults 0: the light is a point, its shadows are hard. Ranges 0 to
   * VTK_DOUBLE_MAX and 0 to 90; what is no number is 0. It belongs to the light: every pass that
   * the light is drawn by sees it, and it goes when the light goes.
   *
   * Visibility is the mean over 32 points of the light, each with depth maps of its own, at most as
   * fine as ReflectiveShadowMapResolution says and kept while the camera moves. Only shadows become
   * soft: cosines, highlights, falloff and bounces are those of VTK's light, a point, with no bias
   * where nothing is in the way. A sphere that the scene reaches into is taken as any other; what
   * of it lies beyond the scene's middle, and more than the scene's diagonal away, is cut off.
   */
  static void SetLightRadius(vtkLight* light, double radius);
  static double GetLightRadius(vtkLight* light);
  static void SetLightAngle(vtkLight* light, double degrees);
  static double GetLightAngle(vtkLight* light);
  ///@}

  ///@{
  /**
   * Bounces of indirect light. Default 0: automatic, all that a random walk finds (128 at most;
   * paths end by themselves where little light is left) for estimators of virtual lights, as long
   * as no light with a map follows the camera; else 1. Range 0 to 16. Bounces that neither the
   * estimator nor a walk computes are listed in the report under left_out, and how much light a
   * walk leaves for bounces after its last one.
   */
  vtkIndirectClampMacro(NumberOfBounces, int, 0, 16);
  ///@}

  ///@{
  /**
   * Factor on the indirect light. Default 1, the physically calibrated value; range 0 to 1e6. At 0
   * it is not computed; with Shadows off too only the delegate runs and the picture is bitwise its
   * own.
   */
  vtkIndirectClampMacro(IndirectScale, double, 0.0, 1.0e6);
  ///@}

  ///@{
  /**
   * Error of the irradiance that is aimed at, RMS over its mean: radiance hints choose their grid
   * by it, multiresolution splatting its thresholds, light from the sky its directions (16 to 1024,
   * at 0 256; a quarter of them in a moving frame), and says what error it estimates. What the
   * user has set on an estimator stays as it is. The report has the value in force under settings,
   * and under left_out where that is another. Default 0: the estimators' own parameters hold. Range
   * 0 to 1.
   */
  vtkIndirectClampMacro(ErrorTolerance, double, 0.0, 1.0);
  ///@}

  ///@{
  /**
   * Keep maps, virtual lights and irradiance while nothing that they depend on has changed. Default
   * on; off for timing whole frames.
   */
  vtkIndirectFlagMacro(Caching);
  ///@}

  ///@{
  /**
   * Draw depth maps alone in still frames that lack some: irradiance and light of the sky are
   * summed in the first frame that has them all, once. Default off: every frame sums with the maps
   * that there are. For a picture that is only looked at when it is complete: render while the
   * report's tiles_left is above 0. Until then the report names what waits under left_out. Frames
   * of a camera that moves, frames without Caching, and area lights, whose sums take the maps of
   * one round after another, do not wait.
   */
  vtkIndirectFlagMacro(MapsFirst);
  ///@}

  ///@{
  /**
   * Take the sky, and the light of it that surfaces reflect, in frames of moving spheres from these
   * in place of depth maps and virtual lights, as vtkProxyAccumulationPass does; lights of the
   * renderer keep their estimator. From the second frame on end in which atoms
   * (vtkMoleculeMapper), vtkOpenGLSphereMapper's or glyphs that are spheres (vtkGlyph3DMapper) are
   * elsewhere than before, where all else that casts shadows is made of spheres or flat and convex,
   * the environment has no sun, and ErrorTolerance is 0 or at least 0.05. The first frame in which
   * nothing has moved has maps again, the ninth while the window gives a frame a second or less.
   * Interactors render it when an interaction ends; after the last frame of an animation, Render
   * once more.
   * Bonds and other sticks are rows of spheres. With splats that vtkPointGaussianMapper's shader
   * code cuts off by `discard`, which no map has, all frames are so, still ones too.
   * The report says by whom the sky was made and why. Half of the time or less, at an RMS error
   * over the mean of 0.05; a still frame has 0.02. Default on; off for a film whose frames may take
   * their time.
   */
  vtkIndirectFlagMacro(SpheresInMotion);
  ///@}

  ///@{
  /**
   * Draw translucent props, volumes and overlays after the composite. Default on;
   * off when other passes of the renderer's chain draw them.
   */
  vtkIndirectFlagMacro(RemainingGeometry);
  ///@}

  ///@{
  /**
   * Name of the channel to show in place of the picture; empty (default) for the picture. See
   * CopyBuffer for the names. Vectors are shown as 0.5 v + 0.5, lengths over the far plane.
   */
  vtkSetMacro(DebugView, std::string);
  vtkGetMacro(DebugView, std::string);
  ///@}

  ///@{
  /**
   * Time the stages, by wall clock and timer queries between glFinish calls, which costs a little
   * of the overlap between them. Default off. Switching it forgets earlier times.
   */
  void SetTiming(bool timing);
  bool GetTiming();
  vtkBooleanMacro(Timing, bool);
  ///@}

  /**
   * The last frame as JSON (schema vtkindirect.report/1): settings, what was modelled and left out
   * and why, which of two ways were in force where OpenGL decides (paths), virtual lights; bytes:
   * of the frame's textures and buffers; main_memory_bytes: of what is kept beside them that grows
   * with the scene and the estimator's settings: voxels, triangles, hints and their rays; counters
   * since construction: shader_builds, how often VTK asked for a mapper's shader source; and with
   * Timing on median and 95th percentile of each stage's milliseconds over the frames since, by
   * wall clock and, where OpenGL has timer queries, by the GPU's clock.
   */
  std::string GetReport();

  /**
   * Copies a channel of the last frame, floats, bottom row first, vectors in world coordinates,
   * lengths in world units, background 0: `final`, `direct`, `indirect` (albedo E + glossy),
   * `irradiance` (E in VTK's units: all that the pass adds to VTK's own direct light) and its parts
   * `sky`, `area` and `bounce`, `glossy`, `albedo`, `normal`, `depth` (along the view axis),
   * `specular` (reflectance, power of the lobe);
   * `rsm<i>.depth`, `rsm<i>.normal`, `rsm<i>.density` (the faces of a map in a row); `lights` (four
   * components, one row a virtual light: position, area; normal, reach; B A, source), `branches`
   * (what is below each, 72 rows a light, with the area by which it is blunt to near receivers in
   * place of the source) and `lobes` (what each reflects specularly: direction,
   * exponent; flux, 0).
   * An estimator may have more; see its page. Returns false, after one error, for an unknown name
   * or when the last frame has no such channel.
   */
  bool CopyBuffer(const std::string& name, vtkImageData* image);

  ///@{
  /** The lights' maps, for inspection and tests. */
  vtkGetObjectMacro(ReflectiveShadowMaps, vtkReflectiveShadowMapPass);
  ///@}

  ///@{
  /**
   * Property keys of a prop of the renderer (vtkProp::SetPropertyKeys), 1 or 0, each for one prop.
   * CASTS_SHADOWS 0: the prop casts no shadow, and sends no light either, because no light's map
   * has it; it still receives light. Default 1 of surfaces, 0 of props that turn to the camera.
   * Lines, points and what has no surface, such as annotation, never cast any. SENDS_LIGHT 0: the
   * prop casts shadows and sends no indirect light. Default 1.
   * @code
   * vtkNew<vtkInformation> keys;
   * keys->Set(vtkIndirectIlluminationPass::CASTS_SHADOWS(), 0);
   * actor->SetPropertyKeys(keys);
   * @endcode
   */
  static vtkInformationIntegerKey* CASTS_SHADOWS();
  static vtkInformationIntegerKey* SENDS_LIGHT();
  ///@}

  /**
   * A property key of a prop: the name by which the report and errors call it, such as that of the
   * file that it shows. Default: none; with VTK 9.2 and later vtkObject::SetObjectName gives one,
   * too. Props without a name are told apart by the classes of their mapper and its source.
   */
  static vtkInformationStringKey* NAME();

  ///@{
  /**
   * Further samplers, whose virtual lights are summed besides those of the frame's sampler: a frame
   * with one needs no vtkLight. For passes that bring light of their own. One that is there already
   * is not added again.
   */
  void AddSampler(vtkVirtualLightSampler* sampler);
  void RemoveSampler(vtkVirtualLightSampler* sampler);
  ///@}

  ///@{
  /**
   * A mesh of fewer triangles that stands for what an actor draws in depth maps of the sky, of
   * virtual lights, of area lights and of penumbras, wherever it is no farther off than half a
   * texel of that map; of several the one of the fewest triangles. `error` is that distance, both
   * ways, in lengths of the actor's mesh, at least 0, as
   * vtkMeshSimplificationFilter::GetMaximumDistance gives it. The picture and lights' own maps
   * always have the mesh itself, and so has an actor with textures, clipping planes or shaders of
   * its own. Levels go when the input of the actor's mapper, or its points or cells, change. The
   * level is copied; it has triangles alone; one that is added again takes its own place. In a map
   * it lies behind what it stands for by its distance, so that nothing hides itself; what it hides
   * within twice that is left bright.
   */
  void AddCoarseLevel(vtkProp* actor, vtkPolyData* level, double error);
  void RemoveCoarseLevels(vtkProp* actor);
  ///@}

protected:
  vtkIndirectIlluminationPass();
  ~vtkIndirectIlluminationPass() override;

  vtkIndirectEstimatorPass* Estimator = nullptr;
  vtkVirtualLightSampler* Sampler = nullptr;
  vtkEnvironmentLight* Environment = nullptr;
  vtkRenderPass* DelegatePass = nullptr;
  vtkReflectiveShadowMapPass* ReflectiveShadowMaps; // of the pipeline
  vtkIndirectSettings Settings;
  std::string DebugView;

private:
  vtkIndirectIlluminationPass(const vtkIndirectIlluminationPass&) = delete;
  void operator=(const vtkIndirectIlluminationPass&) = delete;

  // Takes the estimator that draws its frames through this pass, without holding it.
  friend class vtkIndirectEstimatorPass;
  void BorrowEstimator(vtkIndirectEstimatorPass* estimator);

  void LetGo(vtkWindow* window);
  void ShowDebugView();
  vtkIndirectEstimatorPass* GetFrameEstimator(); // of the last frame, without one of the next
  void RenderDelegate(const vtkRenderState* s, const std::string& why);
  void RefuseDelegate(const std::string& reason);
  // Warns, once, of the renderer's switches and the passes around that have no effect.
  void Say(const vtkRenderState* s, const std::string& around);
  std::string GetChannelNames();

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
