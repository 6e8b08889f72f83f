// SPDX-License-Identifier: BSD-3-Clause
// Where a frame's virtual lights come from: the samplers that its plan asks for, those that the
// pipeline owns and those that the user has set, and the lights of all of them.
#ifndef vtkIndirectFrameSamplers_h
#define vtkIndirectFrameSamplers_h

#include "VirtualLights/vtkIndirectEmitters.h"         // for emitters
#include "VirtualLights/vtkIndirectHeadlightSampler.h" // for members
#include "VirtualLights/vtkIndirectSenderSampler.h"    // for members
#include "VirtualLights/vtkIndirectVirtualLights.h"    // for members
#include "Visibility/vtkIndirectRefractionSampler.h"   // for members
#include "vtkLightTreeSampler.h"                       // for members
#include "vtkNew.h"                                    // for members
#include "vtkRandomWalkLightSampler.h"                 // for members
#include "vtkSmartPointer.h"                           // for members

#include <functional> // for emitters
#include <string>     // for names
#include <vector>     // for samplers

class vtkImageData;
class vtkIndirectGeometryBuffer;
class vtkIndirectSurfaces;
class vtkReflectiveShadowMapPass;
class vtkSurfaceCapturePass;
class vtkVirtualLightSampler;
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
  /** Whose lights are summed besides those of the frame's sampler. */
  std::vector<vtkSmartPointer<vtkVirtualLightSampler>> Others;

  /** Whether lights of one of the others are those of paths. */
  bool HasOtherWalk() const;

  /**
   * The maps of what reflects light of the sky and of area lights, where the plan has that; source
   * tells when emitters have to be made anew. Returns false, after an error, when OpenGL refuses.
   */
  bool UpdateSenderMaps(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    vtkSurfaceCapturePass* capture, const std::vector<double>& source,
    const std::function<vtkIndirectEmitters::List()>& makeEmitters);
  void ReleaseSenderMaps(vtkWindow* window) { this->Senders->ReleaseGraphicsResources(window); }

  /** Chooses the samplers of the frame; own: that of the senders, null where the estimator asks for
   * none. */
  void Choose(
    const vtkIndirectFrame& frame, const vtkIndirectPlan& plan, vtkVirtualLightSampler* own);

  /** Whether a still frame of the same scene would have more lights than the last one. */
  bool HasMore() const;
  /** Whether rays look for the scene's surfaces. */
  bool Walk() const;
  /**
   * Brings the samplers' lights up to date. Returns false, after an error, when a sampler cannot.
   * surfaces: up to date where samplers Walk.
   */
  bool Update(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    const vtkReflectiveShadowMapPass& maps, const vtkIndirectGeometryBuffer& geometry,
    const vtkIndirectSurfaces& surfaces);
  /** The lights, null where the frame has no sampler. */
  const vtkIndirectVirtualLights* GetLights() const
  {
    return this->Samplers.empty() ? nullptr : &this->Lights;
  }

  /** What their lights depend on besides the maps. */
  void AppendTo(std::vector<double>& key) const;
  /** Copies `lights`, `branches` or `lobes`; why not, or empty. */
  std::string Copy(const vtkIndirectFrame& frame, const std::string& name, vtkImageData* image);
  static bool IsTable(const std::string& name);

  long long GetNumberOfFacesDrawn() const { return this->Senders->GetNumberOfFacesDrawn(); }
  void AddToReport(vtkIndirectReport& report) const;
  void Release(vtkWindow* window);

private:
  vtkNew<vtkIndirectHeadlightSampler> Headlight;
  vtkNew<vtkIndirectSenderSampler> Senders;        // of light of the sky and of area lights
  vtkNew<vtkIndirectRefractionSampler> Refraction; // of bodies of glass
  vtkNew<vtkRandomWalkLightSampler> LaterBounces;
  std::vector<vtkSmartPointer<vtkVirtualLightSampler>> Samplers; // of the frame
  bool SendersAreWalked = false; // later bounces are among what the sampler's lights are of
  vtkIndirectVirtualLights Lights;
};

#endif
