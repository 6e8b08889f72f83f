// SPDX-License-Identifier: BSD-3-Clause
// The paper's own method against an independent evaluation of its equations in double precision:
// the field of a hint from its sampled texels (Eq. 1 to 4), further bounces from other hints (Eq. 8
// to 11) and the look-up at a pixel (Eq. 5 to 7). Only the selection of texels and hints is the
// shaders': that sequence of integers is no equation.
#include "vtkIndirectHintPaperRoom.h"

#include <algorithm>
#include <cstdio>

using namespace vtkIndirectTest;

VTK_INDIRECT_TEST(HintsPaperEquations)
{
  PaperRoom scene;
  CheckEqual("texels of all maps", scene.Texels.size(), Layers * MapEdge * MapEdge);
  for (int order : { 2, 3 })
  {
    scene.Hints->SetOrder(order);
    const std::string what = "order " + std::to_string(order) + ": ";
    std::vector<Field> first;
    std::vector<Field> fields;
    for (int bounces : { 1, 2, 3 })
    {
      scene.Pass->SetNumberOfBounces(bounces);
      scene.Render();
      const std::vector<vtkIndirectHintSum::Hint> hints = scene.ReadHints();
      CheckEqual(what + "hints", hints.size(), Grid[0] * Grid[1] * Grid[2]);
      std::vector<double> differences;
      std::vector<double> plain;
      int ambiguous = 0;
      const std::vector<Field> before = fields;
      for (size_t i = 0; i < hints.size(); ++i)
      {
        const int number = static_cast<int>(i);
        bool unclear = false;
        if (bounces == 1)
        {
          first.push_back(scene.Inject(hints[i], number, true));
          fields.push_back(first.back());
          plain.push_back(FindDifference(hints[i], scene.Inject(hints[i], number, false), order));
        }
        else
        {
          fields[i] = scene.Exchange(hints, first, before, number, order, unclear);
        }
        ambiguous += unclear;
        if (!unclear)
        {
          differences.push_back(FindDifference(hints[i], fields[i], order));
        }
      }
      const std::string which = what + std::to_string(bounces) + " bounces: ";
      CheckAtMost(which + "hints with a sample on a border", ambiguous, 2,
        "1e-5 of three times 32 samples each");
      CheckAtMost(which + "worst field, difference over its size", Percentile(differences, 1.0),
        1e-5, "42 terms in floats, each off by 2^-24 and by places' 2^-24 over r");
      if (bounces == 1)
      {
        // For a texel that nearly touches a hint the height changes more than cosine over r^2.
        CheckAtMost(which + "median field without the texels' own size, difference over its size",
          Percentile(plain, 0.5), 0.02, "measured");
        std::printf("       the same, worst: %.3g\n", Percentile(plain, 1.0));
      }
      const Image image = scene.Copy("irradiance");
      const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
      double worst = 0.0;
      for (size_t i = 0; i < receivers.size(); ++i)
      {
        const glm::dvec3 expected = scene.LookUp(fields, receivers[i], order);
        const glm::dvec3 shown(
          image.Values[3 * i], image.Values[3 * i + 1], image.Values[3 * i + 2]);
        worst = std::max(worst, glm::length(shown - expected) / glm::length(expected));
      }
      CheckAtLeast(which + "mean irradiance", image.Mean(), 1e-2, "the test's own power");
      CheckAtMost(which + "worst pixel, difference over its irradiance", worst, 1e-5,
        "four times eight terms in floats");
    }
  }
}

VTK_INDIRECT_TEST(HintsPaperOptions)
{
  // The paper's own ranges of its parameters, and its rotated look-ups, against the same equations.
  PaperRoom scene;
  scene.Samples = 70;
  scene.BounceSamples = 16;
  scene.Range = 0.4 * scene.Diagonal;
  scene.Rotation = true;
  scene.Hints->SetNumberOfSamples(scene.Samples);
  scene.Hints->SetNumberOfBounceSamples(scene.BounceSamples);
  scene.Hints->SetBounceRange(0.4);
  scene.Hints->LookupRotationOn();
  std::vector<Field> fields;
  for (int bounces : { 1, 2 })
  {
    scene.Pass->SetNumberOfBounces(bounces);
    scene.Render();
    const std::vector<vtkIndirectHintSum::Hint> hints = scene.ReadHints();
    Expected expected(scene, hints, fields);
    fields = expected.Fields;
    const std::string which = std::to_string(bounces) + " bounces: ";
    CheckAtMost(which + "worst field, difference over its size",
      Percentile(expected.Differences, 1.0), 1e-5, "as in HintsPaperEquations");
  }
  const Image image = scene.Copy("irradiance");
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  double worst = 0.0;
  double turned = 0.0;
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    const glm::dvec3 shown(image.Values[3 * i], image.Values[3 * i + 1], image.Values[3 * i + 2]);
    scene.Rotation = true;
    const glm::dvec3 wanted = scene.LookUp(fields, receivers[i], 2);
    worst = std::max(worst, glm::length(shown - wanted) / glm::length(wanted));
    scene.Rotation = false;
    const glm::dvec3 still = scene.LookUp(fields, receivers[i], 2);
    turned = std::max(turned, glm::length(still - wanted) / glm::length(wanted));
  }
  CheckAtMost(
    "worst pixel, difference over its irradiance", worst, 1e-5, "as in HintsPaperEquations");
  CheckAtLeast("the rotation, the same", turned, 1e-3, "the test's own power");
}

