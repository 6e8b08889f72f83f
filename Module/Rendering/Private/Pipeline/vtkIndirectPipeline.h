// SPDX-License-Identifier: BSD-3-Clause
// The stages of a frame and their order: facts and plan, the lights' maps, the geometry buffer,
// virtual lights, visibility, the estimate, the composite. Each stage owns what it produces and
// hands it on as a const reference that is valid for this frame.
#pragma once

#include "Area/vtkIndirectAreaGather.h"             // for members
#include "Area/vtkIndirectVisibleLamps.h"           // for members
#include "Capture/vtkIndirectCatchers.h"            // for a member
#include "Capture/vtkIndirectCoarseLevels.h"        // for a member
#include "Capture/vtkIndirectCreases.h"             // for members
#include "Capture/vtkIndirectGeometryBuffer.h"      // for members
#include "Capture/vtkSurfaceCapturePass.h"          // for members
#include "Emitters/vtkIndirectSkyProjection.h"      // for members
#include "Error/vtkIndirectErrorProbe.h"            // for members
#include "Error/vtkIndirectPathImage.h"             // for a member
#include "Error/vtkIndirectPathTracer.h"            // for results
#include "Maps/vtkIndirectDepthMaps.h"              // for members
#include "Maps/vtkIndirectPenumbra.h"               // for members
#include "Maps/vtkIndirectViewSamples.h"            // for a member
#include "OpenGL/vtkIndirectKey.h"                  // for keys
#include "OpenGL/vtkIndirectResource.h"             // for the base class
#include "Picture/vtkIndirectAccumulation.h"        // for a member
#include "Picture/vtkIndirectAntialiasing.h"        // for members
#include "Picture/vtkIndirectComposite.h"           // for members
#include "Pipeline/vtkIndirectBounceLight.h"        // for a member
#include "Pipeline/vtkIndirectFrameSamplers.h"      // for members
#include "Pipeline/vtkIndirectFrameSurfaces.h"      // for a member
#include "Pipeline/vtkIndirectImageLight.h"         // for members
#include "Pipeline/vtkIndirectRefinementSchedule.h" // for a member
#include "Pipeline/vtkIndirectSphereMotion.h"       // for a member
#include "Plan/vtkIndirectPlan.h"
#include "Plan/vtkIndirectReport.h"          // for members
#include "Plan/vtkIndirectStageTimer.h"      // for members
#include "Scene/vtkIndirectCasterBounds.h"   // for a member
#include "Scene/vtkIndirectFrame.h"          // for members
#include "Scene/vtkIndirectPointSpheres.h"   // for members
#include "Sky/vtkIndirectSkyGather.h"        // for members
#include "vtkAreaLight.h"                    // for members
#include "vtkEnvironmentLight.h"             // for members
#include "vtkIndirectEstimatorPass.h"        // for members
#include "vtkMultiresolutionSplattingPass.h" // for members
#include "vtkNew.h"                          // for members
#include "vtkProxyAccumulationPass.h"        // for members
#include "vtkReflectiveShadowMapPass.h"      // for members
#include "vtkSmartPointer.h"                 // for members
#include "vtkTimeStamp.h"                    // for members
#include "vtkWeakPointer.h"                  // for members

#include <optional> // for a member
#include <string>   // for names
#include <vector>   // for samplers

class vtkImageData;
class vtkLightCollection;
class vtkRenderPass;

class vtkIndirectPipeline : public vtkIndirectResource
{
public:
  /** These are the settings and objects that the pass hands to the pipeline for a frame. */
  struct Request
  {
    vtkIndirectSettings Settings;
    vtkIndirectCircumstances Circumstances;
    vtkIndirectEstimatorPass* Estimator = nullptr;
    bool HoldEstimator = true; // else the estimator may be deleted at any time
    vtkVirtualLightSampler* Sampler = nullptr;
    vtkRenderPass* Delegate = nullptr;
    vtkEnvironmentLight* Environment = nullptr;
    /** The renderer's own lights if other lights replace them; else null. */
    vtkLightCollection* ReplacedLights = nullptr;
    /** The greatest share of the frame's lights that light of a preset may replace; 0: none. */
    double MostReplaced = 0.0;
    bool DepthOfSamples = false; // props may be drawn once more, for the depth of samples
    bool DepthCleared = false;   // the bound framebuffer's depth is clear: nothing is drawn yet
  };

  vtkIndirectPipeline();

  /** Reads the scene and plans the frame. After that no data of the last frame can be read. */
  void Prepare(const vtkRenderState* s, const Request& request);
  const vtkIndirectPlan& GetPlan() const { return this->Plan; }

  /**
   * Draws the surfaces: the lights' maps, then what the eye sees. Returns false if OpenGL refuses,
   * or if the delegate has drawn into a framebuffer of its own: IsRedirected.
   */
  bool DrawSurfaces(const vtkRenderState* s, const Request& request);
  bool IsRedirected() const { return this->Capture->IsRedirected(); }
  int GetNumberOfRenderedProps() const { return this->Geometry.GetNumberOfRenderedProps(); }

