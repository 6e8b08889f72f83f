// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkIndirectReport.h"

#include "vtkIndirectShaderLibrary.h"
#include "vtkIndirectStageTimer.h"
#include "vtkIndirectVersion.h"
#include "vtkVersion.h"

#include <charconv>
#include <cmath>
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

// Bytes of the character of UTF-8 (RFC 3629) that begins at a place; 0 when none does.
size_t MeasureCharacter(const std::string& text, size_t at)
{
  auto byte = [&](size_t i)
  { return i < text.size() ? static_cast<unsigned char>(text[i]) : static_cast<unsigned char>(0); };
  const unsigned char first = byte(at);
  if (first < 0x80)
  {
    return 1;
  }
  const size_t length = first >= 0xf0 ? 4 : (first >= 0xe0 ? 3 : 2);
  // The second byte's range leaves out longer forms, surrogates, and what is beyond U+10FFFF.
  const unsigned char lower = first == 0xe0 ? 0xa0 : (first == 0xf0 ? 0x90 : 0x80);
  const unsigned char upper = first == 0xed ? 0x9f : (first == 0xf4 ? 0x8f : 0xbf);
  bool good = first >= 0xc2 && first <= 0xf4 && byte(at + 1) >= lower && byte(at + 1) <= upper;
  for (size_t i = 2; i < length; ++i)
  {
    good = good && (byte(at + i) & 0xc0) == 0x80;
  }
  return good ? length : 0;
}
}

//------------------------------------------------------------------------------
std::string vtkIndirectReport::Quote(const std::string& text)
{
  std::string out = "\"";
  for (size_t i = 0; i < text.size();)
  {
    const size_t length = MeasureCharacter(text, i);
    if (length != 1)
    {
      out += length > 0 ? text.substr(i, length) : "\\ufffd";
      i += length > 0 ? length : 1;
      continue;
    }
    const char c = text[i++];
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
std::string vtkIndirectReport::Number(double value, int digits)
{
  char text[40];
  const std::to_chars_result result = digits > 0
    ? std::to_chars(text, text + sizeof(text), value, std::chars_format::general, digits)
    : std::to_chars(text, text + sizeof(text), value);
  return std::isfinite(value) ? std::string(text, result.ptr) : "null";
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
         << ": {\"median_ms\": " << Number(statistics.MedianMilliseconds)
         << ", \"p95_ms\": " << Number(statistics.Percentile95Milliseconds);
      const auto ofGPU = timer.Get(stage, vtkIndirectStageTimer::GPU);
      if (ofGPU.Count > 0)
      {
        os << ", \"gpu_median_ms\": " << Number(ofGPU.MedianMilliseconds)
           << ", \"gpu_p95_ms\": " << Number(ofGPU.Percentile95Milliseconds);
      }
      os << "}";
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
    os << "  \"indirect_ms\": " << Number(timer.GetSum(indirect).MedianMilliseconds)
       << ",\n  \"frame_ms\": "
       << Number(timer.Get(vtkIndirectStageTimer::Frame).MedianMilliseconds) << ",\n";
    const auto ofGPU = timer.Get(vtkIndirectStageTimer::Frame, vtkIndirectStageTimer::GPU);
    if (ofGPU.Count > 0)
    {
      os << "  \"gpu_indirect_ms\": "
         << Number(timer.GetSum(indirect, vtkIndirectStageTimer::GPU).MedianMilliseconds)
         << ",\n  \"gpu_frame_ms\": " << Number(ofGPU.MedianMilliseconds) << ",\n";
    }
  }
  else
  {
    os << "  \"indirect_ms\": null,\n  \"frame_ms\": null,\n";
  }
  os << "  \"virtual_lights\": " << this->VirtualLights << ",\n  \"bytes\": " << this->Bytes
     << ",\n  \"main_memory_bytes\": " << this->MainMemoryBytes << ",\n  \"estimated_error\": ";
  os << (this->EstimatedError >= 0.0 ? Number(this->EstimatedError) : "null");
  os << ",\n  \"modelled\": " << List(this->Modelled)
     << ",\n  \"left_out\": " << List(this->LeftOut) << ",\n  \"paths\": " << this->Paths
     << ",\n  \"gl\": {\"renderer\": " << Quote(this->GLRenderer)
     << ", \"version\": " << Quote(this->GLVersion)
     << "},\n  \"vtk\": " << Quote(vtkVersion::GetVTKVersion())
     << ",\n  \"version\": " << Quote(VTK_INDIRECT_VERSION)
     << ",\n  \"shader_hash\": " << Quote(vtkIndirectShaderLibrary::GetHash()) << "\n}\n";
  return os.str();
}
