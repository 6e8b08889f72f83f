// SPDX-License-Identifier: BSD-3-Clause
// Data of baselines beside a picture: block means of float buffers, and the metrics. reference.py
// has the same in Python.
//
// VTK's own metric takes the least difference among neighbours, and before VTK 9.4 it ignores a
// uniform change of 40 of 255. So pictures are also compared pixel by pixel, and buffers by the
// means of 16 x 12 blocks.
#ifndef ImageReference_h
#define ImageReference_h

#include "vtkIndirectContractUtilities.h"

#include <map>
#include <string>
#include <vector>

namespace images
{
/** The numbers of tolerance.json, which gives the origin of each. */
struct Tolerance
{
  int PixelStep = 0;
  double PixelShare = 0.0;
  double PixelMean = 0.0;
  double BlockRelative = 0.0;
  double BlockAbsolute = 0.0;
  double BlockShare = 0.0;
  double BlockLimit = 0.0;
};
/** Fails the test if a number is missing. */
Tolerance ReadTolerance(const std::string& path);

/** Means over blocks, first row at the bottom; components side by side. */
struct Grid
{
  static constexpr int Width = 16;
  static constexpr int Height = 12;
  int Components = 0;
  std::vector<double> Values;
};
Grid MakeGrid(const contract::Floats& buffer);

/** Differences of blocks in units of their tolerance. */
struct Deviation
{
  double Worst = 0.0;
  int X = -1; // position of the worst block
  int Y = -1;
  double Share = 0.0; // share of blocks with a deviation above 1
  bool IsSmall = false;
};
std::ostream& operator<<(std::ostream& os, const Deviation& deviation);
Deviation Compare(const Grid& now, const Grid& stored, const Tolerance& tolerance);

using Grids = std::map<std::string, Grid>;
/** Reads a file; empty if it does not exist. A damaged file fails the test. */
Grids ReadGrids(const std::string& path);
void WriteGrids(const std::string& path, const Grids& grids);

/** An image of three components. */
contract::Pixels ReadPNG(const std::string& path);
void WritePNG(const std::string& path, const contract::Pixels& pixels);

/** Pixel by pixel. */
struct PixelDifference
{
  int Largest = 0;
  double Mean = 0.0;
  double Share = 0.0; // share of pixels with a difference above PixelStep
  bool IsSmall = false;
};
PixelDifference Compare(
  const contract::Pixels& now, const contract::Pixels& stored, const Tolerance& tolerance);
std::ostream& operator<<(std::ostream& os, const PixelDifference& difference);
}

#endif
