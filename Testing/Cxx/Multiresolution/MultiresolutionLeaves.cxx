// SPDX-License-Identifier: BSD-3-Clause
// The tree of subsplats: each lit pixel in one leaf, neighbouring leaves, the paper's refinement
// against its criterion on the CPU, and equal leaves by every renderer.
#include "vtkIndirectDetails.h"
#include "vtkIndirectForcedPath.h"
#include "vtkIndirectPyramidReader.h"
#include "vtkIndirectRandomFrame.h"

#include "OpenGL/vtkIndirectComputeProgram.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkRenderWindow.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

using namespace vtkIndirectTest;

namespace
{
using Pass = vtkMultiresolutionSplattingPass;

// A random frame, whose pyramid is read back.
struct LeafFrame : RandomFrame
{
  vtkNew<PyramidReader> Reader;

  LeafFrame(int number, const FrameSize& size)
    : RandomFrame(number, size, static_cast<FrameLight>(number % NumberOfFrameLights))
  {
    this->Sampler->SetNumberOfLights(32);
    this->Pass->SetReflectiveShadowMapResolution(64);
    this->Pass->SetEstimator(this->Reader);
    SET_DETAIL(this->Reader, CoarsestResolution, 8); // several levels in small images
  }
};

// Odd, prime, lines, single pixels.
const std::vector<FrameSize> LeafSizes = { { 97, 61 }, { 127, 89 }, { 131, 1 }, { 1, 67 }, { 1, 1 },
  { 2, 3 }, { 64, 64 }, { 101, 37 } };
}

VTK_INDIRECT_TEST(LeavesCoverOnce)
{
  // With all settings, each lit pixel lies in exactly one leaf, the one that subsplat.level shows;
  // and the lists of split texels contain each of them once.
  double lit = 0.0;
  int coarse = 0;
  int wrong = 0;
  int shown = 0;
  int listed = 0;
  for (int number = 0; number < 16; ++number)
  {
    LeafFrame scene(1000 + number, LeafSizes[number % LeafSizes.size()]);
    PyramidReader* const reader = scene.Reader;
    SET_DETAIL(reader, Balance, number % 3 != 0);
    SET_DETAIL(reader, DepthRange, number % 4 == 3);
    reader->SetFinestLevel(number % 5 == 4 ? Pass::HALF_RESOLUTION : Pass::FULL_RESOLUTION);
    scene.Render();
    const Image level = scene.Copy("subsplat.level");
    for (int y = 0; y < reader->Size[1]; ++y)
    {
      for (int x = 0; x < reader->Size[0]; ++x)
      {
        if (reader->IsLit(x, y))
        {
          const std::vector<int> leaves = reader->FindLeaves(x, y);
          wrong += leaves.size() != 1;
          shown += leaves.empty() || level.At(x, y)[0] != static_cast<float>(leaves[0]);
          coarse += !leaves.empty() && leaves[0] > 1;
          lit += 1.0;
        }
      }
    }
    for (size_t i = 0; i < reader->Levels.size(); ++i)
    {
      const PyramidReader::Level& of = reader->Levels[i];
      int split = 0;
      for (int texel = 0; texel < of.Width * of.Height; ++texel)
      {
        split += reader->IsSplit(static_cast<int>(i) + 1, texel % of.Width, texel / of.Width);
      }
      listed += of.NumberOfListed >= 0 && of.NumberOfListed != split;
    }
  }
  CheckAtLeast("lit pixels", lit, 15000, "the test's own power");
  CheckAtLeast("of them in leaves of four by four pixels and more", coarse, 2000, "as above");
  CheckEqual("lit pixels in no leaf or in several", wrong, 0);
  CheckEqual("lit pixels of which subsplat.level shows another", shown, 0);
  CheckEqual("levels whose list has not as many texels as are split", listed, 0);
}

