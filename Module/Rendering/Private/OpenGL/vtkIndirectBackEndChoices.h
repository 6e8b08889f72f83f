// SPDX-License-Identifier: BSD-3-Clause
// Choices between equivalent implementations, whose speed depends on the OpenGL. Each has a default
// for the current OpenGL, and can be forced by its name in the environment for comparisons on any
// card: VTK_INDIRECT_PATHS="clear=gl,uniforms=plain".
//
// Choices that users make by a property (multiresolution's Renderer and Storage) are not included.
#ifndef vtkIndirectBackEndChoices_h
#define vtkIndirectBackEndChoices_h

#include <string>  // for names
#include <utility> // for pairs
#include <vector>  // for lists

namespace vtkIndirectBackEndChoices
{
enum Choice
{
  Clear,    // clearing of the geometry buffer's colours
  Depth,    // transfer of depth to the frame's target framebuffer
  Grouping, // split texels in one invocation of multiresolution splatting
  Kernels,  // stage of full-screen kernels that write all of a target without tests
  Splats,   // summation of virtual lights' splats
  Uniforms, // form of fragment shaders' uniforms
  NumberOfChoices
};

// Values of each, in the order of their names in vtkIndirectBackEndChoices.cxx.
enum ClearValue
{
  ClearByDraw,
  ClearByGL
};
enum DepthValue
{
  DepthByCopy,
  DepthByDraw
};
enum GroupingValue
{
  GroupingOfTwo,
  GroupingOfFour
};
enum KernelsValue
{
  KernelsFragment,
  KernelsCompute
};
enum SplatsValue
{
  SplatsBlended,
  SplatsInTiles
};
enum UniformsValue
{
  UniformsPlain,
  UniformsFlat
};

/**
 * The value in force in the current context. The environment is read at each call: a change affects
 * passes made, or released, afterwards. An unknown name, or a choice that this OpenGL does not
 * support, is one error, and the whole variable is ignored.
 */
int Get(Choice choice);

/** All choices that this OpenGL supports: name and value in force. */
std::vector<std::pair<std::string, std::string>> GetAll();

/** Each name with its values, independent of this OpenGL. */
std::vector<std::pair<std::string, std::vector<std::string>>> List();
}

#endif
