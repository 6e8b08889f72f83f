// SPDX-License-Identifier: BSD-3-Clause
// Lists of lights for specular subsplats: their limit, their errors, and their savings.
#include "Gather/vtkIndirectGlossyRoom.h"
#include "Sums/vtkIndirectSum.h"
#include "vtkIndirectDetails.h"
#include "vtkIndirectForcedPath.h"

#include "OpenGL/vtkIndirectComputeProgram.h"
#include "vtkActorCollection.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRenderWindow.h"

#include <cstdio>
#include <cstdlib>

using namespace vtkIndirectTest;

namespace
{
using Splatter = vtkMultiresolutionSplattingPass;

struct ListedRoom : GlossyRoom
{
  ListedRoom(int width, int height, double power)
    : GlossyRoom(width, height, 0.7, power)
  {
    SET_DETAIL(this->Splatting, HalfFloats, false);
  }

  vtkNew<Splatter> Splatting;

  Image Splat()
  {
    this->Pass->SetEstimator(this->Splatting);
    this->Render();
    return this->Copy("glossy");
  }
  Image GatherAll()
  {
    this->Pass->SetEstimator(this->Gather);
    this->Render();
    return this->Copy("glossy");
  }
};

/** The report's text about the lists. */
std::string GetLists(Scene& scene)
{
  const std::string report = scene.Pass->GetReport();
  const size_t at = report.find("lists of specular subsplats");
  return at == std::string::npos ? "" : report.substr(at, 240);
}

/** Evaluations over pixels times lights; negative without lists. */
double GetShare(Scene& scene)
{
  const std::string text = GetLists(scene);
  const std::string before = "pixels times lights: ";
  const size_t at = text.find(before);
  return at == std::string::npos ? -1.0 : std::atof(text.c_str() + at + before.size());
}

double RootMeanSquare(const Image& a, const Image& b)
{
  double sum = 0.0;
  for (size_t i = 0; i < a.Values.size(); ++i)
  {
    const double d = static_cast<double>(a.Values[i]) - b.Values[i];
    sum += d * d;
  }
  return std::sqrt(sum / static_cast<double>(a.Values.size()));
}

double Mean(const Image& image)
{
  return (image.Mean(0) + image.Mean(1) + image.Mean(2)) / 3.0;
}

void RequireLists(Scene& scene)
{
  scene.Render();
  scene.Window->MakeCurrent();
  if (!vtkIndirectComputeProgram::IsSupported())
  {
    Skip("OpenGL 4.3 is needed for lists");
  }
}
}

// With an unreachable threshold every light is resolved at every pixel, through all levels:
// residuals and interpolations cancel. With a threshold of zero the gather itself is used.
VTK_INDIRECT_TEST(ListsConverge)
{
  for (double power : { 1.0, 25.0, 128.0 })
  {
    ListedRoom scene(131, 97, power);
    scene.AddPoint({ 0.9, 0.1, 1.2 }, { 1, 0, 1 });
    RequireLists(scene);
    const Image exact = scene.GatherAll();
    const double brightest = Largest(exact);
    const std::string what = "power " + std::to_string(static_cast<int>(power)) + ": ";
    CheckAtLeast(what + "brightest", brightest, 1e-2, "the test's own power");
    for (bool half : { false, true })
    {
      SET_DETAIL(scene.Splatting, HalfFloats, half);
      SET_DETAIL(scene.Splatting, GlossyThreshold, 1e-9);
      const Image listed = scene.Splat();
      const std::string storage = half ? "half floats, " : "32-bit floats, ";
      CheckAtMost(what + storage + "threshold 1e-9: worst difference over the brightest",
        Difference(listed, exact) / brightest, half ? 3e-3 : 6e-5,
        half ? "2^-10 where drivers cut bits off, once a level of three"
             : "the order of sums: 4.4e-5");
      CheckAtLeast(what + storage + "evaluations over pixels times lights", GetShare(scene), 0.2,
        "they came from lists");
      SET_DETAIL(scene.Splatting, GlossyThreshold, 0.0);
      CheckAtMost(what + storage + "threshold 0: worst difference over the brightest",
        Difference(scene.Splat(), exact) / brightest, half ? 2e-3 : 1e-5,
        half ? "2^-10, once for diffuse light and once for lobes" : "the same sum");
      CheckEqual(what + storage + "lists at threshold 0", GetShare(scene), -1.0);
    }
    scene.CheckBuffers(2);
  }
}

