// SPDX-License-Identifier: BSD-3-Clause
// Drawing beside the opaque props: behind, in front, in several renderers.
#include "ImagePicture.h"

#include "vtkMultiresolutionSplattingPass.h"

#include "vtkActor2D.h"
#include "vtkActorCollection.h"
#include "vtkCellArray.h"
#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkSSAAPass.h"
#include "vtkTexture.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <algorithm>

using namespace contract;

namespace
{
void AddGlass(vtkRenderer* renderer, const Vec3& lower, const Vec3& upper, const Vec3& color)
{
  auto glass = MakeBox(lower, upper, color);
  glass->GetProperty()->SetOpacity(0.4);
  renderer->AddActor(glass);
}

// A rectangle in pixels.
void AddRectangle(vtkRenderer* renderer, double x, double y, double width, double height,
  const Vec3& color, double opacity)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(x, y, 0);
  points->InsertNextPoint(x + width, y, 0);
  points->InsertNextPoint(x + width, y + height, 0);
  points->InsertNextPoint(x, y + height, 0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 2, 3 });
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(data);
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->GetProperty()->SetOpacity(opacity);
  renderer->AddActor(actor);
}

void LookAtCourt(images::Picture& picture)
{
  images::AddCourt(picture.Renderer);
  images::AddSun(picture.Renderer);
}
}

VTK_INDIRECT_IMAGE(CompositionTranslucent)
{
  LookAtCourt(picture);
  AddGlass(picture.Renderer, { -0.3, 0, 0.3 }, { 0.4, 0.7, 1.0 }, { 0.3, 0.8, 0.6 });
}

// Two glasses, one in the other, with depth peeling: the inner one is visible through the outer.
VTK_INDIRECT_IMAGE(CompositionDepthPeeling)
{
  LookAtCourt(picture);
  AddGlass(picture.Renderer, { -0.6, 0, 0.2 }, { 0.5, 1.0, 1.2 }, { 0.3, 0.8, 0.6 });
  AddGlass(picture.Renderer, { -0.3, 0.1, 0.5 }, { 0.1, 0.6, 0.9 }, { 0.9, 0.2, 0.7 });
  picture.Renderer->UseDepthPeelingOn();
  picture.Renderer->SetMaximumNumberOfPeels(8);
  picture.Renderer->SetOcclusionRatio(0.0);
}

// A cloud around the box.
VTK_INDIRECT_IMAGE(CompositionVolume)
{
  // A warning about newer VTKs' own volume shader, which Mesa gives without a pass as well.
  AllowWarning("`g_dataPos' used uninitialized");
  LookAtCourt(picture);
  constexpr int n = 24;
  vtkNew<vtkImageData> data;
  data->SetDimensions(n, n, n);
  data->SetSpacing(0.06, 0.06, 0.06);
  data->SetOrigin(-1.3, 0.1, -0.6);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = static_cast<unsigned char*>(data->GetScalarPointer());
  for (int i = 0; i < n * n * n; ++i)
  {
    const double p[3] = { double(i % n), double(i / n % n), double(i / n / n) };
    double square = 0.0;
    for (double coordinate : p)
    {
      square += std::pow((2.0 * coordinate - (n - 1)) / (n - 1), 2);
    }
    values[i] = static_cast<unsigned char>(255.0 * std::max(0.0, 1.0 - square));
  }
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(data);
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.02f);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0, 0.2, 0.4, 1.0);
  color->AddRGBPoint(255, 0.9, 0.9, 0.3);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0, 0);
  opacity->AddPoint(255, 0.3);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.06);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  picture.Renderer->AddVolume(volume);
}

// Two rectangles in pixels, one of them half transparent.
VTK_INDIRECT_IMAGE(CompositionOverlay)
{
  LookAtCourt(picture);
  AddRectangle(picture.Renderer, 10, 10, 60, 20, { 1, 1, 0 }, 1.0);
  AddRectangle(picture.Renderer, 90, 70, 50, 40, { 0, 0, 0 }, 0.5);
}

VTK_INDIRECT_IMAGE(CompositionGradient)
{
  LookAtCourt(picture);
  picture.Renderer->GetActiveCamera()->Zoom(0.6);
  picture.Renderer->SetBackground(0.1, 0.1, 0.2);
  picture.Renderer->SetBackground2(0.5, 0.6, 0.8);
  picture.Renderer->GradientBackgroundOn();
}

VTK_INDIRECT_IMAGE(CompositionTexturedBackground)
{
  LookAtCourt(picture);
  picture.Renderer->GetActiveCamera()->Zoom(0.6);
  vtkNew<vtkImageData> image;
  image->SetDimensions(8, 6, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 6; ++y)
  {
    for (int x = 0; x < 8; ++x)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      pixel[0] = static_cast<unsigned char>(30 * x);
      pixel[1] = (x + y) % 2 ? 120 : 60;
      pixel[2] = static_cast<unsigned char>(40 * y);
    }
  }
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOff();
  picture.Renderer->SetBackgroundTexture(texture);
  picture.Renderer->TexturedBackgroundOn();
}

