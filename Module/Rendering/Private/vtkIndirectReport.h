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
  size_t Bytes = 0;           // of textures and buffers
  size_t MainMemoryBytes = 0; // of what is kept beside them; see vtkIndirectIlluminationPass
  /** Relative; negative: not estimated. */
  double EstimatedError = -1.0;
  std::string GLRenderer;
  std::string GLVersion;
  /** Ways that were in force, as JSON; see vtkIndirectPaths. */
  std::string Paths = "{}";

  /** Asks the current context what OpenGL it is. */
  void ReadGL();

  /** Schema vtkindirect.report/1. */
  std::string ToJSON(const vtkIndirectStageTimer& timer) const;
  ///@{
  /**
   * As JSON, in any locale. A string's bytes that are not UTF-8 become U+FFFD. A number has as many
   * digits as tell it from all others, or as are given; null stands for one that is not finite.
   */
  static std::string Quote(const std::string& text);
  static std::string Number(double value, int digits = 0);
  ///@}
};

#endif
