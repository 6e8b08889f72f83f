// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLHeadlessRenderWindow.h"

#include "vtkEGLContext.h"
#include "vtkEGLDevice.h"
#include "vtkEGLLoader.h"
#include "vtkEGLPlatform.h"
#include "vtkEGLUtilities.h"
#include "vtkFloatArray.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"
#include "vtkRect.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <EGL/egl.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <vector>

//------------------------------------------------------------------------------
class vtkEGLHeadlessRenderWindow::vtkInternals
{
public:
  vtkEGLContext Context;
  std::vector<vtkEGLBinding> Stack;
  std::string ErrorMessage;
  std::string WarningMessage;
  // The device whose context could not be made, so that it is tried only once.
  bool Failed = false;
  int FailedDeviceIndex = -1;
  bool LostCurrent = false;

  bool HasContext() const { return this->Context.HasContext(); }
};

vtkStandardNewMacro(vtkEGLHeadlessRenderWindow);

//------------------------------------------------------------------------------
vtkEGLHeadlessRenderWindow::vtkEGLHeadlessRenderWindow()
  : Internals(new vtkInternals)
{
  this->DeviceIndex = -1;
  this->MultiSamples = 0;
  this->ShowWindow = false;
  this->UseOffScreenBuffers = true;
  // Without a window there is no blit: results stay in the display framebuffer.
  this->FrameBlitMode = NoBlit;
  this->ScreenSize[0] = 1920;
  this->ScreenSize[1] = 1080;
  this->ReadyForRendering = false;
}

