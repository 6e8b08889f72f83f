// SPDX-License-Identifier: BSD-3-Clause
// One of each kind of prop that VTK draws with its opaque geometry.
#include "vtkIndirectContractUtilities.h"

#include "vtkAssembly.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkElevationFilter.h"
#include "vtkFollower.h"
#include "vtkGlyph3DMapper.h"
#include "vtkImageData.h"
#include "vtkImageSlice.h"
#include "vtkImageSliceMapper.h"
#include "vtkLODProp3D.h"
#include "vtkLineSource.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropAssembly.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVectorText.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
#include "vtkCompositePolyDataMapper.h"
using CompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using CompositeMapper = vtkCompositePolyDataMapper2;
#endif

#include <functional>

namespace
{
using Maker = std::function<vtkSmartPointer<vtkProp>()>;

vtkSmartPointer<vtkSphereSource> Ball(int resolution = 24)
{
  auto source = vtkSmartPointer<vtkSphereSource>::New();
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->SetRadius(0.42);
  return source;
}

vtkSmartPointer<vtkActor> Plain()
{
  return contract::MakeActor(Ball(), { 0.7, 0.6, 0.3 });
}

// A ball whose cells, or points, have values from 0 to 1.
vtkSmartPointer<vtkActor> Scalars(bool cells, bool interpolate)
{
  auto source = Ball();
  source->Update();
  vtkNew<vtkPolyData> data;
  data->DeepCopy(source->GetOutput());
  vtkNew<vtkDoubleArray> values;
  const vtkIdType count = cells ? data->GetNumberOfCells() : data->GetNumberOfPoints();
  for (vtkIdType i = 0; i < count; ++i)
  {
    values->InsertNextValue(static_cast<double>((37 * i) % 101) / 100.0);
  }
  vtkDataSetAttributes* attributes = cells
    ? static_cast<vtkDataSetAttributes*>(data->GetCellData())
    : static_cast<vtkDataSetAttributes*>(data->GetPointData());
  attributes->SetScalars(values);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetInterpolateScalarsBeforeMapping(interpolate);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkImageData> Checkers()
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

vtkSmartPointer<vtkActor> Textured()
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-0.4, -0.4, 0.1);
  source->SetPoint1(0.4, -0.4, 0.1);
  source->SetPoint2(-0.4, 0.4, 0.1);
  vtkNew<vtkTexture> texture;
  texture->SetInputData(Checkers());
  auto actor = contract::MakeActor(source, { 0.9, 0.9, 0.9 });
  actor->SetTexture(texture);
  return actor;
}

vtkSmartPointer<vtkActor> With(const std::function<void(vtkProperty*)>& change, int resolution = 12)
{
  auto actor = contract::MakeActor(Ball(resolution), { 0.3, 0.6, 0.8 });
  change(actor->GetProperty());
  return actor;
}

vtkSmartPointer<vtkActor> Lines(bool tubes)
{
  vtkNew<vtkLineSource> source;
  source->SetPoint1(-0.4, -0.4, 0);
  source->SetPoint2(0.4, 0.4, 0.1);
  auto actor = contract::MakeActor(source, { 0.9, 0.4, 0.2 });
  actor->GetProperty()->SetLineWidth(tubes ? 6 : 1);
  actor->GetProperty()->SetRenderLinesAsTubes(tubes);
  return actor;
}

vtkSmartPointer<vtkActor> BackfaceProperty()
{
  auto source = Ball();
  source->SetEndTheta(200);
  auto actor = contract::MakeActor(source, { 0.2, 0.7, 0.2 });
  vtkNew<vtkProperty> back;
  back->SetColor(0.9, 0.2, 0.7);
  actor->SetBackfaceProperty(back);
  return actor;
}

vtkSmartPointer<vtkActor> Composite()
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 2; ++i)
  {
    auto source = Ball(12);
    source->SetCenter(i ? 0.2 : -0.2, 0, 0);
    source->SetRadius(0.2);
    source->Update();
    vtkNew<vtkPolyData> data;
    data->DeepCopy(source->GetOutput());
    blocks->SetBlock(i, data);
  }
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->SetBlockColor(2, 0.1, 0.3, 0.9);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  return actor;
}

vtkSmartPointer<vtkActor> Glyphs()
{
  vtkNew<vtkPlaneSource> points;
  points->SetOrigin(-0.3, -0.3, 0);
  points->SetPoint1(0.3, -0.3, 0);
  points->SetPoint2(-0.3, 0.3, 0);
  points->SetResolution(2, 2);
  auto glyph = Ball(8);
  glyph->SetRadius(0.1);
  vtkNew<vtkGlyph3DMapper> mapper;
  mapper->SetInputConnection(points->GetOutputPort());
  mapper->SetSourceConnection(glyph->GetOutputPort());
  mapper->ScalingOff();
  mapper->OrientOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.8, 0.8, 0.3);
  return actor;
}

vtkSmartPointer<vtkActor> SphereImpostors()
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(-0.2, 0, 0);
  points->InsertNextPoint(0.2, 0, 0);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  // Without cells the data would have no bounds.
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ 0, 1 });
  data->SetVerts(vertices);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetRadius(0.18f);
  mapper->SetInputData(data);
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.6, 0.3, 0.9);
  return actor;
}

