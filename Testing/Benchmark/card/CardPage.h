// SPDX-License-Identifier: BSD-3-Clause
// The results for people: rows.csv and page.md in the folder of results.
#ifndef CardPage_h
#define CardPage_h

#include "CardParts.h" // for Part

namespace card
{
/** One line on a unit that has ended. */
std::string DescribeUnit(const nlohmann::json& unit);

/**
 * Writes both files from what has been found so far, and prints where they are. Returns 0 when all
 * passed, 1 when something failed, 3 when something was not run yet.
 */
int WritePage(const Options& options, const std::vector<Part>& parts, double seconds);
}

#endif
