// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRInputStream.h"

#include <vtksys/FStream.hxx>

#include <Iex.h>

#include <cstring>
#include <filesystem>
#include <istream>
#include <streambuf>
#include <system_error>
#include <utility>

namespace fs = std::filesystem;
namespace exr = OPENEXR_IMF_NAMESPACE;

//------------------------------------------------------------------------------
vtkOpenEXRInputStream::vtkOpenEXRInputStream(const char* fileName)
  : exr::IStream(fileName)
{
  // Only regular files: opening a pipe would block, and the format needs seeking.
  std::error_code error;
  const fs::file_status status = fs::status(fs::u8path(fileName), error);
  if (status.type() == fs::file_type::not_found)
  {
    this->Status = Missing;
    return;
  }
  if (status.type() != fs::file_type::regular)
  {
    this->Status = Unreadable;
    return;
  }
  this->TakeFile(std::make_unique<vtksys::ifstream>(fileName, std::ios::in | std::ios::binary));
}

//------------------------------------------------------------------------------
vtkOpenEXRInputStream::vtkOpenEXRInputStream(std::unique_ptr<std::streambuf> buffer)
  : exr::IStream("(stream)")
  , Buffer(std::move(buffer))
{
  this->TakeFile(std::make_unique<std::istream>(this->Buffer.get()));
}

//------------------------------------------------------------------------------
void vtkOpenEXRInputStream::TakeFile(std::unique_ptr<std::istream> file)
{
  file->seekg(0, std::ios::end);
  const std::streamoff size = file->fail() ? -1 : static_cast<std::streamoff>(file->tellg());
  file->seekg(0, std::ios::beg);
  if (file->fail() || size < 0)
  {
    this->Status = Unreadable;
    return;
  }
  this->Size = static_cast<std::uint64_t>(size);
  this->File = std::move(file);
}

//------------------------------------------------------------------------------
vtkOpenEXRInputStream::vtkOpenEXRInputStream(const void* memory, std::uint64_t size)
  : exr::IStream("(memory)")
  , Memory(static_cast<const char*>(memory))
  , Size(memory ? size : 0)
{
}

//------------------------------------------------------------------------------
vtkOpenEXRInputStream::~vtkOpenEXRInputStream() = default;

//------------------------------------------------------------------------------
bool vtkOpenEXRInputStream::read(char c[], int n)
{
  const std::uint64_t count = n < 0 ? 0 : static_cast<std::uint64_t>(n);
  if (n < 0 || this->Position > this->Size || count > this->Size - this->Position)
  {
    this->FailAtEnd("Unexpected end of file.");
  }
  if (this->Memory)
  {
    std::memcpy(c, this->Memory + this->Position, count);
  }
  else
  {
    if (this->FilePosition != this->Position)
    {
      this->File->seekg(static_cast<std::streamoff>(this->Position), std::ios::beg);
    }
    this->File->read(c, static_cast<std::streamsize>(n));
    if (this->File->fail())
    {
      this->File->clear();
      this->FilePosition = this->Size + 1;
      this->FailAtEnd("Unexpected end of file.");
    }
    this->FilePosition = this->Position + count;
  }
  this->Position += count;
  return this->Position < this->Size;
}

//------------------------------------------------------------------------------
bool vtkOpenEXRInputStream::HasMagicNumber()
{
  unsigned char magic[4] = { 0, 0, 0, 0 };
  if (this->Status != Opened || this->Size < sizeof(magic))
  {
    return false;
  }
  this->Position = 0;
  this->read(reinterpret_cast<char*>(magic), 4);
  this->Position = 0;
  return magic[0] == 0x76 && magic[1] == 0x2f && magic[2] == 0x31 && magic[3] == 0x01;
}

//------------------------------------------------------------------------------
void vtkOpenEXRInputStream::FailAtEnd(const std::string& message)
{
  this->EndWasHit = true;
  throw IEX_NAMESPACE::InputExc(message);
}
