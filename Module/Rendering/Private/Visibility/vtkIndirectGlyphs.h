// SPDX-License-Identifier: BSD-3-Clause
// Where vtkGlyph3DMapper puts its glyphs, how it turns and scales them, and which it takes.
#ifndef vtkIndirectGlyphs_h
#define vtkIndirectGlyphs_h

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
  vtkIdType Point;         // of the data, whose colour it has
  size_t Source;           // its number
  glm::dmat4 ToData{ 1 };  // from the source's coordinates
  glm::dvec3 Factors{ 1 }; // by which it is scaled
};

/** What each source draws, by number. */
std::vector<std::vector<vtkPolyData*>> FindSources(vtkGlyph3DMapper* mapper);
/** Calls with all instances at the points of a data set, as vtkOpenGLGlyph3DMapper places them. */
void ForEach(vtkGlyph3DMapper* mapper, vtkDataSet* data, size_t numberOfSources,
  const std::function<void(const Instance&)>& call);
/** Calls with all data sets of an input. */
void ForEachDataSet(vtkGlyph3DMapper* mapper, const std::function<void(vtkDataSet*)>& call);
}
#endif
