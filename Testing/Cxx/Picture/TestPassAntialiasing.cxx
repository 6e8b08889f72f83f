// SPDX-License-Identifier: BSD-3-Clause
// Antialiased edges against pictures of many more pixels, and the parts that stay unchanged.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractUtilities.h"

#include "vtkMath.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkRenderWindow.h"
#include "vtkSSAAPass.h"
#include "vtkToneMappingPass.h"

#include <algorithm>
#include <set>

using namespace contract;

namespace
{
constexpr int Edge = 96; // pixels of a picture

// A view of 2 x 2 units around the origin.
struct Board : View
{
  vtkNew<vtkIndirectIlluminationPass> Pass;

  explicit Board(bool antialiasing = true, int width = Edge, int height = Edge)
    : View(width, height)
  {
    this->Renderer->SetBackground(0.2, 0.2, 0.2);
    this->Renderer->AddLight(MakeLight(LightKind::Spot, { 0.3, 0.4, 5 }, { 0, 0, 0 }));
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetParallelScale(1.0);
    camera->SetPosition(0, 0, 5);
    camera->SetFocalPoint(0, 0, 0);
    camera->SetClippingRange(1, 10);
    this->Pass->SetAntialiasing(antialiasing);
    this->Renderer->SetPass(this->Pass);
  }
  // Adds a surface of one colour, independent of the light.
  void AddFlat(const vtkSmartPointer<vtkActor>& actor)
  {
    actor->GetProperty()->LightingOff();
    this->Renderer->AddActor(actor);
  }
  // Adds a surface that covers everything below a line at this angle and distance from the middle.
  void AddHalfPlane(double degrees, double distance, double width = 4.0)
  {
    const double c = std::cos(vtkMath::RadiansFromDegrees(degrees));
    const double s = std::sin(vtkMath::RadiansFromDegrees(degrees));
    const double x = -s * distance;
    const double y = c * distance;
    this->AddFlat(MakeQuad({ x - 4 * c + width * s, y - 4 * s - width * c, 0 },
      { x + 4 * c + width * s, y + 4 * s - width * c, 0 }, { x - 4 * c, y - 4 * s, 0 },
      { 1, 1, 1 }));
  }
};

// Means of blocks of factor x factor pixels.
Floats Average(const Pixels& image, int factor)
{
  Floats result;
  result.Width = image.Width / factor;
  result.Height = image.Height / factor;
  result.Components = 4;
  result.Values.resize(static_cast<size_t>(result.Width) * result.Height * 4);
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      for (int c = 0; c < 4; ++c)
      {
        result.Values[4 * (static_cast<size_t>(y / factor) * result.Width + x / factor) + c] +=
          static_cast<float>(image.Get(x, y, c)) / static_cast<float>(factor * factor);
      }
    }
  }
  return result;
}

struct Quality
{
  double Square = 0.0;  // sum of squared errors, of the first component
  std::set<int> Levels; // levels of pixels that the line passes through
};

// Compares with the expected picture without the border, beyond which an outline has no neighbours.
Quality Measure(const Pixels& image, const Floats& expected)
{
  Quality quality;
  constexpr int border = 4;
  for (int y = border; y < image.Height - border; ++y)
  {
    for (int x = border; x < image.Width - border; ++x)
    {
      const double value = expected.Get(x, y, 0);
      quality.Square += std::pow(image.Get(x, y, 0) - value, 2);
      if (value > 51.5 && value < 254.5)
      {
        quality.Levels.insert(image.Get(x, y, 0));
      }
    }
  }
  return quality;
}

Pixels Mirror(const Pixels& image)
{
  Pixels result = image;
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      const unsigned char* from = image.At(image.Width - 1 - x, y);
      std::copy(from, from + 4, &result.Values[4 * (static_cast<size_t>(y) * image.Width + x)]);
    }
  }
  return result;
}

void CheckSame(const Pixels& a, const Pixels& b, const std::string& what)
{
  const Difference difference = Compare(a, b);
  CONTRACT_CHECK(difference.Max == 0.0, what << ": " << difference);
}
}