vtkSmartPointer<vtkProp> Assembly()
{
  auto left = contract::MakeActor(Ball(12), { 0.9, 0.5, 0.1 });
  auto right = contract::MakeActor(Ball(12), { 0.1, 0.5, 0.9 });
  left->SetScale(0.5);
  left->SetPosition(-0.2, 0, 0);
  right->SetScale(0.5);
  right->SetPosition(0.2, 0, 0);
  auto assembly = vtkSmartPointer<vtkAssembly>::New();
  assembly->AddPart(left);
  assembly->AddPart(right);
  assembly->RotateZ(30);
  return assembly;
}

vtkSmartPointer<vtkProp> LevelsOfDetail()
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(Ball()->GetOutputPort());
  auto prop = vtkSmartPointer<vtkLODProp3D>::New();
  vtkNew<vtkProperty> property;
  property->SetColor(0.5, 0.8, 0.5);
  prop->AddLOD(mapper, property, 0.0);
  return prop;
}

vtkSmartPointer<vtkProp> Slice()
{
  vtkNew<vtkImageSliceMapper> mapper;
  mapper->SetInputData(Checkers());
  auto slice = vtkSmartPointer<vtkImageSlice>::New();
  slice->SetMapper(mapper);
  slice->SetScale(0.1);
  return slice;
}

vtkSmartPointer<vtkProp> Text()
{
  vtkNew<vtkVectorText> text;
  text->SetText("VTK");
  auto actor = contract::MakeActor(text, { 0.9, 0.9, 0.2 });
  actor->SetScale(0.25);
  return actor;
}
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkProp3D> contract::MakeFollower(vtkRenderer* renderer, double scale)
{
  vtkNew<vtkVectorText> text;
  text->SetText("F");
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(text->GetOutputPort());
  auto follower = vtkSmartPointer<vtkFollower>::New();
  follower->SetMapper(mapper);
  follower->SetCamera(renderer->GetActiveCamera());
  follower->SetScale(scale);
  return follower;
}

//------------------------------------------------------------------------------
void contract::AddKinds(
  vtkRenderer* renderer, std::vector<std::string>* names, const std::string& only)
{
  const std::vector<std::pair<const char*, Maker>> makers = {
    { "plain", Plain },
    { "cell scalars", [] { return Scalars(true, false); } },
    { "point scalars", [] { return Scalars(false, false); } },
    { "interpolated scalars", [] { return Scalars(false, true); } },
    { "texture", Textured },
    { "flat", [] { return With([](vtkProperty* p) { p->SetInterpolationToFlat(); }); } },
    { "wireframe", [] { return With([](vtkProperty* p) { p->SetRepresentationToWireframe(); }); } },
    { "edges", [] { return With([](vtkProperty* p) { p->EdgeVisibilityOn(); }); } },
    { "points",
      []
      {
        return With(
          [](vtkProperty* p)
          {
            p->SetRepresentationToPoints();
            p->SetPointSize(3);
          });
      } },
    { "points as spheres",
      []
      {
        return With(
          [](vtkProperty* p)
          {
            p->SetRepresentationToPoints();
            p->RenderPointsAsSpheresOn();
            p->SetPointSize(5);
          });
      } },
    { "lines", [] { return Lines(false); } },
    { "tubes", [] { return Lines(true); } },
    { "backface property", BackfaceProperty },
    { "physically based",
      []
      {
        return With(
          [](vtkProperty* p)
          {
            p->SetInterpolationToPBR();
            p->SetMetallic(0.3);
            p->SetRoughness(0.5);
          },
          24);
      } },
    { "specular",
      []
      {
        return With(
          [](vtkProperty* p)
          {
            p->SetSpecular(0.6);
            p->SetSpecularPower(20);
          });
      } },
    { "unlit", [] { return With([](vtkProperty* p) { p->LightingOff(); }); } },
    { "composite", Composite },
    { "glyphs", Glyphs },
    { "sphere impostors", SphereImpostors },
    { "assembly", Assembly },
    { "prop assembly",
      []
      {
        auto assembly = vtkSmartPointer<vtkPropAssembly>::New();
        assembly->AddPart(Plain());
        return assembly;
      } },
    { "levels of detail", LevelsOfDetail },
    { "image slice", Slice },
    { "text", Text },
    { "follower", [renderer] { return contract::MakeFollower(renderer, 0.5); } },
  };

  const int columns = 5;
  int index = 0;
  for (const auto& maker : makers)
  {
    if (names)
    {
      names->emplace_back(maker.first);
    }
    double place[3] = { static_cast<double>(index % columns), static_cast<double>(index / columns),
      0.0 };
    ++index;
    if (!only.empty() && only != maker.first)
    {
      continue;
    }
    vtkSmartPointer<vtkProp> prop = maker.second();
    if (auto* prop3D = vtkProp3D::SafeDownCast(prop))
    {
      prop3D->SetPosition(place);
    }
    else
    {
      vtkPropCollection* parts = vtkPropAssembly::SafeDownCast(prop)->GetParts();
      vtkProp3D::SafeDownCast(parts->GetItemAsObject(0))->SetPosition(place);
    }
    renderer->AddViewProp(prop);
  }
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetFocalPoint(2, 2, 0);
  camera->SetPosition(2.6, 1.2, 10);
  camera->SetViewAngle(30);
  renderer->ResetCameraClippingRange();
}
