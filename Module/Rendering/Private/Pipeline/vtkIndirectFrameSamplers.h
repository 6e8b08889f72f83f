// SPDX-License-Identifier: BSD-3-Clause
// The sources of a frame's virtual lights: the samplers that its plan needs, which belong to the
// pipeline or to the user, and the lights of all of them.
#pragma once

#include "OpenGL/vtkIndirectKey.h"                // for keys
#include "OpenGL/vtkIndirectResource.h"           // for the base class
#include "Senders/vtkIndirectEmitters.h"          // for emitters
#include "Senders/vtkIndirectHeadlightSampler.h"  // for members
#include "Senders/vtkIndirectRefractionSampler.h" // for members
#include "Senders/vtkIndirectSenderSampler.h"     // for members
#include "Senders/vtkIndirectVirtualLights.h"     // for members
#include "vtkAreaLightSampler.h"                  // for members
#include "vtkLightTreeSampler.h"                  // for members
#include "vtkNew.h"                               // for members
#include "vtkRandomWalkLightSampler.h"            // for members
#include "vtkSmartPointer.h"                      // for members
#include "vtkVirtualLightSampler.h"               // for members

#include <functional> // for emitters
#include <string>     // for names
#include <vector>     // for samplers

class vtkImageData;
class vtkIndirectGeometryBuffer;
class vtkIndirectLightMaps;
class vtkIndirectSurfaces;
class vtkSurfaceCapturePass;
struct vtkIndirectEstimateInput;
struct vtkIndirectFrame;
struct vtkIndirectPlan;
struct vtkIndirectReport;

class vtkIndirectFrameSamplers : public vtkIndirectResource
{
public:
  explicit vtkIndirectFrameSamplers(vtkIndirectResource* owner);

  /** This is the sampler if the user has set none. */
  vtkNew<vtkLightTreeSampler> Default;
  /** The sampler of area lights that are summed as virtual lights. */
  vtkNew<vtkAreaLightSampler> Area;
  /**
   * These are further samplers, whose lights are summed in addition to those of the frame's
   * sampler.
   */
  std::vector<vtkSmartPointer<vtkVirtualLightSampler>> Others;

  /** Returns true if one of the further samplers walks. */
  bool HasOtherWalk() const;

  /**
   * Brings the maps of surfaces up to date that reflect light of the sky and of area lights, if the
   * plan has such light. source: the inputs of the emitters, which are made again when one changes;
   * inHaste: the scene has area lights and changes from frame to frame. Returns false, after an
   * error, when OpenGL refuses.
   */
  bool UpdateSenderMaps(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    vtkSurfaceCapturePass* capture, const vtkIndirectKey& source,
    const std::function<vtkIndirectEmitters::List(bool inHaste)>& makeEmitters);
  void ReleaseSenderMaps(vtkWindow* window) { this->Senders->Release(window); }
  /** See vtkIndirectSenderSampler::SetFineness. */
  void SetFinenessOfSenders(double fineness) { this->Senders->SetFineness(fineness); }

  /**
   * Chooses the samplers of the frame; own: the sampler of its lights, null if the estimator needs
   * none.
   */
  void Choose(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    const vtkIndirectSampler::Pointer& own);

  /** Returns true if a still frame of the same scene would have more lights than the last frame. */
  bool HasMore() const;
  /** Returns true if rays meet the scene's surfaces. */
  bool Walk() const;
  /**
   * Brings the samplers' lights up to date. Returns false, after an error, when a sampler fails.
   * surfaces: up to date if Walk is true.
   */
  bool Update(const vtkIndirectEstimateInput& frame, const vtkIndirectSurfaces& surfaces);
  /** Returns the lights, null if the frame has no sampler. */
  const vtkIndirectVirtualLights* GetLights() const
  {
    return this->Samplers.empty() ? nullptr : &this->Lights;
  }

  /** Appends the inputs of the lights, except the maps. */
  void AppendTo(vtkIndirectKey& key) const;
  /**
   * Copies `lights`, `branches` or `lobes`. Returns the reason if it cannot, or an empty string.
   */
  std::string Copy(const vtkIndirectFrame& frame, const std::string& name, vtkImageData* image);
  static bool IsTable(const std::string& name);

  long long GetNumberOfFacesDrawn() const { return this->Senders->GetNumberOfFacesDrawn(); }
  void AddToReport(vtkIndirectReport& report) const;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  template <typename SamplerType>
  using Own = const std::shared_ptr<SamplerType>;
  Own<vtkIndirectHeadlightSampler> Headlight = std::make_shared<vtkIndirectHeadlightSampler>();
  // Samplers of the surfaces that the sky and area lights shine on, and of bodies of glass.
  Own<vtkIndirectSenderSampler> Senders = std::make_shared<vtkIndirectSenderSampler>();
  Own<vtkIndirectRefractionSampler> Refraction = std::make_shared<vtkIndirectRefractionSampler>();
  vtkNew<vtkRandomWalkLightSampler> LaterBounces;
  std::vector<vtkIndirectSampler::Pointer> Samplers; // samplers of the frame
  bool SendersAreWalked = false; // later bounces are among the sources of the sampler's lights
  vtkIndirectVirtualLights Lights{ this };
};
