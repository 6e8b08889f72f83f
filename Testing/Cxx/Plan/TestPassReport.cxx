// SPDX-License-Identifier: BSD-3-Clause
// The report, against the settings in force.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectDetails.h"

#include "vtkLightTreeSampler.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkPropCollection.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <locale>
#include <tuple>

using namespace contract;

namespace
{
// A room with a given estimator, and its report after a frame.
struct ReportView : View
{
  vtkNew<vtkIndirectIlluminationPass> Pass;

  explicit ReportView(vtkIndirectEstimatorPass* estimator)
    : View(60, 40)
  {
    AddRoom(this->Renderer);
    this->Pass->SetReflectiveShadowMapResolution(64);
    this->Pass->SetEstimator(estimator);
    this->Renderer->SetPass(this->Pass);
  }
  ~ReportView() { this->Pass->SetEstimator(nullptr); }

  Report Render()
  {
    this->Grab();
    return Report(this->Pass);
  }
};
}

//------------------------------------------------------------------------------
// The tests' own reader accepts only valid JSON.
VTK_INDIRECT_TEST(ReportReader)
{
  for (const char* good : { "{}", "[]", "{\"a\": [1, -0.5e-7, 0], \"b\": null}", " true ",
         "\"\\u001f\\n\"", "\"\xc3\xa4\"" })
  {
    CONTRACT_CHECK(Report(std::string(good)).IsValid(), good);
  }
  for (const char* bad : { "", "{", "{\"a\": 0,5}", "{\"a\": 1.}", "{\"a\": .5}", "01", "+1", "nan",
         "1.024.000", "\"\n\"", "\"\\x\"", "\"\xe4\"", "\"\xc0\xaf\"", "[1,]", "{} {}" })
  {
    CONTRACT_CHECK(!Report(std::string(bad)).IsValid(), bad);
  }
  const Report report(std::string("{\"a\": {\"b\": [1, 2.5]}, \"c\": \"\\\"x\\u0001\"}"));
  CONTRACT_CHECK(report.GetNumber("a.b.1") == 2.5, report.Get("a.b.1"));
  CONTRACT_CHECK(report.Get("c") == "\"x\1", report.Get("c"));
  CONTRACT_CHECK(std::isnan(report.GetNumber("c")), "a text is no number");
}

//------------------------------------------------------------------------------
// Names of the inputs that make a frame's light new: why a frame computes it again.
VTK_INDIRECT_TEST(ReportSaysWhatChanged)
{
  vtkNew<vtkRSMGatherPass> gather;
  ReportView view(gather);
  view.Render();
  const Report still = view.Render();
  CONTRACT_CHECK(still.Has("changed") && !still.Has("changed.0"), still.Get("changed"));
  view.Renderer->GetActiveCamera()->Azimuth(1.0);
  const Report turned = view.Render();
  CONTRACT_CHECK(turned.Get("changed.0") == "eye" && !turned.Has("changed.1"), "the eye alone");
  vtkProp* const prop = view.Renderer->GetViewProps()->GetLastProp();
  vtkActor::SafeDownCast(prop)->GetProperty()->SetColor(0.2, 0.3, 0.4);
  const Report colored = view.Render();
  CONTRACT_CHECK(
    colored.Get("changed.0") == "props" && !colored.Has("changed.1"), "the props alone");
}

