// SPDX-License-Identifier: BSD-3-Clause
// Kinds of surfaces and of mappers, in the court.
#include "ImagePicture.h"

#include "vtkActorCollection.h"

#include "vtkCellArray.h"
#include "vtkElevationFilter.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTubeFilter.h"

using namespace contract;

namespace
{
// Ground, walls and sun, without box and sphere.
void AddYard(vtkRenderer* renderer)
{
  images::AddCourt(renderer);
  for (int i : { 4, 3 })
  {
    renderer->RemoveActor(vtkActor::SafeDownCast(renderer->GetActors()->GetItemAsObject(i)));
  }
  images::AddSun(renderer);
}

// A helix.
vtkSmartPointer<vtkPolyData> MakeHelix(int count)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> line;
  line->InsertNextCell(count);
  for (int i = 0; i < count; ++i)
  {
    const double t = 4.0 * 3.14159265358979 * i / (count - 1);
    points->InsertNextPoint(0.8 * std::cos(t), 0.3 + 0.08 * t, 0.6 * std::sin(t));
    line->InsertCellPoint(i);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(line);
  return data;
}

vtkSmartPointer<vtkImageData> MakeCheckers()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(8, 8, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 8; ++y)
  {
    for (int x = 0; x < 8; ++x)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      pixel[0] = (x + y) % 2 ? 230 : 40;
      pixel[1] = 120;
      pixel[2] = (x + y) % 2 ? 60 : 200;
    }
  }
  return image;
}

vtkSmartPointer<vtkActor> AddBall(vtkRenderer* renderer, double x, double z = 0.0)
{
  auto actor = MakeSphere({ x, 0.45, z }, 0.45, { 0.9, 0.8, 0.3 }, 32);
  renderer->AddActor(actor);
  return actor;
}
}

VTK_INDIRECT_IMAGE(SurfaceGlyphs)
{
  AddYard(picture.Renderer);
  vtkNew<vtkPlaneSource> points;
  points->SetOrigin(-1.4, 0.3, -0.6);
  points->SetPoint1(1.4, 0.3, -0.6);
  points->SetPoint2(-1.4, 0.3, 0.9);
  points->SetResolution(4, 2);
  vtkNew<vtkSphereSource> glyph;
  glyph->SetRadius(0.25);
  glyph->SetThetaResolution(16);
  glyph->SetPhiResolution(16);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(points->GetOutputPort());
  mapper->SetSourceConnection(glyph->GetOutputPort());
  mapper->ScalingOff();
  mapper->OrientOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.4, 0.2);
  picture.Renderer->AddActor(actor);
}

VTK_INDIRECT_IMAGE(SurfaceTubes)
{
  AddYard(picture.Renderer);
  vtkNew<vtkTubeFilter> tubes;
  tubes->SetInputData(MakeHelix(97));
  tubes->SetRadius(0.09);
  tubes->SetNumberOfSides(16);
  tubes->CappingOn();
  picture.Renderer->AddActor(MakeActor(tubes, { 0.9, 0.4, 0.2 }));
}

// Lines that VTK draws as tubes: lit, and of a width in pixels, so they cast no shadow.
VTK_INDIRECT_IMAGE(SurfaceLinesAsTubes)
{
  AddYard(picture.Renderer);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeHelix(97));
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.4, 0.2);
  actor->GetProperty()->SetLineWidth(8);
  actor->GetProperty()->RenderLinesAsTubesOn();
  picture.Renderer->AddActor(actor);
}

VTK_INDIRECT_IMAGE(SurfaceImpostors)
{
  AddYard(picture.Renderer);
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  for (vtkIdType i = 0; i < 9; ++i)
  {
    points->InsertNextPoint(
      -1.2 + 0.3 * double(i), 0.35 + 0.1 * double(i % 3), 0.4 * double(i % 2));
    vertices->InsertNextCell({ i });
  }
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetVerts(vertices);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetRadius(0.3f);
  mapper->SetInputData(data);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.3, 0.8, 0.4);
  picture.Renderer->AddActor(actor);
}

// Rough, half metallic, metallic.
VTK_INDIRECT_IMAGE(SurfacePBR)
{
  AddYard(picture.Renderer);
  for (int i = 0; i < 3; ++i)
  {
    vtkProperty* property = AddBall(picture.Renderer, -1.2 + 1.1 * i)->GetProperty();
    property->SetInterpolationToPBR();
    property->SetMetallic(0.5 * i);
    property->SetRoughness(0.6 - 0.15 * i);
  }
}

