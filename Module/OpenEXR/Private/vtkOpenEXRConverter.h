// SPDX-License-Identifier: BSD-3-Clause
// Converts values of any type to float, or rounds them to half, and counts those that were beyond
// the range.
#ifndef vtkOpenEXRConverter_h
#define vtkOpenEXRConverter_h

#include "vtkType.h" // for vtkIdType

#include <half.h>

#include <cstddef> // for counts

class vtkDataArray;

class vtkOpenEXRConverter
{
public:
  ///@{
  /** All components of count tuples. */
  void Convert(vtkDataArray* from, vtkIdType first, vtkIdType count, float* to);
  void Convert(vtkDataArray* from, vtkIdType first, vtkIdType count, half* to);
  ///@}

  vtkIdType GetClamped() const { return this->Clamped; }

private:
  template <typename To>
  void ConvertRow(vtkDataArray* from, vtkIdType first, vtkIdType count, To* to);
  template <typename To>
  void ConvertTuples(vtkDataArray* from, vtkIdType first, vtkIdType count, To* to);
  template <typename From, typename To>
  void ConvertValues(const From* from, std::size_t count, To* to);

  void Put(float value, float* to);
  void Put(float value, half* to);
  void Put(double value, float* to);
  void Put(double value, half* to);
  /** The value, or the largest one of its sign. */
  template <typename Value>
  Value Clamp(Value value, Value largest);

  vtkIdType Clamped = 0;
};

#endif
