// SPDX-License-Identifier: BSD-3-Clause
#include "vtkEGLContext.h"

#include "vtkEGLDevice.h"
#include "vtkEGLDiagnosis.h"
#include "vtkEGLLoader.h"
#include "vtkEGLMachine.h"
#include "vtkEGLPlatform.h"
#include "vtkEGLUtilities.h"

#include <EGL/eglext.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <mutex>
#include <vector>

using vtkEGLUtilities::GetErrorName;

namespace
{
// Chooses the device of windows without a DeviceIndex, in programs that cannot be changed.
const char* const DeviceVariable = "VTK_INDIRECT_EGL_DEVICE";

// No platform would work better in this case.
const char* const BlockedReason =
  "Another OpenGL context, such as that of an X window, is current in "
  "this thread. Call ReleaseCurrent() on its window first.";

// Counts the users of EGL displays. Displays are shared: two requests for a display give the same
// handle, and terminating it ends it for everybody. So users are counted over all windows and
// threads, and a display initialized by other code is never terminated.
class DisplayUsers
{
public:
  // The instance is never deleted: windows may be destroyed as late as static objects.
  static DisplayUsers& GetInstance()
  {
    static auto* users = new DisplayUsers;
    return *users;
  }

  // Initializes the display for its first user. Returns false, with EGL's error, if that fails.
  bool Acquire(EGLDisplay display)
  {
    std::lock_guard<std::mutex> lock(this->Mutex);
    Entry& entry = this->Entries[display];
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

  // Terminates the display after its last user.
  void Release(EGLDisplay display)
  {
    std::lock_guard<std::mutex> lock(this->Mutex);
    Entry& entry = this->Entries[display];
    if (--entry.Count == 0 && !entry.IsForeign)
    {
      eglTerminate(display);
    }
  }

private:
  struct Entry
  {
    int Count = 0;
    bool IsForeign = false;
  };
  std::mutex Mutex;
  std::map<EGLDisplay, Entry> Entries;
};

//------------------------------------------------------------------------------
std::string ExplainMissingCard(std::vector<vtkEGLMachine::Attempt> attempts)
{
  const std::vector<vtkEGLDevice> devices = vtkEGLDevice::List();
  for (vtkEGLMachine::Attempt& attempt : attempts)
  {
    const auto device = std::find_if(devices.begin(), devices.end(),
      [&](const vtkEGLDevice& listed) { return listed.Index == attempt.DeviceIndex; });
    if (device != devices.end())
    {
      attempt.IsNvidia = device->IsNvidia();
      attempt.RenderNode = device->RenderNode;
    }
  }
  vtkEGLMachine machine = vtkEGLMachine::Gather();
  machine.Attempts = attempts;
  return vtkEGLDiagnosis::Explain(machine);
}
}

//------------------------------------------------------------------------------
std::string vtkEGLContext::Create(int deviceIndex)
{
  const char* wanted = std::getenv(DeviceVariable);
  if (deviceIndex < 0 && wanted && *wanted)
  {
    char* end = nullptr;
    const long index = std::strtol(wanted, &end, 10);
    if (*end != '\0' || index < 0 || index > std::numeric_limits<int>::max())
    {
      return std::string(DeviceVariable) + " is \"" + wanted + "\", which is no device's number. " +
        vtkEGLDevice::DescribeAll(vtkEGLDevice::List());
    }
    deviceIndex = static_cast<int>(index);
  }
  std::string tried;
  std::vector<vtkEGLMachine::Attempt> attempts;
  const std::vector<vtkEGLPlatform> platforms = vtkEGLPlatform::ListCandidates(deviceIndex);
  for (const vtkEGLPlatform& platform : platforms)
  {
    std::string reason = this->CreateOn(platform);
    if (reason == BlockedReason)
    {
      return reason;
    }
    if (reason.empty())
    {
      // A software device selected by its number is intended.
      if (deviceIndex < 0 && vtkEGLUtilities::IsSoftwareRenderer(this->Renderer))
      {
        const std::string why = ExplainMissingCard(attempts);
        this->Warning = why.empty() ? ""
                                    : "OpenGL renders in software (" + this->Renderer +
            ") although there is a graphics card: " + why;
      }
      return "";
    }
    vtkEGLMachine::Attempt attempt;
    attempt.Name = platform.Name;
    attempt.Reason = reason;
    attempt.IsHardware = platform.DeviceIndex >= 0 && !platform.IsSoftware;
    attempt.DeviceIndex = platform.DeviceIndex;
    attempts.push_back(attempt);
    tried += (tried.empty() ? "" : "; ") + platform.Name + " (" + reason + ")";
  }
  const std::vector<vtkEGLDevice> devices = vtkEGLDevice::List();
  if (platforms.empty())
  {
    return "There is no EGL device " + std::to_string(deviceIndex) + ". " +
      vtkEGLDevice::DescribeAll(devices);
  }
  if (deviceIndex >= 0)
  {
    const bool isListed = deviceIndex < static_cast<int>(devices.size());
    const std::string why = vtkEGLDiagnosis::ExplainRenderNode(
      vtkEGLMachine::Gather(), isListed ? devices[deviceIndex].RenderNode : "");
    return "No OpenGL 3.2 core context can be made on EGL device " + std::to_string(deviceIndex) +
      ": " + attempts.front().Reason + (why.empty() ? "" : "; " + why.substr(0, why.size() - 1)) +
      ". " + vtkEGLDevice::DescribeAll(devices);
  }
  const std::string why = ExplainMissingCard(attempts);
  return "No OpenGL 3.2 core context can be made without a display. Tried: " + tried + ". " +
    (why.empty() ? "Install an EGL driver: that of the GPU's vendor, or Mesa for rendering in "
                   "software (Debian: libegl1 libgl1-mesa-dri)."
                 : "There is a graphics card: " + why);
}

//------------------------------------------------------------------------------
std::string vtkEGLContext::CreateOn(const vtkEGLPlatform& platform)
{
  this->Display = platform.GetDisplay();
  if (this->Display == EGL_NO_DISPLAY)
  {
    return "no EGL display";
  }
  if (!DisplayUsers::GetInstance().Acquire(this->Display))
  {
    std::string reason = "eglInitialize: " + GetErrorName(eglGetError());
    *this = vtkEGLContext();
    return reason;
  }
  const vtkEGLBinding previous = GetCurrent();
  std::string reason = this->MakeContextAndSurface();
  if (reason.empty())
  {
    if (!this->MakeCurrent())
    {
      const EGLint error = eglGetError();
      reason = error == EGL_BAD_ACCESS ? BlockedReason : "eglMakeCurrent: " + GetErrorName(error);
    }
    else
    {
      reason = this->Examine(platform);
      if (previous.HasContext())
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

//------------------------------------------------------------------------------
std::string vtkEGLContext::MakeContextAndSurface()
{
  if (!eglBindAPI(EGL_OPENGL_API))
  {
    return "it offers OpenGL ES only";
  }
  // The smallest pixel buffer serves the context. VTK draws into framebuffers of its own, but
  // queries the default one, which is incomplete without a surface.
  const EGLint wanted[] = { EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_RED_SIZE, 8, EGL_GREEN_SIZE, 8, EGL_BLUE_SIZE, 8, EGL_ALPHA_SIZE, 8, EGL_DEPTH_SIZE, 24,
    EGL_NONE };
  const EGLint surfaceless[] = { EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_RENDERABLE_TYPE,
    EGL_OPENGL_BIT, EGL_NONE };
  EGLConfig config = nullptr;
  EGLint count = 0;
  const bool hasSurface =
    eglChooseConfig(this->Display, wanted, &config, 1, &count) == EGL_TRUE && count > 0;
  if (!hasSurface)
  {
    if (!vtkEGLUtilities::HasExtension(
          eglQueryString(this->Display, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context"))
    {
      return "neither pixel buffers nor contexts without a surface";
    }
    if (!eglChooseConfig(this->Display, surfaceless, &config, 1, &count) || count == 0)
    {
      return "no configuration for OpenGL";
    }
  }

  const int versions[][2] = { { 4, 6 }, { 4, 5 }, { 4, 4 }, { 4, 3 }, { 4, 2 }, { 4, 1 }, { 4, 0 },
    { 3, 3 }, { 3, 2 } };
  for (const auto& version : versions)
  {
    const EGLint attributes[] = { EGL_CONTEXT_MAJOR_VERSION_KHR, version[0],
      EGL_CONTEXT_MINOR_VERSION_KHR, version[1], EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR, EGL_NONE };
    this->Context = eglCreateContext(this->Display, config, EGL_NO_CONTEXT, attributes);
    if (this->HasContext())
    {
      break;
    }
  }
  if (!this->HasContext())
  {
    return "no core profile of OpenGL 3.2 or later: " + GetErrorName(eglGetError());
  }
  if (hasSurface)
  {
    const EGLint size[] = { EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE };
    this->Draw = this->Read = eglCreatePbufferSurface(this->Display, config, size);
    if (this->Draw == EGL_NO_SURFACE)
    {
      return "eglCreatePbufferSurface: " + GetErrorName(eglGetError());
    }
  }
  return "";
}

//------------------------------------------------------------------------------
// Requires the context to be current.
std::string vtkEGLContext::Examine(const vtkEGLPlatform& platform)
{
  this->PlatformName = platform.Name;
  this->Version = vtkEGLLoader::GetVersion();
  this->Renderer = vtkEGLLoader::GetRenderer();
  this->MaximumSize = vtkEGLLoader::GetMaximumTextureSize();
  if (vtkEGLLoader::GetVersionNumber() < 32)
  {
    return "OpenGL \"" + this->Version + "\" is older than 3.2";
  }
  // A driver for a device that cannot render may fall back to software. The surfaceless platform
  // does the same, and is next.
  if (platform.MustBeHardware && vtkEGLUtilities::IsSoftwareRenderer(this->Renderer))
  {
    return "it renders in software (" + this->Renderer + ")";
  }
  return "";
}

//------------------------------------------------------------------------------
void vtkEGLContext::Destroy()
{
  if (this->Display == EGL_NO_DISPLAY)
  {
    return;
  }
  if (this->HasContext())
  {
    this->ReleaseCurrent();
    eglDestroyContext(this->Display, this->Context);
  }
  if (this->Draw != EGL_NO_SURFACE)
  {
    eglDestroySurface(this->Display, this->Draw);
  }
  DisplayUsers::GetInstance().Release(this->Display);
  *this = vtkEGLContext();
}
