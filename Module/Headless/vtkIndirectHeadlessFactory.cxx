// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectHeadlessFactory.h"

#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkNew.h"
#include "vtkObjectFactoryCollection.h"
#include "vtkVersion.h"

#include <cstring>

vtkStandardNewMacro(vtkIndirectHeadlessFactory);

VTK_CREATE_CREATE_FUNCTION(vtkEGLHeadlessRenderWindow);
VTK_CREATE_CREATE_FUNCTION(vtkGenericRenderWindowInteractor);

namespace
{
vtkIndirectHeadlessFactory* FindRegistered()
{
  vtkCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  for (int i = 0; i < factories->GetNumberOfItems(); ++i)
  {
    auto factory = vtkIndirectHeadlessFactory::SafeDownCast(factories->GetItemAsObject(i));
    if (factory)
    {
      return factory;
    }
  }
  return nullptr;
}
}

//------------------------------------------------------------------------------
vtkIndirectHeadlessFactory::vtkIndirectHeadlessFactory()
{
  this->RegisterOverride("vtkRenderWindow", "vtkEGLHeadlessRenderWindow",
    "Render window without a display", 1, vtkObjectFactoryCreatevtkEGLHeadlessRenderWindow);
  this->RegisterOverride("vtkRenderWindowInteractor", "vtkGenericRenderWindowInteractor",
    "Interactor without a display", 1, vtkObjectFactoryCreatevtkGenericRenderWindowInteractor);
}

//------------------------------------------------------------------------------
void vtkIndirectHeadlessFactory::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Enabled: " << (vtkIndirectHeadlessFactory::IsEnabled() ? "On\n" : "Off\n");
}

//------------------------------------------------------------------------------
void vtkIndirectHeadlessFactory::Enable()
{
  if (FindRegistered())
  {
    return;
  }
  vtkNew<vtkIndirectHeadlessFactory> factory;
  vtkObjectFactory::RegisterFactory(factory);
  // The first factory that makes a class wins, and VTK's own have come first.
  vtkCollection* factories = vtkObjectFactory::GetRegisteredFactories();
  if (factories->GetNumberOfItems() > 1)
  {
    factories->RemoveItem(factory);
    factories->InsertItem(-1, factory);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectHeadlessFactory::Disable()
{
  vtkIndirectHeadlessFactory* factory = FindRegistered();
  if (factory)
  {
    vtkObjectFactory::UnRegisterFactory(factory);
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectHeadlessFactory::IsEnabled()
{
  return FindRegistered() != nullptr;
}

//------------------------------------------------------------------------------
vtkObject* vtkIndirectHeadlessFactory::CreateObject(const char* className)
{
  // A testing interactor needs no display either: leave it to its own factory.
  if (std::strcmp(className, "vtkRenderWindowInteractor") == 0)
  {
    vtkCollection* factories = vtkObjectFactory::GetRegisteredFactories();
    for (int i = 0; i < factories->GetNumberOfItems(); ++i)
    {
      auto factory = static_cast<vtkObjectFactory*>(factories->GetItemAsObject(i));
      if (factory->HasOverride(className, "vtkTestingInteractor") &&
        factory->GetEnableFlag(className, "vtkTestingInteractor"))
      {
        return nullptr;
      }
    }
  }
  return this->Superclass::CreateObject(className);
}

//------------------------------------------------------------------------------
const char* vtkIndirectHeadlessFactory::GetVTKSourceVersion()
{
  return VTK_SOURCE_VERSION;
}

//------------------------------------------------------------------------------
const char* vtkIndirectHeadlessFactory::GetDescription()
{
  return "Render windows and interactors that need no display";
}
