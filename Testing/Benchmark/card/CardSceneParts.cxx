// SPDX-License-Identifier: BSD-3-Clause
#include "CardSceneParts.h"
#include "vtkIndirectDetails.h"

#include "CardExpected.h"
#include "CardImages.h"
#include "CardMeasure.h"
#include "CardMethods.h"
#include "CardScene.h"

#include "OpenGL/vtkIndirectBackEndChoices.h"
#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkIndirectIlluminationPass.h"
#include "vtkMultiresolutionSplattingPass.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <stdexcept>

using Json = nlohmann::json;
namespace fs = std::filesystem;

namespace
{
using Size = std::pair<int, int>;

//------------------------------------------------------------------------------
std::vector<std::string> ListScenes(const card::Options& options)
{
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(options.Pack + "/scenes", error))
  {
    if (fs::exists(entry.path() / "scene.json"))
    {
      names.push_back(entry.path().filename().string());
    }
  }
  if (names.empty())
  {
    throw std::runtime_error("there are no scenes in " + options.Pack + "/scenes");
  }
  std::sort(names.begin(), names.end());
  return names;
}

// The sizes for which the pack has values, smallest first.
std::vector<Size> ListSizes(const card::Options& options, const std::string& scene)
{
  std::vector<Size> sizes;
  for (const auto& entry : fs::directory_iterator(options.Pack + "/scenes/" + scene))
  {
    Size size;
    if (std::sscanf(entry.path().filename().c_str(), "expected-%dx%d.msgpack", &size.first,
          &size.second) == 2)
    {
      sizes.push_back(size);
    }
  }
  std::sort(sizes.begin(), sizes.end());
  return sizes;
}

std::string GetText(const Size& size)
{
  return std::to_string(size.first) + "x" + std::to_string(size.second);
}

// A scene in its window, opened when it is first needed and kept for the units that follow.
class Stage
{
public:
  Stage(const card::Options& options, const std::string& scene, const Size& size)
    : Options(options)
    , Folder(options.Pack + "/scenes/" + scene)
    , Pixels(size)
  {
  }

  card::Scene& Get()
  {
    if (!this->Scene)
    {
      auto scene = std::make_unique<card::Scene>(this->Folder);
      scene->Open(this->Pixels.first, this->Pixels.second);
      this->Values =
        std::make_unique<card::Expected>(this->Folder, this->Pixels.first, this->Pixels.second);
      this->Scene = std::move(scene);
    }
    return *this->Scene;
  }

  card::Expected& GetExpected()
  {
    this->Get();
    return *this->Values;
  }

  /** A buffer of the frame that was rendered last. */
  card::Image Copy(vtkIndirectIlluminationPass* pass, const std::string& buffer)
  {
    return buffer == "window" ? card::CopyWindow(this->Get()) : card::CopyBuffer(pass, buffer);
  }

  /** Renders the method; returns what was found, with rows and checks. `label` names pictures. */
  Json Run(const card::Method& method, const std::string& label);

private:
  Json Check(const card::Method& method, const std::string& label,
    vtkIndirectIlluminationPass* pass, Json& result);

  const card::Options& Options;
  std::string Folder;
  Size Pixels;
  std::unique_ptr<card::Scene> Scene;
  std::unique_ptr<card::Expected> Values;
};

//------------------------------------------------------------------------------
Json Stage::Check(const card::Method& method, const std::string& label,
  vtkIndirectIlluminationPass* pass, Json& result)
{
  Json checks = Json::array();
  for (const std::string& buffer : card::GetBufferNames(method))
  {
    const card::Image image = this->Copy(pass, buffer);
    std::vector<std::array<int, 2>> bad;
    Json check = this->Values->Check(method, buffer, image, bad);
    if (!check.at("passed"))
    {
      const std::string name = "pictures/" + this->Scene->Name + "-" + GetText(this->Pixels) + "-" +
        label + "-" + buffer + ".png";
      fs::create_directories(this->Options.Output + "/pictures");
      const float largest = *std::max_element(image.Values.begin(), image.Values.end());
      const double white = buffer == "window" ? 1.0 : largest > 0.0f ? largest : 1.0;
      check["picture"] =
        card::WritePicture(this->Options.Output + "/" + name, image, white, bad) ? name : "";
    }
    checks.push_back(check);
    if (buffer == "irradiance")
    {
      const card::Image mask = this->Scene->GetReference("mask");
      for (const char* layer : { "R1", "R2", "R3" })
      {
        const card::Errors errors = card::Compare(image, this->Scene->GetReference(layer), mask);
        result["errors"][layer] = { { "nrmse", errors.RootMeanSquare },
          { "relmse", errors.Relative }, { "bias", errors.Bias },
          { "receivers", errors.Receivers } };
      }
      if (method.IsWalked())
      {
        checks.push_back(this->Values->CheckError(method, result["errors"]["R3"]["nrmse"]));
      }
    }
  }
  return checks;
}

