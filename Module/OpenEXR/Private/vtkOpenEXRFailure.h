// SPDX-License-Identifier: BSD-3-Clause
// A failure on its way to vtkErrorMacro; thrown inside of the module, never out of it.
#ifndef vtkOpenEXRFailure_h
#define vtkOpenEXRFailure_h

#include <string> // for messages

struct vtkOpenEXRFailure
{
  unsigned long Code = 0; // of vtkErrorCode
  std::string Message;

  /** The exception that is being handled. Code is what one of the OpenEXR library becomes. */
  static vtkOpenEXRFailure FromCurrentException(unsigned long code);

  /** A text that may come from a file, without control characters. */
  static std::string OneLine(std::string text);
};

#endif
