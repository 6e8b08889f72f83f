// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRStreams.h"

#include <vtksys/FStream.hxx>

#include <Iex.h>
#include <ImfVersion.h>

#include <atomic>
#include <cstring>
#include <filesystem>
#include <map>
#include <set>
#include <system_error>

#ifdef _WIN32
#include <process.h>
#else
#include <unistd.h>
#endif

namespace fs = std::filesystem;
namespace exr = OPENEXR_IMF_NAMESPACE;

namespace
{
int ProcessId()
{
#ifdef _WIN32
  return _getpid();
#else
  return static_cast<int>(getpid());
#endif
}
}

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
  auto file = std::make_unique<vtksys::ifstream>(fileName, std::ios::in | std::ios::binary);
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
    this->EndWasHit = true;
    throw IEX_NAMESPACE::InputExc("Unexpected end of file.");
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
      this->EndWasHit = true;
      throw IEX_NAMESPACE::InputExc("Unexpected end of file.");
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
std::string vtkOpenEXRInputStream::ReadName(const char* what)
{
  std::string name;
  for (;;)
  {
    char c;
    this->read(&c, 1);
    if (c == '\0')
    {
      return name;
    }
    if (name.size() == 255)
    {
      throw IEX_NAMESPACE::InputExc(std::string("An ") + what + " is longer than 255 characters.");
    }
    name += c;
  }
}

//------------------------------------------------------------------------------
int vtkOpenEXRInputStream::ReadInt()
{
  unsigned char b[4];
  this->read(reinterpret_cast<char*>(b), 4);
  const std::uint32_t value = static_cast<std::uint32_t>(b[0]) |
    static_cast<std::uint32_t>(b[1]) << 8 | static_cast<std::uint32_t>(b[2]) << 16 |
    static_cast<std::uint32_t>(b[3]) << 24;
  return static_cast<int>(value);
}

//------------------------------------------------------------------------------
bool vtkOpenEXRInputStream::SkipValue(const std::string& type, std::uint64_t end)
{
  static const std::map<std::string, std::uint64_t> fixed = { { "box2f", 16 }, { "box2i", 16 },
    { "chromaticities", 32 }, { "compression", 1 }, { "deepImageState", 1 }, { "double", 8 },
    { "envmap", 1 }, { "float", 4 }, { "int", 4 }, { "keycode", 28 }, { "lineOrder", 1 },
    { "m33d", 72 }, { "m33f", 36 }, { "m44d", 128 }, { "m44f", 64 }, { "rational", 8 },
    { "tiledesc", 9 }, { "timecode", 8 }, { "v2d", 16 }, { "v2f", 8 }, { "v2i", 8 }, { "v3d", 24 },
    { "v3f", 12 }, { "v3i", 12 } };
  const auto found = fixed.find(type);
  if (found != fixed.end())
  {
    this->Position += found->second;
    return true;
  }
  if (type == "chlist")
  {
    while (!this->ReadName("channel name").empty())
    {
      this->Position += 16; // type, linearity, sampling
    }
    return true;
  }
  if (type == "stringvector")
  {
    while (this->Position < end)
    {
      const int length = this->ReadInt();
      if (length < 0)
      {
        return false;
      }
      this->Position += static_cast<std::uint64_t>(length);
    }
    return true;
  }
  if (type == "floatvector" && (end - this->Position) % 4 != 0)
  {
    return false;
  }
  this->Position = end;
  return true;
}

