// SPDX-License-Identifier: BSD-3-Clause
// The actors that a prop draws (the prop itself, or the parts of an assembly), and the blocks of
// data that a mapper draws.
#pragma once

#include "vtkAlgorithm.h"             // for ports
#include "vtkCompositeDataIterator.h" // for blocks
#include "vtkCompositeDataSet.h"      // for blocks
#include "vtkSmartPointer.h"          // for blocks

#include <functional> // for calls

class vtkActor;
class vtkMatrix4x4;
class vtkProp;

namespace vtkIndirectActors
{
/**
 * Calls the function for each visible actor with a mapper in a prop, with the actor's matrix in
 * world coordinates.
 */
void ForEach(vtkProp* prop, const std::function<void(vtkActor*, vtkMatrix4x4*)>& call);

/**
 * Returns true if VTK runs the pipeline of a mapper. It never does that for a static one, which
 * draws the data that are there; only vtkDataSetMapper draws polygons by another mapper that runs.
 */
bool RunsPipeline(vtkAlgorithm* mapper);

/** Calls the function for data of a class, or for each block of that class in composite data. */
template <typename Data, typename Call>
void ForEachBlock(vtkDataObject* object, const Call& call)
{
  auto take = [&call](vtkDataObject* block)
  {
    if (auto* data = Data::SafeDownCast(block))
    {
      call(data);
    }
  };
  auto* composite = vtkCompositeDataSet::SafeDownCast(object);
  if (!composite)
  {
    take(object);
    return;
  }
  auto it = vtkSmartPointer<vtkCompositeDataIterator>::Take(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    take(it->GetCurrentDataObject());
  }
}

/**
 * Calls the function for such data and blocks of all connections of a port. Port 1 of a
 * vtkGlyph3DMapper has all of its sources, a table of sources too.
 */
template <typename Data, typename Call>
void ForEachBlockOfPort(vtkAlgorithm* algorithm, int port, const Call& call)
{
  for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
  {
    ForEachBlock<Data>(algorithm->GetInputDataObject(port, i), call);
  }
}
}
