// SPDX-License-Identifier: BSD-3-Clause
#include "vtkVirtualLightSampler.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "VirtualLights/vtkIndirectLightTable.h"
#include "vtkOpenGLRenderWindow.h"

#include <algorithm>

static_assert(vtkVirtualLightSampler::RowLength == vtkIndirectKernels::VTKI_ROW_LENGTH,
  "what shaders read the table by");

//------------------------------------------------------------------------------
vtkVirtualLightSampler::vtkVirtualLightSampler()
  : Table(new vtkIndirectTarget(vtkIndirectLightTable, false))
{
}

vtkVirtualLightSampler::~vtkVirtualLightSampler() = default;

//------------------------------------------------------------------------------
void vtkVirtualLightSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ActualNumberOfLights: " << this->GetActualNumberOfLights() << "\n";
  this->Table->Print(os, indent);
}

//------------------------------------------------------------------------------
int vtkVirtualLightSampler::GetActualNumberOfLights() const
{
  return this->NumberOfLights;
}

//------------------------------------------------------------------------------
bool vtkVirtualLightSampler::Resize(vtkOpenGLRenderWindow* window, int numberOfLights)
{
  const int rows = std::max(1, (numberOfLights + RowLength - 1) / RowLength);
  this->NumberOfLights = numberOfLights;
  return this->Table->Resize(window, RowLength, rows);
}

//------------------------------------------------------------------------------
vtkIndirectTarget& vtkVirtualLightSampler::BeginChange()
{
  this->ContentTime.Modified();
  return *this->Table;
}

//------------------------------------------------------------------------------
size_t vtkVirtualLightSampler::GetBytes() const
{
  return this->Table->GetBytes();
}

//------------------------------------------------------------------------------
void vtkVirtualLightSampler::ReleaseGraphicsResources(vtkWindow* window)
{
  if (window)
  {
    this->Table->Release(window);
  }
}
