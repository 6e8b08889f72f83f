// SPDX-License-Identifier: BSD-3-Clause
// A full-screen fragment program made from an embedded stage file.
#ifndef vtkIndirectKernelProgram_h
#define vtkIndirectKernelProgram_h

#include <memory> // for the quad
#include <string> // for names

class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class vtkIndirectKernelProgram
{
public:
  /** stage: file in glsl/stage; gather: the file that VTKI_GATHER stands for, if the stage has one.
   */
  vtkIndirectKernelProgram(const char* stage, const char* gather = "");

  ~vtkIndirectKernelProgram();

  /**
   * Makes the program current, building it on first use in this window.
   * Returns nullptr when it does not compile; VTK has reported why.
   * Programs with equal text are shared by VTK's cache: set every uniform before each Draw.
   */
  vtkShaderProgram* Use(vtkOpenGLRenderWindow* window);
  /** The same with SetDefinitions before. */
  vtkShaderProgram* Use(vtkOpenGLRenderWindow* window, const std::string& definitions);

  /** The file that VTKI_GATHER stands for; another one builds the program anew. */
  void SetGather(const std::string& gather);

  /** Lines that the text begins with, such as macros; new ones build the program anew. */
  void SetDefinitions(const std::string& definitions);

  /** Runs the program over the current viewport. */
  void Draw();

  void Release();

private:
  std::string Stage;
  std::string Gather;
  std::string Definitions;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
};

#endif