//------------------------------------------------------------------------------
// Straight edges of many slopes at several distances, against 8 x 8 pixels for each.
VTK_INDIRECT_TEST(AntialiasingSlopes)
{
  constexpr int factor = 8;
  struct Case
  {
    double Degrees;
    double Share; // largest share of the RMS error without antialiasing
    int Levels;   // least number of levels
  };
  // Runs are exact if they have equal lengths. Others have the error of the part of a pixel by
  // which the line misses the middles of its steps: a tenth of a pixel near the axes, and more the
  // shorter the runs are, up to a quarter at 45 degrees, where steps do not tell the line's place
  // between the corners: the least mean error of a fixed share is 2/3. Near 45 degrees diagonals
  // help. Measured: 0.14 to 0.26 up to 20 degrees, 0.13 and 0.14 at 39 and 52, 0.69 at 45.
  const Case cases[] = { { 2, 0.35, 12 }, { 5, 0.3, 12 }, { 10, 0.3, 9 }, { 20, 0.35, 6 },
    { 33, 0.4, 6 }, { 39, 0.25, 10 }, { 45, 0.75, 2 }, { 52, 0.25, 10 }, { 63, 0.55, 5 },
    { 75, 0.3, 6 }, { 88, 0.35, 12 } };
  for (const Case& line : cases)
  {
    double before = 0.0;
    double after = 0.0;
    std::set<int> levels;
    for (double distance : { 0.0137, -0.1291, 0.2043, 0.3311 })
    {
      Board expected(false, factor * Edge, factor * Edge);
      Board without(false);
      Board with(true);
      for (Board* board : { &expected, &without, &with })
      {
        board->AddHalfPlane(line.Degrees, distance);
      }
      const Floats average = Average(expected.Grab(), factor);
      before += Measure(without.Grab(), average).Square;
      const Quality quality = Measure(with.Grab(), average);
      after += quality.Square;
      levels.insert(quality.Levels.begin(), quality.Levels.end());
    }
    const double share = std::sqrt(after / before);
    std::cout << line.Degrees << " degrees: " << share << " of the RMS error, " << levels.size()
              << " levels\n";
    CONTRACT_CHECK(share <= line.Share, line.Degrees << " degrees: " << share);
    CONTRACT_CHECK(static_cast<int>(levels.size()) >= line.Levels,
      line.Degrees << " degrees: " << levels.size() << " levels");
  }
}

//------------------------------------------------------------------------------
// Lines of one pixel and a little more become more accurate, and no darker.
VTK_INDIRECT_TEST(AntialiasingThinLines)
{
  constexpr int factor = 8;
  for (double degrees : { 3.0, 11.0, 24.0, 38.0, 71.0 })
  {
    double before = 0.0;
    double after = 0.0;
    double light[3] = { 0.0, 0.0, 0.0 };
    for (double distance : { 0.0137, -0.1291, 0.2043, 0.3311 })
    {
      Board expected(false, factor * Edge, factor * Edge);
      Board without(false);
      Board with(true);
      for (Board* board : { &expected, &without, &with })
      {
        board->AddHalfPlane(degrees, distance, 1.3 * 2.0 / Edge);
      }
      const Floats average = Average(expected.Grab(), factor);
      const Pixels plain = without.Grab();
      const Pixels image = with.Grab();
      before += Measure(plain, average).Square;
      after += Measure(image, average).Square;
      light[0] += Mean(average, 0);
      light[1] += Mean(plain, 0);
      light[2] += Mean(image, 0);
    }
    const double share = std::sqrt(after / before);
    std::cout << degrees << " degrees: " << share << " of the RMS error; means " << light[0] << ", "
              << light[1] << " without, " << light[2] << "\n";
    CONTRACT_CHECK(share <= 0.95, degrees << " degrees: " << share);
    // One pixel's gain is its neighbour's loss, but for rounding and the ends of lines.
    CONTRACT_CHECK(std::abs(light[2] - light[1]) <= 0.02 * light[1], light[2]);
  }
}

