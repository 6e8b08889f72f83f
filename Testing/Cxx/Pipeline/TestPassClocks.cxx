// SPDX-License-Identifier: BSD-3-Clause
// Times of stages by the GPU's clock, if OpenGL has one.
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

using namespace contract;

//------------------------------------------------------------------------------
namespace
{
// Checks a frame of each estimator, with stages by both clocks; expected: the GPU has one.
void CheckClocks(bool expected)
{
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkRadianceHintsPass> hints;
  // Only the stages matter, not their results.
  hints->SetGridResolution(6, 5, 6);
  SET_DETAIL(hints, NumberOfRays, 16);
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  for (vtkIndirectEstimatorPass* estimator :
    std::initializer_list<vtkIndirectEstimatorPass*>{ gather, hints, splatting })
  {
    View view(80, 60);
    AddRoom(view.Renderer);
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->SetEstimator(estimator);
    if (estimator == splatting)
    {
      // The voxels begin and end the stage of visibility, within the frame.
      pass->SetVisibilityToVoxels();
    }
    pass->SetNumberOfBounces(2);
    pass->CachingOff();
    pass->TimingOn();
    view.Renderer->SetPass(pass);
    for (int i = 0; i < 3; ++i)
    {
      view.Grab();
    }
    const Report report(pass);
    double sum = 0.0;
    int stages = 0;
    for (const char* stage : { "rsm", "geometry", "lights", "visibility", "inject", "bounces",
           "estimate", "upsample", "composite" })
    {
      const std::string name = "stages." + std::string(stage);
      if (!report.Has(name + ".median_ms"))
      {
        continue;
      }
      ++stages;
      CONTRACT_CHECK(report.Has(name + ".gpu_median_ms") == expected, report.GetText());
      CONTRACT_CHECK(report.Has(name + ".gpu_p95_ms") == expected, report.GetText());
      if (expected)
      {
        const double median = report.GetNumber(name + ".gpu_median_ms");
        CONTRACT_CHECK(median >= 0.0, report.GetText());
        CONTRACT_CHECK(report.GetNumber(name + ".gpu_p95_ms") >= median, report.GetText());
        sum += median;
      }
    }
    CONTRACT_CHECK(stages >= 5, report.GetText());
    CONTRACT_CHECK(report.Has("gpu_frame_ms") == expected, report.GetText());
    CONTRACT_CHECK(report.Has("gpu_indirect_ms") == expected, report.GetText());
    if (expected)
    {
      const double frame = report.GetNumber("gpu_frame_ms");
      std::cout << estimator->GetClassName() << ": stages " << sum << " ms, frame " << frame
                << " ms by the GPU's clock, " << report.Get("frame_ms") << " ms by the wall's\n";
      CONTRACT_CHECK(sum > 0.0, report.GetText());
      // Readers may compare them: no duration decides a test.
      CONTRACT_CHECK(frame > 0.0 && report.GetNumber("gpu_indirect_ms") > 0.0, report.GetText());
    }
  }
}

// VTK's mappers and its FXAA time themselves, too: compare only queries of the pass.
int CountQueries(vtkRenderWindow* window)
{
  window->MakeCurrent();
  int count = 0;
  for (GLuint i = 1; i < 4000; ++i)
  {
    count += glIsQuery(i) ? 1 : 0;
  }
  return count;
}

// The version of OpenGL in these tests.
struct Version
{
  int Major = 0;
  int Minor = 0;
  bool HasQueries = false;

  Version()
  {
    View view(8, 8);
    view.Grab();
    glGetIntegerv(GL_MAJOR_VERSION, &this->Major);
    glGetIntegerv(GL_MINOR_VERSION, &this->Minor);
    const char* capabilities = view.Window->ReportCapabilities();
    this->HasQueries = this->Major > 3 || (this->Major == 3 && this->Minor >= 3) ||
      std::string(capabilities ? capabilities : "").find("GL_ARB_timer_query") != std::string::npos;
  }
};
}

// With timer queries stages have times by the GPU's clock, too.
VTK_INDIRECT_TEST(ReportClocks)
{
  CheckClocks(Version().HasQueries);
}

// As OpenGL 3.2, with and without the extension: set in the environment.
VTK_INDIRECT_TEST(ReportClocksOpenGL32)
{
  const Version version;
  if (version.Major != 3 || version.Minor != 2)
  {
    Skip("the driver does not heed MESA_GL_VERSION_OVERRIDE");
  }
  CheckClocks(version.HasQueries);
}
VTK_INDIRECT_TEST(ReportClocksNone)
{
  const Version version;
  if (version.HasQueries)
  {
    Skip("the driver does not heed MESA_GL_VERSION_OVERRIDE and MESA_EXTENSION_OVERRIDE");
  }
  CheckClocks(false);
}

//------------------------------------------------------------------------------
// Timer queries, two for each stage and the frame, are made once and released with the pass, with
// its destruction, and with the end of its context.
VTK_INDIRECT_TEST(ReleaseQueries)
{
  auto hasQueries = [](vtkIndirectIlluminationPass* pass)
  { return pass->GetReport().find("gpu_frame_ms") != std::string::npos; };
  View view(80, 60);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->TimingOn();
  pass->CachingOff();
  view.Renderer->SetPass(pass);
  view.Grab();
  if (!hasQueries(pass))
  {
    Skip("this OpenGL has no timer queries");
  }
  const int during = CountQueries(view.Window);
  view.Grab();
  CONTRACT_CHECK(CountQueries(view.Window) == during, "another frame makes other queries");
  pass->ReleaseGraphicsResources(view.Window);
  const int after = CountQueries(view.Window);
  std::cout << during << " queries in a frame, " << after << " after it\n";
  CONTRACT_CHECK(during == after + 16, "seven stages and the frame");

  // Nor after the end of the context.
  view.Grab();
  view.Window->Finalize();
  CONTRACT_CHECK(hasQueries(pass), "times are forgotten with the context");
  view.Grab();
  CONTRACT_CHECK(CountQueries(view.Window) == during, "in the next context");

  // Another window has them, while this window has none left.
  View other(80, 60);
  AddRoom(other.Renderer);
  view.Renderer->SetPass(nullptr);
  other.Renderer->SetPass(pass);
  other.Grab();
  CONTRACT_CHECK(CountQueries(other.Window) == during, "in the other window");
  CONTRACT_CHECK(CountQueries(view.Window) == after, "left behind in the first window");

  // A pass that is destroyed.
  {
    vtkNew<vtkIndirectIlluminationPass> shorter;
    shorter->TimingOn();
    view.Renderer->SetPass(shorter);
    view.Grab();
    CONTRACT_CHECK(CountQueries(view.Window) > after, "no queries");
    view.Renderer->SetPass(nullptr);
  }
  CONTRACT_CHECK(CountQueries(view.Window) == after, "left behind by a pass that is destroyed");
}