//------------------------------------------------------------------------------
// A grid has as many hints as its property says, which is clamped to the possible range.
VTK_INDIRECT_TEST(ReportGrid)
{
  View view(60, 40);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkRadianceHintsPass> hints;
  pass->SetEstimator(hints);
  view.Renderer->SetPass(pass);
  struct Row
  {
    int Set[3];
    int Expected[3];
  };
  for (const Row& row :
    { Row{ { 5000, 5000, 5000 }, { 64, 64, 64 } }, Row{ { -3, 1, 1 }, { 0, 1, 1 } },
      Row{ { 64, 2, -1 }, { 64, 2, 0 } }, Row{ { 3, 4, 5 }, { 3, 4, 5 } } })
  {
    hints->SetGridResolution(row.Set[0], row.Set[1], row.Set[2]);
    const int* found = hints->GetGridResolution();
    CONTRACT_CHECK(std::equal(found, found + 3, row.Expected),
      row.Set[0] << ": " << found[0] << " " << found[1] << " " << found[2]);
  }
  const vtkMTimeType before = hints->GetMTime();
  hints->SetGridResolution(hints->GetGridResolution());
  CONTRACT_CHECK(hints->GetMTime() == before, "nothing has changed");
  view.Grab();
  CONTRACT_CHECK(hints->GetNumberOfHints() == 60, hints->GetNumberOfHints() << " hints");
  const std::string grid = Report(pass).FindReason("modelled", "8 diffuse bounces");
  CONTRACT_CHECK(grid.find("3 x 4 x 5") != std::string::npos, grid);
}

//------------------------------------------------------------------------------
// The report tells the ErrorTolerance in force, and whether the estimator ignores it or uses
// another one.
VTK_INDIRECT_TEST(ReportTolerance)
{
  const std::string value = "settings.ErrorTolerance";
  const std::string asked = "ErrorTolerance 0.02";
  {
    vtkNew<vtkRadianceHintsPass> hints;
    SET_DETAIL(hints, NumberOfRays, 16); // hints are counted, not used
    ReportView view(hints);
    // Hints along the longest axis: sqrt(12 / tolerance); the room is a cube.
    auto check = [&](double pass, double expected, int along)
    {
      view.Pass->SetErrorTolerance(pass);
      const Report report = view.Render();
      CONTRACT_CHECK(report.GetNumber(value) == expected,
        pass << ": " << report.Get(value) << " for " << expected);
      CONTRACT_CHECK(hints->GetNumberOfHints() == along * along * along,
        pass << ": " << hints->GetNumberOfHints() << " hints");
      // If the tolerance is in force, the report lists what it does not cover; otherwise that it is
      // not in force.
      const std::string reason =
        report.FindReason("left_out", pass == 0.02 ? asked : "ErrorTolerance 0.1");
      CONTRACT_CHECK(reason.empty() == (pass == 0.0), report.GetText());
      CONTRACT_CHECK(
        (reason.find("nearer light") != std::string::npos) == (pass > 0.0 && pass == expected),
        reason);
    };
    check(0.0, 0.05, 16);
    check(0.1, 0.1, 11);
    check(0.02, 0.02, 25);
    hints->SetGridResolution(3, 3, 3);
    check(0.02, 0.0, 3);
  }
  {
    vtkNew<vtkRSMGatherPass> gather;
    ReportView view(gather);
    CONTRACT_CHECK(view.Render().FindReason("left_out", asked).empty(), "nothing was asked for");
    view.Pass->SetErrorTolerance(0.02);
    const Report report = view.Render();
    CONTRACT_CHECK(report.GetNumber(value) == 0.0, report.Get(value));
    CONTRACT_CHECK(!report.FindReason("left_out", asked).empty(), report.GetText());
  }
}

