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
  /** stage: file in glsl/stage, or empty if SetText sets another text. */
  explicit vtkIndirectComputeProgram(const char* stage);
  ~vtkIndirectComputeProgram();

  /** True if the current context has compute shaders and storage buffers: OpenGL 4.3. */
  static bool IsSupported();

  /** Sets the first lines of the text, such as macros; a change rebuilds the program. */
  void SetDefinitions(const std::string& definitions);

  /** Sets a text in place of the stage's, whose first line is ignored; a change rebuilds the
   * program. */
  void SetText(const std::string& text);

  /** Makes the program current. Returns nullptr, after an error, if it does not compile. */
  vtkShaderProgram* Use(vtkOpenGLRenderWindow* window);

  void Release(vtkWindow* window);

private:
  class Program;
  std::string Stage;
  std::string Text;
  std::string Definitions;
  vtkSmartPointer<Program> Built;
};

#endif
