// SPDX-License-Identifier: BSD-3-Clause
// Actors, lights and the room.
#include "vtkImageData.h"
#include "vtkIndirectContractUtilities.h"
#include "vtkTexture.h"

#include "vtkCubeSource.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"

namespace contract
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeActor(vtkAlgorithm* source, const Vec3& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  return actor;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> MakeColorfulTexture()
{
  vtkNew<vtkImageData> picture;
  picture->SetDimensions(4, 4, 1);
  picture->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int i = 0; i < 48; ++i)
  {
    static_cast<unsigned char*>(picture->GetScalarPointer())[i] =
      static_cast<unsigned char>(17 * i);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(picture);
  return texture;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeQuad(
  const Vec3& origin, const Vec3& point1, const Vec3& point2, const Vec3& color, int resolution)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(origin[0], origin[1], origin[2]);
  source->SetPoint1(point1[0], point1[1], point1[2]);
  source->SetPoint2(point2[0], point2[1], point2[2]);
  source->SetResolution(resolution, resolution);
  return MakeActor(source, color);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeSphere(
  const Vec3& center, double radius, const Vec3& color, int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(center[0], center[1], center[2]);
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  return MakeActor(source, color);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> MakeBox(const Vec3& lower, const Vec3& upper, const Vec3& color)
{
  vtkNew<vtkCubeSource> source;
  source->SetBounds(lower[0], upper[0], lower[1], upper[1], lower[2], upper[2]);
  return MakeActor(source, color);
}

//------------------------------------------------------------------------------
const char* GetName(LightKind kind)
{
  static const char* const names[] = { "directional", "spot", "wide spot", "point" };
  return names[static_cast<int>(kind)];
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> MakeLight(
  LightKind kind, const Vec3& position, const Vec3& focalPoint, double coneAngle)
{
  auto light = vtkSmartPointer<vtkLight>::New();
  light->SetLightTypeToSceneLight();
  light->SetPosition(position[0], position[1], position[2]);
  light->SetFocalPoint(focalPoint[0], focalPoint[1], focalPoint[2]);
  light->SetPositional(kind != LightKind::Directional);
  if (kind == LightKind::Spot)
  {
    light->SetConeAngle(coneAngle);
  }
  else if (kind == LightKind::WideSpot)
  {
    light->SetConeAngle(80.0);
  }
  else
  {
    light->SetConeAngle(90.0);
  }
  light->SetExponent(0.0);
  return light;
}

//------------------------------------------------------------------------------
void AddRoomSurfaces(vtkRenderer* renderer)
{
  renderer->AddActor(MakeQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }));
  renderer->AddActor(MakeQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.8, 0.1, 0.1 }));
  renderer->AddActor(MakeQuad({ 1, 0, 0 }, { 1, 0, 1 }, { 1, 1, 0 }, { 0.1, 0.8, 0.1 }));
  renderer->AddActor(MakeQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }));
  renderer->AddActor(MakeQuad({ 0, 1, 0 }, { 1, 1, 0 }, { 0, 1, 1 }));
  renderer->AddActor(MakeSphere({ 0.5, 0.25, 0.4 }, 0.2));
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.5, 0.5, 3.0);
  camera->SetFocalPoint(0.5, 0.5, 0.0);
  camera->SetViewUp(0, 1, 0);
  camera->SetViewAngle(30);
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void AddRoom(vtkRenderer* renderer)
{
  AddRoomSurfaces(renderer);
  auto light = MakeLight(LightKind::Spot, { 0.5, 0.95, 0.6 }, { 0.3, 0.0, 0.4 }, 55.0);
  light->SetAttenuationValues(0, 0, 1);
  light->SetIntensity(0.6);
  renderer->AddLight(light);
}
}
