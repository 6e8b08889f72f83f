// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxyScene.h"

#include "Plan/vtkIndirectReport.h"
#include "Proxies/vtkIndirectProxyKinds.h"
#include "Proxies/vtkIndirectProxySticks.h"
#include "Scene/vtkIndirectActors.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectGlyphs.h"
#include "Scene/vtkIndirectImpostors.h"
#include "Scene/vtkIndirectMaterial.h"
#include "Scene/vtkIndirectPropKind.h"
#include "vtkActor.h"
#include "vtkDataSet.h"
#include "vtkDataSetMapper.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkObject.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>
#include <cmath>

using vtkIndirectActors::ForEachBlock;

namespace
{
const char* const NoBlockers = "they block no indirect light; the result is too bright";

// Returns the polygons of a mapper that draws them unchanged, or of data sets.
vtkDataObject* FindMeshes(vtkMapper* mapper)
{
  auto* dataSetMapper = vtkDataSetMapper::SafeDownCast(mapper);
  vtkDataObject* input = mapper->GetInputDataObject(0, 0);
  if (dataSetMapper && !vtkPolyData::SafeDownCast(input))
  {
    vtkPolyDataMapper* inner = dataSetMapper->GetPolyDataMapper();
    return inner ? inner->GetInput() : nullptr;
  }
  return input;
}
}

//------------------------------------------------------------------------------
struct vtkIndirectProxyScene::Part
{
  vtkActor* Actor;
  vtkMapper* Mapper;
  vtkProp* Prop; // the renderer's prop
  bool Sends;
  bool PhysicallyBased;
  glm::dmat4 ToWorld;
  glm::dmat4 ToScene;
  double Scale; // scale of lengths
};

