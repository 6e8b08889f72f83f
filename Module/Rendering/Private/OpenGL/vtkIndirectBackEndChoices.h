// SPDX-License-Identifier: BSD-3-Clause
// Choices between equivalent implementations, which depend on the OpenGL. Each choice has a default
// for the current OpenGL, and the environment can force a value by its name, for comparisons on any
// card: VTK_INDIRECT_PATHS="compute=off,uniforms=plain".
#pragma once

#include <string>  // for names
#include <utility> // for pairs
#include <vector>  // for lists

namespace vtkIndirectBackEndChoices
{
enum Choice
{
  Compute,   // use of compute shaders
  Depth,     // transfer of depth to the frame's target framebuffer
  Grouping,  // split texels in one invocation of multiresolution splatting
  Uniforms,  // form of fragment shaders' uniforms
  Triangles, // triangles that OpenGL draws into maps of few texels
  NumberOfChoices
};

// Values of each, in the order of their names in vtkIndirectBackEndChoices.cxx.
enum ComputeValue
{
  ComputeOn,
  ComputeOff
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
enum UniformsValue
{
  UniformsPlain,
  UniformsFlat
};
enum TrianglesValue
{
  TrianglesAll,
  TrianglesOfTexels
};

/**
 * Returns the value in force in the current context. The environment is read at each call: a change
 * affects passes made, or released, afterwards. An unknown name, or a choice that this OpenGL does
 * not support, is one error, and the whole variable is ignored.
 */
int Get(Choice choice);

/** Returns all choices that this OpenGL supports: name and value in force. */
std::vector<std::pair<std::string, std::string>> GetAll();

/** Returns each name with its values, independent of this OpenGL. */
std::vector<std::pair<std::string, std::vector<std::string>>> List();
}
