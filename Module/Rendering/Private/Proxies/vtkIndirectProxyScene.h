// SPDX-License-Identifier: BSD-3-Clause
// The spheres and flat polygons that represent a frame's surfaces: atoms, glyphs and points drawn
// as spheres directly from their data, other meshes by vtkIndirectProxyShapes. For segments, which
// voxels occlude as well, only surfaces drawn as spheres.
#pragma once

#include "OpenGL/vtkIndirectKey.h"          // for keys
#include "Proxies/vtkIndirectProxyShapes.h" // for a member

#include <map>     // for the user's spheres
#include <string>  // for reasons
#include <utility> // for pairs
#include <vector>  // for lists

class vtkDataSet;
class vtkMapper;
class vtkObject;
class vtkPolyData;
class vtkProp;
struct vtkIndirectFrame;
struct vtkIndirectReport;

class vtkIndirectProxyScene
{
public:
  /**
   * These are the spheres that a user has given, by their prop: points with the point data
   * "Radius".
   */
  using Given = std::map<vtkSmartPointer<vtkProp>, vtkSmartPointer<vtkPolyData>>;

  enum UserType
  {
    SUMS,    // sums of occlusion and light: also meshes, sticks, and ellipsoids on average
    SEGMENTS // segments and rays: spheres as drawn, and spheres inside sticks
  };
  explicit vtkIndirectProxyScene(UserType user = SUMS)
    : User(user)
  {
  }

  /**
   * Collects the casters of a frame, in scene units. Returns true if anything may have changed
   * since the last call. caller: reports negative or infinite radii.
   */
  bool Update(const vtkIndirectFrame& frame, const Given& given, vtkObject* caller);

  const std::vector<vtkIndirectProxySphere>& GetSpheres() const { return this->Spheres; }
  /** Returns true if a sphere contains the position, in scene units. */
  bool Contains(const glm::dvec3& place) const;
  /** Returns the spheres, which are moved out of this object. */
  std::vector<vtkIndirectProxySphere> TakeSpheres() { return std::move(this->Spheres); }
  const std::vector<vtkIndirectProxyPolygon>& GetPolygons() const { return this->Polygons; }
  /** These are the renderer's props with spheres or polygons. */
  const std::vector<const vtkProp*>& GetProps() const { return this->Props; }
  /** Mappers of actors with spheres or polygons. */
  const std::vector<const vtkMapper*>& GetMappers() const { return this->Mappers; }
  /** Returns the numbers of spheres by their source, as text. */
  std::string GetWhat() const;
  /** Returns the surfaces that are not represented, and the reasons. */
  const std::vector<std::pair<std::string, std::string>>& GetLeftOut() const
  {
    return this->LeftOut;
  }
  void AddToReport(vtkIndirectReport& report) const;
  void Forget() { this->Key.Clear(); }

private:
  struct Part;
  void AddPart(const Part& part, const Given& given);
  void AddActor(const Part& part);
  void AddPoints(const Part& part, vtkDataSet* data, double radius);
  bool AddGlyphs(const Part& part);
  bool AddGlyphs(const Part& part, vtkDataSet* data);
  void AddMesh(const Part& part, vtkPolyData* mesh);
  void AddMeshes(const Part& part);
  // exact: the sphere is drawn as such.
  void Add(
    const Part& part, const double center[3], double radius, const glm::dvec3& albedo, bool exact);
  void LeaveOut(const std::string& what, const std::string& why);
  bool IsOfEllipsoids(const Part& part);
  static bool IsCutOff(const Part& part, const glm::dvec3& place);

  UserType User;
  vtkIndirectKey Key; // of what has been collected
  std::vector<vtkIndirectProxySphere> Spheres;
  std::vector<vtkIndirectProxyPolygon> Polygons;
  std::vector<const vtkProp*> Props;
  std::vector<const vtkMapper*> Mappers;
  vtkIndirectProxyShapes Shapes;
  glm::dvec3 SceneCenter{ 0.0 };
  double SceneScale = 1.0;
  size_t Exact = 0;    // spheres directly from the data
  size_t OfSticks = 0; // spheres of sticks, see vtkIndirectProxySticks
  size_t Fitted = 0;   // spheres fitted to meshes
  size_t Wrong = 0;    // invalid radii or positions
  size_t Sheets = 0;   // meshes without a representation
  bool SaidSheets = false;
  std::string WrongProp;
  std::string Said; // last message about these
  std::vector<std::pair<std::string, std::string>> LeftOut;
};
