// SPDX-License-Identifier: BSD-3-Clause
// The visible share of the sky does not depend on the eye: places that a moving eye sees again keep
// the smoothed share of the last frame, a still one or a moving one, see vtkIndirectReprojection.
// Directions are summed at the other places, and at their neighbours, whose sums these places need.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "Sums/vtkIndirectReprojection.h"        // for a member

#include <functional> // for uniforms
#include <memory>     // for targets
#include <string>     // for definitions

class vtkIndirectSkyReprojection : public vtkIndirectResource
{
public:
  explicit vtkIndirectSkyReprojection(vtkIndirectResource* owner);

  static const vtkIndirectChannels ShareChannels;

  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectGeometryBuffer& Geometry;
    int Step; // edge of the blocks of pixels that share directions
  };

  /** Fills the shares of a moving frame with kept ones. Within a vtkIndirectFullScreenState. */
  bool Begin(const Input& input);
  /** Returns true if some pixels have shares of the last frame. */
  bool IsReprojected() const { return this->Reprojected; }
  /**
   * Target of the shares. A share of the last frame has a negative radius: it is smoothed already.
   */
  vtkIndirectTarget& GetShares() { return *this->Now; }
  /**
   * Definition of shaders that sum directions at some blocks of pixels alone, and binding of these
   * blocks; empty, and without effect, if all blocks sum directions.
   */
  std::string GetDefinition() const;
  /** Returns what the report says of a frame that keeps shares. */
  std::string GetMeaning() const { return this->Reprojection.GetMeaning(); }
  void Activate(const vtkIndirectProgram& program) const;
  /**
   * Draws over a target that is or shares the depth of the shares, at the pixels that have no share
   * of the last frame.
   */
  bool DrawFresh(vtkOpenGLRenderWindow* window, vtkIndirectFullScreenProgram& kernel,
    vtkIndirectTarget& target, const std::function<void(const vtkIndirectProgram&)>& set);
  /** Keeps the smoothed shares of a moving frame for the next frame. */
  bool Keep(const Input& input);
  /** Keeps the smoothed shares of a still frame for the first moving frame. */
  bool KeepStill(const Input& input, const vtkIndirectTarget& shares);

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  bool Resize(const vtkIndirectFrame& frame);
  bool FindFreshBlocks(const Input& input);

  vtkIndirectReprojection Reprojection;
  std::unique_ptr<vtkIndirectTarget> Now;
  vtkIndirectTarget Fresh;  // blocks with pixels that have no share of the last frame
  vtkIndirectTarget Spread; // these blocks and those beside them
  vtkIndirectFullScreenProgram FindFresh{ this, "vtkIndirectSkyFreshFS.glsl" };
  vtkIndirectFullScreenProgram SpreadFresh{ this, "vtkIndirectSkyFreshFS.glsl" };
  bool Reprojected = false;
};