VTK_INDIRECT_TEST(HintsPaperGrids)
{
  // Two grids against the same equations: hints of the finer one place their samples in their own
  // cells and get later bounces from their own grid, and look-ups blend the two where the finer
  // grid ends within the room. A box stands in the finer grid.
  constexpr int hintsOfGrid = Grid[0] * Grid[1] * Grid[2];
  constexpr double extent = 0.5;
  const glm::dvec3 focus(2.3, 2.0, 0.5);
  PaperRoom scene;
  scene.AddBox({ 2.0, 1.7, 0.3 }, { 2.6, 2.2, 0.7 }, Albedo);
  scene.SetEye({ 0.8, 0.6, 1.5 }, focus, { 0, 0, 1 }, 50.0, 0.05, 10.0);
  scene.Pass->SetEstimator(scene.Gather);
  scene.Render();
  scene.Texels = scene.CopyLights();
  scene.Pass->SetEstimator(scene.Hints);
  scene.Hints->SetNumberOfGrids(2);
  scene.Hints->SetFineGridExtent(extent);
  // Shorter than either grid, so that cells decide which hints are near.
  scene.Range = 0.2 * scene.Diagonal;
  scene.Hints->SetBounceRange(0.2);
  // About the focal point, in steps of four cells.
  GridPlace finer;
  finer.First = hintsOfGrid;
  finer.Cell = extent * GetCell();
  finer.Lower =
    glm::floor((focus - 0.5 * extent * Extent) / (4.0 * finer.Cell) + 0.5) * (4.0 * finer.Cell);
  scene.Grids.push_back(finer);
  std::vector<Field> fields;
  for (int bounces : { 1, 2 })
  {
    scene.Pass->SetNumberOfBounces(bounces);
    scene.Render();
    const std::vector<vtkIndirectHintSum::Hint> hints = scene.ReadHints();
    CheckEqual("hints", hints.size(), 2 * hintsOfGrid);
    Expected expected(scene, hints, fields);
    fields = expected.Fields;
    double moved = 0.0;
    for (int i = 0; i < static_cast<int>(hints.size()); ++i)
    {
      const GridPlace& grid = scene.GetGridOf(i);
      const int inGrid = i - grid.First;
      const glm::dvec3 place = grid.Lower +
        grid.Cell *
          (glm::dvec3(inGrid % Grid[0], inGrid / Grid[0] % Grid[1], inGrid / (Grid[0] * Grid[1])) +
            0.5);
      moved = std::max(moved, glm::length(scene.GetPlace(hints[i]) - place));
    }
    const std::string which = std::to_string(bounces) + " bounces: ";
    CheckAtMost(which + "places of hints, in scene units", moved, 1e-6, "2^-24 of the room's 5");
    CheckAtMost(which + "hints with a sample on a border", expected.Ambiguous, 4,
      "as in HintsPaperEquations, for twice the hints");
    CheckAtMost(which + "worst field, difference over its size",
      Percentile(expected.Differences, 1.0), 1e-5, "as in HintsPaperEquations");

    const Image image = scene.Copy("irradiance");
    const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
    double worst = 0.0;
    double effect = 0.0;
    int pixels[2] = {}; // of the coarser grid alone, and of both
    for (size_t i = 0; i < receivers.size(); ++i)
    {
      const glm::dvec3 shown(image.Values[3 * i], image.Values[3 * i + 1], image.Values[3 * i + 2]);
      const glm::dvec3 wanted = scene.LookUp(fields, receivers[i], 2);
      worst =
        std::max(worst, glm::length(shown - wanted) / (glm::length(wanted) + 0.01 * image.Mean()));
      ++pixels[scene.FindFineShare(receivers[i].Position) > 0.0];
      scene.Grids.pop_back();
      const glm::dvec3 coarse = scene.LookUp(fields, receivers[i], 2);
      scene.Grids.push_back(finer);
      effect = std::max(effect, glm::length(coarse - wanted) / image.Mean());
    }
    CheckAtLeast(which + "pixels of the coarser grid", pixels[0], 100, "the test's own power");
    CheckAtLeast(which + "pixels where the finer one fades", pixels[1], 100, "as above");
    CheckAtLeast(which + "effect of the finer one on a pixel", effect, 0.02, "as above");
    CheckAtMost(which + "worst pixel, difference over its irradiance and 1 % of the mean", worst,
      1e-5, "as in HintsPaperEquations; where harmonics nearly cancel little is left of the terms");
  }
}

