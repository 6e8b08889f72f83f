// SPDX-License-Identifier: BSD-3-Clause
// The glyphs of a vtkGlyph3DMapper: their places, turns and scales, and the source of each.
#pragma once

#include "vtkType.h" // for ids

#include <functional>  // for calls
#include <glm/glm.hpp> // for matrices
#include <vector>      // for sources

class vtkDataSet;
class vtkGlyph3DMapper;
class vtkPolyData;

namespace vtkIndirectGlyphs
{
struct Instance
{
  vtkIdType Point;         // the point of the data whose colour the glyph has
  size_t Source;           // number of the source
  glm::dmat4 ToData{ 1 };  // from the source's coordinates to the data's
  glm::dvec3 Factors{ 1 }; // scale along each axis
};

/** Returns the meshes of each source, by number. */
std::vector<std::vector<vtkPolyData*>> FindSources(vtkGlyph3DMapper* mapper);
/**
 * Calls the function with all instances at the points of a data set, placed as by
 * vtkOpenGLGlyph3DMapper.
 */
void ForEach(vtkGlyph3DMapper* mapper, vtkDataSet* data, size_t numberOfSources,
  const std::function<void(const Instance&)>& call);
}
