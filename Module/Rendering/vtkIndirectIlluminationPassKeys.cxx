// SPDX-License-Identifier: BSD-3-Clause
// The static methods of the pass, by which users set keys of props and lights.
#include "vtkIndirectIlluminationPass.h"

#include "Scene/vtkIndirectInformationKeys.h"

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkIndirectIlluminationPass::CASTS_SHADOWS()
{
  return vtkIndirectInformationKeys::CastsShadows();
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkIndirectIlluminationPass::SENDS_LIGHT()
{
  return vtkIndirectInformationKeys::SendsLight();
}

//------------------------------------------------------------------------------
vtkInformationIntegerKey* vtkIndirectIlluminationPass::CATCHES_LIGHT()
{
  return vtkIndirectInformationKeys::CatchesLight();
}

//------------------------------------------------------------------------------
vtkInformationStringKey* vtkIndirectIlluminationPass::NAME()
{
  return vtkIndirectInformationKeys::Name();
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::SetLightRadius(vtkLight* light, double radius)
{
  vtkIndirectInformationKeys::Set(
    light, vtkIndirectInformationKeys::LightRadius(), radius, VTK_DOUBLE_MAX);
}

//------------------------------------------------------------------------------
double vtkIndirectIlluminationPass::GetLightRadius(vtkLight* light)
{
  return vtkIndirectInformationKeys::Get(light, vtkIndirectInformationKeys::LightRadius());
}

//------------------------------------------------------------------------------
void vtkIndirectIlluminationPass::SetLightAngle(vtkLight* light, double degrees)
{
  vtkIndirectInformationKeys::Set(light, vtkIndirectInformationKeys::LightAngle(), degrees, 90.0);
}

//------------------------------------------------------------------------------
double vtkIndirectIlluminationPass::GetLightAngle(vtkLight* light)
{
  return vtkIndirectInformationKeys::Get(light, vtkIndirectInformationKeys::LightAngle());
}
