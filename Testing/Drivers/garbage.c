/* SPDX-License-Identifier: BSD-3-Clause
 *
 * Loaded before a program (LD_PRELOAD), this fills memory that OpenGL allocates without contents:
 * textures of floats with NaN, all other memory with implausible bytes. Mesa's software allocates
 * zeros, a graphics card memory with old contents; reading before writing becomes visible here. For
 * VTK with GLEW, that is up to VTK 9.3.
 */
#define _GNU_SOURCE
#include <GL/gl.h>
#include <GL/glext.h>

#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef void (*Function)(void);
static Function (*GetProcAddress)(const GLubyte*);
static int Filled;

static Function Find(const char* name)
{
  if (!GetProcAddress)
  {
    GetProcAddress = (Function(*)(const GLubyte*))dlsym(RTLD_NEXT, "glXGetProcAddressARB");
  }
  return GetProcAddress((const GLubyte*)name);
}

/* Size for the largest texel: four components of eight bytes. */
static unsigned char* MakeGarbage(size_t texels, GLenum format, GLenum type)
{
  const size_t bytes = 32 * texels + 1;
  unsigned char* garbage = malloc(bytes);
  const float nan = NAN;
  const unsigned short halfNan = 0x7e00;
  size_t i;
  /* Depth formats have no NaN. */
  memset(garbage, format == GL_DEPTH_COMPONENT || format == GL_DEPTH_STENCIL ? 0x3e : 0xab, bytes);
  for (i = 0; type == GL_FLOAT && format != GL_DEPTH_COMPONENT && i + 4 <= bytes; i += 4)
  {
    memcpy(garbage + i, &nan, 4);
  }
  for (i = 0; type == GL_HALF_FLOAT && i + 2 <= bytes; i += 2)
  {
    memcpy(garbage + i, &halfNan, 2);
  }
  ++Filled;
  return garbage;
}

typedef void (*TexImage2D)(
  GLenum, GLint, GLint, GLsizei, GLsizei, GLint, GLenum, GLenum, const void*);

/* VTK links to this function, and looks up those below by their names. */
void glTexImage2D(GLenum target, GLint level, GLint internalFormat, GLsizei width, GLsizei height,
  GLint border, GLenum format, GLenum type, const void* data)
{
  unsigned char* garbage = data ? NULL : MakeGarbage((size_t)width * height, format, type);
  ((TexImage2D)dlsym(RTLD_NEXT, "glTexImage2D"))(target, level, internalFormat, width, height,
    border, format, type, data ? data : garbage);
  free(garbage);
}

static void FillTexImage3D(GLenum target, GLint level, GLint internalFormat, GLsizei width,
  GLsizei height, GLsizei depth, GLint border, GLenum format, GLenum type, const void* data)
{
  unsigned char* garbage = data ? NULL : MakeGarbage((size_t)width * height * depth, format, type);
  ((PFNGLTEXIMAGE3DPROC)Find("glTexImage3D"))(target, level, internalFormat, width, height, depth,
    border, format, type, data ? data : garbage);
  free(garbage);
}

static void FillBufferData(GLenum target, GLsizeiptr size, const void* data, GLenum usage)
{
  unsigned char* garbage = data ? NULL : MakeGarbage((size_t)size / 32 + 1, GL_RED, GL_BYTE);
  ((PFNGLBUFFERDATAPROC)Find("glBufferData"))(target, size, data ? data : garbage, usage);
  free(garbage);
}

Function glXGetProcAddressARB(const GLubyte* name)
{
  if (!strcmp((const char*)name, "glTexImage3D"))
  {
    return (Function)FillTexImage3D;
  }
  if (!strcmp((const char*)name, "glBufferData"))
  {
    return (Function)FillBufferData;
  }
  return Find((const char*)name);
}

Function glXGetProcAddress(const GLubyte* name)
{
  return glXGetProcAddressARB(name);
}

/* Lets the test check that these functions were called. */
__attribute__((destructor)) static void Say(void)
{
  fprintf(stderr, "garbage: %d\n", Filled);
}
