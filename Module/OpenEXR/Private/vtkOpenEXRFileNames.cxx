// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRFileNames.h"

#include "vtkErrorCode.h"
#include "vtkOpenEXRFailure.h"

#include <cstddef>
#include <cstdio>
#include <regex>
#include <vector>

namespace
{
// Both begin with what stands for the sign itself. More than three digits are no file's name.
// Groups: flags, width and precision; conversion.
const char* const PrintfPlace =
  "%%|%([-+ #0]{0,5}\\d{0,3}(?:\\.\\d{0,3})?)(?:hh?|ll?|[jzt])?([sdiuxXo])";
// Groups: index; alignment; sign; alternative form, zeros, width and precision; type.
const char* const FormatPlace =
  "\\{\\{|\\}\\}|\\{(\\d?)(?::([<>]?)([-+ ]?)(#?0?\\d{0,3}(?:\\.\\d{1,3})?)([sdxXo]?))?\\}";

//------------------------------------------------------------------------------
std::string Print(const std::string& format, const char* prefix, int number)
{
  auto print = [&](char* buffer, std::size_t size)
  {
    return format.back() == 's' ? std::snprintf(buffer, size, format.c_str(), prefix)
                                : std::snprintf(buffer, size, format.c_str(), number);
  };
  std::vector<char> buffer(static_cast<std::size_t>(print(nullptr, 0)) + 1);
  print(buffer.data(), buffer.size());
  return buffer.data();
}
}

//------------------------------------------------------------------------------
bool vtkOpenEXRFileNames::IsDefault(const std::string& pattern)
{
  return pattern == "%s.%d" || pattern == "{:s}.{:d}";
}

//------------------------------------------------------------------------------
std::string vtkOpenEXRFileNames::Make(const char* prefix, const std::string& pattern, int number)
{
  auto refuse = [&](const std::string& why)
  {
    throw vtkOpenEXRFailure{ vtkErrorCode::UserError,
      "FilePattern \"" + vtkOpenEXRFailure::OneLine(pattern) + "\" " + why };
  };
  const std::regex printfPlace(PrintfPlace);
  const std::regex formatPlace(FormatPlace);
  const std::sregex_iterator end;
  bool isPrintf = false;
  for (std::sregex_iterator i(pattern.begin(), pattern.end(), printfPlace); i != end; ++i)
  {
    isPrintf = isPrintf || (*i)[2].matched;
  }

  // What goes into the places, in this order: 's' is the prefix.
  const std::string arguments = prefix ? "sd" : "d";
  std::size_t next = 0;
  std::string name;
  auto addText = [&](const std::string& text)
  {
    const std::size_t at = text.find_first_of(isPrintf ? "%" : "{}");
    if (at != std::string::npos)
    {
      refuse("cannot be read at \"" + vtkOpenEXRFailure::OneLine(text.substr(at)) + "\".");
    }
    name += text;
  };
  std::string rest = pattern;
  for (std::sregex_iterator i(pattern.begin(), pattern.end(), isPrintf ? printfPlace : formatPlace);
       i != end; ++i)
  {
    const std::smatch& match = *i;
    addText(match.prefix());
    rest = match.suffix();
    if (match.str() == "%%" || match.str() == "{{" || match.str() == "}}")
    {
      name += match.str().front();
      continue;
    }
    const bool indexed = !isPrintf && match.length(1) > 0;
    const std::size_t index = indexed ? static_cast<std::size_t>(match.str(1).front() - '0') : next;
    ++next;
    if (index >= arguments.size())
    {
      refuse(prefix ? "asks for more than a prefix and a number."
                    : "asks for more than a number, and there is no FilePrefix.");
    }
    const std::string asked = match.str(isPrintf ? 2 : 5);
    const bool isPrefix = arguments[index] == 's';
    if (!asked.empty() && isPrefix != (asked == "s"))
    {
      refuse(isPrefix ? "asks for a number where the prefix goes."
                      : "asks for a text where the number goes.");
    }
    std::string format = isPrintf ? match.str(1) : match.str(4);
    if (!isPrintf)
    {
      // Texts are on the left by default, numbers on the right.
      const bool left = match.str(2) == "<" || (isPrefix && match.str(2) != ">");
      format = (left ? "-" : "") + (match.str(3) == "-" ? "" : match.str(3)) + format;
    }
    name +=
      Print("%" + format + (asked.empty() ? arguments.substr(index, 1) : asked), prefix, number);
  }
  addText(rest);
  return name;
}
