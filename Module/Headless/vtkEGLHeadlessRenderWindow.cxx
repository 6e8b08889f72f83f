// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLHeadlessRenderWindow.h"

#if !__has_include("vtk_glad.h")
// Before VTK 9.4 OpenGL's functions come from GLEW.
#define VTK_INDIRECT_USE_GLEW
#include "vtk_glew.h"
#endif

#include "vtkFloatArray.h"
#include "vtkGenericRenderWindowInteractor.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLState.h"
#include "vtkRect.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>
#include <sstream>
#include <vector>

// Not in the headers of every EGL.
#ifndef EGL_PLATFORM_DEVICE_EXT
#define EGL_PLATFORM_DEVICE_EXT 0x313F
#endif
#ifndef EGL_PLATFORM_SURFACELESS_MESA
#define EGL_PLATFORM_SURFACELESS_MESA 0x31DD
#endif

namespace
{
// What is needed of OpenGL before VTK has loaded it.
constexpr unsigned int GLRendererName = 0x1F01;
constexpr unsigned int GLVersionName = 0x1F02;
constexpr unsigned int GLMajorVersion = 0x821B;
constexpr unsigned int GLMinorVersion = 0x821C;
constexpr unsigned int GLMaxTextureSize = 0x0D33;
constexpr unsigned int GLSmoothLineWidthRange = 0x0B22;
constexpr unsigned int GLAliasedLineWidthRange = 0x846E;

using GetStringFunction = const unsigned char* (*)(unsigned int);
using GetIntegerFunction = void (*)(unsigned int, int*);
using GetFloatFunction = void (*)(unsigned int, float*);

std::string GetGLString(unsigned int name)
{
  auto function = reinterpret_cast<GetStringFunction>(eglGetProcAddress("glGetString"));
  const unsigned char* text = function ? function(name) : nullptr;
  return text ? reinterpret_cast<const char*>(text) : "";
}

int GetGLInteger(unsigned int name)
{
  auto function = reinterpret_cast<GetIntegerFunction>(eglGetProcAddress("glGetIntegerv"));
  int value = 0;
  if (function)
  {
    function(name, &value);
  }
  return value;
}

#ifdef VTK_INDIRECT_USE_GLEW
// The upper end of a range.
float GetGLMaximum(unsigned int name)
{
  auto function = reinterpret_cast<GetFloatFunction>(eglGetProcAddress("glGetFloatv"));
  float range[2] = { 1.0f, 1.0f };
  if (function)
  {
    function(name, range);
  }
  return range[1];
}
#endif

std::string GetEGLErrorName(EGLint error)
{
  switch (error)
  {
    case EGL_NOT_INITIALIZED:
      return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS:
      return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC:
      return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE:
      return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG:
      return "EGL_BAD_CONFIG";
    case EGL_BAD_CONTEXT:
      return "EGL_BAD_CONTEXT";
    case EGL_BAD_DISPLAY:
      return "EGL_BAD_DISPLAY";
    case EGL_BAD_MATCH:
      return "EGL_BAD_MATCH";
    case EGL_BAD_PARAMETER:
      return "EGL_BAD_PARAMETER";
    case EGL_CONTEXT_LOST:
      return "EGL_CONTEXT_LOST";
    default:
    {
      std::ostringstream name;
      name << "EGL error 0x" << std::hex << error;
      return name.str();
    }
  }
}

bool HasExtension(const char* extensions, const std::string& name)
{
  std::istringstream words(extensions ? extensions : "");
  std::string word;
  while (words >> word)
  {
    if (word == name)
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// EGL displays are shared: asking twice for one gives the same handle, and terminating it ends it
// for everybody. So users are counted, over all windows and threads, and a display that somebody
// else had initialized is never terminated. Never deleted, because windows may be destroyed as late
// as static objects are.
struct DisplayUsers
{
  struct Entry
  {
    int Count = 0;
    bool IsForeign = false;
  };
  std::mutex Mutex;
  std::map<EGLDisplay, Entry> Entries;
};

DisplayUsers& GetDisplayUsers()
{
  static auto* users = new DisplayUsers;
  return *users;
}

bool AcquireDisplay(EGLDisplay display)
{
  DisplayUsers& users = GetDisplayUsers();
  std::lock_guard<std::mutex> lock(users.Mutex);
  DisplayUsers::Entry& entry = users.Entries[display];
  if (entry.Count == 0)
  {
    entry.IsForeign = eglQueryString(display, EGL_VERSION) != nullptr;
    if (!eglInitialize(display, nullptr, nullptr))
    {
      return false;
    }
  }
  ++entry.Count;
  return true;
}

void ReleaseDisplay(EGLDisplay display)
{
  DisplayUsers& users = GetDisplayUsers();
  std::lock_guard<std::mutex> lock(users.Mutex);
  DisplayUsers::Entry& entry = users.Entries[display];
  if (--entry.Count == 0 && !entry.IsForeign)
  {
    eglTerminate(display);
  }
}

//------------------------------------------------------------------------------
// A place where a context may come from. Handle is an EGLDeviceEXT where there is one.
struct Platform
{
  std::string Name;
  EGLenum Type = EGL_NONE;
  void* Handle = nullptr;
  bool IsSoftware = false;
  // Whether a driver that falls back to software is of no use here.
  bool MustBeHardware = false;
};

std::vector<Platform> ListDevices()
{
  std::vector<Platform> platforms;
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const bool canList = HasExtension(extensions, "EGL_EXT_device_base") ||
    HasExtension(extensions, "EGL_EXT_device_enumeration");
  if (!canList || !HasExtension(extensions, "EGL_EXT_platform_device"))
  {
    return platforms;
  }
  auto queryDevices =
    reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  auto queryDeviceString =
    reinterpret_cast<PFNEGLQUERYDEVICESTRINGEXTPROC>(eglGetProcAddress("eglQueryDeviceStringEXT"));
  EGLint count = 0;
  if (!queryDevices || !queryDevices(0, nullptr, &count) || count <= 0)
  {
    return platforms;
  }
  std::vector<EGLDeviceEXT> devices(count);
  if (!queryDevices(count, devices.data(), &count))
  {
    return platforms;
  }
  for (EGLint i = 0; i < count; ++i)
  {
    Platform platform;
    platform.Name = "EGL device " + std::to_string(i);
    platform.Type = EGL_PLATFORM_DEVICE_EXT;
    platform.Handle = devices[i];
    platform.IsSoftware = queryDeviceString &&
      HasExtension(queryDeviceString(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
    platforms.push_back(platform);
  }
  return platforms;
}

// All platforms in the order in which they are tried, or the one that was asked for.
std::vector<Platform> ListPlatforms(int deviceIndex)
{
  std::vector<Platform> devices = ListDevices();
  std::vector<Platform> platforms;
  if (deviceIndex >= 0)
  {
    if (deviceIndex < static_cast<int>(devices.size()))
    {
      platforms.push_back(devices[deviceIndex]);
    }
    return platforms;
  }
  for (Platform device : devices)
  {
    if (!device.IsSoftware)
    {
      device.MustBeHardware = true;
      platforms.push_back(device);
    }
  }
  if (HasExtension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless"))
  {
    Platform surfaceless;
    surfaceless.Name = "EGL surfaceless platform";
    surfaceless.Type = EGL_PLATFORM_SURFACELESS_MESA;
    platforms.push_back(surfaceless);
  }
  std::copy_if(devices.begin(), devices.end(), std::back_inserter(platforms),
    [](const Platform& device) { return device.IsSoftware; });
  Platform fallback;
  fallback.Name = "EGL default display";
  platforms.push_back(fallback);
  return platforms;
}

EGLDisplay GetDisplay(const Platform& platform)
{
  if (platform.Type == EGL_NONE)
  {
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
  }
  auto getPlatformDisplay = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
    eglGetProcAddress("eglGetPlatformDisplayEXT"));
  return getPlatformDisplay ? getPlatformDisplay(platform.Type, platform.Handle, nullptr)
                            : EGL_NO_DISPLAY;
}

//------------------------------------------------------------------------------
// Which context is current in a thread, to come back to.
struct Binding
{
  EGLDisplay Display = EGL_NO_DISPLAY;
  EGLSurface Draw = EGL_NO_SURFACE;
  EGLSurface Read = EGL_NO_SURFACE;
  EGLContext Context = EGL_NO_CONTEXT;

  // EGL keeps a current context for each of OpenGL and OpenGL ES; another library may have
  // switched.
  static Binding GetCurrent()
  {
    eglBindAPI(EGL_OPENGL_API);
    Binding binding;
    binding.Context = eglGetCurrentContext();
    if (binding.Context != EGL_NO_CONTEXT)
    {
      binding.Display = eglGetCurrentDisplay();
      binding.Draw = eglGetCurrentSurface(EGL_DRAW);
      binding.Read = eglGetCurrentSurface(EGL_READ);
    }
    return binding;
  }

  bool MakeCurrent() const
  {
    eglBindAPI(EGL_OPENGL_API);
    return eglMakeCurrent(this->Display, this->Draw, this->Read, this->Context) == EGL_TRUE;
  }
};

//------------------------------------------------------------------------------
// No platform is any better then.
const char* const BlockedReason =
  "Another OpenGL context, such as that of an X window, is current in "
  "this thread. Call ReleaseCurrent() on its window first.";

// A context with all that it needs, on one platform.
struct HeadlessContext : Binding
{
  std::string PlatformName;
  std::string Version;
  std::string Renderer;
  int MaximumSize = 0;

  // Make a context that renders. On failure nothing is left behind and the reason is returned,
  // otherwise an empty string.
  std::string Create(const Platform& platform)
  {
    this->Display = GetDisplay(platform);
    if (this->Display == EGL_NO_DISPLAY)
    {
      return "no EGL display";
    }
    if (!AcquireDisplay(this->Display))
    {
      std::string reason = "eglInitialize: " + GetEGLErrorName(eglGetError());
      *this = HeadlessContext();
      return reason;
    }
    const Binding previous = GetCurrent();
    std::string reason = this->CreateOnDisplay();
    if (reason.empty())
    {
      if (!this->MakeCurrent())
      {
        const EGLint error = eglGetError();
        reason =
          error == EGL_BAD_ACCESS ? BlockedReason : "eglMakeCurrent: " + GetEGLErrorName(error);
      }
      else
      {
        reason = this->Examine(platform);
        if (previous.Context != EGL_NO_CONTEXT)
        {
          previous.MakeCurrent();
        }
      }
    }
    if (!reason.empty())
    {
      this->Destroy();
    }
    return reason;
  }

  void Destroy()
  {
    if (this->Display == EGL_NO_DISPLAY)
    {
      return;
    }
    if (this->Context != EGL_NO_CONTEXT)
    {
      if (GetCurrent().Context == this->Context)
      {
        eglMakeCurrent(this->Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
      }
      eglDestroyContext(this->Display, this->Context);
    }
    if (this->Draw != EGL_NO_SURFACE)
    {
      eglDestroySurface(this->Display, this->Draw);
    }
    ReleaseDisplay(this->Display);
    *this = HeadlessContext();
  }

private:
  std::string CreateOnDisplay()
  {
    if (!eglBindAPI(EGL_OPENGL_API))
    {
      return "it offers OpenGL ES only";
    }
    // The smallest pixel buffer goes with the context. VTK draws into framebuffers of its own, but
    // queries the default one, which is incomplete without a surface.
    const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE,
      EGL_OPENGL_BIT, EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_ALPHA_SIZE, 8,
      EGL_DEPTH_SIZE, 24, EGL_NONE };
    const EGLint surfaceless[] = { EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE,
      EGL_OPENGL_BIT, EGL_NONE };
    EGLConfig config = nullptr;
    EGLint count = 0;
    const bool hasSurface =
      eglChooseConfig(this->Display, wanted, &config, 1, &count) == EGL_TRUE && count > 0;
    if (!hasSurface)
    {
      if (!HasExtension(
            eglQueryString(this->Display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
      {
        return "neither pixel buffers nor contexts without a surface";
      }
      if (!eglChooseConfig(this->Display, surfaceless, &config, 1, &count) || count == 0)
      {
        return "no configuration for OpenGL";
      }
    }

    const int versions[][2] = { { 4, 6 }, { 4, 5 }, { 4, 4 }, { 4, 3 }, { 4, 2 }, { 4, 1 },
      { 4, 0 }, { 3, 3 }, { 3, 2 } };
    for (const auto& version : versions)
    {
      const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION_KHR, version[0],
        EGL_CONTEXT_MINOR_VERSION_KHR, version[1], EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR, EGL_NONE };
      this->Context = eglCreateContext(this->Display, config, EGL_NO_CONTEXT, attributes);
      if (this->Context != EGL_NO_CONTEXT)
      {
        break;
      }
    }
    if (this->Context == EGL_NO_CONTEXT)
    {
      return "no core profile of OpenGL 3.2 or later: " + GetEGLErrorName(eglGetError());
    }
    if (hasSurface)
    {
      const EGLint size[] = { EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE };
      this->Draw = this->Read = eglCreatePbufferSurface(this->Display, config, size);
      if (this->Draw == EGL_NO_SURFACE)
      {
        return "eglCreatePbufferSurface: " + GetEGLErrorName(eglGetError());
      }
    }
    return "";
  }

  // What the context, which is current, says of itself.
  std::string Examine(const Platform& platform)
  {
    this->PlatformName = platform.Name;
    this->Version = GetGLString(GLVersionName);
    this->Renderer = GetGLString(GLRendererName);
    this->MaximumSize = GetGLInteger(GLMaxTextureSize);
    const int version = 10 * GetGLInteger(GLMajorVersion) + GetGLInteger(GLMinorVersion);
    if (version < 32)
    {
      return "OpenGL \"" + this->Version + "\" is older than 3.2";
    }
    // A driver for a device that cannot render may fall back to software. The surfaceless platform
    // comes to the same, and is next.
    const bool inSoftware = this->Renderer.find("llvmpipe") != std::string::npos ||
      this->Renderer.find("softpipe") != std::string::npos;
    if (inSoftware && platform.MustBeHardware)
    {
      return "it renders in software (" + this->Renderer + ")";
    }
    return "";
  }
};

// The first platform that works, or the reasons why none does.
std::string CreateContext(int deviceIndex, HeadlessContext& context)
{
  std::ostringstream tried;
  const std::vector<Platform> platforms = ListPlatforms(deviceIndex);
  for (const Platform& platform : platforms)
  {
    const std::string reason = context.Create(platform);
    if (reason.empty())
    {
      return "";
    }
    if (reason == BlockedReason)
    {
      return reason;
    }
    tried << (tried.str().empty() ? "" : "; ") << platform.Name << " (" << reason << ")";
  }
  if (platforms.empty())
  {
    return "There is no EGL device " + std::to_string(deviceIndex) +
      ": the number of EGL devices, counted from 0, is " + std::to_string(ListDevices().size()) +
      ".";
  }
  return "No OpenGL 3.2 core context can be made without a display. Tried: " + tried.str() +
    ". Install an EGL driver: that of the GPU's vendor, or Mesa for rendering in software "
    "(Debian: libegl1 libgl1-mesa-dri).";
}
}

//------------------------------------------------------------------------------
class vtkEGLHeadlessRenderWindow::vtkInternals
{
public:
  HeadlessContext Context;
  std::vector<Binding> Stack;
  std::string ErrorMessage;
  // The device for which making a context has failed, so that it fails only once.
  bool Failed = false;
  int FailedDeviceIndex = -1;
  bool LostCurrent = false;

  bool HasContext() const { return this->Context.Context != EGL_NO_CONTEXT; }
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
  // There is nothing to blit to: results stay in the display framebuffer.
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
}

//------------------------------------------------------------------------------
bool vtkEGLHeadlessRenderWindow::IsSupported()
{
  static const bool supported = []()
  {
    HeadlessContext context;
    const bool works = CreateContext(-1, context).empty();
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
  return static_cast<int>(ListDevices().size());
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
    const std::string reason = CreateContext(this->DeviceIndex, internals.Context);
    if (!reason.empty())
    {
      this->Fail(reason);
      return false;
    }
  }
  // VTK's own state belongs to the context, and is gone too after ReleaseGraphicsResources().
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
  Binding previous = Binding::GetCurrent();
  this->ReleaseGraphicsResources(this);
  const bool restore =
    previous.Context != EGL_NO_CONTEXT && previous.Context != internals.Context.Context;
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
      << GetEGLErrorName(eglGetError())
      << ". If it is current in another thread, or an X window is current in this one, call "
         "ReleaseCurrent() there first.");
  }
  internals.LostCurrent = !succeeded;
}

//------------------------------------------------------------------------------
bool vtkEGLHeadlessRenderWindow::IsCurrent()
{
  return this->Internals->HasContext() &&
    Binding::GetCurrent().Context == this->Internals->Context.Context;
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::ReleaseCurrent()
{
  if (this->IsCurrent())
  {
    eglMakeCurrent(
      this->Internals->Context.Display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::PushContext()
{
  this->Internals->Stack.push_back(Binding::GetCurrent());
  this->MakeCurrent();
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::PopContext()
{
  if (this->Internals->Stack.empty())
  {
    return;
  }
  const Binding previous = this->Internals->Stack.back();
  this->Internals->Stack.pop_back();
  if (previous.Context != EGL_NO_CONTEXT && previous.Context != Binding::GetCurrent().Context)
  {
    previous.MakeCurrent();
  }
}

//------------------------------------------------------------------------------
void vtkEGLHeadlessRenderWindow::OpenGLInit()
{
  // The superclass works in a context of somebody else and leaves it as it was. This one is ours,
  // so VTK's state is set up once, as in VTK's on-screen windows.
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
  GLenum result = glewInit();
#ifdef GLEW_ERROR_NO_GLX_DISPLAY
  // A GLEW made for GLX loads all of OpenGL, then fails to find a GLX display and says so.
  if (result == GLEW_ERROR_NO_GLX_DISPLAY)
  {
    result = GLEW_OK;
  }
#endif
  this->GlewInitValid = result == GLEW_OK;
  if (!this->GlewInitValid)
  {
    this->Internals->ErrorMessage = std::string("GLEW cannot be initialized: ") +
      reinterpret_cast<const char*>(glewGetErrorString(result));
    return;
  }
  this->Initialized = true;
  this->MaximumHardwareLineWidth =
    GetGLMaximum(this->LineSmoothing ? GLSmoothLineWidthRange : GLAliasedLineWidthRange);
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
  HeadlessContext context;
  this->OpenGLSupportMessage = CreateContext(this->DeviceIndex, context);
  context.Destroy();
  return this->OpenGLSupportMessage.empty() ? 1 : 0;
}

//------------------------------------------------------------------------------
vtkRenderWindowInteractor* vtkEGLHeadlessRenderWindow::MakeRenderWindowInteractor()
{
  vtkGenericRenderWindowInteractor* interactor = vtkGenericRenderWindowInteractor::New();
  interactor->SetRenderWindow(this);
  // As in the superclass, the caller owns what is made here.
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
  // RGB or RGBA, bytes or floats: what the callers in VTK ask for.
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
