// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectResource.h"

#include <algorithm>

vtkIndirectResource::vtkIndirectResource(vtkIndirectResource* owner)
  : Owner(owner)
{
  if (owner)
  {
    owner->Parts.push_back(this);
  }
}

//------------------------------------------------------------------------------
vtkIndirectResource::~vtkIndirectResource()
{
  if (this->Owner)
  {
    auto& parts = this->Owner->Parts;
    parts.erase(std::find(parts.begin(), parts.end(), this));
  }
}

//------------------------------------------------------------------------------
void vtkIndirectResource::Release(vtkWindow* window)
{
  if (!this->CanRelease(window))
  {
    return;
  }
  for (vtkIndirectResource* part : this->Parts)
  {
    part->Release(window);
  }
  this->ReleaseOwn(window);
}

//------------------------------------------------------------------------------
size_t vtkIndirectResource::GetBytes() const
{
  size_t bytes = this->GetOwnBytes();
  for (const vtkIndirectResource* part : this->Parts)
  {
    bytes += part->GetBytes();
  }
  return bytes;
}
