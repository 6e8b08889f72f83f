// SPDX-License-Identifier: BSD-3-Clause
// Forced choices (VTK_INDIRECT_PATHS) take effect, and make the same frame.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectDetails.h"

#if __has_include("vtk_glad.h")
#include "vtk_glad.h"
#else
#include "vtk_glew.h"
#endif

#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <map>

using namespace contract;

namespace
{
void Force(const std::string& paths)
{
  paths.empty() ? unsetenv("VTK_INDIRECT_PATHS") : setenv("VTK_INDIRECT_PATHS", paths.c_str(), 1);
}

using Estimators = std::vector<std::pair<std::string, vtkSmartPointer<vtkIndirectEstimatorPass>>>;

Estimators MakeEstimators()
{
  vtkNew<vtkRadianceHintsPass> hints;
  hints->SetGridResolution(6, 5, 6);
  SET_DETAIL(hints, NumberOfRays, 32);
  return { { "gather", vtkSmartPointer<vtkRSMGatherPass>::New() },
    { "multiresolution", vtkSmartPointer<vtkMultiresolutionSplattingPass>::New() },
    { "hints", hints } };
}

// A room with three lights and a ball, with Phong's specular term in scenes that are not all
// opaque.
struct ChoicesView : View
{
  vtkNew<vtkIndirectIlluminationPass> Pass;

  ChoicesView(vtkIndirectEstimatorPass* estimator, bool specular)
    : View(120, 90)
  {
    AddRoomSurfaces(this->Renderer);
    auto ball = MakeSphere({ 0.7, 0.25, 0.5 }, 0.15, { 0.9, 0.7, 0.3 });
    ball->GetProperty()->SetSpecular(specular ? 0.5 : 0.0);
    ball->GetProperty()->SetSpecularPower(20.0);
    this->Renderer->AddActor(ball);
    this->Renderer->AddLight(MakeLight(LightKind::Spot, { 0.5, 0.9, 0.8 }, { 0.5, 0.0, 0.4 }));
    this->Renderer->AddLight(MakeLight(LightKind::Point, { 0.2, 0.8, 0.8 }, { 0.5, 0.0, 0.4 }));
    this->Renderer->AddLight(
      MakeLight(LightKind::Directional, { 0.6, 0.9, 2.0 }, { 0.4, 0.1, 0.0 }));
    this->Pass->SetReflectiveShadowMapResolution(64);
    this->Pass->SetNumberOfBounces(2);
    this->Pass->SetEstimator(estimator);
    this->Renderer->SetPass(this->Pass);
  }
  ~ChoicesView() { this->Pass->SetEstimator(nullptr); }
};

struct Frame
{
  Pixels Image;
  std::vector<float> Depth;
  std::map<std::string, Floats> Buffers;
};

Frame Render(vtkIndirectEstimatorPass* estimator, bool specular, Report* report = nullptr,
  const std::function<void(vtkRenderWindow*)>& look = {})
{
  ChoicesView view(estimator, specular);
  // The second frame may keep results of the first.
  view.Grab();
  view.Renderer->GetActiveCamera()->Azimuth(1.0);
  view.Renderer->ResetCameraClippingRange();
  Frame frame;
  frame.Image = view.Grab();
  frame.Depth = GrabDepth(view.Window);
  for (const char* name : { "direct", "irradiance", "glossy", "final", "depth", "albedo" })
  {
    frame.Buffers[name] = Read(view.Pass, name);
  }
  if (report)
  {
    *report = Report(view.Pass);
  }
  if (look)
  {
    view.Window->MakeCurrent();
    look(view.Window);
  }
  return frame;
}

// Compares the buffers of two frames. Sums of 256 terms in rows, and of 128 rows, in another order,
// or with other operations fused, differ by at most 512 roundings of 32-bit floats; multiresolution
// splatting then rounds to the 11 bits of half floats. At a threshold (interpolated or summed,
// split or not) a pixel may get its neighbour's kind of value: few pixels do, with small
// differences.
void CheckSame(const Frame& frame, const Frame& usual, const std::string& where)
{
  const double rounding = where.find("multiresolution") != std::string::npos ? std::ldexp(1.0, -10)
                                                                             : std::ldexp(1.0, -15);
  std::cout << where << ":";
  for (const auto& named : usual.Buffers)
  {
    const Floats& expected = named.second;
    const Floats& found = frame.Buffers.at(named.first);
    CONTRACT_CHECK(found.Values.size() == expected.Values.size(), where << ": " << named.first);
    double scale = 0.0;
    for (const float value : expected.Values)
    {
      scale = std::max(scale, std::abs(static_cast<double>(value)));
    }
    int beyond = 0;
    for (size_t i = 0; i < std::min(found.Values.size(), expected.Values.size()); ++i)
    {
      const double d = std::abs(static_cast<double>(found.Values[i]) - expected.Values[i]);
      beyond += d <= rounding * scale ? 0 : 1;
    }
    const Difference difference = Compare(found, expected);
    std::cout << " " << named.first << " " << difference.Max / std::max(scale, 1e-30);
    const double share = static_cast<double>(beyond) / static_cast<double>(expected.Values.size());
    CONTRACT_CHECK(share <= 0.002 && difference.Max <= 0.1 * scale,
      where << ": " << named.first << " " << difference << ", share beyond rounding " << share);
  }
  // A step of a depth buffer of 24 bits, and the rounding of a float near one.
  double depth = frame.Depth.size() == usual.Depth.size() ? 0.0 : 1.0;
  for (size_t i = 0; i < std::min(frame.Depth.size(), usual.Depth.size()); ++i)
  {
    depth = std::max(depth, std::abs(static_cast<double>(frame.Depth[i]) - usual.Depth[i]));
  }
  std::cout << " depth of the window " << depth << "\n";
  CONTRACT_CHECK(depth <= std::ldexp(2.0, -24), where << ": depth of the window " << depth);
}

// Names and values, from the error that lists them.
std::map<std::string, std::vector<std::string>> FindChoices()
{
  ExpectedErrors errors;
  Force("nothing=so");
  Render(vtkNew<vtkRSMGatherPass>(), false);
  Force("");
  std::map<std::string, std::vector<std::string>> paths;
  const std::string& said = errors.GetText();
  for (size_t at = said.find("There are "); at != std::string::npos; at = said.find("; ", at))
  {
    at += said.compare(at, 2, "; ") == 0 ? 2 : std::string("There are ").size();
    const size_t equals = said.find('=', at);
    const size_t bar = said.find('|', at);
    const size_t end = said.find(' ', bar);
    paths[said.substr(at, equals - at)] = { said.substr(equals + 1, bar - equals - 1),
      said.substr(bar + 1, end - bar - 1) };
  }
  return paths;
}

// Number of occurrences of a text in the sources of the context's programs that keep them.
int CountInSources(const std::string& text)
{
  int found = 0;
  for (GLuint program = 1; program < 4000; ++program)
  {
    GLuint shaders[8];
    GLsizei count = 0;
    if (glIsProgram(program))
    {
      glGetAttachedShaders(program, 8, &count, shaders);
    }
    for (GLsizei i = 0; i < count; ++i)
    {
      GLint length = 0;
      glGetShaderiv(shaders[i], GL_SHADER_SOURCE_LENGTH, &length);
      std::string source(static_cast<size_t>(length), '\0');
      glGetShaderSource(shaders[i], length, nullptr, &source[0]);
      found += source.find(text) != std::string::npos ? 1 : 0;
    }
  }
  return found;
}

// Number of the context's compute programs with this many invocations in a row of a group; 0: any.
int CountComputePrograms(int invocations)
{
  int found = 0;
#ifdef GL_COMPUTE_WORK_GROUP_SIZE
  // Newer VTKs have OpenGL report each error, and these are expected.
  const GLboolean reports = glIsEnabled(GL_DEBUG_OUTPUT);
  glDisable(GL_DEBUG_OUTPUT);
  glGetError();
  for (GLuint program = 1; program < 4000; ++program)
  {
    GLint size[3] = { 0, 0, 0 };
    if (glIsProgram(program))
    {
      // Programs of other kinds cause an error and leave it unset.
      glGetProgramiv(program, GL_COMPUTE_WORK_GROUP_SIZE, size);
      glGetError();
    }
    found += size[0] > 0 && (invocations == 0 || size[0] == invocations) ? 1 : 0;
  }
  if (reports)
  {
    glEnable(GL_DEBUG_OUTPUT);
  }
#else
  (void)invocations;
#endif
  return found;
}
}

