// SPDX-License-Identifier: BSD-3-Clause
// Meshes of fewer triangles that users have given for props, each with how far it is from what the
// prop draws. Depth maps are drawn of one where that distance is below a share of a texel. It
// depends on the map and on the prop alone which one is taken, never on time, so that complete maps
// are the same however many frames they arrived in.
#ifndef vtkIndirectCoarseLevels_h
#define vtkIndirectCoarseLevels_h

#include "vtkSmartPointer.h" // for members
#include "vtkType.h"         // for times
#include "vtkWeakPointer.h"  // for members

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
class vtkWindow;
struct vtkIndirectFrame;
struct vtkIndirectReport;

class vtkIndirectCoarseLevels
{
public:
  vtkIndirectCoarseLevels();
  ~vtkIndirectCoarseLevels();

  /** A level's triangles; positions relative to Middle, in the mesh's coordinates. */
  struct Level
  {
    std::vector<float> Positions;
    std::vector<unsigned int> Indices;
    glm::dvec3 Middle{ 0.0 };
    double Error = 0.0; // in the mesh's lengths
    vtkWeakPointer<vtkPolyData> Source;
    vtkSmartPointer<vtkOpenGLBufferObject> PositionBuffer;
    vtkSmartPointer<vtkOpenGLBufferObject> IndexBuffer;
  };

  /** Adds a level of what a prop draws now. Returns why it cannot be, or empty. */
  std::string Add(vtkProp* prop, vtkPolyData* mesh, double error);
  void Remove(vtkProp* prop);

  /** Forgets levels of what is gone or has changed, and dates casters that have some. Of an actor
   * that is not in the renderer OpenGL's part is released. */
  void Update(vtkIndirectFrame& frame);

  /** Whether a prop has levels. */
  bool Has(vtkProp* prop) const;
  /** The least triangles no farther off than this, in world units; null: what the prop draws. On
   * success also the level's distance in world units. */
  Level* Find(vtkProp* prop, double mostError, double& error) const;

  /** Counts what maps were drawn of. */
  void Count(size_t drawn, size_t full) const;
  /** Adds what pictures depend on: which levels there are. */
  void AppendTo(vtkIndirectKey& key) const;
  void AddToReport(vtkIndirectReport& report) const;
  /** Releases OpenGL's part; levels stay. */
  void Release(vtkWindow* window);

private:
  struct Entry
  {
    vtkWeakPointer<vtkActor> Actor;
    vtkWeakPointer<vtkPolyData> Mesh;
    vtkTypeUInt64 MeshRevision = 0; // of its shape
    vtkMTimeType Time = 0;          // of the last level that was added
    std::vector<std::unique_ptr<Level>> Levels;
  };
  std::vector<Entry> Entries;
  std::vector<vtkSmartPointer<vtkOpenGLBufferObject>> Unused; // until the next frame
  mutable double Drawn = 0.0;
  mutable double Full = 0.0;

  static bool IsCurrent(const Entry& entry);
  void Discard(Entry& entry);
  void DiscardBuffers(Level& level);
  void DiscardBuffers(Entry& entry);
};

#endif
