// SPDX-License-Identifier: BSD-3-Clause
// Direct light plus albedo times irradiance, and every channel of a frame as an image
//
// Draws over the target: background, gradients and transparency stay as they are, and the depth of
// the opaque props is written. Pixels of VTK's PBR are decoded with gamma 2.2, added to and encoded
// again; others are linear. VTK divides PBR's diffuse reflection by pi in its lights, while the
// irradiance here is physical over pi, so both kinds add albedo times E.
//
// Channels, as floats in world units and coordinates, background 0: `final`, `direct`, `indirect`
// (albedo E + glossy), `irradiance` (E) and its parts `sky`, `area` and `bounce`, `glossy`
// (specular reflection by receivers), `albedo`, `normal`, `depth` (along the view axis), `specular`
// (reflectance, and in a fourth component the power of the lobe, for VTK's PBR minus its roughness;
// zero if no specular reflection is computed).

#pragma once

#include "OpenGL/vtkIndirectResource.h"      // for the base class
#include "Picture/vtkIndirectLightBalance.h" // for balances
#include "Plan/vtkIndirectEstimate.h"        // for lists of light
#include "vtkIndent.h"                       // for printing

#include <functional>  // for other buffers
#include <glm/glm.hpp> // for colours
#include <memory>      // for the internals
#include <ostream>     // for printing
#include <string>      // for names
#include <vector>      // for lists

class vtkImageData;

class vtkIndirectComposite : public vtkIndirectResource
{
public:
  explicit vtkIndirectComposite(vtkIndirectResource* owner);
  ~vtkIndirectComposite() override;

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    const vtkIndirectLightMaps* Maps; // null without maps
    std::vector<vtkIndirectContribution> Lights;
    glm::dvec3 Greatest; // upper bound of the irradiance, without VTK's lights
    double IndirectScale;
    bool DepthCleared; // the bound framebuffer is empty
    bool DepthDrawn;   // the bound framebuffer has the depth of the frame's opaque props
    // VTK's light on props that catch light if nothing hid any; null: such props show nothing.
    const vtkIndirectTarget* OpenLit;
    // The frame's lights are lamps that light of a preset may replace.
    bool LampsAreReplaceable;
    vtkIndirectLightBalance Balance; // of lamps that are replaceable
  };

  /** Returns the index of a channel of the frame, or -1. */
  static int FindChannel(const std::string& name);
  /** Returns the map and channel (0 depth, 1 normal, 2 density) of a name such as rsm0.depth. */
  static bool ParseMapChannel(const std::string& name, int& map, int& channel);
  /** Returns the names accepted by FindChannel and ParseMapChannel, for messages. */
  static std::string GetChannelNames();
  /** Prints a line for each channel: name, meaning, unit, number of components. */
  static void PrintChannels(std::ostream& os, vtkIndent indent);

  /**
   * Measures the input's replaceable lamps and its lights, which have a strength of one here, in
   * blocks of pixels. Returns no blocks if OpenGL refuses.
   */
  std::vector<vtkIndirectLightBalance::Block> Measure(Input input);

  /** Draws the frame into the bound framebuffer. */
  bool Composite(const Input& input);

  /**
   * Renders a channel into an own image. Returns false for unknown names and maps that the frame
   * does not have.
   */
  bool RenderChannel(const Input& input, const std::string& name);
  /**
   * Renders another object's buffer: `draw` draws it, and returns the number of its components, 1
   * or 3, or 0 if it cannot.
   */
  bool RenderChannel(const Input& input, const std::function<int()>& draw);
  /** Copies the rendered channel: float, one component for lengths, three for colours and vectors,
   * four for specular. */
  void CopyImage(vtkImageData* image);
  /** Shows the rendered channel in the bound framebuffer. */
  bool ShowImage(const Input& input);

private:
  /** Multiplies the background by what props that catch light show of it. */
  bool Catch(const Input& input);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};
