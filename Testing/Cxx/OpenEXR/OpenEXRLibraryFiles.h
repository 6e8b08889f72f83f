// SPDX-License-Identifier: BSD-3-Clause
// Files written by the OpenEXR library, for the tests of the reader.

#ifndef OpenEXRLibraryFiles_h
#define OpenEXRLibraryFiles_h

#include "OpenEXRTestTools.h"

#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfStringAttribute.h>
#include <ImfTileDescription.h>
#include <ImfTiledOutputFile.h>
#include <half.h>

namespace exrtest
{
namespace exr = OPENEXR_IMF_NAMESPACE;
namespace imath = IMATH_NAMESPACE;

// Channel values in the order of the file: top row first.
struct Plane
{
  std::string Name;
  exr::PixelType Type;
  int Sampling;
  std::vector<float> Floats;
  std::vector<half> Halves;
  std::vector<unsigned int> Integers;
  int Width = 0;
  int Height = 0;

  Plane(const std::string& name, exr::PixelType type, const imath::Box2i& window,
    std::uint64_t seed = 1, int sampling = 1)
    : Name(name)
    , Type(type)
    , Sampling(sampling)
    , Width((window.max.x - window.min.x + 1) / sampling)
    , Height((window.max.y - window.min.y + 1) / sampling)
  {
    Random random(seed);
    for (int i = 0; i < this->Width * this->Height; ++i)
    {
      // Smooth with some noise, which compresses in part.
      const float value =
        std::abs(static_cast<float>(i % this->Width) * 0.25f + random.Value(1.0f));
      this->Floats.push_back(value);
      this->Halves.push_back(half(value));
      this->Integers.push_back(random.Next() >> random.Below(32));
    }
  }

  // The value that the reader has to return.
  float Get(int column, int row) const
  {
    const std::size_t i = static_cast<std::size_t>(row * this->Width + column);
    return this->Type == exr::FLOAT ? this->Floats[i]
      : this->Type == exr::HALF     ? static_cast<float>(this->Halves[i])
                                    : static_cast<float>(this->Integers[i]);
  }

