// SPDX-License-Identifier: BSD-3-Clause
// A scene that bake.py has written, as a renderer.
#ifndef CardScene_h
#define CardScene_h

#include "vtkNew.h"          // for the renderer
#include "vtkRenderer.h"     // for the renderer
#include "vtkSmartPointer.h" // for the window

#include <string> // for names
#include <vector> // for layers

class vtkEGLHeadlessRenderWindow;

namespace card
{
/** Floats of an image, bottom row first. */
struct Image
{
  int Width = 0;
  int Height = 0;
  int Components = 0;
  std::vector<float> Values;

  const float* At(int x, int y) const
  {
    const size_t pixel = static_cast<size_t>(y) * this->Width + x;
    return &this->Values[this->Components * pixel];
  }
};

class Scene
{
public:
  /** Reads <folder>/scene.json and what it names. Throws std::runtime_error with one line. */
  explicit Scene(const std::string& folder);
  ~Scene();

  std::string Name;
  std::string Folder;
  vtkNew<vtkRenderer> Renderer;
  vtkSmartPointer<vtkEGLHeadlessRenderWindow> Window; // after Open

  /** Makes the window. Throws with the window's own line where no context can be made. */
  void Open(int width, int height);

  double GetDiagonal();

  /** R1, R2, R3 or mask, at the pixels of the reference. */
  Image ReadReference(const std::string& layer) const;
};
}

#endif
