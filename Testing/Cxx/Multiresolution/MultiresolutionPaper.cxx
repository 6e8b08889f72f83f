// SPDX-License-Identifier: BSD-3-Clause
// The interpolation of the preset PAPER (section 3.5 of Nichols and Wyman 2009): each level, made
// in doubles from the level above and the level's own subsplats, against the level that the pass
// shows.
#include "vtkIndirectPyramidReader.h"
#include "vtkIndirectRandomFrame.h"

#include "Sums/vtkIndirectSum.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
// The texels of a level: what the leaves of its pixels say of them.
struct UpsampledLevel
{
  int Width = 0;
  int Height = 0;
  int Shift = 0;              // a texel has 2^Shift pixels along an edge
  std::vector<char> IsThere;  // holds a lit pixel
  std::vector<char> IsSplit;  // has finer leaves
  std::vector<char> IsLeaf;   // is one
  std::vector<char> HasLight; // has light, which the next level interpolates
  std::vector<char> IsInside; // all texels around it have light, too

  UpsampledLevel(const PyramidReader& reader, const Image& leaves, int number)
    : Width(((reader.Size[0] - 1) >> number) + 1)
    , Height(((reader.Size[1] - 1) >> number) + 1)
    , Shift(number)
  {
    const size_t count = static_cast<size_t>(this->Width) * this->Height;
    for (auto* flags :
      { &this->IsThere, &this->IsSplit, &this->IsLeaf, &this->HasLight, &this->IsInside })
    {
      flags->assign(count, 0);
    }
    for (int y = 0; y < reader.Size[1]; ++y)
    {
      for (int x = 0; x < reader.Size[0]; ++x)
      {
        if (reader.IsLit(x, y))
        {
          const size_t at = this->At(x >> number, y >> number);
          this->IsThere[at] = 1;
          this->IsSplit[at] |= leaves.At(x, y)[0] < static_cast<float>(number);
          this->IsLeaf[at] |= leaves.At(x, y)[0] == static_cast<float>(number);
        }
      }
    }
  }
  // Texels outside of the image repeat those at its border.
  size_t At(int x, int y) const
  {
    return static_cast<size_t>(std::clamp(y, 0, this->Height - 1)) * this->Width +
      std::clamp(x, 0, this->Width - 1);
  }
  glm::dvec3 Fetch(const Image& shown, int x, int y) const
  {
    return shown.Color(std::clamp(x, 0, this->Width - 1) << this->Shift,
      std::clamp(y, 0, this->Height - 1) << this->Shift);
  }
};

struct Upsampling
{
  double Worst = 0.0;        // difference over its bound
  int Between = 0;           // texels between four lit ones
  int BeyondLast = 0;        // texels beside one without light
  int ConstantWouldFail = 0; // of them, values that the own texel's light is not
  int SlopesWouldFail = 0;   // of the latter, values that a continued slope is not
  int Unshown = 0;           // texels beside one of background, whose light no buffer shows
  int WrongLeaves = 0;
  int WrongEmpty = 0;

  static double Excess(const glm::dvec3& found, const glm::dvec3& expected, double unit)
  {
    // Half floats over the unit: bits below 2^-10 are cut off, or rounded; small values are
    // multiples of 2^-24. The sum of 32-bit floats rounds four times.
    double excess = 0.0;
    for (int color = 0; color < 3; ++color)
    {
      const double bound =
        (std::exp2(-10.0) + std::exp2(-22.0)) * expected[color] + std::exp2(-24.0) * unit;
      excess = std::max(excess, std::abs(found[color] - expected[color]) / bound);
    }
    return excess;
  }

  // Adds a level. above: the next coarser one, of which `coarser` is shown; own: the subsplats of
  // the level itself; shown: the level with what is interpolated.
  void Add(const UpsampledLevel& above, UpsampledLevel& level, const Image& coarser,
    const Image& own, const Image& shown, const PyramidReader& reader, double unit)
  {
    for (int y = 0; y < level.Height; ++y)
    {
      for (int x = 0; x < level.Width; ++x)
      {
        this->AddTexel(above, level, x, y, coarser, own, shown, reader, unit);
      }
    }
  }

