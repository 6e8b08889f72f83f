// SPDX-License-Identifier: BSD-3-Clause
// The report of a frame: its methods, numbers and times, as JSON.
#pragma once

#include "Plan/vtkIndirectSettingList.h" // for settings

#include <cstddef> // for size_t
#include <map>     // for counters
#include <string>  // for names
#include <utility> // for pairs
#include <vector>  // for lists

class vtkIndirectStageTimer;

struct vtkIndirectReport
{
  using Entries = std::vector<std::pair<std::string, std::string>>; // subject, reason

  int Size[2] = { 0, 0 };
  std::string Method = "off";
  vtkIndirectSettingList Settings;
  Entries Modelled;
  Entries LeftOut;
  int VirtualLights = 0;
  size_t Bytes = 0;           // of textures and buffers
  size_t MainMemoryBytes = 0; // of other data kept between frames; see vtkIndirectIlluminationPass
  /** This is the relative error; negative: not estimated. */
  double EstimatedError = -1.0;
  std::string GLRenderer;
  std::string GLVersion;
  /** Names of the inputs of the frame's light that differ from those of the frame before. */
  std::vector<std::string> Changed;
  /** Counts how often data kept between frames were made again since construction, by name. */
  std::map<std::string, long long> Counters;
  /** Methods in use, name and value; see vtkIndirectBackEndChoices. */
  Entries BackEndChoices;

  /** Appends entries to Modelled and to LeftOut. */
  void Add(const Entries& modelled, const Entries& leftOut)
  {
    this->Modelled.insert(this->Modelled.end(), modelled.begin(), modelled.end());
    this->LeftOut.insert(this->LeftOut.end(), leftOut.begin(), leftOut.end());
  }

  /** Reads the names of the current context's OpenGL. */
  void ReadGL();

  /**
   * Writes the schema vtkindirect.report/1 as valid JSON in any locale: bytes that are not UTF-8
   * become U+FFFD, a number that is not finite becomes null.
   */
  std::string ToJSON(const vtkIndirectStageTimer& timer) const;

  /**
   * Formats a number for reasons, in any locale: with `digits` digits, or with as many as
   * distinguish it from all others.
   */
  static std::string Number(double value, int digits = 0);
};
