// SPDX-License-Identifier: BSD-3-Clause
// The same room by each estimator and each sampler.
#include "ImagePicture.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCylinderSource.h"
#include "vtkEnvironmentLight.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkImportanceLightSampler.h"
#include "vtkOpenGLSphereMapper.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProxyAccumulationPass.h"

#include "vtkIndirectSplattingPass.h"
#include "vtkLight.h"
#include "vtkLightTreeSampler.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkPolyDataNormals.h"
#include "vtkProperty.h"
#include "vtkRSMReferencePass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkRandomWalkLightSampler.h"

#include <cmath>

namespace
{
// The sphere reflects the walls and the floor in a Phong lobe.
void MakeSpecular(images::Picture& picture)
{
  vtkProperty* property = picture.Renderer->GetActors()->GetLastActor()->GetProperty();
  property->SetDiffuse(0.1);
  property->SetSpecular(0.9);
  property->SetSpecularPower(20);
  images::SetIntensity(picture, 0.6);
}
}

VTK_INDIRECT_IMAGE(EstimatorAllTexels)
{
  images::AddRoom(picture);
  picture.Pass->SetReflectiveShadowMapResolution(64);
  picture.Gather->SetModeToAllTexels();
}

// Particles over a ground under a sky with a bright side: soft shadows on the other side, and
// colour on the ground.
VTK_INDIRECT_IMAGE(EstimatorProxies)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> points;
  vtkNew<vtkFloatArray> sizes;
  sizes->SetName("size");
  vtkNew<vtkCellArray> cells;
  for (int i = 0; i < 60; ++i)
  {
    const double turn = 2.399963 * i;
    const vtkIdType id = points->InsertNextPoint(0.11 * std::sqrt(i) * std::cos(turn),
      0.1 + 0.07 * (i % 7), 0.11 * std::sqrt(i) * std::sin(turn));
    sizes->InsertNextValue(0.05f + 0.012f * static_cast<float>(i % 5));
    cells->InsertNextCell(1, &id);
  }
  data->SetPoints(points);
  data->SetVerts(cells);
  data->GetPointData()->AddArray(sizes);
  vtkNew<vtkOpenGLSphereMapper> mapper;
  mapper->SetInputData(data);
  mapper->SetScaleArray("size");
  vtkNew<vtkActor> spheres;
  spheres->SetMapper(mapper);
  spheres->GetProperty()->SetColor(0.95, 0.45, 0.2);
  picture.Renderer->AddActor(spheres);
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-2.5, 0.0, 2.5);
  plane->SetPoint1(2.5, 0.0, 2.5);
  plane->SetPoint2(-2.5, 0.0, -2.5);
  vtkNew<vtkPolyDataMapper> flat;
  flat->SetInputConnection(plane->GetOutputPort());
  vtkNew<vtkActor> ground;
  ground->SetMapper(flat);
  ground->GetProperty()->SetColor(0.8, 0.8, 0.8);
  picture.Renderer->AddActor(ground);
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 8, 1);
  image->AllocateScalars(VTK_FLOAT, 3);
  auto* radiance = static_cast<float*>(image->GetScalarPointer());
  for (int i = 0; i < 3 * 16 * 8; ++i)
  {
    radiance[i] = i / 3 % 16 < 8 ? 1.4f : 0.4f;
  }
  vtkNew<vtkEnvironmentLight> sky;
  sky->SetImage(image);
  picture.Pass->SetEnvironment(sky);
  vtkNew<vtkProxyAccumulationPass> proxies;
  picture.Pass->SetEstimator(proxies);
  picture.Renderer->AutomaticLightCreationOff();
  vtkCamera* camera = picture.Renderer->GetActiveCamera();
  camera->SetPosition(0.3, 2.2, 3.2);
  camera->SetFocalPoint(0.0, 0.1, 0.0);
  camera->SetViewAngle(36.0);
  picture.Renderer->ResetCameraClippingRange();
}

VTK_INDIRECT_IMAGE(EstimatorVirtualLights)
{
  images::AddRoom(picture);
}

