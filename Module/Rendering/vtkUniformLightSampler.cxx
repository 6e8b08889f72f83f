// SPDX-License-Identifier: BSD-3-Clause
#include "vtkUniformLightSampler.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Plan/vtkIndirectSettingList.h"
#include "Senders/vtkIndirectMapSampler.h"
#include "Senders/vtkIndirectSamplePattern.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkUniformLightSampler);

namespace
{
class UniformLights : public vtkIndirectMapSampler
{
public:
  explicit UniformLights(vtkUniformLightSampler& settings)
    : vtkIndirectMapSampler(&settings)
    , Set(settings)
  {
  }
  void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const override;
  Drawing GetDrawing() const override;
  void MakePattern(const std::vector<Source>& sources, std::vector<Sample>& pattern) override;

private:
  const vtkUniformLightSampler& Set;
};
}

//------------------------------------------------------------------------------
vtkUniformLightSampler::vtkUniformLightSampler()
  : vtkVirtualLightSampler(std::make_unique<UniformLights>(*this))
{
}

//------------------------------------------------------------------------------
void UniformLights::AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const
{
  this->vtkIndirectMapSampler::AddSettings(list, plan);
  static const char* const names[] = { "Grid", "Jittered", "LowDiscrepancy" };
  list.Add("Pattern", vtkIndirectSettingList::Choice{ names[this->Set.GetPattern()] })
    .Add("LitTexels", this->Set.GetLitTexels())
    .Add("AmbientOcclusion", this->Set.GetAmbientOcclusion());
}

//------------------------------------------------------------------------------
vtkIndirectMapSampler::Drawing UniformLights::GetDrawing() const
{
  Drawing drawing;
  drawing.By = this->Set.GetLitTexels() ? Drawing::LIT_TEXELS : Drawing::NOTHING;
  drawing.Modulated = this->Set.GetAmbientOcclusion();
  return drawing;
}

//------------------------------------------------------------------------------
void UniformLights::MakePattern(const std::vector<Source>& sources, std::vector<Sample>& pattern)
{
  const int places = this->Set.GetPattern();
  if (sources.empty())
  {
    return;
  }
  const int lights = sources.back().Light + 1;
  const int perLight = std::max(1, this->Set.GetNumberOfLights() / lights);
  for (size_t first = 0, end; first < sources.size(); first = end)
  {
    end = first;
    while (end < sources.size() && sources[end].Light == sources[first].Light)
    {
      ++end;
    }
    const int faces = static_cast<int>(end - first);
    const Source& shape = sources[first];
    // A disk in its square: the concentric map puts every light on the lit part.
    const double texels = static_cast<double>(shape.Size[0]) * shape.Size[1] *
      (shape.Disk ? vtkIndirectSamplePattern::DiskShare : 1.0);
    auto add = [&](double u, double v, int face, double weight)
    {
      if (shape.Disk)
      {
        vtkIndirectSamplePattern::SquareToDisk(u, v);
      }
      pattern.push_back({ static_cast<float>(u), static_cast<float>(v),
        static_cast<float>(sources[first + face].Layer), static_cast<float>(weight) });
    };

    if (places == vtkUniformLightSampler::LOW_DISCREPANCY && shape.CosCone <= 1.0)
    {
      // Directions are spread evenly over the cone of light, or the sphere: none is lost on faces,
      // or parts of them, that no light reaches. Each direction represents its share of the solid
      // angle.
      for (int i = 0; i < perLight; ++i)
      {
        const glm::vec3 direction(
          vtkIndirectSamplePattern::DirectionInCone(i, perLight, shape.CosCone));
        const int face = vtkIndirectKernels::vtkiFaceOf(direction);
        const glm::vec3 p = vtkIndirectKernels::vtkiToFace(direction, face);
        const glm::vec2 tangent(-p.x / p.z, -p.y / p.z);
        const double solidAngle = 2.0 * vtkMath::Pi() * (1.0 - shape.CosCone) / perLight;
        add(0.5 + 0.5 * tangent.x, 0.5 + 0.5 * tangent.y, face,
          solidAngle / vtkIndirectKernels::vtkiTexelSolidAngle(tangent, 2.0f / shape.Size[0]));
      }
      continue;
    }
    if (places == vtkUniformLightSampler::LOW_DISCREPANCY)
    {
      // The faces side by side are one long rectangle with a lattice over it.
      for (int i = 0; i < perLight; ++i)
      {
        const double along = (i + 0.5) / perLight * faces;
        const int face = std::min(static_cast<int>(along), faces - 1);
        add(along - face, vtkIndirectSamplePattern::GoldenRatioFraction(i), face,
          texels * faces / perLight);
      }
      continue;
    }
    const int edge =
      std::max(1, static_cast<int>(std::sqrt(static_cast<double>(perLight) / faces) + 1e-9));
    vtkIndirectSamplePattern::Random random(static_cast<unsigned int>(first));
    for (int face = 0; face < faces; ++face)
    {
      for (int j = 0; j < edge; ++j)
      {
        for (int i = 0; i < edge; ++i)
        {
          const double x = places == vtkUniformLightSampler::JITTERED ? random.Next() : 0.5;
          const double y = places == vtkUniformLightSampler::JITTERED ? random.Next() : 0.5;
          add((i + x) / edge, (j + y) / edge, face, texels / edge / edge);
        }
      }
    }
  }
}