VTK_INDIRECT_TEST(LeavesBalanced)
{
  // Levels of neighbouring lit pixels, also at a corner.
  double pairs = 0.0;
  int steps[2] = {};
  for (int number = 0; number < 16; ++number)
  {
    LeafFrame scene(1100 + number, LeafSizes[number % 2]);
    PyramidReader* const reader = scene.Reader;
    reader->SetFinestLevel(number % 5 == 4 ? Pass::HALF_RESOLUTION : Pass::FULL_RESOLUTION);
    SET_DETAIL(reader, DepthRange, number % 4 == 3);
    for (bool balance : { false, true })
    {
      SET_DETAIL(reader, Balance, balance);
      scene.Render();
      for (int y = 0; y < reader->Size[1]; ++y)
      {
        for (int x = 0; x < reader->Size[0]; ++x)
        {
          const int around[4][2] = { { 1, 0 }, { 0, 1 }, { 1, 1 }, { -1, 1 } };
          for (const auto& step : around)
          {
            const int u = x + step[0];
            const int v = y + step[1];
            if (u >= 0 && u < reader->Size[0] && v < reader->Size[1] && reader->IsLit(x, y) &&
              reader->IsLit(u, v))
            {
              const int difference = reader->FindLeaves(x, y)[0] - reader->FindLeaves(u, v)[0];
              steps[balance] += std::abs(difference) > 1;
              pairs += 1.0;
            }
          }
        }
      }
    }
  }
  CheckAtLeast("pairs of lit pixels", pairs, 100000, "the test's own power");
  CheckAtLeast("that differ by more than one level without balance", steps[0], 500, "as above");
  CheckEqual("that differ by more than one level with it", steps[1], 0);
}

namespace
{
// The paper's pyramid and criterion on the CPU (sections 3.2 and 3.3.1 of Nichols and Wyman 2009):
// 16 texels along an edge, at most, are the coarsest subsplats; one is split if its depths differ
// by more than one threshold, or a component of its normals by more than another.
struct PaperTree
{
  static constexpr int CoarsestResolution = 16;
  struct Node
  {
    bool Present = false;
    glm::dvec4 Minimum{ 1e30 }; // components of the normal, depth
    glm::dvec4 Maximum{ -1e30 };
  };
  struct Level
  {
    int Width = 0;
    int Height = 0;
    std::vector<Node> Nodes;
  };
  std::vector<Level> Levels;
  double DepthThreshold;
  double NormalThreshold;

  explicit PaperTree(const PyramidReader& reader)
    : DepthThreshold(reader.GetDepthThreshold())
    , NormalThreshold(reader.GetNormalThreshold())
  {
    Level pixels;
    pixels.Width = reader.Size[0];
    pixels.Height = reader.Size[1];
    pixels.Nodes.resize(static_cast<size_t>(pixels.Width) * pixels.Height);
    for (size_t i = 0; i < pixels.Nodes.size(); ++i)
    {
      const float* pixel = &reader.Pixels[4 * i];
      const glm::vec4 surface(pixel[0], pixel[1], pixel[2], pixel[3]);
      if (vtkIndirectKernels::vtkiSurfaceIsLit(surface))
      {
        Node& node = pixels.Nodes[i];
        node.Present = true;
        node.Minimum = node.Maximum =
          glm::dvec4(glm::dvec3(vtkIndirectKernels::vtkiSurfaceNormal(surface)),
            static_cast<double>(pixel[0]));
      }
    }
    this->Levels.push_back(pixels);
    while (std::max(this->Levels.back().Width, this->Levels.back().Height) > CoarsestResolution)
    {
      this->Levels.push_back(Halve(this->Levels.back()));
    }
  }

  static Level Halve(const Level& finer)
  {
    Level level;
    level.Width = (finer.Width + 1) / 2;
    level.Height = (finer.Height + 1) / 2;
    level.Nodes.resize(static_cast<size_t>(level.Width) * level.Height);
    for (int y = 0; y < finer.Height; ++y)
    {
      for (int x = 0; x < finer.Width; ++x)
      {
        const Node& one = finer.Nodes[static_cast<size_t>(y) * finer.Width + x];
        Node& node = level.Nodes[static_cast<size_t>(y / 2) * level.Width + x / 2];
        node.Present = node.Present || one.Present;
        node.Minimum = glm::min(node.Minimum, one.Minimum);
        node.Maximum = glm::max(node.Maximum, one.Maximum);
      }
    }
    return level;
  }

