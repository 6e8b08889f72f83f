// SPDX-License-Identifier: BSD-3-Clause
// Ways of doing the same thing, of which one is faster here and another there. Each has a default
// for the OpenGL at hand, and is forced by its name in the environment, so that they can be
// compared on any card: VTK_INDIRECT_PATHS="clear=gl,uniforms=plain".
//
// What users choose by a property (multiresolution's Renderer and Storage) is not among them.
#ifndef vtkIndirectPaths_h
#define vtkIndirectPaths_h

#include <string>  // for names
#include <utility> // for pairs
#include <vector>  // for lists

namespace vtkIndirectPaths
{
enum Path
{
  Clear,    // how the geometry buffer's colours are emptied
  Depth,    // how depth gets to the framebuffer that the frame goes to
  Grouping, // split texels that an invocation of multiresolution splatting works for
  Kernels,  // what full-screen kernels run as, where they write all of a target without tests
  Splats,   // how splats of virtual lights are summed
  Uniforms, // how fragment shaders get their uniforms
  NumberOfPaths
};

// Values of each, in the order of their names in vtkIndirectPaths.cxx.
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
 * The value in force in the current context. The environment is read at each call: it counts for
 * passes that are made, or released, after it has changed. What it names that is not known, or that
 * this OpenGL cannot do, is one error, and all of it is ignored.
 */
int Get(Path path);

/** All that this OpenGL can do: name and value in force. */
std::vector<std::pair<std::string, std::string>> GetAll();

/** Each name with its values, whatever this OpenGL can do. */
std::vector<std::pair<std::string, std::vector<std::string>>> List();
}

#endif
