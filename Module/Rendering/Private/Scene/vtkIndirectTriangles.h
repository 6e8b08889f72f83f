// SPDX-License-Identifier: BSD-3-Clause
// The triangles of a mesh: those of its polygons, as fans, and of its strips, as VTK winds them.
#pragma once

#include "vtkCellArray.h"         // for cells
#include "vtkCellArrayIterator.h" // for cells
#include "vtkPolyData.h"          // for meshes
#include "vtkSmartPointer.h"      // for iterators

#include <array> // for triangles

namespace vtkIndirectTriangles
{
using Points = std::array<vtkIdType, 3>; // numbers of points

/** Calls the function with the cell and the points of each triangle. */
template <typename Call>
void ForEach(vtkPolyData* mesh, const Call& call)
{
  // Cell data count vertices and lines first.
  vtkIdType cell = mesh->GetNumberOfVerts() + mesh->GetNumberOfLines();
  for (const bool strips : { false, true })
  {
    vtkCellArray* cells = strips ? mesh->GetStrips() : mesh->GetPolys();
    auto it = vtk::TakeSmartPointer(cells->NewIterator());
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
    {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      it->GetCurrentCell(count, ids);
      for (vtkIdType i = 2; i < count; ++i)
      {
        // Every second triangle of a strip has the opposite winding.
        const vtkIdType odd = strips ? i % 2 : 0;
        call(cell, Points{ ids[strips ? i - 2 + odd : 0], ids[i - 1 - odd], ids[i] });
      }
    }
  }
}
}
