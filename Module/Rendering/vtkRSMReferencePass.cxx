// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkRSMReferencePass.h"

#include "vtkGeometryBufferPass.h"
#include "vtkIndirectAllTexelsSampler.h"
#include "vtkIndirectClearance.h"
#include "vtkIndirectFrame.h"
#include "vtkIndirectKernels.h"
#include "vtkIndirectOccupancyVolume.h"
#include "vtkIndirectStageTimer.h"
#include "vtkIndirectTarget.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkSMPTools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkRSMReferencePass);

// The widest vectors that the machine has, chosen when the library is loaded.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__)
#define VTK_INDIRECT_VECTORIZED __attribute__((target_clones("avx512f", "avx2,fma", "default")))
#else
#define VTK_INDIRECT_VECTORIZED
#endif

namespace
{
// Senders side by side in a block; sums over blocks stay independent, so compilers vectorise them.
constexpr size_t Lanes = 8;

struct SenderBlock
{
  double Position[3][Lanes];
  double Normal[3][Lanes];
  double Area[Lanes];
  double DensityArea[3][Lanes];
};

struct Receiver
{
  double Position[3];
  double Normal[3];
  double ToEye[3];
};

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
      const double facing = (sender > 0.0 ? sender : 0.0) * (mine > 0.0 ? mine : 0.0);
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

// The same for the specular lobe of a receiver.
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
      for (int c = 0; c < 3; ++c)
      {
        l[c] = s.Position[c][i] - receiver.Position[c];
        r2 += l[c] * l[c];
        sender -= s.Normal[c][i] * l[c];
        mine += n[c] * l[c];
        mirrored += (facing * n[c] - v[c]) * l[c];
      }
      if (r2 > 0.0 && sender > 0.0 && mine > 0.0 && mirrored > 0.0)
      {
        const double r = std::sqrt(r2);
        const double weight =
          sender / r / (pi * r2 + s.Area[i]) * std::pow(std::min(mirrored / r, 1.0), power);
        for (int c = 0; c < 3; ++c)
        {
          total[c] += s.DensityArea[c][i] * weight;
        }
      }
    }
  }
}

// The senders as ends of segments, block by block.
using SenderEnds = std::vector<std::array<vtkIndirectClearance::End, Lanes>>;

SenderEnds FindEnds(const std::vector<SenderBlock>& blocks, const vtkIndirectClearance& clearance)
{
  SenderEnds ends(blocks.size());
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    const SenderBlock& s = blocks[b];
    for (size_t i = 0; i < Lanes; ++i)
    {
      ends[b][i] = clearance.FindEnd(
        glm::vec3(glm::dvec3(s.Position[0][i], s.Position[1][i], s.Position[2][i])),
        glm::vec3(glm::dvec3(s.Normal[0][i], s.Normal[1][i], s.Normal[2][i])));
    }
  }
  return ends;
}

// The senders without those that the receiver does not see.
void FindVisible(const std::vector<SenderBlock>& blocks, const SenderEnds& ends,
  const vtkIndirectClearance& clearance, const Receiver& receiver,
  std::vector<SenderBlock>& visibleBlocks)
{
  visibleBlocks = blocks;
  const vtkIndirectClearance::End end = clearance.FindEnd(
    glm::vec3(glm::dvec3(receiver.Position[0], receiver.Position[1], receiver.Position[2])),
    glm::vec3(glm::dvec3(receiver.Normal[0], receiver.Normal[1], receiver.Normal[2])));
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    SenderBlock& visible = visibleBlocks[b];
    for (size_t i = 0; i < Lanes; ++i)
    {
      double facing[2] = { 0.0, 0.0 }; // of the sender, and of the receiver
      for (int c = 0; c < 3; ++c)
      {
        const double toSender = visible.Position[c][i] - receiver.Position[c];
        facing[0] -= visible.Normal[c][i] * toSender;
        facing[1] += receiver.Normal[c] * toSender;
      }
      if (facing[0] > 0.0 && facing[1] > 0.0 && !clearance.IsVisible(end, ends[b][i]))
      {
        visible.DensityArea[0][i] = visible.DensityArea[1][i] = visible.DensityArea[2][i] = 0.0;
      }
    }
  }
}

