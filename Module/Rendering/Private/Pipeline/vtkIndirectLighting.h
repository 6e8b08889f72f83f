// SPDX-License-Identifier: BSD-3-Clause
// What lights a frame where a preset is chosen: lights that take the place of the renderer's, and a
// sky, made from the preset, the camera and the renderer's lights. A camera that turns changes the
// sky's orientation alone.
#ifndef vtkIndirectLighting_h
#define vtkIndirectLighting_h

#include "Frame/vtkIndirectKey.h"              // for keys
#include "VirtualLights/vtkIndirectLightRig.h" // for members
#include "vtkNew.h"                            // for members

#include <string> // for reasons
#include <vector> // for lists

class vtkEnvironmentLight;
class vtkLight;
class vtkLightCollection;
class vtkRenderer;
struct vtkIndirectReport;
struct vtkIndirectSettings;

class vtkIndirectLighting
{
public:
  vtkIndirectLighting();
  ~vtkIndirectLighting();
  vtkIndirectLighting(const vtkIndirectLighting&) = delete;
  void operator=(const vtkIndirectLighting&) = delete;

  /** Chooses for a frame; the renderer's lights are up to date, and only read. */
  void Update(
    vtkRenderer* renderer, const vtkIndirectSettings& settings, vtkEnvironmentLight* users);

  /** Null: the renderer's own. */
  vtkLightCollection* GetLights() const;
  vtkEnvironmentLight* GetEnvironment() const { return this->Environment; }

  void AddToReport(vtkIndirectReport& report) const;

  /** As it is printed, of a vtkIndirectLightingType. */
  static const char* GetTitle(int preset);

private:
  static std::vector<vtkIndirectLamp> CollectLamps(vtkRenderer* renderer);
  static vtkIndirectRigAlbedo FindAlbedo(vtkRenderer* renderer);
  void SetRig(
    int preset, const std::vector<vtkIndirectLamp>& lamps, const vtkIndirectRigAlbedo& albedo);
  void AddLight(const vtkIndirectLamp& lamp, bool fill);
  void Turn(vtkRenderer* renderer);

  int Preset; // of the last frame; the renderer's lights while it is inactive
  bool Inactive = false;
  int NumberOfReplaced = 0;
  vtkIndirectLightRig Rig;
  vtkIndirectKey RigKey; // the inputs of the rig
  vtkEnvironmentLight* Environment = nullptr;
  vtkNew<vtkEnvironmentLight> Sky;
  vtkNew<vtkLightCollection> Lights;
  std::vector<glm::dvec3> Directions; // to these, in the camera's axes
};

#endif
