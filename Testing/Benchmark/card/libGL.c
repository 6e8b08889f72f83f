/* libGL.so.1 of a pack. VTK's and GLEW's libraries are linked to that of GLX, and where a driver
 * has EGL only there is none. Each function of OpenGL goes on to what libEGL.so.1 says it is, asked
 * for when it is first called. There is no X: each function of GLX returns zero.
 *
 * gl_functions.h is written when the pack is made, from what the packed libraries ask for:
 *   GL_FUNCTION(glClear)   in any order, each once
 *   GLX_FUNCTION(glXIsDirect)
 */
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

typedef void (*Function)(void);

static Function (*getProcAddress)(const char*);

static void fail(const char* what, const char* name)
{
  fprintf(stderr, "gpu: %s%s\n", what, name);
  fflush(NULL);
  _exit(1);
}

/* Threads that come here at the same time find the same. */
static Function find(const char* name)
{
  if (!getProcAddress)
  {
    void* library = dlopen("libEGL.so.1", RTLD_NOW | RTLD_GLOBAL);
    if (!library)
    {
      fail("no libEGL.so.1: install the driver's EGL (Debian: libegl1)", "");
    }
    *(void**)&getProcAddress = dlsym(library, "eglGetProcAddress");
    if (!getProcAddress)
    {
      fail("libEGL.so.1 has no eglGetProcAddress", "");
    }
  }
  return getProcAddress(name);
}

static const char* const names[] = {
#define GL_FUNCTION(name) #name,
#define GLX_FUNCTION(name)
#include "gl_functions.h"
#undef GL_FUNCTION
};

/* Called from the assembly below, with what is to be called in the end. */
__attribute__((used, visibility("hidden"))) Function vtkIndirectFindFunction(unsigned long index)
{
  Function function = find(names[index]);
  if (!function)
  {
    fail("the driver has no ", names[index]);
  }
  return function;
}

/* A function jumps to its target. In the beginning, that finds the right one and puts it there; all
 * registers that can hold arguments are the caller's again after it. */
__asm__(".text\n"
        "vtkIndirectFirstCall:\n" /* the index is on the stack, which is aligned to 16 bytes */
        "  push %rdi\n  push %rsi\n  push %rdx\n  push %rcx\n"
        "  push %r8\n  push %r9\n  push %rax\n  push %r10\n"
        "  sub $128, %rsp\n"
        "  movups %xmm0, 0(%rsp)\n  movups %xmm1, 16(%rsp)\n"
        "  movups %xmm2, 32(%rsp)\n  movups %xmm3, 48(%rsp)\n"
        "  movups %xmm4, 64(%rsp)\n  movups %xmm5, 80(%rsp)\n"
        "  movups %xmm6, 96(%rsp)\n  movups %xmm7, 112(%rsp)\n"
        "  mov 192(%rsp), %rdi\n"
        "  call vtkIndirectFindFunction\n"
        "  lea vtkIndirectTargets(%rip), %r11\n"
        "  mov 192(%rsp), %r10\n"
        "  mov %rax, (%r11, %r10, 8)\n"
        "  mov %rax, %r11\n"
        "  movups 0(%rsp), %xmm0\n  movups 16(%rsp), %xmm1\n"
        "  movups 32(%rsp), %xmm2\n  movups 48(%rsp), %xmm3\n"
        "  movups 64(%rsp), %xmm4\n  movups 80(%rsp), %xmm5\n"
        "  movups 96(%rsp), %xmm6\n  movups 112(%rsp), %xmm7\n"
        "  add $128, %rsp\n"
        "  pop %r10\n  pop %rax\n  pop %r9\n  pop %r8\n"
        "  pop %rcx\n  pop %rdx\n  pop %rsi\n  pop %rdi\n"
        "  add $8, %rsp\n"
        "  jmp *%r11\n"
        ".section .data.targets, \"aw\"\n"
        ".balign 8\n"
        "vtkIndirectTargets:\n"
        ".set vtkIndirectIndex, 0\n"
        ".text\n");

#define GL_FUNCTION(name)                                                                          \
  __asm__(".text\n"                                                                                \
          ".globl " #name "\n"                                                                     \
          ".type " #name ", @function\n"                                                           \
          ".balign 16\n" #name ":\n"                                                               \
          "  jmp *target_" #name "(%rip)\n"                                                        \
          "first_" #name ":\n"                                                                     \
          "  pushq $vtkIndirectIndex\n"                                                            \
          "  jmp vtkIndirectFirstCall\n"                                                           \
          ".size " #name ", . - " #name "\n"                                                       \
          ".section .data.targets, \"aw\"\n"                                                       \
          "target_" #name ": .quad first_" #name "\n"                                              \
          ".set vtkIndirectIndex, vtkIndirectIndex + 1\n"                                          \
          ".text\n");
#include "gl_functions.h"
#undef GL_FUNCTION
#undef GLX_FUNCTION

static void* nothing(void)
{
  return NULL;
}

#define GL_FUNCTION(name)
#define GLX_FUNCTION(name)                                                                         \
  void* name(void)                                                                                 \
  {                                                                                                \
    return NULL;                                                                                   \
  }
#include "gl_functions.h"

/* GLEW asks here for functions of GLX, too, and calls them. */
Function glXGetProcAddressARB(const char* name)
{
  return strncmp(name, "glX", 3) == 0 ? (Function)nothing : find(name);
}

Function glXGetProcAddress(const char* name)
{
  return glXGetProcAddressARB(name);
}
