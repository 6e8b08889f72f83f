// SPDX-License-Identifier: BSD-3-Clause
#include "ImageReference.h"

#include "vtkImageData.h"
#include "vtkPNGReader.h"
#include "vtkPNGWriter.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>
#include <fstream>

namespace images
{
namespace
{
const char* const Schema = "vtkindirect.image/1";
}

//------------------------------------------------------------------------------
Tolerance ReadTolerance(const std::string& path)
{
  Tolerance result;
  std::ifstream stream(path);
  const nlohmann::json file = nlohmann::json::parse(stream, nullptr, false);
  auto read = [&](const char* name, auto& value)
  {
    const bool found = file.is_object() && file.contains(name) && file[name].is_number();
    CONTRACT_CHECK(found, path << " has no number " << name);
    if (found)
    {
      file[name].get_to(value);
    }
  };
  read("pixel_step", result.PixelStep);
  read("pixel_share", result.PixelShare);
  read("pixel_mean", result.PixelMean);
  read("block_relative", result.BlockRelative);
  read("block_absolute", result.BlockAbsolute);
  read("block_share", result.BlockShare);
  read("block_limit", result.BlockLimit);
  return result;
}

//------------------------------------------------------------------------------
Grid MakeGrid(const contract::Floats& buffer)
{
  Grid grid;
  grid.Components = buffer.Components;
  grid.Values.reserve(static_cast<size_t>(Grid::Width) * Grid::Height * grid.Components);
  for (int j = 0; j < Grid::Height; ++j)
  {
    const int rows[2] = { j * buffer.Height / Grid::Height,
      (j + 1) * buffer.Height / Grid::Height };
    for (int i = 0; i < Grid::Width; ++i)
    {
      const int columns[2] = { i * buffer.Width / Grid::Width,
        (i + 1) * buffer.Width / Grid::Width };
      for (int c = 0; c < grid.Components; ++c)
      {
        double sum = 0.0;
        for (int y = rows[0]; y < rows[1]; ++y)
        {
          for (int x = columns[0]; x < columns[1]; ++x)
          {
            sum += buffer.Get(x, y, c);
          }
        }
        grid.Values.push_back(
          sum / (static_cast<double>(rows[1] - rows[0]) * (columns[1] - columns[0])));
      }
    }
  }
  return grid;
}

//------------------------------------------------------------------------------
Deviation Compare(const Grid& now, const Grid& stored, const Tolerance& tolerance)
{
  Deviation result;
  if (now.Components != stored.Components || now.Values.size() != stored.Values.size() ||
    stored.Values.empty())
  {
    result.Worst = 1e30;
    result.Share = 1.0;
    return result;
  }
  double mean = 0.0;
  for (double value : stored.Values)
  {
    mean += std::abs(value) / static_cast<double>(stored.Values.size());
  }
  constexpr int blocks = Grid::Width * Grid::Height;
  for (int block = 0; block < blocks; ++block)
  {
    double worst = 0.0;
    for (int c = 0; c < stored.Components; ++c)
    {
      const size_t k = static_cast<size_t>(block) * stored.Components + c;
      const double allowed =
        tolerance.BlockRelative * std::abs(stored.Values[k]) + tolerance.BlockAbsolute * mean;
      const double difference = std::abs(now.Values[k] - stored.Values[k]);
      // NaN and infinity count as the largest deviation.
      const double deviation = std::isfinite(difference) ? difference / allowed : 1e30;
      worst = std::max(worst, difference == 0.0 ? 0.0 : deviation);
    }
    result.Share += worst > 1.0 ? 1.0 / blocks : 0.0;
    if (worst > result.Worst)
    {
      result.Worst = worst;
      result.X = block % Grid::Width;
      result.Y = block / Grid::Width;
    }
  }
  result.IsSmall = result.Share <= tolerance.BlockShare && result.Worst <= tolerance.BlockLimit;
  return result;
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const Deviation& deviation)
{
  return os << "off by up to " << deviation.Worst << " of the tolerance, in block (" << deviation.X
            << ", " << deviation.Y << "); by more than it in " << 100.0 * deviation.Share
            << " % of the blocks";
}

//------------------------------------------------------------------------------
Grids ReadGrids(const std::string& path)
{
  Grids grids;
  std::ifstream stream(path);
  if (!stream)
  {
    return grids;
  }
  const nlohmann::json file = nlohmann::json::parse(stream, nullptr, false);
  try
  {
    if (file.at("schema") != Schema)
    {
      throw std::runtime_error("the schema is another");
    }
    for (const auto& entry : file.at("buffers").items())
    {
      Grid grid;
      entry.value().at("components").get_to(grid.Components);
      const double unit = entry.value().at("unit").get<double>();
      for (const auto& row : entry.value().at("rows"))
      {
        for (const auto& value : row)
        {
          grid.Values.push_back(unit * value.get<double>());
        }
      }
      const size_t expected = static_cast<size_t>(Grid::Width) * Grid::Height * grid.Components;
      CONTRACT_CHECK(grid.Values.size() == expected, path << ": " << entry.key());
      grids[entry.key()] = grid;
    }
  }
  catch (const std::exception& error)
  {
    CONTRACT_CHECK(false, path << ": " << error.what());
  }
  return grids;
}

//------------------------------------------------------------------------------
void WriteGrids(const std::string& path, const Grids& grids)
{
  nlohmann::json file = { { "schema", Schema }, { "buffers", nlohmann::json::object() } };
  for (const auto& entry : grids)
  {
    const size_t length = static_cast<size_t>(Grid::Width) * entry.second.Components;
    auto rows = nlohmann::json::array();
    for (size_t k = 0; k < entry.second.Values.size(); k += length)
    {
      const auto begin = entry.second.Values.begin() + static_cast<std::ptrdiff_t>(k);
      rows.push_back(std::vector<double>(begin, begin + static_cast<std::ptrdiff_t>(length)));
    }
    file["buffers"][entry.first] = { { "components", entry.second.Components }, { "unit", 1.0 },
      { "rows", rows } };
  }
  std::ofstream stream(path);
  stream << file.dump() << "\n";
  CONTRACT_CHECK(stream.good(), path << " cannot be written");
}

//------------------------------------------------------------------------------
contract::Pixels ReadPNG(const std::string& path)
{
  contract::Pixels result;
  vtkNew<vtkPNGReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkImageData* image = reader->GetOutput();
  const bool known = image->GetScalarType() == VTK_UNSIGNED_CHAR &&
    image->GetNumberOfScalarComponents() == 3 && image->GetNumberOfPoints() > 0;
  CONTRACT_CHECK(known, path << " is no picture of three components of eight bits");
  if (known)
  {
    result.Width = image->GetDimensions()[0];
    result.Height = image->GetDimensions()[1];
    result.Components = 3;
    const auto* values = static_cast<const unsigned char*>(image->GetScalarPointer());
    result.Values.assign(values, values + 3 * image->GetNumberOfPoints());
  }
  return result;
}

//------------------------------------------------------------------------------
void WritePNG(const std::string& path, const contract::Pixels& pixels)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(pixels.Width, pixels.Height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = 0; y < pixels.Height; ++y)
  {
    for (int x = 0; x < pixels.Width; ++x)
    {
      out = std::copy(pixels.At(x, y), pixels.At(x, y) + 3, out);
    }
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(image);
  writer->Write();
}

//------------------------------------------------------------------------------
PixelDifference Compare(
  const contract::Pixels& now, const contract::Pixels& stored, const Tolerance& tolerance)
{
  PixelDifference result;
  if (now.Width != stored.Width || now.Height != stored.Height)
  {
    result.Largest = 255;
    result.Mean = 255.0;
    result.Share = 1.0;
    return result;
  }
  for (int y = 0; y < now.Height; ++y)
  {
    for (int x = 0; x < now.Width; ++x)
    {
      int step = 0;
      for (int c = 0; c < 3; ++c)
      {
        const int difference = std::abs(now.Get(x, y, c) - stored.Get(x, y, c));
        step = std::max(step, difference);
        result.Mean += difference;
      }
      result.Largest = std::max(result.Largest, step);
      result.Share += step > tolerance.PixelStep ? 1.0 : 0.0;
    }
  }
  const double pixels = static_cast<double>(now.Width) * now.Height;
  result.Mean /= 3.0 * pixels;
  result.Share /= pixels;
  result.IsSmall = result.Mean <= tolerance.PixelMean && result.Share <= tolerance.PixelShare;
  return result;
}

//------------------------------------------------------------------------------
std::ostream& operator<<(std::ostream& os, const PixelDifference& difference)
{
  return os << "largest step " << difference.Largest << ", mean " << difference.Mean << ", "
            << 100.0 * difference.Share << " % of the pixels off";
}
}