//------------------------------------------------------------------------------
// Only pixels beside a contrast change; off and on have the same buffers and the same depth.
VTK_INDIRECT_TEST(AntialiasingLeavesAlone)
{
  View view(140, 120);
  AddRoom(view.Renderer);
  view.Renderer->SetBackground(0.2, 0.2, 0.5);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  const Pixels on = view.Grab();
  const char* const channels[] = { "final", "direct", "indirect", "irradiance", "albedo", "normal",
    "depth" };
  std::vector<Floats> buffers;
  for (const char* channel : channels)
  {
    buffers.push_back(Read(pass, channel));
  }
  const std::vector<float> depth = GrabDepth(view.Window);
  const double bytes = Report(pass).GetNumber("bytes");
  pass->AntialiasingOff();
  const Pixels off = view.Grab();
  for (size_t i = 0; i < buffers.size(); ++i)
  {
    const Difference difference = Compare(buffers[i], Read(pass, channels[i]));
    CONTRACT_CHECK(difference.Max == 0.0, channels[i] << ": " << difference);
  }
  CONTRACT_CHECK(depth == GrabDepth(view.Window), "depth");
  // A picture of 8 bits a channel, and the images for finding its edges.
  CONTRACT_CHECK(bytes - Report(pass).GetNumber("bytes") > 4 * 140 * 120, bytes);
  // Switched off, the picture is the composed buffer, rounded.
  const Floats final = Read(pass, "final");
  double worst = 0.0;
  size_t changed = 0;
  size_t far = 0;
  for (int y = 0; y < off.Height; ++y)
  {
    for (int x = 0; x < off.Width; ++x)
    {
      double contrast = 0.0;
      bool differs = false;
      for (int c = 0; c < 3; ++c)
      {
        const double value = 255.0 * std::min(std::max<double>(final.Get(x, y, c), 0.0), 1.0);
        const bool drawn = depth[static_cast<size_t>(y) * off.Width + x] < 1.0f;
        worst = drawn ? std::max(worst, std::abs(off.Get(x, y, c) - value)) : worst;
        differs = differs || on.Get(x, y, c) != off.Get(x, y, c);
        for (int k : { -1, 1 })
        {
          const int x1 = std::min(std::max(x + k, 0), off.Width - 1);
          const int y1 = std::min(std::max(y + k, 0), off.Height - 1);
          contrast =
            std::max<double>({ contrast, std::abs(double(off.Get(x, y, c)) - off.Get(x1, y, c)),
              std::abs(double(off.Get(x, y, c)) - off.Get(x, y1, c)) });
        }
      }
      changed += differs ? 1 : 0;
      far += differs && contrast < 0.05 * 255.0 ? 1 : 0;
    }
  }
  std::cout << changed << " pixels changed; off the picture is " << worst << " from the buffer\n";
  CONTRACT_CHECK(worst <= ByteRounding, "more than a rounding to 1/255: " << worst);
  CONTRACT_CHECK(changed > 100, "no edge was antialiased");
  CONTRACT_CHECK(far == 0, far << " pixels away from edges");
}

