// SPDX-License-Identifier: BSD-3-Clause
// Shader files of glsl/lib comply with the dialect that compiles as GLSL and as C++.
#include "OpenGL/vtkIndirectFlatUniforms.h"
#include "OpenGL/vtkIndirectShaderLibrary.h"
#include "OpenGL/vtkIndirectShaderTable.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <regex>
#include <sstream>

using namespace vtkIndirectTest;

namespace
{
std::string WithoutComments(const std::string& text)
{
  const std::string shorter = std::regex_replace(text, std::regex("//[^\n]*"), "");
  return std::regex_replace(shorter, std::regex("/\\*(.|\n)*?\\*/"), "");
}

// The violated rule of a line, or nothing.
std::string Lint(const std::string& line)
{
  static const std::pair<std::regex, const char*> rules[] = {
    { std::regex(R"((^|[^\w.])(\d+\.\d*|\.\d+)([eE][-+]?\d+)?(?![\dfFeE.]))"), "a double literal" },
    { std::regex(R"((^|[^\w.])\d+[eE][-+]?\d+(?![\dfF]))"), "a double literal" },
    { std::regex(R"(\.([xyzw]{2,4}|[rgba]{2,4}|[stpq]{2,4})\b)"), "a swizzle" },
    { std::regex(R"(\b(uniform|varying|attribute|layout|discard|precision)\b)"), "a stage's word" },
    { std::regex(R"(\b[iu]?sampler\w+)"), "a sampler" },
    { std::regex(R"(\bgl_\w+)"), "a stage's variable" },
    { std::regex(R"(\b(texture\w*|texelFetch\w*|dFdx|dFdy|fwidth|inversesqrt|mix|clamp)\s*\()"),
      "a function that the C++ side does not bring" },
    { std::regex(R"(\b(inout|out)\s+(float|int|bool|u?int|[iub]?vec[234]|mat[234])\b)"),
      "an output parameter without its macro" },
    { std::regex("[^\\x20-\\x7e]"), "a character outside ASCII" },
  };
  for (const auto& rule : rules)
  {
    if (std::regex_search(line, rule.first))
    {
      return rule.second;
    }
  }
  return "";
}

bool IsLibrary(const std::string& name)
{
  return name.compare(0, 14, "vtkIndirectLib") == 0;
}
}

VTK_INDIRECT_TEST(PortableSubset)
{
  int files = 0;
  for (const vtkIndirectShaderTableEntry* entry = vtkIndirectShaderTable; entry->Name; ++entry)
  {
    const std::string name = entry->Name;
    if (!IsLibrary(name))
    {
      continue;
    }
    ++files;
    std::istringstream lines(WithoutComments(entry->Text));
    std::string line;
    std::string first;
    while (std::getline(lines, line))
    {
      const std::string wrong =
        name == "vtkIndirectLibPortable.glsl" && line.find("#define VTKI_") == 0 ? "" : Lint(line);
      if (!wrong.empty() && first.empty())
      {
        first = wrong + ": " + line;
      }
    }
    Check(name + " keeps to the portable subset", first.empty(), first);
    Check(name + " has an include guard",
      std::string(entry->Text).find("#ifndef " + name.substr(0, name.find('.'))) !=
        std::string::npos);
  }
  CheckAtLeast("files of glsl/lib", files, 8, "the folder");
  // Each rule finds its violation.
  for (const char* bad : { "x = 0.5;", "x = 1.;", "x = .5 * y;", "x = 1e-3;", "x = 2.5e-3;",
         "v.xy = a;", "v = a.rgb;", "uniform float a;", "sampler2D s;", "gl_FragCoord.x",
         "texture(s, t)", "void f(out vec3 v)", "x = 1.0f; // \xc3\xa9" })
  {
    Check(std::string("rejects ") + (bad[0] == 'x' && bad[11] == '/' ? "a non-ASCII line" : bad),
      !Lint(bad).empty());
  }
  for (const char* good : { "x = 0.5f;", "x = 1e-3f;", "x = 2.5e-3f * p.x;", "int i = 3;",
         "a[1].x = 2.0f;", "n.x -= vtkiSignNotZero(n.x) * fold;", "void f(VTKI_OUT(vec3) v)" })
  {
    Check(std::string("accepts ") + good, Lint(good).empty(), Lint(good));
  }
}

