// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualLightSampler.h"

#include "Plan/vtkIndirectSettingList.h"
#include "Senders/vtkIndirectSampler.h"

#include <algorithm>

//------------------------------------------------------------------------------
vtkVirtualLightSampler::vtkVirtualLightSampler(std::unique_ptr<vtkIndirectSampler> lights)
  : Lights(std::move(lights))
{
}

vtkVirtualLightSampler::~vtkVirtualLightSampler() = default;

//------------------------------------------------------------------------------
void vtkVirtualLightSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  vtkIndirectSettingList settings;
  this->Lights->AddSettings(settings, nullptr);
  settings.Print(os, indent);
  this->Lights->GetTable().Print(os, indent);
  if (const vtkIndirectTarget* lobes = this->Lights->GetLobes())
  {
    lobes->Print(os, indent);
  }
}

//------------------------------------------------------------------------------
void vtkVirtualLightSampler::SetNumberOfLights(int number)
{
  const int clamped = std::clamp(number, 1, 1048576);
  if (clamped != this->NumberOfLights)
  {
    this->NumberOfLights = clamped;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkVirtualLightSampler::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Lights->Release(window);
}