// A light that its depth map hides from a pixel is hidden from lists too.
VTK_INDIRECT_TEST(ListsHidden)
{
  ListedRoom scene(131, 97, 25.0);
  scene.AddQuad({ 0.2, 0.2, 0.1 }, { 0.2, 0.8, 0.1 }, { 0.2, 0.2, 0.6 }, glm::dvec3(0.5));
  RequireLists(scene);
  const Image open = scene.GatherAll();
  scene.Pass->SetVisibilityToMaps();
  const Image exact = scene.GatherAll();
  const double without = RootMeanSquare(open, exact);
  CheckAtLeast(
    "what maps change, over the mean", without / Mean(exact), 0.1, "the test's own power");
  SET_DETAIL(scene.Splatting, GlossyThreshold, 1e-9);
  CheckAtMost("threshold 1e-9: RMSE over what maps change",
    RootMeanSquare(scene.Splat(), exact) / without, 0.02,
    "rounding moves a receiver past the edge of a texel");
  CheckAtLeast(
    "evaluations over pixels times lights", GetShare(scene), 0.2, "they came from lists");
  SET_DETAIL(scene.Splatting, GlossyThreshold, 0.02);
  CheckAtMost("at the default threshold: RMSE of the mean",
    RootMeanSquare(scene.Splat(), exact) / Mean(exact), 0.05, "as without maps, in ListsThreshold");
}

VTK_INDIRECT_TEST(ListsThreshold)
{
  for (double power : { 3.0, 25.0, 128.0 })
  {
    ListedRoom scene(320, 240, power);
    scene.Sampler->SetNumberOfLights(256);
    RequireLists(scene);
    const Image exact = scene.GatherAll();
    double lastError = 1e30;
    double lastShare = 0.0;
    const std::string what = "power " + std::to_string(static_cast<int>(power)) + ": ";
    for (double threshold : { 0.5, 0.1, 0.02, 0.004 })
    {
      SET_DETAIL(scene.Splatting, GlossyThreshold, threshold);
      const Image listed = scene.Splat();
      const double error = RootMeanSquare(listed, exact) / Mean(exact);
      const double share = GetShare(scene);
      char text[64];
      std::snprintf(text, sizeof(text), "threshold %g: ", threshold);
      std::printf("       %s%sRMSE of the mean %.4f, evaluations %.3f of all\n", what.c_str(), text,
        error, share);
      CheckAtMost(what + text + "RMSE over that of the next coarser", error / lastError, 1.02,
        "a lower threshold lowers the error, but where there is none to speak of");
      CheckAtLeast(what + text + "evaluations over those of the next coarser",
        share / std::max(lastShare, 1e-9), 1.0, "and resolves more");
      lastError = error;
      lastShare = share;
      if (threshold == 0.02)
      {
        CheckAtMost(what + "RMSE of the mean at the default", error, 0.05, "measured");
        CheckAtMost(what + "evaluations at the default, over pixels times lights", share, 1.0,
          "they save something");
      }
    }
  }
}

