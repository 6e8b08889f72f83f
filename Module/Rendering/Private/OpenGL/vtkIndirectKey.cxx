// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectKey.h"

#include "vtkObject.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <map>
#include <utility>

//------------------------------------------------------------------------------
vtkIndirectKey& vtkIndirectKey::AddBits(const char* name, vtkTypeUInt64 bits)
{
  this->Bits.push_back(bits);
  if (this->Parts.empty() || std::strcmp(this->Parts.back().Name, name) != 0)
  {
    this->Parts.push_back({ name, 0 });
  }
  this->Parts.back().End = this->Bits.size();
  return *this;
}

//------------------------------------------------------------------------------
vtkIndirectKey& vtkIndirectKey::AddNumber(const char* name, double value)
{
  value += 0.0; // turns minus zero into zero
  vtkTypeUInt64 bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  return this->AddBits(name, bits);
}

//------------------------------------------------------------------------------
vtkIndirectKey& vtkIndirectKey::Add(const char* name, const double* values, size_t count)
{
  for (size_t i = 0; i < count; ++i)
  {
    this->AddNumber(name, values[i]);
  }
  return *this;
}

//------------------------------------------------------------------------------
vtkIndirectKey& vtkIndirectKey::Add(const char* name, const glm::dvec3& value)
{
  return this->Add(name, &value[0], 3);
}

//------------------------------------------------------------------------------
vtkIndirectKey& vtkIndirectKey::Add(const char* name, const glm::dmat4& value)
{
  return this->Add(name, &value[0][0], 16);
}

//------------------------------------------------------------------------------
vtkIndirectKey& vtkIndirectKey::Add(const char* name, vtkObject* object)
{
  return this->AddAddress(name, object).Add(name, object ? object->GetMTime() : 0);
}

//------------------------------------------------------------------------------
vtkIndirectKey& vtkIndirectKey::AddAddress(const char* name, const void* address)
{
  return this->AddBits(name, static_cast<vtkTypeUInt64>(reinterpret_cast<uintptr_t>(address)));
}

//------------------------------------------------------------------------------
void vtkIndirectKey::Clear()
{
  this->Parts.clear();
  this->Bits.clear();
}

//------------------------------------------------------------------------------
bool vtkIndirectKey::Take(vtkIndirectKey key)
{
  const bool differs = key != *this;
  *this = std::move(key);
  return differs;
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkIndirectKey::FindChanges(const vtkIndirectKey& before) const
{
  using Table = std::map<std::string, std::vector<vtkTypeUInt64>>;
  const auto collect = [](const vtkIndirectKey& key)
  {
    Table table;
    size_t first = 0;
    for (const Part& part : key.Parts)
    {
      std::vector<vtkTypeUInt64>& bits = table[part.Name];
      bits.insert(bits.end(), key.Bits.begin() + static_cast<std::ptrdiff_t>(first),
        key.Bits.begin() + static_cast<std::ptrdiff_t>(part.End));
      first = part.End;
    }
    return table;
  };
  const Table now = collect(*this);
  Table last = collect(before);
  std::vector<std::string> names;
  const auto add = [&](const char* name)
  {
    const bool differs = now.find(name) == now.end() || now.at(name) != last[name];
    if (differs && std::find(names.begin(), names.end(), name) == names.end())
    {
      names.emplace_back(name);
    }
  };
  for (const vtkIndirectKey* key : { this, &before })
  {
    for (const Part& part : key->Parts)
    {
      add(part.Name);
    }
  }
  return names;
}

//------------------------------------------------------------------------------
bool vtkIndirectKey::DiffersOnlyIn(
  const std::vector<std::string>& names, const vtkIndirectKey& before) const
{
  const std::vector<std::string> changes = this->FindChanges(before);
  return std::all_of(changes.begin(), changes.end(),
    [&names](const std::string& change)
    { return std::find(names.begin(), names.end(), change) != names.end(); });
}
