// SPDX-License-Identifier: BSD-3-Clause
// The metrics must detect certain errors, tested on the baseline of EstimatorVirtualLights.
#include "ImagePicture.h"
#include "ImageReference.h"

#include <algorithm>

namespace
{
bool IsSame(const contract::Floats& buffer, const images::Grid& stored,
  const images::Tolerance& tolerance, const std::string& what)
{
  const images::Deviation deviation = images::Compare(images::MakeGrid(buffer), stored, tolerance);
  std::cout << what << ": " << deviation << "\n";
  return deviation.IsSmall;
}
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Tolerance)
{
  const std::string baseline = images::GetArgument("-V");
  const std::string place = baseline.substr(0, baseline.rfind('/'));
  const images::Tolerance tolerance = images::ReadTolerance(place + "/../tolerance.json");
  images::Grids stored = images::ReadGrids(baseline.substr(0, baseline.rfind('.')) + ".json");
  CONTRACT_CHECK(stored.count("final") && stored.count("irradiance"), "no baseline " << baseline);

  images::Picture picture;
  images::AddRoom(picture);
  picture.Renderer->SetPass(picture.Pass);
  const contract::Pixels pixels = picture.Grab();
  const contract::Floats final = contract::Read(picture.Pass, "final");
  const contract::Floats irradiance = contract::Read(picture.Pass, "irradiance");
  CONTRACT_CHECK(IsSame(final, stored["final"], tolerance, "final"), "final");
  CONTRACT_CHECK(IsSame(irradiance, stored["irradiance"], tolerance, "irradiance"), "irradiance");
  CONTRACT_CHECK(
    images::Compare(pixels, images::ReadPNG(baseline), tolerance).IsSmall, "the picture");

  // 3 % more indirect light.
  picture.Pass->SetIndirectScale(1.03);
  picture.Grab();
  const contract::Floats scaled = contract::Read(picture.Pass, "final");
  CONTRACT_CHECK(!IsSame(scaled, stored["final"], tolerance, "indirect light times 1.03"),
    "3 % more indirect light is not found in the picture");
  contract::Floats brighter = irradiance;
  for (float& value : brighter.Values)
  {
    value *= 1.03f;
  }
  CONTRACT_CHECK(!IsSame(brighter, stored["irradiance"], tolerance, "irradiance times 1.03"),
    "3 % more irradiance is not found");

  // A tenth less indirect light is also visible in the picture.
  picture.Pass->SetIndirectScale(0.9);
  const images::PixelDifference darker =
    images::Compare(picture.Grab(), images::ReadPNG(baseline), tolerance);
  std::cout << "indirect light times 0.9, the picture: " << darker << "\n";
  CONTRACT_CHECK(!darker.IsSmall, "a tenth less indirect light is not found in the picture");

  // 8 of 255 more everywhere.
  contract::Floats lifted = final;
  for (float& value : lifted.Values)
  {
    value += 8.0f / 255.0f;
  }
  CONTRACT_CHECK(!IsSame(lifted, stored["final"], tolerance, "final + 8/255"),
    "8 of 255 more is not found in the buffer");
  contract::Pixels lighter = pixels;
  for (unsigned char& value : lighter.Values)
  {
    value = static_cast<unsigned char>(std::min(255, value + 8));
  }
  CONTRACT_CHECK(!images::Compare(lighter, images::ReadPNG(baseline), tolerance).IsSmall,
    "8 of 255 more is not found in the picture");

  // A NaN.
  contract::Floats undefined = final;
  undefined.Values[0] = std::nanf("");
  CONTRACT_CHECK(!IsSame(undefined, stored["final"], tolerance, "final with a NaN"),
    "a value that is undefined is not found");
}
