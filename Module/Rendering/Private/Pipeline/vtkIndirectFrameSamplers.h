// SPDX-License-Identifier: BSD-3-Clause
// Where a frame's virtual lights come from: the samplers that its plan asks for, those that the
// pipeline owns and those that the user has set, and the lights of all of them.
#ifndef vtkIndirectFrameSamplers_h
#define vtkIndirectFrameSamplers_h

#include "Frame/vtkIndirectKey.h"                      // for keys
#include "VirtualLights/vtkIndirectEmitters.h"         // for emitters
#include "VirtualLights/vtkIndirectHeadlightSampler.h" // for members
#include "VirtualLights/vtkIndirectSenderSampler.h"    // for members
#include "VirtualLights/vtkIndirectVirtualLights.h"    // for members
#include "Visibility/vtkIndirectRefractionSampler.h"   // for members
#include "vtkLightTreeSampler.h"                       // for members
#include "vtkNew.h"                                    // for members
#include "vtkRandomWalkLightSampler.h"                 // for members
#include "vtkSmartPointer.h"                           // for members
#include "vtkVirtualLightSampler.h"                    // for members

#include <functional> // for emitters
#include <string>     // for names
#include <vector>     // for samplers

class vtkImageData;
class vtkIndirectGeometryBuffer;
class vtkIndirectLightMaps;
class vtkIndirectSurfaces;
class vtkSurfaceCapturePass;
class vtkWindow;
struct vtkIndirectFrame;
struct vtkIndirectPlan;
struct vtkIndirectReport;

class vtkIndirectFrameSamplers
{
public:
  vtkIndirectFrameSamplers();

  /** Where the user has set none. */
  vtkNew<vtkLightTreeSampler> Default;
  /** Further samplers, whose lights are summed besides those of the frame's sampler. */
  std::vector<vtkSmartPointer<vtkVirtualLightSampler>> Others;

  /** Tells whether one of the further samplers walks. */
  bool HasOtherWalk() const;

  /**
   * The maps of what reflects light of the sky and of area lights, where the plan has that; source
   * tells when emitters have to be made anew. Returns false, after an error, when OpenGL refuses.
   */
  bool UpdateSenderMaps(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    vtkSurfaceCapturePass* capture, const vtkIndirectKey& source,
    const std::function<vtkIndirectEmitters::List()>& makeEmitters);
  void ReleaseSenderMaps(vtkWindow* window) { this->Senders->Release(window); }

  /** Chooses the samplers of the frame; own: the sampler of its lights, null where the estimator
   * asks for none. */
  void Choose(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    const vtkIndirectSampler::Pointer& own);

  /** Tells whether a still frame of the same scene would have more lights than the last one. */
  bool HasMore() const;
  /** Tells whether rays look for the scene's surfaces. */
  bool Walk() const;
  /**
   * Brings the samplers' lights up to date. Returns false, after an error, when a sampler cannot.
   * surfaces: up to date where samplers Walk.
   */
  bool Update(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    const vtkIndirectLightMaps& maps, const vtkIndirectGeometryBuffer& geometry,
    const vtkIndirectSurfaces& surfaces);
  /** The lights, null where the frame has no sampler. */
  const vtkIndirectVirtualLights* GetLights() const
  {
    return this->Samplers.empty() ? nullptr : &this->Lights;
  }

  /** Appends the inputs of the lights, besides the maps. */
  void AppendTo(vtkIndirectKey& key) const;
  /** Copies `lights`, `branches` or `lobes`; why not, or empty. */
  std::string Copy(const vtkIndirectFrame& frame, const std::string& name, vtkImageData* image);
  static bool IsTable(const std::string& name);

  long long GetNumberOfFacesDrawn() const { return this->Senders->GetNumberOfFacesDrawn(); }
  void AddToReport(vtkIndirectReport& report) const;
  void Release(vtkWindow* window);

private:
  template <typename SamplerType>
  using Own = const std::shared_ptr<SamplerType>;
  Own<vtkIndirectHeadlightSampler> Headlight = std::make_shared<vtkIndirectHeadlightSampler>();
  // The surfaces that the sky and area lights shine on, and bodies of glass.
  Own<vtkIndirectSenderSampler> Senders = std::make_shared<vtkIndirectSenderSampler>();
  Own<vtkIndirectRefractionSampler> Refraction = std::make_shared<vtkIndirectRefractionSampler>();
  vtkNew<vtkRandomWalkLightSampler> LaterBounces;
  std::vector<vtkIndirectSampler::Pointer> Samplers; // of the frame
  bool SendersAreWalked = false; // later bounces are among what the sampler's lights are of
  vtkIndirectVirtualLights Lights;
};

#endif