VTK_INDIRECT_IMAGE(EstimatorNeighborhood)
{
  images::AddRoom(picture);
  picture.Gather->SetModeToNeighborhood();
}

VTK_INDIRECT_IMAGE(EstimatorInterpolationOff)
{
  images::AddRoom(picture);
  picture.Gather->InterpolationOff();
}

// Occlusion: the dark place is behind the sphere as seen from the spot's lit area.
VTK_INDIRECT_IMAGE(EstimatorOccupancy)
{
  images::AddRoom(picture);
  picture.Pass->SetVisibilityToVoxels();
}

VTK_INDIRECT_IMAGE(EstimatorGlossy)
{
  images::AddRoom(picture);
  MakeSpecular(picture);
  picture.Buffers.push_back({ "glossy", picture.Pass, "glossy" });
}

VTK_INDIRECT_IMAGE(EstimatorSplatting)
{
  images::AddRoom(picture);
  picture.Pass->SetEstimator(vtkNew<vtkIndirectSplattingPass>());
}

// As in the paper each splat ends at its bound: rims on the walls, and less light.
VTK_INDIRECT_IMAGE(EstimatorSplattingCutOff)
{
  images::AddRoom(picture);
  vtkNew<vtkIndirectSplattingPass> splatting;
  splatting->FarFieldOff();
  picture.Pass->SetEstimator(splatting);
}

// A metal ring under a slanting sun: splats of lobes make its caustic.
VTK_INDIRECT_IMAGE(EstimatorSplattingLobes)
{
  using namespace contract;
  picture.Renderer->AddActor(MakeQuad({ -1.5, 0, -1.5 }, { -1.5, 0, 1.5 }, { 1.5, 0, -1.5 }));
  vtkNew<vtkCylinderSource> source;
  source->SetRadius(0.6);
  source->SetHeight(0.4);
  source->SetCenter(0, 0.1913, 0); // a little into the ground
  source->SetResolution(96);
  source->CappingOff();
  vtkNew<vtkPolyDataNormals> normals;
  normals->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(normals->GetOutputPort());
  vtkNew<vtkActor> ring;
  ring->SetMapper(mapper);
  ring->GetProperty()->SetColor(0.95, 0.75, 0.4);
  ring->GetProperty()->SetInterpolationToPBR();
  ring->GetProperty()->SetMetallic(1.0);
  ring->GetProperty()->SetRoughness(0.25);
  picture.Renderer->AddActor(ring);
  picture.Renderer->AddLight(MakeLight(LightKind::Directional, { 1.0, 0.7, 0.05 }, { 0, 0, 0 }));
  vtkCamera* camera = picture.Renderer->GetActiveCamera();
  camera->SetPosition(0.11, 3.0, 1.9);
  camera->SetFocalPoint(0.0, 0.05, 0.1);
  camera->SetViewAngle(28);
  picture.Renderer->ResetCameraClippingRange();
  vtkNew<vtkLightTreeSampler> tree;
  tree->SetNumberOfLights(1024);
  picture.Pass->SetSampler(tree);
  picture.Pass->SetVisibilityToNone();
  picture.Pass->SetEstimator(vtkNew<vtkIndirectSplattingPass>());
}

VTK_INDIRECT_IMAGE(EstimatorMultiresolution)
{
  images::AddRoom(picture);
  picture.Pass->SetEstimator(vtkNew<vtkMultiresolutionSplattingPass>());
}

VTK_INDIRECT_IMAGE(EstimatorMultiresolutionGlossy)
{
  images::AddRoom(picture);
  MakeSpecular(picture);
  picture.Pass->SetEstimator(vtkNew<vtkMultiresolutionSplattingPass>());
  picture.Buffers.push_back({ "glossy", picture.Pass, "glossy" });
}

// With the paper's own criteria.
VTK_INDIRECT_IMAGE(EstimatorMultiresolutionPaper)
{
  images::AddRoom(picture);
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  splatting->SetPresetToPaper();
  picture.Pass->SetEstimator(splatting);
}

