// SPDX-License-Identifier: BSD-3-Clause
// Coarse meshes that users have given for props, each with its distance from the prop's own mesh.
// Depth maps draw a level whose distance is below a share of a texel. The choice depends only on
// the map and the prop, never on time, so that complete maps are equal, however many frames they
// took.
#pragma once

#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "vtkSmartPointer.h"            // for members
#include "vtkType.h"                    // for times
#include "vtkWeakPointer.h"             // for members

#include <cstddef> // for size_t
#include <glm/glm.hpp>
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

  /** A level's triangles; positions relative to Middle, in the mesh's coordinates. */
  struct Level
  {
    std::vector<float> Positions;
    std::vector<unsigned int> Indices;
    glm::dvec3 Middle{ 0.0 };
    double Error = 0.0; // distance from the prop's mesh, in the mesh's units
    vtkWeakPointer<vtkPolyData> Source;
    vtkSmartPointer<vtkOpenGLBufferObject> PositionBuffer;
    vtkSmartPointer<vtkOpenGLBufferObject> IndexBuffer;
  };

  /** Adds a level for the prop's current mesh. Returns the reason if it is refused, else empty. */
  std::string Add(vtkProp* prop, vtkPolyData* mesh, double error);
  void Remove(vtkProp* prop);

  /** Removes levels of props that are gone or have changed, and dates casters that have levels.
   * Releases the OpenGL objects of an actor that is not in the renderer. */
  void Update(vtkIndirectFrame& frame);

  /** True if a prop has levels. */
  bool Has(vtkProp* prop) const;
  /** The coarsest level at most this far off, in world units; null: the prop's own mesh. Also
   * returns the level's distance in world units. */
  Level* Find(vtkProp* prop, double mostError, double& error) const;

  /** Counts the triangles that maps drew, and those of the full meshes. */
  void Count(size_t drawn, size_t full) const;
  /** Adds the levels to a key of pictures. */
  void AppendTo(vtkIndirectKey& key) const;
  void AddToReport(vtkIndirectReport& report) const;

protected:
  /** Releases OpenGL objects; the levels stay. */
  void ReleaseOwn(vtkWindow* window) override;

private:
  struct Entry
  {
    vtkWeakPointer<vtkActor> Actor;
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkTypeUInt64 MeshRevision = 0; // revision of the mesh's shape
    vtkMTimeType Time = 0;          // time of the last added level
    std::vector<std::unique_ptr<Level>> Levels;
  };
  std::vector<Entry> Entries;
  std::vector<vtkSmartPointer<vtkOpenGLBufferObject>> Unused; // released in the next frame
  mutable double Drawn = 0.0;
  mutable double Full = 0.0;

  static bool IsCurrent(const Entry& entry);
  void Discard(Entry& entry);
  void DiscardBuffers(Level& level);
  void DiscardBuffers(Entry& entry);
};
