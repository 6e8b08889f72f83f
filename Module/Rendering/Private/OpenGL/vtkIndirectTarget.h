// SPDX-License-Identifier: BSD-3-Clause
// A framebuffer with the textures of a channel table, owned by the stage that writes it.
#pragma once

#include "OpenGL/vtkIndirectChannel.h"  // for the table
#include "OpenGL/vtkIndirectProgram.h"  // for programs
#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "vtkIndent.h"                  // for Print
#include "vtkOpenGLFramebufferObject.h" // for members
#include "vtkSmartPointer.h"            // for members
#include "vtkTextureObject.h"           // for members

#include <cstddef> // for size_t
#include <ostream> // for Print
#include <vector>  // for textures

class vtkOpenGLRenderWindow;

class vtkIndirectTarget : public vtkIndirectResource
{
public:
  /** depth: true adds a depth texture, of 32-bit floats or 16 bits, or makes only that if there are
   * no channels. The table must live as long as the target. */
  vtkIndirectTarget(vtkIndirectResource* owner, const vtkIndirectChannels& channels, bool depth,
    int depthBits = 32);
  ~vtkIndirectTarget() override;

  /** Uses only this many of the table's channels, from the first on; before Resize. */
  void SetNumberOfChannels(int count) { this->Limit = static_cast<size_t>(count); }

  /**
   * Creates or resizes the textures. `shared`: a target whose depth texture, at least as large,
   * replaces an own one. Returns false, after an error, if OpenGL refuses.
   */
  bool Resize(vtkOpenGLRenderWindow* window, int width, int height,
    const vtkIndirectTarget* shared = nullptr);

  /**
   * Takes the depth format of the framebuffer that is bound for drawing, so that CopyDepth can copy
   * to it, or else 32-bit floats; before Resize.
   */
  void MatchDepth();
  /**
   * Copies depth to the framebuffer that is bound for drawing, from `origin` on. Returns false,
   * without drawing, if the formats differ or either has samples.
   */
  bool CopyDepth(const int origin[2]) const;

  /**
   * Returns the target format for the content of the first colour buffer of the framebuffer that is
   * bound for drawing.
   */
  static unsigned int FindBoundColorFormat();
  /**
   * Copies that buffer, from `origin` on, to the first channel; of several samples their mean.
   * Returns false, after an error, if OpenGL refuses.
   */
  bool CopyBoundColor(const int origin[2]);
  /**
   * Copies a channel of a target of the same size to the first channel, which may have fewer
   * components. Returns false, after an error, if OpenGL refuses.
   */
  bool CopyFrom(const vtkIndirectTarget& source, int channel);

  /** Returns the bytes of a texel of an OpenGL format. */
  static size_t FindBytes(unsigned int internalFormat);
  /** Returns the distance between two depths near one. */
  double GetDepthStep() const;

  /** Binds for drawing to all channels with the viewport over the whole target. Pair with End. */
  void Begin();
  void End();

  /** Clears all channels to zero and depth to one; between Begin and End. */
  void Clear();
  /** Clears only depth: colours of many bytes cost as much to clear as to draw. */
  void ClearDepth();

  vtkOpenGLFramebufferObject* GetFramebuffer() const { return this->Framebuffer; }
  /** Returns the number that Resize has made. */
  int GetNumberOfChannels() const { return static_cast<int>(this->Textures.size()); }
  /** Returns the format of OpenGL. */
  unsigned int GetInternalFormat(int channel) const
  {
    return this->Channels[channel].InternalFormat;
  }
  vtkTextureObject* GetTexture(int channel) const { return this->Textures[channel]; }
  vtkTextureObject* GetDepthTexture() const { return this->Depth; }

  /** Binds a channel's texture and sets its sampler uniform. */
  void Activate(int channel, const vtkIndirectProgram& program) const;
  /** Binds under another name than the channel's own. */
  void Activate(int channel, const vtkIndirectProgram& program, const char* uniform) const;
  void ActivateDepth(const vtkIndirectProgram& program, const char* uniform) const;

  static constexpr int DepthChannel = -1;
  /** Reads a channel back, four floats a pixel, or depths, one float; bottom row first. */
  std::vector<float> ReadBack(int channel) const;

  /** Replaces a channel's content from a row on: four floats a pixel, bottom row first. */
  void Write(int channel, const std::vector<float>& values, int row = 0);

  /** Replaces depths of 32-bit floats in a rectangle, rows from the bottom. */
  void WriteDepth(const int first[2], const int size[2], const float* values);

  /** One line a channel: name, meaning, size, format, space and unit. */
  void Print(std::ostream& os, vtkIndent indent) const;

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }

protected:
  size_t GetOwnBytes() const override;
  void ReleaseOwn(vtkWindow* window) override;

private:
  void ActivateChannels();

  const vtkIndirectChannels& Channels;
  bool WithDepth;
  int DepthBits;
  int DepthFormat = -1; // format of vtkTextureObject to match; -1: none, use DepthBits
  int AllocatedDepth = -1;
  mutable bool DepthRefused = false; // OpenGL has refused to copy this format
  size_t Limit = static_cast<size_t>(-1);
  vtkSmartPointer<vtkTextureObject> SharedDepth; // the attached texture
  int Width = 0;
  int Height = 0;
  vtkOpenGLRenderWindow* Window = nullptr;
  vtkSmartPointer<vtkOpenGLFramebufferObject> Framebuffer;
  std::vector<vtkSmartPointer<vtkTextureObject>> Textures;
  vtkSmartPointer<vtkTextureObject> Depth;
};
