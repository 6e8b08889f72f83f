// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRHeaderCheck.h"

#include "vtkOpenEXRInputStream.h"

#include <Iex.h>
#include <ImfVersion.h>

#include <map>
#include <set>

//------------------------------------------------------------------------------
void vtkOpenEXRHeaderCheck::Run(vtkOpenEXRInputStream& stream)
{
  vtkOpenEXRHeaderCheck check(stream);
  stream.seekg(4);
  const bool multiPart = OPENEXR_IMF_NAMESPACE::isMultiPart(check.ReadInt());
  while (check.CheckHeader() && multiPart)
  {
  }
  stream.seekg(0);
}

//------------------------------------------------------------------------------
bool vtkOpenEXRHeaderCheck::CheckHeader()
{
  std::set<std::string> names;
  for (;;)
  {
    const std::string name = this->ReadName("attribute name");
    if (name.empty())
    {
      return !names.empty();
    }
    if (!names.insert(name).second)
    {
      throw IEX_NAMESPACE::InputExc("The header has the attribute \"" + name + "\" twice.");
    }
    this->CheckValue(name);
  }
}

//------------------------------------------------------------------------------
void vtkOpenEXRHeaderCheck::CheckValue(const std::string& name)
{
  const std::string type = this->ReadName("attribute type name");
  const int size = this->ReadInt();
  if (size < 0)
  {
    throw IEX_NAMESPACE::InputExc("The header attribute \"" + name + "\" has a negative size.");
  }
  const std::uint64_t start = this->Stream.tellg();
  if (static_cast<std::uint64_t>(size) > this->Stream.GetSize() - start)
  {
    this->Stream.FailAtEnd(
      "The header attribute \"" + name + "\" reaches beyond the end of the file.");
  }
  // The library reads most types by their own length, whatever the header says. Where these
  // differ it takes the bytes that follow for attributes, of any size.
  const std::uint64_t end = start + static_cast<std::uint64_t>(size);
  if (!this->SkipValue(type, end) || this->Stream.tellg() != end)
  {
    throw IEX_NAMESPACE::InputExc(
      "The header attribute \"" + name + "\" has a size that does not fit its type.");
  }
}

//------------------------------------------------------------------------------
std::string vtkOpenEXRHeaderCheck::ReadName(const char* what)
{
  std::string name;
  for (;;)
  {
    char c;
    this->Stream.read(&c, 1);
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
int vtkOpenEXRHeaderCheck::ReadInt()
{
  unsigned char b[4];
  this->Stream.read(reinterpret_cast<char*>(b), 4);
  const std::uint32_t value = static_cast<std::uint32_t>(b[0]) |
    static_cast<std::uint32_t>(b[1]) << 8 | static_cast<std::uint32_t>(b[2]) << 16 |
    static_cast<std::uint32_t>(b[3]) << 24;
  return static_cast<int>(value);
}

//------------------------------------------------------------------------------
void vtkOpenEXRHeaderCheck::Skip(std::uint64_t bytes)
{
  this->Stream.seekg(this->Stream.tellg() + bytes);
}

//------------------------------------------------------------------------------
bool vtkOpenEXRHeaderCheck::SkipValue(const std::string& type, std::uint64_t end)
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
    this->Skip(found->second);
    return true;
  }
  if (type == "chlist")
  {
    while (!this->ReadName("channel name").empty())
    {
      this->Skip(16); // type, linearity, sampling
    }
    return true;
  }
  if (type == "stringvector")
  {
    while (this->Stream.tellg() < end)
    {
      const int length = this->ReadInt();
      if (length < 0)
      {
        return false;
      }
      this->Skip(static_cast<std::uint64_t>(length));
    }
    return true;
  }
  if (type == "floatvector" && (end - this->Stream.tellg()) % 4 != 0)
  {
    return false;
  }
  this->Stream.seekg(end);
  return true;
}
