// SPDX-License-Identifier: BSD-3-Clause
// A vendor's library for EGL with simulated devices, for tests of machines that are not at hand.
// libEGL loads it as a driver. It forwards rendering to Mesa, and answers queries of devices and
// displays itself.
//
// Environment:
//   FAKE_EGL_DEVICES      the devices, separated by ";", each "kind|render node|name|vendor|CUDA
//                         number", optional except for the kind. Kinds: "works", "mute" (no
//                         display), "broken" (no initialization), "contextless", "fallback" (it
//                         renders in software), "software".
//   FAKE_EGL_ENUMERATION  "missing": no extension lists devices; "failing": the function fails.
//   FAKE_EGL_PLATFORMS    "none": neither the surfaceless platform nor the default display exists.
#include <glvnd/libeglabi.h>

#include <dlfcn.h>

#include <cstdlib>
#include <cstring>
#include <deque>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace
{
constexpr EGLint DrmRenderNodeFile = 0x3377;
constexpr EGLint RendererName = 0x335F;
constexpr EGLint CudaDevice = 0x323A;
constexpr EGLenum SurfacelessPlatform = 0x31DD;
constexpr EGLenum DevicePlatform = 0x313F;
constexpr unsigned int GLRenderer = 0x1F01;

const __EGLapiExports* Exports = nullptr;
__EGLapiImports Mesa;
thread_local EGLint PendingError = EGL_SUCCESS;

// A device, which is also its display.
struct Device
{
  std::string Kind;
  std::string RenderNode;
  std::string Name;
  std::string Vendor;
  std::string Cuda;
  std::string Extensions;
  std::string GLName;
};
// Elements of a deque keep their addresses, which are handles.
std::deque<Device> Devices;
Device Surfaceless;

//------------------------------------------------------------------------------
std::string GetSetting(const char* name)
{
  const char* value = std::getenv(name);
  return value ? value : "";
}

//------------------------------------------------------------------------------
void ReadDevices()
{
  const std::string software = "llvmpipe (LLVM 15.0.6, 256 bits)";
  std::istringstream list(GetSetting("FAKE_EGL_DEVICES"));
  std::string entry;
  while (std::getline(list, entry, ';'))
  {
    Device device;
    std::istringstream fields(entry);
    for (std::string* field :
      { &device.Kind, &device.RenderNode, &device.Name, &device.Vendor, &device.Cuda })
    {
      std::getline(fields, *field, '|');
    }
    device.Extensions =
      device.Kind == "software" ? "EGL_MESA_device_software" : "EGL_EXT_device_drm";
    device.Extensions += device.RenderNode.empty() ? "" : " EGL_EXT_device_drm_render_node";
    device.Extensions += device.Name.empty() ? "" : " EGL_EXT_device_query_name";
    device.Extensions += device.Cuda.empty() ? "" : " EGL_NV_device_cuda";
    const bool inSoftware = device.Kind == "software" || device.Kind == "fallback";
    device.GLName = inSoftware ? software : "Fake GPU " + std::to_string(Devices.size());
    Devices.push_back(device);
  }
  Surfaceless.Kind = "platform";
  Surfaceless.GLName = software;
}

//------------------------------------------------------------------------------
Device* FindDevice(const void* handle)
{
  for (Device& device : Devices)
  {
    if (&device == handle)
    {
      return &device;
    }
  }
  return handle == &Surfaceless ? &Surfaceless : nullptr;
}

//------------------------------------------------------------------------------
template <typename Function>
Function GetMesa(const char* name)
{
  return reinterpret_cast<Function>(Mesa.getProcAddress(name));
}

//------------------------------------------------------------------------------
// All displays share one of Mesa's, which is never closed.
EGLDisplay GetMesaDisplay()
{
  static EGLDisplay display = []()
  {
    EGLDisplay made = Mesa.getPlatformDisplay(SurfacelessPlatform, nullptr, nullptr);
    GetMesa<PFNEGLINITIALIZEPROC>("eglInitialize")(made, nullptr, nullptr);
    return made;
  }();
  return display;
}

//------------------------------------------------------------------------------
template <typename Result>
Result Refuse(EGLint error, Result result)
{
  PendingError = error;
  return result;
}

//------------------------------------------------------------------------------
EGLDisplay GetPlatformDisplay(EGLenum platform, void* native, const EGLAttrib*)
{
  if (platform == DevicePlatform)
  {
    Device* device = FindDevice(native);
    return device && device->Kind != "mute" ? device : Refuse(EGL_BAD_PARAMETER, EGL_NO_DISPLAY);
  }
  const bool isOffered = platform == SurfacelessPlatform || platform == EGL_NONE;
  return isOffered && GetSetting("FAKE_EGL_PLATFORMS") != "none"
    ? &Surfaceless
    : Refuse(EGL_BAD_PARAMETER, EGL_NO_DISPLAY);
}

//------------------------------------------------------------------------------
EGLBoolean EGLAPIENTRY Initialize(EGLDisplay display, EGLint* major, EGLint* minor)
{
  if (FindDevice(display)->Kind == "broken")
  {
    return Refuse(EGL_NOT_INITIALIZED, static_cast<EGLBoolean>(EGL_FALSE));
  }
  return GetMesa<PFNEGLINITIALIZEPROC>("eglInitialize")(GetMesaDisplay(), major, minor);
}

//------------------------------------------------------------------------------
EGLBoolean EGLAPIENTRY Terminate(EGLDisplay)
{
  return EGL_TRUE;
}

//------------------------------------------------------------------------------
const char* EGLAPIENTRY QueryString(EGLDisplay display, EGLint name)
{
  if (display == EGL_NO_DISPLAY)
  {
    // libEGL lists only devices of vendors with these extensions.
    const char* extensions = GetSetting("FAKE_EGL_ENUMERATION") == "missing"
      ? "EGL_EXT_client_extensions EGL_EXT_platform_base"
      : "EGL_EXT_client_extensions EGL_EXT_platform_base EGL_EXT_device_base "
        "EGL_EXT_device_enumeration EGL_EXT_device_query EGL_EXT_platform_device";
    return name == EGL_EXTENSIONS ? extensions : Refuse<const char*>(EGL_BAD_DISPLAY, nullptr);
  }
  if (FindDevice(display)->Kind == "broken")
  {
    return Refuse<const char*>(EGL_NOT_INITIALIZED, nullptr);
  }
  return GetMesa<PFNEGLQUERYSTRINGPROC>("eglQueryString")(GetMesaDisplay(), name);
}

//------------------------------------------------------------------------------
EGLContext EGLAPIENTRY CreateContext(
  EGLDisplay display, EGLConfig config, EGLContext shared, const EGLint* attributes)
{
  if (FindDevice(display)->Kind == "contextless")
  {
    return Refuse(EGL_BAD_MATCH, EGL_NO_CONTEXT);
  }
  return GetMesa<PFNEGLCREATECONTEXTPROC>("eglCreateContext")(
    GetMesaDisplay(), config, shared, attributes);
}

//------------------------------------------------------------------------------
EGLint EGLAPIENTRY GetError()
{
  const EGLint error = PendingError;
  PendingError = EGL_SUCCESS;
  return error != EGL_SUCCESS ? error : GetMesa<PFNEGLGETERRORPROC>("eglGetError")();
}

//------------------------------------------------------------------------------
EGLBoolean EGLAPIENTRY QueryDevices(EGLint room, EGLDeviceEXT* devices, EGLint* count)
{
  const std::string enumeration = GetSetting("FAKE_EGL_ENUMERATION");
  if (enumeration == "failing")
  {
    return Refuse(EGL_BAD_ALLOC, static_cast<EGLBoolean>(EGL_FALSE));
  }
  *count = 0;
  for (Device& device : Devices)
  {
    if (devices)
    {
      if (*count == room)
      {
        break;
      }
      devices[*count] = &device;
    }
    ++*count;
  }
  return EGL_TRUE;
}

//------------------------------------------------------------------------------
const char* EGLAPIENTRY QueryDeviceString(EGLDeviceEXT handle, EGLint name)
{
  const Device* device = FindDevice(handle);
  const auto answer = [](const std::string& text)
  { return text.empty() ? Refuse<const char*>(EGL_BAD_PARAMETER, nullptr) : text.c_str(); };
  switch (name)
  {
    case EGL_EXTENSIONS:
      return device->Extensions.c_str();
    case DrmRenderNodeFile:
      return answer(device->RenderNode);
    case RendererName:
      return answer(device->Name);
    case EGL_VENDOR:
      return answer(device->Vendor);
    default:
      return answer("");
  }
}

//------------------------------------------------------------------------------
EGLBoolean EGLAPIENTRY QueryDeviceAttribute(EGLDeviceEXT handle, EGLint name, EGLAttrib* value)
{
  const Device* device = FindDevice(handle);
  if (name != CudaDevice || device->Cuda.empty())
  {
    return Refuse(EGL_BAD_ATTRIBUTE, static_cast<EGLBoolean>(EGL_FALSE));
  }
  *value = std::atoi(device->Cuda.c_str());
  return EGL_TRUE;
}

//------------------------------------------------------------------------------
const unsigned char* GetString(unsigned int name)
{
  const Device* device = FindDevice(Exports->getCurrentDisplay());
  if (name == GLRenderer && device)
  {
    return reinterpret_cast<const unsigned char*>(device->GLName.c_str());
  }
  return GetMesa<const unsigned char* (*)(unsigned int)>("glGetString")(name);
}

//------------------------------------------------------------------------------
// Forwards a function of Mesa's whose first argument is the display; `place` is its place in the
// list of these functions.
template <int place, typename Function>
struct OnMesaDisplay;

template <int place, typename Result, typename... Arguments>
struct OnMesaDisplay<place, Result (*)(EGLDisplay, Arguments...)>
{
  static inline const char* Name = nullptr;
  static Result EGLAPIENTRY Call(EGLDisplay, Arguments... arguments)
  {
    return GetMesa<Result (*)(EGLDisplay, Arguments...)>(Name)(GetMesaDisplay(), arguments...);
  }
};

template <int place, typename Function>
void* Forward(const char* name)
{
  OnMesaDisplay<place, Function>::Name = name;
  return reinterpret_cast<void*>(&OnMesaDisplay<place, Function>::Call);
}

//------------------------------------------------------------------------------
void* GetFunction(const char* name)
{
  static const std::map<std::string, void*> functions = {
    { "eglInitialize", reinterpret_cast<void*>(&Initialize) },
    { "eglTerminate", reinterpret_cast<void*>(&Terminate) },
    { "eglQueryString", reinterpret_cast<void*>(&QueryString) },
    { "eglCreateContext", reinterpret_cast<void*>(&CreateContext) },
    { "eglGetError", reinterpret_cast<void*>(&GetError) },
    { "eglQueryDevicesEXT", reinterpret_cast<void*>(&QueryDevices) },
    { "eglQueryDeviceStringEXT", reinterpret_cast<void*>(&QueryDeviceString) },
    { "eglQueryDeviceAttribEXT", reinterpret_cast<void*>(&QueryDeviceAttribute) },
    { "glGetString", reinterpret_cast<void*>(&GetString) },
    { "eglChooseConfig", Forward<0, PFNEGLCHOOSECONFIGPROC>("eglChooseConfig") },
    { "eglCreatePbufferSurface",
      Forward<1, PFNEGLCREATEPBUFFERSURFACEPROC>("eglCreatePbufferSurface") },
    { "eglDestroyContext", Forward<2, PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext") },
    { "eglDestroySurface", Forward<3, PFNEGLDESTROYSURFACEPROC>("eglDestroySurface") },
    { "eglMakeCurrent", Forward<4, PFNEGLMAKECURRENTPROC>("eglMakeCurrent") },
  };
  const bool isMissing = GetSetting("FAKE_EGL_ENUMERATION") == "missing" &&
    std::strncmp(name, "eglQueryDevice", 14) == 0;
  if (isMissing)
  {
    return nullptr;
  }
  const auto found = functions.find(name);
  return found == functions.end() ? Mesa.getProcAddress(name) : found->second;
}

//------------------------------------------------------------------------------
const char* GetVendorString(int name)
{
  if (name != __EGL_VENDOR_STRING_PLATFORM_EXTENSIONS)
  {
    return nullptr;
  }
  return GetSetting("FAKE_EGL_ENUMERATION") == "missing"
    ? "EGL_MESA_platform_surfaceless"
    : "EGL_EXT_platform_device EGL_MESA_platform_surfaceless";
}
}

//------------------------------------------------------------------------------
extern "C" __attribute__((visibility("default"))) EGLBoolean __egl_Main(uint32_t version,
  const __EGLapiExports* exports, __EGLvendorInfo* vendor, __EGLapiImports* imports)
{
  void* library = dlopen("libEGL_mesa.so.0", RTLD_LAZY);
  auto start =
    reinterpret_cast<__PFNEGLMAINPROC>(library ? dlsym(library, __EGL_MAIN_PROTO_NAME) : nullptr);
  if (!start || !start(version, exports, vendor, imports))
  {
    return EGL_FALSE;
  }
  Exports = exports;
  Mesa = *imports;
  ReadDevices();
  imports->getPlatformDisplay = GetPlatformDisplay;
  imports->getVendorString = GetVendorString;
  imports->getProcAddress = GetFunction;
  return EGL_TRUE;
}