VTK_INDIRECT_IMAGE(EstimatorHints)
{
  images::AddRoom(picture);
  picture.Pass->SetEstimator(vtkNew<vtkRadianceHintsPass>());
}

// Brighter than EstimatorHints where light arrives after more than one bounce.
VTK_INDIRECT_IMAGE(EstimatorHintsBounces)
{
  images::AddRoom(picture);
  picture.Pass->SetEstimator(vtkNew<vtkRadianceHintsPass>());
  picture.Pass->SetNumberOfBounces(4);
}

VTK_INDIRECT_IMAGE(EstimatorReference)
{
  images::AddRoom(picture);
  vtkNew<vtkRSMReferencePass> reference;
  reference->SetModeToVirtualLights();
  picture.Pass->SetEstimator(reference);
}

VTK_INDIRECT_IMAGE(EstimatorAutomatic)
{
  images::AddRoom(picture);
  picture.Pass->SetEstimator(nullptr);
  picture.Pass->SetSampler(nullptr);
}

// An estimator set on the renderer by itself.
VTK_INDIRECT_IMAGE(EstimatorAsPass)
{
  images::AddRoom(picture);
  picture.Buffers.clear();
  picture.AddBuffers("", picture.Gather->GetIlluminationPass());
  picture.Gather->GetIlluminationPass()->AntialiasingOff();
  picture.Renderer->SetPass(picture.Gather);
}

// Lights of three bounces without maps. Brighter than EstimatorGather where light arrives after
// more than one bounce.
VTK_INDIRECT_IMAGE(SamplerRandomWalk)
{
  images::AddRoom(picture);
  vtkNew<vtkRandomWalkLightSampler> walk;
  picture.Pass->SetSampler(walk);
  picture.Pass->SetNumberOfBounces(3);
}

// Later bounces beside the lights of the maps.
VTK_INDIRECT_IMAGE(EstimatorBounces)
{
  images::AddRoom(picture);
  picture.Pass->SetEstimator(nullptr);
  picture.Pass->SetSampler(nullptr);
  picture.Pass->SetNumberOfBounces(16);
}

// So few lights that each is visible.
VTK_INDIRECT_IMAGE(SamplerUniformFew)
{
  images::AddRoom(picture);
  picture.Sampler->SetNumberOfLights(9);
}

VTK_INDIRECT_IMAGE(SamplerUniformGrid)
{
  images::AddRoom(picture);
  picture.Sampler->SetNumberOfLights(16);
  picture.Sampler->SetPatternToGrid();
}

VTK_INDIRECT_IMAGE(SamplerUniformJittered)
{
  images::AddRoom(picture);
  picture.Sampler->SetNumberOfLights(16);
  picture.Sampler->SetPatternToJittered();
}

// Samples spread over whole maps: some of the nine lights are lost.
VTK_INDIRECT_IMAGE(SamplerUniformWholeMaps)
{
  images::AddRoom(picture);
  picture.Sampler->SetNumberOfLights(9);
  picture.Sampler->LitTexelsOff();
}

VTK_INDIRECT_IMAGE(SamplerImportanceFew)
{
  images::AddRoom(picture);
  vtkNew<vtkImportanceLightSampler> sampler;
  sampler->SetNumberOfLights(9);
  picture.Pass->SetSampler(sampler);
}

VTK_INDIRECT_IMAGE(SamplerImportance)
{
  images::AddRoom(picture);
  picture.Pass->SetSampler(vtkNew<vtkImportanceLightSampler>());
}

VTK_INDIRECT_IMAGE(SamplerAutomatic)
{
  images::AddRoom(picture);
  picture.Pass->SetSampler(nullptr);
}

// A single headlight: virtual lights lie on visible surfaces.
VTK_INDIRECT_IMAGE(SamplerHeadlight)
{
  images::AddRoomSurfaces(picture);
  vtkNew<vtkLight> light;
  light->SetLightTypeToHeadlight();
  light->SetIntensity(0.6);
  picture.Renderer->AddLight(light);
}
