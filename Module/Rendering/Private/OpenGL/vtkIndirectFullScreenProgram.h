// SPDX-License-Identifier: BSD-3-Clause
// A full-screen program made from an embedded stage file: a fragment shader, or, where it writes
// all of a target and is asked to by name (vtkIndirectPaths), the same text as a compute shader.
#ifndef vtkIndirectFullScreenProgram_h
#define vtkIndirectFullScreenProgram_h

#include <memory> // for the quad
#include <string> // for names

class vtkIndirectComputeProgram;
class vtkIndirectTarget;
class vtkOpenGLQuadHelper;
class vtkOpenGLRenderWindow;
class vtkShaderProgram;

class vtkIndirectFullScreenProgram
{
public:
  /** stage: file in glsl/stage; gather: the file that VTKI_GATHER stands for, if the stage has one.
   */
  vtkIndirectFullScreenProgram(const char* stage, const char* gather = "");

  ~vtkIndirectFullScreenProgram();

  /**
   * Makes the program current, building it on first use in this window.
   * Returns nullptr when it does not compile; VTK has reported why.
   * Programs with equal text are shared by VTK's cache: set every uniform before each Draw.
   */
  vtkShaderProgram* Use(vtkOpenGLRenderWindow* window);
  /** The same with SetDefinitions before. */
  vtkShaderProgram* Use(vtkOpenGLRenderWindow* window, const std::string& definitions);

  /**
   * The same for Draws that write all pixels and channels of a target, whose size is known, with no
   * test and no blending, or added to what is there: they may run as compute shaders. The target
   * stays until the last of them, begins and ends as for other Draws, and who adds blends for those
   * that are none.
   */
  vtkShaderProgram* Use(
    vtkOpenGLRenderWindow* window, const vtkIndirectTarget& target, bool adds = false);

  /** The file that VTKI_GATHER stands for; another one builds the program anew. */
  void SetGather(const std::string& gather);

  /** Lines that the text begins with, such as macros; new ones build the program anew. */
  void SetDefinitions(const std::string& definitions);

  /** Runs the program over the current viewport, or the target. */
  void Draw();

  void Release();

private:
  std::string GetComputeText(const vtkIndirectTarget& target, bool adds) const;
  void Dispatch();

  std::string Stage;
  std::string Gather;
  std::string Definitions;
  std::unique_ptr<vtkOpenGLQuadHelper> Quad;
  std::unique_ptr<vtkIndirectComputeProgram> Compute;
  std::string ComputeKey;                    // what its text was made for
  vtkShaderProgram* Current = nullptr;       // while it is to be dispatched
  const vtkIndirectTarget* Target = nullptr; // of that
};

#endif
