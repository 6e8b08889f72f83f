// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkIndirectEstimatorPass.h"

#include "vtkIndirectReport.h"
#include "vtkIndirectTarget.h"

namespace
{
const vtkIndirectChannel Channels[] = {
  { "irradiance", "vtkiIrradiance", "indirect irradiance", GL_RGBA32F, "-", "VTK irradiance" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel HalfChannels[] = {
  { "irradiance", "vtkiIrradiance", "indirect irradiance", GL_RGBA16F, "-",
    "VTK irradiance over the frame's unit" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
}

//------------------------------------------------------------------------------
vtkIndirectEstimatorPass::vtkIndirectEstimatorPass()
  : Irradiance(new vtkIndirectTarget(Channels, false))
{
}

vtkIndirectEstimatorPass::~vtkIndirectEstimatorPass() = default;

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MethodName: " << this->GetMethodName() << "\n";
  os << indent << "MaximumNumberOfBounces: " << this->GetMaximumNumberOfBounces() << "\n";
  this->Irradiance->Print(os, indent);
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::Render(const vtkRenderState*)
{
  vtkErrorMacro("An estimator draws nothing by itself; give it to "
                "vtkIndirectIlluminationPass::SetEstimator.");
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::SetIrradianceStorage(
  vtkWindow* window, bool half, double unit, bool depth)
{
  this->IrradianceUnit = unit;
  if (half != this->IrradianceIsHalf || depth != this->IrradianceHasDepth)
  {
    this->Irradiance->Release(window);
    this->Irradiance =
      std::make_unique<vtkIndirectTarget>(half ? HalfChannels : Channels, depth, 16);
    this->IrradianceIsHalf = half;
    this->IrradianceHasDepth = depth;
  }
}

//------------------------------------------------------------------------------
size_t vtkIndirectEstimatorPass::GetBytes() const
{
  return this->Irradiance->GetBytes();
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::AddToReport(vtkIndirectReport& report) const
{
  report.Modelled.emplace_back("one diffuse bounce", this->GetClassName());
  report.LeftOut.emplace_back("visibility between sender and receiver",
    std::string(this->GetClassName()) + " does not test it; the result is too bright");
}

//------------------------------------------------------------------------------
void vtkIndirectEstimatorPass::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Irradiance->Release(window);
}
