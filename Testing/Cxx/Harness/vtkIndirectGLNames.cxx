// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGLNames.h"

#include "vtkIndirectContractUtilities.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include "vtkRenderWindow.h"

namespace contract
{
//------------------------------------------------------------------------------
bool Names::operator==(const Names& other) const
{
  return this->Textures == other.Textures && this->Framebuffers == other.Framebuffers &&
    this->Renderbuffers == other.Renderbuffers && this->Buffers == other.Buffers &&
    this->VertexArrays == other.VertexArrays && this->Programs == other.Programs;
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const Names& names)
{
  return os << names.Textures << " textures, " << names.Framebuffers << " framebuffers, "
            << names.Renderbuffers << " renderbuffers, " << names.Buffers << " buffers, "
            << names.VertexArrays << " vertex arrays, " << names.Programs << " programs";
}

//------------------------------------------------------------------------------
Names CountNames(vtkRenderWindow* window)
{
  window->MakeCurrent();
  Names names;
  // Names are given from one on, and reused: here far fewer than this exist at a time.
  for (GLuint i = 1; i < 4000; ++i)
  {
    names.Textures += glIsTexture(i) ? 1 : 0;
    names.Framebuffers += glIsFramebuffer(i) ? 1 : 0;
    names.Renderbuffers += glIsRenderbuffer(i) ? 1 : 0;
    names.Buffers += glIsBuffer(i) ? 1 : 0;
    names.VertexArrays += glIsVertexArray(i) ? 1 : 0;
    names.Programs += glIsProgram(i) ? 1 : 0;
  }
  return names;
}

//------------------------------------------------------------------------------
void CheckGivenBack(const Names& before, const Names& after)
{
  CONTRACT_CHECK(after.Textures == before.Textures, "textures");
  CONTRACT_CHECK(after.Framebuffers == before.Framebuffers, "framebuffers");
  CONTRACT_CHECK(after.Renderbuffers == before.Renderbuffers, "renderbuffers");
  CONTRACT_CHECK(after.Buffers == before.Buffers, "buffers");
  CONTRACT_CHECK(after.VertexArrays == before.VertexArrays, "vertex arrays");
}
}
