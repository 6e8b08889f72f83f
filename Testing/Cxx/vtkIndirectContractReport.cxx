// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectContractReport.h"

#include "vtkIndirectContractUtilities.h"

#include <cstring>
#include <locale>

namespace contract
{
namespace
{
// Whether bytes are UTF-8: no overlong form, no surrogate, nothing beyond U+10FFFF (RFC 3629).
bool IsUTF8(const std::string& text)
{
  for (size_t i = 0; i < text.size();)
  {
    const auto byte = [&](size_t k)
    { return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) : 0u; };
    const unsigned int first = byte(0);
    const size_t length = first < 0x80 ? 1
      : first >= 0xc2 && first < 0xe0  ? 2
      : first >= 0xe0 && first < 0xf0  ? 3
      : first >= 0xf0 && first < 0xf5  ? 4
                                       : 0;
    const bool low = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
    const bool high = (first == 0xed && byte(1) > 0x9f) || (first == 0xf4 && byte(1) > 0x8f);
    if (length == 0 || low || high)
    {
      return false;
    }
    for (size_t k = 1; k < length; ++k)
    {
      if ((byte(k) & 0xc0) != 0x80)
      {
        return false;
      }
    }
    i += length;
  }
  return true;
}
}

//------------------------------------------------------------------------------
Report::Report(const std::string& text)
  : Text(text)
{
  this->Valid = IsUTF8(text) && this->ReadValue("");
  this->SkipSpace();
  this->Valid = this->Valid && this->At == text.size();
}

//------------------------------------------------------------------------------
Report::Report(vtkIndirectIlluminationPass* pass)
  : Report(pass->GetReport())
{
  CONTRACT_CHECK(this->Valid, "no valid JSON: " << this->Text);
  for (const char* key : { "schema", "scene", "size", "method", "settings", "frames", "stages",
         "indirect_ms", "frame_ms", "virtual_lights", "bytes", "estimated_error", "modelled",
         "left_out", "gl", "vtk", "version", "shader_hash" })
  {
    CONTRACT_CHECK(this->Has(key), "the report has no " << key);
  }
  CONTRACT_CHECK(this->Get("schema") == "vtkindirect.report/1", "schema");
}

//------------------------------------------------------------------------------
std::string Report::Get(const std::string& path) const
{
  const auto found = this->Values.find(path);
  return found != this->Values.end() ? found->second : std::string();
}

//------------------------------------------------------------------------------
double Report::GetNumber(const std::string& path) const
{
  std::istringstream text(this->Get(path));
  text.imbue(std::locale::classic());
  double value = NAN;
  text >> value;
  return text && text.eof() ? value : NAN;
}

//------------------------------------------------------------------------------
std::string Report::FindReason(const std::string& list, const std::string& what) const
{
  for (int i = 0; this->Has(list + "." + std::to_string(i)); ++i)
  {
    const std::string entry = list + "." + std::to_string(i);
    if (this->Get(entry + ".what") == what)
    {
      return this->Get(entry + ".why");
    }
  }
  return {};
}

//------------------------------------------------------------------------------
void Report::SkipSpace()
{
  while (this->At < this->Text.size() && std::strchr(" \t\r\n", this->Text[this->At]))
  {
    ++this->At;
  }
}

//------------------------------------------------------------------------------
bool Report::Take(char c)
{
  this->SkipSpace();
  if (this->At < this->Text.size() && this->Text[this->At] == c)
  {
    ++this->At;
    return true;
  }
  return false;
}

//------------------------------------------------------------------------------
bool Report::ReadValue(const std::string& path)
{
  this->SkipSpace();
  const char c = this->At < this->Text.size() ? this->Text[this->At] : '\0';
  if (c == '{' || c == '[')
  {
    return this->ReadMembers(path, c == '{' ? '}' : ']', c == '{');
  }
  std::string value;
  if (c == '"')
  {
    const bool read = this->ReadString(value);
    this->Values[path] = value;
    return read;
  }
  for (const char* word : { "true", "false", "null" })
  {
    if (this->Text.compare(this->At, std::strlen(word), word) == 0)
    {
      this->At += std::strlen(word);
      this->Values[path] = word;
      return true;
    }
  }
  const bool read = this->ReadNumber(value);
  this->Values[path] = value;
  return read;
}