//------------------------------------------------------------------------------
Json Stage::Run(const card::Method& method, const std::string& label)
{
  card::Scene& scene = this->Get();
  vtkIndirectIlluminationPass* pass = card::Enable(scene, method);
  const auto begin = std::chrono::steady_clock::now();
  scene.Window->Render();
  scene.Window->WaitForCompletion();
  const double first =
    std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  Json result = { { "scene", scene.Name }, { "method", method.Name },
    { "width", this->Pixels.first }, { "height", this->Pixels.second } };
  result["checks"] = this->Check(method, label, pass, result);
  result.update(card::Measure(scene, pass));
  result["rows"].push_back({ { "stage", "first frame" }, { "frames", 1 }, { "gpu_ms", nullptr },
    { "gpu_p95_ms", nullptr }, { "wall_ms", first }, { "wall_p95_ms", first } });
  const auto& checks = result.at("checks");
  const bool passed = std::all_of(
    checks.begin(), checks.end(), [](const Json& check) { return check.at("passed").get<bool>(); });
  result["status"] = passed ? "passed" : "failed";
  scene.Renderer->SetPass(nullptr);
  return result;
}

const char* const Defaults = "defaults";

// Scenes for back-end choices: many triangles in one, light from several maps in the other.
std::vector<std::string> ChooseScenes(const card::Options& options)
{
  std::vector<std::string> chosen;
  const std::vector<std::string> all = ListScenes(options);
  for (const std::string& name : all)
  {
    if (name == "frog" || name == "room_fire")
    {
      chosen.push_back(name);
    }
  }
  return chosen.empty() ? std::vector<std::string>{ all[0] } : chosen;
}
}

//------------------------------------------------------------------------------
std::vector<card::Part> card::MakeSceneParts(const Options& options, bool smallest)
{
  std::vector<Part> parts;
  std::vector<std::pair<Size, std::string>> order;
  for (const std::string& scene : ListScenes(options))
  {
    const std::vector<Size> sizes = ListSizes(options, scene);
    for (const Size& size : sizes)
    {
      if ((size == sizes[0]) == smallest)
      {
        order.emplace_back(size, scene);
      }
    }
  }
  std::sort(order.begin(), order.end());
  for (const auto& [size, scene] : order)
  {
    auto stage = std::make_shared<Stage>(options, scene, size);
    Part part;
    part.Name = scene + "-" + GetText(size);
    for (const Method& method : GetMethods())
    {
      part.Units.emplace_back(method.Name);
    }
    part.Run = [stage](const std::string& unit) { return stage->Run(FindMethod(unit), unit); };
    parts.push_back(part);
  }
  return parts;
}

//------------------------------------------------------------------------------
card::Part card::MakePathsPart(const Options& options)
{
  using Splatting = vtkMultiresolutionSplattingPass;
  // Storage is a detail of the pass and no back-end choice.
  static const std::map<std::string, void (*)(Splatting*)> properties = {
    { "Storage=Float", [](Splatting* pass) { SET_DETAIL(pass, HalfFloats, false); } },
  };
  Part part;
  part.Name = "paths";
  part.Units = { Defaults };
  for (const auto& path : vtkIndirectBackEndChoices::List())
  {
    for (const std::string& value : path.second)
    {
      part.Units.push_back(path.first + "=" + value);
    }
  }
  for (const auto& property : properties)
  {
    part.Units.push_back(property.first);
  }
  // Difference of two measurements of the same thing.
  part.Units.emplace_back("defaults again");

  auto stages = std::make_shared<std::vector<std::unique_ptr<Stage>>>();
  part.Run = [&options, stages](const std::string& unit)
  {
    if (stages->empty())
    {
      for (const std::string& scene : ChooseScenes(options))
      {
        stages->push_back(std::make_unique<Stage>(options, scene, ListSizes(options, scene).at(0)));
      }
    }
    const auto property = properties.find(unit);
    const bool isPath = property == properties.end() && unit.find('=') != std::string::npos;
    setenv("VTK_INDIRECT_PATHS", isPath ? unit.c_str() : "", 1);
    Json result = { { "status", "passed" }, { "frames_of", Json::array() } };
    for (const auto& stage : *stages)
    {
      for (const char* name : { "automatic", "gather-every-pixel", "hints" })
      {
        Method method = FindMethod(name);
        if (property != properties.end())
        {
          if (std::string(name) != "automatic")
          {
            continue;
          }
          const auto set = property->second;
          method.SetUp = [set](vtkIndirectIlluminationPass* pass)
          {
            vtkNew<Splatting> splatting;
            set(splatting);
            pass->SetEstimator(splatting);
          };
        }
        Json frame = stage->Run(method, unit + "-" + name);
        frame["path"] = unit;
        if (frame.at("status") != "passed")
        {
          result["status"] = "failed";
        }
        result["frames_of"].push_back(frame);
      }
    }
    return result;
  };
  return part;
}

//------------------------------------------------------------------------------
void card::Record(const Options& options)
{
  if (options.Sizes.empty())
  {
    throw std::runtime_error("record needs at least one --size");
  }
  for (const std::string& scene : ListScenes(options))
  {
    for (const Size& size : options.Sizes)
    {
      std::cout << "recording " << scene << ", " << GetText(size) << std::endl;
      Stage stage(options, scene, size);
      for (const Method& method : GetMethods())
      {
        vtkIndirectIlluminationPass* pass = Enable(stage.Get(), method);
        stage.Get().Window->Render();
        for (const std::string& buffer : GetBufferNames(method))
        {
          const card::Image image = stage.Copy(pass, buffer);
          stage.GetExpected().Record(method.Name, buffer, image);
          if (buffer == "irradiance" && method.IsWalked())
          {
            card::Scene& judge = stage.Get();
            stage.GetExpected().RecordError(method.Name,
              card::Compare(image, judge.GetReference("R3"), judge.GetReference("mask"))
                .RootMeanSquare);
          }
        }
        stage.Get().Renderer->SetPass(nullptr);
      }
      stage.GetExpected().Write();
    }
  }
}