  /** Draws the light, and then the picture into the bound framebuffer. */
  void DrawLight(const Request& request);
  /** Shows a channel in place of the picture; false for one that the frame does not have. */
  bool ShowChannel(const std::string& name);

  /** Marks the last frame as one without buffers, for this reason. */
  void Forget(const std::string& why);
  bool HasBuffers() const { return this->BuffersAreThere; }
  /** Returns the number of depth maps and of batches of lights that a still picture lacks. */
  long long CountWorkLeft() const;
  /** Returns true if the last frame's window is still the renderer's. */
  bool IsInWindow() const;
  /** Returns the estimator of the last frame; null before the first frame. */
  vtkIndirectEstimatorPass* GetEstimator() const { return this->Estimator; }
  /** Copies a channel of the last frame. Returns the reason if it cannot, or an empty string. */
  std::string CopyChannel(const std::string& name, vtkImageData* image);

  /**
   * Adds the pass's settings: the values that are set, or, with the plan of the last frame, the
   * values in force.
   */
  void AddSettings(vtkIndirectSettingList& list, const vtkIndirectSettings& settings,
    const vtkIndirectPlan* plan) const;

  /**
   * Estimates the error of the last frame's irradiance, once for each frame. Returns the RMS error
   * over the mean; negative of moving frames, and of pictures that lack depth maps.
   */
  double EstimateError();

  /** Adds what the last frame modelled and left out, its sizes and its counters to the report. */
  void AddToReport(vtkIndirectReport& report) const;

  vtkIndirectStageTimer Timer;
  vtkNew<vtkReflectiveShadowMapPass> MapsPass; // the user's settings of the lights' maps
  vtkNew<vtkMultiresolutionSplattingPass> DefaultEstimator;
  std::vector<vtkSmartPointer<vtkAreaLight>> AreaLights;
  vtkIndirectFrameSamplers Samplers{ this };
  vtkIndirectCoarseLevels Levels{ this };
  vtkIndirectPointSpheres PointSpheres; // a frame is drawn within a Scope of these

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  // One kind of light of the frame.
  struct Part
  {
    const char* Name = ""; // in the report
    vtkIndirectFrameLight* Light = nullptr;
    bool IsOfEstimator = false; // of the frame's estimator, which may be deleted between frames
    bool IsAsked = false;       // the plan needs it
    bool IsNew = false;         // its result is made in this frame
    bool IsStill = false;       // its inputs are those of the last result
    bool EyeMoved = false;      // its inputs are those of the last result but for the eye
    bool Waits = false;         // it waits for its depth maps
    bool IsThere = false;       // Result is of the last frame
    vtkIndirectEstimate Result;
    vtkMTimeType Time = 0; // GetEstimateTime of Result
    vtkIndirectKey Key;    // the inputs of Result; empty if there is none
    vtkIndirectKey Failed; // the inputs of an attempt without a result: the light is tried again
                           // when they change
  };

  vtkIndirectKey MakeFrameKey() const;
  void ChooseLights(const Request& request);
  vtkIndirectFrameLight::Input MakeInput(const vtkIndirectVisibility& visibility)
  {
    return { this->Frame, this->Plan, this->Geometry, this->Creases, this->Maps, nullptr,
      visibility, false, this->Timer, this->Environment, &this->SkyProjection,
      &this->ClosedAreaLights };
  }
  void Refine(const vtkIndirectFrameLight::Input& input);
  void LimitRefinement();
  bool AddBatch();
  bool UpdateLightsOfBatch(const vtkIndirectFrameLight::Input& input);
  bool SumBatch(const vtkIndirectFrameLight::Input& input);
  bool MeetsTolerance();
  bool CopyImage(const char* name, vtkImageData* image);
  vtkIndirectPathTracer MakePathTracer(const vtkIndirectSurfaces& surfaces) const;
  bool TracesPaths() const { return this->Plan.TracesPaths && this->WhyNoPaths.empty(); }
  bool TracePaths(const vtkIndirectFrameLight::Input& input);
  bool CorrectByPaths(bool anew);
  void KeepCasters();
  bool CastersAreThere() const;
  bool HasTime() const;
  bool RefinesSky() const;
  bool Refines(const Part& part) const;
  bool DrawMapsOfBatch();
  bool SumOpening();
  bool SumFurtherPoints(const vtkIndirectFrameLight::Input& input);
  std::vector<vtkIndirectContribution> GetRefined() const;
  bool ShowRefinement();
  void ReleaseRefinement();
  void UpdatePart(Part& part, const vtkIndirectFrameLight::Input& input);
  void SumPart(Part& part, const vtkIndirectFrameLight::Input& input, bool mapsDrawn);
  bool IsCurrent(const Part& part) const;
  void AppendAreaLights(vtkIndirectKey& key) const;
  void AddCoarseMapsToReport(vtkIndirectReport& report) const;
  void AddRefinementToReport(vtkIndirectReport& report) const;
  long long CountTilesLeft() const;
  long long CountBatchesLeft() const;
  bool UpdateSenderMaps(vtkIndirectFrameSamplers& samplers);
  void FindBalance(double mostReplaced);
  vtkIndirectComposite::Input MakeCompositeInput() const;
  glm::dvec3 FindGreatestIrradiance(const std::vector<vtkIndirectContribution>& lights) const;
  bool RenderChannel(const std::string& name);