// Phong lobes of power 5, 20 and 80.
VTK_INDIRECT_IMAGE(SurfaceSpecular)
{
  AddYard(picture.Renderer);
  for (int i = 0; i < 3; ++i)
  {
    vtkProperty* property = AddBall(picture.Renderer, -1.2 + 1.1 * i)->GetProperty();
    property->SetDiffuse(0.5);
    property->SetSpecular(0.5);
    property->SetSpecularPower(i == 0 ? 5 : (i == 1 ? 20 : 80));
  }
}

VTK_INDIRECT_IMAGE(SurfaceScalars)
{
  AddYard(picture.Renderer);
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(6);
  table->SetHueRange(0.66, 0.0);
  table->Build();
  for (int i = 0; i < 2; ++i)
  {
    vtkNew<vtkSphereSource> source;
    source->SetCenter(i == 0 ? -0.7 : 0.7, 0.6, 0);
    source->SetRadius(0.6);
    source->SetThetaResolution(32);
    source->SetPhiResolution(24);
    vtkNew<vtkElevationFilter> elevation;
    elevation->SetInputConnection(source->GetOutputPort());
    elevation->SetLowPoint(0, 0, 0);
    elevation->SetHighPoint(0, 1.2, 0);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(elevation->GetOutputPort());
    mapper->SetLookupTable(table);
    mapper->SetInterpolateScalarsBeforeMapping(i == 1);
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    picture.Renderer->AddActor(actor);
  }
}

VTK_INDIRECT_IMAGE(SurfaceTexture)
{
  AddYard(picture.Renderer);
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-1.2, 0.1, -0.3);
  source->SetPoint1(1.0, 0.1, -0.6);
  source->SetPoint2(-1.2, 1.3, -0.6);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(MakeCheckers());
  texture->InterpolateOff();
  auto actor = MakeActor(source, { 1, 1, 1 });
  actor->SetTexture(texture);
  picture.Renderer->AddActor(actor);
}

// Edges over faces. A wireframe is left out: rasterizers differ in every tenth pixel of its lines.
VTK_INDIRECT_IMAGE(SurfaceEdges)
{
  AddYard(picture.Renderer);
  auto edges = MakeSphere({ -0.7, 0.7, 0 }, 0.7, { 0.9, 0.8, 0.3 }, 8);
  edges->GetProperty()->EdgeVisibilityOn();
  edges->GetProperty()->SetEdgeColor(0, 0, 0.3);
  picture.Renderer->AddActor(edges);
  auto box = MakeBox({ 0.3, 0, -0.5 }, { 1.2, 1.0, 0.4 }, { 0.3, 0.8, 0.4 });
  box->GetProperty()->EdgeVisibilityOn();
  box->GetProperty()->SetEdgeColor(0.4, 0, 0);
  picture.Renderer->AddActor(box);
}

// Flat faces; an open sphere whose inside has another colour.
VTK_INDIRECT_IMAGE(SurfaceFlatAndBackface)
{
  AddYard(picture.Renderer);
  auto flat = MakeSphere({ -0.7, 0.5, 0 }, 0.5, { 0.9, 0.8, 0.3 }, 10);
  flat->GetProperty()->SetInterpolationToFlat();
  picture.Renderer->AddActor(flat);
  vtkNew<vtkSphereSource> open;
  open->SetCenter(0.7, 0.5, 0);
  open->SetRadius(0.5);
  open->SetThetaResolution(32);
  open->SetPhiResolution(32);
  open->SetStartTheta(110);
  open->SetEndTheta(380);
  auto actor = MakeActor(open, { 0.2, 0.7, 0.3 });
  vtkNew<vtkProperty> back;
  back->SetColor(0.9, 0.2, 0.7);
  actor->SetBackfaceProperty(back);
  picture.Renderer->AddActor(actor);
}

// The left sphere is unlit, in its own colour; the right one is ambient in part.
VTK_INDIRECT_IMAGE(SurfaceUnlitAndAmbient)
{
  AddYard(picture.Renderer);
  AddBall(picture.Renderer, -0.7)->GetProperty()->LightingOff();
  vtkProperty* property = AddBall(picture.Renderer, 0.7)->GetProperty();
  property->SetAmbient(0.4);
  property->SetDiffuse(0.6);
}
