// SPDX-License-Identifier: BSD-3-Clause
// Virtual lights of surfaces that the sky and area lights shine on. Maps of senders are drawn from
// directions of the sky and pieces of area lights, and clusters of their texels become lights. A
// map sees the surfaces that its emitter's light reaches, so no other surface sends.
//
// Maps are kept while the camera turns and while only radiances change. Places of lights are kept,
// too, unless radiances change by more than a factor (vtkIndirectSenderClusters).
#pragma once

#include "Maps/vtkIndirectLightMaps.h"   // for members
#include "OpenGL/vtkIndirectKey.h"       // for keys
#include "Scene/vtkIndirectFrame.h"      // for casters
#include "Senders/vtkIndirectEmitters.h" // for members
#include "Senders/vtkIndirectSampler.h"
#include "Senders/vtkIndirectSenderClusters.h" // for members
#include "Senders/vtkIndirectSenderTexels.h"   // for members
#include "Senders/vtkIndirectSteadyLights.h"   // for members

class vtkSurfaceCapturePass;
struct vtkIndirectPlan;
struct vtkIndirectReport;

class vtkIndirectSenderSampler : public vtkIndirectSampler
{
public:
  /**
   * Makes as many lights as the frame's sampler, and divides them if that sampler does. steady: the
   * emitters' light changes from frame to frame, and lights stay in place
   * (vtkIndirectSteadyLights); then they are half as many, and represent later bounces, too.
   */
  void Follow(const vtkIndirectSamplerAbilities& sampler, bool steady);

  /**
   * Sets the texels along an edge of the maps over those of a moving frame; the maps may have
   * fewer. 0: as the scene allows.
   */
  void SetFineness(double fineness) { this->Fineness = fineness; }
  /** Finds out whether the scene has changed. Must be called first in each frame. */
  void BeginFrame(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan);
  /** Returns true if the scene changes from frame to frame, so that few maps are better than many.
   */
  bool IsHasty() const { return this->Hasty; }
  /** Returns true if the sampler has the emitters that were made of these inputs. */
  bool Knows(const vtkIndirectKey& source) const { return source == this->Source; }
  /** Sets the frame's emitters, each of which sends light, and their inputs. */
  void SetEmitters(const vtkIndirectEmitters::List& emitters, const vtkIndirectKey& source);
  /**
   * Brings the maps up to date, while the capture is attached. Returns false, after an error, when
   * OpenGL cannot hold them.
   */
  bool DrawMaps(
    const vtkIndirectFrame& frame, const vtkIndirectPlan& plan, vtkSurfaceCapturePass* capture);
  bool Update(const Input& input) override;
  vtkIndirectSamplerAbilities GetAbilities() const override;

  const vtkIndirectEmitters::List& GetEmitters() const { return this->Emitters; }
  /** Grows when the inputs of the lights change, except their number. */
  size_t GetSourceTime() const { return this->SourceTime; }
  long long GetNumberOfFacesDrawn() const { return this->Maps.GetNumberOfFacesDrawn(); }
  void AddToReport(vtkIndirectReport& report) const override;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  bool UpdateScene(const vtkIndirectFrame& frame);
  int FindTexels(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan) const;
  bool SeesAllSides() const;
  bool ReadSenders(const Input& input);
  bool MakeSteadyLights(const Input& input, bool anew);
  std::vector<glm::dvec3> FindStrengths() const;
  bool WriteLights(
    const Input& input, const vtkIndirectSenderClusters::LightTree& lights, double error);

  vtkIndirectLightMaps Maps{ this };
  vtkIndirectSenderTexels Texels;
  vtkIndirectSenderClusters Clusters;
  vtkIndirectSteadyLights SteadyLights;
  bool Steady = false;
  std::vector<vtkIndirectSenderClusters::Sender> FromMaps; // kept for steady lights
  size_t FurtherTime = 0;
  int NumberOfLights = 256;
  double Fineness = 0.0;
  int TexelsOfMap = 0;   // along an edge
  int TexelsOfDrawn = 0; // of the maps that are there
  int MostLights = 0;    // an automatic number of steady lights may grow up to this one
  int Narrow = 0;        // the number up to which the frame's lights may grow
  bool Divides = false;  // true if the lights have branches

  vtkIndirectEmitters::List Emitters; // in the order of their maps; dark ones have lost their light
  vtkIndirectEmitters::List Given;    // emitters of the frame
  bool IsFresh = false;               // true if Given was set since the maps were drawn
  vtkIndirectKey Source;              // the inputs of Given
  bool EmittersHaveMoved = false;     // true if emitters came, went or moved since then

  bool MapsAreThere = false;
  bool SceneIsNew = false; // a caster has changed since the last frame
  bool Hasty = false;
  vtkIndirectKey Scene;          // the casters that the maps show
  vtkIndirectSeenBox SeenByMaps; // what the maps' windows are fitted to
  vtkMTimeType SendersTime = 0;

  size_t SourceTime = 0;
  // These numbers identify the inputs of the lights.
  size_t MadeTime = 0;
  int MadeCount = 0;
  double MadeError = 0.0; // of steady lights
};
