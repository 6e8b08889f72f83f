// SPDX-License-Identifier: BSD-3-Clause
// The spheres and flat polygons that stand for what a frame draws: atoms, glyphs and points that
// are drawn as spheres straight from their data, other meshes by what vtkIndirectProxyShapes finds.
#ifndef vtkIndirectProxyScene_h
#define vtkIndirectProxyScene_h

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

  /**
   * Collects what casts shadows in a frame, in scene units. Returns whether anything may have
   * changed since the last call. caller: whose error it is when radii are negative or not finite.
   */
  bool Update(const vtkIndirectFrame& frame, const Given& given, vtkObject* caller);

  const std::vector<vtkIndirectProxySphere>& GetSpheres() const { return this->Spheres; }
  const std::vector<vtkIndirectProxyPolygon>& GetPolygons() const { return this->Polygons; }
  /** How often meshes have been looked into. */
  int GetNumberOfFits() const { return this->Shapes.GetNumberOfFits(); }
  void AddToReport(vtkIndirectReport& report) const;
  void Forget() { this->Key.clear(); }

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
    const Part& part, const double center[3], double radius, const glm::vec3& albedo, bool exact);
  void LeaveOut(const std::string& what, const std::string& why);

  std::vector<double> Key; // of what has been collected
  std::vector<vtkIndirectProxySphere> Spheres;
  std::vector<vtkIndirectProxyPolygon> Polygons;
  vtkIndirectProxyShapes Shapes;
  glm::dvec3 SceneCenter{ 0.0 };
  double SceneScale = 1.0;
  size_t Exact = 0;    // spheres straight from the data
  size_t OfSticks = 0; // rows of them, see vtkIndirectProxySticks
  size_t Fitted = 0;   // of meshes
  size_t Wrong = 0;    // radii or places that are not
  std::string WrongProp;
  std::vector<std::pair<std::string, std::string>> LeftOut;
};
#endif
