// SPDX-License-Identifier: BSD-3-Clause
// The maps of a frame's lights: layers of array textures, as documented in
// vtkReflectiveShadowMapPass, and a depth array for percentage-closer shadow look-ups.
//
// A face is drawn again only when the light's place, anything that the face can see or the
// resolution has changed. A light's strength, falloff and exponent redraw nothing.
#pragma once

#include "Capture/vtkIndirectCasterDrawer.h"     // for a member
#include "Maps/vtkIndirectLightMap.h"            // for members
#include "OpenGL/vtkIndirectDataTexture.h"       // for members
#include "OpenGL/vtkIndirectFullScreenProgram.h" // for a member
#include "OpenGL/vtkIndirectKey.h"               // for keys
#include "OpenGL/vtkIndirectLayeredTarget.h"     // for members
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "vtkIndent.h"                           // for Print
#include "vtkSmartPointer.h"                     // for members
#include "vtkTimeStamp.h"                        // for a member

#include <set>    // for layers
#include <vector> // for maps

class vtkIndirectContextGuard;
class vtkOpenGLRenderWindow;
class vtkReflectiveShadowMapPass;
class vtkSurfaceCapturePass;
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
   * Brings the maps of the plan's lights up to date, and windows where the plan has shadows;
   * resolution: texels along an edge. Returns false, after an error, when OpenGL cannot hold them.
   */
  bool Update(const vtkIndirectFrame& frame, const vtkIndirectPlan& plan,
    vtkSurfaceCapturePass* capture, int resolution);
  /** Removes all maps. */
  void Clear() { this->Maps.clear(); }

  /** These are the contents of maps beside depths. */
  enum ContentType
  {
    SHADOWS,         // slopes: for shadows alone
    SENDERS,         // also surfaces that send light
    SPECULAR_SENDERS // also their specular reflections, which the capture must write
  };
  /** Chooses the content of the next maps. Default: SENDERS. */
  void SetContent(ContentType content) { this->Content = content; }
  /** Returns true if the maps hold surfaces that send light. */
  bool HasSenders() const;
  /** Returns true if the maps hold their specular reflections, so that shaders are built with
   * VTKI_LOBES. */
  bool HasSpecular() const;

  int GetNumberOfMaps() const { return static_cast<int>(this->Maps.size()); }
  int GetNumberOfLayers() const { return this->NumberOfLayers; }
  const vtkIndirectLightMap& GetMap(int i) const { return this->Maps[i]; }
  /** Returns the number of faces drawn since construction. */
  vtkIdType GetNumberOfFacesDrawn() const { return this->NumberOfFacesDrawn; }
  /**
   * Returns the texels along an edge in the last frame: the resolution, or less with many lights.
   */
  int GetTexels() const { return this->Texels; }
  /** Grows whenever the content of a map, or its part of the table below, changes. */
  vtkMTimeType GetContentTime() const { return this->ContentTime.GetMTime(); }
  /** Grows whenever the content of a window with senders changes, and when one comes or goes. */
  vtkMTimeType GetWindowTime() const { return this->WindowTime.GetMTime(); }

  /** Binds the maps and their table for vtkIndirectMapTexel.glsl. */
  void Activate(const vtkIndirectProgram& program) const;
  ///@{
  /** Bind the depths for shadow look-ups; pair. */
  vtkIndirectShadowMaps ActivateShadows(vtkOpenGLRenderWindow* window);
  void DeactivateShadows() { this->Rows.Deactivate(); }
  ///@}

  /** Adds the maps and their memory to the report. */
  void AddToReport(vtkIndirectReport& report) const;
  void Print(ostream& os, vtkIndent indent) const;

protected:
  bool CanRelease(vtkWindow* window) override;
  void ReleaseOwn(vtkWindow*) override { this->Faces.clear(); }

private:
  std::vector<const vtkIndirectCaster*> DrawShadows(const vtkIndirectFrame& frame,
    const vtkIndirectPlan& plan, const vtkIndirectDepthTile& view,
    const std::vector<const vtkIndirectCaster*>& casters);
  void UpdateTable(const vtkIndirectFrame& frame);
  void UpdateFresnel(const vtkIndirectFrame& frame);
  bool UpdateRows(vtkOpenGLRenderWindow* window);

  vtkObject* Caller;
  int Resolution = 0;    // resolution that the last frame asked for
  int Texels = 0;        // of the last frame
  int LightsTooMany = 0; // lights of the last frame without a map
  ContentType Content = SENDERS;
  vtkIdType NumberOfFacesDrawn = 0;
  vtkTimeStamp ContentTime;
  vtkTimeStamp WindowTime;
  std::vector<vtkIndirectKey> WindowKeys; // the inputs of the windows with senders
  vtkIndirectCasterDrawer Drawer{ this }; // for shadows alone
  // Binding textures changes the objects that hold them.
  mutable vtkIndirectLayeredTarget Target;
  // Depths in the form of shadow look-ups: a texel holds two neighbours of a row, and the slopes of
  // their surfaces. A fetch of four channels costs little more than a fetch of one.
  vtkIndirectLayeredTarget Rows;
  vtkIndirectFullScreenProgram RowKernel{ this, "vtkIndirectShadowRowsFS.glsl" };
  std::set<int> StaleRows; // layers whose depths are newer than their rows
  std::vector<vtkIndirectLightMap> Maps;
  // Windows are fitted to places that the eye sees, and kept while both stay.
  struct FittedWindow
  {
    vtkIndirectKey Inputs;
    vtkIndirectShadowMap::WindowType Window;
  };
  vtkIndirectKey SeenKey;
  std::vector<FittedWindow> FittedWindows; // of each map
  int NumberOfLayers = 0;                  // of maps
  int NumberOfWindows = 0;                 // the layers after those of maps
  std::vector<vtkIndirectKey> Faces;       // the inputs of each layer's image; empty: not drawn
  std::vector<float> Table;
  int LayersOfTable = 0; // of maps
  vtkIndirectDataTexture TableTexture{ this };
  vtkIndirectDataTexture FresnelTexture{ this }; // empty unless senders have lobes
  vtkSmartPointer<vtkIndirectContextGuard> Guard;
};
