// SPDX-License-Identifier: BSD-3-Clause
#include "CardExpected.h"

#include "CardMethods.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <map>
#include <stdexcept>
#include <utility>

using Json = nlohmann::json;

namespace
{
enum class Scale
{
  One,   // the values' own unit
  Value, // each value
  Mean,  // the mean of the expected values' magnitudes
  Column // the same of the values with the same meaning in a table, column by column
};

// Two implementations of OpenGL draw an edge through other pixels, and a virtual light whose texel
// lies on an edge in a map is another one. So a share of the places may differ by any amount, as in
// the tests that compare pictures.
struct Tolerance
{
  const char* Buffer;
  double Limit;
  Scale Of;
  double Share; // of places that may differ by more
  const char* Why;
};

const char* const Pictures = "the tests of pictures: 4 of 255 at 99 % of the pixels";
const Tolerance Tolerances[] = {
  { "depth", 1e-4, Scale::Value, 0.005, "interpolated along edges of triangles; silhouettes" },
  { "normal", 1e-3, Scale::One, 0.01,
    "interpolated 1/512 of a pixel beside the ray, measured 1.2e-3 at single places; silhouettes" },
  { "albedo", 2e-3, Scale::One, 0.005, "KernelParity: the next of 1023 roots; silhouettes" },
  { "specular", 2e-3, Scale::One, 0.005, "half floats; silhouettes" },
  { "direct", 0.01, Scale::Mean, 0.01, "shadows' edges, silhouettes" },
  { "rsm0.depth", 1e-4, Scale::Value, 0.005, "as depth" },
  { "rsm0.normal", 1e-3, Scale::One, 0.01, "as normal" },
  { "rsm0.density", 2e-3, Scale::Mean, 0.02, "half floats, 2^-10; silhouettes" },
  { "lights", 2e-3, Scale::Column, 0.02,
    "AllTexelsSpot: half floats, 2^-10; lights on silhouettes" },
  { "irradiance", 0.02, Scale::Mean, 0.01,
    "MultiresolutionError: what default thresholds allow, which rounding crosses; see "
    "Method::Share" },
  { "indirect", 0.02, Scale::Mean, 0.01, "as irradiance" },
  { "glossy", 0.02, Scale::Mean, 0.01, "as irradiance" },
  { "final", 0.02, Scale::Mean, 0.01, "direct and indirect light" },
  { "window", 4.0 / 255.0, Scale::One, 0.01, Pictures },
};

// The mean over a whole buffer may differ by this share: single places do not count there.
constexpr double MeanLimit = 0.005;
// The same where a walk finds the senders: an H200 and llvmpipe differ by 0.0055.
constexpr double WalkedMeanLimit = 0.01;
// The error against the path tracer may differ by this share: these differ by 0.023.
constexpr double ErrorLimit = 0.05;

const Tolerance& FindTolerance(const std::string& buffer)
{
  for (const Tolerance& tolerance : Tolerances)
  {
    if (buffer == tolerance.Buffer)
    {
      return tolerance;
    }
  }
  throw std::runtime_error("no tolerance is known for the buffer '" + buffer + "'");
}

// The table of lights is small, and compared whole.
std::vector<std::array<int, 2>> GetPlaces(const std::string& buffer, const card::Image& image)
{
  if (buffer != "lights")
  {
    return card::MakePlaces(image.Width, image.Height);
  }
  std::vector<std::array<int, 2>> places;
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      places.push_back({ x, y });
    }
  }
  return places;
}

std::vector<float> Take(const card::Image& image, const std::vector<std::array<int, 2>>& places)
{
  std::vector<float> values;
  for (const auto& place : places)
  {
    const float* pixel = image.At(place[0], place[1]);
    values.insert(values.end(), pixel, pixel + image.Components);
  }
  return values;
}

double GetMean(const card::Image& image)
{
  double sum = 0.0;
  for (float value : image.Values)
  {
    sum += value;
  }
  return sum / std::max<size_t>(1, image.Values.size());
}
}

//------------------------------------------------------------------------------
std::vector<std::string> card::GetBufferNames(const Method& method)
{
  if (!method.SetUp)
  {
    // VTK's own ambient occlusion is here for its time.
    return method.Name == std::string("ssao") ? std::vector<std::string>{}
                                              : std::vector<std::string>{ "window" };
  }
  if (method.Name != std::string("automatic"))
  {
    return { "irradiance", "indirect", "window" };
  }
  return { "depth", "normal", "albedo", "direct", "rsm0.depth", "rsm0.normal", "rsm0.density",
    "lights", "irradiance", "indirect", "final", "window" };
}

//------------------------------------------------------------------------------
card::Expected::Expected(const std::string& folder, int width, int height)
  : Path(folder + "/expected-" + std::to_string(width) + "x" + std::to_string(height) + ".msgpack")
  , Values(Json::object())
{
  std::ifstream file(this->Path, std::ios::binary);
  if (file)
  {
    try
    {
      this->Values = Json::from_msgpack(file);
    }
    catch (const Json::exception& error)
    {
      throw std::runtime_error(this->Path + ": " + error.what());
    }
  }
}

