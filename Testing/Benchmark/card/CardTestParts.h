// SPDX-License-Identifier: BSD-3-Clause
// Parts that run the test programs of the pack.
#ifndef CardTestParts_h
#define CardTestParts_h

#include "CardParts.h" // for Part

namespace card
{
/** A part for each of the programs, by its name, that the pack has in bin. */
std::vector<Part> MakeTestParts(
  const Options& options, const std::vector<std::pair<std::string, std::string>>& programs);
}

#endif
