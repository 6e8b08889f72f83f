// SPDX-License-Identifier: BSD-3-Clause
// The reader returns the writer's layers and windows.

#include "OpenEXRLibraryFiles.h"

#include "vtkExtractVOI.h"

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
  Write(writer, folder + "layers.exr");

  vtkNew<vtkOpenEXRReader> reader;
  reader->SetFileName((folder + "layers.exr").c_str());
  EXR_CHECK(reader->GetNumberOfLayers() == 0);
  reader->UpdateInformation();
  EXR_CHECK(reader->GetNumberOfLayers() == 4);
  EXR_CHECK(reader->GetLayerName(0).empty());
  EXR_CHECK(reader->GetLayerName(1) == "albedo");
  EXR_CHECK(reader->GetLayerName(2) == "many");
  EXR_CHECK(reader->GetLayerName(3) == "rsm0.depth");
  EXR_CHECK(reader->GetLayerName(4).empty());
  EXR_CHECK(reader->GetLayerName(-1).empty());
  reader->Update();
  EXR_CHECK(SameBits(beauty, reader->GetOutput()));
  const std::string names[] = { "R", "G", "B", "A" };
  for (int i = 0; i < 4; ++i)
  {
    EXR_CHECK(ComponentName(reader, i) == names[i]);
  }
  reader->SetLayer("albedo");
  reader->Update();
  EXR_CHECK(SameBits(albedo, reader->GetOutput()));
  reader->SetLayer("rsm0.depth");
  reader->Update();
  EXR_CHECK(ComponentName(reader, 0) == "Y");
  EXR_CHECK(reader->GetOutput()->GetNumberOfScalarComponents() == 1);
  EXR_CHECK(
    std::memcmp(FloatData(reader->GetOutput()), FloatData(depth), 300 * sizeof(float)) == 0);
  reader->SetLayer("many");
  reader->Update();
  EXR_CHECK(ComponentName(reader, 10) == "C10");
  EXR_CHECK(ComponentName(reader, 0) == "C00");
  EXR_CHECK(SameBits(many, reader->GetOutput()));

  writer->RemoveAllLayers();
  Write(writer, folder + "layers.exr");
  reader->SetLayer("");
  reader->UpdateInformation();
  EXR_CHECK(reader->GetNumberOfLayers() == 1);
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
    const exr::InputFile file((folder + "window.exr").c_str());
    const imath::Box2i window = MakeWindow(extent[0], extent[1], extent[2], extent[3]);
    EXR_CHECK(file.header().dataWindow() == window);
    EXR_CHECK(file.header().displayWindow() == window);
  }

  // A data window partly outside of the display window, and one that does not meet it.
  for (const imath::Box2i& display : { MakeWindow(0, 15, 0, 9), MakeWindow(1000, 1003, 70, 71) })
  {
    const imath::Box2i data = MakeWindow(-3, 8, -3, 5);
    std::vector<Plane> planes;
    planes.emplace_back("Y", exr::FLOAT, data, 1);
    WriteScanlines(
      folder + "display.exr", data, planes, exr::ZIP_COMPRESSION, exr::INCREASING_Y, &display);
    vtkNew<vtkOpenEXRReader> reader;
    Read(reader, folder + "display.exr");
    // Row y of the file is row D - y of the image.
    const int sum = display.min.y + display.max.y;
    int extent[6];
    reader->GetOutput()->GetExtent(extent);
    EXR_CHECK(extent[2] == sum - 5 && extent[3] == sum + 3);
    reader->GetOutput()->SetExtent(-3, 8, -3, 5, 0, 0);
    EXR_CHECK(Holds(reader->GetOutput(), data, { &planes[0] }));
  }
}

//------------------------------------------------------------------------------
// The output is always the whole image, whichever piece the pipeline requests.
VTK_INDIRECT_TEST(SubExtent)
{
  const std::string folder = GetFolder();
  auto image = MakeImage({ -10, 89, 5, 204, 0, 0 }, 3);
  vtkNew<vtkOpenEXRWriter> writer;
  writer->SetInputData(image);
  writer->SetPixelTypeToFloat();
  Write(writer, folder + "sub.exr");
  int extent[6] = { 3, 20, 50, 204, 0, 0 };
  vtkNew<vtkOpenEXRReader> reader;
  reader->SetFileName((folder + "sub.exr").c_str());
  reader->UpdateExtent(extent);
  EXR_CHECK(SameBits(image, reader->GetOutput()));

  // A filter that requests a piece gets its pixels.
  vtkNew<vtkExtractVOI> part;
  part->SetInputConnection(reader->GetOutputPort());
  part->SetVOI(extent);
  part->Update();
  image->Crop(extent);
  EXR_CHECK(SameBits(image, part->GetOutput()));
}
}
