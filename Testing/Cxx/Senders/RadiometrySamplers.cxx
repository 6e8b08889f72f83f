// SPDX-License-Identifier: BSD-3-Clause
// Samplers other than that of the maps: light from directions, several samplers in one frame, and a
// scene without any vtkLight.
#include "vtkIndirectTestUtilities.h"

#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectSamplePattern.h"
#include "Senders/vtkIndirectSampler.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLFramebufferObject.h"
#include "vtkRSMGatherPass.h"
#include "vtkRSMReferencePass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkUniformLightSampler.h"

#include <cmath>

using namespace vtkIndirectTest;

namespace
{
// Uniform radiance from all sides, as directions.
class SkyLights : public vtkIndirectSampler
{
public:
  int Count = 2048;
  glm::dvec3 Radiance{ 0.25, 0.5, 1.0 };

  vtkIndirectSamplerAbilities GetAbilities() const override
  {
    vtkIndirectSamplerAbilities abilities;
    abilities.Directions = true;
    return abilities;
  }

  bool Update(const Input& input) override
  {
    if (this->GetActualNumberOfLights() == this->Count && this->GetTable().GetWidth() > 0)
    {
      return true;
    }
    if (!this->Resize(input.Frame.Window, this->Count))
    {
      return false;
    }
    vtkIndirectTarget& table = this->BeginChange();
    const size_t size = 4 * static_cast<size_t>(table.GetWidth()) * table.GetHeight();
    std::vector<float> rows[3] = { std::vector<float>(size), std::vector<float>(size),
      std::vector<float>(size) };
    const double angle = 4.0 * 3.14159265358979323846 / this->Count;
    for (int i = 0; i < this->Count; ++i)
    {
      const glm::dvec3 direction = vtkIndirectSamplePattern::DirectionInCone(i, this->Count, -1.0);
      for (int c = 0; c < 3; ++c)
      {
        rows[0][4 * i + c] = static_cast<float>(direction[c]);
        rows[1][4 * i + c] = static_cast<float>(-direction[c]);
        rows[2][4 * i + c] = static_cast<float>(this->Radiance[c] * angle);
      }
      rows[0][4 * i + 3] = static_cast<float>(-angle);
    }
    for (int channel = 0; channel < 3; ++channel)
    {
      table.Write(channel, rows[channel]);
    }
    return true;
  }
};

class Sky : public vtkVirtualLightSampler
{
public:
  static Sky* New() { VTK_STANDARD_NEW_BODY(Sky); }
  vtkTypeMacro(Sky, vtkVirtualLightSampler);

  SkyLights& GetLights() { return static_cast<SkyLights&>(*vtkIndirectSampler::Get(this)); }

protected:
  Sky()
    : vtkVirtualLightSampler(std::make_unique<SkyLights>())
  {
  }
};

struct SkyScene : Scene
{
  vtkNew<vtkMultiresolutionSplattingPass> Splatting;
  vtkNew<vtkRSMReferencePass> Reference;
  vtkNew<vtkRadianceHintsPass> Hints;
  vtkNew<Sky> Light;

  SkyScene(int width, int height)
    : Scene(width, height)
  {
    this->Gather->SetModeToVirtualLights();
    this->Reference->SetModeToVirtualLights();
    this->Pass->SetReflectiveShadowMapResolution(64);
    this->Pass->AddSampler(this->Light);
  }
  ~SkyScene() { this->Pass->SetEstimator(nullptr); }

  Image Measure(vtkIndirectEstimatorPass* estimator, bool voxels)
  {
    this->Pass->SetEstimator(estimator);
    this->Pass->SetVisibility(
      voxels ? vtkIndirectIlluminationPass::VOXELS : vtkIndirectIlluminationPass::NONE);
    this->Render();
    return this->Copy("irradiance");
  }
};

double Worst(const Image& image, const glm::dvec3& expected)
{
  double worst = 0.0;
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      const glm::dvec3 color = image.Color(x, y);
      for (int c = 0; c < 3; ++c)
      {
        worst = std::max(worst, std::abs(color[c] - expected[c]) / expected[c]);
      }
    }
  }
  return worst;
}
}

// A uniform radiance L gives every surface E = L, and a diffuse surface reflects albedo times that,
// without any vtkLight.
VTK_INDIRECT_TEST(SamplersDirections)
{
  SkyScene scene(48, 36);
  // One quad that fills the view, seen from the side, without neighbours.
  scene.AddQuad({ -9, -9, 0 }, { 9, -9, 0 }, { -9, 9, 3 }, { 0.5, 0.5, 0.5 });
  scene.SetEye({ 0, 0, 3 }, { 0.2, 0.1, 0 }, { 0, 1, 0 }, 50.0, 0.1, 20.0);
  for (vtkIndirectEstimatorPass* estimator : std::initializer_list<vtkIndirectEstimatorPass*>{
         scene.Gather, scene.Splatting, scene.Reference })
  {
    const std::string name = estimator->GetMethodName();
    const Image e = scene.Measure(estimator, false);
    // The quadrature of a cosine by 2048 directions, and half floats.
    CheckAtMost(name + ": worst E over L - 1", Worst(e, scene.Light->GetLights().Radiance), 2e-3,
      "2048 directions of a Fibonacci lattice, and half floats");
    CheckRelative(name + ": picture", scene.Copy("final").Mean(1), 0.5 * e.Mean(1), 3e-3,
      "albedo E, the albedo in ten bits");
    CheckEqual(name + ": lights", scene.ReadReport("virtual_lights"), 2048);
  }
  // Harmonics of order 2 represent a constant exactly.
  const Image e = scene.Measure(scene.Hints, false);
  CheckAtMost("hints: worst E over L - 1", Worst(e, scene.Light->GetLights().Radiance), 0.02,
    "Ramamoorthi and Hanrahan 2001: below 1 % of lighting is beyond order 2; half of the sphere "
    "comes through the surface's own back");
}

