// SPDX-License-Identifier: BSD-3-Clause
// What surfaces reflect diffusely, linear: albedos of data as its mapper colours it, one for each
// point, or each cell.
#ifndef vtkIndirectProxyAlbedos_h
#define vtkIndirectProxyAlbedos_h

#include "vtkSmartPointer.h"      // for a member
#include "vtkType.h"              // for numbers
#include "vtkUnsignedCharArray.h" // for a member

#include <glm/glm.hpp> // for albedos

class vtkDataSet;
class vtkMapper;
class vtkProperty;

class vtkIndirectProxyAlbedos
{
public:
  vtkIndirectProxyAlbedos(vtkMapper* mapper, vtkProperty* property, vtkDataSet* data);

  bool AreByCell() const { return this->Colors && this->ByCell; }
  /** Of a point or cell; that of the property where there are no colours. */
  glm::vec3 Get(vtkIdType i) const;
  glm::vec3 GetMean() const;

  /** Of a surface of one colour. */
  static glm::vec3 Find(vtkProperty* property, const glm::dvec3& color);

private:
  vtkProperty* Property;
  glm::vec3 Plain;
  vtkSmartPointer<vtkUnsignedCharArray> Colors;
  bool ByCell = false;
};
#endif
