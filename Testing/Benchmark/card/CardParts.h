// SPDX-License-Identifier: BSD-3-Clause
// The work, in parts that can run alone, each of units that are done one after another.
#ifndef CardParts_h
#define CardParts_h

#include <nlohmann/json.hpp>

#include <functional> // for units
#include <string>     // for names
#include <vector>     // for lists

namespace card
{
struct Options
{
  std::string Pack;    // folder with scenes and bin
  std::string Output;  // folder of results
  std::string Program; // this one, to run itself
  std::vector<std::string> Words;
  std::vector<std::pair<int, int>> Sizes;
  double Seconds = 600.0; // that all may take
  int Device = -1;
  bool Fresh = false;
};

struct Part
{
  std::string Name;
  std::vector<std::string> Units;
  /**
   * Does one unit. Returns an object with `status`, "passed" or "failed" or "skipped", and what was
   * found; whatever it throws is a failure, too.
   */
  std::function<nlohmann::json(const std::string& unit)> Run;
};

/** All parts of a pack, in the order in which they are worth having. */
std::vector<Part> MakeParts(const Options& options);

/**
 * Parts that words name, all parts without words: a part, the parts that begin with a word,
 * such as a scene's,
 * or with PART:UNIT one unit. Throws std::runtime_error for a word that names nothing.
 */
std::vector<Part> Choose(const std::vector<Part>& parts, const std::vector<std::string>& words);
}

#endif
