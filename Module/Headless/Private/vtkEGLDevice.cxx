// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLDevice.h"

#include "vtkEGLMachine.h"
#include "vtkEGLPlatform.h"
#include "vtkEGLUtilities.h"

#include <EGL/eglext.h>

#include <algorithm>

// Some EGL headers lack these names.
#ifndef EGL_DRM_DEVICE_FILE_EXT
#define EGL_DRM_DEVICE_FILE_EXT 0x3233
#endif
#ifndef EGL_DRM_RENDER_NODE_FILE_EXT
#define EGL_DRM_RENDER_NODE_FILE_EXT 0x3377
#endif
#ifndef EGL_DRIVER_NAME_EXT
#define EGL_DRIVER_NAME_EXT 0x335E
#endif
#ifndef EGL_RENDERER_EXT
#define EGL_RENDERER_EXT 0x335F
#endif
#ifndef EGL_CUDA_DEVICE_NV
#define EGL_CUDA_DEVICE_NV 0x323A
#endif

using vtkEGLUtilities::GetFunction;
using vtkEGLUtilities::HasExtension;

namespace
{
//------------------------------------------------------------------------------
// Puts drivers' texts on one line, for messages.
std::string OnOneLine(const char* text)
{
  std::string line(text ? text : "");
  std::replace_if(
    line.begin(), line.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
  return line;
}

//------------------------------------------------------------------------------
vtkEGLDevice Ask(const vtkEGLPlatform& platform, int index)
{
  vtkEGLDevice device;
  device.Index = index;
  device.IsSoftware = platform.IsSoftware;
  auto handle = static_cast<EGLDeviceEXT>(platform.Handle);
  auto queryString = GetFunction<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  auto queryAttribute = GetFunction<PFNEGLQUERYDEVICEATTRIBEXTPROC>("eglQueryDeviceAttribEXT");
  const char* extensions = queryString ? queryString(handle, EGL_EXTENSIONS) : nullptr;
  const auto ask = [&](const char* extension, EGLint name)
  { return HasExtension(extensions, extension) ? OnOneLine(queryString(handle, name)) : ""; };
  device.Renderer = ask("EGL_EXT_device_query_name", EGL_RENDERER_EXT);
  device.Vendor = ask("EGL_EXT_device_query_name", EGL_VENDOR);
  device.Driver = ask("EGL_EXT_device_persistent_id", EGL_DRIVER_NAME_EXT);
  device.CardFile = ask("EGL_EXT_device_drm", EGL_DRM_DEVICE_FILE_EXT);
  device.RenderNode = ask("EGL_EXT_device_drm_render_node", EGL_DRM_RENDER_NODE_FILE_EXT);
  // Only NVIDIA's driver has this extension, and some versions of it report no vendor.
  if (device.Vendor.empty() && HasExtension(extensions, "EGL_NV_device_cuda"))
  {
    device.Vendor = "NVIDIA";
  }
  if (device.Driver.empty() && !device.IsSoftware && !device.RenderNode.empty())
  {
    device.Driver = vtkEGLMachine::GetKernelDriver(device.RenderNode);
  }
  EGLAttrib cuda = -1;
  if (queryAttribute && HasExtension(extensions, "EGL_NV_device_cuda") &&
    queryAttribute(handle, EGL_CUDA_DEVICE_NV, &cuda))
  {
    device.CudaDevice = static_cast<int>(cuda);
  }
  // Discards the error of a query that a driver does not support.
  eglGetError();
  return device;
}
}

//------------------------------------------------------------------------------
bool vtkEGLDevice::IsNvidia() const
{
  // Mesa may list an NVIDIA card, too, and has other requirements.
  return this->Vendor.find("NVIDIA") != std::string::npos;
}

//------------------------------------------------------------------------------
std::string vtkEGLDevice::Describe() const
{
  std::string text =
    "EGL device " + std::to_string(this->Index) + (this->IsSoftware ? ": software" : ": hardware");
  for (const std::string* word :
    { &this->Renderer, &this->Vendor, &this->Driver, &this->CardFile, &this->RenderNode })
  {
    text += word->empty() ? "" : ", " + *word;
  }
  text += this->CudaDevice >= 0 ? ", CUDA device " + std::to_string(this->CudaDevice) : "";
  text +=
    this->SameCardAs >= 0 ? ", the card of EGL device " + std::to_string(this->SameCardAs) : "";
  return text;
}

//------------------------------------------------------------------------------
std::vector<vtkEGLDevice> vtkEGLDevice::List()
{
  std::vector<vtkEGLDevice> devices;
  for (const vtkEGLPlatform& platform : vtkEGLPlatform::ListDevices())
  {
    vtkEGLDevice device = Ask(platform, static_cast<int>(devices.size()));
    const auto isSame = [](const std::string& a, const std::string& b)
    { return !a.empty() && a == b; };
    const auto first = std::find_if(devices.begin(), devices.end(),
      [&](const vtkEGLDevice& other) {
        return isSame(device.RenderNode, other.RenderNode) ||
          isSame(device.CardFile, other.CardFile);
      });
    device.SameCardAs = first == devices.end() ? -1 : first->Index;
    devices.push_back(device);
  }
  return devices;
}

//------------------------------------------------------------------------------
std::string vtkEGLDevice::DescribeAll(const std::vector<vtkEGLDevice>& devices)
{
  if (devices.empty())
  {
    return "EGL lists no devices.";
  }
  std::string text;
  for (const vtkEGLDevice& device : devices)
  {
    text += (text.empty() ? "EGL lists " : "; ") + device.Describe();
  }
  return text + ".";
}
