// SPDX-License-Identifier: BSD-3-Clause
// Measures and checks the passes on the graphics card of the machine that it runs on.
#include "CardPage.h"
#include "CardParts.h"
#include "CardRun.h"
#include "CardSceneParts.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace
{
const char* const Usage = R"(usage: gpu COMMAND

  run [PART...]   do all parts, or those named, as far as they are not done; then write the page
                  a scene's name stands for all its sizes, PART:UNIT for a unit
  list [PART...]  the parts, or their units
  page            write the page anew
  record          render the scenes and keep what the buffers hold (when a pack is made)

  --output FOLDER   of the results (default: results, in the folder of the pack)
  --device N        EGL device, counted from 0 (default: the first GPU that works)
  --seconds S       that a run may take (default 600); running again goes on
  --fresh           forget earlier results
  --pack FOLDER     of scenes and programs (default: that of gpu)
  --size WxH        record: a size, may be given again
)";

//------------------------------------------------------------------------------
class UsageError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

double ToNumber(const std::string& option, const std::string& text, double least)
{
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0' || !(value >= least))
  {
    throw UsageError(option + " needs a number from " + std::to_string(static_cast<int>(least)) +
      ", not '" + text + "'");
  }
  return value;
}

//------------------------------------------------------------------------------
card::Options ReadOptions(int argc, char* argv[])
{
  card::Options options;
  options.Program = std::filesystem::absolute(argv[0]).string();
  const char* pack = std::getenv("VTK_INDIRECT_PACK");
  options.Pack = pack ? pack : "";
  for (int i = 2; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "--fresh")
    {
      options.Fresh = true;
    }
    else if (word.compare(0, 2, "--") != 0)
    {
      options.Words.push_back(word);
    }
    else if (word != "--output" && word != "--device" && word != "--seconds" && word != "--pack" &&
      word != "--size")
    {
      throw UsageError("there is no option " + word);
    }
    else if (++i == argc)
    {
      throw UsageError(word + " needs a value");
    }
    else if (word == "--output")
    {
      options.Output = argv[i];
    }
    else if (word == "--device")
    {
      options.Device = static_cast<int>(ToNumber(word, argv[i], 0.0));
    }
    else if (word == "--seconds")
    {
      options.Seconds = ToNumber(word, argv[i], 0.0);
    }
    else if (word == "--pack")
    {
      options.Pack = argv[i];
    }
    else
    {
      std::pair<int, int> size;
      char rest = '\0';
      if (std::sscanf(argv[i], "%dx%d%c", &size.first, &size.second, &rest) != 2 ||
        size.first < 16 || size.second < 16)
      {
        throw UsageError(
          "--size needs WIDTHxHEIGHT from 16x16, not '" + std::string(argv[i]) + "'");
      }
      options.Sizes.push_back(size);
    }
  }
  if (options.Pack.empty())
  {
    throw UsageError("--pack is needed: the folder with scenes and bin");
  }
  options.Pack = std::filesystem::absolute(options.Pack).string();
  options.Output = options.Output.empty() ? options.Pack + "/results"
                                          : std::filesystem::absolute(options.Output).string();
  return options;
}

//------------------------------------------------------------------------------
int Main(int argc, char* argv[])
{
  const std::string command = argc > 1 ? argv[1] : "help";
  if (command == "help" || command == "--help" || command == "-h")
  {
    std::cout << Usage;
    return EXIT_SUCCESS;
  }
  const card::Options options = ReadOptions(argc, argv);
  if (options.Device >= 0)
  {
    // Test programs and parts take it from there.
    setenv("VTK_INDIRECT_EGL_DEVICE", std::to_string(options.Device).c_str(), 1);
  }
  if (command == "run")
  {
    return card::Run(options);
  }
  if (command == "part" && !options.Words.empty())
  {
    return card::RunPart(options);
  }
  if (command == "record")
  {
    card::Record(options);
    return EXIT_SUCCESS;
  }
  if (command == "list" || command == "page")
  {
    const std::vector<card::Part> parts = card::MakeParts(options);
    if (command == "page")
    {
      return card::WritePage(options, parts, 0.0);
    }
    for (const card::Part& part : card::Choose(parts, options.Words))
    {
      std::cout << part.Name << ": " << part.Units.size() << " units\n";
      for (size_t i = 0; i < part.Units.size() && !options.Words.empty(); ++i)
      {
        std::cout << "  " << part.Units[i] << "\n";
      }
    }
    return EXIT_SUCCESS;
  }
  throw UsageError("there is no command '" + command + "'");
}
}

//------------------------------------------------------------------------------
int main(int argc, char* argv[])
{
  try
  {
    return Main(argc, argv);
  }
  catch (const UsageError& error)
  {
    std::cerr << "gpu: " << error.what() << " (see gpu help)\n";
    return 2;
  }
  catch (const std::exception& error)
  {
    std::cerr << "gpu: " << error.what() << "\n";
    return EXIT_FAILURE;
  }
}
