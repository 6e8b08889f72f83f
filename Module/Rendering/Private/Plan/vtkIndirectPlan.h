// SPDX-License-Identifier: BSD-3-Clause
// The plan of a frame: which light it draws and by which methods, and the reasons. It is made once,
// before anything is drawn, from the facts of the scene, the user's settings and the estimator's
// abilities. It holds no OpenGL and no VTK objects. Stages read it and make no such decisions
// themselves.
#pragma once

#include "OpenGL/vtkIndirectKey.h" // for keys
#include "vtkIndirectSettings.h"   // for the user's settings

#include <string>  // for reasons
#include <utility> // for pairs
#include <vector>  // for lists

struct vtkIndirectFrame;

/** These are the abilities and settings of the frame's estimator. */
struct vtkIndirectAbilities
{
  std::string Name = "an estimator"; // for reasons
  int MaximumNumberOfBounces = 1;
  bool ComputesGlossy = false;
  bool SumsLobes = false;    // lobes of senders
  bool TakesSampler = false; // sums lights of the frame's sampler, not of its own sampler
  bool SpecularTransport = true;
  bool TakesLightMaps = false; // can look visibility up in a map of each virtual light
  bool Refines = false;        // can sum lights in batches: its images have a value for each pixel
  /** Visibility AUTO means this one, unless the preset is PAPER. */
  int AutomaticVisibility = vtkIndirectVisibilityNone;
  /** It is true with the preset PAPER: automatic bounces are one, and automatic visibility is none.
   */
  bool IsOfPaper = false;
  /** Sums the texels of lights' maps, if there are maps, and no virtual lights beside them. */
  bool ReadsMaps = false;
  /** Sums the sky, and the light that surfaces reflect of it, itself, and no lights. */
  bool SumsSky = false;
  /**
   * This is the tolerance that its parameters follow for the wanted tolerance; 0: no parameter
   * follows one.
   */
  double ErrorTolerance = 0.0;
};

/** These are further facts about the renderer and the pass. */
struct vtkIndirectCircumstances
{
  bool OwnDelegate = false;      // the surfaces of the user's own delegate are unknown
  std::string DelegateIsRefused; // the reason why the delegate gives no surfaces; empty: it gives
                                 // them
  int NumberOfOtherEmitters = 0; // sources of light other than vtkLight
  /** The estimator sums lights of a sampler that finds lights of all bounces by rays. */
  bool SamplerWalks = false;
  bool OtherSamplerWalks = false;   // an additional sampler finds lights by rays
  bool SamplerTakesSenders = false; // the estimator sums lights of a sampler that joins senders
  bool AreaLights = false;          // there are rectangular lights
  ///@{
  /** It is true if some lights of this Method shine. */
  bool AutomaticAreaLights = false;
  bool ClosedAreaLights = false;
  bool VirtualAreaLights = false;
  ///@}
  /**
   * This is the VTK irradiance of a surface in the middle of the scene that faces all area lights.
   */
  double AreaLightIrradiance = 0.0;
  int VisibleAreaLights = 0;     // number of area lights that are visible themselves
  bool Environment = false;      // light comes from all around
  bool EnvironmentTurns = false; // it turns with the camera
  /**
   * This is the VTK irradiance of a surface that receives all of the environment's light at a right
   * angle.
   */
  double EnvironmentIrradiance = 0.0;
  ///@{
  /**
   * SpheresMove: the casters with spheres that have moved in successive frames, in words; empty if
   * there are none. SpheresFail: why spheres cannot represent everything that hides the sky; empty
   * if they can.
   */
  std::string SpheresMove;
  std::string SpheresFail;
  ///@}
  bool ImageBasedLighting = false; // VTK adds the unoccluded light of the renderer's texture
  std::string OtherAntialiasing;   // name of the stage that antialiases the picture after the pass;
                                   // empty: none
  /**
   * Frames a second that the window asks for: vtkRenderWindow's DesiredUpdateRate, by default that
   * of a still picture; the application sets it. The duration of frames does not count: a busy
   * machine draws the same picture as an idle one.
   */
  double UpdateRate = 0.0001;
  /** The window shows nothing on a screen: nobody sees how its pictures are completed. */
  bool OffScreen = false;
  /** The window's interactor draws further frames of a still picture. */
  bool IdleFrames = false;
  bool IsIdleFrame = false; // a timer of the interactor draws this frame
};

struct vtkIndirectPlan
{
  using Entries = std::vector<std::pair<std::string, std::string>>; // subject, reason

