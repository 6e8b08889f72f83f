// SPDX-License-Identifier: BSD-3-Clause
// The maps of a frame's lights: layers of array textures, as documented in
// vtkReflectiveShadowMapPass, and a depth array for percentage-closer shadow look-ups.
//
// A face is drawn again only when the light's place, anything that the face can see or the
// resolution has changed. A light's strength, falloff and exponent redraw nothing.
#pragma once

#include "Frame/vtkIndirectKey.h"            // for keys
#include "LightMaps/vtkIndirectLightMap.h"   // for members
#include "LightMaps/vtkIndirectShadowRows.h" // for members
#include "OpenGL/vtkIndirectDataTexture.h"   // for members
#include "OpenGL/vtkIndirectLayeredTarget.h" // for members
#include "OpenGL/vtkIndirectResource.h"      // for the base class
#include "vtkIndent.h"                       // for Print
#include "vtkSmartPointer.h"                 // for members
#include "vtkTimeStamp.h"                    // for a member

#include <memory> // for maps
#include <vector> // for maps

class vtkIndirectContextGuard;
class vtkOpenGLRenderWindow;
class vtkReflectiveShadowMapPass;
class vtkSurfaceCapturePass;
struct vtkIndirectCaster;
struct vtkIndirectFrame;
struct vtkIndirectPlan;
struct vtkIndirectReport;
struct vtkIndirectShadowMaps;

class vtkIndirectLightMaps : public vtkIndirectResource
{
public:
  /** caller: the object that reports the error of too many lights; null: the frame's window. */
  explicit vtkIndirectLightMaps(vtkIndirectResource* owner, vtkObject* caller = nullptr);
  ~vtkIndirectLightMaps() override;

  /** Returns the maps that a public pass holds. */
  static vtkIndirectLightMaps& Get(const vtkReflectiveShadowMapPass* pass);

  /**
   * Brings the maps of the plan's lights up to date; resolution: texels along an edge. Returns
   * false, after an error, when OpenGL cannot hold them.
   */
  bool Update(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    vtkSurfaceCapturePass* capture, int resolution);
  /** Removes all maps. */
  void Clear() { this->NumberOfMaps = 0; }

  /**
   * Chooses whether the next maps hold the specular reflections of senders. The capture must write
   * them. Default off.
   */
  void SetSpecular(bool specular) { this->Specular = specular; }
  /** Returns true if the maps hold them, so that shaders are built with VTKI_LOBES. */
  bool HasSpecular() const;

  int GetNumberOfMaps() const { return this->NumberOfMaps; }
  int GetNumberOfLayers() const { return this->NumberOfLayers; }
  const vtkIndirectLightMap& GetMap(int i) const { return *this->Maps[i]; }
  /** Returns the number of faces drawn since construction. */
  vtkIdType GetNumberOfFacesDrawn() const { return this->NumberOfFacesDrawn; }
  /**
   * Returns the texels along an edge in the last frame: the resolution, or less with many lights.
   */
  int GetTexels() const { return this->Texels; }
  /** Grows whenever the content of a map, or the table below, changes. */
  vtkMTimeType GetContentTime() const { return this->ContentTime.GetMTime(); }

  /** Binds the maps and their table for vtkIndirectMapTexel.glsl. */
  void Activate(const vtkIndirectProgram& program) const;
  ///@{
  /** Bind the depths for shadow look-ups; pair. */
  vtkIndirectShadowMaps ActivateShadows(vtkOpenGLRenderWindow* window);
  void DeactivateShadows() const { this->Rows.Deactivate(); }
  ///@}

  /** Adds the maps and their memory to the report. */
  void AddToReport(vtkIndirectReport& report) const;
  void Print(ostream& os, vtkIndent indent) const;

protected:
  bool CanRelease(vtkWindow* window) override;
  void ReleaseOwn(vtkWindow*) override { this->Faces.clear(); }

private:
  void UpdateTable(const vtkIndirectFrame& frame);
  void UpdateFresnel(const vtkIndirectFrame& frame);
  void DrawFace(const vtkIndirectFrame& frame, vtkSurfaceCapturePass* capture,
    vtkIndirectLightMap& map, int face, const std::vector<const vtkIndirectCaster*>& casters);

  vtkObject* Caller;
  int Resolution = 0;    // resolution that the last frame asked for
  int Texels = 0;        // of the last frame
  int LightsTooMany = 0; // lights of the last frame without a map
  bool Specular = false;
  vtkIdType NumberOfFacesDrawn = 0;
  vtkTimeStamp ContentTime;
  // Binding textures changes the objects that hold them.
  mutable vtkIndirectLayeredTarget Target;
  mutable vtkIndirectShadowRows Rows{ this }; // rows of the target's depths, for shadow look-ups
  std::vector<std::unique_ptr<vtkIndirectLightMap>> Maps;
  int NumberOfMaps = 0;
  int NumberOfLayers = 0;
  std::vector<vtkIndirectKey> Faces; // the inputs of each layer's image; empty: not drawn
  std::vector<float> Table;
  vtkIndirectDataTexture TableTexture{ this };
  vtkIndirectDataTexture FresnelTexture{ this }; // empty unless senders have lobes
  vtkSmartPointer<vtkIndirectContextGuard> Guard;
};
