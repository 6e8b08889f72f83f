// SPDX-License-Identifier: BSD-3-Clause
// Names of the files of a series, by a pattern in either of the two syntaxes that VTK's versions
// use.
#ifndef vtkOpenEXRFileNames_h
#define vtkOpenEXRFileNames_h

#include <string> // for names

namespace vtkOpenEXRFileNames
{
/** Whether it is the pattern that VTK's readers and writers have from the start, of any version. */
bool IsDefault(const std::string& pattern);

/**
 * A name with the prefix, if there is one, and the number in the places of the pattern. These are
 * either all printf's ("%s_%03d.exr") or all std::format's ("{:s}_{:03d}.exr"), whatever VTK's
 * version. Throws vtkOpenEXRFailure (UserError) for a pattern that is neither, or that asks for
 * something else.
 */
std::string Make(const char* prefix, const std::string& pattern, int number);
}

#endif
