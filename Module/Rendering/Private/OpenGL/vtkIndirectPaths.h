// SPDX-License-Identifier: BSD-3-Clause
// Pairs of ways to do the same thing, of which one is faster on this hardware and the other on
// that. Each pair has a default for the OpenGL at hand, and a way is forced by its name in the
// environment, so that both can be compared on any card:
// VTK_INDIRECT_PATHS="clear=gl,uniforms=plain".
//
// Choices of a preset, such as the renderer of multiresolution splatting, are not among them.
#ifndef vtkIndirectPaths_h
#define vtkIndirectPaths_h

#include <string>  // for names
#include <utility> // for pairs
#include <vector>  // for lists

namespace vtkIndirectPaths
{
enum Path
{
  Clear,    // emptying the geometry buffer's colours
  Depth,    // bringing depth to the framebuffer that the frame goes to
  Grouping, // split texels that an invocation of multiresolution splatting works for
  Kernels,  // running full-screen kernels that write all of a target without tests
  Splats,   // summing splats of virtual lights
  Uniforms, // handing uniforms to fragment shaders
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
 * passes that are made, or released, after it has changed. A name that is not known, or a way that
 * this OpenGL cannot go, is one error, and all of the environment's text is ignored.
 */
int Get(Path path);

/** Pairs that this OpenGL has: name and value in force. */
std::vector<std::pair<std::string, std::string>> GetAll();

/** Each name with its values, whatever this OpenGL can do. */
std::vector<std::pair<std::string, std::vector<std::string>>> List();
}

#endif