// The finest level bounds how far lights are resolved, as for diffuse light: blocks of 4 x 4 pixels
// make the same picture but for the sharpest highlights, by fewer evaluations.
VTK_INDIRECT_TEST(ListsFinestLevel)
{
  for (double power : { 3.0, 25.0, 128.0 })
  {
    ListedRoom scene(320, 240, power);
    scene.Sampler->SetNumberOfLights(256);
    RequireLists(scene);
    const Image exact = scene.GatherAll();
    scene.Splat();
    const double all = GetShare(scene);
    scene.Splatting->SetFinestLevelToQuarterResolution();
    const Image coarse = scene.Splat();
    const std::string what = "power " + std::to_string(static_cast<int>(power)) + ": ";
    CheckAtMost(what + "RMSE of the mean", RootMeanSquare(coarse, exact) / Mean(exact),
      power < 100.0 ? 0.4 : 1.0, "measured: 0.25, 0.34 and 0.89");
    CheckRelative(what + "mean", Mean(coarse), Mean(exact), 0.02, "measured: 0.011 at most");
    CheckAtMost(what + "evaluations over those down to pixels", GetShare(scene) / all, 0.3,
      "measured: 0.24 at most");
  }
}

// Contexts before OpenGL 4.3 have no lists, and use the setting without them.
VTK_INDIRECT_TEST(ListsFallBack)
{
  ListedRoom scene(64, 48, 25.0);
  const Image exact = scene.GatherAll();
  {
    const vtkIndirectForcedPath path("compute=off");
    CheckAtMost("without compute shaders: worst difference to the gather over the brightest",
      Difference(scene.Splat(), exact) / Largest(exact), 1e-5, "the same sum");
    Check("the report says that all lights are summed, and why",
      GetLists(scene).find("because lists need compute shaders") != std::string::npos,
      GetLists(scene));
  }
  RequireLists(scene);
  scene.Splatting->Modified();
  scene.Splat();
  CheckAtLeast("evaluations from lists", GetShare(scene), 1e-3, "there are lists");
}

VTK_INDIRECT_TEST(ListsStrength)
{
  for (const bool half : { false, true })
  {
    ListedRoom scene(96, 72, 25.0);
    RequireLists(scene);
    scene.AddDirectional({ -0.8, 0.1, -0.5 });
    SET_DETAIL(scene.Splatting, HalfFloats, half);
    const Image unit = scene.Splat();
    CheckAtLeast("brightest", Largest(unit), 1e-2, "the test's own power");
    for (double intensity : { 1e-12, 1e12 })
    {
      scene.SetIntensities(intensity);
      Image scaled = scene.Splat();
      scene.CheckBuffers(2);
      for (float& value : scaled.Values)
      {
        value = static_cast<float>(value / intensity);
      }
      char what[80];
      std::snprintf(what, sizeof(what), "strength %g, %s floats: RMS difference over the brightest",
        intensity, half ? "half" : "32-bit");
      // Rounding may decide on a light at the threshold.
      CheckAtMost(what, RootMeanSquare(scaled, unit) / Largest(unit), half ? 1e-3 : 1e-5,
        half ? "roundings of 2^-11 on each level" : "rounding");
    }
  }
}

