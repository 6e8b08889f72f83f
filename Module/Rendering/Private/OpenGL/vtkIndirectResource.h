// SPDX-License-Identifier: BSD-3-Clause
// A part of a tree of graphics resources. A stage derives from this class, and its members that
// hold graphics resources name the stage as their owner. One call then releases, or counts, the
// resources of the stage and of all its members.
#pragma once

#include <cstddef> // for size_t
#include <vector>  // for the parts

class vtkWindow;

class vtkIndirectResource
{
public:
  /** owner: must live longer than this object; null: none. */
  explicit vtkIndirectResource(vtkIndirectResource* owner = nullptr);
  virtual ~vtkIndirectResource();
  vtkIndirectResource(const vtkIndirectResource&) = delete;
  void operator=(const vtkIndirectResource&) = delete;

  /** Releases the resources of the parts, then its own. The window's context must be current. */
  void Release(vtkWindow* window);
  /** Returns the bytes of the textures and buffers of this object and of its parts. */
  size_t GetBytes() const;

protected:
  /** Returns false if no resource can be in this window's context, so that Release does nothing. */
  virtual bool CanRelease(vtkWindow*) { return true; }
  /**
   * Releases resources that no part holds, and forgets what depends on the parts' content. May
   * destroy its own parts, but not those of its owner, which is releasing them.
   */
  virtual void ReleaseOwn(vtkWindow*) {}
  /** Returns the bytes that no part holds. */
  virtual size_t GetOwnBytes() const { return 0; }

private:
  vtkIndirectResource* Owner;
  std::vector<vtkIndirectResource*> Parts;
};
