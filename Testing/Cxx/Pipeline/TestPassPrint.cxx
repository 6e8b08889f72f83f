// SPDX-License-Identifier: BSD-3-Clause
// Classes print their settings.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkImportanceLightSampler.h"
#include "vtkIndirectSplattingPass.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkOpaquePass.h"
#include "vtkProxyAccumulationPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkRandomWalkLightSampler.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <set>

using namespace contract;

namespace
{
// Lines of an object's printed text, without their indentation.
std::set<std::string> GetLines(vtkObject* object)
{
  std::ostringstream os;
  object->Print(os);
  std::set<std::string> lines;
  std::istringstream text(os.str());
  for (std::string line; std::getline(text, line);)
  {
    lines.insert(line.substr(std::min(line.find_first_not_of(' '), line.size())));
  }
  return lines;
}

void CheckLine(vtkObject* object, const std::string& line, bool expected)
{
  CONTRACT_CHECK((GetLines(object).count(line) == 1) == expected,
    object->GetClassName() << ": '" << line << (expected ? "' is not" : "' is") << " printed");
}

// Sets a property to a value that is not its default: the line appears only afterwards.
#define CHECK_PRINT(object, property, value, text)                                                 \
  do                                                                                               \
  {                                                                                                \
    CheckLine(object, #property ": " text, false);                                                 \
    (object)->Set##property(value);                                                                \
    CheckLine(object, #property ": " text, true);                                                  \
  } while (false)
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(PrintSettings)
{
  vtkNew<vtkIndirectIlluminationPass> pass;
  CHECK_PRINT(pass, Lighting, vtkIndirectIlluminationPass::STUDIO, "Studio");
  CHECK_PRINT(pass, Shadows, false, "Off");
  CHECK_PRINT(pass, Antialiasing, false, "Off");
  CHECK_PRINT(pass, ReflectiveShadowMapResolution, 77, "77");
  CHECK_PRINT(pass, NumberOfBounces, 3, "3");
  CHECK_PRINT(pass, IndirectScale, 0.5, "0.5");
  CHECK_PRINT(pass, ErrorTolerance, 0.125, "0.125");
  CHECK_PRINT(pass, Caching, false, "Off");
  CHECK_PRINT(pass, MapsFirst, true, "On");
  CHECK_PRINT(pass, NumberOfRefinements, 2, "2");
  CHECK_PRINT(pass, TimeBudget, 2.5, "2.5");
  CHECK_PRINT(pass, IdleFrames, false, "Off");
  CHECK_PRINT(pass, SpheresInMotion, false, "Off");
  CHECK_PRINT(pass, RemainingGeometry, false, "Off");
  CHECK_PRINT(pass, DebugView, "normal", "\"normal\"");
  CHECK_PRINT(pass, Timing, true, "On");
  for (const char* name : { "Estimator", "Sampler" })
  {
    CheckLine(pass, std::string(name) + ": 0 (automatic)", true);
  }
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkUniformLightSampler> sampler;
  vtkNew<vtkOpaquePass> delegate;
  pass->SetEstimator(gather);
  pass->SetSampler(sampler);
  pass->SetDelegatePass(delegate);
  auto at = [](const char* name, const void* object)
  {
    std::ostringstream os;
    os << name << ": " << object;
    return os.str();
  };
  CheckLine(pass, at("Estimator", gather.Get()), true);
  CheckLine(pass, at("Sampler", sampler.Get()), true);
  CheckLine(pass, at("DelegatePass", delegate.Get()), true);

  CheckLine(gather, "MethodName: gather", true);
  CHECK_PRINT(gather, SpecularTransport, false, "Off");
  CHECK_PRINT(gather, OccupancyResolution, 33, "33");
  CHECK_PRINT(gather, Mode, vtkRSMGatherPass::NEIGHBORHOOD, "Neighborhood");
  CHECK_PRINT(gather, NumberOfSamples, 7, "7");
  CHECK_PRINT(gather, NeighborhoodRadius, 0.75, "0.75");
  CHECK_PRINT(gather, Interpolation, false, "Off");
  CHECK_PRINT(gather, InterpolationStep, 6, "6");

  CHECK_PRINT(sampler, Pattern, vtkUniformLightSampler::JITTERED, "Jittered");
  CHECK_PRINT(sampler, NumberOfLights, 33, "33");
  CHECK_PRINT(sampler, LitTexels, false, "Off");
  CHECK_PRINT(sampler, AmbientOcclusion, true, "On");
  vtkNew<vtkImportanceLightSampler> importance;
  CHECK_PRINT(importance, NumberOfLights, 34, "34");
  CHECK_PRINT(importance, Warping, vtkImportanceLightSampler::TOGETHER, "Together");
  CHECK_PRINT(importance, Levels, 3, "3");
  CHECK_PRINT(importance, Evenness, 0.5, "0.5");
  CHECK_PRINT(importance, Occlusion, 0.25, "0.25");

  vtkNew<vtkIndirectSplattingPass> splats;
  CheckLine(splats, "MethodName: splatting", true);
  CHECK_PRINT(splats, IntensityThreshold, 0.125, "0.125");
  CHECK_PRINT(splats, FarField, false, "Off");
  CHECK_PRINT(splats, FarFieldStep, 12, "12");

  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  CheckLine(splatting, "MethodName: multiresolution", true);
  CHECK_PRINT(splatting, Preset, 1, "Paper");
  CHECK_PRINT(splatting, FinestLevel, 1, "HalfResolution");
  CHECK_PRINT(splatting, FormFactor, 1, "Point");
  CHECK_PRINT(splatting, PlaneThreshold, 0.75, "0.75");
  CHECK_PRINT(splatting, DepthThreshold, 0.5, "0.5");
  CHECK_PRINT(splatting, NormalThreshold, 0.375, "0.375");
  CHECK_PRINT(splatting, SurfaceDetail, 0.5, "0.5");

  vtkNew<vtkProxyAccumulationPass> proxies;
  CHECK_PRINT(proxies, Upsampling, 2, "Bilinear");

  vtkNew<vtkRadianceHintsPass> hints;
  CheckLine(hints, "MethodName: hints", true);
  CHECK_PRINT(hints, Preset, 1, "Paper");
  CHECK_PRINT(hints, Order, 3, "3");
  CHECK_PRINT(hints, Extent, 1, "View");
  CheckLine(hints, "GridResolution: 3 4 5", false);
  hints->SetGridResolution(3, 4, 5);
  CheckLine(hints, "GridResolution: 3 4 5", true);
  CHECK_PRINT(hints, NumberOfGrids, 2, "2");
  CHECK_PRINT(hints, FineGridExtent, 0.75, "0.75");
  CHECK_PRINT(hints, NumberOfSamples, 41, "41");
  CHECK_PRINT(hints, DepthOcclusion, true, "On");
  CHECK_PRINT(hints, InterpolationStep, 6, "6");
  CHECK_PRINT(hints, TemporalSmoothing, 0.5, "0.5");

  vtkNew<vtkRSMReferencePass> reference;
  CheckLine(reference, "MethodName: reference", true);
  CHECK_PRINT(reference, Mode, 1, "VirtualLights");
  CHECK_PRINT(reference, Visibility, vtkRSMReferencePass::EXACT, "Exact");
  vtkNew<vtkRandomWalkLightSampler> walk;
  CHECK_PRINT(walk, NumberOfLights, 77, "77");
  CHECK_PRINT(walk, NumberOfVertices, 78, "78");
  CHECK_PRINT(walk, FirstBounce, 2, "2");
  vtkNew<vtkReflectiveShadowMapPass> maps;
  CHECK_PRINT(maps, Resolution, 77, "77");
  pass->SetDelegatePass(nullptr);
  pass->SetSampler(nullptr);
  pass->SetEstimator(nullptr);
}

//------------------------------------------------------------------------------
// Counters and sizes of a known frame.
VTK_INDIRECT_TEST(PrintCounters)
{
  View view(80, 60);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkUniformLightSampler> sampler;
  pass->SetEstimator(gather);
  pass->SetSampler(sampler);
  pass->SetNumberOfBounces(1); // a walk adds lights of its own
  sampler->SetNumberOfLights(33);
  view.Renderer->SetPass(pass);
  CONTRACT_CHECK(Report(pass).GetNumber("virtual_lights") == 0, "virtual lights before a frame");
  CheckLine(gather, "Size: 0 x 0, 0 bytes", true);
  view.Grab();
  view.Grab();
  CONTRACT_CHECK(CountOf(pass, "estimates") == 1, "estimates");
  CheckLine(pass->GetReflectiveShadowMaps(), "NumberOfMaps: 1", true);
  CONTRACT_CHECK(CountOf(pass, "faces_drawn") == 1, "faces drawn");
  CONTRACT_CHECK(Report(pass).GetNumber("virtual_lights") == 33, "virtual lights");
  CheckLine(gather, "Size: 80 x 60, 76800 bytes", true); // 16 bytes a pixel
  vtkNew<vtkRadianceHintsPass> hints;
  pass->SetEstimator(hints);
  view.Grab();
  CONTRACT_CHECK(CountOf(pass, "hint_updates") == 1, "hint updates");
  CONTRACT_CHECK(CountOf(pass, "voxel_updates") == 1, "voxel updates");
  CONTRACT_CHECK(CountOf(pass, "estimates") == 2, "estimates");
}

//------------------------------------------------------------------------------
// With Timing on every stage of a frame has a time, without it none.
VTK_INDIRECT_TEST(ReportStages)
{
  View view(80, 60);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  vtkNew<vtkRSMGatherPass> gather;
  pass->SetEstimator(gather);
  view.Renderer->SetPass(pass);
  view.Grab();
  const Report untimed(pass);
  CONTRACT_CHECK(untimed.GetNumber("frames") == 0, untimed.Get("frames"));
  CONTRACT_CHECK(untimed.GetNumber("stages") == 0, untimed.GetText());
  CONTRACT_CHECK(untimed.Get("frame_ms") == "null", untimed.Get("frame_ms"));
  pass->TimingOn();
  pass->CachingOff();
  for (int i = 0; i < 3; ++i)
  {
    view.Window->Render();
  }
  const Report report(pass);
  CONTRACT_CHECK(report.GetNumber("frames") == 3, report.Get("frames"));
  for (const char* stage : { "rsm", "geometry", "lights", "estimate", "upsample", "composite" })
  {
    const std::string name = "stages." + std::string(stage);
    const double median = report.GetNumber(name + ".median_ms");
    CONTRACT_CHECK(median > 0.0, "no time of " << stage << " in " << report.GetText());
    CONTRACT_CHECK(report.GetNumber(name + ".p95_ms") >= median, report.GetText());
  }
  // Times of a whole frame; their length decides nothing.
  CONTRACT_CHECK(report.GetNumber("indirect_ms") > 0.0, report.Get("indirect_ms"));
  CONTRACT_CHECK(report.GetNumber("frame_ms") > 0.0, report.Get("frame_ms"));
}