//------------------------------------------------------------------------------
vtkEGLHeadlessRenderWindow::~vtkEGLHeadlessRenderWindow()
{
  this->Finalize();
  vtkCollectionSimpleIterator iterator;
  this->Renderers->InitTraversal(iterator);
  while (vtkRenderer* renderer = this->Renderers->GetNextRenderer(iterator))
  {
    renderer->SetRenderWindow(nullptr);
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DeviceIndex: " << this->DeviceIndex << "\n";
  os << indent << "Context: " << this->GetGenericContext() << "\n";
  os << indent << "PlatformName: " << this->GetPlatformName() << "\n";
  os << indent << "GLVersion: " << this->GetGLVersion() << "\n";
  os << indent << "GLRenderer: " << this->GetGLRenderer() << "\n";
  os << indent << "LastErrorMessage: " << this->GetLastErrorMessage() << "\n";
  os << indent << "LastWarningMessage: " << this->GetLastWarningMessage() << "\n";
}

//------------------------------------------------------------------------------
bool vtkEGLHeadlessRenderWindow::IsSupported()
{
  static const bool supported = []()
  {
    vtkEGLContext context;
    const bool works = context.Create(-1).empty();
    context.Destroy();
    return works;
  }();
  return supported;
}

//------------------------------------------------------------------------------
std::string vtkEGLHeadlessRenderWindow::GetLastErrorMessage()
{
  return this->Internals->ErrorMessage;
}

//------------------------------------------------------------------------------
std::string vtkEGLHeadlessRenderWindow::GetLastWarningMessage()
{
  return this->Internals->WarningMessage;
}

//------------------------------------------------------------------------------
std::string vtkEGLHeadlessRenderWindow::GetGLVersion()
{
  return this->Internals->Context.Version;
}

//------------------------------------------------------------------------------
std::string vtkEGLHeadlessRenderWindow::GetGLRenderer()
{
  return this->Internals->Context.Renderer;
}

//------------------------------------------------------------------------------
std::string vtkEGLHeadlessRenderWindow::GetPlatformName()
{
  return this->Internals->Context.PlatformName;
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::GetNumberOfDevices()
{
  return static_cast<int>(vtkEGLPlatform::ListDevices().size());
}

//------------------------------------------------------------------------------
std::string vtkEGLHeadlessRenderWindow::GetDeviceDescription(int index)
{
  const std::vector<vtkEGLDevice> devices = vtkEGLDevice::List();
  return index >= 0 && index < static_cast<int>(devices.size()) ? devices[index].Describe() : "";
}

//------------------------------------------------------------------------------
void* vtkEGLHeadlessRenderWindow::GetGenericContext()
{
  return this->Internals->Context.Context;
}

//------------------------------------------------------------------------------
bool vtkEGLHeadlessRenderWindow::EnsureContext()
{
  vtkInternals& internals = *this->Internals;
  if (internals.HasContext() && this->Initialized)
  {
    return true;
  }
  if (!internals.HasContext())
  {
    if (internals.Failed && internals.FailedDeviceIndex == this->DeviceIndex)
    {
      return false;
    }
    const std::string reason = internals.Context.Create(this->DeviceIndex);
    if (!reason.empty())
    {
      this->Fail(reason);
      return false;
    }
  }
  // VTK's own state belongs to the context, and ReleaseGraphicsResources() has released it as well.
  this->MakeCurrent();
  if (this->IsCurrent())
  {
    this->OpenGLInit();
  }
  if (!this->Initialized)
  {
    const std::string reason = internals.ErrorMessage.empty()
      ? "OpenGL cannot be initialized on " + this->GetPlatformName() + "."
      : internals.ErrorMessage;
    internals.Context.Destroy();
    this->Fail(reason);
    return false;
  }
  internals.ErrorMessage.clear();
  internals.Failed = false;
  this->ReadyForRendering = true;
  internals.WarningMessage = internals.Context.Warning;
  static std::atomic<bool> hasWarned(false);
  if (!internals.WarningMessage.empty() && !hasWarned.exchange(true))
  {
    vtkWarningMacro(<< internals.WarningMessage);
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::Fail(const std::string& reason)
{
  this->Internals->ErrorMessage = reason;
  this->Internals->Failed = true;
  this->Internals->FailedDeviceIndex = this->DeviceIndex;
  vtkErrorMacro(<< reason);
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::Initialize()
{
  if (this->EnsureContext())
  {
    this->MakeCurrent();
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::CreateAWindow()
{
  this->Initialize();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::Finalize()
{
  vtkInternals& internals = *this->Internals;
  internals.Failed = false;
  if (!internals.HasContext())
  {
    return;
  }
  const vtkEGLBinding previous = vtkEGLBinding::GetCurrent();
  this->ReleaseGraphicsResources(this);
  const bool restore = previous.HasContext() && previous.Context != internals.Context.Context;
  internals.Context.Destroy();
  internals.Stack.clear();
  this->ReadyForRendering = false;
  if (restore)
  {
    previous.MakeCurrent();
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::DestroyWindow()
{
  this->Finalize();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::MakeCurrent()
{
  vtkInternals& internals = *this->Internals;
  if (!internals.HasContext() || this->IsCurrent())
  {
    return;
  }
  const bool succeeded = internals.Context.MakeCurrent();
  if (!succeeded && !internals.LostCurrent)
  {
    vtkErrorMacro("The context cannot be made current: "
      << vtkEGLUtilities::GetErrorName(eglGetError())
      << ". If it is current in another thread, or an X window is current in this one, call "
         "ReleaseCurrent() there first.");
  }
  internals.LostCurrent = !succeeded;
}

//------------------------------------------------------------------------------
bool vtkEGLHeadlessRenderWindow::IsCurrent()
{
  return this->Internals->Context.IsCurrent();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::ReleaseCurrent()
{
  this->Internals->Context.ReleaseCurrent();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::PushContext()
{
  this->Internals->Stack.push_back(vtkEGLBinding::GetCurrent());
  this->MakeCurrent();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::PopContext()
{
  if (this->Internals->Stack.empty())
  {
    return;
  }
  const vtkEGLBinding previous = this->Internals->Stack.back();
  this->Internals->Stack.pop_back();
  if (previous.HasContext() && !previous.IsCurrent())
  {
    previous.MakeCurrent();
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::OpenGLInit()
{
  // The superclass works in another owner's context and leaves its state unchanged. This window
  // owns its context, so it sets VTK's state up once, as VTK's on-screen windows do.
  this->vtkOpenGLRenderWindow::OpenGLInit();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::OpenGLInitContext()
{
  if (this->Initialized)
  {
    return;
  }
#ifdef VTK_INDIRECT_USE_GLEW
  this->ContextCreationTime.Modified();
  const std::string reason = vtkEGLLoader::LoadGLEW();
  this->GlewInitValid = reason.empty();
  if (!this->GlewInitValid)
  {
    this->Internals->ErrorMessage = reason;
    return;
  }
  this->Initialized = true;
  this->MaximumHardwareLineWidth = vtkEGLLoader::GetMaximumLineWidth(this->LineSmoothing);
#else
  this->SetOpenGLSymbolLoader(
    [](void*, const char* name) -> VTKOpenGLAPIProc { return eglGetProcAddress(name); }, nullptr);
  this->Superclass::OpenGLInitContext();
#endif
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::Render()
{
  if (!this->EnsureContext())
  {
    return;
  }
  this->MakeCurrent();
  if (!this->IsCurrent())
  {
    return;
  }
  const int maximum = this->Internals->Context.MaximumSize;
  if (this->Size[0] > maximum || this->Size[1] > maximum)
  {
    vtkErrorMacro("A size of " << this->Size[0] << " x " << this->Size[1]
                               << " is more than this OpenGL can render, which is " << maximum
                               << "; it is reduced.");
    this->SetSize(std::min(this->Size[0], maximum), std::min(this->Size[1], maximum));
  }
  this->vtkOpenGLRenderWindow::Render();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::Start()
{
  if (this->EnsureContext())
  {
    this->Superclass::Start();
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::End()
{
  if (this->Internals->HasContext())
  {
    this->Superclass::End();
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::Frame()
{
  if (this->Internals->HasContext())
  {
    this->MakeCurrent();
    this->Superclass::Frame();
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::WaitForCompletion()
{
  if (this->Internals->HasContext())
  {
    this->MakeCurrent();
    this->Superclass::WaitForCompletion();
  }
}

//------------------------------------------------------------------------------
const char* vtkEGLHeadlessRenderWindow::ReportCapabilities()
{
  return this->EnsureContext() ? this->Superclass::ReportCapabilities()
                               : this->Internals->ErrorMessage.c_str();
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::SupportsOpenGL()
{
  if (this->Internals->HasContext() && this->Initialized)
  {
    return 1;
  }
  vtkEGLContext context;
  this->OpenGLSupportMessage = context.Create(this->DeviceIndex);
  context.Destroy();
  return this->OpenGLSupportMessage.empty() ? 1 : 0;
}

//------------------------------------------------------------------------------
vtkRenderWindowInteractor* vtkEGLHeadlessRenderWindow::MakeRenderWindowInteractor()
{
  vtkGenericRenderWindowInteractor* interactor = vtkGenericRenderWindowInteractor::New();
  interactor->SetRenderWindow(this);
  // As in the superclass, the caller owns the interactor.
  return interactor;
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  if (interactor && interactor->IsA("vtkXRenderWindowInteractor"))
  {
    vtkErrorMacro("A vtkXRenderWindowInteractor needs an X display and is not used. Call "
                  "MakeRenderWindowInteractor(), or vtkIndirectHeadlessFactory::Enable() before "
                  "the interactor is created.");
    return;
  }
  this->Superclass::SetInteractor(interactor);
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::ReadPixels(
  const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right)
{
  if (this->Internals->HasContext() && this->Initialized)
  {
    return this->Superclass::ReadPixels(rect, front, glFormat, glType, data, right);
  }
  // RGB or RGBA, bytes or floats: the formats that VTK's callers request.
  constexpr int rgba = 0x1908;
  constexpr int floats = 0x1406;
  const size_t components = glFormat == rgba ? 4 : 3;
  const size_t bytes = glType == floats ? sizeof(float) : 1;
  if (rect.GetWidth() > 0 && rect.GetHeight() > 0)
  {
    std::memset(data, 0, components * bytes * rect.GetWidth() * rect.GetHeight());
  }
  return VTK_ERROR;
}

//------------------------------------------------------------------------------
float* vtkEGLHeadlessRenderWindow::GetZbufferData(int x1, int y1, int x2, int y2)
{
  return this->Superclass::GetZbufferData(x1, y1, x2, y2);
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::GetZbufferData(
  int x1, int y1, int x2, int y2, vtkFloatArray* buffer)
{
  return this->Superclass::GetZbufferData(x1, y1, x2, y2, buffer);
}

//------------------------------------------------------------------------------
int vtkEGLHeadlessRenderWindow::GetZbufferData(int x1, int y1, int x2, int y2, float* z)
{
  if (this->Internals->HasContext() && this->Initialized)
  {
    return this->Superclass::GetZbufferData(x1, y1, x2, y2, z);
  }
  const size_t count =
    (static_cast<size_t>(std::abs(x2 - x1)) + 1) * (static_cast<size_t>(std::abs(y2 - y1)) + 1);
  std::fill_n(z, count, 1.0f);
  return VTK_ERROR;
}
