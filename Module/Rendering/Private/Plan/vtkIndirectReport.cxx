// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Plan/vtkIndirectReport.h"

#include "OpenGL/vtkIndirectShaderLibrary.h"
#include "Plan/vtkIndirectStageTimer.h"
#include "vtkIndirectVersion.h"
#include "vtkVersion.h"

#include <nlohmann/json.hpp>

#include <charconv>
#include <type_traits>

using JSON = nlohmann::ordered_json;

namespace
{
JSON List(const vtkIndirectReport::Entries& entries)
{
  JSON list = JSON::array();
  for (const auto& entry : entries)
  {
    list.push_back({ { "what", entry.first }, { "why", entry.second } });
  }
  return list;
}

JSON GetTimes(const vtkIndirectStageTimer& timer, int stage)
{
  const auto wall = timer.Get(stage);
  JSON times = { { "median_ms", wall.MedianMilliseconds },
    { "p95_ms", wall.Percentile95Milliseconds } };
  const auto ofGPU = timer.Get(stage, vtkIndirectStageTimer::GPU);
  if (ofGPU.Count > 0)
  {
    times["gpu_median_ms"] = ofGPU.MedianMilliseconds;
    times["gpu_p95_ms"] = ofGPU.Percentile95Milliseconds;
  }
  return times;
}

// All stages other than the delegate, the geometry buffer and the lights' maps.
constexpr unsigned int IndirectStages = 1u << vtkIndirectStageTimer::Lights |
  1u << vtkIndirectStageTimer::Visibility | 1u << vtkIndirectStageTimer::Sky |
  1u << vtkIndirectStageTimer::Inject | 1u << vtkIndirectStageTimer::Bounces |
  1u << vtkIndirectStageTimer::Estimate | 1u << vtkIndirectStageTimer::Upsample |
  1u << vtkIndirectStageTimer::Composite;
}

//------------------------------------------------------------------------------
std::string vtkIndirectReport::Number(double value, int digits)
{
  char text[40];
  const std::to_chars_result result = digits > 0
    ? std::to_chars(text, text + sizeof(text), value, std::chars_format::general, digits)
    : std::to_chars(text, text + sizeof(text), value);
  return std::string(text, result.ptr);
}

//------------------------------------------------------------------------------
void vtkIndirectReport::ReadGL()
{
  auto text = [](GLenum name)
  {
    const auto* value = reinterpret_cast<const char*>(glGetString(name));
    return std::string(value ? value : "");
  };
  this->GLRenderer = text(GL_RENDERER);
  this->GLVersion = text(GL_VERSION);
}

//------------------------------------------------------------------------------
std::string vtkIndirectReport::ToJSON(const vtkIndirectStageTimer& timer) const
{
  JSON settings = JSON::object();
  for (const auto& setting : this->Settings.GetEntries())
  {
    std::visit(
      [&](const auto& value)
      {
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, vtkIndirectSettingList::Choice>)
        {
          settings[setting.first] = value.GetScriptName();
        }
        else
        {
          settings[setting.first] = value;
        }
      },
      setting.second);
  }
  JSON stages = JSON::object();
  for (int stage = 0; stage < vtkIndirectStageTimer::Frame; ++stage)
  {
    const auto wall = timer.Get(stage);
    if (wall.Count > 0 && wall.Percentile95Milliseconds > 0.0)
    {
      stages[vtkIndirectStageTimer::GetName(stage)] = GetTimes(timer, stage);
    }
  }
  const bool timed = timer.GetNumberOfFrames() > 0;
  JSON report = { { "schema", "vtkindirect.report/1" }, { "scene", "" },
    { "size", { this->Size[0], this->Size[1] } }, { "method", this->Method },
    { "settings", settings }, { "frames", timer.GetNumberOfFrames() }, { "stages", stages },
    { "indirect_ms", nullptr }, { "frame_ms", nullptr } };
  if (timed)
  {
    report["indirect_ms"] = timer.GetSum(IndirectStages).MedianMilliseconds;
    report["frame_ms"] = timer.Get(vtkIndirectStageTimer::Frame).MedianMilliseconds;
    const auto ofGPU = timer.Get(vtkIndirectStageTimer::Frame, vtkIndirectStageTimer::GPU);
    if (ofGPU.Count > 0)
    {
      report["gpu_indirect_ms"] =
        timer.GetSum(IndirectStages, vtkIndirectStageTimer::GPU).MedianMilliseconds;
      report["gpu_frame_ms"] = ofGPU.MedianMilliseconds;
    }
  }
  report["virtual_lights"] = this->VirtualLights;
  report["bytes"] = this->Bytes;
  report["main_memory_bytes"] = this->MainMemoryBytes;
  report["estimated_error"] = this->EstimatedError >= 0.0 ? JSON(this->EstimatedError) : JSON();
  report["modelled"] = List(this->Modelled);
  report["left_out"] = List(this->LeftOut);
  report["changed"] = this->Changed;
  report["counters"] = this->Counters;
  report["paths"] = JSON::object();
  for (const auto& path : this->BackEndChoices)
  {
    report["paths"][path.first] = path.second;
  }
  report["gl"] = { { "renderer", this->GLRenderer }, { "version", this->GLVersion } };
  report["vtk"] = vtkVersion::GetVTKVersion();
  report["version"] = VTK_INDIRECT_VERSION;
  report["shader_hash"] = vtkIndirectShaderLibrary::GetHash();
  return report.dump(2, ' ', false, JSON::error_handler_t::replace) + "\n";
}