//------------------------------------------------------------------------------
// A threshold set by the user stays, independent of the tolerance and of its value: the frame
// equals one with the other thresholds set by hand.
VTK_INDIRECT_TEST(ToleranceKeepsThresholds)
{
  // Levels of the subsplats, and the report; only nonnegative thresholds are set.
  using Pass = vtkMultiresolutionSplattingPass;
  auto render =
    [&](double tolerance, double lighting, double plane, double normal, double depth = -1.0)
  {
    vtkNew<Pass> splatting;
    ReportView view(splatting);
    SET_DETAIL(splatting, LightingThreshold, lighting);
    if (depth >= 0.0)
    {
      splatting->SetPresetToPaper();
      splatting->SetDepthThreshold(depth);
    }
    if (plane >= 0.0)
    {
      splatting->SetPlaneThreshold(plane);
    }
    if (normal >= 0.0)
    {
      splatting->SetNormalThreshold(normal);
    }
    view.Pass->SetErrorTolerance(tolerance);
    view.Pass->SetNumberOfRefinements(0);
    // a tree's branches, and lights of paths, depend on the tolerance, too
    vtkNew<vtkUniformLightSampler> even;
    view.Pass->SetSampler(even);
    view.Pass->SetNumberOfBounces(1);
    view.Grab();
    const Report report(view.Pass);
    return std::make_tuple(Read(view.Pass, "subsplat.level"),
      report.GetNumber("settings.ErrorTolerance"),
      report.FindReason("left_out", "ErrorTolerance 0.04"));
  };
  auto levels = [](const auto& rendered) { return std::get<0>(rendered); };
  constexpr double standard = 0.0015;
  const auto defaults = render(0.0, standard, -1.0, -1.0);
  // Twice the standard tolerance doubles the thresholds that are not set.
  const auto byHand = render(0.0, 2.0 * standard, 0.5, 0.4);
  CONTRACT_CHECK(Compare(levels(defaults), levels(byHand)).Max > 0.0, "the test's own power");
  const auto scaled = render(0.04, standard, -1.0, -1.0);
  CONTRACT_CHECK(Compare(levels(byHand), levels(scaled)).Max == 0.0, "all are scaled");
  CONTRACT_CHECK(std::get<1>(scaled) == 0.04, "in force");
  const auto finer = render(0.0, 2.0 * standard, 0.01, 0.4);
  CONTRACT_CHECK(Compare(levels(byHand), levels(finer)).Max > 0.0, "the test's own power");
  const auto own = render(0.04, standard, 0.01, -1.0);
  CONTRACT_CHECK(Compare(levels(finer), levels(own)).Max == 0.0, "one is the user's");
  CONTRACT_CHECK(std::get<2>(own).find("PlaneThreshold") != std::string::npos, std::get<2>(own));
  // Also if the user's value is the default.
  const auto usual = render(0.0, 2.0 * standard, 0.25, 0.4);
  CONTRACT_CHECK(Compare(levels(byHand), levels(usual)).Max > 0.0, "the test's own power");
  const auto kept = render(0.04, standard, 0.25, -1.0);
  CONTRACT_CHECK(Compare(levels(usual), levels(kept)).Max == 0.0, "the default, set by the user");
  // The paper's refinement ignores the lighting.
  const auto paper = render(0.0, standard, -1.0, 0.1, 0.01);
  const auto all = render(0.04, standard, -1.0, 0.1, 0.01);
  CONTRACT_CHECK(Compare(levels(paper), levels(all)).Max == 0.0, "all are the user's");
  CONTRACT_CHECK(std::get<1>(all) == 0.0, "not in force");
}

