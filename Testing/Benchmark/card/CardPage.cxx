// SPDX-License-Identifier: BSD-3-Clause
#include "CardPage.h"

#include "CardResults.h"

#include <cmath>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <iostream>
#include <locale>
#include <map>
#include <sstream>

using Json = nlohmann::json;

namespace
{
//------------------------------------------------------------------------------
// A number of so many digits, in any locale; nothing for null.
std::string Format(const Json& value, int digits)
{
  if (!value.is_number())
  {
    return "";
  }
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.setf(std::ios::fixed);
  text.precision(digits);
  text << value.get<double>();
  return text.str();
}

// A value of a path such as "/errors/R1/nrmse", or null.
Json Find(const Json& unit, const std::string& path)
{
  const Json::json_pointer pointer(path);
  return unit.contains(pointer) ? unit.at(pointer) : Json();
}

const Json* FindRow(const Json& unit, const std::string& stage)
{
  if (!unit.contains("rows"))
  {
    return nullptr;
  }
  for (const Json& row : unit.at("rows"))
  {
    if (row.at("stage") == stage)
    {
      return &row;
    }
  }
  return nullptr;
}

Json GetTime(const Json& unit, const std::string& stage, const char* key)
{
  const Json* row = FindRow(unit, stage);
  return row ? row->at(key) : Json();
}

std::string Quote(const std::string& text)
{
  std::string quoted = "\"";
  for (char c : text)
  {
    quoted += c == '"' ? "\"\"" : std::string(1, c);
  }
  return quoted + "\"";
}

std::string GetText(const Json& unit, const char* key)
{
  return unit.contains(key) && unit.at(key).is_string() ? unit.at(key).get<std::string>() : "";
}

// Returns the text of a table's cell or a list's line.
std::string OneLine(std::string text)
{
  for (char& c : text)
  {
    c = c == '\n' || c == '|' ? ' ' : c;
  }
  return text;
}

//------------------------------------------------------------------------------
struct Tally
{
  int Passed = 0;
  int Failed = 0;
  int Skipped = 0;
  int Left = 0; // not run yet
};

using Results = std::map<std::string, Json>; // by part

Tally Count(const Json& found, const card::Part& part)
{
  Tally tally;
  for (const std::string& name : part.Units)
  {
    const Json& units = found.at("units");
    const std::string status = units.contains(name) ? GetText(units.at(name), "status") : "";
    ++(status == "passed"     ? tally.Passed
        : status == "failed"  ? tally.Failed
        : status == "skipped" ? tally.Skipped
                              : tally.Left);
  }
  return tally;
}

//------------------------------------------------------------------------------
void WriteRows(std::ostream& out, const Results& results, const Json& context)
{
  out
    << "part,scene,width,height,method,path,stage,frames,gpu_ms,gpu_p95_ms,wall_ms,wall_p95_ms,"
       "nrmse_R1,bias_R1,relmse_R2,bias_R2,relmse_R3,nrmse_R3,bias_R3,bytes,virtual_lights,checks,"
       "gl_renderer,gl_version\n";
  for (const auto& [part, found] : results)
  {
    for (const auto& [name, unit] : found.at("units").items())
    {
      const Json frames = unit.contains("frames_of") ? unit.at("frames_of") : Json::array({ unit });
      for (const Json& frame : frames)
      {
        for (const Json& row : frame.value("rows", Json::array()))
        {
          out << part << ',' << GetText(frame, "scene") << ',' << Format(Find(frame, "/width"), 0)
              << ',' << Format(Find(frame, "/height"), 0) << ',' << GetText(frame, "method") << ','
              << Quote(GetText(frame, "path")) << ',' << Quote(GetText(row, "stage")) << ','
              << Format(row.at("frames"), 0);
          for (const char* key : { "gpu_ms", "gpu_p95_ms", "wall_ms", "wall_p95_ms" })
          {
            out << ',' << Format(row.at(key), 4);
          }
          for (const char* path :
            { "R1/nrmse", "R1/bias", "R2/relmse", "R2/bias", "R3/relmse", "R3/nrmse", "R3/bias" })
          {
            out << ',' << Format(Find(frame, std::string("/errors/") + path), 5);
          }
          out << ',' << Format(Find(frame, "/bytes"), 0) << ','
              << Format(Find(frame, "/virtual_lights"), 0) << ',' << GetText(frame, "status") << ','
              << Quote(GetText(context, "renderer")) << ',' << Quote(GetText(context, "version"))
              << '\n';
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
void WriteHead(std::ostream& out, const Json& context, double seconds)
{
  char date[32] = "";
  const std::time_t now = std::time(nullptr);
  std::strftime(date, sizeof date, "%Y-%m-%d %H:%M UTC", std::gmtime(&now));
  out << "# " << (context.empty() ? "No OpenGL" : GetText(context, "renderer")) << "\n\n";
  if (context.empty())
  {
    out << "No context could be made; see the failures.\n\n";
    return;
  }
  out << "OpenGL " << GetText(context, "version") << ", GLSL " << GetText(context, "glsl") << ", "
      << GetText(context, "vendor") << ", by " << GetText(context, "platform") << ". VTK "
      << GetText(context, "vtk") << ", vtk-indirect " << GetText(context, "pack") << ". "
      << GetText(context, "processor") << ", " << Format(Find(context, "/threads"), 0)
      << " threads, glibc " << GetText(context, "glibc") << ". Page written " << date << ", after "
      << Format(seconds, 0) << " s of this run.\n\n";
  for (const Json& device : context.value("devices", Json::array()))
  {
    out << "* " << device.get<std::string>() << "\n";
  }
  const std::string warning = GetText(context, "warning");
  out << (warning.empty() ? "\n" : "\n**" + OneLine(warning) + "**\n\n");
  out << "What the columns mean is in Documentation/gpu.md; all stages and columns are in "
         "rows.csv.\n\n";
}

void WriteSummary(std::ostream& out, const std::vector<card::Part>& parts, const Results& results)
{
  out
    << "## Summary\n\n| part | passed | failed | skipped | not run |\n|---|---:|---:|---:|---:|\n";
  for (const card::Part& part : parts)
  {
    const Tally tally = Count(results.at(part.Name), part);
    out << "| " << part.Name << " | " << tally.Passed << " | " << tally.Failed << " | "
        << tally.Skipped << " | " << tally.Left << " |\n";
  }
  out << "\n";
}

//------------------------------------------------------------------------------
void WriteScene(std::ostream& out, const card::Part& part, const Json& found)
{
  const Json& units = found.at("units");
  bool begun = false;
  const Json plain = units.contains("vtk") ? units.at("vtk") : Json::object();
  const Json yardstick = GetTime(plain, "frame", "wall_ms");
  for (const std::string& name : part.Units)
  {
    if (!units.contains(name) || !units.at(name).contains("scene"))
    {
      continue;
    }
    const Json& unit = units.at(name);
    if (!begun)
    {
      out << "## " << GetText(unit, "scene") << ", " << Format(unit.at("width"), 0) << " x "
          << Format(unit.at("height"), 0)
          << "\n\n| method | frame ms, GPU | frame ms, wall | of vtk's | in flight ms | camera "
             "turns ms "
             "| indirect ms, GPU | indirect ms, wall | nRMSE R1 | bias R1 | relMSE R2 | nRMSE R3 | "
             "bias R3 | MB | checks |\n"
             "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---|\n";
      begun = true;
    }
    const Json wall = GetTime(unit, "frame", "wall_ms");
    const Json ratio = wall.is_number() && yardstick.is_number()
      ? Json(wall.get<double>() / yardstick.get<double>())
      : Json();
    const Json bytes = Find(unit, "/bytes");
    out << "| " << name << " | " << Format(GetTime(unit, "frame", "gpu_ms"), 2) << " | "
        << Format(wall, 2) << " | " << Format(ratio, 2) << " | "
        << Format(GetTime(unit, "frames in flight", "wall_ms"), 2) << " | "
        << Format(GetTime(unit, "camera turns", "wall_ms"), 2) << " | "
        << Format(Find(unit, "/gpu_indirect_ms"), 2) << " | "
        << Format(Find(unit, "/indirect_ms"), 2) << " | "
        << Format(Find(unit, "/errors/R1/nrmse"), 4) << " | "
        << Format(Find(unit, "/errors/R1/bias"), 4) << " | "
        << Format(Find(unit, "/errors/R2/relmse"), 4) << " | "
        << Format(Find(unit, "/errors/R3/nrmse"), 4) << " | "
        << Format(Find(unit, "/errors/R3/bias"), 3) << " | "
        << (bytes.is_number() ? Format(bytes.get<double>() / 1e6, 1) : "") << " | "
        << GetText(unit, "status") << " |\n";
  }
  out << (begun ? "\n" : "");
}

//------------------------------------------------------------------------------
void WritePaths(std::ostream& out, const Json& found)
{
  // By scene and method, the frames of each way.
  std::map<std::string, std::map<std::string, const Json*>> table;
  std::vector<std::string> columns;
  for (const auto& [name, unit] : found.at("units").items())
  {
    for (size_t i = 0; unit.contains("frames_of") && i < unit.at("frames_of").size(); ++i)
    {
      const Json& frame = unit.at("frames_of").at(i);
      const std::string column = GetText(frame, "scene") + ", " + GetText(frame, "method");
      table[column][name] = &frame;
    }
  }
  if (table.empty())
  {
    return;
  }
  out << "## Ways forced by name\n\nTime of a frame over that with the defaults of the same run, "
         "by wall clock and, behind the slash, by the GPU's own. Below 1 the way is faster "
         "here.\n\n| way |";
  for (const auto& column : table)
  {
    out << " " << column.first << " |";
  }
  out << " checks |\n|---|";
  for (size_t i = 0; i <= table.size(); ++i)
  {
    out << "---:|";
  }
  out << "\n";
  for (const auto& [name, unit] : found.at("units").items())
  {
    out << "| " << name << " |";
    for (auto& [column, frames] : table)
    {
      out << " ";
      for (const char* key : { "wall_ms", "gpu_ms" })
      {
        const Json base =
          frames.count("defaults") ? GetTime(*frames["defaults"], "frame", key) : Json();
        const Json time = frames.count(name) ? GetTime(*frames[name], "frame", key) : Json();
        out << (std::string(key) == "gpu_ms" ? " / " : "");
        out << (base.is_number() && time.is_number() && base.get<double>() > 0.0
            ? Format(time.get<double>() / base.get<double>(), 2)
            : "");
      }
      out << " |";
    }
    out << " " << GetText(unit, "status") << " |\n";
  }
  out << "\n";
}

//------------------------------------------------------------------------------
void WriteChecks(std::ostream& out, const Json& frame)
{
  for (const Json& check : frame.value("checks", Json::array()))
  {
    if (check.at("passed"))
    {
      continue;
    }
    out << "  * " << GetText(check, "buffer") << ": ";
    if (check.contains("share"))
    {
      out << Format(100.0 * check.at("share").get<double>(), 2)
          << " % of the places differ by more than " << Format(check.at("tolerance"), 5)
          << " (allowed: " << Format(100.0 * check.at("allowed_share").get<double>(), 1)
          << " %), the worst by " << Format(check.at("worst"), 5) << ", the mean by "
          << Format(check.at("mean"), 5) << "; ";
    }
    out << GetText(check, "why") << "\n";
    if (!GetText(check, "picture").empty())
    {
      out << "\n    ![" << GetText(check, "buffer") << "](" << GetText(check, "picture") << ")\n\n";
    }
  }
}

void WriteFailures(std::ostream& out, const Results& results)
{
  bool begun = false;
  for (const auto& [part, found] : results)
  {
    for (const auto& [name, unit] : found.at("units").items())
    {
      if (GetText(unit, "status") != "failed" && GetText(unit, "status") != "skipped")
      {
        continue;
      }
      out << (begun ? "" : "## Failures and skips\n\n");
      begun = true;
      out << "* " << part << ", " << name << ": " << GetText(unit, "status");
      const std::string why = GetText(unit, "why");
      out << (why.empty() ? "" : ": " + OneLine(why)) << "\n";
      WriteChecks(out, unit);
      for (const Json& frame : unit.value("frames_of", Json::array()))
      {
        WriteChecks(out, frame);
      }
      if (!GetText(unit, "said").empty())
      {
        std::istringstream lines(GetText(unit, "said"));
        out << "\n";
        for (std::string line; std::getline(lines, line);)
        {
          out << "      " << line << "\n";
        }
        out << "\n";
      }
    }
  }
}
}

//------------------------------------------------------------------------------
std::string card::DescribeUnit(const Json& unit)
{
  std::string text = GetText(unit, "status") == "failed" ? "FAILED" : GetText(unit, "status");
  const Json wall = GetTime(unit, "frame", "wall_ms");
  if (wall.is_number())
  {
    text += ", frame " + Format(wall, 2) + " ms";
    const Json gpu = GetTime(unit, "frame", "gpu_ms");
    text += gpu.is_number() ? " (GPU " + Format(gpu, 2) + ")" : "";
  }
  int bad = 0;
  for (const Json& check : unit.value("checks", Json::array()))
  {
    bad += check.at("passed") ? 0 : 1;
  }
  text += bad ? ", " + std::to_string(bad) + " buffers differ" : "";
  const std::string why = GetText(unit, "why");
  return text + (why.empty() ? "" : ": " + OneLine(why));
}

//------------------------------------------------------------------------------
int card::WritePage(const Options& options, const std::vector<Part>& parts, double seconds)
{
  Results results;
  Tally all;
  for (const Part& part : parts)
  {
    results[part.Name] = LoadPart(options.Output, part.Name);
    const Tally tally = Count(results[part.Name], part);
    all.Passed += tally.Passed;
    all.Failed += tally.Failed;
    all.Skipped += tally.Skipped;
    all.Left += tally.Left;
  }
  const Json& units = results.at("opengl").at("units");
  const Json context =
    units.contains("context") && GetText(units.at("context"), "status") == "passed"
    ? units.at("context")
    : Json::object();
  std::ostringstream rows;
  rows.imbue(std::locale::classic());
  WriteRows(rows, results, context);
  WriteText(options.Output + "/rows.csv", rows.str());
  std::ostringstream page;
  page.imbue(std::locale::classic());
  WriteHead(page, context, seconds);
  WriteSummary(page, parts, results);
  for (const Part& part : parts)
  {
    WriteScene(page, part, results.at(part.Name));
  }
  WritePaths(page, results.at("paths"));
  WriteFailures(page, results);
  WriteText(options.Output + "/page.md", page.str());
  std::cout << all.Passed << " passed, " << all.Failed << " failed, " << all.Skipped << " skipped, "
            << all.Left << " not run\n"
            << "the page is " << options.Output << "/page.md, the rows are in " << options.Output
            << "/rows.csv\n";
  if (all.Left > 0)
  {
    std::cout << "run it again to go on with the rest\n";
  }
  return all.Failed ? 1 : all.Left ? 3 : 0;
}
