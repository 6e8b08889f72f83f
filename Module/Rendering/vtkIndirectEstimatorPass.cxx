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
