// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectPaths.h"

#include "OpenGL/vtkIndirectComputeProgram.h"
#include "vtkObject.h" // for the error macro

#include <array>
#include <cstdlib>
#include <cstring>
#include <sstream>

namespace
{
using namespace vtkIndirectPaths;
constexpr const char* Variable = "VTK_INDIRECT_PATHS";

struct Entry
{
  const char* Name;
  std::array<const char*, 2> Values;
  const char* Meaning;
  // The defaults where OpenGL runs on the processor (Mesa's llvmpipe) and where it runs on a GPU.
  // The entries say why.
  int OnProcessor;
  int OnGPU;
  std::array<bool, 2> NeedsCompute;
};

// In the order of Path.
const std::array<Entry, NumberOfPaths> Entries{ {
  // Software clears textures of floats pixel by pixel, which takes longer than to draw over them.
  // Not measured on a GPU, where clears are fast, but a solid frame is cleared only where nothing
  // was drawn.
  { "clear", { "draw", "gl" }, "the geometry buffer is emptied by a drawn quad or by glClear",
    ClearByDraw, ClearByDraw, { false, false } },
  // A copy is fewer operations a pixel than a test and a write. Not measured on a GPU.
  { "depth", { "copy", "draw" },
    "depth is copied to the frame where formats allow it or drawn by the composite", DepthByCopy,
    DepthByCopy, { false, false } },
  // A light is fetched once for all texels of an invocation. On a processor a fetch costs more than
  // registers that spill: with four the sums take 0.8 of the time with two. Eight would save a
  // tenth more, and take a second more to compile.
  { "grouping", { "two", "four" },
    "split texels that one invocation of multiresolution splatting sums lights for", GroupingOfFour,
    GroupingOfTwo, { true, true } },
  // Both take the same time on the processor. On a GPU, where nothing was measured, fragment
  // shaders
  // may run on fewer multiprocessors than compute shaders do.
  { "kernels", { "fragment", "compute" },
    "full-screen kernels that write all of a target are fragment or compute shaders",
    KernelsFragment, KernelsFragment, { false, true } },
  // Tiles sum lights in registers, in a fixed order, where blending reads and writes 16 bytes of each
  // pixel for each splat.
  { "splats", { "blend", "tiles" },
    "splats of virtual lights are drawn and blended, or summed by compute shaders in tiles",
    SplatsInTiles, SplatsInTiles, { false, true } },
  // See vtkIndirectFlatUniforms.h: a GPU reads a uniform once for all pixels.
  { "uniforms", { "plain", "flat" },
    "fragment shaders read uniforms or get them as flat varyings, mappers' where there are pixels "
    "enough for it",
    UniformsFlat, UniformsPlain, { false, false } },
} };

bool RunsOnProcessor()
{
  const char* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name && (std::strstr(name, "llvmpipe") || std::strstr(name, "softpipe"));
}

bool CanDo(int path, int value)
{
  return !Entries[path].NeedsCompute[value] || vtkIndirectComputeProgram::IsSupported();
}

int GetDefault(int path)
{
  const int value = RunsOnProcessor() ? Entries[path].OnProcessor : Entries[path].OnGPU;
  return CanDo(path, value) || !CanDo(path, 1 - value) ? value : 1 - value;
}

// The variable of the environment, parsed.
struct Choice
{
  std::string Text;
  std::array<int, NumberOfPaths> Values; // -1: not forced
  std::string Unknown;                   // the first item that is not known
  bool Reported = false;

  Choice() { this->Values.fill(-1); }
};

Choice Parse(const std::string& text)
{
  Choice choice;
  choice.Text = text;
  std::istringstream items(text);
  for (std::string item; std::getline(items, item, ',');)
  {
    item.erase(0, item.find_first_not_of(' '));
    item.erase(item.find_last_not_of(' ') + 1);
    bool found = item.empty();
    for (int path = 0; path < NumberOfPaths; ++path)
    {
      for (int value = 0; value < 2; ++value)
      {
        if (item == std::string(Entries[path].Name) + "=" + Entries[path].Values[value])
        {
          choice.Values[path] = value;
          found = true;
        }
      }
    }
    if (!found && choice.Unknown.empty())
    {
      choice.Unknown = item;
    }
  }
  return choice;
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
int vtkIndirectPaths::Get(Path path)
{
  static Choice choice;
  const char* text = std::getenv(Variable);
  if (choice.Text != (text ? text : ""))
  {
    choice = Parse(text ? text : "");
  }
  std::string wrong = choice.Unknown;
  std::string why = "is not known";
  for (int i = 0; i < NumberOfPaths && wrong.empty(); ++i)
  {
    const int value = choice.Values[i];
    if (value >= 0 && !CanDo(i, value))
    {
      wrong = std::string(Entries[i].Name) + "=" + Entries[i].Values[value];
      why = "needs OpenGL 4.3, and this context is older";
    }
  }
  if (!wrong.empty() && !choice.Reported)
  {
    Report(wrong, why);
    choice.Reported = true;
  }
  return wrong.empty() && choice.Values[path] >= 0 ? choice.Values[path] : GetDefault(path);
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::string>> vtkIndirectPaths::GetAll()
{
  std::vector<std::pair<std::string, std::string>> all;
  for (int i = 0; i < NumberOfPaths; ++i)
  {
    const int value = Get(static_cast<Path>(i));
    if (CanDo(i, value))
    {
      all.emplace_back(Entries[i].Name, Entries[i].Values[value]);
    }
  }
  return all;
}

//------------------------------------------------------------------------------
std::vector<std::pair<std::string, std::vector<std::string>>> vtkIndirectPaths::List()
{
  std::vector<std::pair<std::string, std::vector<std::string>>> list;
  for (const Entry& entry : Entries)
  {
    list.emplace_back(
      entry.Name, std::vector<std::string>(entry.Values.begin(), entry.Values.end()));
  }
  return list;
}