VTK_INDIRECT_TEST(FlatUniforms)
{
  const std::string vertex =
    "//VTK::System::Dec\nuniform mat4 shared;\nvoid main()\n{\n  f();\n}\n";
  auto move = [&vertex](const std::string& fragment, int maximum)
  {
    std::string v = vertex;
    std::string f = fragment;
    vtkIndirectFlatUniforms::Move(v, f, maximum);
    return std::make_pair(v, f);
  };
  const auto moved =
    move("//VTK::System::Dec\n"
         "#ifdef A\nuniform vec3 twice; // here\n#else\nuniform vec3 twice;\n#endif\n"
         "uniform mat4 shared;\nuniform float unused;\nuniform int used;\n"
         "uniform vec4 array[2];\nuniform sampler2D image;\nuniform bool flag;\n"
         "void main()\n{\n  twice; shared; used; array; image; flag; unused2;\n}\n",
      128);
  for (const char* name : { "twice", "shared", "used" })
  {
    const std::string varying = std::string("vtkiFlat_") + name;
    Check(std::string(name) + " is handed on",
      moved.first.find("  " + varying + " = " + name + ";\n") != std::string::npos &&
        moved.second.find("#define " + std::string(name) + " " + varying + "\n") !=
          std::string::npos &&
        moved.second.find(std::string(" ") + name + ";\nuniform") == std::string::npos);
  }
  auto count = [](const std::string& text, const std::string& what)
  {
    int found = 0;
    for (size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
    {
      ++found;
    }
    return found;
  };
  CheckEqual("uniforms that the vertex shader has once", count(moved.first, "uniform "), 3);
  CheckEqual("varyings of the vertex shader", count(moved.first, "flat out "), 3);
  CheckEqual("varyings of the fragment shader", count(moved.second, "flat in "), 4);
  for (const char* kept : { "uniform float unused;", "uniform vec4 array[2];",
         "uniform sampler2D image;", "uniform bool flag;" })
  {
    Check(std::string("stays: ") + kept, count(moved.second, kept) == 1);
  }
  const std::string two = "uniform vec4 a;\nuniform vec3 b;\nuniform float c;\na b c\n";
  CheckEqual("varyings of at most 5 components", count(move(two, 5).second, "flat in "), 2);
  Check(
    "the one that fits comes with the first", count(move(two, 5).second, "uniform vec3 b;") == 1);
  std::string none = "no entry";
  std::string fragment = two;
  vtkIndirectFlatUniforms::Move(none, fragment, 128);
  Check("nothing moves where no vertex shader hands on", none == "no entry" && fragment == two);
}

VTK_INDIRECT_TEST(ShaderFiles)
{
  for (const vtkIndirectShaderTableEntry* entry = vtkIndirectShaderTable; entry->Name; ++entry)
  {
    const std::string text = entry->Text;
    const std::string name = entry->Name;
    Check(name + " is ASCII without tabs",
      std::all_of(
        text.begin(), text.end(), [](char c) { return c == '\n' || (c >= 32 && c < 127); }));
    const std::string expanded =
      vtkIndirectShaderLibrary::GetText(name, "vtkIndirectGatherVirtualLights.glsl");
    Check(name + " expands", !expanded.empty() && expanded.find("#include") == std::string::npos);
    // A file included twice would define everything twice; #ifndef alone would hide that.
    const std::string guard = "#define vtkIndirectLibPortable";
    const size_t at = expanded.find(guard);
    Check(name + " includes each file once",
      at == std::string::npos || expanded.find(guard + "\n", at + 1) == std::string::npos);
  }
  Check("the hash is an MD5", vtkIndirectShaderLibrary::GetHash().size() == 32);
}