  enum SenderType
  {
    NO_SENDERS, // no vtkLight sends anything
    MAPS,       // surfaces that lights see, in their maps
    HEADLIGHT,  // surfaces that the eye sees, whose headlight is the only light
    RAYS        // surfaces that the sampler's rays meet; there are no maps
  };

  /**
   * Empty: indirect light is computed or could be; otherwise the reason why the delegate alone
   * draws.
   */
  std::string WhyDelegate;
  int Senders = NO_SENDERS;
  /** Lights with a map: places in vtkIndirectFrame::Lights. */
  std::vector<int> MapLights;
  /** Texels along an edge of a map where the user leaves the number to the pass. */
  int MapTexels = 512;
  bool Shadows = false;             // mappers look up shadows in these maps
  bool Specular = false;            // estimators reflect specularly
  bool SurfacesAreSpecular = false; // the geometry buffer holds the data for that
  bool SendersAreSpecular = false;  // some senders are specular
  bool Refraction = false;          // bodies of glass send the light that passes through them
  bool SenderLobes = false;         // maps hold the specular reflections of senders
  bool AlbedoInAlpha = false;       // alpha has no meaning, and holds the albedo
  bool Antialiasing = false;        // edges of the composed picture are antialiased
  enum SkySourceType
  {
    SKY_BY_MAPS,     // depth maps, and virtual lights of its bounce
    SKY_BY_SPHERES,  // spheres that represent the props, with bounces, beside an estimator
    SKY_BY_ESTIMATOR // the estimator sums the sky itself, and nothing is added
  };

  /**
   * It is true if there is irradiance to estimate other than that of an estimator that sums the sky
   * itself. If there is no irradiance of any kind, WhyNoIrradiance has the reason.
   */
  bool Irradiance = false;
  std::string WhyNoIrradiance;
  int Visibility = vtkIndirectVisibilityNone; // of senders from receivers; never automatic
  ///@{
  /**
   * This is the light that comes directly from the environment. This frame and a still one have
   * their numbers of directions; a pixel sums one of SkyBlock squared subsets of them. The maps of
   * directions have their own size.
   */
  bool Sky = false;
  bool SkyIsShadowed = true;
  int SkySource = SKY_BY_MAPS;
  bool ReplacesImageLight = false; // the sky replaces the diffuse light that VTK adds from the
                                   // renderer's texture
  int NumberOfSkyDirections = 256;
  int NumberOfStillSkyDirections = 256;
  int SkyBlock = 1;
  int SkyTileTexels = 128;
  ///@}
  /** Surfaces reflect the environment's light: by virtual lights, or by spheres. */
  bool SkyBounces = false;
  bool SpheresBounceSky = false;
  /**
   * The frame's lights follow the camera: surfaces reflect their light as if it came from the sky's
   * fixed directions, so that turning the camera changes no map.
   */
  bool LightsTurn = false;
  bool MapsSend = true;           // lights' maps hold surfaces that send light, beside depths
  bool OtherSamplers = false;     // passes add virtual lights of their own samplers
  bool AreaLights = false;        // light comes directly from rectangles, in closed form
  bool VirtualAreaLights = false; // pieces of rectangles are virtual lights
  bool Catches = false;           // props that catch light are seen, by what they change
  bool AutomaticAreaLightsAreVirtual = false; // so are rectangles whose Method is AUTOMATIC
  bool MinMaxAreaLights = false;              // these pieces are the paper's
  bool AreaIsShadowed = true;                 // light from rectangles may be hidden
  bool AreaLightsBounce = false;              // surfaces reflect the light of rectangles
  bool AreaSpecular = false;                  // receivers reflect rectangles specularly, too
  int VisibleAreaLights = 0;                  // number of area lights that are drawn
  ///@{
  /**
   * Returns true if a further frame is awaited, as while a camera turns: at a rate of a picture a
   * second or more, no picture is awaited alone.
   */
  static bool IsInteractive(double updateRate) { return updateRate >= 1.0; }
  bool Interactive = false;
  ///@}
  int Refinements = 0;            // of a still picture, see vtkIndirectIlluminationPass
  double RefinementSeconds = 0.0; // 0: no limit
  bool RefinementFades = false;   // frames show how a finer picture takes the place of one
  bool RefinesLights = false;     // else of the sky alone
  bool TracesPaths = false;       // path tracing corrects refined pictures
  bool AddsBatches = false;       // a frame adds batches as long as there is time and no input
  bool FinishesAtOnce = false;    // a picture that goes to a file is whole
  bool WaitsForMaps = false;      // sums begin when no depth map is missing
  int TilesPerFrame = 1 << 30; // largest number of depth maps of virtual lights and of the sky to
                               // draw
  int NumberOfBounces = 1;     // bounces that the estimator computes
  int SampledBounces = 1;      // bounces that samplers of several bounces make lights of
  /**
   * The last bounce of virtual lights from a random walk, which begin after the estimator's
   * bounces; 0: there is no walk.
   */
  int WalkedBounces = 0;
  int AskedBounces = 0; // that the user asks for; 0: all
  int LastBounce = 1;   // the last bounce that an estimator, a sampler or the walk computes
  ///@{
  /**
   * These are the relative errors that parts of the frame's light aim at: the user's, if
   * ErrorToleranceIsSet, else a standard one for each part. ErrorTolerance is that of samplers and
   * area lights. The estimator's is 0 if none of its parameters depends on it.
   */
  static constexpr double StandardErrorTolerance = 0.02;
  static constexpr double StandardSkyErrorTolerance = 0.035;
  bool ErrorToleranceIsSet = false;
  double ErrorTolerance = StandardErrorTolerance;
  double SkyErrorTolerance = StandardSkyErrorTolerance;
  double EstimatorErrorTolerance = 0.0;
  ///@}
  bool Caching = true;
  double IndirectScale = 1.0;
  /**
   * This is the VTK irradiance, about the brightest of the frame: a power of two, for half floats.
   */
  double IrradianceUnit = 1.0;

