// SPDX-License-Identifier: BSD-3-Clause
// Programs' access to the window: through an interactor, and through the factory.
#include "HeadlessTestTools.h"

#include "vtkGenericRenderWindowInteractor.h"
#include "vtkIndirectHeadlessFactory.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkProperty.h"
#include "vtkTestingObjectFactory.h"

using namespace headlesstest;

namespace
{
//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Interactor)
{
  SceneWindow scene(Red);
  auto interactor =
    vtkSmartPointer<vtkRenderWindowInteractor>::Take(scene.Window->MakeRenderWindowInteractor());
  CHECK(interactor->IsA("vtkGenericRenderWindowInteractor"), interactor->GetClassName());
  CHECK(scene.Window->GetInteractor() == interactor, "");
  interactor->Initialize();
  interactor->Render();
  interactor->Start();
  CHECK_IMAGE(scene.Window, Red);
  interactor->UpdateSize(30, 20);
  interactor->Render();
  CHECK(scene.Window->GetSize()[0] == 30, scene.Window->GetSize()[0]);
  CHECK_IMAGE(scene.Window, Red);
  // Events come from the program.
  interactor->SetEventInformation(5, 5, 0, 0, 'w');
  interactor->InvokeEvent(vtkCommand::CharEvent);
  CHECK(scene.Actor->GetProperty()->GetRepresentation() == VTK_WIREFRAME, "");

  // The usual one on Linux needs X.
  vtkNew<vtkRenderWindowInteractor> onDisplay;
  if (onDisplay->IsA("vtkXRenderWindowInteractor"))
  {
    SceneWindow other(Green);
    ErrorCounter errors(other.Window);
    onDisplay->SetRenderWindow(other.Window);
    CHECK(errors.Count == 1, errors.Count);
    CHECK(other.Window->GetInteractor() == nullptr, "");
    other.Window->Render();
    CHECK_IMAGE(other.Window, Green);
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Factory)
{
  const auto windowClass = []()
  { return std::string(vtkSmartPointer<vtkRenderWindow>::New()->GetClassName()); };
  const auto interactorClass = []()
  { return std::string(vtkSmartPointer<vtkRenderWindowInteractor>::New()->GetClassName()); };
  const std::string window = windowClass();
  const std::string interactor = interactorClass();
  CHECK(window != "vtkEGLHeadlessRenderWindow", window);
  CHECK(!vtkIndirectHeadlessFactory::IsEnabled(), "");
  vtkIndirectHeadlessFactory::Disable();

  for (int i = 0; i < 3; ++i)
  {
    vtkIndirectHeadlessFactory::Enable();
    vtkIndirectHeadlessFactory::Enable();
    CHECK(vtkIndirectHeadlessFactory::IsEnabled(), "");
    CHECK(windowClass() == "vtkEGLHeadlessRenderWindow", windowClass());
    CHECK(interactorClass() == "vtkGenericRenderWindowInteractor", interactorClass());
    vtkIndirectHeadlessFactory::Disable();
    CHECK(!vtkIndirectHeadlessFactory::IsEnabled(), "");
    CHECK(windowClass() == window, windowClass());
    CHECK(interactorClass() == interactor, interactorClass());
  }

  // A typical program.
  vtkIndirectHeadlessFactory::Enable();
  {
    Scene scene(Red);
    vtkNew<vtkRenderWindow> plain;
    plain->SetSize(40, 30);
    plain->AddRenderer(scene.Renderer);
    vtkNew<vtkRenderWindowInteractor> iren;
    iren->SetRenderWindow(plain);
    iren->Initialize();
    iren->CreateRepeatingTimer(10);
    plain->Render();
    iren->Start();
    CHECK_IMAGE(plain, Red);
  }
  // VTK's test harness puts its interactor in place by first disabling all others.
  vtkNew<vtkTestingObjectFactory> testing;
  for (int i = 0; i < 2; ++i)
  {
    vtkObjectFactory::RegisterFactory(testing);
    if (i == 1)
    {
      vtkIndirectHeadlessFactory::Disable();
      vtkObjectFactoryCollection* factories = vtkObjectFactory::GetRegisteredFactories();
      factories->InitTraversal();
      while (vtkObjectFactory* factory = factories->GetNextItem())
      {
        if (factory != testing)
        {
          factory->Disable("vtkRenderWindowInteractor");
        }
      }
      vtkIndirectHeadlessFactory::Enable();
      CHECK(interactorClass() == "vtkTestingInteractor", interactorClass());
    }
    CHECK(windowClass() == "vtkEGLHeadlessRenderWindow", windowClass());
    vtkObjectFactory::UnRegisterFactory(testing);
  }
  vtkIndirectHeadlessFactory::Disable();
}
}