// A mirror-like sheet in front of a floor with another lobe, whose highlight ends at the sheet's
// edge: the light of one must not appear on the other, whose sum in double precision is exactly
// zero.
VTK_INDIRECT_TEST(ListsDepthEdge)
{
  double worst = 0.0;
  int dark = 0;
  int lit = 0;
  for (int number = 0; number < 12; ++number)
  {
    Random random(2300 + static_cast<std::uint64_t>(number));
    Scene scene(160 + 7 * number, 120);
    RequireLists(scene);
    // The sheets' sender lies below them and beside the view, and lights only the floor.
    scene.AddQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, { 0, 0, 0 });
    const glm::dvec3 sender(1.3, -1.5, 0.5);
    scene.AddQuad(sender, sender + glm::dvec3(0, 3, 0), sender + glm::dvec3(2, 0, 0),
      glm::dvec3(0.9)); // faces -z
    for (int i = 0; i < 8; ++i)
    {
      const glm::dvec3 at(random.Next(-1, 0.7), random.Next(-1, 0.7), random.Next(0.6, 1.0));
      scene.AddQuad(at, at + glm::dvec3(random.NextMagnitude(0.02, 0.5), 0, 0),
        at + glm::dvec3(0, random.NextMagnitude(0.02, 0.5), 0), glm::dvec3(0.1));
    }
    auto* actors = scene.Renderer->GetActors();
    actors->InitTraversal();
    const double power = random.NextMagnitude(1.0, 60.0);
    while (vtkActor* actor = actors->GetNextActor())
    {
      actor->GetProperty()->SetSpecular(0.8);
      actor->GetProperty()->SetSpecularPower(power);
      actor->GetProperty()->SetSpecularColor(1.0, 1.0, 1.0);
    }
    scene.AddSpot({ 2.3, 0, -1.5 }, { 2.3, 0, 0.5 }, 24, 0, { 1, 0, 0 });
    const glm::dvec3 target(0.0, 0.0, 0.5);
    scene.SetEye(target + glm::dvec3(-2.4, random.Next(-0.4, 0.4), random.Next(0.7, 1.2)), target,
      { 0, 0, 1 }, random.Next(25, 45), 0.3, 10);
    scene.Sampler->SetNumberOfLights(64);
    scene.Gather->SetModeToVirtualLights();
    scene.Gather->InterpolationOff();
    scene.Render();
    const Image exact = scene.Copy("glossy");
    vtkNew<Splatter> splatting;
    SET_DETAIL(splatting, HalfFloats, false);
    SET_DETAIL(splatting, GlossyThreshold, number % 2 ? 0.02 : 0.5);
    scene.Pass->SetEstimator(splatting);
    scene.Render();
    const Image listed = scene.Copy("glossy");
    CheckAtLeast("evaluations from lists", GetShare(scene), 1e-4, "there are lists");
    const double brightest = Largest(exact);
    CheckAtLeast("brightest", brightest, 1e-3, "the test's own power");
    for (size_t i = 0; i < exact.Values.size(); ++i)
    {
      if (exact.Values[i] > 0.05 * brightest)
      {
        ++lit;
      }
      else if (exact.Values[i] == 0.0f)
      {
        ++dark;
        worst = std::max(worst, listed.Values[i] / brightest);
      }
    }
  }
  CheckAtLeast("values in highlights", lit, 5000, "the test's own power");
  CheckAtLeast("dark values", dark, 5000, "the test's own power");
  CheckAtMost("largest value where the gather has none, over the brightest", worst, 1e-6,
    "nothing crosses an edge");
}

VTK_INDIRECT_TEST(ListsRelease)
{
  ListedRoom scene(64, 48, 25.0);
  RequireLists(scene);
  scene.Splat();
  const size_t with = vtkIndirectSum::Get(scene.Splatting).GetBytes();
  scene.Splatting->SpecularTransportOff();
  scene.Splat();
  const size_t without = vtkIndirectSum::Get(scene.Splatting).GetBytes();
  CheckAtLeast("bytes of lists, levels and glossy light", static_cast<double>(with - without),
    64 * 48 * 16.0, "the glossy light alone is as many");
  const Image first = scene.Copy("final");
  for (int i = 0; i < 100; ++i)
  {
    scene.Splatting->SetSpecularTransport(i % 2 == 0);
    scene.Render();
    CheckAtMost("bytes", static_cast<double>(vtkIndirectSum::Get(scene.Splatting).GetBytes()),
      static_cast<double>(i % 2 == 0 ? with : without), "as often as it is switched");
  }
  CheckEqual("the picture without, after switching", Difference(scene.Copy("final"), first), 0.0);
  scene.Splatting->SpecularTransportOn();
  const Image listed = scene.Splat();
  scene.Splatting->ReleaseGraphicsResources(scene.Window);
  CheckEqual("bytes after release",
    static_cast<double>(vtkIndirectSum::Get(scene.Splatting).GetBytes()), 0.0);
  scene.Pass->CachingOff();
  CheckEqual("rendered again", Difference(scene.Splat(), listed), 0.0);
}
