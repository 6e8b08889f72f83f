// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOpenEXRConverter.h"

#include "vtkDataArray.h"

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace
{
constexpr double LargestHalf = 65504.0;

//------------------------------------------------------------------------------
// Rounds to odd, so that rounding the result to half is as good as rounding the value to half.
float NarrowForHalf(double value)
{
  float narrow = static_cast<float>(value);
  const double error = value - static_cast<double>(narrow);
  std::uint32_t bits;
  std::memcpy(&bits, &narrow, sizeof(bits));
  if (error != 0.0 && !(bits & 1u))
  {
    // The odd neighbour is on the side of the value. Zero has the smallest float as its neighbour.
    const bool away = (error > 0.0) == (value > 0.0);
    bits = away ? bits + 1u : bits - 1u;
    std::memcpy(&narrow, &bits, sizeof(bits));
  }
  return narrow;
}
}

//------------------------------------------------------------------------------
void vtkOpenEXRConverter::Convert(vtkDataArray* from, vtkIdType first, vtkIdType count, float* to)
{
  this->ConvertRow(from, first, count, to);
}

//------------------------------------------------------------------------------
void vtkOpenEXRConverter::Convert(vtkDataArray* from, vtkIdType first, vtkIdType count, half* to)
{
  this->ConvertRow(from, first, count, to);
}

//------------------------------------------------------------------------------
template <typename To>
void vtkOpenEXRConverter::ConvertRow(vtkDataArray* from, vtkIdType first, vtkIdType count, To* to)
{
  if (!from->HasStandardMemoryLayout() || from->GetDataType() == VTK_BIT)
  {
    this->ConvertTuples(from, first, count, to);
    return;
  }
  const vtkIdType components = from->GetNumberOfComponents();
  const void* values = from->GetVoidPointer(first * components);
  const std::size_t size = static_cast<std::size_t>(count * components);
  switch (from->GetDataType())
  {
    vtkTemplateMacro(this->ConvertValues(static_cast<const VTK_TT*>(values), size, to));
    default:
      this->ConvertTuples(from, first, count, to);
  }
}

//------------------------------------------------------------------------------
// Any array that offers its values one tuple at a time.
template <typename To>
void vtkOpenEXRConverter::ConvertTuples(
  vtkDataArray* from, vtkIdType first, vtkIdType count, To* to)
{
  std::vector<double> tuple(static_cast<std::size_t>(from->GetNumberOfComponents()));
  for (vtkIdType i = 0; i < count; ++i, to += tuple.size())
  {
    from->GetTuple(first + i, tuple.data());
    this->ConvertValues(tuple.data(), tuple.size(), to);
  }
}

//------------------------------------------------------------------------------
template <typename From, typename To>
void vtkOpenEXRConverter::ConvertValues(const From* from, std::size_t count, To* to)
{
  using Via = typename std::conditional<std::is_same<From, float>::value || sizeof(From) <= 2,
    float, double>::type;
  for (std::size_t i = 0; i < count; ++i)
  {
    this->Put(static_cast<Via>(from[i]), to + i);
  }
}

//------------------------------------------------------------------------------
template <typename Value>
Value vtkOpenEXRConverter::Clamp(Value value, Value largest)
{
  if (std::abs(value) > largest && std::isfinite(value))
  {
    ++this->Clamped;
    return std::copysign(largest, value);
  }
  return value;
}

//------------------------------------------------------------------------------
void vtkOpenEXRConverter::Put(float value, float* to)
{
  // Copied as bits, so that every NaN stays the same.
  std::memcpy(to, &value, sizeof(value));
}

//------------------------------------------------------------------------------
void vtkOpenEXRConverter::Put(float value, half* to)
{
  *to = half(this->Clamp(value, static_cast<float>(LargestHalf)));
}

//------------------------------------------------------------------------------
void vtkOpenEXRConverter::Put(double value, float* to)
{
  *to =
    static_cast<float>(this->Clamp(value, static_cast<double>(std::numeric_limits<float>::max())));
}

//------------------------------------------------------------------------------
void vtkOpenEXRConverter::Put(double value, half* to)
{
  *to = half(std::isfinite(value) ? NarrowForHalf(this->Clamp(value, LargestHalf))
                                  : static_cast<float>(value));
}
