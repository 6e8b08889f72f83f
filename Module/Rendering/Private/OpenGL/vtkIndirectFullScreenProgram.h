// SPDX-License-Identifier: BSD-3-Clause
// A full-screen program whose fragment shader is an embedded stage file.
#pragma once

#include "OpenGL/vtkIndirectProgram.h"  // for programs
#include "OpenGL/vtkIndirectResource.h" // for the base class

#include <functional> // for the setting of uniforms
#include <memory>     // for the quad
#include <string>     // for names

class vtkIndirectTarget;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;

class vtkIndirectFullScreenProgram : public vtkIndirectResource
{
public:
  /** stage: the name of a file in glsl; gather: the file for VTKI_GATHER, if the stage has one. */
  vtkIndirectFullScreenProgram(
    vtkIndirectResource* owner, const char* stage, const char* gather = "");
  ~vtkIndirectFullScreenProgram() override;

  /**
   * Makes the program current, building it on first use in this window. Returns nullptr if it does
   * not compile; VTK has reported why. VTK's cache shares programs with equal text: set every
   * uniform before each Draw.
   */
  vtkIndirectProgram Use(vtkOpenGLRenderWindow* window);
  /** Use after SetDefinitions. */
  vtkIndirectProgram Use(vtkOpenGLRenderWindow* window, const std::string& definitions);

  /** Sets the first lines of the text, such as macros; a change rebuilds the program. */
  void SetDefinitions(const std::string& definitions);

  /** Runs the program over the current viewport. */
  void Draw();

  /**
   * Draws over a target: uses the program, calls `set`, which sets the uniforms, and runs the
   * program. Returns false if the program does not compile.
   */
  bool Run(vtkOpenGLRenderWindow* window, vtkIndirectTarget& target,
    const std::function<void(const vtkIndirectProgram&)>& set);

  /**
   * Does the same where something was drawn: where the depth that the target shares is less than
   * one. Other pixels become zero. The depth test branches where software's shaders cannot, and
   * background fills most of many pictures. Within a vtkIndirectFullScreenState.
   */
  bool RunOnSurfaces(vtkOpenGLRenderWindow* window, vtkIndirectTarget& target,
    const std::function<void(const vtkIndirectProgram&)>& set);

  /**
   * Does the same for a table of lights, of which each draw takes at most `most` rows: the target
   * has the sum of all draws. Within a vtkIndirectFullScreenState.
   */
  bool RunRows(vtkOpenGLRenderWindow* window, vtkIndirectTarget& target, int rows, int most,
    const std::function<void(const vtkIndirectProgram&)>& set);

  /** Draws once for each block of rows, which the uniform vtkiLightRows tells. */
  void DrawRows(const vtkIndirectProgram& program, int rows, int most);

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  std::string Stage;
  std::string Gather;
  std::string Definitions;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};
