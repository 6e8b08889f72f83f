// SPDX-License-Identifier: BSD-3-Clause
// A room of known surfaces, and the equations of the hints' paper over its texels and hints in
// double precision.
#ifndef vtkIndirectHintPaperRoom_h
#define vtkIndirectHintPaperRoom_h

#include "RadianceHints/vtkIndirectHintSum.h"
#include "vtkIndirectDetails.h"
#include "vtkIndirectHintScenes.h"

#include "Scene/vtkIndirectFrame.h"
#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkMath.h"
#include "vtkRSMGatherPass.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace vtkIndirectTest
{
constexpr int MapEdge = 32;
constexpr int Layers = 7; // one of a spot and six of a point light
constexpr int Grid[3] = { 6, 5, 4 };
const glm::dvec3 Extent(4.0, 3.0, 2.0); // extent of the room, which has a corner at the origin
const glm::dvec3 Albedo(0.8, 0.5, 0.3);
const double Pi = vtkMath::Pi();

inline glm::dvec3 GetCell()
{
  return Extent / glm::dvec3(Grid[0], Grid[1], Grid[2]);
}

// Item i of the sequence of a seed, as in vtkIndirectHintPlaces.glsl.
inline glm::dvec3 Spread(int i, std::uint32_t seed)
{
  std::uint32_t h = seed * 747796405u + 2891336453u;
  h = ((h >> ((h >> 28u) + 4u)) ^ h) * 277803737u;
  h = (h >> 22u) ^ h;
  const std::uint32_t start[3] = { h, h * 2654435761u + 1013904223u,
    (h ^ 0x9e3779b9u) * 2246822519u };
  const std::uint32_t step[3] = { 3518319155u, 2882110345u, 2360945575u };
  glm::dvec3 result;
  for (int axis = 0; axis < 3; ++axis)
  {
    result[axis] = ((start[axis] + static_cast<std::uint32_t>(i) * step[axis]) >> 8u) / 16777216.0;
  }
  return result;
}

// Real spherical harmonics in the order (0,0), (1,-1), (1,0), (1,1), (2,-2) to (2,2).
inline std::array<double, 9> Harmonics(const glm::dvec3& d)
{
  const double one = std::sqrt(3.0 / (4.0 * Pi));
  const double two = std::sqrt(15.0 / (4.0 * Pi));
  return { std::sqrt(1.0 / (4.0 * Pi)), one * d.y, one * d.z, one * d.x, two * d.x * d.y,
    two * d.y * d.z, std::sqrt(5.0 / (16.0 * Pi)) * (3.0 * d.z * d.z - 1.0), two * d.x * d.z,
    0.5 * two * (d.x * d.x - d.y * d.y) };
}

struct Field
{
  std::array<glm::dvec3, 9> C{};
  double Nearest = 1e30; // distance of a sender over the scene's diagonal
  double Farthest = 0.0;

  void Add(const glm::dvec3& light, const glm::dvec3& direction)
  {
    const std::array<double, 9> y = Harmonics(direction);
    for (int k = 0; k < 9; ++k)
    {
      this->C[k] += light * y[k];
    }
  }
  // Ramamoorthi and Hanrahan 2001, over pi.
  glm::dvec3 GetIrradiance(const glm::dvec3& normal, int order) const
  {
    const std::array<double, 9> y = Harmonics(normal);
    glm::dvec3 sum(0.0);
    for (int k = 0; k < order * order; ++k)
    {
      sum += (k == 0 ? 1.0 : k < 4 ? 2.0 / 3.0 : 0.25) * y[k] * this->C[k];
    }
    return sum;
  }
};

// Radiance times solid angle of a texel, `weight` times. A texel of area A is seen from the height
// sqrt(h^2 + A / 2 pi), see radiance-hints.md; without `patches` from its real height, as in the
// paper.
inline void AddTexel(
  Field& field, const VirtualLight& texel, const glm::dvec3& from, double weight, bool patches)
{
  const glm::dvec3 offset = texel.Position - from;
  const double height = -glm::dot(texel.Normal, offset);
  if (height > 0.0)
  {
    const double back = patches ? std::sqrt(height * height + texel.Area / (2.0 * Pi)) : height;
    const glm::dvec3 seen = offset - (back - height) * texel.Normal;
    const double r = glm::length(seen);
    field.Add(texel.DensityArea * (weight * back / (r * r * r)), seen / r);
  }
}

// The place of a grid, and the number of its first hint.
struct GridPlace
{
  glm::dvec3 Lower{ 0.0 };
  glm::dvec3 Cell = GetCell();
  int First = 0;
};

struct PaperRoom : HintScene
{
  std::vector<VirtualLight> Texels; // texels of all maps, by layer, row and column
  const double Diagonal = glm::length(Extent);
  int Samples = 40; // of all layers together, as in the preset
  int BounceSamples = 32;
  double Range = Diagonal;                     // r_max, the unit of stored distances
  bool Rotation = false;                       // of the look-ups
  std::vector<GridPlace> Grids{ GridPlace() }; // of as many hints each; the second is the finer one
  // Section 8: points on a segment, the factor for a hidden one, and the eye.
  int DepthSamples = 0;
  double DepthAttenuation = 0.6;
  Image Depth;
  glm::dmat4 WorldToView;
  glm::dmat4 ViewToClip;

  PaperRoom()
    : HintScene(40, 30)
  {
    this->AddBox(glm::dvec3(0.0), Extent, Albedo);
    this->AddSpot({ 1.0, 1.0, 1.9 }, { 2.0, 1.6, 0.0 }, 50.0, 1.0, { 0.0, 0.0, 1.0 });
    this->AddPoint({ 2.7, 1.9, 0.8 }, { 0.5, 0.0, 1.0 });
    this->SetEye({ 0.2, 0.2, 1.8 }, { 3.0, 2.5, 0.2 }, { 0, 0, 1 }, 70.0, 0.05, 10.0);
    this->Pass->SetReflectiveShadowMapResolution(MapEdge);
    this->Pass->SetEstimator(this->Gather);
    this->Gather->SetModeToAllTexels();
    this->Render();
    this->Texels = this->CopyLights();
    this->Pass->SetEstimator(this->Hints);
    this->Pass->SetVisibilityToAuto();
    this->Hints->SetPresetToPaper();
    this->Hints->SetGridResolution(Grid[0], Grid[1], Grid[2]);
    this->Hints->SetInterpolationStep(1);
  }

  glm::dvec3 GetPlace(const vtkIndirectHintSum::Hint& hint) const
  {
    return glm::dvec3(hint.Position[0], hint.Position[1], hint.Position[2]) * this->Diagonal +
      0.5 * Extent;
  }

  const GridPlace& GetGridOf(int hint) const
  {
    return this->Grids.size() > 1 && hint >= this->Grids[1].First ? this->Grids[1] : this->Grids[0];
  }

  // Makes the eye's depth hide senders, by the settings of the pass.
  void FollowDepth()
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    this->Depth = this->Copy("depth");
    this->WorldToView = vtkIndirectFrame::ToGLM(camera->GetModelViewTransformMatrix());
    this->ViewToClip = vtkIndirectFrame::ToGLM(
      camera->GetProjectionTransformMatrix(this->Renderer->GetTiledAspectRatio(), -1, 1));
    this->DepthSamples = this->Hints->GetNumberOfDepthSamples();
    this->DepthAttenuation = this->Hints->GetDepthAttenuation();
  }

  // Section 8: a factor for each point of the segment that lies behind what the eye sees there.
  double FindShare(const glm::dvec3& a, const glm::dvec3& b) const
  {
    double share = 1.0;
    for (int i = 0; i < this->DepthSamples; ++i)
    {
      const glm::dvec4 view =
        this->WorldToView * glm::dvec4(glm::mix(a, b, (i + 0.5) / this->DepthSamples), 1.0);
      const glm::dvec4 clip = this->ViewToClip * view;
      const glm::dvec2 at = 0.5 * glm::dvec2(clip) / clip.w + 0.5;
      if (clip.w > 0.0 && std::min(at.x, at.y) >= 0.0 && std::max(at.x, at.y) < 1.0)
      {
        const double depth = this->Depth.At(static_cast<int>(at.x * this->Depth.Width),
          static_cast<int>(at.y * this->Depth.Height))[0];
        share *= depth > 0.0 && -view.z > depth ? this->DepthAttenuation : 1.0;
      }
    }
    return share;
  }

  // Eq. 1 to 4: the mean over each map's samples, from a position in the hint's cell.
  Field Inject(const vtkIndirectHintSum::Hint& hint, int number, bool patches) const
  {
    Field field;
    const int count = (this->Samples + Layers - 1) / Layers;
    for (int layer = 0; layer < Layers; ++layer)
    {
      const auto seed = static_cast<std::uint32_t>(16 * number + layer);
      for (int i = 0; i < count; ++i)
      {
        const glm::dvec3 random = Spread(i, seed);
        const glm::dvec3 jitter = Spread(i, seed + 77777777u);
        const int x = static_cast<int>(random.x * MapEdge);
        const int y = static_cast<int>(random.y * MapEdge);
        const VirtualLight& texel = this->Texels[(layer * MapEdge + y) * MapEdge + x];
        const glm::dvec3 from =
          this->GetPlace(hint) + (jitter - 0.5) * this->GetGridOf(number).Cell;
        const glm::dvec3 offset = texel.Position - from;
        field.Nearest = std::min(field.Nearest, glm::length(offset) / this->Range);
        field.Farthest = std::max(field.Farthest, glm::length(offset) / this->Range);
        AddTexel(field, texel, from,
          this->FindShare(from, texel.Position) * MapEdge * MapEdge / count, patches);
      }
    }
    field.Nearest = std::min(field.Nearest, 1.0);
    field.Farthest = std::min(field.Farthest, 1.0);
    return field;
  }

  // Eq. 8 with weights normalized once, 9 and 11. ambiguous: rounding decides between two cells for
  // a sample on their border.
  Field Exchange(const std::vector<vtkIndirectHintSum::Hint>& hints,
    const std::vector<Field>& first, const std::vector<Field>& before, int number, int order,
    bool& ambiguous) const
  {
    const glm::ivec3 size(Grid[0], Grid[1], Grid[2]);
    const GridPlace& grid = this->GetGridOf(number);
    const int inGrid = number - grid.First;
    const glm::dvec3 middle(inGrid % size.x, inGrid / size.x % size.y, inGrid / (size.x * size.y));
    const glm::dvec3 reach = this->Range / grid.Cell;
    const glm::dvec3 lower = glm::max(middle - reach, glm::dvec3(-0.5));
    const glm::dvec3 upper = glm::min(middle + reach, glm::dvec3(size) - 0.5);
    Field sum;
    double weights = 0.0;
    int found = 0;
    for (int i = 0; i < 8 * this->BounceSamples && found < this->BounceSamples; ++i)
    {
      const glm::dvec3 at =
        lower + (upper - lower) * Spread(i, static_cast<std::uint32_t>(number)) + 0.5;
      const glm::dvec3 rest = glm::abs(at - glm::round(at));
      ambiguous = ambiguous || std::min({ rest.x, rest.y, rest.z }) < 1e-5;
      const glm::ivec3 other = glm::clamp(glm::ivec3(at), glm::ivec3(0), size - 1);
      const int j = grid.First + other.x + size.x * (other.y + size.y * other.z);
      const glm::dvec3 toward = (this->GetPlace(hints[j]) - this->GetPlace(hints[number]));
      const double r = glm::length(toward) / this->Range;
      if (!(r > 0.0 && r <= 1.0))
      {
        continue;
      }
      const double least = first[number].Nearest + first[j].Nearest;
      const double most = first[number].Farthest + first[j].Farthest;
      const double visible =
        most > least ? 1.0 - glm::clamp((r - least) / (most - least), 0.0, 1.0) : 1.0;
      const double weight = visible * (1.0 - first[j].Nearest);
      const glm::dvec3 direction = glm::normalize(toward);
      const glm::dvec3 e = glm::max(before[j].GetIrradiance(-direction, order), glm::dvec3(0.0));
      sum.Add(weight * Albedo * e, direction);
      weights += weight;
      ++found;
    }
    Field result = first[number];
    for (int k = 0; k < 9; ++k)
    {
      result.C[k] += weights > 0.0 ? sum.C[k] * (4.0 * Pi / weights) : glm::dvec3(0.0);
    }
    return result;
  }

  // The finer grid's share of the light at a surface: it fades over its outermost two cells, except
  // at faces that both grids share.
  double FindFineShare(const glm::dvec3& position) const
  {
    if (this->Grids.size() < 2)
    {
      return 0.0;
    }
    const GridPlace& fine = this->Grids.back();
    const GridPlace& coarse = this->Grids.front();
    const glm::dvec3 size(Grid[0], Grid[1], Grid[2]);
    double inside = 2.0;
    for (int i = 0; i < 3; ++i)
    {
      const double low = (position[i] - fine.Lower[i]) / fine.Cell[i];
      const double atLow = fine.Lower[i] - coarse.Lower[i];
      const double atHigh = atLow + size[i] * (fine.Cell[i] - coarse.Cell[i]);
      inside = std::abs(atLow) < 0.5 * fine.Cell[i] ? inside : std::min(inside, low);
      inside = std::abs(atHigh) < 0.5 * fine.Cell[i] ? inside : std::min(inside, size[i] - low);
    }
    return glm::clamp(0.5 * inside, 0.0, 1.0);
  }

  // Eq. 5 to 7: four look-ups, each in the eight hints around it, by the grids' shares.
  glm::dvec3 LookUp(const std::vector<Field>& fields, const Receiver& at, int order) const
  {
    const glm::dvec3 helper =
      std::abs(at.Normal.x) < 0.5 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
    const glm::dvec3 tangent = glm::normalize(glm::cross(helper, at.Normal));
    const glm::dvec3 bitangent = glm::cross(at.Normal, tangent);
    const double start =
      this->Rotation ? 2.0 * Pi * Spread(0, static_cast<std::uint32_t>(at.X * 4099 + at.Y)).x : 0.0;
    Field sum;
    double total = 0.0;
    const double fine = this->FindFineShare(at.Position);
    for (const GridPlace& grid : this->Grids)
    {
      const double share = grid.First > 0 ? fine : 1.0 - fine;
      for (int lookup = 0; share > 0.0 && lookup < 4; ++lookup)
      {
        const double polar = lookup == 0 ? 0.0 : 80.0 * Pi / 180.0;
        const double turn = start + 2.0 * Pi * lookup / 3.0;
        const glm::dvec3 place = at.Position +
          glm::length(grid.Cell) *
            (0.5 * at.Normal + std::cos(polar) * at.Normal +
              std::sin(polar) * (std::cos(turn) * tangent + std::sin(turn) * bitangent));
        const glm::dvec3 inGrid = (place - grid.Lower) / grid.Cell - 0.5;
        const glm::dvec3 base = glm::floor(inGrid);
        for (int corner = 0; corner < 8; ++corner)
        {
          int index[3];
          double weight = 1.0;
          for (int axis = 0; axis < 3; ++axis)
          {
            const int shift = (corner >> axis) & 1;
            const double blend = inGrid[axis] - base[axis];
            index[axis] = std::clamp(static_cast<int>(base[axis]) + shift, 0, Grid[axis] - 1);
            weight *= shift ? blend : 1.0 - blend;
          }
          // Above zero: see vtkIndirectHintLookup.glsl.
          weight = share * std::max(weight, 1e-4);
          const Field& field =
            fields[grid.First + index[0] + Grid[0] * (index[1] + Grid[1] * index[2])];
          for (int k = 0; k < 9; ++k)
          {
            sum.C[k] += weight * field.C[k];
          }
          total += weight;
        }
      }
    }
    for (glm::dvec3& c : sum.C)
    {
      c /= total;
    }
    return glm::max(sum.GetIrradiance(at.Normal, order), glm::dvec3(0.0));
  }
};