//------------------------------------------------------------------------------
void vtkOpenEXRInputStream::CheckHeaders()
{
  this->Position = 4;
  const bool multiPart = exr::isMultiPart(this->ReadInt());
  bool another = true;
  while (another)
  {
    std::set<std::string> names;
    for (;;)
    {
      const std::string name = this->ReadName("attribute name");
      if (name.empty())
      {
        break;
      }
      if (!names.insert(name).second)
      {
        throw IEX_NAMESPACE::InputExc("The header has the attribute \"" + name + "\" twice.");
      }
      const std::string type = this->ReadName("attribute type name");
      const int size = this->ReadInt();
      if (size < 0)
      {
        throw IEX_NAMESPACE::InputExc("The header attribute \"" + name + "\" has a negative size.");
      }
      if (static_cast<std::uint64_t>(size) > this->Size - this->Position)
      {
        this->EndWasHit = true;
        throw IEX_NAMESPACE::InputExc(
          "The header attribute \"" + name + "\" reaches beyond the end of the file.");
      }
      // The library reads most types by their own length, whatever the header says. Where these
      // differ it takes the bytes that follow for attributes, of any size.
      const std::uint64_t end = this->Position + static_cast<std::uint64_t>(size);
      if (!this->SkipValue(type, end) || this->Position != end)
      {
        throw IEX_NAMESPACE::InputExc(
          "The header attribute \"" + name + "\" has a size that does not fit its type.");
      }
    }
    another = multiPart && !names.empty();
  }
  this->Position = 0;
}

//------------------------------------------------------------------------------
vtkOpenEXROutputStream::vtkOpenEXROutputStream(const char* fileName)
  : exr::OStream(fileName)
  , FinalName(fileName)
{
  std::error_code error;
  fs::path path = fs::u8path(this->FinalName);
  // Replace what a link points to, not the link.
  for (int i = 0; i < 40 && fs::is_symlink(fs::symlink_status(path, error)); ++i)
  {
    const fs::path target = fs::read_symlink(path, error);
    path = target.is_absolute() ? target : path.parent_path() / target;
    this->FinalName = path.u8string();
  }
  const fs::file_type type = fs::status(path, error).type();
  if (type != fs::file_type::not_found && type != fs::file_type::regular)
  {
    this->State = CannotOpen;
    return;
  }

  static std::atomic<unsigned int> counter{ 0 };
  std::string name;
  do
  {
    name = this->FinalName + ".tmp" + std::to_string(ProcessId()) + "-" + std::to_string(counter++);
  } while (fs::exists(fs::symlink_status(fs::u8path(name), error)));
  auto file = std::make_unique<vtksys::ofstream>(
    name.c_str(), std::ios::out | std::ios::binary | std::ios::trunc);
  if (file->fail())
  {
    this->State = CannotOpen;
    return;
  }
  this->TemporaryName = name;
  this->File = std::move(file);
}

//------------------------------------------------------------------------------
vtkOpenEXROutputStream::~vtkOpenEXROutputStream()
{
  this->File.reset();
  if (!this->TemporaryName.empty())
  {
    std::error_code error;
    fs::remove(fs::u8path(this->TemporaryName), error);
  }
}

//------------------------------------------------------------------------------
vtkOpenEXROutputStream::Result vtkOpenEXROutputStream::Commit()
{
  if (this->State != Success)
  {
    return this->State;
  }
  auto* file = static_cast<vtksys::ofstream*>(this->File.get());
  file->close();
  if (file->fail())
  {
    this->State = CannotWrite;
    return this->State;
  }
  std::error_code error;
  fs::rename(fs::u8path(this->TemporaryName), fs::u8path(this->FinalName), error);
  if (error)
  {
    this->State = CannotRename;
    return this->State;
  }
  this->TemporaryName.clear();
  return this->State;
}

//------------------------------------------------------------------------------
void vtkOpenEXROutputStream::write(const char c[], int n)
{
  if (this->State == Success)
  {
    this->File->write(c, static_cast<std::streamsize>(n));
  }
  if (this->State != Success || this->File->fail())
  {
    this->State = this->State == Success ? CannotWrite : this->State;
    throw IEX_NAMESPACE::IoExc("The file could not be written.");
  }
}

//------------------------------------------------------------------------------
std::uint64_t vtkOpenEXROutputStream::tellp()
{
  const std::streamoff position = this->File ? static_cast<std::streamoff>(this->File->tellp()) : 0;
  if (position < 0)
  {
    this->State = CannotWrite;
    return 0;
  }
  return static_cast<std::uint64_t>(position);
}

//------------------------------------------------------------------------------
void vtkOpenEXROutputStream::seekp(std::uint64_t position)
{
  if (this->State == Success)
  {
    this->File->seekp(static_cast<std::streamoff>(position), std::ios::beg);
    if (this->File->fail())
    {
      this->State = CannotWrite;
    }
  }
}
