// SPDX-License-Identifier: BSD-3-Clause
// The lights of a frame with a preset: lights that replace the renderer's own, and a sky, made from
// the preset, the camera and the renderer's lights. A camera that turns changes the sky's
// orientation alone.
#pragma once

#include "Emitters/vtkIndirectPresetLights.h" // for members
#include "OpenGL/vtkIndirectKey.h"            // for keys
#include "vtkNew.h"                           // for members

#include <vector> // for lists

class vtkEnvironmentLight;
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

  /** Chooses the lights of a frame. The renderer's lights are up to date, and only read. */
  void Update(
    vtkRenderer* renderer, const vtkIndirectSettings& settings, vtkEnvironmentLight* users);

  /** Returns the replacing lights; null: the renderer's own are used. */
  vtkLightCollection* GetLights() const;
  vtkEnvironmentLight* GetEnvironment() const { return this->Environment; }
  /** Returns true if the environment is the preset's own sky, which turns with the camera. */
  bool HasOwnSky() const { return this->GetLights() && this->Environment == this->Sky.Get(); }
  /** Returns vtkIndirectPresetLights::MostReplaced of the lights that replace the renderer's. */
  double GetMostReplaced() const
  {
    return this->GetLights() ? this->PresetLights.MostReplaced : 0.0;
  }

  void AddToReport(vtkIndirectReport& report) const;

  /** Returns the title of a vtkIndirectLightingType for the report and printing. */
  static const char* GetTitle(int preset);

private:
  static std::vector<vtkIndirectDistantLight> CollectLamps(vtkRenderer* renderer);
  static vtkIndirectPresetAlbedo FindAlbedo(vtkRenderer* renderer);
  void SetRig(int preset, const std::vector<vtkIndirectDistantLight>& lamps,
    const vtkIndirectPresetAlbedo& albedo, bool hasOwnSky);
  void AddLight(const vtkIndirectDistantLight& lamp, bool fill);
  void Turn(vtkRenderer* renderer);

  int Preset; // preset of the last frame
  bool Inactive = false;
  int NumberOfReplaced = 0;
  vtkIndirectPresetLights PresetLights;
  vtkIndirectKey PresetLightsKey; // the inputs of the lights of the preset
  vtkEnvironmentLight* Environment = nullptr;
  vtkNew<vtkEnvironmentLight> Sky;
  vtkNew<vtkLightCollection> Lights;
  std::vector<glm::dvec3> Directions; // directions to the lights, in the camera's axes
};
