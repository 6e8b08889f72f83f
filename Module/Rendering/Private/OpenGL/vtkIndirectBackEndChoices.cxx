// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectBackEndChoices.h"

#include "vtkObject.h" // for the error macro

#include <array>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace
{
using namespace vtkIndirectBackEndChoices;
constexpr const char* Variable = "VTK_INDIRECT_PATHS";

struct Entry
{
  const char* Name;
  std::array<const char*, 2> Values;
  const char* Meaning;
  // Defaults for OpenGL on the processor (Mesa's llvmpipe), and on a GPU. Reasons:
  int OnProcessor;
  int OnGPU;
  std::array<bool, 2> NeedsCompute;
};

// The entries stand in the order of Choice.
const std::array<Entry, NumberOfChoices> Entries{ {
  // Compute shaders sum splats in registers, in a fixed order, where blending reads and writes 16
  // bytes of each pixel for each splat, and list split texels of multiresolution splatting.
  { "compute", { "on", "off" }, "estimators sum by compute shaders or by drawing", ComputeOn,
    ComputeOn, { true, false } },
  // A copy takes fewer operations a pixel than a test and a write. Not measured on a GPU.
  { "depth", { "copy", "draw" },
    "depth is copied to the frame where formats allow it or drawn by the composite", DepthByCopy,
    DepthByCopy, { false, false } },
  // One invocation fetches a light once for all its texels. On a processor a fetch costs more than
  // spilled registers: with four split texels the sums take 0.8 of the time with two. Eight would
  // save a tenth more, and take a second more to compile.
  { "grouping", { "two", "four" },
    "split texels that one invocation of multiresolution splatting sums lights for", GroupingOfFour,
    GroupingOfTwo, { true, true } },
  // See vtkIndirectFlatUniforms.h: a GPU reads a uniform once for all pixels.
  { "uniforms", { "plain", "flat" },
    "fragment shaders read uniforms or get them as flat varyings, mappers' where there are pixels "
    "enough for it",
    UniformsFlat, UniformsPlain, { false, false } },
  // See vtkIndirectTexelTriangles.h and vtkIndirectSmallTriangles.h. On a processor, 32 maps of 64
  // texels squared take a quarter of the time for 672,000 triangles, and a first picture with depth
  // maps of coarse levels takes 0.6 of the time. Not measured on a GPU.
  { "triangles", { "all", "texels" },
    "OpenGL draws all triangles into maps of few texels, or those that cover a texel's centre, and "
    "the processor the small ones of depth maps",
    TrianglesOfTexels, TrianglesAll, { false, false } },
} };

bool RunsOnProcessor()
{
  const char* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name && (std::strstr(name, "llvmpipe") || std::strstr(name, "softpipe"));
}

bool HasComputeShaders()
{
  int version[2] = { 0, 0 };
  glGetIntegerv(GL_MAJOR_VERSION, &version[0]);
  glGetIntegerv(GL_MINOR_VERSION, &version[1]);
  return version[0] > 4 || (version[0] == 4 && version[1] >= 3);
}

bool CanDo(int choice, int value)
{
  return !Entries[choice].NeedsCompute[value] || HasComputeShaders();
}

int GetDefault(int choice)
{
  const int value = RunsOnProcessor() ? Entries[choice].OnProcessor : Entries[choice].OnGPU;
  return CanDo(choice, value) || !CanDo(choice, 1 - value) ? value : 1 - value;
}

// Choices in the environment variable.
struct Forced
{
  std::string Text;
  std::array<int, NumberOfChoices> Values; // -1: no choice
  std::string Unknown;                     // an unknown item
  bool Reported = false;

  Forced() { this->Values.fill(-1); }
};

Forced Parse(const std::string& text)
{
  Forced forced;
  forced.Text = text;
  std::istringstream items(text);
  for (std::string item; std::getline(items, item, ',');)
  {
    item.erase(0, item.find_first_not_of(' '));
    item.erase(item.find_last_not_of(' ') + 1);
    bool found = item.empty();
    for (int choice = 0; choice < NumberOfChoices; ++choice)
    {
      for (int value = 0; value < 2; ++value)
      {
        if (item == std::string(Entries[choice].Name) + "=" + Entries[choice].Values[value])
        {
          forced.Values[choice] = value;
          found = true;
        }
      }
    }
    if (!found && forced.Unknown.empty())
    {
      forced.Unknown = item;
    }
  }
  return forced;
}

void Report(const std::string& item, const std::string& why)
{
  std::string known;
  for (const Entry& entry : Entries)
  {
    known += (known.empty() ? "" : "; ") + std::string(entry.Name) + "=" + entry.Values[0] + "|" +
      entry.Values[1] + " (" + entry.Meaning + ")";
  }
  vtkErrorWithObjectMacro(nullptr, << Variable << " is ignored, because '" << item << "' " << why
                                   << ". There are " << known << ".");
}
}

//------------------------------------------------------------------------------
int vtkIndirectBackEndChoices::Get(Choice choice)
{
  static Forced forced;
  const char* text = std::getenv(Variable);
  if (forced.Text != (text ? text : ""))
  {
    forced = Parse(text ? text : "");
  }
  std::string wrong = forced.Unknown;
  std::string why = "is not known";
  for (int i = 0; i < NumberOfChoices && wrong.empty(); ++i)
  {
    const int value = forced.Values[i];
    if (value >= 0 && !CanDo(i, value))
    {
      wrong = std::string(Entries[i].Name) + "=" + Entries[i].Values[value];
      why = "needs OpenGL 4.3, and this context is older";
    }
  }
  if (!wrong.empty() && !forced.Reported)
  {
    Report(wrong, why);
    forced.Reported = true;
  }
  return wrong.empty() && forced.Values[choice] >= 0 ? forced.Values[choice] : GetDefault(choice);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::string>> vtkIndirectBackEndChoices::GetAll()
{
  std::vector<std::pair<std::string, std::string>> all;
  for (int i = 0; i < NumberOfChoices; ++i)
  {
    const int value = Get(static_cast<Choice>(i));
    if (CanDo(i, value))
    {
      all.emplace_back(Entries[i].Name, Entries[i].Values[value]);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::vector<std::string>>> vtkIndirectBackEndChoices::List()
{
  std::vector<std::pair<std::string, std::vector<std::string>>> list;
  for (const Entry& entry : Entries)
  {
    list.emplace_back(
      entry.Name, std::vector<std::string>(entry.Values.begin(), entry.Values.end()));
  }
  return list;
}