  // The level of a pixel's leaf, from the coarsest on; -1 where rounding decides. The shader
  // decodes a normal within 5e-7 (Multiresolution.PyramidRange) and rounds thresholds and
  // differences.
  int FindLeaf(int x, int y) const
  {
    int number = static_cast<int>(this->Levels.size()) - 1;
    for (; number > 0; --number)
    {
      const Level& level = this->Levels[number];
      const Node& node =
        level.Nodes[static_cast<size_t>(y >> number) * level.Width + (x >> number)];
      const glm::dvec4 range = node.Maximum - node.Minimum;
      const double turn = std::max({ range.x, range.y, range.z });
      const bool near = std::abs(range.w - this->DepthThreshold) < 2e-7 * this->DepthThreshold;
      if (near || std::abs(turn - this->NormalThreshold) < 1e-6)
      {
        return -1;
      }
      if (range.w <= this->DepthThreshold && turn <= this->NormalThreshold)
      {
        break;
      }
    }
    return number;
  }
};

struct Comparison
{
  double Lit = 0.0;
  int Different = 0;
  int Unclear = 0;
  std::map<int, int> Leaves;

  void Add(const PyramidReader& reader, const Image& shown)
  {
    const PaperTree tree(reader);
    for (int y = 0; y < reader.Size[1]; ++y)
    {
      for (int x = 0; x < reader.Size[0]; ++x)
      {
        if (reader.IsLit(x, y))
        {
          const int expected = tree.FindLeaf(x, y);
          this->Lit += 1.0;
          this->Unclear += expected < 0;
          this->Different += expected >= 0 && shown.At(x, y)[0] != static_cast<float>(expected);
          ++this->Leaves[expected];
        }
      }
    }
  }
};
}

VTK_INDIRECT_TEST(LeavesOfThePaper)
{
  // The preset as users set it, with thresholds of theirs, against the paper's rule; leaves are
  // those that subsplat.level shows. Sheets of one orientation at different depths: depths decide.
  Comparison sheets;
  for (int number = 0; number < 6; ++number)
  {
    MultiresolutionScene scene(LeafSizes[number % 2].Width, LeafSizes[number % 2].Height);
    vtkNew<PyramidReader> reader;
    Random random(1200 + static_cast<std::uint64_t>(number));
    scene.AddQuad({ -1, -1, 0 }, { 1, -1, 0 }, { -1, 1, 0 }, glm::dvec3(0.75));
    for (int i = 0; i < 12; ++i)
    {
      const glm::dvec3 at(random.Next(-0.9, 0.6), random.Next(-0.9, 0.6), random.Next(0.02, 0.6));
      scene.AddQuad(at, at + glm::dvec3(random.NextMagnitude(0.02, 0.5), 0, 0),
        at + glm::dvec3(0, random.NextMagnitude(0.02, 0.5), 0), glm::dvec3(0.75));
    }
    scene.AddSpot({ 0, 0, 2 }, { 0, 0, 0 }, 40, 0, { 1, 0, 0 });
    scene.SetEye({ 0.5, -0.7, 2.4 }, { 0, 0, 0.2 }, { 0.1, 1, 0 }, 40, 0.3, 10);
    scene.Sampler->SetNumberOfLights(16);
    scene.Pass->SetEstimator(reader);
    reader->SetPresetToPaper();
    reader->SetDepthThreshold(random.NextMagnitude(0.005, 0.1));
    scene.Render();
    sheets.Add(*reader, scene.Copy("subsplat.level"));
    scene.Pass->SetEstimator(nullptr);
  }
  CheckAtLeast("sheets: lit pixels", sheets.Lit, 20000, "the test's own power");
  CheckAtLeast("sheets: levels of leaves", sheets.Leaves.size(), 4, "as above");
  CheckEqual("sheets: pixels at which rounding decides", sheets.Unclear, 0);
  CheckEqual("sheets: pixels of another leaf than by the paper's criterion", sheets.Different, 0);

  // Random frames: curved surfaces and corners, which are split by depths and normals only.
  Comparison frames;
  for (int number = 0; number < 12; ++number)
  {
    RandomFrame scene(1250 + number, LeafSizes[number % 2],
      static_cast<FrameLight>((1250 + number) % NumberOfFrameLights));
    vtkNew<PyramidReader> reader;
    scene.Sampler->SetNumberOfLights(32);
    scene.Pass->SetReflectiveShadowMapResolution(64);
    scene.Pass->SetEstimator(reader);
    reader->SetPresetToPaper();
    reader->SetDepthThreshold(number % 3 ? 0.02 : 0.1);
    reader->SetNormalThreshold(number % 2 ? 0.25 : 0.6);
    scene.Render();
    frames.Add(*reader, scene.Copy("subsplat.level"));
    scene.Pass->SetEstimator(nullptr);
  }
  CheckAtLeast("frames: lit pixels", frames.Lit, 40000, "the test's own power");
  CheckAtLeast("frames: levels of leaves", frames.Leaves.size(), 4, "as above");
  CheckAtMost("frames: pixels at which rounding decides", frames.Unclear, 0.001 * frames.Lit,
    "1e-6 of components of normals");
  CheckEqual("frames: pixels of another leaf than by the paper's criterion", frames.Different, 0);
}