// Root of the squared difference over that of the expected field.
inline double FindDifference(const vtkIndirectHintSum::Hint& hint, const Field& expected, int order)
{
  double difference = 0.0;
  double size = 0.0;
  for (int color = 0; color < 3; ++color)
  {
    for (int k = 0; k < order * order; ++k)
    {
      const double wanted = expected.C[k][color];
      difference += std::pow(hint.Coefficients[color * order * order + k] - wanted, 2.0);
      size += wanted * wanted;
    }
  }
  return std::sqrt(difference / size);
}

// The fields of all hints of order 2 with one bounce more than the fields before, none for the
// first bounce, and their differences to the pass's.
struct Expected
{
  std::vector<Field> Fields;
  std::vector<double> Differences; // see FindDifference
  int Ambiguous = 0;               // hints with a sample on a border, which have no difference

  Expected(const PaperRoom& scene, const std::vector<vtkIndirectHintSum::Hint>& hints,
    const std::vector<Field>& before)
  {
    for (int i = 0; i < static_cast<int>(hints.size()); ++i)
    {
      bool unclear = false;
      this->Fields.push_back(before.empty() ? scene.Inject(hints[i], i, true)
                                            : scene.Exchange(hints, before, before, i, 2, unclear));
      this->Ambiguous += unclear;
      if (!unclear)
      {
        this->Differences.push_back(FindDifference(hints[i], this->Fields.back(), 2));
      }
    }
  }
};
}

#endif
