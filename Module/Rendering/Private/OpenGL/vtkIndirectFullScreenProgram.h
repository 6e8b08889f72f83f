// SPDX-License-Identifier: BSD-3-Clause
// A full-screen program made from an embedded stage file: a fragment shader, or, if it writes all
// of a target and vtkIndirectBackEndChoices selects it, the same text as a compute shader.
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
  /** stage: file in glsl/stage; gather: the file for VTKI_GATHER, if the stage has one.
   */
  vtkIndirectFullScreenProgram(const char* stage, const char* gather = "");

  ~vtkIndirectFullScreenProgram();

  /**
   * Makes the program current, building it on first use in this window. Returns nullptr if it does
   * not compile; VTK has reported why. VTK's cache shares programs with equal text: set every
   * uniform before each Draw.
   */
  vtkShaderProgram* Use(vtkOpenGLRenderWindow* window);
  /** Use after SetDefinitions. */
  vtkShaderProgram* Use(vtkOpenGLRenderWindow* window, const std::string& definitions);

  /**
   * Use for Draws that write, or add to, all pixels and channels of a target of known size without
   * tests or blending: they may run as compute shaders. The target must exist until the last Draw,
   * and begins and ends as for other Draws; a caller that adds also enables blending, for the case
   * of fragment shaders.
   */
  vtkShaderProgram* Use(
    vtkOpenGLRenderWindow* window, const vtkIndirectTarget& target, bool adds = false);

  /** Sets the file for VTKI_GATHER; a change rebuilds the program. */
  void SetGather(const std::string& gather);

  /** Sets the first lines of the text, such as macros; a change rebuilds the program. */
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
  std::string ComputeKey;                    // inputs of its text
  vtkShaderProgram* Current = nullptr;       // while it is ready to dispatch
  const vtkIndirectTarget* Target = nullptr; // target of Current
};

#endif
