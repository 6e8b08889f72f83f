// SPDX-License-Identifier: BSD-3-Clause
// A compute program made from an embedded stage file. VTK 9.1 knows no compute shaders; to those
// who set uniforms this is a vtkShaderProgram like any other.
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
  /** stage: file in glsl/stage, or empty where SetText gives another text. */
  explicit vtkIndirectComputeProgram(const char* stage);
  ~vtkIndirectComputeProgram();

  /** Whether the current context has compute shaders and storage buffers: OpenGL 4.3. */
  static bool IsSupported();

  /** Lines that the text begins with, such as macros; new ones build the program anew. */
  void SetDefinitions(const std::string& definitions);

  /** A text in place of the stage's, whose first line is not used; another one builds anew. */
  void SetText(const std::string& text);

  /** Makes the program current. Returns nullptr, after an error, when it does not compile. */
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
