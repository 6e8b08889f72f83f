// SPDX-License-Identifier: BSD-3-Clause
// Several devices, of which some do not work: the chosen device, and the messages. The devices are
// those of a simulated vendor's library for EGL; see FakeEGLVendor.cxx.
#include "CardTestTools.h"
#include "HeadlessTestTools.h"

#include "vtkEGLMachine.h"

#include <dlfcn.h>

#include <cstdlib>

// The path of the library, which is not built without libglvnd's header for vendors.
#ifndef FAKE_EGL_VENDOR
#define FAKE_EGL_VENDOR ""
#endif

using namespace headlesstest;

namespace
{
//------------------------------------------------------------------------------
// The devices, on a machine with simulated files. EGL reads the environment once.
struct FakeMachine
{
  FakeTree Tree;

  explicit FakeMachine(const std::string& devices, const Settings& more = {}, bool withMesa = false)
  {
    if (!*FAKE_EGL_VENDOR)
    {
      vtkIndirectTest::Skip("glvnd/libeglabi.h was not there for the build");
    }
    if (!dlopen("libEGL_mesa.so.0", RTLD_LAZY))
    {
      vtkIndirectTest::Skip(std::string("there is no Mesa behind the devices: ") + dlerror());
    }
    std::string files = WriteVendorFile(this->Tree, "/fake/10_fake.json", FAKE_EGL_VENDOR);
    if (withMesa)
    {
      files += ":" + WriteVendorFile(this->Tree, "/fake/50_mesa.json", "libEGL_mesa.so.0");
    }
    Settings settings = more;
    settings["FAKE_EGL_DEVICES"] = devices;
    settings["__EGL_VENDOR_LIBRARY_FILENAMES"] = files;
    SetEnvironment(settings);
    vtkEGLMachine::Root = this->Tree.GetRoot();
  }
};

//------------------------------------------------------------------------------
struct Outcome
{
  int Messages = 0;
  std::string Text;
  std::string Platform;
  std::string Renderer;
  std::string Error;
  std::string Warning;
};

Outcome Render(int deviceIndex)
{
  SceneWindow scene(Red);
  ErrorCounter messages(scene.Window);
  scene.Window->SetDeviceIndex(deviceIndex);
  scene.Window->Render();
  scene.Window->Render();
  if (scene.Window->GetGenericContext())
  {
    CHECK_IMAGE(scene.Window, Red);
  }
  const Outcome outcome{ messages.Count, messages.Text, scene.Window->GetPlatformName(),
    scene.Window->GetGLRenderer(), scene.Window->GetLastErrorMessage(),
    scene.Window->GetLastWarningMessage() };
  std::cout << deviceIndex << ": " << outcome.Platform << ", " << outcome.Renderer << "\n";
  for (const std::string* text : { &outcome.Error, &outcome.Warning })
  {
    CHECK(text->find('\n') == std::string::npos, *text);
  }
  return outcome;
}

//------------------------------------------------------------------------------
const char* const Several =
  "broken|/dev/dri/renderD128|Card A|Vendor A|0;mute;contextless;fallback|/dev/dri/renderD129;"
  "works|/dev/dri/renderD130|Card B|Vendor B|1;works|/dev/dri/renderD131;software";

// Devices before the working card are not reported.
VTK_INDIRECT_TEST(FirstThatWorks)
{
  const FakeMachine machine(Several);
  const Outcome outcome = Render(-1);
  CHECK(outcome.Platform == "EGL device 4", outcome.Platform);
  CHECK(outcome.Renderer == "Fake GPU 4", outcome.Renderer);
  CHECK(outcome.Messages == 0, outcome.Text);
  CHECK(outcome.Warning.empty(), outcome.Warning);
  CHECK(vtkEGLHeadlessRenderWindow::IsSupported(), "");
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ChosenDevice)
{
  const FakeMachine machine(Several);
  vtkNew<vtkEGLHeadlessRenderWindow> window;
  CHECK(window->GetNumberOfDevices() == 7, window->GetNumberOfDevices());
  const std::map<int, std::string> works = { { 4, "Fake GPU 4" }, { 5, "Fake GPU 5" },
    { 6, "llvmpipe (LLVM 15.0.6, 256 bits)" } };
  const std::map<int, std::string> fails = { { 0, "eglInitialize: EGL_NOT_INITIALIZED" },
    { 1, "no EGL display" }, { 2, "EGL_BAD_MATCH" }, { 3, "it renders in software" },
    { 7, "There is no EGL device 7" }, { 1000000, "There is no EGL device 1000000" } };
  for (const auto& each : works)
  {
    const Outcome outcome = Render(each.first);
    CHECK(outcome.Platform == "EGL device " + std::to_string(each.first), outcome.Platform);
    CHECK(outcome.Renderer == each.second, outcome.Renderer);
    CHECK(outcome.Messages == 0, outcome.Text);
  }
  for (const auto& each : fails)
  {
    const Outcome outcome = Render(each.first);
    CHECK(outcome.Platform.empty() && outcome.Renderer.empty(), outcome.Platform);
    CHECK(outcome.Messages == 1, outcome.Messages);
    CHECK(Has(outcome.Error, each.second), outcome.Error);
    CHECK(Has(outcome.Error, "EGL device " + std::to_string(each.first)), outcome.Error);
    for (int i = 0; i < 7; ++i)
    {
      const std::string device = vtkEGLHeadlessRenderWindow::GetDeviceDescription(i);
      CHECK(!device.empty() && Has(outcome.Error, device), outcome.Error);
    }
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Descriptions)
{
  FakeMachine machine("works|/dev/dri/renderD128|Card A|NVIDIA Corporation|0;"
                      "broken|/dev/dri/renderD128;mute|||NVIDIA;works||Two\nlines|Vendor B|12;"
                      "works|/dev/dri/renderD129;works||||3;software|/dev/dri/renderD129");
  machine.Tree.KernelNode("renderD128", "nvidia").KernelNode("renderD129", "amdgpu");
  const auto describe = [](int index)
  { return vtkEGLHeadlessRenderWindow::GetDeviceDescription(index); };
  const std::vector<std::string> expected = { "EGL device 0: hardware, Card A, NVIDIA Corporation, "
                                              "nvidia, /dev/dri/renderD128, CUDA device 0",
    "EGL device 1: hardware, nvidia, /dev/dri/renderD128, the card of EGL device 0",
    "EGL device 2: hardware", "EGL device 3: hardware, Two lines, Vendor B, CUDA device 12",
    "EGL device 4: hardware, amdgpu, /dev/dri/renderD129",
    "EGL device 5: hardware, NVIDIA, CUDA device 3",
    "EGL device 6: software, /dev/dri/renderD129, the card of EGL device 4" };
  for (size_t i = 0; i < expected.size(); ++i)
  {
    CHECK(describe(static_cast<int>(i)) == expected[i], describe(static_cast<int>(i)));
  }
  CHECK(describe(-1).empty() && describe(7).empty() && describe(1 << 30).empty(), "");
}

//------------------------------------------------------------------------------
// One card that two drivers list, the first of which cannot render on it.
VTK_INDIRECT_TEST(TwoDriversFirstFails)
{
  const FakeMachine machine("broken|/dev/dri/renderD128;works|/dev/dri/renderD128|A40|NVIDIA|0");
  const Outcome outcome = Render(-1);
  CHECK(outcome.Platform == "EGL device 1", outcome.Platform);
  CHECK(outcome.Messages == 0, outcome.Text);
  CHECK(Has(vtkEGLHeadlessRenderWindow::GetDeviceDescription(1), "the card of EGL device 0"), "");
}

//------------------------------------------------------------------------------
// Two vendors' libraries, the second of which is Mesa's own.
VTK_INDIRECT_TEST(TwoVendors)
{
  const FakeMachine machine("works|/dev/dri/renderD128|A40|NVIDIA|0;broken", {}, true);
  vtkNew<vtkEGLHeadlessRenderWindow> window;
  const int count = window->GetNumberOfDevices();
  CHECK(count >= 3, count);
  const Outcome outcome = Render(-1);
  CHECK(outcome.Platform == "EGL device 0", outcome.Platform);
  CHECK(outcome.Messages == 0, outcome.Text);
  for (int i = 2; i < count; ++i)
  {
    const std::string device = vtkEGLHeadlessRenderWindow::GetDeviceDescription(i);
    std::cout << device << "\n";
    CHECK(Has(device, "EGL device " + std::to_string(i) + ": "), device);
    if (Has(device, ": software"))
    {
      CHECK(Render(i).Platform == "EGL device " + std::to_string(i), "");
    }
  }
}

//------------------------------------------------------------------------------
void CheckNoDevices()
{
  vtkNew<vtkEGLHeadlessRenderWindow> window;
  CHECK(window->GetNumberOfDevices() == 0, window->GetNumberOfDevices());
  CHECK(vtkEGLHeadlessRenderWindow::GetDeviceDescription(0).empty(), "");
  const Outcome chosen = Render(0);
  CHECK(chosen.Messages == 1, chosen.Messages);
  CHECK(chosen.Error == "There is no EGL device 0. EGL lists no devices.", chosen.Error);
  const Outcome any = Render(-1);
  CHECK(any.Platform == "EGL surfaceless platform", any.Platform);
  CHECK(any.Messages == 0, any.Text);
}

VTK_INDIRECT_TEST(DevicesMissing)
{
  const FakeMachine machine("works;works", { { "FAKE_EGL_ENUMERATION", "missing" } });
  CheckNoDevices();
}

VTK_INDIRECT_TEST(DevicesFail)
{
  const FakeMachine machine("works;works", { { "FAKE_EGL_ENUMERATION", "failing" } });
  CheckNoDevices();
}

//------------------------------------------------------------------------------
// A device by its number, whose file cannot be opened.
VTK_INDIRECT_TEST(ChosenDeviceRefused)
{
  FakeMachine machine("broken|/dev/dri/renderD128;works");
  machine.Tree.KernelNode("renderD128", "amdgpu").Folder("/dev/dri/renderD128");
  const Outcome outcome = Render(0);
  CHECK(outcome.Messages == 1, outcome.Messages);
  CHECK(Has(outcome.Error, "EGL_NOT_INITIALIZED; /dev/dri/renderD128 of a graphics card cannot"),
    outcome.Error);
  CHECK(Has(outcome.Error, "EGL lists EGL device 0"), outcome.Error);
}

//------------------------------------------------------------------------------
// One warning in a process, which every window can return.
VTK_INDIRECT_TEST(CardWithoutEGL)
{
  FakeMachine machine("broken|/dev/dri/renderD128;software");
  machine.Tree.Node("renderD128", "amdgpu");
  CHECK(vtkEGLHeadlessRenderWindow::IsSupported(), "");
  const Outcome first = Render(-1);
  CHECK(first.Platform == "EGL surfaceless platform", first.Platform);
  CHECK(first.Messages == 1, first.Messages);
  CHECK(Has(first.Text, first.Warning), first.Text);
  CHECK(first.Error.empty(), first.Error);
  const std::string expected = "OpenGL renders in software (llvmpipe (LLVM 15.0.6, 256 bits)) "
                               "although there is a graphics card: EGL device 0 of the graphics "
                               "card /dev/dri/renderD128 (amdgpu) does not work";
  CHECK(Has(first.Warning, expected), first.Warning);
  const Outcome second = Render(-1);
  CHECK(second.Messages == 0, second.Messages);
  CHECK(second.Warning == first.Warning, second.Warning);
  // Software chosen by its number is intended.
  const Outcome chosen = Render(1);
  CHECK(chosen.Messages == 0 && chosen.Warning.empty(), chosen.Warning);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(FallbackToSoftware)
{
  FakeMachine machine("fallback|/dev/dri/renderD128|||");
  machine.Tree.Node("renderD128", "i915");
  const Outcome outcome = Render(-1);
  CHECK(outcome.Messages == 1, outcome.Messages);
  CHECK(Has(outcome.Warning, "it renders in software"), outcome.Warning);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(NvidiaWithoutEGL)
{
  FakeMachine machine("software", { { "NVIDIA_DRIVER_CAPABILITIES", "compute,utility" } });
  machine.Tree.File("/dev/nvidia0");
  const Outcome outcome = Render(-1);
  CHECK(outcome.Messages == 1, outcome.Messages);
  CHECK(Has(outcome.Warning, "NVIDIA_DRIVER_CAPABILITIES=all"), outcome.Warning);
}

//------------------------------------------------------------------------------
// NVIDIA's device is distinguished from another vendor's.
VTK_INDIRECT_TEST(NvidiaFails)
{
  FakeMachine machine("broken|/dev/dri/renderD128;broken|/dev/dri/renderD128|A40|NVIDIA|0");
  machine.Tree.Node("renderD128", "nvidia").File("/dev/nvidia0");
  const Outcome outcome = Render(-1);
  CHECK(outcome.Messages == 1, outcome.Messages);
  CHECK(Has(outcome.Warning, "card: EGL device 1 of the NVIDIA card"), outcome.Warning);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ContainerWithoutDevices)
{
  FakeMachine machine("");
  machine.Tree.KernelNode("renderD128", "amdgpu");
  const Outcome outcome = Render(-1);
  CHECK(outcome.Messages == 1, outcome.Messages);
  CHECK(Has(outcome.Warning, "--device /dev/dri"), outcome.Warning);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(NoCard)
{
  FakeMachine machine("software");
  machine.Tree.Folder("/sys/class/drm/card0").File("/dev/dri/card0");
  const Outcome outcome = Render(-1);
  CHECK(!outcome.Platform.empty() && outcome.Messages == 0, outcome.Text);
  CHECK(outcome.Warning.empty(), outcome.Warning);
}

//------------------------------------------------------------------------------
// A device that the environment makes software may be chosen.
VTK_INDIRECT_TEST(SoftwareWanted)
{
  FakeMachine machine("fallback|/dev/dri/renderD128", { { "LIBGL_ALWAYS_SOFTWARE", "1" } });
  machine.Tree.Node("renderD128", "amdgpu");
  for (int index : { -1, 0 })
  {
    const Outcome outcome = Render(index);
    CHECK(outcome.Platform == "EGL device 0", outcome.Platform);
    CHECK(outcome.Messages == 0 && outcome.Warning.empty(), outcome.Warning);
  }
}

//------------------------------------------------------------------------------
// One error, in place of the warning.
VTK_INDIRECT_TEST(NothingWorks)
{
  FakeMachine machine("broken|/dev/dri/renderD128", { { "FAKE_EGL_PLATFORMS", "none" } });
  machine.Tree.Node("renderD128", "amdgpu");
  const Outcome outcome = Render(-1);
  CHECK(outcome.Messages == 1, outcome.Messages);
  CHECK(Has(outcome.Error, "Tried: EGL device 0 (eglInitialize: EGL_NOT_INITIALIZED)"), "");
  CHECK(Has(outcome.Error, "There is a graphics card: EGL device 0"), outcome.Error);
  CHECK(outcome.Warning.empty(), outcome.Warning);
}
}
