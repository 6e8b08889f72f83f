// SPDX-License-Identifier: BSD-3-Clause
// Coarse levels of meshes for depth maps: those that users have given for props, each with its
// distance from the prop's own mesh, and else levels of parts of dense meshes. Depth maps draw a
// level whose distance is below a share of a texel. The choice depends only on the map and the
// prop, never on time, so that complete maps are equal, however many frames they took.
#pragma once

#include "Capture/vtkIndirectMeshParts.h" // for members
#include "OpenGL/vtkIndirectResource.h"   // for the base class
#include "vtkSmartPointer.h"              // for members
#include "vtkType.h"                      // for times
#include "vtkWeakPointer.h"               // for members

#include <cstddef> // for size_t
#include <glm/glm.hpp>
#include <map>    // for members
#include <memory> // for levels
#include <string> // for reasons
#include <vector> // for lists

class vtkActor;
class vtkIndirectKey;
class vtkOpenGLBufferObject;
class vtkPolyData;
class vtkProp;
struct vtkIndirectFrame;
struct vtkIndirectReport;

class vtkIndirectCoarseLevels : public vtkIndirectResource
{
public:
  explicit vtkIndirectCoarseLevels(vtkIndirectResource* owner);
  ~vtkIndirectCoarseLevels() override;

  /** Adds a level for the prop's current mesh. Returns the reason if it is refused, else empty. */
  std::string Add(vtkProp* prop, vtkPolyData* mesh, double error);
  void Remove(vtkProp* prop);

  /** Removes levels of props that are gone or have changed, and dates casters that have levels.
   * Releases the OpenGL objects of an actor that is not in the renderer. */
  void Update(vtkIndirectFrame& frame);

  /**
   * Returns the levels that a user has given for a prop, in one part, or the parts of its dense
   * mesh, which are made on the first call. Null: the mesh itself is drawn. For props that
   * vtkIndirectDepthDrawer can draw.
   */
  vtkIndirectMeshParts* Find(vtkProp* prop);

  /** Counts the triangles that maps drew, and those of the full meshes. */
  void Count(size_t drawn, size_t full);
  /** Adds the levels to a key of pictures. */
  void AppendTo(vtkIndirectKey& key) const;
  void AddToReport(vtkIndirectReport& report) const;

protected:
  /** Releases OpenGL objects; the levels stay. */
  void ReleaseOwn(vtkWindow* window) override;

private:
  struct Given
  {
    vtkWeakPointer<vtkPolyData> Source;
    double Error = 0.0; // distance from the prop's mesh, in the mesh's units
    std::vector<glm::dvec3> Points;
    std::vector<unsigned int> Indices;
  };
  struct Entry
  {
    vtkWeakPointer<vtkActor> Actor;
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkTypeUInt64 MeshRevision = 0; // revision of the mesh's shape
    vtkMTimeType Time = 0;          // time of the last added level
    std::vector<Given> Levels;      // of the fewest triangles first
    std::unique_ptr<vtkIndirectMeshParts> Parts;
  };
  struct Made
  {
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkTypeUInt64 MeshRevision = 0;
    std::unique_ptr<vtkIndirectMeshParts> Parts; // null: the mesh has none
  };
  std::vector<Entry> Entries;
  std::map<vtkPolyData*, Made> MadeOf;
  std::vector<vtkSmartPointer<vtkOpenGLBufferObject>> Unused; // released in the next frame
  double Drawn = 0.0;
  double Full = 0.0;

  static bool IsCurrent(const Entry& entry);
  static void Join(Entry& entry);
  static std::string Read(vtkPolyData* mesh, Given& level);
  template <typename Test>
  void RemoveEntries(const Test& goes);
  void RemoveUnneeded(const vtkIndirectFrame& frame);
  void DiscardBuffers(vtkIndirectMeshParts* parts);
  void ReleaseUnused();
  std::vector<vtkIndirectMeshParts*> GetAll() const;
};