//------------------------------------------------------------------------------
bool vtkIndirectProxyScene::Update(
  const vtkIndirectFrame& frame, const Given& given, vtkObject* caller)
{
  vtkIndirectKey key;
  frame.AppendUnitsTo(key);
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    caster.AppendTo(key);
    const auto known = given.find(caster.Prop);
    key.Add("given spheres", known == given.end() ? nullptr : known->second);
  }
  if (!this->Key.Take(std::move(key)))
  {
    return false;
  }
  this->Spheres.clear();
  this->Polygons.clear();
  this->Props.clear();
  this->Mappers.clear();
  this->LeftOut.clear();
  this->Exact = this->OfSticks = this->Fitted = this->Wrong = this->Sheets = 0;
  this->SceneCenter = frame.SceneCenter;
  this->SceneScale = frame.SceneScale;
  for (const vtkIndirectCaster& caster : frame.Casters)
  {
    const size_t before = this->Spheres.size();
    vtkIndirectActors::ForEach(caster.Prop,
      [&](vtkActor* actor, vtkMatrix4x4* matrix)
      {
        const glm::dmat4 toWorld = vtkIndirectFrame::ToGLM(matrix);
        Part part = { actor, actor->GetMapper(), caster.Prop, caster.SendsLight,
          actor->GetProperty()->GetInterpolation() == VTK_PBR, toWorld, frame.ToScene(toWorld),
          frame.SceneScale * std::cbrt(std::abs(glm::determinant(glm::dmat3(toWorld)))) };
        for (int i = 0; i < 3; ++i)
        {
          part.ToScene[i] *= frame.SceneScale;
        }
        const size_t fromHere = this->Spheres.size();
        this->AddPart(part, given);
        if (this->Spheres.size() > fromHere)
        {
          this->Mappers.push_back(actor->GetMapper());
        }
      });
    if (this->Spheres.size() > before)
    {
      this->Props.push_back(caster.Prop);
    }
  }
  this->Shapes.Forget();
  const std::string wrong = this->Wrong == 0
    ? ""
    : std::to_string(this->Wrong) + " spheres of " + this->WrongProp +
      " have radii that are negative or not finite, or no place; they are left out.";
  // Reports the same message only once, also for later colours.
  if (!wrong.empty() && wrong != this->Said)
  {
    vtkErrorWithObjectMacro(caller, << wrong);
  }
  this->Said = wrong;
  if (this->Sheets > 0 && !this->SaidSheets)
  {
    vtkWarningWithObjectMacro(caller,
      << this->Sheets
      << " meshes are open sheets, for which no spheres stand: they hide no light and send none. "
         "Other methods take them as they are.");
  }
  this->SaidSheets = this->Sheets > 0;
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectProxyScene::LeaveOut(const std::string& what, const std::string& why)
{
  const std::pair<std::string, std::string> entry(what, why);
  if (std::find(this->LeftOut.begin(), this->LeftOut.end(), entry) == this->LeftOut.end())
  {
    this->LeftOut.push_back(entry);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectProxyScene::Add(
  const Part& part, const double center[3], double radius, const glm::dvec3& albedo, bool exact)
{
  const glm::dvec3 place(part.ToScene * glm::dvec4(center[0], center[1], center[2], 1.0));
  const double scaled = radius * part.Scale;
  // A radius whose square overflows is invalid.
  if (!(scaled >= 0.0) || !(scaled < 1e18) || !std::isfinite(place.x + place.y + place.z))
  {
    this->WrongProp = this->Wrong++ ? this->WrongProp : vtkIndirectPropKind::GetFullName(part.Prop);
    return;
  }
  // Relative to the scene's diagonal; a smaller sphere hides nothing.
  if (scaled > 1e-12 &&
    !(this->User == SEGMENTS &&
      IsCutOff(part, glm::dvec3(part.ToWorld * glm::dvec4(center[0], center[1], center[2], 1.0)))))
  {
    this->Spheres.push_back({ place, std::min(scaled, 1e6),
      part.Sends ? glm::vec3(albedo) : glm::vec3(0.0f), part.PhysicallyBased, exact });
  }
}

//------------------------------------------------------------------------------
// VTK clips a sphere as a whole by its centre; clipped glyphs are treated the same.
bool vtkIndirectProxyScene::IsCutOff(const Part& part, const glm::dvec3& place)
{
  vtkPlaneCollection* planes = part.Actor->GetMapper()->GetClippingPlanes();
  bool shown = true;
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    shown = shown && planes->GetItem(i)->EvaluateFunction(place.x, place.y, place.z) >= 0.0;
  }
  return !shown;
}

//------------------------------------------------------------------------------
// Returns true if the actor's matrix makes ellipsoids of spheres, beyond rounding.
bool vtkIndirectProxyScene::IsOfEllipsoids(const Part& part)
{
  const glm::dmat3 turned(part.ToWorld);
  const glm::dmat3 squares = glm::transpose(turned) * turned;
  const double mean = (squares[0][0] + squares[1][1] + squares[2][2]) / 3.0;
  double off = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      off = std::max(off, std::abs(squares[i][k] - (i == k ? mean : 0.0)));
    }
  }
  return !(off <= 1e-3 * mean);
}

//------------------------------------------------------------------------------
void vtkIndirectProxyScene::AddPart(const Part& part, const Given& given)
{
  auto known = given.find(part.Actor);
  known = known == given.end() ? given.find(part.Prop) : known;
  if (known == given.end())
  {
    this->AddActor(part);
    return;
  }
  vtkPolyData* spheres = known->second;
  vtkDataArray* radii = spheres->GetPointData()->GetArray("Radius");
  const glm::dvec3 albedo = vtkIndirectMaterial(part.Actor, part.Mapper, spheres).Get(-1);
  const size_t before = this->Spheres.size();
  for (vtkIdType i = 0; i < spheres->GetNumberOfPoints(); ++i)
  {
    this->Add(part, spheres->GetPoint(i), radii->GetTuple1(i), albedo, false);
  }
  this->Fitted += this->Spheres.size() - before;
}

