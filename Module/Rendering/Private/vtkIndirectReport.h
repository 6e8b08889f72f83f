// SPDX-License-Identifier: BSD-3-Clause
// What a frame was made of, as JSON.
#ifndef vtkIndirectReport_h
#define vtkIndirectReport_h

#include <cstddef> // for size_t
#include <string>  // for names
#include <utility> // for pairs
#include <vector>  // for lists

class vtkIndirectStageTimer;

struct vtkIndirectReport
{
  using Entries = std::vector<std::pair<std::string, std::string>>; // what, why

  int Size[2] = { 0, 0 };
  std::string Method = "off";
  /** Name and a value that is JSON already. */
  Entries Settings;
  Entries Modelled;
  Entries LeftOut;
  int VirtualLights = 0;
  size_t Bytes = 0;
  /** Relative; negative: not estimated. */
  double EstimatedError = -1.0;
  std::string GLRenderer;
  std::string GLVersion;

  /** Schema vtkindirect.report/1. */
  std::string ToJSON(const vtkIndirectStageTimer& timer) const;
  static std::string Quote(const std::string& text);
};

#endif
