// SPDX-License-Identifier: BSD-3-Clause
// Coefficients of spherical harmonics of order 4 by their number.
#pragma once

/** One of the 16 coefficients of vtkiHarmonics4, by l (l + 1) + m. The type is a parameter, because
 * each file that includes the kernels has its own. */
template <typename Harmonics>
auto& vtkIndirectCoefficient(Harmonics& f, int i)
{
  auto& part = i < 4 ? f.A : i < 8 ? f.B : i < 12 ? f.C : f.D;
  return part[i % 4];
}
