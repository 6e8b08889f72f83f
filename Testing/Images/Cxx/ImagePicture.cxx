// SPDX-License-Identifier: BSD-3-Clause
#include "ImagePicture.h"
#include "ImageReference.h"

#include "vtkRegressionTestImage.h"

#include <algorithm>
#include <fstream>

namespace images
{
namespace
{
std::string WithoutEnding(const std::string& path)
{
  return path.substr(0, path.rfind('.'));
}

// The baseline and its alternatives, whose names end with _1, _2 and so on.
std::vector<std::string> FindAlternatives(const std::string& baseline)
{
  std::vector<std::string> paths;
  std::string path = baseline;
  while (std::ifstream(path).good())
  {
    paths.push_back(path);
    path = WithoutEnding(baseline) + "_" + std::to_string(paths.size()) + ".png";
  }
  return paths;
}

void CompareByVTK(vtkRenderWindow* window)
{
  std::vector<std::string> words = { "TestImages" };
  const std::vector<std::string>& arguments = vtkIndirectTest::GetArguments();
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> pointers;
  for (std::string& word : words)
  {
    pointers.push_back(&word[0]);
  }
  // Main of the macro, whose threshold depends on the version.
  const int argc = static_cast<int>(pointers.size());
  char** const argv = pointers.data();
  const int verdict = vtkRegressionTestImage(window);
  CONTRACT_CHECK(verdict == vtkTesting::PASSED, "VTK's metric");
}

// Differences of a frame from one baseline.
std::vector<std::string> FindDifferences(const contract::Pixels& pixels, const Grids& grids,
  const std::string& path, const Tolerance& tolerance)
{
  std::vector<std::string> found;
  const PixelDifference difference = Compare(pixels, ReadPNG(path), tolerance);
  std::cout << path.substr(path.rfind('/') + 1) << "\n  picture: " << difference << "\n";
  if (!difference.IsSmall)
  {
    found.emplace_back("the picture");
  }
  const Grids stored = ReadGrids(WithoutEnding(path) + ".json");
  for (const auto& entry : stored)
  {
    if (grids.count(entry.first) == 0)
    {
      found.push_back(entry.first + " (the frame has none)");
    }
  }
  for (const auto& entry : grids)
  {
    const auto old = stored.find(entry.first);
    if (old == stored.end())
    {
      found.push_back(entry.first + " (the baseline has none)");
      continue;
    }
    const Deviation deviation = Compare(entry.second, old->second, tolerance);
    std::cout << "  " << entry.first << ": " << deviation << "\n";
    if (!deviation.IsSmall)
    {
      found.push_back(entry.first);
    }
  }
  return found;
}
}

//------------------------------------------------------------------------------
std::string GetArgument(const std::string& flag)
{
  const std::vector<std::string>& arguments = vtkIndirectTest::GetArguments();
  const auto found = std::find(arguments.begin(), arguments.end(), flag);
  if (found == arguments.end() || found + 1 == arguments.end())
  {
    CONTRACT_CHECK(false, "no argument " << flag << "; ctest -L image gives it");
    return std::string();
  }
  return *(found + 1);
}

//------------------------------------------------------------------------------
Picture::Picture(int width, int height)
  : contract::View(width, height)
{
  this->Pass->SetEstimator(this->Gather);
  this->Pass->SetSampler(this->Sampler);
  // Separate cases test antialiasing: aliased edges show more of the other cases' subjects.
  this->Pass->AntialiasingOff();
  this->AddBuffers("", this->Pass);
}

//------------------------------------------------------------------------------
void Picture::ShowChannel(const std::string& channel)
{
  this->Pass->SetDebugView(channel);
  this->Buffers = { { channel, this->Pass, channel } };
}

//------------------------------------------------------------------------------
void Picture::AddBuffers(const std::string& prefix, vtkIndirectIlluminationPass* pass)
{
  this->Buffers.push_back({ prefix + "final", pass, "final" });
  this->Buffers.push_back({ prefix + "irradiance", pass, "irradiance" });
}

//------------------------------------------------------------------------------
void Run(const std::string& name, void (*draw)(Picture& picture))
{
  const std::string folder = GetArgument("-T");
  const std::string baseline = GetArgument("-V");
  const std::string place = baseline.substr(0, baseline.rfind('/'));
  const Tolerance tolerance = ReadTolerance(place + "/../tolerance.json");

  Picture picture;
  draw(picture);
  if (!picture.Renderer->GetPass())
  {
    picture.Renderer->SetPass(picture.Pass);
  }
  const contract::Pixels pixels = picture.Grab();
  Grids grids;
  for (const Picture::Buffer& buffer : picture.Buffers)
  {
    grids[buffer.Label] = MakeGrid(contract::Read(buffer.Pass, buffer.Channel));
  }
  // Files that `renew` collects.
  WritePNG(folder + "/" + name + ".now.png", pixels);
  WriteGrids(folder + "/" + name + ".now.json", grids);

  if (!std::ifstream(baseline).good())
  {
    CONTRACT_CHECK(false, "there is no baseline " << baseline);
    return;
  }
  CompareByVTK(picture.Window);
  bool agrees = false;
  std::string differences;
  for (const std::string& path : FindAlternatives(baseline))
  {
    const std::vector<std::string> found = FindDifferences(pixels, grids, path, tolerance);
    agrees = agrees || found.empty();
    for (const std::string& what : found)
    {
      differences += (differences.empty() ? "" : ", ") + what;
    }
  }
  CONTRACT_CHECK(agrees, "what differs: " << differences);
}
}
