// SPDX-License-Identifier: BSD-3-Clause
// The reader with files of the OpenEXR library.

#include "OpenEXRLibraryFiles.h"

#include "vtkStringArray.h"

#include <sstream>

using namespace exrtest;

namespace
{
//------------------------------------------------------------------------------
// Every compression, against the library's reader, since some are lossy.
VTK_INDIRECT_TEST(Compressions)
{
  const std::string folder = GetFolder();
  const imath::Box2i window = MakeWindow(-5, 94, 3, 302);
  const std::string path = folder + "compressed.exr";
  for (int compression = 0; compression < exr::NUM_COMPRESSION_METHODS; ++compression)
  {
    for (exr::PixelType type : { exr::HALF, exr::FLOAT })
    {
      for (int kind = 0; kind < 3; ++kind)
      {
        std::vector<Plane> planes;
        planes.emplace_back("R", type, window, 1);
        planes.emplace_back("G", type, window, 2);
        planes.emplace_back("B", type, window, 3);
        if (kind == 2)
        {
          WriteTiles(path, window, planes, static_cast<exr::Compression>(compression), 32, 48);
        }
        else
        {
          WriteScanlines(path, window, planes, static_cast<exr::Compression>(compression),
            kind ? exr::DECREASING_Y : exr::INCREASING_Y);
        }
        std::vector<Plane> expected;
        for (const char* name : { "R", "G", "B" })
        {
          expected.emplace_back(name, exr::FLOAT, window);
        }
        {
          exr::InputFile file(path.c_str());
          file.setFrameBuffer(MakeFrame(window, expected));
          file.readPixels(window.min.y, window.max.y);
        }
        vtkNew<vtkOpenEXRReader> reader;
        Read(reader, path);
        EXR_CHECK(Holds(reader->GetOutput(), window, { &expected[0], &expected[1], &expected[2] }));
        const bool lossless = compression <= exr::PIZ_COMPRESSION;
        EXR_CHECK(
          !lossless || Holds(reader->GetOutput(), window, { &planes[0], &planes[1], &planes[2] }));
      }
    }
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Tiled)
{
  const std::string folder = GetFolder();
  const std::string path = folder + "tiled.exr";
  for (const imath::Box2i& window :
    { MakeWindow(0, 99, 0, 69), MakeWindow(-33, 12, -100, -51), MakeWindow(7, 7, 9, 9) })
  {
    for (exr::LevelMode mode : { exr::ONE_LEVEL, exr::MIPMAP_LEVELS, exr::RIPMAP_LEVELS })
    {
      for (exr::LineOrder order : { exr::INCREASING_Y, exr::DECREASING_Y, exr::RANDOM_Y })
      {
        for (unsigned int size : { 16u, 33u, 256u })
        {
          std::vector<Plane> planes;
          planes.emplace_back("Y", exr::FLOAT, window, 4);
          planes.emplace_back("A", exr::HALF, window, 5);
          WriteTiles(path, window, planes, exr::ZIP_COMPRESSION, size, size / 2, mode, order);
          vtkNew<vtkOpenEXRReader> reader;
          Read(reader, path);
          EXR_CHECK(Holds(reader->GetOutput(), window, { &planes[0], &planes[1] }));
        }
      }
    }
  }
}

//------------------------------------------------------------------------------
// The first part with a flat image.
VTK_INDIRECT_TEST(MultiPart)
{
  const std::string folder = GetFolder();
  const imath::Box2i window = MakeWindow(0, 30, 0, 40);
  const std::string path = folder + "parts.exr";
  for (const bool deepFirst : { false, true })
  {
    std::vector<std::vector<Plane>> parts(3);
    parts[0].emplace_back("Y", exr::FLOAT, window, 1);
    parts[1].emplace_back("R", exr::HALF, window, 2);
    parts[1].emplace_back("depth.Z", exr::FLOAT, window, 3);
    parts[2].emplace_back("id", exr::UINT, window, 4);
    WriteParts(path, window, parts, deepFirst);
    vtkNew<vtkOpenEXRReader> reader;
    Read(reader, path);
    const std::size_t first = deepFirst ? 1 : 0;
    EXR_CHECK(Holds(reader->GetOutput(), window, { &parts[first][0] }));
    EXR_CHECK(reader->GetNumberOfLayers() == (deepFirst ? 2 : 1));
    reader->SetLayer("depth");
    if (deepFirst)
    {
      reader->Update();
      EXR_CHECK(Holds(reader->GetOutput(), window, { &parts[1][1] }));
    }
    else
    {
      ExpectReadError(reader, vtkErrorCode::UserError);
    }
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(PixelTypes)
{
  const std::string folder = GetFolder();
  const imath::Box2i window = MakeWindow(0, 63, 0, 63);
  std::vector<Plane> planes;
  planes.emplace_back("R", exr::HALF, window, 1);
  planes.emplace_back("G", exr::UINT, window, 2);
  planes.emplace_back("B", exr::FLOAT, window, 3);
  WriteScanlines(folder + "types.exr", window, planes, exr::PIZ_COMPRESSION);
  vtkNew<vtkOpenEXRReader> reader;
  Read(reader, folder + "types.exr");
  EXR_CHECK(Holds(reader->GetOutput(), window, { &planes[0], &planes[1], &planes[2] }));
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ChannelOrder)
{
  const std::string folder = GetFolder();
  const imath::Box2i window = MakeWindow(0, 4, 0, 4);
  const std::string path = folder + "order.exr";
  const std::vector<std::vector<std::string>> orders = { { "R", "G", "B", "A" }, { "R", "G", "B" },
    { "Y" }, { "Y", "A" }, { "X", "Y", "Z" }, { "R", "G", "B", "A", "Z" }, { "G", "B" },
    { "id", "mask", "z" }, { "R", "A", "X", "Y", "Z" }, { "U", "V" } };
  for (const std::string& prefix : { std::string(), std::string("a.b.") })
  {
    for (const std::vector<std::string>& names : orders)
    {
      std::vector<Plane> planes;
      std::vector<const Plane*> expected;
      planes.reserve(names.size());
      for (const std::string& name : names)
      {
        planes.emplace_back(prefix + name, exr::FLOAT, window, planes.size() + 1);
        expected.push_back(&planes.back());
      }
      WriteScanlines(path, window, planes, exr::ZIP_COMPRESSION);
      vtkNew<vtkOpenEXRReader> reader;
      reader->SetLayer(prefix.empty() ? "" : "a.b");
      Read(reader, path);
      EXR_CHECK(Holds(reader->GetOutput(), window, expected));
      for (std::size_t i = 0; i < names.size(); ++i)
      {
        EXR_CHECK(ComponentName(reader, static_cast<int>(i)) == names[i]);
      }
    }
  }
}

//------------------------------------------------------------------------------
// Reading from memory. A list of files is refused.
VTK_INDIRECT_TEST(Memory)
{
  const std::string folder = GetFolder();
  const imath::Box2i window = MakeWindow(0, 30, 0, 40);
  std::vector<Plane> planes;
  planes.emplace_back("Y", exr::FLOAT, window, 1);
  WriteScanlines(folder + "a.exr", window, planes, exr::ZIP_COMPRESSION);
  const std::vector<char> bytes = ReadBytes(folder + "a.exr");
  vtkNew<vtkOpenEXRReader> reader;
  reader->SetMemoryBuffer(bytes.data());
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size()));
  reader->Update();
  EXR_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(Holds(reader->GetOutput(), window, { &planes[0] }));
  reader->SetMemoryBufferLength(static_cast<vtkIdType>(bytes.size() - 1));
  ExpectReadError(reader, vtkErrorCode::PrematureEndOfFileError);
  reader->SetMemoryBufferLength(0);
  ExpectReadError(reader, vtkErrorCode::UnrecognizedFileTypeError);

  vtkNew<vtkOpenEXRReader> bytesReader;
  SetBytes(bytesReader, bytes, bytes.size());
  bytesReader->Update();
  EXR_CHECK(bytesReader->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(Holds(bytesReader->GetOutput(), window, { &planes[0] }));
  SetBytes(bytesReader, bytes, bytes.size() - 1);
  ExpectReadError(bytesReader, vtkErrorCode::PrematureEndOfFileError);
  SetBytes(bytesReader, bytes, 0);
  ExpectReadError(bytesReader, vtkErrorCode::UnrecognizedFileTypeError);

  vtkNew<vtkStringArray> names;
  names->InsertNextValue(folder + "a.exr");
  names->InsertNextValue(folder + "a.exr");
  vtkNew<vtkOpenEXRReader> list;
  list->SetFileNames(names);
  ExpectReadError(list, vtkErrorCode::NoFileNameError);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(CanReadFile)
{
  const std::string folder = GetFolder();
  const imath::Box2i window = MakeWindow(0, 3, 0, 3);
  std::vector<Plane> planes;
  planes.emplace_back("Y", exr::FLOAT, window, 1);
  WriteScanlines(folder + "image.exr", window, planes, exr::ZIP_COMPRESSION);
  WriteBytes(folder + "text.exr", { 'n', 'o', ' ', 'e', 'x', 'r' });
  WriteBytes(folder + "empty.exr", {});
  vtkNew<vtkOpenEXRReader> reader;
  EXR_CHECK(reader->CanReadFile((folder + "image.exr").c_str()) == 3);
  EXR_CHECK(reader->CanReadFile((folder + "text.exr").c_str()) == 0);
  EXR_CHECK(reader->CanReadFile((folder + "empty.exr").c_str()) == 0);
  EXR_CHECK(reader->CanReadFile((folder + "missing.exr").c_str()) == 0);
  EXR_CHECK(reader->CanReadFile(folder.c_str()) == 0);
  EXR_CHECK(reader->CanReadFile(nullptr) == 0);
  EXR_CHECK(reader->GetFileExtensions() == std::string(".exr"));
  EXR_CHECK(reader->GetDescriptiveName() == std::string("OpenEXR"));
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Print)
{
  const std::string folder = GetFolder();
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(MakeImage({ 0, 3, 0, 3, 0, 0 }, 3));
  writer->AddLayer("albedo", MakeImage({ 0, 3, 0, 3, 0, 0 }, 3));
  writer->SetFileName((folder + "print.exr").c_str());
  writer->Write();
  vtkNew<vtkOpenEXRReader> reader;
  Read(reader, folder + "print.exr");
  std::ostringstream text;
  reader->Print(text);
  writer->Print(text);
  for (const char* word : { "Layer: ", "MaximumSize: 8192", "Layers: 2", "PixelType: Half",
         "Compression: ZIP", "albedo" })
  {
    EXR_CHECK(text.str().find(word) != std::string::npos);
  }
}
}
