// SPDX-License-Identifier: BSD-3-Clause
// Every debug view shows its buffer: the picture is the buffer's value under this test's mapping.
#include "vtkIndirectContractUtilities.h"
#include "vtkIndirectDetails.h"

#include "vtkAreaLight.h"
#include "vtkEnvironmentLight.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMultiresolutionSplattingPass.h"
#include "vtkRSMGatherPass.h"
#include "vtkRadianceHintsPass.h"
#include "vtkRenderWindow.h"

#include <algorithm>

using namespace contract;

namespace
{
constexpr int Maps = 2;

// The names that an error lists, with a number for <i>: buffers of views, `lights`, `branches` and
// `lobes`.
std::vector<std::string> FindNames(vtkIndirectIlluminationPass* pass)
{
  ExpectedErrors errors;
  vtkNew<vtkImageData> image;
  pass->CopyBuffer("no such buffer", image);
  const std::string text = errors.GetText();
  const std::string before = "known are ";
  std::vector<std::string> names;
  size_t at = text.find(before);
  at = at == std::string::npos ? text.size() : at + before.size();
  for (bool more = at < text.size(); more;)
  {
    size_t end = text.find(", ", at);
    const size_t last = text.find(".\n", at);
    more = end != std::string::npos && end < last;
    end = more ? end : last;
    const std::string name = text.substr(at, end - at);
    for (int map = 0; map < (name.compare(0, 3, "rsm") == 0 ? Maps : 1); ++map)
    {
      const size_t index = name.find("<i>");
      names.push_back(index == std::string::npos
          ? name
          : name.substr(0, index) + std::to_string(map) + name.substr(index + 3));
    }
    at = end + 2;
  }
  return names;
}

bool EndsWith(const std::string& text, const std::string& end)
{
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// Value * scale + bias as eight bits.
struct Mapping
{
  double Scale = 1.0;
  double Bias = 0.0;
};

// Colours unchanged, directions from [-1, 1], levels over eight, depths over the far plane; the
// scale of a light map's depth is found from the picture, which must use one scale everywhere.
Mapping FindMapping(
  const std::string& name, const Floats& buffer, const Pixels& shown, vtkCamera* camera)
{
  if (EndsWith(name, "normal"))
  {
    return { 0.5, 0.5 };
  }
  if (name == "depth")
  {
    return { 1.0 / camera->GetClippingRange()[1], 0.0 };
  }
  if (name == "subsplat.level")
  {
    return { 1.0 / 8.0, 0.0 };
  }
  if (EndsWith(name, ".depth"))
  {
    const float farthest = *std::max_element(buffer.Values.begin(), buffer.Values.end());
    double brightest = 0.0;
    for (size_t i = 0; i < shown.Values.size(); i += 4)
    {
      brightest = std::max(brightest, static_cast<double>(shown.Values[i]));
    }
    CONTRACT_CHECK(brightest > 64.0 && brightest <= 255.0, name << ": brightest " << brightest);
    return { brightest / 255.0 / farthest, 0.0 };
  }
  return {};
}

// Returns true if the picture is not empty.
bool CheckView(
  const std::string& name, const Floats& buffer, const Pixels& shown, vtkCamera* camera)
{
  const Mapping mapping = FindMapping(name, buffer, shown, camera);
  // One of the picture's steps is 1/255, and the scale of a map's depths is known to half of one.
  const double tolerance = name.find("rsm") == 0 && EndsWith(name, ".depth") ? 1.02 : ByteRounding;
  double worst = 0.0;
  int least = 255;
  int most = 0;
  for (int y = 0; y < shown.Height; ++y)
  {
    for (int x = 0; x < shown.Width; ++x)
    {
      // The texel below the pixel's centre.
      const int u = static_cast<int>((x + 0.5) / shown.Width * buffer.Width);
      const int v = static_cast<int>((y + 0.5) / shown.Height * buffer.Height);
      for (int c = 0; c < 3; ++c)
      {
        // A view of one component uses only red; green and blue are undefined.
        if (c > 0 && buffer.Components == 1)
        {
          continue;
        }
        const double value = buffer.Get(u, v, c) * mapping.Scale + mapping.Bias;
        const double wanted = 255.0 * std::min(std::max(value, 0.0), 1.0);
        const int found = shown.Get(x, y, c);
        worst = std::max(worst, std::abs(found - wanted));
        least = std::min(least, found);
        most = std::max(most, found);
      }
    }
  }
  std::cout << name << ": worst " << worst << " steps, from " << least << " to " << most << "\n";
  CONTRACT_CHECK(worst <= tolerance, name << ": " << worst << " steps of 1/255");
  return most - least >= 2;
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ViewsShowBuffers)
{
  View view(160, 120);
  AddRoom(view.Renderer);
  view.Renderer->AddLight(MakeLight(LightKind::Point, { 0.7, 0.7, 0.6 }, { 0.5, 0.0, 0.5 }));
  auto ball = MakeSphere({ 0.3, 0.2, 0.6 }, 0.15, { 0.4, 0.7, 0.9 });
  ball->GetProperty()->SetSpecular(0.6);
  ball->GetProperty()->SetSpecularPower(8.0);
  view.Renderer->AddActor(ball);
  auto catcher = MakeQuad({ 0.5, 0.2, 0.8 }, { 0.5, 0.2, 0.9 }, { 0.6, 0.2, 0.8 });
  vtkNew<vtkInformation> keys;
  keys->Set(vtkIndirectIlluminationPass::CATCHES_LIGHT(), 1);
  catcher->SetPropertyKeys(keys);
  view.Renderer->AddActor(catcher);
  view.Renderer->ResetCameraClippingRange();
  vtkNew<vtkIndirectIlluminationPass> pass;
  pass->SetReflectiveShadowMapResolution(96);
  vtkNew<vtkEnvironmentLight> sky;
  sky->SetRadiance(0.1, 0.15, 0.2);
  pass->SetEnvironment(sky);
  vtkNew<vtkAreaLight> lamp;
  lamp->SetOrigin(0.3, 0.9, 0.3);
  lamp->SetPoint1(0.7, 0.9, 0.3);
  lamp->SetPoint2(0.3, 0.9, 0.7);
  lamp->SetRadiance(0.4, 0.4, 0.3);
  pass->AddAreaLight(lamp);
  view.Renderer->SetPass(pass);
  vtkNew<vtkRSMGatherPass> gather;
  vtkNew<vtkMultiresolutionSplattingPass> splatting;
  SET_DETAIL(splatting, CoarsestResolution, 16);
  vtkNew<vtkRadianceHintsPass> hints;
  hints->SetGridResolution(6, 5, 6);
  int views = 0;
  for (vtkIndirectEstimatorPass* estimator :
    std::initializer_list<vtkIndirectEstimatorPass*>{ gather, splatting, hints })
  {
    pass->SetEstimator(estimator);
    pass->SetDebugView("");
    const Pixels picture = view.Grab();
    for (const std::string& name : FindNames(pass))
    {
      const bool isMap = name.compare(0, 3, "rsm") == 0;
      // Views independent of the estimator are tested once.
      const bool own = name == "final" || name == "indirect" || name == "irradiance" ||
        name == "bounce" || name == "glossy" || name.compare(0, 8, "subsplat") == 0;
      if (name == "lights" || name == "branches" || name == "lobes" ||
        (estimator != gather && (isMap || !own)) || (estimator == hints && name == "glossy"))
      {
        continue;
      }
      pass->SetDebugView(name);
      const Pixels shown = view.Grab();
      const bool something =
        CheckView(name, Read(pass, name), shown, view.Renderer->GetActiveCamera());
      // A level may have no subsplat of its own.
      CONTRACT_CHECK(something || name.find("evaluated") != std::string::npos, name << " is empty");
      views += something;
      if (name == "final")
      {
        // The picture of the frame is this view, but for the background.
        CONTRACT_CHECK(Compare(shown, picture).Pixels < shown.Values.size() / 8, "the picture");
      }
    }
  }
  std::cout << views << " views\n";
  // Ten views of the frame, three for each map, and for splatting those that depend on it and some
  // of its own.
  CONTRACT_CHECK(views >= 10 + 3 * Maps + 4 + 2 + 4 + 3, views << " views");
  pass->SetEstimator(nullptr);
}
