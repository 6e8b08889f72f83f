// SPDX-License-Identifier: BSD-3-Clause
// Each channel in place of the picture. Lengths are shown over the far plane, levels over eight.
#include "ImagePicture.h"
#include "vtkIndirectDetails.h"

#include "vtkActorCollection.h"

#include "vtkIndirectSplattingPass.h"
#include "vtkMultiresolutionSplattingPass.h"

namespace
{
// The room with a sphere that reflects specularly.
void Show(images::Picture& picture, const std::string& channel)
{
  images::AddRoom(picture);
  vtkProperty* property = picture.Renderer->GetActors()->GetLastActor()->GetProperty();
  property->SetSpecular(0.6);
  property->SetSpecularPower(12);
  property->SetSpecularColor(1.0, 0.9, 0.7);
  picture.Pass->SetReflectiveShadowMapResolution(160);
  picture.ShowChannel(channel);
  // Indirect light alone is too dark at the light's usual intensity.
  if (channel == "indirect" || channel == "irradiance" || channel == "glossy")
  {
    images::SetIntensity(picture, channel == "glossy" ? 4.0 : 1.5);
  }
}

void ShowSubsplats(images::Picture& picture, const std::string& channel)
{
  images::AddRoom(picture);
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  SET_DETAIL(splatting, CoarsestResolution, 16);
  picture.Pass->SetEstimator(splatting);
  images::SetIntensity(picture, 1.5);
  picture.ShowChannel(channel);
}
}

VTK_INDIRECT_IMAGE(ViewFinal)
{
  Show(picture, "final");
}

VTK_INDIRECT_IMAGE(ViewDirect)
{
  Show(picture, "direct");
}

VTK_INDIRECT_IMAGE(ViewIndirect)
{
  Show(picture, "indirect");
}

VTK_INDIRECT_IMAGE(ViewIrradiance)
{
  Show(picture, "irradiance");
}

VTK_INDIRECT_IMAGE(ViewGlossy)
{
  Show(picture, "glossy");
}

VTK_INDIRECT_IMAGE(ViewAlbedo)
{
  Show(picture, "albedo");
}

VTK_INDIRECT_IMAGE(ViewNormal)
{
  Show(picture, "normal");
}

VTK_INDIRECT_IMAGE(ViewDepth)
{
  Show(picture, "depth");
}

VTK_INDIRECT_IMAGE(ViewSpecular)
{
  Show(picture, "specular");
}

VTK_INDIRECT_IMAGE(ViewMapDepth)
{
  Show(picture, "rsm0.depth");
}

VTK_INDIRECT_IMAGE(ViewMapNormal)
{
  Show(picture, "rsm0.normal");
}

VTK_INDIRECT_IMAGE(ViewMapDensity)
{
  Show(picture, "rsm0.density");
}

// Six faces in a row.
VTK_INDIRECT_IMAGE(ViewMapOfPoint)
{
  images::AddRoomSurfaces(picture);
  picture.Renderer->AddLight(
    contract::MakeLight(contract::LightKind::Point, { 0.437, 0.713, 0.619 }, { 0, 0, 0 }));
  picture.Pass->SetReflectiveShadowMapResolution(64);
  picture.Window->SetSize(192, 32);
  picture.ShowChannel("rsm0.density");
}

// The number of splats at each pixel, here of each tile of 16 x 16 pixels; white means 256, the
// number of lights.
VTK_INDIRECT_IMAGE(ViewSplatOverdraw)
{
  images::AddRoom(picture);
  vtkNew<vtkIndirectSplattingPass> splatting;
  picture.Pass->SetEstimator(splatting);
  picture.ShowChannel("splat.overdraw");
}

VTK_INDIRECT_IMAGE(ViewSubsplatLevel)
{
  ShowSubsplats(picture, "subsplat.level");
}

VTK_INDIRECT_IMAGE(ViewSubsplatOutline)
{
  ShowSubsplats(picture, "subsplat.outline");
}

VTK_INDIRECT_IMAGE(ViewSubsplatEvaluated)
{
  ShowSubsplats(picture, "subsplat.evaluated1");
}

VTK_INDIRECT_IMAGE(ViewSubsplatUpsampled)
{
  ShowSubsplats(picture, "subsplat.upsampled1");
}
