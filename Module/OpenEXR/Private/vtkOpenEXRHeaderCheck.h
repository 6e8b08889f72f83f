// SPDX-License-Identifier: BSD-3-Clause
// Checks the structure of a file's headers before the OpenEXR library allocates anything by what
// they say.
#ifndef vtkOpenEXRHeaderCheck_h
#define vtkOpenEXRHeaderCheck_h

#include <cstdint> // for positions
#include <string>  // for names

class vtkOpenEXRInputStream;

class vtkOpenEXRHeaderCheck
{
public:
  /**
   * Walks all headers and throws Iex::InputExc where an attribute claims more bytes than the file
   * has left or other than its type needs, or appears twice. Leaves the position at the start.
   */
  static void Run(vtkOpenEXRInputStream& stream);

private:
  explicit vtkOpenEXRHeaderCheck(vtkOpenEXRInputStream& stream)
    : Stream(stream)
  {
  }

  /** Returns whether there was an attribute at all: an empty header ends a list of them. */
  bool CheckHeader();
  void CheckValue(const std::string& name);
  std::string ReadName(const char* what);
  int ReadInt();
  void Skip(std::uint64_t bytes);
  /** Moves behind a value of that type; false if its parts make no sense. */
  bool SkipValue(const std::string& type, std::uint64_t end);

  vtkOpenEXRInputStream& Stream;
};

#endif