//------------------------------------------------------------------------------
// Predictable memory: a grid of hints, and the triangles for their rays.
VTK_INDIRECT_TEST(ReportMemory)
{
  View view(32, 16);
  vtkRenderer* renderer = view.Renderer;
  // Squares of the sides of a unit cube: 2 n^2 triangles each.
  constexpr int n = 4;
  renderer->AddActor(MakeQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0.8, 0.8, 0.8 }, n));
  renderer->AddActor(MakeQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.8, 0.8, 0.8 }, n));
  renderer->AddLight(MakeLight(LightKind::Spot, { 0.8, 0.5, 0.8 }, { 0, 0.5, 0 }));
  renderer->ResetCamera();
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkRadianceHintsPass> hints;
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkUniformLightSampler> sampler;
  pass->SetReflectiveShadowMapResolution(16);
  pass->SetSampler(sampler);
  pass->SetEstimator(hints);
  renderer->SetPass(pass);
  hints->SetOccupancyResolution(16);
  SET_DETAIL(hints, SkipEmptyCells, false);
  double memory[2];
  for (int more = 0; more < 2; ++more)
  {
    hints->SetGridResolution(8, 8, more ? 16 : 8);
    view.Grab();
    memory[more] = Report(pass).GetNumber("main_memory_bytes");
  }
  // 512 additional hints: 16 bytes each for position and albedo, 4 for each of 400 rays; and a few
  // surfaces of 40 bytes that only their rays have met.
  const double hint = 512.0 * (16 + 16 + 4 * 400);
  std::cout << memory[0] << ", 512 hints more: " << memory[1] - memory[0] << " for " << hint
            << "\n";
  CONTRACT_CHECK(std::abs(memory[1] - memory[0] - hint) < 0.01 * hint, "hints");

  // More triangles in the same place.
  auto* fine = vtkActor::SafeDownCast(renderer->GetViewProps()->GetItemAsObject(0));
  auto refine = [&](int resolution)
  {
    vtkNew<vtkPlaneSource> source;
    source->SetResolution(resolution, resolution);
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputConnection(source->GetOutputPort());
    fine->SetPosition(0.5, 0.5, 0.0);
    fine->SetMapper(mapper);
    view.Grab();
    return Report(pass).GetNumber("main_memory_bytes");
  };
  const double triangles = refine(200) - refine(100);
  // A triangle has 72 bytes of corners in the tree, 16 of numbers and half a point of 24 in the
  // list.
  const double least = 2.0 * (200 * 200 - 100 * 100) * (72 + 16 + 12);
  // A node has 128 bytes and four children; a leaf has a triangle or more.
  const double most = least + 2.0 * (200 * 200 - 100 * 100) * 128 / 3;
  std::cout << "60000 triangles more: " << triangles << " of " << least << " to " << most << "\n";
  CONTRACT_CHECK(triangles >= least && triangles < 1.01 * most, "triangles");

  // Textures and main memory are counted separately: all texels of a map of 16 x 16 are 256 lights
  // of 48 bytes and 16 of their pattern; the gather adds an irradiance of 16 bytes a pixel.
  pass->SetEstimator(gather);
  pass->SetVisibilityToNone(); // tests of maps cover depth maps
  pass->SetNumberOfBounces(1); // paths would add their own memory
  sampler->LitTexelsOff();     // sums over texels would add theirs
  gather->SetModeToVirtualLights();
  gather->InterpolationOff();
  sampler->SetNumberOfLights(256);
  view.Grab();
  const Report lights(pass);
  gather->SetModeToAllTexels();
  view.Grab();
  const Report texels(pass);
  CONTRACT_CHECK(texels.GetNumber("virtual_lights") == 256, texels.Get("virtual_lights"));
  CONTRACT_CHECK(texels.GetNumber("bytes") == lights.GetNumber("bytes"),
    texels.Get("bytes") << " for " << lights.Get("bytes"));
  sampler->SetNumberOfLights(512);
  gather->SetModeToVirtualLights();
  view.Grab();
  const double more = Report(pass).GetNumber("bytes") - lights.GetNumber("bytes");
  CONTRACT_CHECK(more == 256 * (48 + 16), more << " for 256 lights more");
  CONTRACT_CHECK(lights.GetNumber("main_memory_bytes") == 0.0, lights.Get("main_memory_bytes"));
  // A tree over the texels is kept in main memory.
  vtkNew<vtkLightTreeSampler> tree;
  pass->SetSampler(tree);
  view.Grab();
  CONTRACT_CHECK(Report(pass).GetNumber("main_memory_bytes") > 0.0, "the light tree");
}

