// SPDX-License-Identifier: BSD-3-Clause
// A tree of spheres as shaders read it: tables of entries, of boxes around blocks of them, and of
// what sends light.
#ifndef vtkIndirectProxyTreeTables_h
#define vtkIndirectProxyTreeTables_h

#include "OpenGL/vtkIndirectTarget.h"      // for members
#include "Proxies/vtkIndirectProxyLight.h" // for polygons
#include "Proxies/vtkIndirectProxyTree.h"  // for entries

#include <vector> // for polygons

class vtkIndirectProxyTreeTables
{
public:
  vtkIndirectProxyTreeTables();

  /** Uploads entries. Returns false, after an error, when OpenGL refuses. */
  bool Update(vtkOpenGLRenderWindow* window, const vtkIndirectProxyTree& tree,
    const std::vector<vtkIndirectProxyPolygon>& polygons);

  void Activate(vtkShaderProgram* program) const;
  void Deactivate() const;
  /** A texel of a table with rows of VTKI_ROW_LENGTH, over its width and height. */
  static void SetTexelSize(
    vtkShaderProgram* program, const char* name, const vtkIndirectTarget& table);

  /** Those that send light: the largest ones of what Update was given. */
  const std::vector<vtkIndirectProxyPolygon>& GetPolygons() const { return this->Polygons; }
  bool HasGroups() const { return this->HasAnyGroups; }
  int GetNumberOfEntries() const { return this->NumberOfEntries; }
  int GetNumberOfSenders() const { return this->NumberOfSenders; }
  /** The first of the senders that are places of polygons. */
  int GetFirstPlace() const { return this->FirstPlace; }
  const vtkIndirectTarget& GetEntries() const { return this->Rows; }
  const vtkIndirectTarget& GetSenders() const { return this->Senders; }
  /** Of senders, of which an entry sends the mean. */
  const vtkIndirectTarget& GetRanges() const { return this->Ranges; }

  size_t GetBytes() const;
  void Release(vtkWindow* window);

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
  vtkIndirectTarget Ranges; // of means
};
#endif
