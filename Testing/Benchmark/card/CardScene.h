// SPDX-License-Identifier: BSD-3-Clause
// A scene that bake.py has written, as a renderer.
#ifndef CardScene_h
#define CardScene_h

#include "vtkIndirectTestUtilities.h" // for images
#include "vtkNew.h"                   // for the renderer
#include "vtkRenderer.h"              // for the renderer
#include "vtkSmartPointer.h"          // for the window

#include <string> // for names

class vtkEGLHeadlessRenderWindow;
class vtkImageData;

namespace card
{
/** Floats of an image, bottom row first. */
using Image = vtkIndirectTest::Image;

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
  Image GetReference(const std::string& layer);

private:
  vtkSmartPointer<vtkImageData> References; // all layers, once one was asked for
};
}

#endif