  void Insert(exr::FrameBuffer& frame, const imath::Box2i& window)
  {
    const std::size_t size = this->Type == exr::HALF ? 2 : 4;
    void* data = this->Type == exr::FLOAT ? static_cast<void*>(this->Floats.data())
      : this->Type == exr::HALF           ? static_cast<void*>(this->Halves.data())
                                          : static_cast<void*>(this->Integers.data());
    const std::size_t stride = size * static_cast<std::size_t>(this->Width);
    std::intptr_t base = reinterpret_cast<std::intptr_t>(data);
    base -=
      static_cast<std::intptr_t>(window.min.x / this->Sampling) * static_cast<std::intptr_t>(size);
    base -= static_cast<std::intptr_t>(window.min.y / this->Sampling) *
      static_cast<std::intptr_t>(stride);
    frame.insert(this->Name,
      exr::Slice(
        this->Type, reinterpret_cast<char*>(base), size, stride, this->Sampling, this->Sampling));
  }
};

inline imath::Box2i MakeWindow(int x0, int x1, int y0, int y1)
{
  return imath::Box2i(imath::V2i(x0, y0), imath::V2i(x1, y1));
}

inline exr::Header MakeHeader(const imath::Box2i& window, const std::vector<Plane>& planes,
  exr::Compression compression, exr::LineOrder order = exr::INCREASING_Y)
{
  exr::Header header(window, window, 1.0f, imath::V2f(0, 0), 1.0f, order, compression);
  for (const Plane& plane : planes)
  {
    header.channels().insert(plane.Name, exr::Channel(plane.Type, plane.Sampling, plane.Sampling));
  }
  return header;
}

inline exr::FrameBuffer MakeFrame(const imath::Box2i& window, std::vector<Plane>& planes)
{
  exr::FrameBuffer frame;
  for (Plane& plane : planes)
  {
    plane.Insert(frame, window);
  }
  return frame;
}

inline void WriteScanlines(const std::string& path, const imath::Box2i& window,
  std::vector<Plane>& planes, exr::Compression compression,
  exr::LineOrder order = exr::INCREASING_Y, const imath::Box2i* display = nullptr)
{
  exr::Header header = MakeHeader(window, planes, compression, order);
  header.displayWindow() = display ? *display : window;
  exr::OutputFile file(path.c_str(), header);
  file.setFrameBuffer(MakeFrame(window, planes));
  file.writePixels(window.max.y - window.min.y + 1);
}

// All levels hold the corner of the same planes.
inline void WriteTiles(const std::string& path, const imath::Box2i& window,
  std::vector<Plane>& planes, exr::Compression compression, unsigned int width, unsigned int height,
  exr::LevelMode mode = exr::ONE_LEVEL, exr::LineOrder order = exr::INCREASING_Y)
{
  exr::Header header = MakeHeader(window, planes, compression, order);
  header.setTileDescription(exr::TileDescription(width, height, mode));
  exr::TiledOutputFile file(path.c_str(), header);
  file.setFrameBuffer(MakeFrame(window, planes));
  for (int ly = 0; ly < file.numYLevels(); ++ly)
  {
    for (int lx = 0; lx < file.numXLevels(); ++lx)
    {
      if (file.isValidLevel(lx, ly))
      {
        file.writeTiles(0, file.numXTiles(lx) - 1, 0, file.numYTiles(ly) - 1, lx, ly);
      }
    }
  }
}

// The first part may be a deep one, without pixels.
inline void WriteParts(const std::string& path, const imath::Box2i& window,
  std::vector<std::vector<Plane>>& parts, bool deepFirst = false)
{
  std::vector<exr::Header> headers;
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    headers.push_back(MakeHeader(window, parts[i], exr::ZIP_COMPRESSION));
    headers.back().setName("part" + std::to_string(i));
    const bool deep = deepFirst && i == 0;
    headers.back().setType(deep ? exr::DEEPSCANLINE : exr::SCANLINEIMAGE);
    headers.back().compression() = deep ? exr::ZIPS_COMPRESSION : exr::ZIP_COMPRESSION;
    headers.back().insert("comments", exr::StringAttribute("of part " + std::to_string(i)));
  }
  exr::MultiPartOutputFile file(path.c_str(), headers.data(), static_cast<int>(headers.size()));
  for (std::size_t i = deepFirst ? 1 : 0; i < parts.size(); ++i)
  {
    exr::OutputPart part(file, static_cast<int>(i));
    part.setFrameBuffer(MakeFrame(window, parts[i]));
    part.writePixels(window.max.y - window.min.y + 1);
  }
}

inline void WriteDeep(const std::string& path)
{
  exr::Header header(2, 2);
  header.channels().insert("Z", exr::Channel(exr::FLOAT));
  header.setType(exr::DEEPSCANLINE);
  header.compression() = exr::ZIPS_COMPRESSION;
  exr::DeepScanLineOutputFile file(path.c_str(), header);
  std::vector<unsigned int> counts(4, 1);
  std::vector<float> values{ 1.0f, 2.0f, 3.0f, 4.0f };
  std::vector<float*> pointers;
  for (float& value : values)
  {
    pointers.push_back(&value);
  }
  exr::DeepFrameBuffer frame;
  frame.insertSampleCountSlice(exr::Slice(exr::UINT, reinterpret_cast<char*>(counts.data()),
    sizeof(unsigned int), 2 * sizeof(unsigned int)));
  frame.insert("Z",
    exr::DeepSlice(exr::FLOAT, reinterpret_cast<char*>(pointers.data()), sizeof(float*),
      2 * sizeof(float*), sizeof(float)));
  file.setFrameBuffer(frame);
  file.writePixels(2);
}

// True if the image holds the planes, in the order of the components.
inline bool Holds(
  vtkImageData* image, const imath::Box2i& window, const std::vector<const Plane*>& planes)
{
  const float* data = FloatData(image);
  const int width = window.max.x - window.min.x + 1;
  const int height = window.max.y - window.min.y + 1;
  const int* extent = image->GetExtent();
  if (!data || image->GetNumberOfScalarComponents() != static_cast<int>(planes.size()) ||
    extent[0] != window.min.x || extent[1] != window.max.x || extent[2] != window.min.y ||
    extent[3] != window.max.y)
  {
    return false;
  }
  for (int y = 0; y < height; ++y)
  {
    for (int x = 0; x < width; ++x)
    {
      for (const Plane* plane : planes)
      {
        if (*data++ != plane->Get(x, height - 1 - y))
        {
          return false;
        }
      }
    }
  }
  return true;
}
}

#endif