  vtkIndirectLightMaps& Maps = vtkIndirectLightMaps::Get(this->MapsPass);
  vtkNew<vtkSurfaceCapturePass> Capture;
  vtkIndirectDepthMaps DepthMaps;
  vtkIndirectViewSamples ViewSamples{ DepthMaps };
  vtkIndirectPenumbra Penumbra{ this, DepthMaps }; // penumbrae of the maps' lights
  vtkIndirectGeometryBuffer Geometry{ this };
  vtkIndirectCatchers Catchers{ this };
  vtkIndirectCreases Creases{ this };
  vtkIndirectFrameSurfaces Surfaces;
  vtkIndirectBounceLight Bounce{ this, Samplers, Surfaces, DepthMaps,
    vtkIndirectDepthMaps::VIRTUAL_LIGHTS };
  // A finer picture has lights and maps of its own: a moving frame takes those of the first picture
  // up. Its sky waits for SkyMaps, whose maps of strong directions it shares.
  vtkIndirectFrameSamplers FinerSamplers{ this };
  vtkIndirectBounceLight FinerBounce{ this, FinerSamplers, Surfaces, DepthMaps,
    vtkIndirectDepthMaps::FURTHER_LIGHTS, true };
  vtkIndirectAccumulation Accumulation{ this };
  vtkIndirectRefinementSchedule Schedule;
  double FrameBegan = 0.0; // on the schedule's clock
  vtkIndirectErrorProbe ErrorProbe;
  vtkIndirectPathImage Paths;           // of a picture that is refined
  std::string WhyNoPaths;               // of the picture's surfaces; empty: paths meet all of them
  long long PathsOfPicture = 0;         // that have corrected the picture
  std::optional<double> EstimatedError; // of the last frame; see EstimateError
  std::vector<vtkWeakPointer<vtkProp>> CastersOfPicture; // of the frame that made the picture
  vtkIndirectSkyProjection SkyProjection;
  vtkIndirectSkyGather SkyMaps{ this, DepthMaps };
  vtkIndirectSkyGather FinerSky{ this, DepthMaps, &SkyMaps };
  int DirectionsOfOpening = 0;              // that the sky is summed over; 0: the plan's number
  double ShareOfOpening = 1.0;              // of the sky, that pixels see; their median
  vtkNew<vtkProxyAccumulationPass> Spheres; // its sum replaces SkyMaps
  vtkIndirectSphereMotion SphereMotion;
  vtkIndirectAreaGather Area{ this, DepthMaps };
  vtkIndirectVisibleLamps VisibleLamps{ this };
  vtkIndirectImageLight ImageLight;
  vtkIndirectComposite Composite{ this };
  bool LampsAreReplaceable = false; // by light of a preset
  vtkIndirectLightBalance Balance;
  bool BalanceIsOfWhole = false; // the last whole picture had it
  vtkIndirectAntialiasing Antialiasing{ this };

  // This is the data of the last frame.
  vtkIndirectFrame Frame;
  vtkIndirectCasterBounds CasterBounds; // wide bounds of the frame's casters
  vtkIndirectPlan Plan;
  vtkWeakPointer<vtkRenderer> Renderer; // guards Frame's pointers
  vtkWeakPointer<vtkEnvironmentLight> Environment;
  std::vector<vtkSmartPointer<vtkAreaLight>> UsableAreaLights; // includes lights that are off
  std::vector<vtkSmartPointer<vtkAreaLight>> ClosedAreaLights; // usable, and no virtual lights
  bool BuffersAreThere = false;
  Part Parts[3];
  long long NumberOfEstimates = 0;
  std::string WhyNoBuffers = "no frame has been rendered yet";
  // This is the estimator of the last frame: its buffers stay readable when the pass gets another
  // one.
  vtkWeakPointer<vtkIndirectEstimatorPass> Estimator;
  vtkSmartPointer<vtkIndirectEstimatorPass> HeldEstimator;
  vtkTimeStamp Identity;                     // identifies this user of an estimator
  bool TargetIsClear = false;                // the frame's target is clear
  bool DepthIsDrawn = false;                 // depth is drawn into the target, sample by sample
  vtkIndirectReport::Entries BackEndChoices; // choices in force

  vtkIndirectKey FrameKey;     // the inputs of all light of the frame
  vtkIndirectKey LastFrameKey; // key of the frame before
};
