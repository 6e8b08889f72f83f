// SPDX-License-Identifier: BSD-3-Clause
// Parts that render scenes.
#ifndef CardSceneParts_h
#define CardSceneParts_h

#include "CardParts.h" // for Part

namespace card
{
/** For each scene of the pack a part with a unit for each method, at its smallest size or all other
 * ones. */
std::vector<Part> MakeSceneParts(const Options& options, bool smallest);

/** The ways that can be forced by name, each against the defaults. */
Part MakePathsPart(const Options& options);

/** Renders all scenes of the pack and writes what their buffers hold, for later checks. */
void Record(const Options& options);
}

#endif
