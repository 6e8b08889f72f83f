// SPDX-License-Identifier: BSD-3-Clause
// The spheres and flat polygons that stand for what a frame draws: atoms, glyphs and points that
// are drawn as spheres straight from their data, other meshes by what vtkIndirectProxyShapes finds.
// For segments, which voxels are there for as well, those that are drawn as spheres alone.
#ifndef vtkIndirectProxyScene_h
#define vtkIndirectProxyScene_h

#include "Frame/vtkIndirectKey.h"           // for keys
#include "Proxies/vtkIndirectProxyKinds.h"  // for a member
#include "Proxies/vtkIndirectProxyShapes.h" // for a member

#include <map>     // for the user's spheres
#include <string>  // for reasons
#include <utility> // for pairs
#include <vector>  // for lists

class vtkActor;
class vtkDataSet;
class vtkMapper;
class vtkMatrix4x4;
class vtkObject;
struct vtkIndirectFrame;
struct vtkIndirectReport;

class vtkIndirectProxyScene
{
public:
  /** Spheres that a user has given, by their prop: points with the point data "Radius". */
  using Given = std::map<vtkSmartPointer<vtkProp>, vtkSmartPointer<vtkPolyData>>;

  enum UserType
  {
    SUMS,    // over what spheres hide and send: meshes too, sticks and ellipsoids in the mean
    SEGMENTS // and rays: spheres as they are drawn, and what lies inside of sticks
  };
  explicit vtkIndirectProxyScene(UserType user = SUMS)
    : User(user)
  {
  }

  /**
   * Collects what casts shadows in a frame, in scene units. Returns whether anything may have
   * changed since the last call. caller: whose error it is when radii are negative or not finite.
   */
  bool Update(const vtkIndirectFrame& frame, const Given& given, vtkObject* caller);

  const std::vector<vtkIndirectProxySphere>& GetSpheres() const { return this->Spheres; }
  /** How many of them hold a place, in scene units. */
  size_t CountAround(const glm::dvec3& place) const;
  /** The spheres, which are not kept here any longer. */
  std::vector<vtkIndirectProxySphere> TakeSpheres() { return std::move(this->Spheres); }
  const std::vector<vtkIndirectProxyPolygon>& GetPolygons() const { return this->Polygons; }
  /** The renderer's props that have such. */
  const std::vector<const vtkProp*>& GetProps() const { return this->Props; }
  /** Mappers of actors that have such. */
  const std::vector<const vtkMapper*>& GetMappers() const { return this->Mappers; }
  /** How many spheres of what. */
  std::string GetWhat() const;
  /** What else there is, and what is lost. */
  const std::vector<std::pair<std::string, std::string>>& GetLeftOut() const
  {
    return this->LeftOut;
  }
  /** How often meshes have been looked into. */
  int GetNumberOfFits() const { return this->Shapes.GetNumberOfFits(); }
  void AddToReport(vtkIndirectReport& report) const;
  void Forget() { this->Key.Clear(); }

private:
  struct Part;
  void AddPart(const Part& part, const Given& given);
  void AddActor(const Part& part);
  void AddPoints(const Part& part, vtkDataSet* data, const char* array, double radius);
  void AddGaussians(const Part& part);
  bool AddGlyphs(const Part& part);
  bool AddGlyphs(const Part& part, vtkDataSet* data);
  void AddMesh(const Part& part, vtkPolyData* mesh);
  void AddMeshes(const Part& part);
  // exact: it is drawn as it is.
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
  vtkIndirectProxyKinds Kinds;
  glm::dvec3 SceneCenter{ 0.0 };
  double SceneScale = 1.0;
  size_t Exact = 0;    // spheres straight from the data
  size_t OfSticks = 0; // rows of them, see vtkIndirectProxySticks
  size_t Fitted = 0;   // of meshes
  size_t Wrong = 0;    // radii or places that are not
  size_t Sheets = 0;   // meshes for which nothing stands
  bool SaidSheets = false;
  std::string WrongProp;
  std::string Said; // of these, last
  std::vector<std::pair<std::string, std::string>> LeftOut;
};
#endif
