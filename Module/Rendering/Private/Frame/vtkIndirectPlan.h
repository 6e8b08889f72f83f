// SPDX-License-Identifier: BSD-3-Clause
// What a frame draws, and why: decided once, before anything is drawn, from the facts of the scene,
// what the user has set and what the estimator can do. No OpenGL and no VTK objects in it. Stages
// read it and decide nothing of the kind themselves.
#ifndef vtkIndirectPlan_h
#define vtkIndirectPlan_h

#include "Frame/vtkIndirectKey.h" // for keys
#include "vtkIndirectSettings.h"  // for what the user has set

#include <string>  // for reasons
#include <utility> // for pairs
#include <vector>  // for lists

struct vtkIndirectFrame;

/** What the frame's estimator can do and has been set to. */
struct vtkIndirectAbilities
{
  std::string Name = "an estimator"; // for reasons
  int MaximumNumberOfBounces = 1;
  bool ComputesGlossy = false;
  bool SumsLobes = false;    // of senders
  bool TakesSampler = false; // sums lights of the frame's sampler, not of its own
  bool SpecularTransport = true;
  bool Occupancy = false;         // asks for voxels where the user has chosen nothing
  bool TakesLightMaps = false;    // can look visibility up in a map of each virtual light
  bool IgnoresVisibility = false; // where the user has chosen nothing
  /** Sums the texels of lights' maps, where there are such, and no virtual lights beside them. */
  bool ReadsMaps = false;
  /** Sums the sky, and what surfaces send of its light, itself, and no lights. */
  bool SumsSky = false;
  /** The tolerance that its parameters follow when so much is asked for; 0: none does. */
  double ErrorTolerance = 0.0;
};

/** What else of the renderer and the pass counts. */
struct vtkIndirectCircumstances
{
  bool OwnDelegate = false;      // what the user's own delegate draws is not known
  std::string DelegateIsRefused; // why no surfaces can be had of it; empty: they can
  int NumberOfOtherEmitters = 0; // sources of light that are no vtkLight
  /** The estimator sums lights of a sampler that finds them by rays, of all bounces. */
  bool SamplerWalks = false;
  bool OtherSamplerWalks = false; // one that is added to that
  bool AreaLights = false;        // of rectangles
  /** VTK irradiance of a surface in the middle of the scene that faces all of them. */
  double AreaLightIrradiance = 0.0;
  int VisibleAreaLights = 0; // that are seen themselves
  bool Environment = false;  // light comes from all around
  /** VTK irradiance of a surface that all of its light would fall on at a right angle. */
  double EnvironmentIrradiance = 0.0;
  ///@{
  /**
   * Spheres that have moved in frames one after the other are among the casters: why, in words,
   * else empty; and why spheres cannot stand for all that hides the sky, empty where they can.
   */
  std::string SpheresMove;
  std::string SpheresFail;
  ///@}
  bool ImageBasedLighting = false; // VTK adds that of the renderer's texture, which nothing hides
  std::string OtherAntialiasing;   // what antialiases the picture after the pass; empty: nothing
  /** Frames a second that the window asks for: vtkRenderWindow's DesiredUpdateRate, by default that
   * of a still picture. Whoever uses the window sets it. How long frames take is never asked: a
   * busy machine draws what an idle one draws. */
  double UpdateRate = 0.0001;
};

struct vtkIndirectPlan
{
  using Entries = std::vector<std::pair<std::string, std::string>>; // what, why

  enum SenderType
  {
    NO_SENDERS, // no vtkLight sends anything
    MAPS,       // surfaces that lights see, in their maps
    EYE,        // surfaces that the eye sees, whose headlight is the only light
    RAYS        // surfaces that rays of the sampler's meet; there are no maps
  };

  /** Empty: indirect light is computed or could be; else why the delegate alone draws. */
  std::string WhyDelegate;
  int Senders = NO_SENDERS;
  /** Lights with a map: places in vtkIndirectFrame::Lights. */
  std::vector<int> MapLights;
  bool Shadows = false;             // mappers look shadows up in these maps
  bool Specular = false;            // estimators reflect specularly
  bool SurfacesAreSpecular = false; // the geometry buffer has what is needed for that
  bool SendersAreSpecular = false;  // some of them
  bool Refraction = false;          // bodies of glass send what comes through them
  bool SenderLobes = false;         // maps have what senders reflect specularly
  bool AlbedoInAlpha = false;       // alpha says nothing, and the albedo has its place
  bool Antialiasing = false;        // edges of the composed picture are antialiased
  enum SkySourceType
  {
    SKY_BY_MAPS,    // depth maps, and virtual lights of its bounce
    SKY_BY_SPHERES, // spheres that stand for what is drawn, and its bounce too, beside an estimator
    SKY_BY_ESTIMATOR // that sums it itself, and nothing beside it
  };