//------------------------------------------------------------------------------
// Each value of each name makes the default's frame.
VTK_INDIRECT_TEST(ChoicesSame)
{
  const auto paths = FindChoices();
  CONTRACT_CHECK(paths.size() >= 4, paths.size());
  for (const bool specular : { false, true })
  {
    for (const auto& entry : MakeEstimators())
    {
      if (specular && entry.first == "hints")
      {
        continue; // these estimators have no specular light
      }
      Force("");
      const Frame usual = Render(entry.second, specular);
      for (const auto& path : paths)
      {
        for (const std::string& value : path.second)
        {
          const std::string forced = path.first + "=" + value;
          if (forced == "compute=off" && specular && entry.first == "multiresolution")
          {
            continue; // without lists all lights are summed at specular pixels: ListsFallBack
          }
          Force(forced);
          Report report{ std::string() };
          const Frame frame = Render(entry.second, specular, &report);
          const std::string where = forced + ", " + entry.first + (specular ? ", specular" : "");
          CONTRACT_CHECK(report.Get("paths." + path.first) == value, where << report.GetText());
          CheckSame(frame, usual, where);
        }
      }
    }
  }
  Force("");
}

//------------------------------------------------------------------------------
// A forced choice is the one that runs.
VTK_INDIRECT_TEST(ChoicesTake)
{
  struct Row
  {
    const char* Forced;
    int Estimator; // index in MakeEstimators
    bool Specular;
    const char* Text; // text in the sources
    bool Expected;
  };
  const Estimators estimators = MakeEstimators();
  for (const Row& row : { Row{ "depth=copy", 0, false, "#define VTKI_DEPTH_COPIED", true },
         Row{ "depth=draw", 0, false, "#define VTKI_DEPTH_COPIED", false },
         Row{ "uniforms=flat", 0, false, "flat in vec3 vtkiFlat_", true },
         Row{ "uniforms=flat", 1, false, "flat in ivec2 vtkiFlat_", true },
         Row{ "uniforms=flat, depth=draw", 2, false, "flat in ivec2 vtkiFlat_", true },
         Row{ "uniforms=plain", 0, false, "vtkiFlat_", false },
         Row{ "uniforms=plain", 1, false, "vtkiFlat_", false },
         Row{ "depth=draw,uniforms=plain", 2, false, "vtkiFlat_", false } })
  {
    Force(row.Forced);
    auto look = [&row](vtkRenderWindow*)
    {
      const int found = CountInSources(row.Text);
      CONTRACT_CHECK((found > 0) == row.Expected,
        row.Forced << ", " << row.Estimator << ": " << found << " times " << row.Text);
    };
    Render(estimators[row.Estimator].second, row.Specular, nullptr, look);
  }
  for (const bool four : { false, true })
  {
    Force(four ? "grouping=four" : "grouping=two");
    auto look = [four](vtkRenderWindow*)
    {
      if (CountComputePrograms(0) == 0)
      {
        std::cout << "No compute programs: grouping is not tried\n";
        return;
      }
      CONTRACT_CHECK(CountComputePrograms(16) == (four ? 2 : 0), "four in a group of 64");
      CONTRACT_CHECK(CountComputePrograms(32) == (four ? 0 : 2), "two in a group of 64");
    };
    Render(estimators[1].second, false, nullptr, look);
  }
  Force("");
}

