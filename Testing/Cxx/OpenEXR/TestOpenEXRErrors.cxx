// SPDX-License-Identifier: BSD-3-Clause
// Each failure is reported once, leaves no files behind, and does not crash.

#include "OpenEXRLibraryFiles.h"

#include "vtkTrivialProducer.h"

#ifndef _WIN32
#include <csignal>
#include <cstdlib>
#include <sys/resource.h>
#endif

using namespace exrtest;

namespace
{
std::string WriteSmall(const std::string& path)
{
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(MakeImage({ 0, 19, 0, 49, 0, 0 }, 3));
  writer->AddLayer("albedo", MakeImage({ 0, 19, 0, 49, 0, 0 }, 3));
  Write(writer, path);
  return path;
}

//------------------------------------------------------------------------------
// Replaces the value of an attribute of the header.
void Patch(std::vector<char>& bytes, const std::string& name, const std::string& type,
  const std::vector<std::int32_t>& values)
{
  const std::string key = name + std::string(1, '\0') + type + std::string(1, '\0');
  const std::string text(bytes.begin(), bytes.end());
  const std::size_t at = text.find(key);
  EXR_CHECK(at != std::string::npos);
  for (std::size_t i = 0; i < values.size() && at != std::string::npos; ++i)
  {
    for (std::size_t b = 0; b < 4; ++b)
    {
      bytes[at + key.size() + 4 + 4 * i + b] =
        static_cast<char>(static_cast<std::uint32_t>(values[i]) >> (8 * b));
    }
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ReaderErrors)
{
  const std::string folder = GetFolder();
  const std::string good = WriteSmall(folder + "good.exr");
  {
    vtkNew<vtkOpenEXRReader> reader;
    ExpectReadError(reader, vtkErrorCode::NoFileNameError);
    reader->SetFileName((folder + "missing.exr").c_str());
    ExpectReadError(reader, vtkErrorCode::FileNotFoundError);
    reader->SetFileName((good + "/below.exr").c_str());
    vtkNew<Messages> messages;
    messages->Watch(reader);
    reader->Update();
    EXR_CHECK(messages->Errors == 1);
    EXR_CHECK(reader->GetErrorCode() != vtkErrorCode::NoError);
    reader->RemoveObserver(messages);
    reader->SetFileName(folder.c_str());
    ExpectReadError(reader, vtkErrorCode::CannotOpenFileError);
    WriteBytes(folder + "empty.exr", {});
    reader->SetFileName((folder + "empty.exr").c_str());
    ExpectReadError(reader, vtkErrorCode::UnrecognizedFileTypeError);
    WriteBytes(folder + "foreign.exr", std::vector<char>(1000, 'P'));
    reader->SetFileName((folder + "foreign.exr").c_str());
    ExpectReadError(reader, vtkErrorCode::UnrecognizedFileTypeError);

    // The same reader continues with a good file, and empties the output with the next bad one.
    reader->SetFileName(good.c_str());
    reader->Update();
    EXR_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
    EXR_CHECK(!IsEmpty(reader->GetOutput()));
    reader->SetLayer("normal");
    ExpectReadError(reader, vtkErrorCode::UserError);
    EXR_CHECK(reader->GetNumberOfLayers() == 2);
    reader->SetLayer("albedo");
    reader->Update();
    EXR_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
    EXR_CHECK(!IsEmpty(reader->GetOutput()));
  }
  {
    // The header alone.
    vtkNew<vtkOpenEXRReader> reader;
    vtkNew<Messages> messages;
    messages->Watch(reader);
    reader->SetFileName((folder + "missing.exr").c_str());
    reader->UpdateInformation();
    EXR_CHECK(messages->Errors == 1);
    EXR_CHECK(reader->GetErrorCode() == vtkErrorCode::FileNotFoundError);
    EXR_CHECK(reader->GetNumberOfLayers() == 0);
  }
  {
    // No default layer.
    const imath::Box2i window = MakeWindow(0, 3, 0, 3);
    std::vector<Plane> planes;
    planes.emplace_back("albedo.R", exr::FLOAT, window, 1);
    WriteScanlines(folder + "named.exr", window, planes, exr::ZIP_COMPRESSION);
    vtkNew<vtkOpenEXRReader> reader;
    reader->SetFileName((folder + "named.exr").c_str());
    ExpectReadError(reader, vtkErrorCode::UserError);
    EXR_CHECK(reader->GetNumberOfLayers() == 1);
    EXR_CHECK(reader->GetLayerName(0) == "albedo");
  }
  {
    // The file is moved between reading the header and the pixels.
    vtkNew<vtkOpenEXRReader> reader;
    reader->SetFileName((folder + "named.exr").c_str());
    reader->SetLayer("albedo");
    reader->UpdateInformation();
    std::filesystem::rename(folder + "named.exr", folder + "away.exr");
    ExpectReadError(reader, vtkErrorCode::FileNotFoundError);

    // Or replaced by another one.
    std::filesystem::rename(folder + "away.exr", folder + "named.exr");
    reader->Modified();
    reader->UpdateInformation();
    vtkNew<vtkOpenEXRWriter> writer;
    vtkSmartPointer<vtkImageData> image = MakeImage({ 0, 7, 0, 3, 0, 0 }, 1);
    writer->SetInputData(image);
    writer->AddLayer("albedo", image);
    Write(writer, folder + "named.exr");
    ExpectReadError(reader, vtkErrorCode::FileFormatError);
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(HugeSizes)
{
  const std::string folder = GetFolder();
  const std::vector<char> good = ReadBytes(WriteSmall(folder + "good.exr"));
  auto expectOneOf = [&](const std::vector<char>& bytes, const std::vector<unsigned long>& codes)
  {
    WriteBytes(folder + "huge.exr", bytes);
    vtkNew<vtkOpenEXRReader> reader;
    reader->SetFileName((folder + "huge.exr").c_str());
    ExpectReadError(reader, codes);
  };
  auto expect = [&](const std::vector<char>& bytes, unsigned long code)
  { expectOneOf(bytes, { code }); };
  // Too large, and without space for the table of chunks, which newer libraries read later.
  auto expectTooLarge = [&](const std::vector<char>& bytes) {
    expectOneOf(bytes, { vtkErrorCode::PrematureEndOfFileError, vtkErrorCode::FileFormatError });
  };
  const std::int32_t billion = 999999999;
  std::vector<char> bytes = good;
  Patch(bytes, "dataWindow", "box2i", { 0, 0, billion, billion });
  expectTooLarge(bytes);
  bytes = good;
  Patch(bytes, "dataWindow", "box2i", { 0, 0, billion, 15 });
  expect(bytes, vtkErrorCode::FileFormatError);
  bytes = good;
  Patch(bytes, "dataWindow", "box2i", { -billion, -billion, billion, billion });
  Patch(bytes, "displayWindow", "box2i", { -billion, -billion, billion, billion });
  expectTooLarge(bytes);
  bytes = good;
  Patch(bytes, "dataWindow", "box2i", { 0, 0, -1, -1 });
  expect(bytes, vtkErrorCode::FileFormatError);
  bytes = good;
  Patch(bytes, "dataWindow", "box2i", { VTK_INT_MIN, VTK_INT_MIN, VTK_INT_MAX, VTK_INT_MAX });
  expect(bytes, vtkErrorCode::FileFormatError);

  // A huge display window only moves the pixels.
  bytes = good;
  Patch(bytes, "displayWindow", "box2i", { 0, 0, billion, billion });
  WriteBytes(folder + "huge.exr", bytes);
  vtkNew<vtkOpenEXRReader> reader;
  reader->SetFileName((folder + "huge.exr").c_str());
  reader->Update();
  EXR_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(reader->GetOutput()->GetNumberOfPoints() == 1000);
  EXR_CHECK(reader->GetOutput()->GetExtent()[3] == billion);

  // The display window as far from the data window as the format allows.
  const std::int32_t far = VTK_INT_MAX / 2 - 1;
  bytes = good;
  Patch(bytes, "dataWindow", "box2i", { 0, -far, 19, -far + 49 });
  Patch(bytes, "displayWindow", "box2i", { 0, far, 0, far });
  expect(bytes, vtkErrorCode::FileFormatError);

  // Tiles.
  const imath::Box2i window = MakeWindow(0, 31, 0, 31);
  std::vector<Plane> planes;
  planes.emplace_back("Y", exr::FLOAT, window, 1);
  WriteTiles(folder + "tiled.exr", window, planes, exr::ZIP_COMPRESSION, 16, 16);
  const std::vector<char> tiled = ReadBytes(folder + "tiled.exr");
  bytes = tiled;
  Patch(bytes, "tiles", "tiledesc", { 1 << 30, 1 << 30 });
  expect(bytes, vtkErrorCode::FileFormatError);
  bytes = tiled;
  Patch(bytes, "tiles", "tiledesc", { 1, 1 });
  Patch(bytes, "dataWindow", "box2i", { 0, 0, 30000, 30000 });
  expectTooLarge(bytes);

  // An attribute that claims two gigabytes.
  bytes = good;
  const std::string text(bytes.begin(), bytes.end());
  const std::string key("channels\0chlist\0", 16);
  const std::size_t at = text.find(key);
  EXR_CHECK(at != std::string::npos);
  bytes[at + key.size() + 3] = 0x7f;
  expect(bytes, vtkErrorCode::FileFormatError);

  // An attribute whose size does not fit its type.
  bytes = good;
  const std::string compression("compression\0compression\0", 24);
  const std::size_t place = text.find(compression);
  EXR_CHECK(place != std::string::npos);
  bytes[place + compression.size()] = 2;
  expect(bytes, vtkErrorCode::FileFormatError);

  // The limit itself: 50 x 20 pixels are accepted, 1024 x 1024 with three components are not.
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(MakeImage({ 0, 1023, 0, 1023, 0, 0 }, 3));
  writer->SetFileName((folder + "large.exr").c_str());
  writer->Write();
  vtkNew<vtkOpenEXRReader> limited;
  EXR_CHECK(limited->GetMaximumSize() == 8192);
  limited->SetFileName((folder + "large.exr").c_str());
  limited->SetMaximumSize(11);
  ExpectReadError(limited, vtkErrorCode::FileFormatError);
  limited->SetMaximumSize(12);
  limited->Update();
  EXR_CHECK(limited->GetErrorCode() == vtkErrorCode::NoError);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Subsampled)
{
  const std::string folder = GetFolder();
  const imath::Box2i window = MakeWindow(0, 31, 0, 31);
  std::vector<Plane> planes;
  planes.emplace_back("Y", exr::HALF, window, 1);
  planes.emplace_back("RY", exr::HALF, window, 2, 2);
  planes.emplace_back("BY", exr::HALF, window, 3, 2);
  planes.emplace_back("full.Y", exr::HALF, window, 4);
  WriteScanlines(folder + "chroma.exr", window, planes, exr::ZIP_COMPRESSION);
  vtkNew<vtkOpenEXRReader> reader;
  reader->SetFileName((folder + "chroma.exr").c_str());
  ExpectReadError(reader, vtkErrorCode::FileFormatError);
  reader->SetLayer("full");
  reader->Update();
  EXR_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(Holds(reader->GetOutput(), window, { &planes[3] }));
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Deep)
{
  const std::string folder = GetFolder();
  WriteDeep(folder + "deep.exr");
  vtkNew<vtkOpenEXRReader> reader;
  reader->SetFileName((folder + "deep.exr").c_str());
  ExpectReadError(reader, vtkErrorCode::FileFormatError);
}

//------------------------------------------------------------------------------
// Every length of a small file.
VTK_INDIRECT_TEST(Truncated)
{
  const std::string folder = GetFolder();
  const imath::Box2i window = MakeWindow(0, 7, 0, 39);
  std::vector<std::vector<char>> files;
  {
    std::vector<Plane> planes;
    planes.emplace_back("Y", exr::HALF, window, 1);
    WriteScanlines(folder + "file.exr", window, planes, exr::ZIP_COMPRESSION);
    files.push_back(ReadBytes(folder + "file.exr"));
    WriteTiles(folder + "file.exr", window, planes, exr::ZIP_COMPRESSION, 8, 8);
    files.push_back(ReadBytes(folder + "file.exr"));
    std::vector<std::vector<Plane>> parts{ planes };
    WriteParts(folder + "file.exr", window, parts);
    files.push_back(ReadBytes(folder + "file.exr"));
  }
  for (const std::vector<char>& bytes : files)
  {
    for (std::size_t length = 0; length < bytes.size(); ++length)
    {
      vtkNew<vtkOpenEXRReader> reader;
      vtkNew<Messages> messages;
      messages->Watch(reader);
      SetBytes(reader, bytes, length);
      reader->Update();
      EXR_CHECK(messages->Errors == 1);
      EXR_CHECK(messages->IsOneLine());
      EXR_CHECK(IsEmpty(reader->GetOutput()));
      EXR_CHECK(reader->GetErrorCode() ==
        static_cast<unsigned long>(length < 8 ? vtkErrorCode::UnrecognizedFileTypeError
                                              : vtkErrorCode::PrematureEndOfFileError));
    }
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(WriterErrors)
{
  const std::string folder = GetFolder();
  const std::string path = folder + "out.exr";
  vtkNew<vtkOpenEXRWriter> writer;
  vtkNew<vtkOpenEXRWriter> noInput;
  noInput->SetFileName(path.c_str());
  ExpectWriteError(noInput, vtkErrorCode::UserError);

  auto image = MakeImage({ 0, 3, 0, 3, 0, 0 }, 3);
  writer->SetInputData(image);
  ExpectWriteError(writer, vtkErrorCode::NoFileNameError);
  writer->SetFileName("");
  ExpectWriteError(writer, vtkErrorCode::NoFileNameError);
  writer->SetFileName(path.c_str());

  vtkNew<vtkImageData> empty;
  writer->SetInputData(empty);
  ExpectWriteError(writer, vtkErrorCode::UserError);
  vtkNew<vtkImageData> noScalars;
  noScalars->SetDimensions(4, 4, 1);
  writer->SetInputData(noScalars);
  ExpectWriteError(writer, vtkErrorCode::UserError);
  writer->SetInputData(MakeImage({ 0, 3, 0, 3, 0, 1 }, 3));
  ExpectWriteError(writer, vtkErrorCode::UserError);
  writer->SetInputData(MakeImage({ VTK_INT_MAX - 3, VTK_INT_MAX - 1, 0, 3, 0, 0 }, 1));
  ExpectWriteError(writer, vtkErrorCode::UserError);

  writer->SetInputData(image);
  writer->AddLayer("albedo", MakeImage({ 0, 3, 0, 4, 0, 0 }, 3));
  ExpectWriteError(writer, vtkErrorCode::UserError);
  writer->RemoveAllLayers();
  writer->AddLayer("albedo", noScalars);
  ExpectWriteError(writer, vtkErrorCode::UserError);
  writer->RemoveAllLayers();

  for (const std::string& name : { std::string(), std::string("."), std::string("a."),
         std::string(".a"), std::string(241, 'a'), std::string("a\0b", 3), std::string("a\n.") })
  {
    writer->AddLayer(name, image);
    ExpectWriteError(writer, vtkErrorCode::UserError);
    writer->RemoveAllLayers();
  }
  writer->AddLayer("albedo", nullptr);
  ExpectWriteError(writer, vtkErrorCode::UserError);
  writer->RemoveAllLayers();
  EXR_CHECK(CountFiles(folder) == 0);

  // A folder with the temporary folder's name is kept.
  std::filesystem::create_directory(path + ".tmp0");
  writer->AddLayer(std::string(240, 'a'), image);
  writer->Write();
  EXR_CHECK(writer->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(std::filesystem::remove(path + ".tmp0"));
  EXR_CHECK(CountFiles(folder) == 1);

  // The reader's failure becomes the writer's: an empty input.
  vtkNew<vtkOpenEXRReader> reader;
  vtkNew<Messages> readerMessages;
  readerMessages->Watch(reader);
  reader->SetFileName((folder + "missing.exr").c_str());
  writer->SetInputConnection(reader->GetOutputPort());
  ExpectWriteError(writer, vtkErrorCode::UserError);
  EXR_CHECK(readerMessages->Errors == 1);
  EXR_CHECK(CountFiles(folder) == 1);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(UnwritablePath)
{
  const std::string folder = GetFolder();
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(MakeImage({ 0, 3, 0, 3, 0, 0 }, 3));
  writer->SetFileName((folder + "missing/out.exr").c_str());
  ExpectWriteError(writer, vtkErrorCode::CannotOpenFileError);
  EXR_CHECK(CountFiles(folder) == 0);

  std::filesystem::create_directory(folder + "directory.exr");
  writer->SetFileName((folder + "directory.exr").c_str());
  ExpectWriteError(writer, vtkErrorCode::CannotOpenFileError);
  EXR_CHECK(CountFiles(folder) == 1);
  EXR_CHECK(CountFiles(folder + "directory.exr") == 0);

  WriteBytes(folder + "file", { 'x' });
  writer->SetFileName((folder + "file/out.exr").c_str());
  ExpectWriteError(writer, vtkErrorCode::CannotOpenFileError);
  EXR_CHECK(CountFiles(folder) == 2);

#ifndef _WIN32
  // A device is not replaced, for any user.
  writer->SetFileName("/dev/null");
  ExpectWriteError(writer, vtkErrorCode::CannotOpenFileError);
  EXR_CHECK(std::filesystem::is_character_file("/dev/null"));

  // A link stays a link.
  std::filesystem::create_symlink(folder + "target.exr", folder + "link.exr");
  writer->SetFileName((folder + "link.exr").c_str());
  writer->Write();
  EXR_CHECK(writer->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(std::filesystem::is_symlink(folder + "link.exr"));
  vtkNew<vtkOpenEXRReader> reader;
  EXR_CHECK(reader->CanReadFile((folder + "target.exr").c_str()) == 3);
  EXR_CHECK(CountFiles(folder) == 4);
#endif
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(ExistingFile)
{
  const std::string folder = GetFolder();
  const std::string path = WriteSmall(folder + "file.exr");
  const std::vector<char> before = ReadBytes(path);
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetFileName(path.c_str());
  writer->SetInputData(MakeImage({ 0, 3, 0, 3, 0, 0 }, 3));
  writer->AddLayer("other", MakeImage({ 0, 4, 0, 3, 0, 0 }, 3));
  ExpectWriteError(writer, vtkErrorCode::UserError);
  EXR_CHECK(ReadBytes(path) == before);
  EXR_CHECK(CountFiles(folder) == 1);

  writer->RemoveAllLayers();
  writer->Write();
  EXR_CHECK(writer->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(ReadBytes(path) != before);
  EXR_CHECK(CountFiles(folder) == 1);
}

//------------------------------------------------------------------------------
// A limit on the size of files simulates a full disk, with space for the header or the pixels or
// all but the last byte.
VTK_INDIRECT_TEST(DiskFull)
{
  const std::string folder = GetFolder();
#ifdef _WIN32
  (void)folder;
  std::exit(125);
#else
  const std::string path = WriteSmall(folder + "file.exr");
  const std::vector<char> before = ReadBytes(path);
  auto image = MakeImage({ 0, 99, 0, 99, 0, 0 }, 4);
  vtkNew<vtkOpenEXRWriter> whole;
  whole->SetInputData(image);
  whole->SetFileName((folder + "whole.exr").c_str());
  whole->Write();
  const std::uintmax_t size = std::filesystem::file_size(folder + "whole.exr");
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit old;
  getrlimit(RLIMIT_FSIZE, &old);
  for (std::uintmax_t limit : { std::uintmax_t(0), std::uintmax_t(100), size / 2, size - 1 })
  {
    for (const std::string& name : { path, folder + "new.exr" })
    {
      vtkNew<vtkOpenEXRWriter> writer;
      vtkNew<Messages> messages;
      messages->Watch(writer);
      writer->SetInputData(image);
      writer->SetFileName(name.c_str());
      rlimit small = old;
      small.rlim_cur = static_cast<rlim_t>(limit);
      setrlimit(RLIMIT_FSIZE, &small);
      writer->Write();
      setrlimit(RLIMIT_FSIZE, &old);
      EXR_CHECK(messages->Errors == 1);
      EXR_CHECK(messages->IsOneLine());
      EXR_CHECK(writer->GetErrorCode() == vtkErrorCode::OutOfDiskSpaceError);
      EXR_CHECK(CountFiles(folder) == 2);
      EXR_CHECK(ReadBytes(path) == before);
    }
  }
#endif
}
}