  /** Whether there is irradiance to estimate of anything but what sums the sky itself; else, where
   * there is none of that either, WhyNoIrradiance. */
  bool Irradiance = false;
  std::string WhyNoIrradiance;
  int Visibility = vtkIndirectVisibilityNone; // of senders from receivers; never automatic
  ///@{
  /**
   * Light that comes directly from the environment; in how many directions this frame and a still
   * one, of which a pixel sums those of one of SkyBlock squared subsets; maps of what size.
   */
  bool Sky = false;
  bool SkyIsShadowed = true;
  int SkySource = SKY_BY_MAPS;
  bool ReplacesImageLight = false; // the diffuse light that VTK adds of the renderer's texture
  int NumberOfSkyDirections = 256;
  int NumberOfStillSkyDirections = 256;
  int SkyBlock = 1;
  int SkyTileTexels = 128;
  ///@}
  /** Surfaces send what the environment gives them: virtual lights of it, or spheres. */
  bool SkyBounces = false;
  bool SpheresBounceSky = false;
  bool OtherSamplers = false;    // virtual lights that passes bring of their own
  bool AreaLights = false;       // light comes directly from rectangles
  bool AreaIsShadowed = true;    // and may be hidden
  bool AreaLightsBounce = false; // surfaces send what these give them
  bool AreaSpecular = false;     // receivers reflect them specularly, too
  int VisibleAreaLights = 0;     // that are drawn
  ///@{
  /** Whether another frame is awaited, as while a camera turns: who asks for a picture a second or
   * more is not waiting for this one alone. */
  static bool IsInteractive(double updateRate) { return updateRate >= 1.0; }
  bool Interactive = false;
  ///@}
  bool WaitsForMaps = false;   // sums begin when no depth map is missing
  int TilesPerFrame = 1 << 30; // depth maps of virtual lights and of the sky to draw at most
  int NumberOfBounces = 1;     // those that the estimator computes
  int SampledBounces = 1;      // that samplers which know several make lights of
  /** Virtual lights of bounces after the estimator's, up to this one, come from a random walk; 0:
   * of none. */
  int WalkedBounces = 0;
  ///@{
  /** The relative error that the light of the frame aims at, the user's or the standard one, and
   * whether the user has set it. */
  static constexpr double StandardErrorTolerance = 0.02;
  double ErrorTolerance = StandardErrorTolerance;
  bool ErrorToleranceIsSet = false;
  ///@}
  /** The relative error by which the estimator's parameters are chosen; 0: none of them is. */
  double EstimatorErrorTolerance = 0.0;
  bool Caching = true;
  double IndirectScale = 1.0;
  /** VTK irradiance of the order of the brightest of the frame: a power of two, for half floats. */
  double IrradianceUnit = 1.0;

  ///@{
  /** For the report: of the scene, and what holds only where the estimate succeeds. */
  Entries Modelled;
  Entries LeftOut;
  Entries EstimateModelled;
  Entries EstimateLeftOut;
  ///@}

  /** Depth maps are looked up for the sky. */
  bool HasSkyMaps() const
  {
    return this->Sky && this->SkySource == SKY_BY_MAPS && this->SkyIsShadowed;
  }

  static vtkIndirectPlan Make(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances);

  /**
   * The inputs of the irradiance, besides its stages' own times: the eye, lights, props and the
   * plan's decisions.
   */
  vtkIndirectKey MakeKey(const vtkIndirectFrame& frame) const;

  ///@{
  /**
   * What an error tolerance means for parameters whose defaults were found for one of 0.02: the
   * error goes with a threshold; that of a grid of hints with the square of its cells, 12 hints
   * along the longest edge for 0.0833.
   */
  static double ScaleThreshold(double standard, double tolerance, double most);
  static int FindGridEdge(double tolerance);
  ///@}

  /** Depth maps of so many triangles in so many props that a frame draws of which the window asks
   * for so many a second. */
  static int FindTilesPerFrame(double triangles, double props, double updateRate);
  /**
   * Directions of the sky for an error tolerance, 16, 64, 256 (also for 0, where none is asked for)
   * or 1024. RMS error over the mean of 256 that are each seen or not, of exact visibility: 0.035,
   * the mean of three scenes; it goes with their number to the power -3/4, as from 64 to 256 there.
   */
  static int FindSkyDirections(double tolerance);

private:
  void FindSenders(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectCircumstances& circumstances);
  void FindBounces(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances);
  void FindVisibility(const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator);
  void FindSky(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances);
  void FindSkySource(const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator,
    const vtkIndirectCircumstances& circumstances);
  void FindOtherLights(const vtkIndirectFrame& frame, const vtkIndirectSettings& settings,
    const vtkIndirectAbilities& estimator, const vtkIndirectCircumstances& circumstances);
  void FindUnit(const vtkIndirectFrame& frame, const vtkIndirectCircumstances& circumstances);
  void LeaveOut(const vtkIndirectSettings& settings, const vtkIndirectAbilities& estimator,
    const vtkIndirectCircumstances& circumstances);
};

#endif