//------------------------------------------------------------------------------
// Without edges nothing changes: a picture of one colour, and squares along pixels.
VTK_INDIRECT_TEST(AntialiasingConstant)
{
  Board board;
  board.AddFlat(MakeQuad({ -4, -4, 0 }, { 4, -4, 0 }, { -4, 4, 0 }, { 0.3, 0.7, 0.5 }));
  const Pixels image = board.Grab();
  bool same = true;
  for (size_t i = 4; i < image.Values.size(); ++i)
  {
    same = same && image.Values[i] == image.Values[i - 4];
  }
  CONTRACT_CHECK(same, "a picture of one colour");
  // Corners of outlines along the pixels stay sharp.
  Pixels squares[2];
  for (bool on : { false, true })
  {
    Board other(on);
    const double pixel = 2.0 / Edge;
    for (int i = 0; i < 5; ++i)
    {
      const double lower = (-40 + 14 * i) * pixel;
      const double upper = lower + (1 + 2 * i) * pixel;
      other.AddFlat(
        MakeQuad({ lower, lower, 0 }, { upper, lower, 0 }, { lower, upper, 0 }, { 1, 1, 1 }));
      // A line of one pixel and one of two, which end in the picture.
      const double width = (1 + i % 2) * pixel;
      other.AddFlat(
        MakeQuad({ upper + 2 * pixel, lower, 0 }, { upper + 2 * pixel + width, lower, 0 },
          { upper + 2 * pixel, lower + 11 * pixel, 0 }, { 1, 1, 1 }));
    }
    squares[on] = other.Grab();
  }
  CheckSame(squares[0], squares[1], "squares along pixels");
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(AntialiasingMirrored)
{
  for (double degrees : { 4.0, 17.0, 31.0, 47.0, 68.0 })
  {
    for (double width : { 4.0, 1.3 * 2.0 / Edge })
    {
      Board left;
      Board right;
      left.AddHalfPlane(degrees, 0.0137, width);
      right.AddHalfPlane(-degrees, 0.0137, width);
      const Difference difference = Compare(Mirror(left.Grab()), right.Grab());
      // Sums in another order, rounded to 1/255.
      CONTRACT_CHECK(difference.Max <= 1.0, degrees << " degrees: " << difference);
    }
  }
}

//------------------------------------------------------------------------------
// Backgrounds and earlier layers stay unchanged; viewports are independent.
VTK_INDIRECT_TEST(AntialiasingPlaces)
{
  auto addLayer = [](View& view)
  {
    // A layer without a pass, with an aliased line.
    vtkNew<vtkRenderer> layer;
    view.Window->SetNumberOfLayers(2);
    view.Renderer->SetLayer(1);
    view.Window->AddRenderer(layer);
    layer->SetBackground(0.1, 0.3, 0.4);
    auto quad = MakeQuad({ -3, -3, 0 }, { 3, -1, 0 }, { -3, 3, 0 }, { 1, 0.6, 0.1 });
    quad->GetProperty()->LightingOff();
    layer->AddActor(quad);
    layer->GetActiveCamera()->DeepCopy(view.Renderer->GetActiveCamera());
  };
  Pixels images[2];
  for (bool on : { false, true })
  {
    Board board(on);
    addLayer(board);
    board.AddHalfPlane(10.0, -0.5);
    images[on] = board.Grab();
  }
  // The other layer alone is above the half plane.
  const int first = Edge / 2;
  CheckSame(Crop(images[0], 0, first, Edge, Edge - first),
    Crop(images[1], 0, first, Edge, Edge - first), "an earlier layer");
  CONTRACT_CHECK(Compare(images[0], images[1]).Pixels > 20, "no edge was antialiased");

  Board alone(true, 50, 70);
  alone.AddHalfPlane(10.0, 0.0137);
  const Pixels expected = alone.Grab();
  Board board(true, 107, 81);
  board.AddHalfPlane(10.0, 0.0137);
  // 50 x 70 pixels from 33, 7 on.
  board.Renderer->SetViewport(33.0 / 107, 7.0 / 81, 83.0 / 107, 77.0 / 81);
  vtkNew<vtkRenderer> around;
  around->SetBackground(0.9, 0.1, 0.1);
  around->SetViewport(0, 0, 33.0 / 107, 1);
  board.Window->AddRenderer(around);
  const Pixels image = board.Grab();
  CheckSame(expected, Crop(image, 33, 7, 50, 70), "a viewport");
  // 229.5 and 25.5 of 255
  CONTRACT_CHECK(
    std::abs(image.Get(32, 40, 0) - 229.5) < 1.0 && std::abs(image.Get(32, 40, 1) - 25.5) < 1.0,
    "its neighbour");
}

//------------------------------------------------------------------------------
// At most one filter: a user's setting beside the pass wins, and the report says so.
VTK_INDIRECT_TEST(AntialiasingOthers)
{
  auto draw = [](bool on, int other)
  {
    Board board(on);
    board.AddHalfPlane(10.0, 0.0137);
    vtkNew<vtkOpenGLFXAAPass> fxaa;
    vtkNew<vtkSSAAPass> ssaa;
    fxaa->SetDelegatePass(board.Pass);
    ssaa->SetDelegatePass(board.Pass);
    board.Renderer->SetUseFXAA(other == 1);
    if (other > 1)
    {
      board.Renderer->SetPass(other == 2 ? static_cast<vtkRenderPass*>(fxaa) : ssaa);
    }
    const Pixels image = board.Grab();
    const Report report(board.Pass);
    const std::string what = "antialiased edges";
    const bool modelled = !report.FindReason("modelled", what).empty();
    CONTRACT_CHECK(modelled == (on && other == 0), report.GetText());
    CONTRACT_CHECK(modelled == report.FindReason("left_out", what).empty(), report.GetText());
    board.Renderer->SetPass(nullptr);
    return image;
  };
  for (int other : { 1, 2, 3 })
  {
    CheckSame(draw(false, other), draw(true, other), other == 1 ? "FXAA" : "a pass around");
  }
  CONTRACT_CHECK(Compare(draw(false, 0), draw(true, 0)).Pixels > 20, "no edge was antialiased");
}

//------------------------------------------------------------------------------
// Windows of several samples, and the floats of a surrounding pass.
VTK_INDIRECT_TEST(AntialiasingSamples)
{
  Board plain;
  plain.AddHalfPlane(10.0, 0.0137);
  const Pixels expected = plain.Grab();
  Board board;
  board.Window->SetMultiSamples(4);
  board.AddHalfPlane(10.0, 0.0137);
  const Difference difference = Compare(expected, board.Grab());
  // Samples of a pixel are equal; their mean may be rounded.
  CONTRACT_CHECK(difference.Max <= 1.0, difference);

  // In floats a clamp with exposure 1 shows the same as a window of eight bits.
  Board floats;
  floats.AddHalfPlane(10.0, 0.0137);
  vtkNew<vtkToneMappingPass> outer;
  outer->SetToneMappingType(vtkToneMappingPass::Clamp);
  outer->SetDelegatePass(floats.Pass);
  floats.Renderer->SetPass(outer);
  const Pixels mapped = floats.Grab();
  const Difference other = Compare(expected, mapped);
  std::cout << "in floats: " << other << "\n";
  // Tone mapping decodes and encodes colours: a rounding each.
  CONTRACT_CHECK(other.Max <= 2.0, other);
  outer->ReleaseGraphicsResources(floats.Window);
  floats.Renderer->SetPass(nullptr);
}
