// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkRadianceHintsPass.h"

#include "RadianceHints/vtkIndirectHintRegions.h"
#include "RadianceHints/vtkIndirectHintSum.h"
#include "vtkObjectFactory.h"

#include <algorithm>

vtkStandardNewMacro(vtkRadianceHintsPass);

namespace
{
vtkIndirectHintSum& SumOf(const vtkRadianceHintsPass* pass)
{
  return static_cast<vtkIndirectHintSum&>(vtkIndirectSum::Get(pass));
}
}

//------------------------------------------------------------------------------
vtkRadianceHintsPass::vtkRadianceHintsPass()
  : vtkIndirectEstimatorPass(std::make_unique<vtkIndirectHintSum>(*this))
  , Details(new vtkIndirectHintDetails)
{
}

vtkRadianceHintsPass::~vtkRadianceHintsPass() = default;

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  SumOf(this).GetCoarse().Print(os, indent);
}

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::ApplyPreset()
{
  this->Settings = SettingsType();
  *this->Details =
    this->GetPreset() == PAPER ? vtkIndirectHintDetails::OfPaper() : vtkIndirectHintDetails();
}

//------------------------------------------------------------------------------
void vtkRadianceHintsPass::SetGridResolution(int x, int y, int z)
{
  const int wanted[3] = { x, y, z };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int hints = std::clamp(wanted[axis], 0, vtkIndirectHintRegions::MaximumResolution);
    if (hints != this->Settings.GridResolution[axis])
    {
      this->Settings.GridResolution[axis] = hints;
      this->Modified();
    }
  }
}

//------------------------------------------------------------------------------
int vtkRadianceHintsPass::GetNumberOfHints() const
{
  return SumOf(this).Grid.GetNumberOfHints();
}

//------------------------------------------------------------------------------
int vtkRadianceHintsPass::GetNumberOfActiveHints() const
{
  return SumOf(this).Grid.GetNumberOfActiveHints();
}
