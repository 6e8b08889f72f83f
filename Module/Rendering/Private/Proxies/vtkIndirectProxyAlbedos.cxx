// SPDX-License-Identifier: BSD-3-Clause
#include "Proxies/vtkIndirectProxyAlbedos.h"

#include "vtkAbstractArray.h"
#include "vtkDataSet.h"
#include "vtkMapper.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"

#include <algorithm>

//------------------------------------------------------------------------------
glm::vec3 vtkIndirectProxyAlbedos::Find(vtkProperty* property, const glm::dvec3& color)
{
  if (!property->GetLighting())
  {
    return glm::vec3(0.0f);
  }
  // As the capture of surfaces clamps it.
  const glm::dvec3 albedo = property->GetInterpolation() == VTK_PBR
    ? (1.0 - property->GetMetallic()) * glm::pow(color, glm::dvec3(2.2))
    : property->GetDiffuse() * color;
  return glm::vec3(glm::clamp(albedo, glm::dvec3(0.0), glm::dvec3(1.0)));
}

//------------------------------------------------------------------------------
vtkIndirectProxyAlbedos::vtkIndirectProxyAlbedos(
  vtkMapper* mapper, vtkProperty* property, vtkDataSet* data)
  : Property(property)
{
  const double* color = property->GetDiffuseColor();
  this->Plain = Find(property, glm::dvec3(color[0], color[1], color[2]));
  if (!mapper->GetScalarVisibility())
  {
    return;
  }
  int cells = 0;
  vtkAbstractArray* scalars = vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
    mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cells);
  vtkScalarsToColors* table = mapper->GetLookupTable();
  if (!scalars || !table || cells > 1)
  {
    return;
  }
  if (!mapper->GetUseLookupTableScalarRange())
  {
    table->SetRange(mapper->GetScalarRange());
  }
  table->Build();
  this->Colors = vtkSmartPointer<vtkUnsignedCharArray>::Take(vtkUnsignedCharArray::SafeDownCast(
    table->MapScalars(scalars, mapper->GetColorMode(), mapper->GetArrayComponent(), VTK_RGB)));
  this->ByCell = cells == 1;
}

//------------------------------------------------------------------------------
glm::vec3 vtkIndirectProxyAlbedos::Get(vtkIdType i) const
{
  if (!this->Colors || i < 0 || i >= this->Colors->GetNumberOfTuples())
  {
    return this->Plain;
  }
  const unsigned char* c = this->Colors->GetPointer(i * this->Colors->GetNumberOfComponents());
  return Find(this->Property, glm::dvec3(c[0], c[1], c[2]) / 255.0);
}

//------------------------------------------------------------------------------
glm::vec3 vtkIndirectProxyAlbedos::GetMean() const
{
  const vtkIdType count = this->Colors ? this->Colors->GetNumberOfTuples() : 0;
  const vtkIdType step = std::max<vtkIdType>(1, count / 1000);
  glm::dvec3 sum(0.0);
  double number = 0.0;
  for (vtkIdType i = 0; i < count; i += step)
  {
    sum += glm::dvec3(this->Get(i));
    number += 1.0;
  }
  return number > 0.0 ? glm::vec3(sum / number) : this->Plain;
}
