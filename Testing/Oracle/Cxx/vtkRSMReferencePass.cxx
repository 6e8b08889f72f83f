// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkRSMReferencePass.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "Plan/vtkIndirectEstimate.h"
#include "Plan/vtkIndirectPlan.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Plan/vtkIndirectStageTimer.h"
#include "Scene/vtkIndirectFrame.h"
#include "Scene/vtkIndirectSurfaces.h"
#include "Senders/vtkIndirectAllTexelsSampler.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "Sums/vtkIndirectSum.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "Visibility/vtkIndirectVisibility.h"
#include "vtkIndirectReferenceLobe.h"
#include "vtkIndirectSegmentTests.h"
#include "vtkIndirectSightLines.h"
#include "vtkIndirectVoxelLines.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <vector>

vtkStandardNewMacro(vtkRSMReferencePass);

// Uses the widest vectors of the machine, chosen when the library is loaded.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define VTK_INDIRECT_VECTORIZED __attribute__((target_clones("avx512f", "avx2,fma", "default")))
#else
#define VTK_INDIRECT_VECTORIZED
#endif

namespace
{
// A block holds this many senders side by side; sums over blocks stay independent, so compilers
// vectorise them.
constexpr size_t Lanes = 8;

struct SenderBlock
{
  double Position[3][Lanes];
  double Normal[3][Lanes];
  double Spread[Lanes]; // of the surfaces' normals: see vtkiSpreadOfNormals
  double Area[Lanes];
  double DensityArea[3][Lanes];
};

struct Receiver
{
  double Position[3];
  double Normal[3];
  double ToEye[3];
};

// Returns vtkiMeanProjection for this receiver, which may face the sender.
inline double FindProjection(
  double projected, double normals, double spread, double squaredDistance)
{
  const double share = std::min(std::max(1.0 + 2.0 * normals, 0.0), 1.0);
  const double halfWidth = share * std::sqrt(spread * squaredDistance);
  const double within = std::max(halfWidth - std::abs(projected), 0.0);
  return std::max(projected, 0.0) + within * within / (4.0 * std::max(halfWidth, 1e-30));
}

VTK_INDIRECT_VECTORIZED
void Sum(const SenderBlock* blocks, size_t count, const Receiver& receiver, double* total)
{
  constexpr double pi = 3.14159265358979323846;
  double sums[3][Lanes] = {};
  for (size_t b = 0; b < count; ++b)
  {
    const SenderBlock& s = blocks[b];
    for (size_t i = 0; i < Lanes; ++i)
    {
      const double x = s.Position[0][i] - receiver.Position[0];
      const double y = s.Position[1][i] - receiver.Position[1];
      const double z = s.Position[2][i] - receiver.Position[2];
      const double r2 = x * x + y * y + z * z;
      const double sender = -(s.Normal[0][i] * x + s.Normal[1][i] * y + s.Normal[2][i] * z);
      const double mine = receiver.Normal[0] * x + receiver.Normal[1] * y + receiver.Normal[2] * z;
      const double normals = s.Normal[0][i] * receiver.Normal[0] +
        s.Normal[1][i] * receiver.Normal[1] + s.Normal[2][i] * receiver.Normal[2];
      const double projected = FindProjection(sender, normals, s.Spread[i], r2);
      const double facing = projected * (mine > 0.0 ? mine : 0.0);
      const double denominator = r2 * (pi * r2 + s.Area[i]);
      const double weight = denominator > 0.0 ? facing / denominator : 0.0;
      sums[0][i] += s.DensityArea[0][i] * weight;
      sums[1][i] += s.DensityArea[1][i] * weight;
      sums[2][i] += s.DensityArea[2][i] * weight;
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    for (size_t i = 0; i < Lanes; ++i)
    {
      total[c] += sums[c][i];
    }
  }
}

// Sums the same for the specular lobe of a receiver.
void SumLobe(
  const SenderBlock* blocks, size_t count, const Receiver& receiver, double power, double* total)
{
  constexpr double pi = 3.14159265358979323846;
  const double* n = receiver.Normal;
  const double* v = receiver.ToEye;
  const double facing = 2.0 * (n[0] * v[0] + n[1] * v[1] + n[2] * v[2]);
  for (size_t b = 0; b < count; ++b)
  {
    const SenderBlock& s = blocks[b];
    for (size_t i = 0; i < Lanes; ++i)
    {
      double l[3];
      double r2 = 0.0;
      double sender = 0.0;
      double mine = 0.0;
      double mirrored = 0.0;
      double normals = 0.0;
      for (int c = 0; c < 3; ++c)
      {
        normals += s.Normal[c][i] * n[c];
        l[c] = s.Position[c][i] - receiver.Position[c];
        r2 += l[c] * l[c];
        sender -= s.Normal[c][i] * l[c];
        mine += n[c] * l[c];
        mirrored += (facing * n[c] - v[c]) * l[c];
      }
      const double projected = FindProjection(sender, normals, s.Spread[i], r2);
      if (r2 > 0.0 && projected > 0.0 && mine > 0.0 && mirrored > 0.0)
      {
        const double r = std::sqrt(r2);
        const double weight =
          projected / r / (pi * r2 + s.Area[i]) * std::pow(std::min(mirrored / r, 1.0), power);
        for (int c = 0; c < 3; ++c)
        {
          total[c] += s.DensityArea[c][i] * weight;
        }
      }
    }
  }
}

// Adds lobes to the irradiance, and to the reflection of a lobe of that power; power < 0: there is
// no such lobe.
template <typename Lines>
void SumLobes(const std::vector<vtkIndirectReferenceLobe>& senders,
  const std::vector<typename Lines::End>& ends, const Lines& lines, const Receiver& receiver,
  const typename Lines::End& end, double power, double* total, double* reflected)
{
  const glm::dvec3 position(receiver.Position[0], receiver.Position[1], receiver.Position[2]);
  const glm::dvec3 normal(receiver.Normal[0], receiver.Normal[1], receiver.Normal[2]);
  const glm::dvec3 toEye(receiver.ToEye[0], receiver.ToEye[1], receiver.ToEye[2]);
  const glm::dvec3 mirror = 2.0 * glm::dot(normal, toEye) * normal - toEye;
  for (size_t i = 0; i < senders.size(); ++i)
  {
    const vtkIndirectReferenceLobe& s = senders[i];
    const glm::dvec3 way = position - s.Position;
    const double cosine = -glm::dot(normal, way);
    const double facing = cosine > 0.0 ? s.FindStrength(way) : 0.0;
    if (!(facing > 0.0) || !lines.IsVisible(end, ends[i]))
    {
      continue;
    }
    const double r = glm::length(way);
    const double mirrored = -glm::dot(mirror, way) / r;
    const double lobe =
      power >= 0.0 && mirrored > 0.0 ? std::pow(std::min(mirrored, 1.0), power) : 0.0;
    for (int c = 0; c < 3; ++c)
    {
      total[c] += s.Flux[c] * facing * cosine / r;
      reflected[c] += s.Flux[c] * facing * lobe;
    }
  }
}

// Empty lanes have no normal.
glm::dvec3 Normalized(const glm::dvec3& normal)
{
  const double length = glm::length(normal);
  return length > 0.0 ? normal / length : normal;
}

// The senders as ends of segments, block by block.
template <typename Lines>
using SenderEnds = std::vector<std::array<typename Lines::End, Lanes>>;

template <typename Lines>
SenderEnds<Lines> FindEnds(const std::vector<SenderBlock>& blocks, const Lines& lines)
{
  SenderEnds<Lines> ends(blocks.size());
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    const SenderBlock& s = blocks[b];
    for (size_t i = 0; i < Lanes; ++i)
    {
      ends[b][i] = lines.FindEnd({ s.Position[0][i], s.Position[1][i], s.Position[2][i] },
        Normalized({ s.Normal[0][i], s.Normal[1][i], s.Normal[2][i] }));
    }
  }
  return ends;
}

template <typename Lines>
typename Lines::End FindEnd(const Receiver& receiver, const Lines& lines)
{
  const double* p = receiver.Position;
  const double* n = receiver.Normal;
  return lines.FindEnd({ p[0], p[1], p[2] }, { n[0], n[1], n[2] });
}

// Finds the senders that the receiver sees.
template <typename Lines>
void FindVisible(const std::vector<SenderBlock>& blocks, const SenderEnds<Lines>& ends,
  const Lines& lines, const Receiver& receiver, const typename Lines::End& end,
  std::vector<SenderBlock>& visibleBlocks)
{
  visibleBlocks = blocks;
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    SenderBlock& visible = visibleBlocks[b];
    for (size_t i = 0; i < Lanes; ++i)
    {
      double facing[2] = { 0.0, 0.0 }; // cosines at the sender, and at the receiver
      for (int c = 0; c < 3; ++c)
      {
        const double toSender = visible.Position[c][i] - receiver.Position[c];
        facing[0] -= visible.Normal[c][i] * toSender;
        facing[1] += receiver.Normal[c] * toSender;
      }
      const bool sends = facing[0] > 0.0 || visible.Spread[i] > 0.0;
      if (sends && facing[1] > 0.0 && !lines.IsVisible(end, ends[b][i]))
      {
        visible.DensityArea[0][i] = visible.DensityArea[1][i] = visible.DensityArea[2][i] = 0.0;
      }
    }
  }
}