//------------------------------------------------------------------------------
void card::Expected::Record(
  const std::string& method, const std::string& buffer, const Image& image)
{
  const std::vector<float> values = Take(image, GetPlaces(buffer, image));
  std::vector<std::uint8_t> bytes(values.size() * sizeof(float));
  std::memcpy(bytes.data(), values.data(), bytes.size());
  this->Values[method][buffer] = { { "width", image.Width }, { "height", image.Height },
    { "components", image.Components }, { "mean", GetMean(image) },
    { "values", Json::binary(std::move(bytes)) } };
}

//------------------------------------------------------------------------------
void card::Expected::Write() const
{
  std::ofstream file(this->Path, std::ios::binary);
  Json::to_msgpack(this->Values, nlohmann::detail::output_adapter<char>(file));
  if (!file)
  {
    throw std::runtime_error(this->Path + " cannot be written");
  }
}

//------------------------------------------------------------------------------
Json card::Expected::Check(const Method& method, const std::string& buffer, const Image& image,
  std::vector<std::array<int, 2>>& bad) const
{
  const Tolerance& tolerance = FindTolerance(buffer);
  Json result = { { "buffer", buffer }, { "passed", false } };
  if (!this->Values.contains(method.Name) || !this->Values.at(method.Name).contains(buffer))
  {
    result["why"] = "the pack has no values of it";
    return result;
  }
  const Json& found = this->Values.at(method.Name).at(buffer);
  if (found.at("width") != image.Width || found.at("height") != image.Height ||
    found.at("components") != image.Components)
  {
    result["why"] = "the buffer has another size than expected";
    return result;
  }
  const std::vector<std::array<int, 2>> places = GetPlaces(buffer, image);
  const std::vector<float> values = Take(image, places);
  const auto& bytes = found.at("values").get_binary();
  std::vector<float> expected(bytes.size() / sizeof(float));
  std::memcpy(expected.data(), bytes.data(), bytes.size());
  double magnitude = 0.0;
  for (float value : expected)
  {
    magnitude += std::abs(value);
  }
  magnitude /= std::max<size_t>(1, expected.size());

  const bool isIndirect = buffer == "irradiance" || buffer == "indirect";
  const bool isWalked = method.IsWalked() &&
    (isIndirect || buffer == "lights" || buffer == "final" || buffer == "window");
  const double allowed = isIndirect || isWalked ? method.Share : tolerance.Share;
  std::map<std::pair<int, int>, double> columns;
  for (size_t i = 0; i < std::min(expected.size(), places.size() * image.Components); ++i)
  {
    const int column = places[i / image.Components][0];
    columns[{ column, static_cast<int>(i % image.Components) }] +=
      std::abs(expected[i]) / image.Height;
  }
  double worst = 0.0;
  bool finite = expected.size() == values.size();
  for (size_t i = 0; finite && i < places.size(); ++i)
  {
    double difference = 0.0;
    for (int c = 0; c < image.Components; ++c)
    {
      const size_t at = image.Components * i + c;
      double unit = 1.0;
      switch (tolerance.Of)
      {
        case Scale::One:
          break;
        case Scale::Value:
          unit = std::abs(expected[at]);
          break;
        case Scale::Mean:
          unit = magnitude;
          break;
        case Scale::Column:
          // Values that are zero everywhere, such as a plane's height: compare neighbours.
          unit = 0.0;
          for (int k = 0; k < image.Components; ++k)
          {
            const double share = k == c ? 1.0 : 0.01;
            unit = std::max(unit, share * columns.at({ places[i][0], k }));
          }
          break;
      }
      const double off = std::abs(static_cast<double>(values[at]) - expected[at]);
      difference = std::max(difference, off > 0.0 ? off / std::max(unit, 1e-30) : 0.0);
      finite = finite && std::isfinite(values[at]);
    }
    worst = std::max(worst, difference);
    if (difference > tolerance.Limit)
    {
      bad.push_back(places[i]);
    }
  }
  const double share = static_cast<double>(bad.size()) / std::max<size_t>(1, places.size());
  const double mean = GetMean(image);
  const double wanted = found.at("mean");
  const double off = std::abs(mean - wanted) / std::max(magnitude, 1e-30);
  // A buffer that is cut into hemispheres or signs has a mean near zero: its magnitude is the unit.
  result["worst"] = worst;
  result["share"] = share;
  result["mean"] = off;
  result["tolerance"] = tolerance.Limit;
  result["allowed_share"] = allowed;
  result["passed"] = finite && share <= allowed && off <= (isWalked ? WalkedMeanLimit : MeanLimit);
  result["why"] = finite ? tolerance.Why : "there are values that are not finite";
  return result;
}

//------------------------------------------------------------------------------
void card::Expected::RecordError(const std::string& method, double error)
{
  this->Values[method]["error"] = error;
}

//------------------------------------------------------------------------------
Json card::Expected::CheckError(const Method& method, double error) const
{
  Json result = { { "buffer", "error" }, { "passed", false } };
  if (!this->Values.contains(method.Name) || !this->Values.at(method.Name).contains("error"))
  {
    result["why"] = "the pack has no error of it";
    return result;
  }
  const double expected = this->Values.at(method.Name).at("error");
  const double off = std::abs(error / expected - 1.0);
  result["worst"] = off;
  result["share"] = 0.0;
  result["mean"] = off;
  result["tolerance"] = ErrorLimit;
  result["allowed_share"] = 0.0;
  result["passed"] = off <= ErrorLimit;
  result["why"] = "nRMSE R3 over that of the processor's picture";
  return result;
}
