// SPDX-License-Identifier: BSD-3-Clause
// A compute program made from an embedded stage file. VTK 9.1 has no compute shaders; for setting
// uniforms this is an ordinary vtkShaderProgram.
#pragma once

#include "OpenGL/vtkIndirectProgram.h"  // for programs
#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "vtkSmartPointer.h"            // for the program

#include <string> // for names
#include <vector> // for units

class vtkIndirectCommandBuffer;
class vtkIndirectTarget;
class vtkOpenGLRenderWindow;

class vtkIndirectComputeProgram : public vtkIndirectResource
{
public:
  /** stage: the name of a file in glsl. */
  vtkIndirectComputeProgram(vtkIndirectResource* owner, const char* stage);
  ~vtkIndirectComputeProgram() override;

  /** Returns true if the current context has compute shaders and storage buffers, OpenGL 4.3, and
   * vtkIndirectBackEndChoices does not switch them off. */
  static bool IsSupported();

  /** Sets the first lines of the text, such as macros; a change rebuilds the program. */
  void SetDefinitions(const std::string& definitions);

  /** Makes the program current. Returns nullptr, after an error, if it does not compile. */
  vtkIndirectProgram Use(vtkOpenGLRenderWindow* window);

  /** Binds all channels of a target as images, from that unit on, for the next Run. */
  void AddImages(const vtkIndirectTarget& target, int unit = 0);

  ///@{
  /**
   * Runs the current program, after draws into its images and inputs and before the next use of its
   * results, and unbinds images: in groups of groupSize x groupSize invocations, which cover a
   * width and a height, or for the entries of a list.
   */
  void Run(int width, int height, int groupSize);
  void Run(const vtkIndirectCommandBuffer& lists, size_t list);
  ///@}

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  class Program;
  static void Begin();
  void End();

  std::string Stage;
  std::string Definitions;
  vtkSmartPointer<Program> Built;
  std::vector<unsigned int> Units; // units of images that are bound
};