// A second layer with its own pass in front of the first one's picture.
VTK_INDIRECT_IMAGE(CompositionLayers)
{
  LookAtCourt(picture);
  vtkNew<vtkRenderer> above;
  above->SetLayer(1);
  above->AddActor(MakeQuad({ -0.8, -0.5, 0 }, { -0.8, -0.5, 0.6 }, { 0, -0.5, 0 }));
  above->AddActor(MakeSphere({ -0.4, -0.25, 0.3 }, 0.25, { 0.2, 0.8, 0.3 }));
  above->AddLight(MakeLight(LightKind::Directional, { -1, 2, 1 }, { 0, 0, 0 }));
  above->GetActiveCamera()->SetPosition(0.35, 0.5, 3.2);
  above->GetActiveCamera()->SetFocalPoint(0.35, 0.1, 0);
  above->ResetCameraClippingRange();
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetEstimator(vtkNew<vtkRSMGatherPass>());
  pass->AntialiasingOff();
  above->SetPass(pass);
  picture.Window->SetNumberOfLayers(2);
  picture.Window->AddRenderer(above);
  picture.AddBuffers("above.", pass);
}

// The same court by two estimators, side by side, and a renderer with only a background above the
// right one: pixels outside of all renderers are undefined.
VTK_INDIRECT_IMAGE(CompositionViewports)
{
  LookAtCourt(picture);
  // In a small viewport blocks have few pixels, and a single silhouette pixel counts too much.
  picture.Window->SetSize(256, 192);
  picture.Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  picture.Renderer->SetBackground(0.3, 0.1, 0.1);
  vtkNew<vtkRenderer> right;
  images::AddCourt(right);
  images::AddSun(right);
  right->GetActiveCamera()->Azimuth(20);
  right->SetViewport(0.5, 0.0, 1.0, 0.7);
  right->SetBackground(0.1, 0.1, 0.3);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetEstimator(vtkNew<vtkMultiresolutionSplattingPass>());
  pass->SetSampler(vtkNew<vtkUniformLightSampler>());
  pass->AntialiasingOff();
  right->SetPass(pass);
  picture.Window->AddRenderer(right);
  vtkNew<vtkRenderer> empty;
  empty->SetViewport(0.5, 0.7, 1.0, 1.0);
  empty->SetBackground(0.1, 0.3, 0.1);
  picture.Window->AddRenderer(empty);
  picture.AddBuffers("right.", pass);
}

// Silhouettes, shadows and steps of the light, against a gradient.
VTK_INDIRECT_IMAGE(CompositionAntialiasing)
{
  LookAtCourt(picture);
  picture.Renderer->GetActiveCamera()->Zoom(0.6);
  picture.Renderer->GetActiveCamera()->Roll(7);
  picture.Renderer->SetBackground(0.1, 0.1, 0.2);
  picture.Renderer->SetBackground2(0.5, 0.6, 0.8);
  picture.Renderer->GradientBackgroundOn();
  picture.Pass->AntialiasingOn();
}

VTK_INDIRECT_IMAGE(CompositionFXAA)
{
  LookAtCourt(picture);
  picture.Renderer->UseFXAAOn();
}

// A pass around this pass, which makes it draw a larger picture.
VTK_INDIRECT_IMAGE(CompositionSSAA)
{
  LookAtCourt(picture);
  vtkNew<vtkSSAAPass> outer;
  outer->SetDelegatePass(picture.Pass);
  picture.Renderer->SetPass(outer);
}

// Shadows without indirect light are black.
VTK_INDIRECT_IMAGE(CompositionScaleZero)
{
  LookAtCourt(picture);
  picture.Pass->SetIndirectScale(0.0);
  picture.Buffers = { { "final", picture.Pass, "final" } };
}

VTK_INDIRECT_IMAGE(CompositionShadowsOff)
{
  LookAtCourt(picture);
  picture.Pass->ShadowsOff();
}

// Neither shadows nor indirect light: VTK's own picture.
VTK_INDIRECT_IMAGE(CompositionDelegateAlone)
{
  LookAtCourt(picture);
  picture.Pass->SetIndirectScale(0.0);
  picture.Pass->ShadowsOff();
  picture.Buffers.clear();
}

// The box casts no shadow and sends no light, the sphere casts one and sends none.
VTK_INDIRECT_IMAGE(CompositionPropertyKeys)
{
  LookAtCourt(picture);
  vtkActorCollection* actors = picture.Renderer->GetActors();
  vtkNew<vtkInformation> box;
  box->Set(vtkIndirectIlluminationPass::CASTS_SHADOWS(), 0);
  vtkActor::SafeDownCast(actors->GetItemAsObject(3))->SetPropertyKeys(box);
  vtkNew<vtkInformation> sphere;
  sphere->Set(vtkIndirectIlluminationPass::SENDS_LIGHT(), 0);
  vtkActor::SafeDownCast(actors->GetItemAsObject(4))->SetPropertyKeys(sphere);
}
