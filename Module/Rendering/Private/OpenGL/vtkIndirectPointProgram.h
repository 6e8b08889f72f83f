// SPDX-License-Identifier: BSD-3-Clause
// A program of a vertex and a fragment stage file. It draws points, or a rectangle of four, which
// its vertex shader makes from their numbers, or what its user draws.
#pragma once

#include "OpenGL/vtkIndirectProgram.h"  // for programs
#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "vtkOpenGLRenderWindow.h"      // for the weak pointer
#include "vtkWeakPointer.h"             // for the context

#include <string> // for names

class vtkIndirectPointProgram : public vtkIndirectResource
{
public:
  /**
   * Files in glsl. varyings: most components of varyings in which a back end without fast uniforms
   * hands uniforms to the fragment shader (vtkIndirectFlatUniforms).
   */
  vtkIndirectPointProgram(vtkIndirectResource* owner, const char* vertexStage,
    const char* fragmentStage, int varyings = 0);
  ~vtkIndirectPointProgram() override;

  /**
   * Makes the program current, with these lines at the beginning of both texts. Returns nullptr if
   * it does not compile; VTK has reported why. Set every uniform before each Draw.
   */
  vtkIndirectProgram Use(vtkOpenGLRenderWindow* window, const std::string& definitions);

  /** Draws points 0 to count - 1, squares of this many pixels. */
  void Draw(int count, int pixels);

  /** Draws the rectangle of corners 0 to 3, corners 2 and 3 beside 0 and 1. */
  void DrawRectangle();

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  std::string VertexStage;
  std::string FragmentStage;
  int Varyings;
  std::string Definitions;
  std::string VertexText;
  std::string FragmentText;
  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  unsigned int VertexArray = 0; // core profiles draw nothing without one
};