// Light from a direction.
struct DirectionLight
{
  glm::dvec3 ToLight;
  glm::dvec3 Light; // radiance times solid angle
};

// Adds the light of directions to the irradiance, and to the reflection of a lobe of that power;
// power < 0: there is no such lobe.
template <typename Lines>
void SumDirections(const std::vector<DirectionLight>& directions, const Lines& lines,
  const Receiver& receiver, const typename Lines::End& end, double power, double* total,
  double* reflected)
{
  constexpr double pi = 3.14159265358979323846;
  const glm::dvec3 position(receiver.Position[0], receiver.Position[1], receiver.Position[2]);
  const glm::dvec3 normal(receiver.Normal[0], receiver.Normal[1], receiver.Normal[2]);
  const glm::dvec3 toEye(receiver.ToEye[0], receiver.ToEye[1], receiver.ToEye[2]);
  const glm::dvec3 mirror = 2.0 * glm::dot(normal, toEye) * normal - toEye;
  for (const DirectionLight& light : directions)
  {
    const double cosine = glm::dot(normal, light.ToLight);
    // The segment is twice as long as the scene's diagonal, so it leaves the scene.
    if (!(cosine > 0.0) ||
      !lines.IsVisible(end, lines.FindEnd(position + 2.0 * light.ToLight, -light.ToLight)))
    {
      continue;
    }
    const double mirrored = glm::dot(mirror, light.ToLight);
    const double lobe =
      power >= 0.0 && mirrored > 0.0 ? std::pow(std::min(mirrored, 1.0), power) : 0.0;
    for (int c = 0; c < 3; ++c)
    {
      total[c] += light.Light[c] * cosine / pi;
      reflected[c] += light.Light[c] * lobe / pi;
    }
  }
}