  ///@{
  /**
   * Entries of the report: those of the scene, and those that hold only if the estimate succeeds.
   */
  Entries Modelled;
  Entries LeftOut;
  Entries EstimateModelled;
  Entries EstimateLeftOut;
  ///@}

  /** Returns true if surfaces reflect light of fixed directions or of area lights. */
  bool HasSenderMaps() const
  {
    return this->SkyBounces || this->AreaLightsBounce || this->LightsTurn;
  }
  /** Returns true if depth maps are looked up for the sky. */
  bool HasSkyMaps() const
  {
    return this->Sky && this->SkySource == SKY_BY_MAPS && this->SkyIsShadowed;
  }

  static vtkIndirectPlan Make(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances);

  /**
   * Returns the key of the irradiance's inputs, except its stages' own times: the eye, lights,
   * props and the plan's decisions.
   */
  vtkIndirectKey MakeKey(const vtkIndirectFrame& frame) const;

  ///@{
  /**
   * Convert an error tolerance for parameters whose defaults are right for a tolerance of 0.02. A
   * threshold is proportional to the error; the error of a grid of hints is proportional to the
   * square of its cells, with 12 hints along the longest edge for 0.0833.
   */
  static double ScaleThreshold(double standard, double tolerance, double most);
  static int FindGridEdge(double tolerance);
  ///@}

  /**
   * Returns the number of depth maps, of scenes of this many triangles in this many props, that a
   * frame draws at this update rate.
   */
  static int FindTilesPerFrame(double triangles, double props, double updateRate);
  /**
   * Returns the number of directions of the sky for an error tolerance: a power of two from 16 to
   * 1024. The RMS error over the mean, of 256 directions with exact visibility, each seen or not,
   * is StandardSkyErrorTolerance as the mean of three scenes. It is proportional to the power -3/4
   * of the number, as from 64 to 256 in these scenes.
   */
  static int FindSkyDirections(double tolerance);
  /**
   * Returns the number of directions with which pixels that see this share of the sky, as through
   * an opening, see as many of them as in the open: a power of two up to 8192, or 0 where the
   * plan's number suffices. The relative error depends on the number of directions that are seen.
   */
  int FindDirectionsOfOpening(double share) const;

private:
  void FindSenders(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectCircumstances& circumstances);
  void FindTurningLights(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances);
  void FindBounces(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances);
  void ReportTolerances(const vtkIndirectAbilities& estimator);
  void FindRefinements(const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator,
    const vtkIndirectCircumstances& circumstances);
  void FindPaths();
  void FindTolerances(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances);
  void FindVisibility(const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator);
  void FindSky(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances);
  void FindSkySource(const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator,
    const vtkIndirectCircumstances& circumstances);
  void FindOtherLights(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances);
  void FindCatchers(const vtkIndirectFrame& frame, const vtkIndirectAbilities& estimator);
  void FindUnit(const vtkIndirectFrame& frame, const vtkIndirectCircumstances& circumstances);
  void LeaveOut(const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator,
    const vtkIndirectCircumstances& circumstances);
};