  void AddTexel(const UpsampledLevel& above, UpsampledLevel& level, int x, int y,
    const Image& coarser, const Image& own, const Image& shown, const PyramidReader& reader,
    double unit)
  {
    const size_t at = level.At(x, y);
    const int u = x >> 1;
    const int v = y >> 1;
    const int s = 2 * (x & 1) - 1; // towards the nearer neighbours
    const int t = 2 * (y & 1) - 1;
    const size_t parent = above.At(u, v);
    // Pixels are read as such, and a texel's value at its first pixel.
    const glm::dvec3 found = level.Fetch(shown, x, y);
    const bool smooth = above.IsInside[parent] &&
      (level.Shift == 0 ||
        (above.IsInside[above.At(u + s, v)] && above.IsInside[above.At(u, v + t)] &&
          above.IsInside[above.At(u + s, v + t)]));
    const bool lit = level.IsThere[at] && !level.IsSplit[at];
    // Inside a surface a texel has light even if all of its pixels are background.
    level.HasLight[at] = lit || (smooth && level.Shift > 0);
    level.IsInside[at] = smooth;
    if (!smooth && lit)
    {
      bool inside = true;
      for (int i = 0; i < 9; ++i)
      {
        const size_t other = level.At(x + i % 3 - 1, y + i / 3 - 1);
        inside = inside && level.IsThere[other] && !level.IsSplit[other];
      }
      level.IsInside[at] = inside;
    }
    if (!level.HasLight[at])
    {
      this->WrongEmpty += found != glm::dvec3(0.0);
      return;
    }
    if (level.IsLeaf[at])
    {
      // The own subsplats are shown at lit pixels.
      for (int j = y << level.Shift; j < std::min((y + 1) << level.Shift, reader.Size[1]); ++j)
      {
        for (int i = x << level.Shift; i < std::min((x + 1) << level.Shift, reader.Size[0]); ++i)
        {
          this->WrongLeaves += reader.IsLit(i, j) && own.Color(i, j) != found;
        }
      }
      return;
    }

    // Centres are a quarter of the coarser edge apart.
    const glm::dvec3 here = above.Fetch(coarser, u, v);
    glm::dvec3 expected = here;
    glm::dvec3 sloped = here;
    bool last = false;
    if (smooth)
    {
      if (!above.HasLight[above.At(u + s, v)] || !above.HasLight[above.At(u, v + t)] ||
        !above.HasLight[above.At(u + s, v + t)])
      {
        ++this->Unshown;
        return;
      }
      expected = (9.0 * here + 3.0 * above.Fetch(coarser, u + s, v) +
                   3.0 * above.Fetch(coarser, u, v + t) + above.Fetch(coarser, u + s, v + t)) /
        16.0;
      sloped = expected;
    }
    else
    {
      for (const auto& step : { glm::ivec2(s, 0), glm::ivec2(0, t) })
      {
        const glm::ivec2 near(u + step.x, v + step.y);
        const glm::ivec2 across(u - step.x, v - step.y);
        if (above.HasLight[above.At(near.x, near.y)])
        {
          const glm::dvec3 rise = 0.25 * (above.Fetch(coarser, near.x, near.y) - here);
          expected += rise;
          sloped += rise;
        }
        else
        {
          last = true;
          if (above.HasLight[above.At(across.x, across.y)])
          {
            sloped += 0.25 * (here - above.Fetch(coarser, across.x, across.y));
          }
        }
      }
    }
    this->Worst = std::max(this->Worst, Excess(found, expected, unit));
    this->Between += smooth;
    this->BeyondLast += last;
    this->ConstantWouldFail += Excess(found, here, unit) > 1.0;
    this->SlopesWouldFail += Excess(found, glm::max(sloped, glm::dvec3(0.0)), unit) > 1.0;
  }
};
}

VTK_INDIRECT_TEST(PaperInterpolates)
{
  Upsampling all;
  for (int number = 0; number < 10; ++number)
  {
    const FrameSize sizes[] = { { 97, 61 }, { 127, 89 }, { 64, 64 } };
    RandomFrame scene(
      1400 + number, sizes[number % 3], static_cast<FrameLight>(number % NumberOfFrameLights));
    vtkNew<PyramidReader> reader;
    scene.Sampler->SetNumberOfLights(32);
    scene.Pass->SetReflectiveShadowMapResolution(64);
    scene.Pass->SetEstimator(reader);
    reader->SetPresetToPaper();
    scene.Render();
    const double unit = vtkIndirectSum::Get(reader).GetIrradianceUnit();
    const Image leaves = scene.Copy("subsplat.level");
    // The level that is always split has no light, and none is interpolated from it.
    int above = static_cast<int>(reader->Levels.size());
    UpsampledLevel coarser(*reader, leaves, above);
    Image shown = leaves;
    while (above-- > 0)
    {
      UpsampledLevel level(*reader, leaves, above);
      const Image own = scene.Copy("subsplat.evaluated" + std::to_string(above));
      const Image next = scene.Copy("subsplat.upsampled" + std::to_string(above));
      all.Add(coarser, level, shown, own, next, *reader, unit);
      coarser = level;
      shown = next;
    }
    scene.Pass->SetEstimator(nullptr);
  }
  CheckEqual("leaves of which the level holds another light", all.WrongLeaves, 0);
  CheckEqual("texels with light where there is no surface", all.WrongEmpty, 0);
  CheckAtMost("texels that are not compared", all.Unshown, 20, "measured 2");
  CheckAtLeast("texels between four", all.Between, 10000, "the test's own power");
  CheckAtLeast("texels beyond the last one", all.BeyondLast, 2000, "as above");
  CheckAtLeast("texels that are not constant", all.ConstantWouldFail, 5000, "as above");
  CheckAtLeast("texels that do not continue slopes", all.SlopesWouldFail, 1000, "as above");
  CheckAtMost("difference to the linear interpolation over half floats' rounding", all.Worst, 1.0,
    "2^-10 of a value, 2^-24 of the unit; a half of that where drivers round to nearest");
}