// The lights of two samplers are summed, and either can be removed.
VTK_INDIRECT_TEST(SamplersSeveral)
{
  SkyScene scene(48, 36);
  scene.AddQuad({ -2, -2, 0 }, { 2, -2, 0 }, { -2, 2, 0 }, { 0.8, 0.4, 0.2 });
  scene.AddQuad({ -2, 2, 0 }, { 2, 2, 0 }, { -2, 2, 3 }, { 0.2, 0.4, 0.8 });
  scene.AddSpot({ 0, -3, 4 }, { 0, 1, 0 }, 30.0, 0.0, { 1, 0, 0 });
  scene.SetEye({ 0, -5, 3 }, { 0, 1, 0.5 }, { 0, 0, 1 }, 40.0, 0.1, 20.0);
  scene.Sampler->SetNumberOfLights(300);
  scene.Light->GetLights().Count = 700;
  for (vtkIndirectEstimatorPass* estimator : std::initializer_list<vtkIndirectEstimatorPass*>{
         scene.Gather, scene.Splatting, scene.Reference })
  {
    const std::string name = estimator->GetMethodName();
    const Image both = scene.Measure(estimator, false);
    CheckEqual(name + ": lights of both", scene.ReadReport("virtual_lights"), 1000);
    const std::vector<VirtualLight> lights = scene.CopyLights();
    CheckEqual(name + ": rows of the buffer", static_cast<double>(lights.size()), 1000);
    Check(name + ": the senders come first", lights[299].Area > 0.0 && lights[300].Area < 0.0);
    CheckRelative(name + ": solid angle of a row", -lights[999].Area,
      4.0 * 3.14159265358979323846 / 700.0, 1e-6, "single precision");
    scene.Pass->RemoveSampler(scene.Light);
    const Image maps = scene.Measure(estimator, false);
    CheckEqual(name + ": lights of the maps", scene.ReadReport("virtual_lights"), 300);
    scene.Pass->AddSampler(scene.Light);
    scene.SetIntensities(0.0);
    const Image sky = scene.Measure(estimator, false);
    CheckEqual(name + ": lights of the sky", scene.ReadReport("virtual_lights"), 700);
    scene.SetIntensities(1.0);
    double worst = 0.0;
    for (size_t i = 0; i < both.Values.size(); ++i)
    {
      worst = std::max<double>(worst,
        std::abs(both.Values[i] - maps.Values[i] - sky.Values[i]) /
          std::max(both.Values[i], 1e-3f));
    }
    CheckAtLeast(name + ": light of the maps over that of both", maps.Mean() / both.Mean(), 0.05,
      "the test's own power");
    CheckAtMost(name + ": sum of the two against both", worst,
      estimator == scene.Splatting.Get() ? 0.03 : 1e-5,
      "rounding; subsplats are other ones, each within its threshold");
  }
}

// A roof hides a part of the sky: closed form of a square over the middle of the floor.
VTK_INDIRECT_TEST(SamplersShadow)
{
  SkyScene scene(16, 16);
  scene.AddQuad({ -3, -3, 0 }, { 3, -3, 0 }, { -3, 3, 0 }, { 0.5, 0.5, 0.5 });
  scene.AddBox({ -1, -1, 1 }, { 1, 1, 1.05 }, { 0.5, 0.5, 0.5 });
  // The floor under the middle of the roof, from the side.
  scene.SetEye({ 0, -3.5, 0.5 }, { 0, 0, 0 }, { 0, 0, 1 }, 1.0, 0.1, 20.0);
  const double roof = PolygonFormFactor(
    { 0, 0, 0 }, { 0, 0, 1 }, { { -1, -1, 1 }, { 1, -1, 1 }, { 1, 1, 1 }, { -1, 1, 1 } });
  for (vtkIndirectEstimatorPass* estimator : std::initializer_list<vtkIndirectEstimatorPass*>{
         scene.Gather, scene.Splatting, scene.Reference })
  {
    const std::string name = estimator->GetMethodName();
    CheckRelative(name + ": without voxels", scene.Measure(estimator, false).Mean(2), 1.0, 3e-3,
      "the whole sky");
    // A voxel is 6 / 128: the roof is larger by at most one on each side.
    CheckRelative(name + ": under the roof", scene.Measure(estimator, true).Mean(2), 1.0 - roof,
      0.15, "edges of the roof are off by up to two voxels of 0.066");
  }
  scene.Reference->SetVisibilityToExact();
  CheckRelative("reference: under the roof, exactly", scene.Measure(scene.Reference, false).Mean(2),
    1.0 - roof, 0.01,
    "2048 directions: the roof's rim cuts about 60 cells, each off by half at most");
  CheckAtLeast("what the roof hides", roof, 0.5, "the test's own power");
}
