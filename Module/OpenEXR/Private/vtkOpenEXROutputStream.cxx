// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXROutputStream.h"

#include <vtksys/FStream.hxx>

#include <Iex.h>

#include <atomic>
#include <filesystem>
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
