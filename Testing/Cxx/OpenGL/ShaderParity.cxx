// SPDX-License-Identifier: BSD-3-Clause
// The kernels on the GPU against the same source on the host.
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectComputeProgram.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectShaderLibrary.h"
#include "OpenGL/vtkIndirectShaderTable.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <set>

using namespace vtkIndirectTest;

namespace vtkIndirectKernels
{
namespace
{
#include "ShaderKernels.glsl"
}
}

namespace
{
constexpr int Width = 128;
constexpr int Height = 128;

const vtkIndirectChannels Channels = {
  { "test", "vtkiTest", "a kernel's values", GL_RGBA32F, "-", "-" },
};

struct Kernel
{
  const char* Name;
  double Tolerance; // relative to max(|value|, Floor)
  double Floor;
  const char* Origin;
  double Share = 0.0; // of the values that may be off by any amount
};

// In the order of ShaderKernels.glsl. Default: 1e-5 of values of order one.
const char* const Rounding = "rounding, order of operations";
const Kernel Kernels[] = {
  { "vtkiOctahedralEncode", 1e-5, 0.1, Rounding },
  { "vtkiOctahedralDecode", 1e-5, 0.1, Rounding },
  { "vtkiPackSurface, vtkiSurfaceDepth, vtkiSurfaceCode", 1.001 / 16127.0, 1.0,
    "a rounding may fall on the next of 16127 steps" },
  { "vtkiSurfaceNormal, vtkiSurfaceKind", 3.0 / 16127.0, 1.0,
    "the same, through the decoder's gain of 3" },
  { "vtkiSurfaceIsLit", 0.0, 1.0, "a decision" },
  { "vtkiReconstruct", 1e-5, 0.5, "sums that cancel" },
  { "vtkiFaceOf", 0.0, 1.0, "a decision" },
  { "vtkiToFace", 0.0, 1.0, "signs and order only" },
  { "vtkiTexelSolidAngle", 1e-5, 0.0, Rounding },
  { "vtkiAttenuationTimesDistance2", 1e-5, 1e-9, Rounding },
  { "vtkiConeFactor", 1e-4, 1e-3,
    "GPU pow: log2 and exp2 of limited precision, exponents up to 8" },
  { "vtkiCosineRatio", 1e-5, 1e-6, Rounding },
  { "vtkiVirtualLightWeight", 1e-4, 1e-2, "cosines near zero cancel" },
  { "vtkiPlaneDepthGradient", 1e-5, 1e-3, Rounding },
  { "vtkiDepthToBuffer, its slope, vtkiShadowWeight", 1e-5, 0.1, "depth minus near plane cancels" },
  { "vtkiSameSurface", 0.0, 1.0, "a decision" },
  { "vtkiDiskSample", 1e-4, 0.1, "GPU sine and cosine: 2^-11 is allowed, about 1e-5 usual" },
  { "vtkiDecodeGamma", 1e-4, 1e-3, "GPU pow" },
  { "vtkiEncodeGamma", 1e-4, 1e-3, "GPU pow" },
  { "gamma round trip", 1e-4, 1e-3, "GPU pow" },
  { "vtkiHarmonicsLow, vtkiHarmonicsHigh", 1e-5, 0.1, Rounding },
  { "vtkiIrradianceLow, High, Lobe", 1e-4, 0.1, "near half a hemisphere two forms meet" },
  { "vtkiPatchOffset, vtkiPatchSolidAngle", 1e-4, 1e-2, "cosines near zero cancel" },
  { "vtkiBeginWalk, vtkiWalkBits, vtkiAdvance", 0.0, 1.0,
    "decisions and bits, where a GPU's division, off by 2.5 steps of a float, crosses a border",
    1e-4 },
  { "vtkiMirror, vtkiGlossyWeight, vtkiGlossyVariation", 1e-3, 0.1,
    "GPU pow: log2 of limited precision, exponents up to 128" },
  { "vtkiPackPlane, vtkiUnpackPlane, vtkiLeavePlane", 1e-5, 0.1, Rounding },
  { "vtkiPackAlbedo, vtkiUnpackAlbedo", 2e-3, 1.0,
    "a rounding may fall on the next of 1023 roots" },
  { "vtkiRunForward, vtkiRunBackward, vtkiRunAreas, vtkiNeighborShares", 1e-5, 0.1, Rounding },
  { "vtkiSenderLobeWeight, vtkiPhongFlux, vtkiLobeIntegral, vtkiExponentOfRoughness", 2e-3, 0.1,
    "GPU exp and log of limited precision, exponents up to 1e6" },
  { "vtkiProxySine, vtkiHarmonicsExp, vtkiLitCosine, vtkiProxyRadiance, vtkiProxyOverlap", 2e-4,
    0.1, "squares of squares: 32 times the rounding of exp and of 16 sums" },
  { "vtkiMakeLobeSplat, vtkiMakeSplat", 2e-3, 1e-2,
    "GPU exp and log of limited precision, exponents up to 1e6" },
  { "constants", 0.0, 1.0, "literals" },
};

// a: direction and a number, b: direction and a number, c: direction and a signed number.
std::vector<float> MakeInput()
{
  Random random(20);
  std::vector<float> input;
  for (int i = 0; i < 3 * Width * Height; ++i)
  {
    const glm::dvec3 d = random.NextDirection();
    const double w = i % 3 == 2 ? random.Next(-1.0, 1.0) : random.Next();
    for (double v : { d.x, d.y, d.z, w })
    {
      input.push_back(static_cast<float>(v));
    }
  }
  return input;
}

std::vector<float> RunOnGPU(Scene& scene, vtkIndirectFullScreenProgram& kernel,
  vtkIndirectTarget& target, vtkTextureObject* texture, int number)
{
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
  const vtkIndirectProgram program = kernel.Use(window);
  if (!Check("the test's stage links", program != nullptr))
  {
    return {};
  }
  vtkOpenGLState::ScopedglViewport viewport(window->GetState());
  vtkOpenGLState::ScopedglScissor scissor(window->GetState());
  vtkIndirectFullScreenState state(window);
  target.Begin();
  texture->Activate();
  program->SetUniformi("vtkiInput", texture->GetTextureUnit());
  program->SetUniformi("vtkiKernel", number);
  kernel.Draw();
  texture->Deactivate();
  target.End();
  return target.ReadBack(0);
}
}

