// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLPlatform.h"

#include "vtkEGLMachine.h"
#include "vtkEGLUtilities.h"

#include <EGL/eglext.h>

#include <algorithm>
#include <iterator>

// Some EGL headers lack this name.
#ifndef EGL_PLATFORM_DEVICE_EXT
#define EGL_PLATFORM_DEVICE_EXT 0x313F
#endif
#ifndef EGL_PLATFORM_SURFACELESS_MESA
#define EGL_PLATFORM_SURFACELESS_MESA 0x31DD
#endif

using vtkEGLUtilities::GetFunction;
using vtkEGLUtilities::HasExtension;

//------------------------------------------------------------------------------
EGLDisplay vtkEGLPlatform::GetDisplay() const
{
  if (this->Type == EGL_NONE)
  {
    return eglGetDisplay(EGL_DEFAULT_DISPLAY);
  }
  auto getPlatformDisplay =
    GetFunction<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  return getPlatformDisplay ? getPlatformDisplay(this->Type, this->Handle, nullptr)
                            : EGL_NO_DISPLAY;
}

//------------------------------------------------------------------------------
std::vector<vtkEGLPlatform> vtkEGLPlatform::ListDevices()
{
  std::vector<vtkEGLPlatform> platforms;
  const char* extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  const bool canList = HasExtension(extensions, "EGL_EXT_device_base") ||
    HasExtension(extensions, "EGL_EXT_device_enumeration");
  if (!canList || !HasExtension(extensions, "EGL_EXT_platform_device"))
  {
    return platforms;
  }
  auto queryDevices = GetFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  auto queryDeviceString = GetFunction<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
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
    vtkEGLPlatform platform;
    platform.Name = "EGL device " + std::to_string(i);
    platform.Type = EGL_PLATFORM_DEVICE_EXT;
    platform.Handle = devices[i];
    platform.DeviceIndex = i;
    platform.IsSoftware = queryDeviceString &&
      HasExtension(queryDeviceString(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
    platform.MustBeHardware = !platform.IsSoftware && !vtkEGLMachine::EnvironmentWantsSoftware();
    platforms.push_back(platform);
  }
  return platforms;
}

//------------------------------------------------------------------------------
std::vector<vtkEGLPlatform> vtkEGLPlatform::ListCandidates(int deviceIndex)
{
  std::vector<vtkEGLPlatform> devices = ListDevices();
  std::vector<vtkEGLPlatform> platforms;
  if (deviceIndex >= 0)
  {
    if (deviceIndex < static_cast<int>(devices.size()))
    {
      platforms.push_back(devices[deviceIndex]);
    }
    return platforms;
  }
  std::copy_if(devices.begin(), devices.end(), std::back_inserter(platforms),
    [](const vtkEGLPlatform& device) { return !device.IsSoftware; });
  if (HasExtension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), "EGL_MESA_platform_surfaceless"))
  {
    vtkEGLPlatform surfaceless;
    surfaceless.Name = "EGL surfaceless platform";
    surfaceless.Type = EGL_PLATFORM_SURFACELESS_MESA;
    platforms.push_back(surfaceless);
  }
  std::copy_if(devices.begin(), devices.end(), std::back_inserter(platforms),
    [](const vtkEGLPlatform& device) { return device.IsSoftware; });
  vtkEGLPlatform fallback;
  fallback.Name = "EGL default display";
  platforms.push_back(fallback);
  return platforms;
}
