// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkRSMReferencePass.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Frame/vtkIndirectEstimate.h"
#include "Frame/vtkIndirectFrame.h"
#include "Frame/vtkIndirectPlan.h"
#include "Frame/vtkIndirectStageTimer.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "VirtualLights/vtkIndirectAllTexelsSampler.h"
#include "VirtualLights/vtkIndirectVirtualLights.h"
#include "Visibility/vtkIndirectDistanceField.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"
#include "Visibility/vtkIndirectVisibility.h"
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
using SenderEnds = std::vector<std::array<vtkIndirectDistanceField::End, Lanes>>;

SenderEnds FindEnds(const std::vector<SenderBlock>& blocks, const vtkIndirectDistanceField& field)
{
  SenderEnds ends(blocks.size());
  for (size_t b = 0; b < blocks.size(); ++b)
  {
    const SenderBlock& s = blocks[b];
    for (size_t i = 0; i < Lanes; ++i)
    {
      ends[b][i] =
        field.FindEnd(glm::vec3(glm::dvec3(s.Position[0][i], s.Position[1][i], s.Position[2][i])),
          glm::vec3(glm::dvec3(s.Normal[0][i], s.Normal[1][i], s.Normal[2][i])));
    }
  }
  return ends;
}

// The senders without those that the receiver does not see.
void FindVisible(const std::vector<SenderBlock>& blocks, const SenderEnds& ends,
  const vtkIndirectDistanceField& field, const Receiver& receiver,
  std::vector<SenderBlock>& visibleBlocks)
{
  visibleBlocks = blocks;
  const vtkIndirectDistanceField::End end = field.FindEnd(
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
      if (facing[0] > 0.0 && facing[1] > 0.0 && !field.IsVisible(end, ends[b][i]))
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

// Adds what comes from directions to the irradiance, and to what a lobe of that power reflects;
// power < 0: there is none.
void SumDirections(const std::vector<DirectionLight>& directions,
  const vtkIndirectDistanceField* field, const Receiver& receiver, double power, double* total,
  double* reflected)
{
  constexpr double pi = 3.14159265358979323846;
  const glm::dvec3 position(receiver.Position[0], receiver.Position[1], receiver.Position[2]);
  const glm::dvec3 normal(receiver.Normal[0], receiver.Normal[1], receiver.Normal[2]);
  const glm::dvec3 toEye(receiver.ToEye[0], receiver.ToEye[1], receiver.ToEye[2]);
  const glm::dvec3 mirror = 2.0 * glm::dot(normal, toEye) * normal - toEye;
  vtkIndirectDistanceField::End end{};
  if (field)
  {
    end = field->FindEnd(glm::vec3(position), glm::vec3(normal));
  }
  for (const DirectionLight& light : directions)
  {
    const double cosine = glm::dot(normal, light.ToLight);
    // Twice the diagonal of the scene away nothing stands any more.
    if (!(cosine > 0.0) ||
      (field &&
        !field->IsVisible(end,
          field->FindEnd(glm::vec3(position + 2.0 * light.ToLight), glm::vec3(-light.ToLight)))))
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
  const std::vector<float> position = table.ReadBack(vtkVirtualLightSampler::PositionArea);
  const std::vector<float> normal = table.ReadBack(vtkVirtualLightSampler::NormalExponent);
  const std::vector<float> density = table.ReadBack(vtkVirtualLightSampler::DensityArea);
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
vtkVirtualLightSampler* vtkRSMReferencePass::ChooseSampler(
  vtkVirtualLightSampler* users, const vtkIndirectPlan&)
{
  return this->Mode == ALL_TEXELS ? this->Internal->AllTexels.Get() : users;
}

//------------------------------------------------------------------------------
vtkIndirectEstimate vtkRSMReferencePass::Estimate(const Input& input)
{
  vtkIndirectStageTimer& timer = input.Timer;
  const vtkIndirectFrame& frame = input.Frame;
  if (!this->Irradiance->Resize(frame.Window, frame.Size[0], frame.Size[1]) ||
    !this->ResizeGlossy(input))
  {
    return {};
  }
  timer.Begin(vtkIndirectStageTimer::Estimate);
  std::vector<DirectionLight> directions;
  const std::vector<SenderBlock> senders = ReadSenders(*input.Lights, directions);
  const vtkIndirectDistanceField* const field =
    input.Visibility.HidesSenders() ? &input.Visibility.GetVolume().GetDistanceField() : nullptr;
  const SenderEnds ends = field ? FindEnds(senders, *field) : SenderEnds();
  const std::vector<float> surfaces =
    input.Geometry.GetTarget().ReadBack(vtkIndirectGeometryBuffer::Surface);
  const size_t pixels = surfaces.size() / 4;
  const std::vector<float> specular = this->HasGlossy
    ? input.Geometry.GetTarget().ReadBack(vtkIndirectGeometryBuffer::Specular)
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
          if (field)
          {
            FindVisible(senders, ends, *field, receiver, visible);
          }
          const SenderBlock* blocks = field ? visible.data() : senders.data();
          Sum(blocks, senders.size(), receiver, total);
          const float* lobe = this->HasGlossy ? &specular[4 * p] : nullptr;
          const bool mirrors = lobe && std::max({ lobe[0], lobe[1], lobe[2] }) > 0.0f;
          double reflected[3] = { 0.0, 0.0, 0.0 };
          SumDirections(directions, field, receiver, mirrors ? lobe[3] : -1.0, total, reflected);
          if (mirrors)
          {
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
  return this->MakeResult();
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