std::vector<SenderBlock> ReadSenders(vtkVirtualLightSampler* sampler)
{
  const size_t count = static_cast<size_t>(sampler->GetActualNumberOfLights());
  vtkIndirectTarget& target = sampler->GetTarget();
  const std::vector<float> position = target.ReadBack(vtkVirtualLightSampler::PositionArea);
  const std::vector<float> normal = target.ReadBack(vtkVirtualLightSampler::NormalExponent);
  const std::vector<float> density = target.ReadBack(vtkVirtualLightSampler::DensityArea);
  std::vector<SenderBlock> blocks;
  size_t kept = 0;
  for (size_t i = 0; i < count; ++i)
  {
    const float* d = &density[4 * i];
    if (d[0] == 0.0f && d[1] == 0.0f && d[2] == 0.0f)
    {
      continue;
    }
    if (kept % Lanes == 0)
    {
      // Lanes that stay empty send nothing from a place of their own.
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
  }
  return blocks;
}

// The receiver at a pixel, or false where nothing lit was drawn.
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
}

//------------------------------------------------------------------------------
struct vtkRSMReferencePass::Internals
{
  vtkNew<vtkIndirectAllTexelsSampler> AllTexels;
};

vtkRSMReferencePass::vtkRSMReferencePass()
  : Internal(new Internals)
{
}

vtkRSMReferencePass::~vtkRSMReferencePass() = default;

//------------------------------------------------------------------------------
void vtkRSMReferencePass::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Mode: " << (this->Mode == ALL_TEXELS ? "AllTexels" : "VirtualLights") << "\n";
}

//------------------------------------------------------------------------------
size_t vtkRSMReferencePass::GetBytes() const
{
  return this->Superclass::GetBytes() + this->Internal->AllTexels->GetBytes();
}

//------------------------------------------------------------------------------
vtkVirtualLightSampler* vtkRSMReferencePass::ChooseSampler(vtkVirtualLightSampler* users)
{
  return this->Mode == ALL_TEXELS ? this->Internal->AllTexels.Get() : users;
}

//------------------------------------------------------------------------------
bool vtkRSMReferencePass::Estimate(const Input& input, vtkIndirectStageTimer& timer)
{
  const vtkIndirectFrame& frame = input.Frame;
  if (!this->Irradiance->Resize(frame.Window, frame.Size[0], frame.Size[1]) ||
    !this->ResizeGlossy(input))
  {
    return false;
  }
  this->UpdateSight(input, timer);
  timer.Begin(vtkIndirectStageTimer::Estimate);
  const std::vector<SenderBlock> senders = ReadSenders(input.Sampler);
  const vtkIndirectClearance* const clearance =
    this->IsBlocked() ? &this->Voxels->GetClearance() : nullptr;
  const SenderEnds ends = clearance ? FindEnds(senders, *clearance) : SenderEnds();
  const std::vector<float> surfaces =
    input.Geometry.GetTarget().ReadBack(vtkGeometryBufferPass::Surface);
  const size_t pixels = surfaces.size() / 4;
  const std::vector<float> specular = this->HasGlossy
    ? input.Geometry.GetTarget().ReadBack(vtkGeometryBufferPass::Specular)
    : std::vector<float>();
  std::vector<float> irradiance(surfaces.size(), 0.0f);
  std::vector<float> glossy(specular.size(), 0.0f);
  vtkSMPTools::For(0, static_cast<vtkIdType>(pixels),
    [&](vtkIdType begin, vtkIdType end)
    {
      std::vector<SenderBlock> visible;
      for (vtkIdType p = begin; p < end; ++p)
      {
        Receiver receiver;
        double total[3] = { 0.0, 0.0, 0.0 };
        if (MakeReceiver(frame, &surfaces[4 * p], static_cast<int>(p % frame.Size[0]),
              static_cast<int>(p / frame.Size[0]), receiver))
        {
          if (clearance)
          {
            FindVisible(senders, ends, *clearance, receiver, visible);
          }
          const SenderBlock* blocks = clearance ? visible.data() : senders.data();
          Sum(blocks, senders.size(), receiver, total);
          const float* lobe = this->HasGlossy ? &specular[4 * p] : nullptr;
          if (lobe && std::max({ lobe[0], lobe[1], lobe[2] }) > 0.0f)
          {
            double reflected[3] = { 0.0, 0.0, 0.0 };
            SumLobe(blocks, senders.size(), receiver, lobe[3], reflected);
            std::copy(reflected, reflected + 3, &glossy[4 * p]);
          }
        }
        for (int c = 0; c < 3; ++c)
        {
          irradiance[4 * p + c] = static_cast<float>(total[c]);
        }
        irradiance[4 * p + 3] = 1.0f;
      }
    });
  this->Irradiance->Write(0, irradiance);
  if (this->HasGlossy)
  {
    this->Glossy->Write(0, glossy);
  }
  timer.End(vtkIndirectStageTimer::Estimate);
  return true;
}

//------------------------------------------------------------------------------
void vtkRSMReferencePass::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!window)
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  this->Internal->AllTexels->ReleaseGraphicsResources(window);
}
