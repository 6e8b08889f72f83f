// SPDX-License-Identifier: BSD-3-Clause
// The inputs that a kept result was computed from, by name. A stage computes its result again when
// the key of its inputs differs from the key of the result; the names tell which input changed.
#pragma once

#include "vtkType.h" // for numbers

#include <cstddef>     // for size_t
#include <glm/glm.hpp> // for vectors and matrices
#include <string>      // for names
#include <type_traits> // for numbers of any type
#include <vector>      // for parts

class vtkObject;

class vtkIndirectKey
{
public:
  vtkIndirectKey() = default;
  vtkIndirectKey(const char* name, vtkObject* object) { this->Add(name, object); }

  ///@{
  /**
   * Appends an input. The name is a literal: the key holds the pointer. Inputs of one name that
   * follow each other form one part.
   */
  template <typename T,
    typename = std::enable_if_t<std::is_arithmetic<T>::value || std::is_enum<T>::value>>
  vtkIndirectKey& Add(const char* name, T value)
  {
    return std::is_floating_point<T>::value
      ? this->AddNumber(name, static_cast<double>(value))
      : this->AddBits(name, static_cast<vtkTypeUInt64>(value));
  }
  vtkIndirectKey& Add(const char* name, const glm::dvec3& value);
  vtkIndirectKey& Add(const char* name, const glm::dmat4& value);
  vtkIndirectKey& Add(const char* name, const double* values, size_t count);
  /** An object counts by its address and its time of modification; null is allowed. */
  vtkIndirectKey& Add(const char* name, vtkObject* object);
  vtkIndirectKey& AddAddress(const char* name, const void* address);
  ///@}

  /** Empties the key. An empty key belongs to no result. */
  void Clear();
  bool IsEmpty() const { return this->Parts.empty(); }

  /** Keys are equal if their numbers are, bit by bit; plus and minus zero are equal. */
  bool operator==(const vtkIndirectKey& other) const { return this->Bits == other.Bits; }
  bool operator!=(const vtkIndirectKey& other) const { return !(*this == other); }
  /** Becomes equal to a key. Returns true if it was not. */
  bool Take(vtkIndirectKey key);

  /**
   * Returns the names of the parts that differ from another key's, each once, in this key's order.
   */
  std::vector<std::string> FindChanges(const vtkIndirectKey& before) const;
  /** Returns true if no part but those of these names differs from another key's. */
  bool DiffersOnlyIn(const std::vector<std::string>& names, const vtkIndirectKey& before) const;

private:
  struct Part
  {
    const char* Name;
    size_t End; // end of its numbers in Bits
  };

  vtkIndirectKey& AddNumber(const char* name, double value);
  vtkIndirectKey& AddBits(const char* name, vtkTypeUInt64 bits);

  std::vector<Part> Parts;
  std::vector<vtkTypeUInt64> Bits;
};
