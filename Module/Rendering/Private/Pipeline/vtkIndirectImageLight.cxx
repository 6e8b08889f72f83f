// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectImageLight.h"

#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkOpenGLRenderer.h"
#include "vtkPBRIrradianceTexture.h"
#include "vtkPointData.h"
#include "vtkTexture.h"

//------------------------------------------------------------------------------
vtkEnvironmentLight* vtkIndirectImageLight::Find(vtkRenderer* renderer)
{
  vtkTexture* texture =
    renderer->GetUseImageBasedLighting() ? renderer->GetEnvironmentTexture() : nullptr;
  vtkImageData* image = nullptr;
  if (texture && !texture->GetCubeMap())
  {
    texture->Update();
    image = texture->GetInput();
  }
  if (!image || !image->GetPointData()->GetScalars() || image->GetDimensions()[2] != 1)
  {
    this->Light->SetTexture(nullptr);
    return nullptr;
  }
  this->Light->SetTexture(texture);
  // VTK's shaders of PBR look up the texture's middle to the right, a quarter of a turn from its
  // place on VTK's skybox.
  double front[3];
  vtkMath::Cross(renderer->GetEnvironmentRight(), renderer->GetEnvironmentUp(), front);
  this->Light->SetUp(renderer->GetEnvironmentUp());
  this->Light->SetRight(front);
  auto* opengl = vtkOpenGLRenderer::SafeDownCast(renderer);
  this->Light->SetEncoded(opengl && opengl->GetEnvMapIrradiance()->GetConvertToLinear());
  return this->Light;
}