std::vector<SenderBlock> ReadSenders(
  const vtkIndirectVirtualLights& lights, std::vector<DirectionLight>& directions)
{
  const size_t count = static_cast<size_t>(lights.GetNumberOfLights());
  const vtkIndirectTarget& table = lights.GetTable();
  const std::vector<float> position = table.ReadBack(vtkIndirectSampler::PositionArea);
  const std::vector<float> normal = table.ReadBack(vtkIndirectSampler::NormalChildDistance);
  const std::vector<float> density = table.ReadBack(vtkIndirectSampler::DensityArea);
  std::vector<SenderBlock> blocks;
  size_t kept = 0;
  for (size_t i = 0; i < count; ++i)
  {
    const float* d = &density[4 * i];
    if (d[0] == 0.0f && d[1] == 0.0f && d[2] == 0.0f)
    {
      continue;
    }
    if (position[4 * i + 3] < 0.0f)
    {
      const float* p = &position[4 * i];
      directions.push_back({ { p[0], p[1], p[2] }, { d[0], d[1], d[2] } });
      continue;
    }
    if (kept % Lanes == 0)
    {
      // Empty lanes send nothing; their area of one avoids a division by zero.
      SenderBlock empty = {};
      std::fill(empty.Area, empty.Area + Lanes, 1.0);
      blocks.push_back(empty);
    }
    SenderBlock& block = blocks.back();
    const size_t lane = kept++ % Lanes;
    for (int c = 0; c < 3; ++c)
    {
      block.Position[c][lane] = position[4 * i + c];
      block.Normal[c][lane] = normal[4 * i + c];
      block.DensityArea[c][lane] = d[c];
    }
    block.Area[lane] = position[4 * i + 3];
    const float* n = &normal[4 * i];
    block.Spread[lane] =
      static_cast<double>(vtkIndirectKernels::vtkiSpreadOfNormals(glm::vec3(n[0], n[1], n[2])));
  }
  return blocks;
}

