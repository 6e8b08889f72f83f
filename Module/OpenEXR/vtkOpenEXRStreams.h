// SPDX-License-Identifier: BSD-3-Clause
/**
 * Private to this module: file access for the OpenEXR library that never reads past the end of the
 * file, tells whether that was tried, and checks the structure of a header before the library
 * allocates anything by what it says.
 */

#ifndef vtkOpenEXRStreams_h
#define vtkOpenEXRStreams_h

#include <ImfIO.h>

#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>

/**
 * Reads from a file or from memory. A read beyond the end throws Iex::InputExc and is remembered.
 */
class vtkOpenEXRInputStream : public OPENEXR_IMF_NAMESPACE::IStream
{
public:
  enum OpenStatus
  {
    Opened,
    Missing,
    Unreadable
  };

  vtkOpenEXRInputStream(const char* fileName);
  vtkOpenEXRInputStream(const void* memory, std::uint64_t size);
  ~vtkOpenEXRInputStream() override;

  OpenStatus GetStatus() const { return this->Status; }
  std::uint64_t GetSize() const { return this->Size; }

  /**
   * Whether a read beyond the end was tried: the file is truncated, or damaged so that it looks so.
   */
  bool GetEndWasHit() const { return this->EndWasHit; }

  bool HasMagicNumber();

  /**
   * Walks all headers and throws Iex::InputExc where an attribute claims more bytes than the file
   * has left or other than its type needs, or appears twice. Leaves the position at the start.
   */
  void CheckHeaders();

  bool read(char c[], int n) override;
  std::uint64_t tellg() override { return this->Position; }
  void seekg(std::uint64_t position) override { this->Position = position; }
  void clear() override {}

private:
  std::string ReadName(const char* what);
  int ReadInt();
  // Moves behind a value of that type; false if its parts make no sense.
  bool SkipValue(const std::string& type, std::uint64_t end);

  std::unique_ptr<std::istream> File;
  const char* Memory = nullptr;
  OpenStatus Status = Opened;
  std::uint64_t Size = 0;
  std::uint64_t Position = 0;
  std::uint64_t FilePosition = 0;
  bool EndWasHit = false;
};

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
