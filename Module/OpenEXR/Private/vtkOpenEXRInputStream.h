// SPDX-License-Identifier: BSD-3-Clause
// A file, memory or a stream for the OpenEXR library to read, never past the end.
#ifndef vtkOpenEXRInputStream_h
#define vtkOpenEXRInputStream_h

#include <ImfIO.h>

#include <cstdint> // for positions
#include <iosfwd>  // for the file
#include <memory>  // for std::unique_ptr
#include <string>  // for messages

/**
 * Reads from a file, from memory or from a stream that can seek. A read beyond the end throws
 * Iex::InputExc and is remembered.
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
  explicit vtkOpenEXRInputStream(std::unique_ptr<std::streambuf> buffer);
  ~vtkOpenEXRInputStream() override;

  OpenStatus GetStatus() const { return this->Status; }
  std::uint64_t GetSize() const { return this->Size; }

  /**
   * Whether a read beyond the end was tried: the file is truncated, or damaged so that it looks so.
   */
  bool GetEndWasHit() const { return this->EndWasHit; }

  bool HasMagicNumber();

  /**
   * Throws Iex::InputExc for something that lies beyond the end, and remembers that.
   */
  [[noreturn]] void FailAtEnd(const std::string& message);

  bool read(char c[], int n) override;
  std::uint64_t tellg() override { return this->Position; }
  void seekg(std::uint64_t position) override { this->Position = position; }
  void clear() override {}

private:
  void TakeFile(std::unique_ptr<std::istream> file);

  std::unique_ptr<std::streambuf> Buffer;
  std::unique_ptr<std::istream> File;
  const char* Memory = nullptr;
  OpenStatus Status = Opened;
  std::uint64_t Size = 0;
  std::uint64_t Position = 0;
  std::uint64_t FilePosition = 0;
  bool EndWasHit = false;
};

#endif
