// SPDX-License-Identifier: BSD-3-Clause
// Virtual lights of surfaces that the sky lights: maps of senders in the directions of its groups,
// of which clusters of texels are lights. A map sees what its part of the sky reaches, so nothing
// else sends.
//
// Maps are kept while the camera turns and where only the sky's radiance changes; so are places of
// lights, but where it changes by more than a factor (vtkIndirectSenderClusters).
#ifndef vtkIndirectSkySampler_h
#define vtkIndirectSkySampler_h

#include "Frame/vtkIndirectFrame.h"                    // for casters
#include "VirtualLights/vtkIndirectAllTexelsSampler.h" // for members
#include "VirtualLights/vtkIndirectSenderClusters.h"   // for members
#include "VirtualLights/vtkIndirectSkyGroups.h"        // for members
#include "vtkNew.h"                                    // for members
#include "vtkVirtualLightSampler.h"

#include <vector> // for lists

class vtkEnvironmentLight;
class vtkIndirectSkyProjection;
class vtkReflectiveShadowMapPass;
class vtkSurfaceCapturePass;
struct vtkIndirectPlan;
struct vtkIndirectReport;

class vtkIndirectSkySampler : public vtkVirtualLightSampler
{
public:
  static vtkIndirectSkySampler* New();
  vtkTypeMacro(vtkIndirectSkySampler, vtkVirtualLightSampler);

  /** As many as a sampler has of the scene's lights; null for the default. */
  void SetNumberOfLightsOf(vtkVirtualLightSampler* sampler);

  /**
   * Brings the maps up to date, while the capture is attached. Returns false, after an error, when
   * OpenGL cannot hold them.
   */
  bool DrawMaps(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    vtkSurfaceCapturePass* capture, vtkIndirectSkyProjection& projection,
    vtkEnvironmentLight* environment);
  bool Update(const Input& input) override;

  /** Grows with what lights are made from, but their number. */
  size_t GetSourceTime() const { return this->SourceTime; }
  long long GetNumberOfFacesDrawn() const;
  size_t GetBytes() const override;
  void AddToReport(vtkIndirectReport& report) const;
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkIndirectSkySampler();
  ~vtkIndirectSkySampler() override;

private:
  vtkIndirectSkySampler(const vtkIndirectSkySampler&) = delete;
  void operator=(const vtkIndirectSkySampler&) = delete;

  bool UpdateScene(const vtkIndirectFrame& frame);
  bool UpdateGroups(
    vtkIndirectSkyProjection& projection, vtkEnvironmentLight* environment, bool anew);
  bool ReadSenders(const Input& input);

  vtkNew<vtkReflectiveShadowMapPass> Maps;
  vtkNew<vtkIndirectAllTexelsSampler> Texels; // holds something only while they are read
  vtkIndirectSenderClusters Clusters;
  int NumberOfLights = 256;

  std::vector<vtkIndirectSkyGroups::Group> Groups; // by their maps; without light where it has gone
  vtkEnvironmentLight* Environment = nullptr;      // whose light that is, and its time
  vtkMTimeType EnvironmentTime = 0;

  // What the maps were drawn of, and what the senders were read from.
  bool MapsAreThere = false;
  std::vector<vtkIndirectCaster> Casters;
  double SceneScale = 0.0;
  glm::dvec3 SceneCenter{ 0.0 };
  vtkMTimeType SendersTime = 0;

  size_t SourceTime = 0;
  // What the lights were made from.
  size_t MadeTime = 0;
  int MadeCount = 0;
};

#endif
