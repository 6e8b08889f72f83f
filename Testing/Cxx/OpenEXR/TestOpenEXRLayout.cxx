// SPDX-License-Identifier: BSD-3-Clause
// The reader gives back what the writer was given around the values: layers, attributes, windows,
// pieces and series.

#include "OpenEXRTestTools.h"

using namespace exrtest;

namespace
{
//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Layers)
{
  const std::string folder = GetFolder();
  auto beauty = MakeImage({ 0, 19, 0, 14, 0, 0 }, 4, VTK_FLOAT, 1);
  auto albedo = MakeImage({ 0, 19, 0, 14, 0, 0 }, 3, VTK_FLOAT, 2);
  auto depth = MakeImage({ 5, 24, -3, 11, 2, 2 }, 1, VTK_FLOAT, 3); // same dimensions, elsewhere
  auto many = MakeImage({ 0, 19, 0, 14, 0, 0 }, 11, VTK_FLOAT, 4);
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(beauty);
  writer->SetPixelTypeToFloat();
  writer->AddLayer("rsm0.depth", many);
  writer->AddLayer("albedo", albedo);
  writer->AddLayer("rsm0.depth", depth); // replaces
  writer->AddLayer("many", many);
  EXR_CHECK(writer->GetNumberOfLayers() == 3);
  EXR_CHECK(writer->GetLayerName(0) == "albedo");
  EXR_CHECK(writer->GetLayerName(3).empty());
  Write(writer, folder + "layers.exr");

  vtkNew<vtkOpenEXRReader> reader;
  reader->SetFileName((folder + "layers.exr").c_str());
  EXR_CHECK(reader->GetNumberOfLayers() == 0);
  EXR_CHECK(reader->ReadHeader());
  EXR_CHECK(reader->GetNumberOfLayers() == 4);
  EXR_CHECK(reader->GetLayerName(0).empty());
  EXR_CHECK(reader->GetLayerName(1) == "albedo");
  EXR_CHECK(reader->GetLayerName(2) == "many");
  EXR_CHECK(reader->GetLayerName(3) == "rsm0.depth");
  EXR_CHECK(reader->GetLayerName(4).empty());
  EXR_CHECK(reader->GetLayerName(-1).empty());
  reader->Update();
  EXR_CHECK(SameBits(beauty, reader->GetOutput()));
  const std::string names[] = { "R", "G", "B", "A", "" };
  for (int i = 0; i < 5; ++i)
  {
    EXR_CHECK(reader->GetChannelName(i) == names[i]);
  }
  reader->SetLayer("albedo");
  reader->Update();
  EXR_CHECK(SameBits(albedo, reader->GetOutput()));
  reader->SetLayer("rsm0.depth");
  reader->Update();
  EXR_CHECK(reader->GetChannelName(0) == "Y");
  EXR_CHECK(reader->GetOutput()->GetNumberOfScalarComponents() == 1);
  EXR_CHECK(
    std::memcmp(FloatData(reader->GetOutput()), FloatData(depth), 300 * sizeof(float)) == 0);
  reader->SetLayer("many");
  reader->Update();
  EXR_CHECK(reader->GetChannelName(10) == "C10");
  EXR_CHECK(reader->GetChannelName(0) == "C00");
  EXR_CHECK(SameBits(many, reader->GetOutput()));

  writer->RemoveAllLayers();
  EXR_CHECK(writer->GetNumberOfLayers() == 0);
  Write(writer, folder + "layers.exr");
  EXR_CHECK(reader->ReadHeader());
  EXR_CHECK(reader->GetNumberOfLayers() == 1);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Attributes)
{
  const std::string folder = GetFolder();
  const std::string binary = std::string("a\0b\n\xff", 5);
  const std::string longName(255, 'n');
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(MakeImage({ 0, 3, 0, 3, 0, 0 }, 3));
  writer->SetAttribute("comments", "first");
  writer->SetAttribute("comments", "a frame");
  writer->SetAttribute("empty", "");
  writer->SetAttribute("binary", binary);
  writer->SetAttribute("long", std::string(100000, 'x'));
  writer->SetAttribute(longName, "named");
  EXR_CHECK(writer->GetAttribute("comments") == "a frame");
  EXR_CHECK(writer->GetAttribute("nothing").empty());
  writer->SetPixelAspectRatio(1.5);
  Write(writer, folder + "attributes.exr");
  vtkNew<vtkOpenEXRReader> reader;
  reader->SetFileName((folder + "attributes.exr").c_str());
  EXR_CHECK(reader->ReadHeader());
  EXR_CHECK(reader->GetAttribute("comments") == "a frame");
  EXR_CHECK(reader->HasAttribute("empty"));
  EXR_CHECK(reader->GetAttribute("empty").empty());
  EXR_CHECK(reader->GetAttribute("binary") == binary);
  EXR_CHECK(reader->GetAttribute("long") == std::string(100000, 'x'));
  EXR_CHECK(reader->GetAttribute(longName) == "named");
  EXR_CHECK(!reader->HasAttribute("nothing"));
  EXR_CHECK(reader->GetAttribute("nothing").empty());
  EXR_CHECK(reader->GetNumberOfAttributes() >= 5);
  EXR_CHECK(reader->GetAttributeName(0) == "binary");
  EXR_CHECK(reader->GetAttributeName(-1).empty());
  EXR_CHECK(std::abs(reader->GetPixelAspectRatio() - 1.5) < 1e-6);
  writer->RemoveAllAttributes();
  Write(writer, folder + "attributes.exr");
  EXR_CHECK(reader->ReadHeader());
  EXR_CHECK(!reader->HasAttribute("comments"));
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Windows)
{
  const std::string folder = GetFolder();
  // The extent becomes the data window, also with negative numbers.
  for (const std::vector<int>& extent :
    { std::vector<int>{ -7, 4, -20, -3, 0, 0 }, std::vector<int>{ 100, 130, -5, 40, 0, 0 } })
  {
    auto image = MakeImage(extent, 3);
    vtkNew<vtkOpenEXRWriter> writer;
    writer->SetInputData(image);
    writer->SetPixelTypeToFloat();
    Write(writer, folder + "window.exr");
    vtkNew<vtkOpenEXRReader> reader;
    Read(reader, folder + "window.exr");
    EXR_CHECK(SameBits(image, reader->GetOutput()));
    for (int i = 0; i < 4; ++i)
    {
      EXR_CHECK(reader->GetDataWindow()[i] == extent[static_cast<std::size_t>(i)]);
      EXR_CHECK(reader->GetDisplayWindow()[i] == extent[static_cast<std::size_t>(i)]);
    }
  }

  // A data window partly outside of the display window.
  auto image = MakeImage({ -3, 8, 4, 12, 0, 0 }, 2);
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(image);
  writer->SetPixelTypeToFloat();
  writer->SetDisplayWindow(0, 15, 0, 9);
  Write(writer, folder + "display.exr");
  vtkNew<vtkOpenEXRReader> reader;
  EXR_CHECK(!reader->GetUseDisplayWindow());
  Read(reader, folder + "display.exr");
  EXR_CHECK(SameBits(image, reader->GetOutput()));
  const int data[4] = { -3, 8, -3, 5 }; // row y of the extent is row 9 - y of the file
  const int display[4] = { 0, 15, 0, 9 };
  EXR_CHECK(std::equal(data, data + 4, reader->GetDataWindow()));
  EXR_CHECK(std::equal(display, display + 4, reader->GetDisplayWindow()));

  reader->UseDisplayWindowOn();
  reader->Update();
  vtkImageData* output = reader->GetOutput();
  EXR_CHECK(output->GetExtent()[0] == 0 && output->GetExtent()[1] == 15);
  EXR_CHECK(output->GetExtent()[2] == 0 && output->GetExtent()[3] == 9);
  int different = 0;
  for (int y = 0; y <= 9; ++y)
  {
    for (int x = 0; x <= 15; ++x)
    {
      for (int c = 0; c < 2; ++c)
      {
        const bool inside = x <= 8 && y >= 4;
        const float expected = inside ? image->GetScalarComponentAsFloat(x, y, 0, c) : 0.0f;
        different += output->GetScalarComponentAsFloat(x, y, 0, c) == expected ? 0 : 1;
      }
    }
  }
  EXR_CHECK(different == 0);

  // Windows that do not meet at all.
  writer->SetDisplayWindow(1000, 1003, 2000, 2001);
  Write(writer, folder + "display.exr");
  reader->Modified();
  reader->Update();
  EXR_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(reader->GetOutput()->GetNumberOfPoints() == 8);
  EXR_CHECK(reader->GetOutput()->GetScalarRange()[1] == 0.0);
  reader->UseDisplayWindowOff();
  reader->Update();
  EXR_CHECK(SameBits(image, reader->GetOutput()));
}

//------------------------------------------------------------------------------
// The pipeline may ask for a piece of the image.
VTK_INDIRECT_TEST(SubExtent)
{
  const std::string folder = GetFolder();
  auto image = MakeImage({ -10, 89, 5, 204, 0, 0 }, 3);
  for (int compression = 0; compression < 3; ++compression)
  {
    vtkNew<vtkOpenEXRWriter> writer;
    writer->SetInputData(image);
    writer->SetPixelTypeToFloat();
    writer->SetCompression(compression);
    Write(writer, folder + "sub.exr");
    Random random(9);
    for (int i = 0; i < 30; ++i)
    {
      int extent[6] = { -10 + static_cast<int>(random.Below(100)), 0,
        5 + static_cast<int>(random.Below(200)), 0, 0, 0 };
      extent[1] = extent[0] + static_cast<int>(random.Below(static_cast<unsigned>(90 - extent[0])));
      extent[3] =
        extent[2] + static_cast<int>(random.Below(static_cast<unsigned>(205 - extent[2])));
      vtkNew<vtkOpenEXRReader> reader;
      reader->SetFileName((folder + "sub.exr").c_str());
      reader->UpdateExtent(extent);
      vtkNew<vtkImageData> expected;
      expected->DeepCopy(image);
      expected->Crop(extent);
      EXR_CHECK(SameBits(expected, reader->GetOutput()));
    }
  }
}

//------------------------------------------------------------------------------
// The name that the writer gives the file of slice 7, and that the reader then finds. A prefix of
// "" is none.
std::string NameOfSeven(
  const std::string& folder, const std::string& prefix, const std::string& pattern)
{
  auto slice = MakeImage({ 0, 7, 0, 5, 7, 7 }, 3);
  const std::string place = folder + "patterns/";
  std::filesystem::remove_all(place);
  std::filesystem::create_directory(place);
  vtkNew<vtkOpenEXRWriter> writer;
  vtkNew<vtkOpenEXRReader> reader;
  const std::string fullPattern = prefix.empty() ? place + pattern : pattern;
  if (!prefix.empty())
  {
    writer->SetFilePrefix((place + prefix).c_str());
    reader->SetFilePrefix((place + prefix).c_str());
  }
  // VTK's own default is not set.
  if (!pattern.empty())
  {
    writer->SetFilePattern(fullPattern.c_str());
    reader->SetFilePattern(fullPattern.c_str());
  }
  writer->SetInputData(slice);
  writer->SetPixelTypeToFloat();
  writer->Write();
  EXR_CHECK(writer->GetErrorCode() == vtkErrorCode::NoError);
  reader->SetDataExtent(0, 0, 0, 0, 7, 7);
  reader->Update();
  EXR_CHECK(reader->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(SameBits(slice, reader->GetOutput()));
  std::string name;
  for (const auto& file : std::filesystem::directory_iterator(place))
  {
    name += file.path().filename().string();
  }
  return name;
}

//------------------------------------------------------------------------------
// Names of series, in both syntaxes with any version of VTK. What is expected is what printf and
// std::format make of the pattern.
VTK_INDIRECT_TEST(Patterns)
{
  const std::string folder = GetFolder();
  const struct
  {
    const char* Prefix;
    const char* Pattern;
    const char* Name;
  } cases[] = {
    { "a", "", "a.7" },
    { "a", "%s.%d", "a.7" },
    { "a", "{:s}.{:d}", "a.7" },
    { "a", "%s_%03d.exr", "a_007.exr" },
    { "a", "{:s}_{:03d}.exr", "a_007.exr" },
    { "a", "{}_{}.exr", "a_7.exr" },
    { "a", "{0:s}_{1:d}.exr", "a_7.exr" },
    { "a", "%s_%-3dx", "a_7  x" },
    { "a", "{:s}_{:<3d}x", "a_7  x" },
    { "a", "%s_%3i", "a_  7" },
    { "a", "{:s}_{:>3}", "a_  7" },
    { "a", "%s_%+.2d", "a_+07" },
    { "a", "{:s}_{:+d}", "a_+7" },
    { "a", "{:s}_{:-d}", "a_7" },
    { "a", "%s%%{x}_%d", "a%{x}_7" },
    { "a", "{:s}{{%}}_{:d}", "a{%}_7" },
    { "a", "{:s}_{:#04x}", "a_0x07" },
    { "a", "{:s}", "a" },
    { "", "b%02d.exr", "b07.exr" },
    { "", "b{:02d}.exr", "b07.exr" },
    { "", "b{}.exr", "b7.exr" },
    { "", "b.exr", "b.exr" },
  };
  for (const auto& expected : cases)
  {
    const std::string name = NameOfSeven(folder, expected.Prefix, expected.Pattern);
    std::cout << "\"" << expected.Pattern << "\": " << name << "\n";
    EXR_CHECK(name == expected.Name);
  }

  // What does not fit makes no file, and is not handed to printf.
  for (const char* pattern :
    { "%d_%s", "%s_%s", "%s_%d_%d", "%s_%n", "%s_%f", "%s_%d%", "%s_%9999d", "{:d}_{:s}",
      "{:s}_{:d}_{:d}", "{:s}_{:f}", "{:s}_{:d", "{:s}_{2}", "{:s}_{:*>3d}", "{x}" })
  {
    vtkNew<vtkOpenEXRWriter> writer;
    writer->SetInputData(MakeImage({ 0, 3, 0, 3, 0, 0 }, 1));
    writer->SetFilePrefix((folder + "wrong").c_str());
    writer->SetFilePattern(pattern);
    ExpectWriteError(writer, vtkErrorCode::UserError);
    vtkNew<vtkOpenEXRReader> reader;
    reader->SetFilePrefix((folder + "wrong").c_str());
    reader->SetFilePattern(pattern);
    ExpectReadError(reader, vtkErrorCode::UserError);
  }
  vtkNew<vtkOpenEXRWriter> noPrefix;
  noPrefix->SetInputData(MakeImage({ 0, 3, 0, 3, 0, 0 }, 1));
  noPrefix->SetFilePattern("%s_%d.exr");
  ExpectWriteError(noPrefix, vtkErrorCode::UserError);
  EXR_CHECK(CountFiles(folder) == 1); // the folder of names
  vtkNew<vtkOpenEXRReader> noPattern;
  noPattern->SetFilePrefix((folder + "wrong").c_str());
  noPattern->SetFilePattern(nullptr);
  ExpectReadError(noPattern, vtkErrorCode::NoFileNameError);
}

//------------------------------------------------------------------------------
// A volume is a series of files.
VTK_INDIRECT_TEST(Series)
{
  const std::string folder = GetFolder();
  auto volume = MakeImage({ 0, 7, 0, 5, 3, 6 }, 3);
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(volume);
  writer->SetPixelTypeToFloat();
  writer->SetFilePrefix((folder + "slice").c_str());
  writer->SetFilePattern("%s_%02d.exr");
  writer->Write();
  EXR_CHECK(writer->GetErrorCode() == vtkErrorCode::NoError);
  EXR_CHECK(CountFiles(folder) == 4);
  EXR_CHECK(std::filesystem::exists(folder + "slice_03.exr"));

  vtkNew<vtkOpenEXRReader> reader;
  reader->SetDataExtent(0, 0, 0, 0, 3, 6);
  reader->SetFilePrefix((folder + "slice").c_str());
  reader->SetFilePattern("%s_%02d.exr");
  reader->Update();
  EXR_CHECK(SameBits(volume, reader->GetOutput()));

  // One slice that differs is an error.
  vtkNew<vtkOpenEXRWriter> other;
  other->SetInputData(MakeImage({ 0, 6, 0, 5, 0, 0 }, 3));
  Write(other, folder + "slice_05.exr");
  reader->Modified();
  ExpectReadError(reader, vtkErrorCode::FileFormatError);
}
}
