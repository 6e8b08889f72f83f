// SPDX-License-Identifier: BSD-3-Clause
// Doing the parts: each in a process of its own, within the time that there is.
#ifndef CardRun_h
#define CardRun_h

#include "CardParts.h" // for Options

namespace card
{
/**
 * Does what is not done yet, then writes the rows and the page. Returns 0 when all passed, 1 when
 * something failed, 3 when time ran out before the end and nothing failed so far.
 */
int Run(const Options& options);

/** The process of one part: of the units that the words after its name are, those that are not
 * done, until the time is up. */
int RunPart(const Options& options);
}

#endif
