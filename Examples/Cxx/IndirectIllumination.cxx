// SPDX-License-Identifier: BSD-3-Clause
// A white room with a red and a green wall, lit by one spot light: what the light does not reach is
// lit by the walls. Writes a picture, and shows it where there is a display.
//
// usage: IndirectIllumination [picture.png]
#include "vtkIndirectIlluminationPass.h"
#ifdef HAVE_HEADLESS
#include "vtkIndirectHeadlessFactory.h"
#endif

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkWindowToImageFilter.h"

#include <cstdlib>
#include <iostream>

namespace
{
void AddSurface(vtkRenderer* renderer, vtkPolyDataAlgorithm* source, double r, double g, double b)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(r, g, b);
  renderer->AddActor(actor);
}

void AddWall(vtkRenderer* renderer, const double (&corners)[9], double r, double g, double b)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(corners[0], corners[1], corners[2]);
  plane->SetPoint1(corners[3], corners[4], corners[5]);
  plane->SetPoint2(corners[6], corners[7], corners[8]);
  AddSurface(renderer, plane, r, g, b);
}
}

int main(int argc, char* argv[])
{
  const char* path = argc > 1 ? argv[1] : "IndirectIllumination.png";

#ifdef HAVE_HEADLESS
  const char* display = std::getenv("DISPLAY");
  if (!display || !*display)
  {
    vtkIndirectHeadlessFactory::Enable();
  }
#endif

  // A room of 2 x 2 x 2, open to the front.
  vtkNew<vtkRenderer> renderer;
  AddWall(renderer, { -1, 0, 1, 1, 0, 1, -1, 0, -1 }, 0.8, 0.8, 0.8);   // floor
  AddWall(renderer, { -1, 2, -1, 1, 2, -1, -1, 2, 1 }, 0.8, 0.8, 0.8);  // ceiling
  AddWall(renderer, { -1, 0, -1, 1, 0, -1, -1, 2, -1 }, 0.8, 0.8, 0.8); // back
  AddWall(renderer, { -1, 0, 1, -1, 0, -1, -1, 2, 1 }, 0.8, 0.1, 0.1);  // left
  AddWall(renderer, { 1, 0, -1, 1, 0, 1, 1, 2, -1 }, 0.1, 0.7, 0.1);    // right
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(0.3, 0.4, -0.2);
  sphere->SetRadius(0.4);
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(32);
  AddSurface(renderer, sphere, 0.8, 0.8, 0.8);

  vtkNew<vtkLight> lamp;
  lamp->SetPositional(true);
  lamp->SetPosition(0.2, 1.9, 0.6);
  lamp->SetFocalPoint(-0.7, 0.0, -0.3);
  lamp->SetConeAngle(50);
  renderer->SetAutomaticLightCreation(false);
  renderer->AddLight(lamp);

  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetPosition(0, 1, 4.7);
  camera->SetFocalPoint(0, 1, 0);
  camera->SetViewAngle(35);

  // This is all it takes.
  vtkNew<vtkIndirectIlluminationPass> pass;
  renderer->SetPass(pass);

  vtkNew<vtkRenderWindow> window;
  window->SetSize(400, 400);
  window->SetMultiSamples(0);
  window->AddRenderer(renderer);
  window->Render();

  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(path);
  writer->Write();
  if (writer->GetErrorCode() != 0)
  {
    std::cerr << path << " cannot be written\n";
    return EXIT_FAILURE;
  }
  std::cout << "wrote " << path << "\n";

  // Returns at once where there is no display.
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  interactor->Start();
  return EXIT_SUCCESS;
}
