// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectFlatUniforms.h"

#include <algorithm>
#include <cctype>
#include <set>
#include <sstream>

namespace
{
// Components of a type, with columns of three as they are packed; 0 for a type that cannot be a
// varying.
int CountComponents(const std::string& type)
{
  static const struct
  {
    const char* Name;
    int Components;
  } types[] = { { "float", 1 }, { "int", 1 }, { "vec2", 2 }, { "ivec2", 2 }, { "vec3", 3 },
    { "vec4", 4 }, { "mat3", 9 }, { "mat4", 16 } };
  for (const auto& known : types)
  {
    if (type == known.Name)
    {
      return known.Components;
    }
  }
  return 0;
}

// Components that the vertex shader passes on already: each output may take whole rows of four.
int CountOutputs(const std::string& vertexShader)
{
  std::istringstream lines(vertexShader);
  std::string line;
  int components = 0;
  while (std::getline(lines, line))
  {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "flat" || word == "smooth" || word == "centroid")
    {
      words >> word;
    }
    std::string type;
    if (word == "out" && words >> type)
    {
      components += (std::max(CountComponents(type), 1) + 3) / 4 * 4;
    }
  }
  return components;
}

// Returns true if a name occurs in a text behind `at`, as a whole word.
bool IsUsed(const std::string& text, const std::string& name, size_t at)
{
  auto isPart = [](char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; };
  for (at = text.find(name, at); at != std::string::npos; at = text.find(name, at + 1))
  {
    const size_t end = at + name.size();
    if (!isPart(text[at - 1]) && (end == text.size() || !isPart(text[end])))
    {
      return true;
    }
  }
  return false;
}
}

//------------------------------------------------------------------------------
void vtkIndirectFlatUniforms::Move(
  std::string& vertexShader, std::string& fragmentShader, int maximum)
{
  std::istringstream lines(fragmentShader);
  std::string line;
  std::string fragment;
  std::string declarations;
  std::string assignments;
  std::set<std::string> moved;
  int components = CountOutputs(vertexShader);
  size_t at = 0;
  while (std::getline(lines, line))
  {
    at += line.size() + 1;
    std::istringstream words(line);
    std::string word;
    std::string type;
    std::string name;
    words >> word >> type >> name;
    const bool ended =
      name.size() > 1 && name.find(';') == name.size() - 1 && name.find('[') == std::string::npos;
    const int count = word == "uniform" && ended ? CountComponents(type) : 0;
    name = name.substr(0, name.find(';'));
    const bool again = moved.count(name) > 0; // declared in two branches of the preprocessor
    if (count == 0 || !IsUsed(fragmentShader, name, at) || (!again && components + count > maximum))
    {
      fragment += line + "\n";
      continue;
    }
    const std::string varying = "vtkiFlat_" + name;
    fragment += "flat in " + type + " " + varying + ";\n#define " + name + " " + varying + "\n";
    if (again)
    {
      continue;
    }
    moved.insert(name);
    components += count;
    if (vertexShader.find("uniform " + type + " " + name + ";") == std::string::npos)
    {
      declarations += "uniform " + type + " " + name + ";\n";
    }
    declarations += "flat out " + type + " " + varying + ";\n";
    assignments += "  " + varying + " = " + name + ";\n";
  }
  const std::string entry = "void main()";
  const size_t main = vertexShader.find(entry);
  const size_t body =
    main == std::string::npos ? main : vertexShader.find('{', main + entry.size());
  if (body == std::string::npos)
  {
    return;
  }
  vertexShader.insert(body + 1, "\n" + assignments);
  vertexShader.insert(main, declarations);
  fragmentShader = fragment;
}