VTK_INDIRECT_TEST(KernelParity)
{
  Scene scene(64, 64);
  scene.Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
  window->MakeCurrent();
  const std::vector<float> input = MakeInput();
  vtkNew<vtkTextureObject> texture;
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  std::vector<float> copy = input;
  texture->Create2DFromRaw(3 * Width, Height, 4, VTK_FLOAT, copy.data());
  vtkIndirectTarget target(nullptr, Channels, false);
  vtkIndirectFullScreenProgram kernel(nullptr, "ShaderKernelsFS.glsl");
  target.Resize(window, Width, Height);

  const int count = static_cast<int>(std::size(Kernels));
  CheckEqual("kernels in the table", count, vtkIndirectKernels::VTKI_KERNEL_COUNT);
  for (int number = 0; number < count; ++number)
  {
    const Kernel& k = Kernels[number];
    const std::vector<float> values = RunOnGPU(scene, kernel, target, texture, number);
    if (values.empty())
    {
      break;
    }
    std::vector<double> differences;
    int bad = 0;
    std::set<float> distinct;
    for (int i = 0; i < Width * Height; ++i)
    {
      const float* v = &input[12 * i];
      const glm::vec4 host =
        vtkIndirectKernels::vtkiTestKernel(number, glm::vec4(v[0], v[1], v[2], v[3]),
          glm::vec4(v[4], v[5], v[6], v[7]), glm::vec4(v[8], v[9], v[10], v[11]));
      for (int c = 0; c < 4; ++c)
      {
        const double a = values[4 * i + c];
        const double b = host[c];
        bad += !std::isfinite(a) || !std::isfinite(b);
        differences.push_back(a == b ? 0.0 : std::abs(a - b) / std::max(std::abs(b), k.Floor));
        distinct.insert(values[4 * i + c]);
      }
    }
    CheckEqual(std::string(k.Name) + ": values that are not finite", bad, 0);
    std::sort(differences.begin(), differences.end());
    const size_t others = static_cast<size_t>(k.Share * static_cast<double>(differences.size()));
    CheckAtMost(std::string(k.Name) + ": worst difference",
      differences[differences.size() - 1 - others], k.Tolerance, k.Origin);
    CheckAtLeast(
      std::string(k.Name) + ": distinct values", distinct.size(), 2, "the test's own power");
  }
  target.Release(window);
  kernel.Release(window);
  texture->ReleaseGraphicsResources(window);
}