// Makes the receiver at a pixel. Returns false if nothing lit was drawn there.
bool MakeReceiver(
  const vtkIndirectFrame& frame, const float* surface, int i, int j, Receiver& receiver)
{
  const glm::vec4 texel(surface[0], surface[1], surface[2], surface[3]);
  if (!vtkIndirectKernels::vtkiSurfaceIsLit(texel))
  {
    return false;
  }
  const glm::dvec3 ndc(
    2.0 * (i + 0.5) / frame.Size[0] - 1.0, 2.0 * (j + 0.5) / frame.Size[1] - 1.0, 1.0);
  const glm::dvec3 view = frame.RayOrigin * ndc +
    static_cast<double>(vtkIndirectKernels::vtkiSurfaceDepth(texel)) * (frame.RayDirection * ndc);
  const glm::dvec3 position(frame.ViewToScene * glm::dvec4(view, 1.0));
  const glm::dvec3 normal = glm::normalize(
    glm::dmat3(frame.ViewToScene) * glm::dvec3(vtkIndirectKernels::vtkiSurfaceNormal(texel)));
  const glm::dvec3 toEye = glm::dmat3(frame.ViewToScene) *
    (glm::length(view) > 0.0 ? -glm::normalize(view) : glm::dvec3(0.0, 0.0, 1.0));
  for (int c = 0; c < 3; ++c)
  {
    receiver.ToEye[c] = toEye[c];
    receiver.Position[c] = position[c];
    receiver.Normal[c] = normal[c];
  }
  return true;
}

// The inputs of a frame's sums, and their results; four values a pixel.
struct Sums
{
  const vtkIndirectFrame& Frame;
  const std::vector<float>& Surfaces;
  const std::vector<float>& Specular; // empty if nothing reflects specularly
  std::vector<SenderBlock> Senders;
  std::vector<DirectionLight> Directions;
  std::vector<vtkIndirectReferenceLobe> Lobes;
  std::vector<float> Irradiance;
  std::vector<float> Glossy;