//------------------------------------------------------------------------------
// An unknown name is one error, which lists the known ones, and the frame is drawn as without it.
VTK_INDIRECT_TEST(ChoicesErrors)
{
  vtkNew<vtkRSMGatherPass> gather;
  Report usual{ std::string() };
  const Frame frame = Render(gather, false, &usual);
  for (const char* wrong : { "nothing=so", "depth", "depth=", "depth=both", "=draw", "draw",
         "depth=draw,uniforms=plane", "depth=draw;uniforms=plain", "Depth=draw" })
  {
    ExpectedErrors errors;
    Force(wrong);
    Report report{ std::string() };
    const Frame same = Render(gather, false, &report);
    if (wrong == std::string("nothing=so"))
    {
      Render(gather, false, &report); // repeats no message
    }
    CONTRACT_CHECK(errors.GetCount() == 1, wrong << ": " << errors.GetText());
    CONTRACT_CHECK(errors.GetText().find("depth=copy|draw") != std::string::npos, errors.GetText());
    CONTRACT_CHECK(Compare(frame.Image, same.Image).Max == 0.0, wrong);
    for (const char* name : { "compute", "depth", "uniforms" })
    {
      const std::string path = "paths." + std::string(name);
      CONTRACT_CHECK(
        !report.Get(path).empty() && report.Get(path) == usual.Get(path), wrong << path);
    }
  }
  for (const char* empty : { "", ",", " " })
  {
    setenv("VTK_INDIRECT_PATHS", empty, 1);
    CONTRACT_CHECK(Compare(frame.Image, Render(gather, false).Image).Max == 0.0, empty);
  }
  Force("");
}

// As OpenGL 3.2: set in the environment.
VTK_INDIRECT_TEST(ChoicesOpenGL32)
{
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  Report report{ std::string() };
  int version[2] = { 0, 0 };
  auto look = [&version](vtkRenderWindow*)
  {
    glGetIntegerv(GL_MAJOR_VERSION, &version[0]);
    glGetIntegerv(GL_MINOR_VERSION, &version[1]);
  };
  const Frame usual = Render(splatting, false, &report, look);
  if (version[0] != 3 || version[1] != 2)
  {
    Skip("the driver does not heed MESA_GL_VERSION_OVERRIDE");
  }
  CONTRACT_CHECK(report.Has("paths.depth") && !report.Has("paths.grouping"), report.GetText());
  CONTRACT_CHECK(report.Get("paths.compute") == "off", report.GetText());
  for (const char* forced : { "uniforms=flat", "uniforms=plain", "depth=draw" })
  {
    Force(forced);
    const Difference difference = Compare(usual.Image, Render(splatting, false).Image);
    CONTRACT_CHECK(difference.Max <= 1.0, forced << ": " << difference);
  }
  for (const char* forced : { "grouping=two", "uniforms=plain,grouping=four", "compute=on" })
  {
    ExpectedErrors errors;
    Force(forced);
    const Difference difference = Compare(usual.Image, Render(splatting, false, &report).Image);
    CONTRACT_CHECK(difference.Max == 0.0, forced << ": " << difference);
    CONTRACT_CHECK(errors.GetCount() == 1, forced << ": " << errors.GetText());
    CONTRACT_CHECK(errors.GetText().find("OpenGL 4.3") != std::string::npos, errors.GetText());
  }
  Force("");
}