VTK_INDIRECT_TEST(StagesLink)
{
  Scene scene(32, 32);
  scene.AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, glm::dvec3(0.5));
  scene.AddDirectional({ 0, 0, -1 });
  scene.SetEye({ 0.5, 0.5, 2 }, { 0.5, 0.5, 0 }, { 0, 1, 0 }, 40, 0.1, 10);
  scene.Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(scene.Window);
  window->MakeCurrent();
  int linked = 0;
  std::set<std::string> used;
  const char* const gathers[] = { "vtkIndirectGatherVirtualLights.glsl",
    "vtkIndirectGatherNeighborhood.glsl" };
  const char* const lights = "#define VTKI_LIGHTS 2\n"
                             "#define VTKI_ADD_IRRADIANCE bounce += "
                             "vtkiFetchCoarse(vtkiLights[0], position) * vtkiUnits[0];\n"
                             "#define VTKI_ADD_RADIANCE radiance += specular * "
                             "textureLod(vtkiLights[1], place, 0.0f).rgb * scale;\n"
                             "#define VTKI_ADD_OPEN open += "
                             "textureLod(vtkiOpenLights[0], place, 0.0f).rgb * vtkiUnits[0];\n"
                             "#define VTKI_CATCHES\n#define VTKI_CATCHERS\n"
                             "#define VTKI_SPECULAR\n";
  for (const vtkIndirectShaderTableEntry* entry = vtkIndirectShaderTable; entry->Name; ++entry)
  {
    const std::string name = entry->Name;
    const std::string text = entry->Text;
    // The capture's files are parts of mappers' shaders, which the frame above has linked. Points,
    // splats and visible lamps have their own vertex stages; the tests of both kinds of splatting
    // and Contract.VisibleLamp* link them.
    const bool stage = name.size() > 7 && name.substr(name.size() - 7) == "FS.glsl" &&
      name.find("vtkIndirectCapture") != 0 && name.find("PointFS") == std::string::npos &&
      name != "vtkIndirectLampFS.glsl" && name != "vtkIndirectSplatFS.glsl" &&
      name != "vtkIndirectProxySplatFS.glsl";
    if (!stage)
    {
      continue;
    }
    const bool open = text.find("#include VTKI_GATHER") != std::string::npos;
    const bool adds = text.find("vtkIndirectAddedLight.glsl") != std::string::npos;
    for (int i = 0; i < (open || adds ? 2 : 1); ++i)
    {
      vtkIndirectFullScreenProgram kernel(nullptr, entry->Name, gathers[i]);
      kernel.SetDefinitions(adds && i == 1 ? lights : "");
      Check(name + (open ? std::string(" with ") + gathers[i] : "") + " links",
        kernel.Use(window) != nullptr);
      ++linked;
      kernel.Release(window);
    }
  }
  CheckAtLeast("programs", linked, 9, "glsl/stage");
  CheckAtLeast("mappers' shaders that the capture built",
    scene.Copy("direct").Mean() + scene.Copy("rsm0.density").Mean(), 0.1,
    "something was drawn by them");
}