VTK_INDIRECT_TEST(HintsPaperDepth)
{
  // Section 8 with the values that a user gets: a screen in the room hides senders from hints.
  PaperRoom scene;
  scene.AddQuad({ 1.6, 0.9, 0.0 }, { 2.4, 1.5, 0.0 }, { 1.6, 0.9, 1.2 }, Albedo);
  scene.Pass->SetEstimator(scene.Gather);
  scene.Render();
  scene.Texels = scene.CopyLights();
  scene.Pass->SetEstimator(scene.Hints);
  scene.Pass->SetNumberOfBounces(1);
  scene.Hints->DepthOcclusionOn();
  scene.Render();
  const std::vector<vtkIndirectHintSum::Hint> hints = scene.ReadHints();
  std::vector<double> differences;
  std::vector<double> effect;
  for (size_t i = 0; i < hints.size(); ++i)
  {
    scene.DepthSamples = 0;
    effect.push_back(
      FindDifference(hints[i], scene.Inject(hints[i], static_cast<int>(i), true), 2));
    scene.FollowDepth();
    differences.push_back(
      FindDifference(hints[i], scene.Inject(hints[i], static_cast<int>(i), true), 2));
  }
  CheckAtMost("nine of ten fields, difference over their size", Percentile(differences, 0.9), 1e-5,
    "as in HintsPaperEquations; rounding decides whether points at a silhouette are hidden");
  CheckAtLeast("the effect on the median field, the same", Percentile(effect, 0.5), 0.02,
    "the test's own power");
}

VTK_INDIRECT_TEST(HintsPaperCoverage)
{
  // c_RSM: samples come from a square of that share of the map about the hint's own place in it.
  // Under a parallel light places in the map are linear in places of the floor.
  constexpr int edgeOfMap = 64;
  constexpr int count = 256;
  HintScene scene(40, 30);
  scene.AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, glm::dvec3(0.8));
  scene.AddQuad({ -2, 2, 0 }, { 2, 2, 0 }, { -2, 2, 1 }, glm::dvec3(0.8));
  scene.AddDirectional({ 0, 0, -1 });
  scene.SetEye({ 0, -3, 3 }, { 0, 0, 0 }, { 0, 0, 1 }, 60.0, 0.05, 20.0);
  scene.Pass->SetReflectiveShadowMapResolution(edgeOfMap);
  scene.Pass->SetEstimator(scene.Gather);
  scene.Gather->SetModeToAllTexels();
  scene.Render();
  const std::vector<VirtualLight> texels = scene.CopyLights();
  CheckEqual("texels", texels.size(), edgeOfMap * edgeOfMap);
  auto at = [&](int x, int y) { return glm::dvec2(texels[y * edgeOfMap + x].Position); };
  const glm::dvec2 first = at(8, 8);
  const glm::dmat2 toTexels =
    glm::inverse(glm::dmat2((at(56, 8) - first) / 48.0, (at(8, 56) - first) / 48.0));
  scene.Pass->SetEstimator(scene.Hints);
  scene.Hints->SetPresetToPaper();
  scene.Hints->SetGridResolution(3, 3, 2);
  scene.Hints->SetNumberOfSamples(count);
  const glm::dvec3 extent(4.0, 4.0, 1.0);
  const glm::dvec3 cell = extent / glm::dvec3(3.0, 3.0, 2.0);
  for (double coverage : { 0.1, 0.4, 1.0 })
  {
    scene.Hints->SetMapCoverage(coverage);
    scene.Render();
    const std::vector<vtkIndirectHintSum::Hint> hints = scene.ReadHints();
    CheckEqual("hints", hints.size(), 18);
    double worst = 0.0;
    for (size_t i = 0; i < hints.size(); ++i)
    {
      const glm::dvec3 place =
        glm::dvec3(hints[i].Position[0], hints[i].Position[1], hints[i].Position[2]) *
          glm::length(extent) +
        glm::dvec3(0.0, 0.0, 0.5);
      const glm::dvec2 own = (toTexels * (glm::dvec2(place) - first) + 8.5) / double(edgeOfMap);
      const double edge = std::sqrt(coverage);
      const glm::dvec2 corner =
        glm::clamp(own - 0.5 * edge, glm::dvec2(0.0), glm::dvec2(1.0 - edge));
      const auto seed = static_cast<std::uint32_t>(16 * i);
      Field field;
      for (int sample = 0; sample < count; ++sample)
      {
        const glm::dvec2 random(Spread(sample, seed));
        const glm::dvec2 texel =
          glm::min((corner + edge * random) * double(edgeOfMap), glm::dvec2(edgeOfMap - 1.0));
        const glm::dvec3 from = place + (Spread(sample, seed + 77777777u) - 0.5) * cell;
        AddTexel(field, texels[static_cast<int>(texel.y) * edgeOfMap + static_cast<int>(texel.x)],
          from, edgeOfMap * edgeOfMap * coverage / count, true);
      }
      worst = std::max(worst, FindDifference(hints[i], field, 2));
    }
    // A texel on the square's border may be its neighbour by rounding.
    CheckAtMost("coverage " + std::to_string(coverage) + ": worst field, difference over its size",
      worst, 0.02, "one of 256 texels, of four times the mean's light, may be its neighbour");
  }
}