//------------------------------------------------------------------------------
namespace
{
// A decimal comma, and points between thousands.
struct German : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

// Reports, shaders and buffers equal those of the C locale.
void CheckInLocale()
{
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  vtkNew<vtkRadianceHintsPass> hints;
  SET_DETAIL(hints, NumberOfRays, 16);
  for (vtkIndirectEstimatorPass* estimator :
    std::initializer_list<vtkIndirectEstimatorPass*>{ splatting, hints })
  {
    ReportView view(estimator);
    view.Pass->TimingOn();
    view.Pass->SetIndirectScale(1e-7);
    view.Pass->SetErrorTolerance(0.0123456789);
    // the error of a tree's lights is not estimated
    vtkNew<vtkUniformLightSampler> even;
    view.Pass->SetSampler(even);
    view.Pass->SetNumberOfBounces(1);
    const Report report = view.Render();
    CONTRACT_CHECK(
      report.GetNumber("settings.IndirectScale") == 1e-7, report.Get("settings.IndirectScale"));
    CONTRACT_CHECK(report.GetNumber("settings.ErrorTolerance") == 0.0123456789,
      report.Get("settings.ErrorTolerance"));
    CONTRACT_CHECK(
      report.GetNumber("stages.geometry.median_ms") > 0.0, report.Get("stages.geometry.median_ms"));
    CONTRACT_CHECK(report.GetNumber("bytes") > 1e4, report.Get("bytes"));
    CONTRACT_CHECK(Mean(Read(view.Pass, "irradiance"), 0) > 1e-3, "no indirect light");
    if (estimator == splatting.Get())
    {
      CONTRACT_CHECK(
        !report.FindReason("modelled", "ErrorTolerance 0.0123456789").empty(), report.GetText());
    }
    const Report whole(view.Pass->GetReport());
    CONTRACT_CHECK(whole.GetNumber("estimated_error") > 0.0, whole.Get("estimated_error"));
  }
}
}

VTK_INDIRECT_TEST(ReportLocaleOfStreams)
{
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new German));
  std::ostringstream probe;
  probe << 1234.5;
  CONTRACT_CHECK(probe.str() == "1.234,5", probe.str());
  CheckInLocale();
  std::locale::global(before);
}

VTK_INDIRECT_TEST(ReportLocaleOfC)
{
  // Compiled from Debian's package locales if the system has none, in the build tree, independent
  // of the current folder.
  const std::string folder = VTK_INDIRECT_TEST_FOLDER "/locales";
  const std::string make = "mkdir -p '" + folder +
    "' && localedef --no-archive -f UTF-8 -i de_DE '" + folder + "/de_DE.UTF-8' >/dev/null 2>&1";
  if (!std::setlocale(LC_ALL, "de_DE.UTF-8"))
  {
    const bool made = std::system(make.c_str()) == 0;
#ifndef _WIN32
    setenv("LOCPATH", folder.c_str(), 1);
#endif
    if (!made || !std::setlocale(LC_ALL, "de_DE.UTF-8"))
    {
      Skip("this system has no locale de_DE.UTF-8, and localedef makes none");
    }
  }
  char probe[16];
  std::snprintf(probe, sizeof(probe), "%.1f", 0.5);
  CONTRACT_CHECK(std::string(probe) == "0,5", probe);
  CheckInLocale();
  std::setlocale(LC_ALL, "C");
}

//------------------------------------------------------------------------------
namespace
{
// An opaque prop with invalid bounds, which the report leaves out by its class name.
class BadName : public vtkActor
{
public:
  static BadName* New() { return new BadName; }
  double* GetBounds() override
  {
    for (double& bound : this->Bad)
    {
      bound = NAN;
    }
    return this->Bad;
  }
  vtkTypeBool HasOpaqueGeometry() override { return 1; }
  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }

protected:
  const char* GetClassNameInternal() const override
  {
    return "a\"\\\x01\x7f \xc3\xa4 \xe4 \xed\xa0\x80 \xf0\x9f\x98\x80 \xc3";
  }
  double Bad[6];
};
}

// The report is JSON for any bytes in a name, and keeps valid UTF-8.
VTK_INDIRECT_TEST(ReportStrings)
{
  vtkNew<vtkRSMGatherPass> gather;
  ReportView view(gather);
  vtkNew<BadName> actor;
  view.Renderer->AddViewProp(actor);
  const Report report = view.Render();
  bool found = false;
  for (int i = 0; report.Has("left_out." + std::to_string(i)); ++i)
  {
    const std::string name = report.Get("left_out." + std::to_string(i) + ".what");
    // One replacement for each byte that begins no character: a single one, three of a surrogate, a
    // truncated one.
    found = found ||
      name ==
        "a\"\\\x01\x7f \xc3\xa4 \xef\xbf\xbd \xef\xbf\xbd\xef\xbf\xbd\xef\xbf\xbd \xf0\x9f\x98\x80 "
        "\xef\xbf\xbd";
  }
  CONTRACT_CHECK(found, report.GetText());
}