//------------------------------------------------------------------------------
void vtkIndirectProxyScene::AddActor(const Part& part)
{
  namespace Kinds = vtkIndirectProxyKinds;
  const size_t before = this->Spheres.size();
  const bool segments = this->User == SEGMENTS;
  const Kinds::MapperType type = Kinds::FindType(part.Mapper);
  if (segments && type != Kinds::MESH && this->IsOfEllipsoids(part))
  {
    this->LeaveOut("spheres that a matrix stretches", NoBlockers);
  }
  else if (type == Kinds::MOLECULE)
  {
    const Kinds::Molecule molecule = Kinds::FindMolecule(part.Mapper);
    for (vtkMapper* drawn : { molecule.Bonds, molecule.Atoms })
    {
      Part inner = part;
      inner.Mapper = drawn;
      if (drawn)
      {
        this->AddActor(inner);
      }
    }
  }
  else if (type == Kinds::BALLS)
  {
    auto* spheres = vtkOpenGLSphereMapper::SafeDownCast(part.Mapper);
    ForEachBlock<vtkDataSet>(spheres->GetInputDataObject(0, 0),
      [&](vtkDataSet* data) { this->AddPoints(part, data, spheres->GetRadius()); });
    this->Exact += this->Spheres.size() - before;
  }
  else if (type == Kinds::STICKS)
  {
    ForEachBlock<vtkDataSet>(part.Mapper->GetInputDataObject(0, 0),
      [&](vtkDataSet* data)
      {
        const vtkIndirectMaterial material(part.Actor, part.Mapper, data);
        vtkIndirectProxySticks::ForEach(part.Mapper, data,
          segments ? vtkIndirectProxySticks::INSIDE : vtkIndirectProxySticks::AVERAGED,
          [&](vtkIdType i, const double place[3], double radius)
          { this->Add(part, place, radius, material.Get(i), false); });
      });
    this->OfSticks += this->Spheres.size() - before;
  }
  else if (type == Kinds::SPLATS)
  {
    this->LeaveOut("splats without an edge",
      "they hide no light: a sphere's shader code cuts them off by `discard`, with Emissive off");
  }
  else if (type == Kinds::GLYPHS)
  {
    const std::string why = segments ? Kinds::FindWhyNoGlyphs(part.Mapper, this->Shapes) : "";
    if (!why.empty())
    {
      this->LeaveOut(why, NoBlockers);
    }
    else if (!this->AddGlyphs(part))
    {
      this->LeaveOut("glyphs that are no spheres", "they hide no light; the result is too bright");
    }
    this->Exact += this->Spheres.size() - before;
  }
  else if (!segments)
  {
    this->AddMeshes(part);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectProxyScene::AddPoints(const Part& part, vtkDataSet* data, double radius)
{
  vtkDataArray* sizes = vtkIndirectImpostors::FindRadii(part.Mapper, data);
  const vtkIndirectMaterial material(part.Actor, part.Mapper, data);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double place[3];
    data->GetPoint(i, place);
    this->Add(part, place, sizes ? sizes->GetComponent(i, 0) : radius, material.Get(i), true);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectProxyScene::AddGlyphs(const Part& part)
{
  bool all = true;
  ForEachBlock<vtkDataSet>(part.Mapper->GetInputDataObject(0, 0),
    [&](vtkDataSet* data) { all = this->AddGlyphs(part, data) && all; });
  return all;
}

//------------------------------------------------------------------------------
bool vtkIndirectProxyScene::AddGlyphs(const Part& part, vtkDataSet* data)
{
  auto* mapper = vtkGlyph3DMapper::SafeDownCast(part.Mapper);
  std::vector<const vtkIndirectProxyShapes::Shape*> sources;
  bool all = true;
  for (const std::vector<vtkPolyData*>& source : vtkIndirectGlyphs::FindSources(mapper))
  {
    const bool one = source.size() == 1 && source.front()->GetNumberOfPoints() > 0;
    all = all && source.size() <= 1;
    sources.push_back(one ? &this->Shapes.Find(source.front(), true) : nullptr);
  }
  if (sources.empty())
  {
    return false;
  }
  const vtkIndirectMaterial material(part.Actor, mapper, data);
  vtkIndirectGlyphs::ForEach(mapper, data, sources.size(),
    [&](const vtkIndirectGlyphs::Instance& instance)
    {
      const vtkIndirectProxyShapes::Shape* source = sources[instance.Source];
      if (!source || source->Spheres.size() != 1)
      {
        all = all && !source;
        return;
      }
      const vtkIndirectProxySphere& sphere = source->Spheres.front();
      const glm::dvec3 place(instance.ToData * glm::dvec4(sphere.Center, 1.0));
      // An ellipsoid is represented by the ball of equal volume. Spheres of negative radius do not
      // occur.
      const glm::dvec3& factors = instance.Factors;
      const double volume = factors.x * factors.y * factors.z;
      this->Add(part, &place[0], std::cbrt(std::abs(volume)) * sphere.Radius,
        material.Get(instance.Point), factors.x == factors.y && factors.y == factors.z);
    });
  return all;
}

//------------------------------------------------------------------------------
void vtkIndirectProxyScene::AddMeshes(const Part& part)
{
  if (part.Actor->GetProperty()->GetRepresentation() != VTK_SURFACE)
  {
    return;
  }
  ForEachBlock<vtkPolyData>(FindMeshes(part.Mapper),
    [&](vtkPolyData* mesh)
    {
      if (mesh->GetNumberOfPoints() > 0)
      {
        this->AddMesh(part, mesh);
      }
    });
}

//------------------------------------------------------------------------------
void vtkIndirectProxyScene::AddMesh(const Part& part, vtkPolyData* mesh)
{
  const vtkIndirectProxyShapes::Shape& shape = this->Shapes.Find(mesh, false);
  this->Sheets += shape.Kind == vtkIndirectProxyShapes::SHEET ? 1 : 0;
  if (!shape.LeftOut.empty())
  {
    this->LeaveOut("a mesh of " + vtkIndirectPropKind::GetFullName(part.Prop), shape.LeftOut);
  }
  const vtkIndirectMaterial material(part.Actor, part.Mapper, mesh);
  const glm::dvec3 mean = material.GetMean();
  const size_t before = this->Spheres.size();
  const bool own = shape.Kind == vtkIndirectProxyShapes::SPHERES;
  for (size_t i = 0; i < shape.Spheres.size(); ++i)
  {
    this->Add(part, &shape.Spheres[i].Center[0], shape.Spheres[i].Radius,
      own ? material.Get(material.IsByCell() ? shape.Cells[i] : shape.Points[i]) : mean, own);
  }
  (own ? this->Exact : this->Fitted) += this->Spheres.size() - before;
  for (const vtkIndirectProxyPolygon& polygon : shape.Polygons)
  {
    vtkIndirectProxyPolygon moved = polygon;
    for (glm::dvec3& corner : moved.Corners)
    {
      corner = glm::dvec3(part.ToScene * glm::dvec4(corner, 1.0));
    }
    moved.Albedo = part.Sends ? glm::vec3(mean) : glm::vec3(0.0f);
    this->Polygons.push_back(moved);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectProxyScene::Contains(const glm::dvec3& place) const
{
  return std::any_of(this->Spheres.begin(), this->Spheres.end(),
    [&](const vtkIndirectProxySphere& sphere)
    { return glm::distance(sphere.Center, place) < sphere.Radius; });
}

//------------------------------------------------------------------------------
std::string vtkIndirectProxyScene::GetWhat() const
{
  return std::to_string(this->Exact) + " spheres of the data" +
    (this->OfSticks > 0 ? ", " + std::to_string(this->OfSticks) + " spheres of sticks" : "");
}

//------------------------------------------------------------------------------
void vtkIndirectProxyScene::AddToReport(vtkIndirectReport& report) const
{
  report.Modelled.emplace_back("what hides the sky",
    this->GetWhat() + ", " + std::to_string(this->Fitted) + " spheres of meshes, " +
      std::to_string(this->Polygons.size()) + " flat polygons");
  report.LeftOut.insert(report.LeftOut.end(), this->LeftOut.begin(), this->LeftOut.end());
}
