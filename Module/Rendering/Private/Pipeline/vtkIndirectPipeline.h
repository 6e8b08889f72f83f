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
#include "Frame/vtkIndirectKey.h"                   // for keys
#include "Frame/vtkIndirectPlan.h"                  // for members
#include "Frame/vtkIndirectReport.h"                // for members
#include "Frame/vtkIndirectRoom.h"                  // for a member
#include "Frame/vtkIndirectStageTimer.h"            // for members
#include "Gather/vtkIndirectAreaGather.h"           // for members
#include "Gather/vtkIndirectSkyGather.h"            // for members
#include "Gather/vtkIndirectVisibleLamps.h"         // for members
#include "Pipeline/vtkIndirectBounceLight.h"        // for a member
#include "Pipeline/vtkIndirectEstimatorSky.h"       // for a member
#include "Pipeline/vtkIndirectFrameSamplers.h"      // for members
#include "Pipeline/vtkIndirectImageLight.h"         // for members
#include "Pipeline/vtkIndirectSphereMotion.h"       // for a member
#include "VirtualLights/vtkIndirectSkyProjection.h" // for members
#include "Visibility/vtkIndirectPenumbra.h"         // for members
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
  vtkNew<vtkReflectiveShadowMapPass> MapsPass; // what the user sets of the lights' maps
  vtkNew<vtkMultiresolutionSplattingPass> DefaultEstimator;
  std::vector<vtkSmartPointer<vtkAreaLight>> AreaLights;
  vtkIndirectFrameSamplers Samplers;
  vtkIndirectCoarseLevels Levels;

private:
  // One kind of light of the frame.
  struct Part
  {
    vtkIndirectFrameLight* Light = nullptr;
    bool IsAsked = false; // by the plan
    bool Waits = false;   // for its depth maps
    bool IsThere = false; // Result is of the last frame
    vtkIndirectEstimate Result;
    vtkIndirectKey Key;    // the inputs of Result; empty where there is none
    vtkIndirectKey Failed; // the inputs of an error: the light is asked for again when they change
  };
  enum PartType
  {
    BOUNCE,
    SKY,
    AREA,
    NUMBER_OF_PARTS
  };

  vtkIndirectKey MakeFrameKey() const;
  void ChooseLights(const Request& request);
  bool UpdatePart(Part& part, const vtkIndirectFrameLight::Input& input, int mostMaps);
  const Part* GetPart(PartType type) const;
  vtkIndirectEstimatorPass* GetSkyEstimator() const;
  void AppendAreaLights(vtkIndirectKey& key) const;
  void AddCoarseMapsToReport(vtkIndirectReport& report) const;
  bool UpdateSenderMaps();
  void ReleaseSkyMaps(vtkWindow* window);
  vtkIndirectComposite::Input MakeCompositeInput() const;
  glm::dvec3 FindGreatestIrradiance() const;
  bool RenderChannel(const std::string& name);

  vtkIndirectLightMaps& Maps = vtkIndirectLightMaps::Get(this->MapsPass);
  vtkNew<vtkSurfaceCapturePass> Capture;
  vtkIndirectPenumbra Penumbra; // of the maps' lights
  vtkIndirectGeometryBuffer Geometry;
  vtkIndirectBounceLight Bounce{ Samplers };
  vtkIndirectSkyProjection SkyProjection;
  vtkIndirectSkyGather SkyMaps;
  vtkIndirectEstimatorSky EstimatorSky;     // in place of SkyMaps
  vtkNew<vtkProxyAccumulationPass> Spheres; // an estimator for it
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
  Part Parts[NUMBER_OF_PARTS];
  long long NumberOfEstimates = 0;
  std::string WhyNoBuffers = "no frame has been rendered yet";
  // The estimator of the last frame: its buffers stay readable when the pass is given another one.
  vtkWeakPointer<vtkIndirectEstimatorPass> Estimator;
  vtkSmartPointer<vtkIndirectEstimatorPass> HeldEstimator;
  vtkTimeStamp Identity;            // whose estimator it is
  bool TargetIsClear = false;       // of what the frame is drawn into
  bool DepthIsDrawn = false;        // into that, sample by sample
  vtkIndirectReport::Entries Paths; // in force

  vtkIndirectKey FrameKey;     // the inputs of all light of the frame
  vtkIndirectKey LastFrameKey; // the same of the frame before
};

#endif
