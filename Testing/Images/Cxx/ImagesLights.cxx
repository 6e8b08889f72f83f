// SPDX-License-Identifier: BSD-3-Clause
// Each kind of light. The court is open above; only indirect light reaches its shadows.
#include "ImagePicture.h"

#include "vtkLightKit.h"

using contract::LightKind;
using contract::MakeLight;

VTK_INDIRECT_IMAGE(LightSpot)
{
  images::AddCourt(picture.Renderer);
  picture.Renderer->AddLight(
    MakeLight(LightKind::Spot, { 1.2, 2.4, 1.6 }, { -0.4, 0.3, -0.6 }, 22));
}

VTK_INDIRECT_IMAGE(LightSpotExponent)
{
  images::AddCourt(picture.Renderer);
  auto light = MakeLight(LightKind::Spot, { 1.2, 2.4, 1.6 }, { -0.4, 0.3, -0.6 }, 35);
  light->SetExponent(12);
  picture.Renderer->AddLight(light);
}

// Wider than one face of a map.
VTK_INDIRECT_IMAGE(LightSpotWide)
{
  images::AddCourt(picture.Renderer);
  picture.Renderer->AddLight(MakeLight(LightKind::WideSpot, { 0.4, 1.5, 0.8 }, { -0.4, 0, -0.4 }));
}

VTK_INDIRECT_IMAGE(LightPoint)
{
  images::AddCourt(picture.Renderer);
  auto light = MakeLight(LightKind::Point, { 0.0, 1.2, 0.6 }, { 0, 0, 0 });
  light->SetIntensity(0.7);
  picture.Renderer->AddLight(light);
}

VTK_INDIRECT_IMAGE(LightDirectional)
{
  images::AddCourt(picture.Renderer);
  images::AddSun(picture.Renderer);
}

VTK_INDIRECT_IMAGE(LightHeadlight)
{
  images::AddCourt(picture.Renderer);
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  light->SetIntensity(0.7);
  picture.Renderer->AddLight(light);
}

// The light that VTK creates if there is none.
VTK_INDIRECT_IMAGE(LightCreatedByVTK)
{
  images::AddCourt(picture.Renderer);
}

// Above the eye and to its left.
VTK_INDIRECT_IMAGE(LightCamera)
{
  images::AddCourt(picture.Renderer);
  vtkNew<vtkLight> light;
  light->SetLightTypeToCameraLight();
  light->SetPosition(-0.6, 0.8, 1);
  light->SetFocalPoint(0, 0, 0);
  light->SetIntensity(0.8);
  picture.Renderer->AddLight(light);
}

VTK_INDIRECT_IMAGE(LightKit)
{
  images::AddCourt(picture.Renderer);
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(picture.Renderer);
}

VTK_INDIRECT_IMAGE(LightColored)
{
  images::AddCourt(picture.Renderer);
  images::AddSun(picture.Renderer)->SetColor(1.0, 0.5, 0.1);
}

VTK_INDIRECT_IMAGE(LightAttenuated)
{
  images::AddCourt(picture.Renderer);
  auto light = MakeLight(LightKind::Point, { 0.0, 0.9, 0.7 }, { 0, 0, 0 });
  light->SetAttenuationValues(0, 0, 1);
  light->SetIntensity(0.6);
  picture.Renderer->AddLight(light);
}

// Red from the right, green from above, blue from the left: shadows have the other colours.
VTK_INDIRECT_IMAGE(LightSeveral)
{
  images::AddCourt(picture.Renderer);
  auto red = MakeLight(LightKind::Directional, { 2, 1.5, 1 }, { 0, 0, 0 });
  red->SetColor(0.7, 0.1, 0.1);
  auto green = MakeLight(LightKind::Spot, { 0.2, 3.0, 1.0 }, { 0.1, 0, 0 }, 30);
  green->SetColor(0.1, 0.7, 0.1);
  auto blue = MakeLight(LightKind::Point, { -1.6, 1.2, 1.2 }, { 0, 0, 0 });
  blue->SetColor(0.1, 0.1, 0.7);
  for (const auto& light : { red, green, blue })
  {
    picture.Renderer->AddLight(light);
  }
}

// One of two suns is off.
VTK_INDIRECT_IMAGE(LightSwitchedOff)
{
  images::AddCourt(picture.Renderer);
  images::AddSun(picture.Renderer);
  auto other = MakeLight(LightKind::Directional, { -2, 1.5, 1 }, { 0, 0, 0 });
  other->SwitchOff();
  picture.Renderer->AddLight(other);
}
