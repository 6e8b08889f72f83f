// SPDX-License-Identifier: BSD-3-Clause
// A file that appears under its name only when it is complete, for the OpenEXR library to write.
#ifndef vtkOpenEXROutputStream_h
#define vtkOpenEXROutputStream_h

#include <ImfIO.h>

#include <cstdint> // for positions
#include <iosfwd>  // for the file
#include <memory>  // for std::unique_ptr
#include <string>  // for names

/**
 * Writes a new file beside the final one. Commit() puts it in place; without it the destructor
 * removes what was written.
 */
class vtkOpenEXROutputStream : public OPENEXR_IMF_NAMESPACE::OStream
{
public:
  enum Result
  {
    Success,
    CannotOpen,
    CannotWrite,
    CannotRename
  };

  vtkOpenEXROutputStream(const char* fileName);
  ~vtkOpenEXROutputStream() override;

  /**
   * CannotOpen when the file could not be made, CannotWrite as soon as a write has failed.
   */
  Result GetResult() const { return this->State; }

  /**
   * Closes the file and renames it to the final name. Call it after the library has let go.
   */
  Result Commit();

  void write(const char c[], int n) override;
  std::uint64_t tellp() override;
  void seekp(std::uint64_t position) override;

private:
  std::unique_ptr<std::ostream> File;
  std::string FinalName;
  std::string TemporaryName;
  Result State = Success;
};

#endif
