// SPDX-License-Identifier: BSD-3-Clause
// A framebuffer over square two-dimensional array textures, one layer a map.
#pragma once

#include "OpenGL/vtkIndirectChannel.h"  // for the table
#include "OpenGL/vtkIndirectProgram.h"  // for programs
#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "vtkSmartPointer.h"            // for members

#include <vector> // for textures

class vtkIndirectArrayTexture;
class vtkOpenGLFramebufferObject;
class vtkOpenGLRenderWindow;

class vtkIndirectLayeredTarget : public vtkIndirectResource
{
public:
  /** depth: true to add a depth array, for shadow look-ups. */
  vtkIndirectLayeredTarget(
    vtkIndirectResource* owner, const vtkIndirectChannels& channels, bool depth);
  ~vtkIndirectLayeredTarget() override;

  /** Uses only this many of the table's channels, from the first on; takes effect with Resize. */
  void SetNumberOfChannels(int count) { this->NumberOfChannels = count; }
  /** Returns the number that Resize has made. */
  int GetNumberOfChannels() const { return static_cast<int>(this->Textures.size()); }

  /**
   * Creates the textures; layers grow as needed and never shrink. Sets `lost` if the old content is
   * gone. Returns false if OpenGL cannot hold them, after one error for each new attempt.
   */
  bool Resize(vtkOpenGLRenderWindow* window, int texels, int layers, bool& lost);

  /** Binds one layer for drawing, and clears it if there are depths; pair with End. */
  void BeginLayer(int layer);
  void End();

  /** Binds a channel's array and sets its sampler; pair with Deactivate. */
  void Activate(int channel, const vtkIndirectProgram& program);
  /** Returns the texture unit with a channel's array bound; pair with Deactivate. */
  int Activate(int channel);
  /** Returns the texture unit with the depth array bound; pair with Deactivate. */
  int ActivateShadow();
  void Deactivate();

  int GetLayers() const { return this->Layers; }

protected:
  size_t GetOwnBytes() const override;
  void ReleaseOwn(vtkWindow* window) override;

private:
  const vtkIndirectChannels& Channels;
  const bool HasDepth;
  int NumberOfChannels;
  int Texels = 0;
  int Layers = 0;
  int RefusedTexels = 0; // sizes that the window could not hold
  int RefusedLayers = 0;
  vtkOpenGLRenderWindow* RefusedBy = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  vtkSmartPointer<vtkIndirectArrayTexture> Depth;
  std::vector<vtkSmartPointer<vtkIndirectArrayTexture>> Textures;
};
