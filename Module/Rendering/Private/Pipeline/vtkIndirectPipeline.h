// SPDX-License-Identifier: BSD-3-Clause
// The stages of a frame and their order: facts and plan, the lights' maps, the geometry buffer,
// virtual lights, visibility, the estimate, the composite. Each stage owns what it produces and
// hands it on as a const reference that is valid for this frame.
#ifndef vtkIndirectPipeline_h
#define vtkIndirectPipeline_h

#include "Capture/vtkIndirectCoarseLevels.h"        // for a member
#include "Capture/vtkIndirectGeometryBuffer.h"      // for members
#include "Capture/vtkSurfaceCapturePass.h"          // for members
#include "Composite/vtkIndirectAntialiasing.h"      // for members
#include "Composite/vtkIndirectComposite.h"         // for members
#include "Frame/vtkIndirectEstimate.h"              // for members
#include "Frame/vtkIndirectFrame.h"                 // for members
#include "Frame/vtkIndirectPlan.h"                  // for members
#include "Frame/vtkIndirectReport.h"                // for members
#include "Frame/vtkIndirectRoom.h"                  // for a member
#include "Frame/vtkIndirectStageTimer.h"            // for members
#include "Gather/vtkIndirectAreaGather.h"           // for members
#include "Gather/vtkIndirectSkyGather.h"            // for members
#include "Gather/vtkIndirectVisibleLamps.h"         // for members
#include "Pipeline/vtkIndirectFrameSamplers.h"      // for members
#include "Pipeline/vtkIndirectImageLight.h"         // for members
#include "Pipeline/vtkIndirectSphereBlockers.h"     // for a member
#include "Pipeline/vtkIndirectSphereMotion.h"       // for a member
#include "VirtualLights/vtkIndirectSkyProjection.h" // for members
#include "Visibility/vtkIndirectPenumbra.h"         // for members
#include "Visibility/vtkIndirectSurfaces.h"         // for a member
#include "Visibility/vtkIndirectVisibility.h"       // for members
#include "vtkAreaLight.h"                           // for members
#include "vtkEnvironmentLight.h"                    // for members
#include "vtkIndirectEstimatorPass.h"               // for members
#include "vtkMultiresolutionSplattingPass.h"        // for members
#include "vtkNew.h"                                 // for members
#include "vtkProxyAccumulationPass.h"               // for members
#include "vtkReflectiveShadowMapPass.h"             // for members
#include "vtkSmartPointer.h"                        // for members
#include "vtkTimeStamp.h"                           // for members
#include "vtkWeakPointer.h"                         // for members

#include <string> // for names
#include <vector> // for samplers

class vtkImageData;
class vtkLightCollection;
class vtkRenderPass;

class vtkIndirectPipeline
{
public:
  /** What the pass asks for. */
  struct Request
  {
    vtkIndirectSettings Settings;
    vtkIndirectCircumstances Circumstances;
    vtkIndirectEstimatorPass* Estimator = nullptr;
    bool HoldEstimator = true; // else it may go at any time
    vtkVirtualLightSampler* Sampler = nullptr;
    vtkRenderPass* Delegate = nullptr;
    vtkEnvironmentLight* Environment = nullptr;
    /** The renderer's own lights where others have taken their place; else null. */
    vtkLightCollection* ReplacedLights = nullptr;
    bool DepthOfSamples = false; // props may be drawn once more, for their depth
    bool DepthCleared = false;   // of the framebuffer that is bound: nothing is drawn there yet
  };

  vtkIndirectPipeline();

  /** Reads the scene and plans the frame; nothing of the last one can be read from here on. */
  void Prepare(const vtkRenderState* s, const Request& request);
  const vtkIndirectPlan& GetPlan() const { return this->Plan; }

  /**
   * Draws the surfaces: the lights' maps, then what the eye sees. Returns false where OpenGL
   * refuses, or where the delegate has drawn into a framebuffer of its own: IsRedirected.
   */
  bool DrawSurfaces(const vtkRenderState* s, const Request& request);
  bool IsRedirected() const { return this->Capture->IsRedirected(); }
  int GetNumberOfRenderedProps() const { return this->Geometry.GetNumberOfRenderedProps(); }

  /**
   * Then the light, and the picture into the framebuffer that is bound.
   */
  void DrawLight(const Request& request);
  /** Shows a channel in place of the picture; false for one that the frame does not have. */
  bool ShowChannel(const std::string& name);

