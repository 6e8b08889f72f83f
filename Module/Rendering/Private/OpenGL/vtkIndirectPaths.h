// SPDX-License-Identifier: BSD-3-Clause
// Choices between two ways of doing the same thing, of which one is faster on a processor and the
// other may be faster on a GPU. Each choice has a default for the OpenGL at hand, and a name in the
// environment forces it, so that both ways can be compared on any card:
// VTK_INDIRECT_PATHS="kernels=compute,uniforms=plain".
#ifndef vtkIndirectPaths_h
#define vtkIndirectPaths_h

#include <string>  // for names
#include <utility> // for pairs
#include <vector>  // for lists

namespace vtkIndirectPaths
{
enum Path
{
  Grouping, // an invocation of multiresolution splatting works for two split texels or for four
  Kernels,  // full-screen kernels that write all of a target are fragment or compute shaders
  Splats,   // splats of virtual lights are blended or summed in tiles
  Uniforms, // fragment shaders read uniforms or get them as flat varyings
  NumberOfPaths
};

// The values of each choice, in the order of their names in vtkIndirectPaths.cxx.
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
 * Returns the value in force in the current context. Each call reads the environment: a change
 * counts for passes that are made, or released, after it. An unknown name, or a value that this
 * OpenGL lacks, is one error, and the whole variable is ignored.
 */
int Get(Path path);

/** Returns name and value in force of each choice that this OpenGL has. */
std::vector<std::pair<std::string, std::string>> GetAll();

/** Returns each name with its values, whatever this OpenGL can do. */
std::vector<std::pair<std::string, std::vector<std::string>>> List();
}

#endif
