// SPDX-License-Identifier: BSD-3-Clause
#include "Capture/vtkIndirectWithin.h"

#include "Scene/vtkIndirectFrame.h"
#include "vtkActor.h"
#include "vtkMatrix3x3.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLCamera.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"

#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

//------------------------------------------------------------------------------
void vtkIndirectWithin::SetUniforms(
  vtkShaderProgram* program, vtkProp* prop, vtkRenderer* renderer, const glm::dvec3& sceneCenter)
{
  auto* actor = vtkActor::SafeDownCast(prop);
  auto* camera = vtkOpenGLCamera::SafeDownCast(renderer->GetActiveCamera());
  if (!actor || !camera || !program->IsUniformUsed("vtkiWithin"))
  {
    return;
  }
  const glm::dmat4 toWorld = vtkIndirectFrame::ToGLM(actor->GetMatrix());
  glm::vec3 within(glm::inverse(toWorld) * glm::dvec4(sceneCenter, 1.0));
  if (!std::isfinite(within.x + within.y + within.z))
  {
    within = glm::vec3(0.0f);
  }
  vtkMatrix4x4* toView;
  vtkMatrix3x3* normals;
  vtkMatrix4x4* projection;
  vtkMatrix4x4* toClip;
  camera->GetKeyMatrices(renderer, toView, normals, projection, toClip); // transposed
  const glm::dmat4 fromWithin = glm::translate(toWorld, glm::dvec3(within));
  const auto set = [&](const char* name, vtkMatrix4x4* matrix)
  {
    if (program->IsUniformUsed(name))
    {
      const glm::mat4 product(glm::transpose(vtkIndirectFrame::ToGLM(matrix)) * fromWithin);
      program->SetUniformMatrix4x4(name, const_cast<float*>(glm::value_ptr(product)));
    }
  };
  program->SetUniform3f("vtkiWithin", glm::value_ptr(within));
  set("vtkiWithinToView", toView);
  set("vtkiWithinToClip", toClip);
}
