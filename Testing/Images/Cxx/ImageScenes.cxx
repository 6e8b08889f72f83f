// SPDX-License-Identifier: BSD-3-Clause
// Scenes of several cases.
#include "ImagePicture.h"

#include "vtkLightCollection.h"

namespace images
{
//------------------------------------------------------------------------------
void AddRoomSurfaces(Picture& picture)
{
  contract::AddRoomSurfaces(picture.Renderer);
  // The room fills the picture, and the view is oblique to its walls: rasterizers differ in pixels
  // whose centre lies on an edge.
  vtkCamera* camera = picture.Renderer->GetActiveCamera();
  camera->SetPosition(0.61, 0.58, 2.97);
  camera->SetViewAngle(22);
  picture.Renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
void AddRoom(Picture& picture)
{
  AddRoomSurfaces(picture);
  auto light =
    contract::MakeLight(contract::LightKind::Spot, { 0.5, 0.95, 0.6 }, { 0.3, 0.0, 0.4 }, 55.0);
  light->SetAttenuationValues(0, 0, 1);
  // Little of the picture is brighter than white.
  light->SetIntensity(0.4);
  picture.Renderer->AddLight(light);
}

//------------------------------------------------------------------------------
void SetIntensity(Picture& picture, double intensity)
{
  vtkLight::SafeDownCast(picture.Renderer->GetLights()->GetItemAsObject(0))
    ->SetIntensity(intensity);
}

//------------------------------------------------------------------------------
void AddCourt(vtkRenderer* renderer)
{
  using namespace contract;
  renderer->AddActor(MakeQuad({ -2, 0, -1.2 }, { -2, 0, 2 }, { 2, 0, -1.2 }));
  renderer->AddActor(MakeQuad({ -2, 0, -1.2 }, { 2, 0, -1.2 }, { -2, 2.4, -1.2 }));
  renderer->AddActor(MakeQuad({ -2, 0, -1.2 }, { -2, 2.4, -1.2 }, { -2, 0, 2 }, { 0.2, 0.4, 0.8 }));
  renderer->AddActor(MakeBox({ -1.2, 0, -0.9 }, { -0.4, 0.9, 0.0 }, { 0.9, 0.3, 0.2 }));
  renderer->AddActor(MakeSphere({ 0.7, 0.5, -0.2 }, 0.5, { 0.9, 0.8, 0.3 }, 48));
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0.6, 1.9, 5.0);
  camera->SetFocalPoint(-0.1, 0.5, 0);
  camera->SetViewAngle(30);
  renderer->ResetCameraClippingRange();
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkLight> AddSun(vtkRenderer* renderer)
{
  auto sun = contract::MakeLight(contract::LightKind::Directional, { 1.5, 2, 1.5 }, { 0, 0, 0 });
  sun->SetIntensity(0.8);
  renderer->AddLight(sun);
  return sun;
}
}
