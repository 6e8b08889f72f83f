// SPDX-License-Identifier: BSD-3-Clause
// A tree of spheres in the form that shaders read: tables of entries, of bounding boxes of blocks
// of them, and of senders.
#pragma once

#include "OpenGL/vtkIndirectResource.h"    // for the base class
#include "OpenGL/vtkIndirectTarget.h"      // for members
#include "Proxies/vtkIndirectProxyLight.h" // for polygons
#include "Proxies/vtkIndirectProxyTree.h"  // for entries

#include <vector> // for polygons

class vtkIndirectProxyTreeTables : public vtkIndirectResource
{
public:
  explicit vtkIndirectProxyTreeTables(vtkIndirectResource* owner);

  /** Uploads entries. Returns false, after an error, if OpenGL refuses. */
  bool Update(vtkOpenGLRenderWindow* window, const vtkIndirectProxyTree& tree,
    const std::vector<vtkIndirectProxyPolygon>& polygons);

  void Activate(const vtkIndirectProgram& program) const;
  /** Sets the size of a table's texel over the table's width and height, for rows of
   * VTKI_ROW_LENGTH. */
  static void SetTexelSize(
    const vtkIndirectProgram& program, const char* name, const vtkIndirectTarget& table);

  /** Returns the polygons that send light: the largest of those given to Update. */
  const std::vector<vtkIndirectProxyPolygon>& GetPolygons() const { return this->Polygons; }
  bool HasGroups() const { return this->HasAnyGroups; }
  int GetNumberOfEntries() const { return this->NumberOfEntries; }
  int GetNumberOfSenders() const { return this->NumberOfSenders; }
  /** Returns the number of the first sender that is a place of a polygon. */
  int GetFirstPlace() const { return this->FirstPlace; }
  const vtkIndirectTarget& GetEntries() const { return this->Rows; }
  const vtkIndirectTarget& GetSenders() const { return this->Senders; }
  /** Ranges of senders whose mean an entry sends. */
  const vtkIndirectTarget& GetRanges() const { return this->Ranges; }

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  bool UpdateSenders(vtkOpenGLRenderWindow* window, const vtkIndirectProxyTree& tree);

  std::vector<vtkIndirectProxyPolygon> Polygons;
  bool HasAnyGroups = false;
  int NumberOfEntries = 0;
  int NumberOfBlocks = 0;
  int NumberOfSenders = 0;
  int FirstPlace = 0;
  vtkIndirectTarget Table;  // zonal logarithms
  vtkIndirectTarget Rows;   // entries
  vtkIndirectTarget Blocks; // boxes
  vtkIndirectTarget Senders;
  vtkIndirectTarget Ranges; // ranges of means
};
