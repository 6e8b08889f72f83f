// SPDX-License-Identifier: BSD-3-Clause
// A compute program made from an embedded stage file. VTK 9.1 has no compute shaders; for setting
// uniforms this is an ordinary vtkShaderProgram.
#ifndef vtkIndirectComputeProgram_h
#define vtkIndirectComputeProgram_h

#include "vtkSmartPointer.h" // for the program

#include <string> // for names

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkWindow;

class vtkIndirectComputeProgram
{
public:
  /** stage: the name of a file in glsl. */
  explicit vtkIndirectComputeProgram(const char* stage);
  ~vtkIndirectComputeProgram();

  /** True if the current context has compute shaders and storage buffers, OpenGL 4.3, and
   * vtkIndirectBackEndChoices does not switch them off. */
  static bool IsSupported();

  /** Sets the first lines of the text, such as macros; a change rebuilds the program. */
  void SetDefinitions(const std::string& definitions);

  /** Makes the program current. Returns nullptr, after an error, if it does not compile. */
  vtkShaderProgram* Use(vtkOpenGLRenderWindow* window);

  void Release(vtkWindow* window);

private:
  class Program;
  std::string Stage;
  std::string Definitions;
  vtkSmartPointer<Program> Built;
};

#endif
