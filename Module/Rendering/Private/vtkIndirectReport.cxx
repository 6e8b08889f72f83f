// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectReport.h"

#include "vtkIndirectShaderLibrary.h"
#include "vtkIndirectStageTimer.h"
#include "vtkIndirectVersion.h"
#include "vtkVersion.h"

#include <cstdio>
#include <locale>
#include <sstream>

namespace
{
std::string List(const vtkIndirectReport::Entries& entries)
{
  std::string out = "[";
  for (const auto& entry : entries)
  {
    out += out.size() > 1 ? ", " : "";
    out += "{\"what\": " + vtkIndirectReport::Quote(entry.first) +
      ", \"why\": " + vtkIndirectReport::Quote(entry.second) + "}";
  }
  return out + "]";
}
}

//------------------------------------------------------------------------------
std::string vtkIndirectReport::Quote(const std::string& text)
{
  std::string out = "\"";
  for (char c : text)
  {
    if (c == '"' || c == '\\')
    {
      out += '\\';
      out += c;
    }
    else if (static_cast<unsigned char>(c) < 0x20)
    {
      char escape[8];
      std::snprintf(escape, sizeof(escape), "\\u%04x", static_cast<unsigned int>(c));
      out += escape;
    }
    else
    {
      out += c;
    }
  }
  return out + "\"";
}

//------------------------------------------------------------------------------
std::string vtkIndirectReport::ToJSON(const vtkIndirectStageTimer& timer) const
{
  std::ostringstream os;
  os.imbue(std::locale::classic());
  os << "{\n  \"schema\": \"vtkindirect.report/1\",\n  \"scene\": \"\",\n  \"size\": ["
     << this->Size[0] << ", " << this->Size[1] << "],\n  \"method\": " << Quote(this->Method)
     << ",\n  \"settings\": {";
  const char* separator = "";
  for (const auto& setting : this->Settings)
  {
    os << separator << Quote(setting.first) << ": " << setting.second;
    separator = ", ";
  }
  os << "},\n  \"frames\": " << timer.GetNumberOfFrames() << ",\n  \"stages\": {";
  separator = "";
  for (int stage = 0; stage < vtkIndirectStageTimer::Frame; ++stage)
  {
    const auto statistics = timer.Get(stage);
    if (statistics.Count > 0 && statistics.Percentile95Milliseconds > 0.0)
    {
      os << separator << "\n    " << Quote(vtkIndirectStageTimer::GetName(stage))
         << ": {\"median_ms\": " << statistics.MedianMilliseconds
         << ", \"p95_ms\": " << statistics.Percentile95Milliseconds << "}";
      separator = ",";
    }
  }
  const unsigned int indirect = 1u << vtkIndirectStageTimer::Lights |
    1u << vtkIndirectStageTimer::Visibility | 1u << vtkIndirectStageTimer::Inject |
    1u << vtkIndirectStageTimer::Bounces | 1u << vtkIndirectStageTimer::Estimate |
    1u << vtkIndirectStageTimer::Upsample | 1u << vtkIndirectStageTimer::Composite;
  os << "\n  },\n";
  if (timer.GetNumberOfFrames() > 0)
  {
    os << "  \"indirect_ms\": " << timer.GetSum(indirect).MedianMilliseconds
       << ",\n  \"frame_ms\": " << timer.Get(vtkIndirectStageTimer::Frame).MedianMilliseconds
       << ",\n";
  }
  else
  {
    os << "  \"indirect_ms\": null,\n  \"frame_ms\": null,\n";
  }
  os << "  \"virtual_lights\": " << this->VirtualLights << ",\n  \"bytes\": " << this->Bytes
     << ",\n  \"estimated_error\": ";
  if (this->EstimatedError >= 0.0)
  {
    os << this->EstimatedError;
  }
  else
  {
    os << "null";
  }
  os << ",\n  \"modelled\": " << List(this->Modelled)
     << ",\n  \"left_out\": " << List(this->LeftOut)
     << ",\n  \"gl\": {\"renderer\": " << Quote(this->GLRenderer)
     << ", \"version\": " << Quote(this->GLVersion)
     << "},\n  \"vtk\": " << Quote(vtkVersion::GetVTKVersion())
     << ",\n  \"version\": " << Quote(VTK_INDIRECT_VERSION)
     << ",\n  \"shader_hash\": " << Quote(vtkIndirectShaderLibrary::GetHash()) << "\n}\n";
  return os.str();
}
