// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkIndirectIlluminationPass
 * @brief Real-time indirect illumination: the pass to give to vtkRenderer::SetPass
 *
 * A frame has these stages in this order: each light's reflective shadow map, the geometry buffer
 * (VTK's own shading, shadowed light by light), virtual lights, the estimator, the composite; then
 * translucent props (with depth peeling when the renderer asks for it), FXAA, volumes and overlays
 * as in a renderer without a pass.
 *
 * The pass models what the scene needs. The delegate alone draws the picture when nothing is lit,
 * when nothing opaque is visible, and during hardware selection. A single headlight needs no map,
 * because the eye sees all surfaces that it lights. GetReport lists these decisions.
 *
 * Units: VTK's. Radiance is physical; irradiance and light strength are physical divided by pi.
 * With IndirectScale 1 and defaults otherwise the result agrees with a path tracer's diffuse
 * bounces: all bounces, hidden by depth maps of the virtual lights (NumberOfBounces, Visibility),
 * with lobes of specular senders in the first bounce. There is one bounce if a light of the scene
 * follows the camera.
 *
 * Multisampling has no effect on the colours that this pass draws: its targets are float textures.
 * Instead edges are antialiased by their shapes (Antialiasing); vtkSSAAPass around the pass takes
 * more samples. Depth of several samples is VTK's own if a prop in the scene looks it up.
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
class vtkIndirectSettingList;
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

  /**
   * Renders a frame. EndEvent follows, except after hardware selection: observers may read buffers
   * of this frame, and set passes around this one, which have not drawn yet.
   */
  void Render(const vtkRenderState* s) override;

  /** Releases all resources in the window's context; does nothing without a window. */
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
  /**
   * The sampler, which chooses virtual lights. Default null: automatic, a vtkLightTreeSampler, or
   * that of the estimator's preset (vtkIndirectEstimatorPass::SetPreset).
   */
  virtual void SetSampler(vtkVirtualLightSampler* sampler);
  vtkGetObjectMacro(Sampler, vtkVirtualLightSampler);
  ///@}

  ///@{
  /**
   * Light from all around. Default null: the renderer's environment texture if it uses image-based
   * lighting and the texture is not a cube map; else none. In this case the unoccluded diffuse
   * light that VTK's physically based shading adds from that texture is left out. The direct part
   * is summed over directions that are fixed in the world, hidden by depth maps of the scene, and
   * stored in the buffer `sky`. Light that surfaces reflect of it is summed with the reflected
   * light of lights (`bounce`). A frame with an environment needs no vtkLight. While the window's
   * rate is a frame a second or more (vtkRenderWindow::SetDesiredUpdateRate), the environment is
   * summed over a quarter of the directions, which neighbouring pixels share among them.
   */
  virtual void SetEnvironment(vtkEnvironmentLight* environment);
  vtkGetObjectMacro(Environment, vtkEnvironmentLight);
  ///@}

  ///@{
  /**
   * Rectangles that send light, in addition to the renderer's lights. Their direct light is the
   * buffer `area`: Lambert's closed form at every pixel, times the share of the light that depth
   * maps of some of its points see (Visibility none: all of it). vtkAreaLight::Method chooses
   * virtual lights instead. Surfaces reflect it: the estimator sums virtual lights of the surfaces
   * that 16 points of a single light see, or four points of each of up to four lights, or one point
   * of each of more (buffer `bounce`). Estimators that read the lights' maps themselves leave these
   * out, and the report says so. Adding a light twice has no effect.
   */
  void AddAreaLight(vtkAreaLight* light);
  void RemoveAreaLight(vtkAreaLight* light);
  void RemoveAllAreaLights();
  int GetNumberOfAreaLights();
  /** Returns an area light; null if the index is out of range. */
  vtkAreaLight* GetAreaLight(int index);
  ///@}

  ///@{
  /**
   * The opaque part of the picture. Default null: VTK's lights pass, then its opaque pass. The
   * delegate must draw the props into the framebuffer that it is given. A pass that draws them into
   * its own framebuffer, such as vtkSSAOPass or vtkShadowMapPass, gives no surfaces: after one
   * error only its picture is shown. Passes that process images (vtkSSAAPass, vtkToneMappingPass
   * and others) take this pass as their delegate. vtkSSAOPass and vtkOutlineGlowPass need the
   * output of VTK's mappers: around this pass they show their picture alone, after one error.
   */
  virtual void SetDelegatePass(vtkRenderPass* delegate);
  vtkGetObjectMacro(DelegatePass, vtkRenderPass);
  ///@}

  ///@{
  /** Return the estimator and the sampler in use, including automatic ones; never null. */
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
   * others are presets, which replace the renderer's lights while the frame is drawn, and follow
   * the camera. STUDIO has soft lobes of a sky where the lights are, SOFT and GENTLE a sky that is
   * brighter towards the lights' mean direction: there is no hard shadow. They replace as much of
   * the lights' diffuse light, GENTLE at most half of it, as leaves the picture as bright as plain
   * VTK's, 0.92 times at least, with no channel clipped that VTK does not clip; each picture
   * measures this. FULL keeps 0.6 of the lights and replaces the rest by the brightest light as a
   * key light with shadows, and by the others as lobes. FULL and STUDIO replace a headlight by a
   * key, a fill and rims of their own. The renderer's lights count if all are directional and
   * follow its camera, such as vtkLightKit's; otherwise a headlight of strength 1 replaces them.
   *
   * The kept lights are too bright where something hides them, and surfaces reflect none of their
   * light. A given Environment replaces the preset's sky, and then each preset keeps a fixed share
   * of the lights: 0.6, GENTLE 0.8; of headlights SOFT 0.4, GENTLE 0.7. Translucent props, volumes
   * and annotation keep the renderer's lights. With IndirectScale 0 there is no sky, and no preset.
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
   * Let lights cast shadows. Default on: only lit surfaces in the maps send light, so direct light
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
   * through all obstacles, and is too bright. VOXELS: the scene's voxels
   * (vtkIndirectEstimatorPass::OccupancyResolution), for all estimators, and exact spheres of
   * mappers that draw such, for all estimators but radiance hints. MAPS: a depth map of each
   * virtual light, drawn by VTK's mappers and kept while the camera moves, for estimators that sum
   * virtual lights; others use voxels. A frame draws as many maps as the window's rate allows
   * (vtkRenderWindow::SetDesiredUpdateRate), including those of the environment, and all of them in
   * a window off screen of a rate of 0.001 or less, as VTK's default of 0.0001. The number follows
   * from counts of maps, props and triangles, so that a busy machine draws the same picture. Until
   * all maps are drawn, lights share them, as directions of the environment do, and
   * the report says so. AUTO (default): maps if the estimator can use them, voxels for radiance
   * hints, none for others and with the preset PAPER.
   */
  vtkIndirectClampMacro(Visibility, int, AUTO, MAPS);
  void SetVisibilityToAuto() { this->SetVisibility(AUTO); }
  void SetVisibilityToNone() { this->SetVisibility(NONE); }
  void SetVisibilityToVoxels() { this->SetVisibility(VOXELS); }
  void SetVisibilityToMaps() { this->SetVisibility(MAPS); }
  ///@}

  ///@{
  /**
   * Antialias edges of the opaque props: where surfaces end, against any background, but not where
   * data on a surface change. Default on. If it is off, or if the renderer's FXAA,
   * vtkOpenGLFXAAPass or vtkSSAAPass replaces it, pixels stay as they were shaded, bitwise. Buffers
   * of CopyBuffer and depth are not filtered. Reshetov 2009, Jimenez et al. 2012 (SMAA): steps of
   * an outline that are up to 63 pixels long are replaced by the line that they approximate.
   * Objects thinner than a pixel stay broken; vtkSSAAPass improves these.
   */
  vtkIndirectFlagMacro(Antialiasing);
  ///@}

  ///@{
  /**
   * Texels along an edge of a light's map. Default 0: 512, or, where the estimator sums virtual
   * lights in frames of more than 384 pixels, 2.25 times as many as the frame has pixels along its
   * longer edge, as many where lights turn with the camera, rounded up to 1024 or 2048, in at most
   * 335 MB. Range 1 to 16384 besides. Larger maps make sharper shadows; the mean of the indirect
   * light does not depend on this number.
   */
  void SetReflectiveShadowMapResolution(int texels);
  int GetReflectiveShadowMapResolution();
  ///@}

  ///@{
  /**
   * A light's own size, for the penumbrae of its shadows: LightRadius, in world units, of a
   * positional light, a sphere; LightAngle, the angular radius in degrees, of a directional one
   * (the sun's is 0.27). Defaults 0: the light is a point, and its shadows are hard. Ranges 0 to
   * VTK_DOUBLE_MAX and 0 to 90; a value that is not a number becomes 0. The size belongs to the
   * light: every pass that draws with the light uses it, and it vanishes with the light.
   *
   * Visibility is the mean over 32 points of the light, each with its own depth maps, which are at
   * most as fine as ReflectiveShadowMapResolution and are kept while the camera moves. Only shadows
   * become soft: cosines, highlights, falloff and bounces are those of VTK's light, a point,
   * without bias where nothing blocks the light. A sphere that the scene reaches into is treated as
   * any other; its part beyond the scene's middle, and more than the scene's diagonal away, is cut
   * off.
   */
  static void SetLightRadius(vtkLight* light, double radius);
  static double GetLightRadius(vtkLight* light);
  static void SetLightAngle(vtkLight* light, double degrees);
  static double GetLightAngle(vtkLight* light);
  ///@}

  ///@{
  /**
   * Bounces of indirect light. Default 0: automatic. For estimators of virtual lights these are all
   * bounces that a random walk finds (128 at most; paths end by themselves where little light is
   * left), and 8 for vtkRadianceHintsPass. They are 1 where only some lights with a map follow the
   * camera, for lights that follow it with a sampler that joins no senders, and with the preset
   * PAPER of an estimator. Range 0 to 16. The report lists bounces that neither the estimator nor a
   * walk computes under left_out, with the light of bounces after a walk's last one.
   */
  vtkIndirectClampMacro(NumberOfBounces, int, 0, 16);
  ///@}

  ///@{
  /**
   * Factor on the indirect light. Default 1, the physically calibrated value; range 0 to 1e6. At 0
   * the indirect light is not computed; with Shadows also off only the delegate runs and the
   * picture is bitwise its own.
   */
  vtkIndirectClampMacro(IndirectScale, double, 0.0, 1.0e6);
  ///@}

  ///@{
  /**
   * The wanted error of the irradiance, RMS over its mean. Radiance hints choose their grid by it,
   * multiresolution splatting its thresholds, and light from the sky its directions (16 to 1024, at
   * 0 256; a quarter of them in a moving frame). A still picture is refined (NumberOfRefinements)
   * until path tracing at some of its pixels says that the error is no greater. Parameters that the
   * user has set on an estimator stay unchanged. The report has the value in use under settings,
   * and under left_out if it differs. Default 0: the estimators' own parameters are used. Range 0
   * to 1.
   */
  vtkIndirectClampMacro(ErrorTolerance, double, 0.0, 1.0);
  ///@}

  ///@{
  /**
   * Keep maps, virtual lights and irradiance while their inputs are unchanged. Default on; off for
   * timing whole frames.
   */
  vtkIndirectFlagMacro(Caching);
  ///@}

  ///@{
  /**
   * Draw only depth maps in still frames that lack some: irradiance and light of the sky are summed
   * once, in the first frame that has all maps. Default off: every frame sums with the available
   * maps. This is for pictures that are only viewed when they are complete: render while the
   * report's tiles_left is above 0. Until then the report names the waiting sums under left_out.
   * Frames of a moving camera, frames without Caching, and area lights, whose sums use the maps of
   * one round after another, do not wait.
   */
  vtkIndirectFlagMacro(MapsFirst);
  ///@}

  ///@{
  /**
   * Number of times, 0 to 3, that a still picture is refined. The first refinement sums it anew, of
   * 2048 virtual lights and as many directions of the sky, and path tracing on the processor
   * corrects it, by up to 2 million paths; the others have four and sixteen times as many paths.
   * Pictures whose light paths do not know (glass, specular senders; the report names the reason)
   * are summed of 8192 and 32768 lights instead, and those with a sky in addition. While nothing changes, each frame draws the depth
   * maps of 64 lights and directions, sums their light and traces a part of the paths, a frame of
   * IdleFrames as many as there is time for; when all of them are there, the finer picture takes
   * the place of the one before, on a screen within eight frames. A picture off screen, at an update rate of 0.001 or less, is
   * refined at once. Render while the report's batches_left is above 0. With an ErrorTolerance
   * refinement ends when the estimated error meets it.
   * Default -1, automatic: 2 on a screen, where IdleFrames draw them; 3 with a TimeBudget or an
   * ErrorTolerance; else 0.
   * This is for vtkMultiresolutionSplattingPass, the default estimator, and for lights of maps; in
   * other pictures the sky alone is refined. The report names under left_out what is not refined.
   */
  vtkIndirectClampMacro(NumberOfRefinements, int, -1, 3);
  ///@}

  ///@{
  /**
   * Seconds that a still picture may take. With it a picture is refined once, of as many virtual
   * lights as there is time for by the time of the first batches, 1024 or more, and then of as many
   * paths: at most those of NumberOfRefinements. The seconds begin with the render that completes the first picture,
   * which is drawn in any case. Pictures depend on the
   * machine's load then. Default 0: no limit, and the same picture on any machine. Range 0 to 1e6.
   */
  vtkIndirectClampMacro(TimeBudget, double, 0.0, 1.0e6);
  ///@}

  ///@{
  /**
   * Let a timer of the window's interactor draw further frames while a still picture on the screen
   * lacks depth maps or refinements; input comes between them. Default on; off for applications
   * that draw frames themselves. Interactors without timers, and windows without an interactor,
   * draw no such frames.
   */
  vtkIndirectFlagMacro(IdleFrames);
  ///@}

  ///@{
  /**
   * Take the sky, and its light that surfaces reflect, in frames of moving spheres from these
   * spheres instead of depth maps and virtual lights, as vtkProxyAccumulationPass does. Lights of
   * the renderer keep their estimator. This begins with the second successive frame in which atoms
   * (vtkMoleculeMapper), vtkOpenGLSphereMapper's spheres or glyphs that are spheres
   * (vtkGlyph3DMapper) have moved. It requires that all other casters are made of spheres or are
   * flat and convex, that the environment has no sun, and that ErrorTolerance is 0 or at least
   * 0.05. Maps return in the first frame without motion, or in the ninth such frame while the
   * window's rate is a frame a second or more. Interactors render that frame when an interaction
   * ends; after the last frame of an animation, Render once more.
   * Bonds and other sticks are rows of spheres. The report says which method made the sky and why.
   * Spheres take half of the time or less, at an RMS error over the mean of 0.05; a still frame has
   * 0.02. Default on; off for a film whose frames may take their time.
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
   * Time the stages, by wall clock and timer queries between glFinish calls, which costs some of
   * the overlap between stages. Default off. Switching it discards earlier times.
   */
  void SetTiming(bool timing);
  bool GetTiming();
  vtkBooleanMacro(Timing, bool);
  ///@}

  /**
   * Returns a report of the last frame as JSON (schema vtkindirect.report/1): settings in force;
   * what was modelled and left out and why; the alternatives in use where OpenGL decides (paths);
   * virtual lights; bytes: of the frame's textures and buffers; main_memory_bytes: of other kept
   * data that grow with the scene and the estimator's settings: voxels, triangles, hints and their
   * rays; counters since construction: shader_builds, how often VTK asked for a mapper's shader
   * source. With Timing on it has the median and 95th percentile of each stage's milliseconds over
   * the frames since, by wall clock and, if OpenGL has timer queries, by the GPU's clock.
   *   estimated_error is the RMS error of a still picture's irradiance over its mean, of all
   * bounces that NumberOfBounces asks for, with true visibility. It comes from path tracing on the
   * processor at 256 to 1024 pixels, none of them at silhouettes and creases, once for each picture
   * and only when a report asks for it; it leaves out the size of lights, glass, and specular
   * reflection between surfaces. estimatesError: false leaves the estimate out of a report that is
   * to cost nothing.
   */
  std::string GetReport(bool estimatesError = true);

  /**
   * Copies a channel of the last frame, floats, bottom row first, vectors in world coordinates,
   * lengths in world units, background 0: `final`, `direct`, `indirect` (albedo E + glossy),
   * `irradiance` (E in VTK's units: all that the pass adds to VTK's own direct light) and its parts
   * `sky`, `area` and `bounce`, `glossy`, `albedo`, `normal`, `depth` (along the view axis),
   * `specular` (reflectance, power of the lobe); `rsm<i>.depth`, `rsm<i>.normal`, `rsm<i>.density`
   * (the faces of a map in a row); `lights` (four components, one row for each virtual light:
   * position, area; normal, child distance; B A, source), `branches` (the nodes below each light,
   * 72 rows a light, with the contact softening for near receivers in place of the source) and
   * `lobes` (the specular reflection of each light: direction, exponent; flux, 0). Estimators may
   * have further channels; see their pages. Returns false, after one error, for an unknown name or
   * when the last frame has no such channel.
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
   * has it; it still receives light. Default 1 for surfaces, 0 for props that turn to the camera.
   * Lines, points and props without a surface, such as annotation, never cast shadows. SENDS_LIGHT
   * 0: the prop casts shadows and sends no indirect light. Default 1.
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
   * A property key of a prop, 1 or 0: the prop shows the background in place of itself, times the
   * light that it receives over the light that it would receive if nothing else was in the scene.
   * It thus shows the shadows on it, and the light that other surfaces send to it, and nothing
   * where there is neither. Alpha grows by the share of the background that is lost. The prop
   * writes no depth, casts no shadow and sends no light, unless CASTS_SHADOWS is 1, and neither the
   * scene's size nor maps of lights depend on it. The camera's near and far planes do not cut it
   * off. It needs lit faces of a diffuse colour other than black, and takes no part in selection
   * only where it is not pickable. Default 0.
   */
  static vtkInformationIntegerKey* CATCHES_LIGHT();

  /**
   * A property key of a prop: the name that the report and errors use for it, such as that of the
   * file that it shows. Default: none; with VTK 9.2 and later vtkObject::SetObjectName also sets a
   * name. Props without a name are distinguished by the classes of their mapper and its source.
   */
  static vtkInformationStringKey* NAME();

  ///@{
  /**
   * Further samplers, whose virtual lights are summed in addition to those of the frame's sampler:
   * a frame with one needs no vtkLight. They are for passes that add light of their own. Adding a
   * sampler twice has no effect.
   */
  void AddSampler(vtkVirtualLightSampler* sampler);
  void RemoveSampler(vtkVirtualLightSampler* sampler);
  ///@}

  ///@{
  /**
   * A mesh of fewer triangles that replaces an actor's mesh, or the coarse levels that the pass
   * makes of meshes of 20,000 triangles and more, in depth maps of the sky, of virtual lights, of
   * area lights and of penumbras, if it deviates by at most half a texel of that map; of
   * several such meshes the one with the fewest triangles is used. `error` is that deviation, both
   * ways, in lengths of the actor's mesh, at least 0, as returned by
   * vtkMeshSimplificationFilter::GetMaximumDistance. The picture and lights' own maps always have
   * the mesh itself, and so has an actor with textures, clipping planes or shaders of its own.
   * Levels are dropped when the input of the actor's mapper, or its points or cells, change. The
   * level is copied and has only triangles; adding it again replaces it. In a map it lies behind
   * the mesh by its deviation, so that the mesh does not hide itself; receivers within twice that
   * distance stay lit.
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
  vtkReflectiveShadowMapPass* ReflectiveShadowMaps; // maps pass of the pipeline
  vtkIndirectSettings Settings;
  std::string DebugView;

private:
  vtkIndirectIlluminationPass(const vtkIndirectIlluminationPass&) = delete;
  void operator=(const vtkIndirectIlluminationPass&) = delete;

  // Uses an estimator that draws its frames through this pass, without holding it.
  friend class vtkIndirectEstimatorPass;
  void BorrowEstimator(vtkIndirectEstimatorPass* estimator);

  void LetGo(vtkWindow* window);
  void ShowDebugView();
  /** Returns the settings of the estimator, the sampler and the pass, as they are in force. */
  vtkIndirectSettingList CollectSettings();
  vtkIndirectEstimatorPass* GetFrameEstimator(); // estimator of the last frame, if the next frame
                                                 // has none
  void RenderDelegate(const vtkRenderState* s, const std::string& why);
  void RefuseDelegate(const std::string& reason);
  // Warns, once, of the renderer's switches and the surrounding passes that have no effect.
  void Say(const vtkRenderState* s, const std::string& around);
  std::string GetChannelNames();

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