//------------------------------------------------------------------------------
bool Report::ReadMembers(const std::string& path, char close, bool named)
{
  ++this->At;
  int count = 0;
  if (!this->Take(close))
  {
    do
    {
      std::string name = std::to_string(count);
      this->SkipSpace();
      if (named && (name.clear(), !(this->ReadString(name) && this->Take(':'))))
      {
        return false;
      }
      const std::string member = path.empty() ? name : path + "." + name;
      // A name twice is no error of the grammar, but nobody knows which is meant.
      if (this->Has(member) || !this->ReadValue(member))
      {
        return false;
      }
      ++count;
    } while (this->Take(','));
    if (!this->Take(close))
    {
      return false;
    }
  }
  this->Values[path] = std::to_string(count);
  return true;
}

//------------------------------------------------------------------------------
bool Report::ReadString(std::string& out)
{
  if (this->At >= this->Text.size() || this->Text[this->At] != '"')
  {
    return false;
  }
  for (++this->At; this->At < this->Text.size(); ++this->At)
  {
    const char c = this->Text[this->At];
    if (c == '"')
    {
      ++this->At;
      return true;
    }
    if (static_cast<unsigned char>(c) < 0x20 || (c == '\\' && !this->ReadEscape(out)))
    {
      return false;
    }
    if (c != '\\')
    {
      out += c;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Leaves the place at the last character of the escape.
bool Report::ReadEscape(std::string& out)
{
  static const char* const letters = "\"\\/bfnrt";
  static const char* const meanings = "\"\\/\b\f\n\r\t";
  const char c = ++this->At < this->Text.size() ? this->Text[this->At] : '\0';
  if (const char* found = c ? std::strchr(letters, c) : nullptr)
  {
    out += meanings[found - letters];
    return true;
  }
  const std::string digits = c == 'u' ? this->Text.substr(this->At + 1, 4) : std::string();
  if (digits.size() != 4 || digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos)
  {
    return false;
  }
  this->At += 4;
  const int code = std::stoi(digits, nullptr, 16);
  if (code < 0x80)
  {
    out += static_cast<char>(code);
    return true;
  }
  // Pairs of surrogates are not written here.
  out += static_cast<char>(code < 0x800 ? 0xc0 | code >> 6 : 0xe0 | code >> 12);
  if (code >= 0x800)
  {
    out += static_cast<char>(0x80 | (code >> 6 & 0x3f));
  }
  out += static_cast<char>(0x80 | (code & 0x3f));
  return true;
}

//------------------------------------------------------------------------------
size_t Report::ReadDigits()
{
  const size_t begin = this->At;
  while (this->At < this->Text.size() && this->Text[this->At] >= '0' && this->Text[this->At] <= '9')
  {
    ++this->At;
  }
  return this->At - begin;
}

//------------------------------------------------------------------------------
bool Report::ReadNumber(std::string& out)
{
  const size_t begin = this->At;
  auto is = [this](const char* set)
  {
    return this->At < this->Text.size() && this->Text[this->At] != '\0' &&
      std::strchr(set, this->Text[this->At]) != nullptr;
  };
  this->At += is("-");
  const bool zero = is("0");
  const size_t whole = this->ReadDigits();
  bool good = whole > 0 && !(zero && whole > 1);
  if (is("."))
  {
    ++this->At;
    good = this->ReadDigits() > 0 && good;
  }
  if (is("eE"))
  {
    ++this->At;
    this->At += is("+-");
    good = this->ReadDigits() > 0 && good;
  }
  out = this->Text.substr(begin, this->At - begin);
  return good;
}
}