  /** The last frame has no buffers, and why. */
  void Forget(const std::string& why);
  bool HasBuffers() const { return this->BuffersAreThere; }
  const std::string& GetWhyNoBuffers() const { return this->WhyNoBuffers; }
  /** Whether the last frame's window is the renderer's still. */
  bool IsInWindow() const;
  /** Of the last frame; null before the first. */
  vtkIndirectEstimatorPass* GetEstimator() const { return this->Estimator; }
  /** Copies a channel of the last frame; why not, or empty. */
  std::string CopyChannel(const std::string& name, vtkImageData* image);

  /** What the last frame modelled and left out, and its sizes and counters. */
  void AddToReport(vtkIndirectReport& report) const;
  void Release(vtkWindow* window);

  vtkIndirectStageTimer Timer;
  vtkNew<vtkReflectiveShadowMapPass> Maps;
  vtkNew<vtkMultiresolutionSplattingPass> DefaultEstimator;
  std::vector<vtkSmartPointer<vtkAreaLight>> AreaLights;
  vtkIndirectFrameSamplers Samplers;
  vtkIndirectCoarseLevels Levels;

private:
  std::vector<double> MakeFrameKey() const;
  std::vector<double> MakeKey(vtkVirtualLightSampler* users) const;
  const vtkIndirectBlockingSpheres* UpdateSurfaces(
    const vtkIndirectVisibilityNeeds& needs, bool caching);
  bool UpdateIrradiance(const Request& request);
  bool UpdateSky(const Request& request);
  bool UpdateSkyMaps(const Request& request);
  vtkIndirectEstimatorPass* GetSkySummer() const;
  bool UpdateArea(const Request& request);
  void AppendAreaLights(std::vector<double>& key) const;
  void AddCoarseMapsToReport(vtkIndirectReport& report) const;
  bool UpdateSenderMaps();
  void ReleaseSkyMaps(vtkWindow* window);
  bool IsEstimateThere() const;
  const vtkIndirectEstimate* GetEstimate() const;
  vtkIndirectComposite::Input MakeCompositeInput() const;
  glm::dvec3 FindGreatestIrradiance() const;
  bool RenderChannel(const std::string& name);

  vtkNew<vtkSurfaceCapturePass> Capture;
  vtkIndirectPenumbra Penumbra; // of the maps' lights
  vtkIndirectGeometryBuffer Geometry;
  vtkIndirectVisibility Visibility;
  vtkIndirectSphereBlockers Blockers; // for visibility and surfaces
  vtkIndirectSurfaces Surfaces;       // for samplers and visibility
  vtkIndirectSkyProjection SkyProjection;
  vtkIndirectSkyGather Sky;
  vtkNew<vtkProxyAccumulationPass> Spheres; // in place of these maps
  vtkIndirectSphereMotion SphereMotion;
  vtkIndirectAreaGather Area;
  vtkIndirectVisibleLamps VisibleLamps;
  vtkIndirectImageLight ImageLight;
  vtkIndirectComposite Composite;
  vtkIndirectAntialiasing Antialiasing;

  // The last frame.
  vtkIndirectFrame Frame;
  vtkIndirectRoom Room; // of its casters
  vtkIndirectPlan Plan;
  vtkWeakPointer<vtkRenderer> Renderer; // guards Frame's pointers
  vtkEnvironmentLight* Environment = nullptr;
  std::vector<vtkSmartPointer<vtkAreaLight>> UsableAreaLights; // or off
  bool BuffersAreThere = false;
  bool IrradianceIsThere = false;
  bool SkyIsThere = false;
  bool IrradianceWaits = false; // for its depth maps
  bool SkyWaits = false;
  bool AreaIsThere = false;
  long long NumberOfEstimates = 0;
  int TilesLeft = 0; // depth maps that the frame may draw still
  std::string WhyNoBuffers = "no frame has been rendered yet";
  vtkIndirectEstimate Estimate;
  vtkIndirectEstimate SkyEstimate; // of who sums the sky without maps
  // What made its irradiance: its buffers stay readable when the pass is given others.
  vtkWeakPointer<vtkIndirectEstimatorPass> Estimator;
  vtkSmartPointer<vtkIndirectEstimatorPass> HeldEstimator;
  vtkMTimeType EstimateTime = 0;    // of the estimator, at the frame's end
  vtkTimeStamp Identity;            // whose estimator it is
  bool TargetIsClear = false;       // of what the frame is drawn into
  bool DepthIsDrawn = false;        // into that, sample by sample
  vtkIndirectReport::Entries Paths; // in force

  std::vector<double> FrameKey; // what all light of the frame depends on
  // What the irradiance was computed from; empty when there is none.
  std::vector<double> EstimateKey;
  std::vector<double> SkyKey;
  std::vector<double> AreaKey;
  // What the estimator could not work with, and has said so: not asked again before it changes.
  std::vector<double> FailedKey;
};

#endif