  template <typename Lines>
  void Make(const Lines& lines)
  {
    constexpr bool hides = !std::is_same<Lines, vtkIndirectOpenLines>::value;
    const SenderEnds<Lines> ends = FindEnds(this->Senders, lines);
    std::vector<typename Lines::End> endsOfLobes;
    for (const vtkIndirectReferenceLobe& lobe : this->Lobes)
    {
      endsOfLobes.push_back(lines.FindEnd(lobe.Position, lobe.Normal));
    }
    this->Irradiance.assign(this->Surfaces.size(), 0.0f);
    this->Glossy.assign(this->Specular.size(), 0.0f);
    vtkSMPTools::For(0, static_cast<vtkIdType>(this->Surfaces.size() / 4),
      [&](vtkIdType begin, vtkIdType finish)
      {
        std::vector<SenderBlock> visible;
        for (vtkIdType p = begin; p < finish; ++p)
        {
          Receiver receiver;
          double total[3] = { 0.0, 0.0, 0.0 };
          if (MakeReceiver(this->Frame, &this->Surfaces[4 * p],
                static_cast<int>(p % this->Frame.Size[0]),
                static_cast<int>(p / this->Frame.Size[0]), receiver))
          {
            const typename Lines::End end = FindEnd(receiver, lines);
            if (hides)
            {
              FindVisible(this->Senders, ends, lines, receiver, end, visible);
            }
            const std::vector<SenderBlock>& blocks = hides ? visible : this->Senders;
            Sum(blocks.data(), blocks.size(), receiver, total);
            const float* lobe = this->Specular.empty() ? nullptr : &this->Specular[4 * p];
            // Values below zero are the roughness of PBR, which only area lights use.
            const bool mirrors =
              lobe && lobe[3] >= 0.0f && std::max({ lobe[0], lobe[1], lobe[2] }) > 0.0f;
            double reflected[3] = { 0.0, 0.0, 0.0 };
            SumDirections(
              this->Directions, lines, receiver, end, mirrors ? lobe[3] : -1.0, total, reflected);
            SumLobes(this->Lobes, endsOfLobes, lines, receiver, end, mirrors ? lobe[3] : -1.0,
              total, reflected);
            if (mirrors)
            {
              SumLobe(blocks.data(), blocks.size(), receiver, lobe[3], reflected);
              std::copy(reflected, reflected + 3, &this->Glossy[4 * p]);
            }
          }
          for (int c = 0; c < 3; ++c)
          {
            this->Irradiance[4 * p + c] = static_cast<float>(total[c]);
          }
          this->Irradiance[4 * p + 3] = 1.0f;
        }
      });
  }
};

class ReferenceSum : public vtkIndirectSum
{
public:
  explicit ReferenceSum(vtkRSMReferencePass& pass)
    : vtkIndirectSum(pass)
    , Set(pass)
  {
  }
  void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const override;
  vtkIndirectAbilities GetAbilities(double tolerance) const override;
  vtkIndirectVisibilityNeeds GetVisibilityNeeds(const vtkIndirectPlan& plan) const override;
  vtkIndirectSampler::Pointer ChooseSampler(
    const vtkIndirectSampler::Pointer& users, const vtkIndirectPlan& plan) override;

protected:
  size_t GetOwnBytes() const override { return this->AllTexels->GetBytes(); }
  vtkIndirectEstimate Estimate(const Input& input) override;
  void ReleaseOwn(vtkWindow* window) override { this->AllTexels->Release(window); }

private:
  const vtkRSMReferencePass& Set;
  const std::shared_ptr<vtkIndirectAllTexelsSampler> AllTexels =
    std::make_shared<vtkIndirectAllTexelsSampler>();
};
}

//------------------------------------------------------------------------------
vtkRSMReferencePass::vtkRSMReferencePass()
  : vtkIndirectEstimatorPass(std::make_unique<ReferenceSum>(*this))
{
}

//------------------------------------------------------------------------------
void ReferenceSum::AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const
{
  const bool all = this->Set.GetMode() == vtkRSMReferencePass::ALL_TEXELS;
  static const char* const visibilities[] = { "None", "Voxels", "Exact" };
  this->vtkIndirectSum::AddSettings(list, plan);
  list.Add("Mode", vtkIndirectSettingList::Choice{ all ? "AllTexels" : "VirtualLights" })
    .Add("Visibility", vtkIndirectSettingList::Choice{ visibilities[this->Set.GetVisibility()] });
}