VTK_INDIRECT_TEST(LeavesOfRenderers)
{
  // Full-screen passes and compute shaders have the same leaves at thresholds above zero.
  double worst = 0.0;
  std::vector<double> squares;
  double moved = 0.0;
  double coarse = 0.0;
  int counts = 0;
  bool compared = false;
  for (int number = 0; number < 12; ++number)
  {
    RandomFrame scene(1300 + number, LeafSizes[number % 2 ? 1 : number % LeafSizes.size()],
      static_cast<FrameLight>(number % NumberOfFrameLights));
    scene.Sampler->SetNumberOfLights(64);
    scene.Pass->SetReflectiveShadowMapResolution(64);
    SET_DETAIL(scene.Splatting, HalfFloats, false);
    SET_DETAIL(scene.Splatting, CoarsestResolution, 16);
    scene.Splatting->SetFinestLevel(
      number % 4 == 3 ? Pass::HALF_RESOLUTION : Pass::FULL_RESOLUTION);
    SET_DETAIL(scene.Splatting, DepthRange, number % 3 == 2);
    Image fragments;
    Image levels;
    {
      const vtkIndirectForcedPath path("compute=off");
      fragments = scene.Splat();
      levels = scene.Copy("subsplat.level");
    }
    std::map<float, int> leaves;
    for (float level : levels.Values)
    {
      ++leaves[level];
      coarse += level > 0.0f;
    }
    scene.Splatting->Modified();
    const ImageError error = Compare(scene.Splat(), fragments, 1e-3);
    compared = compared || vtkIndirectComputeProgram::IsSupported();
    worst = std::max(worst, error.Worst);
    if (error.Mean > 0.0)
    {
      squares.push_back(error.RootMeanSquare);
    }
    std::map<float, int> others;
    const Image otherLevels = scene.Copy("subsplat.level");
    for (size_t i = 0; i < levels.Values.size(); ++i)
    {
      ++others[otherLevels.Values[i]];
      moved += otherLevels.Values[i] != levels.Values[i];
    }
    counts += others != leaves;
  }
  Check("renderers compared", compared);
  CheckAtLeast("pixels in leaves coarser than one", coarse, 5000, "the test's own power");
  CheckEqual("pixels whose leaf is another", moved, 0);
  CheckEqual("frames with other numbers of leaves", counts, 0);
  CheckAtMost("difference of the irradiance, RMS over the mean, worst frame",
    Percentile(squares, 1.0), 1e-6, "the order of sums of 64 floats: 8 times 2^-24 at random");
  CheckAtMost("the same, worst pixel over its own or a thousandth of the brightest", worst, 3e-5,
    "measured 1.1e-5: dark pixels, of which light interpolated from bright ones is most");
}