//------------------------------------------------------------------------------
vtkIndirectAbilities ReferenceSum::GetAbilities(double tolerance) const
{
  vtkIndirectAbilities abilities = this->vtkIndirectSum::GetAbilities(tolerance);
  abilities.ComputesGlossy = true;
  abilities.SumsLobes = true;
  abilities.TakesSampler = this->Set.GetMode() == vtkRSMReferencePass::VIRTUAL_LIGHTS;
  return abilities;
}

//------------------------------------------------------------------------------
vtkIndirectSampler::Pointer ReferenceSum::ChooseSampler(
  const vtkIndirectSampler::Pointer& users, const vtkIndirectPlan&)
{
  if (this->Set.GetMode() == vtkRSMReferencePass::ALL_TEXELS)
  {
    return this->AllTexels;
  }
  return users;
}

//------------------------------------------------------------------------------
vtkIndirectVisibilityNeeds ReferenceSum::GetVisibilityNeeds(const vtkIndirectPlan& plan) const
{
  vtkIndirectVisibilityNeeds needs = this->vtkIndirectSum::GetVisibilityNeeds(plan);
  needs.Exact = this->Set.GetVisibility() == vtkRSMReferencePass::EXACT;
  needs.Senders = needs.Segments =
    !needs.Exact && (needs.Senders || this->Set.GetVisibility() == vtkRSMReferencePass::VOXELS);
  return needs;
}

//------------------------------------------------------------------------------
vtkIndirectEstimate ReferenceSum::Estimate(const Input& input)
{
  vtkIndirectStageTimer& timer = input.Timer;
  const vtkIndirectFrame& frame = input.Frame;
  if (!this->Irradiance->Resize(frame.Window, frame.Size[0], frame.Size[1]) ||
    !this->ResizeGlossy(input))
  {
    return {};
  }
  timer.Begin(vtkIndirectStageTimer::Estimate);
  const std::vector<float> surfaces =
    input.Geometry.GetTarget().ReadBack(vtkIndirectGeometryBuffer::Surface);
  const std::vector<float> specular = this->HasGlossy
    ? input.Geometry.GetTarget().ReadBack(vtkIndirectGeometryBuffer::Specular)
    : std::vector<float>();
  Sums sums = { input.Frame, surfaces, specular, {}, {}, {}, {}, {} };
  sums.Senders = ReadSenders(*input.Lights, sums.Directions);
  sums.Lobes = vtkIndirectReferenceLobe::Read(*input.Lights);
  const vtkIndirectVisibility& visibility = input.Visibility;
  const vtkIndirectSphereLines spheres{ visibility.GetSpheres() };
  if (visibility.IsExact())
  {
    sums.Make(vtkIndirectSightLines(visibility.GetSurfaces().GetTree()));
  }
  else if (visibility.WalksVoxels() && visibility.WalksSpheres())
  {
    const vtkIndirectVoxelLines voxels{ visibility.GetVolume().GetDistanceField() };
    sums.Make(
      vtkIndirectBothLines<vtkIndirectVoxelLines, vtkIndirectSphereLines>{ voxels, spheres });
  }
  else if (visibility.WalksVoxels())
  {
    sums.Make(vtkIndirectVoxelLines(visibility.GetVolume().GetDistanceField()));
  }
  else if (visibility.WalksSpheres())
  {
    sums.Make(spheres);
  }
  else
  {
    sums.Make(vtkIndirectOpenLines());
  }
  this->Irradiance->Write(0, sums.Irradiance);
  if (this->HasGlossy)
  {
    this->Glossy->Write(0, sums.Glossy);
  }
  timer.End(vtkIndirectStageTimer::Estimate);
  return this->MakeResult();
}
