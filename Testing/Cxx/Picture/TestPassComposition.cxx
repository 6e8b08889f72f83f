// SPDX-License-Identifier: BSD-3-Clause
// Drawing before and after the pass: backgrounds, translucent props, volumes, overlays,
// antialiasing.
#include "vtkIndirectContractUtilities.h"

#include "vtkActorCollection.h"
#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkSSAAPass.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkVolume.h"
#include "vtkVolumeCollection.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <functional>

using namespace contract;

namespace
{
enum class Mode
{
  Plain,    // no pass
  Delegate, // the pass without any effect
  Full
};

using SetUp = std::function<void(View&)>;

Pixels GrabScene(Mode mode, const SetUp& setUp, int width = 140, int height = 120)
{
  View view(width, height);
  AddRoom(view.Renderer);
  setUp(view);
  vtkNew<vtkIndirectIlluminationPass> pass;
  if (mode == Mode::Delegate)
  {
    pass->SetIndirectScale(0.0);
    pass->ShadowsOff();
  }
  if (mode != Mode::Plain)
  {
    view.Renderer->SetPass(pass);
  }
  view.Window->Render();
  return view.Grab();
}

// With IndirectScale 0 and Shadows off the picture is VTK's, bit for bit.
void CheckDelegate(const SetUp& setUp, const std::string& what)
{
  const Difference difference =
    Compare(GrabScene(Mode::Plain, setUp), GrabScene(Mode::Delegate, setUp));
  CONTRACT_CHECK(difference.Max == 0.0, what << ": " << difference);
}

vtkSmartPointer<vtkActor> MakeGlass(double z, const Vec3& color, double opacity, double x = 0.2)
{
  auto glass = MakeQuad({ x, 0.2, z }, { x + 0.5, 0.2, z }, { x, 0.8, z }, color);
  glass->GetProperty()->LightingOff();
  glass->GetProperty()->SetOpacity(opacity);
  return glass;
}

int LargestStep(const Pixels& image, int x, int y)
{
  int largest = 0;
  for (int c = 0; c < 3; ++c)
  {
    for (int k : { -1, 1 })
    {
      const int x1 = std::min(std::max(x + k, 0), image.Width - 1);
      const int y1 = std::min(std::max(y + k, 0), image.Height - 1);
      largest = std::max(largest, std::abs(image.Get(x, y, c) - image.Get(x1, y, c)));
      largest = std::max(largest, std::abs(image.Get(x, y, c) - image.Get(x, y1, c)));
    }
  }
  return largest;
}
}

//------------------------------------------------------------------------------
// One glass in front: alpha blended over the pass's own picture.
VTK_INDIRECT_TEST(TranslucentBlend)
{
  const Vec3 color = { 0.2, 0.5, 0.9 };
  const double alpha = 0.4;
  for (bool peeling : { false, true })
  {
    auto with = [&](View& view)
    {
      view.Renderer->AddActor(MakeGlass(0.9, color, alpha));
      view.Renderer->SetUseDepthPeeling(peeling);
    };
    CheckDelegate(with, peeling ? "with depth peeling" : "by default");
    const Pixels opaque = GrabScene(Mode::Full, [](View&) {});
    const Pixels image = GrabScene(Mode::Full, with);
    // Pixels of the glass, found with plain VTK.
    const Pixels plain = GrabScene(Mode::Plain, [](View&) {});
    const Pixels plainGlass = GrabScene(Mode::Plain, with);
    size_t inside = 0;
    double worstInside = 0.0;
    double worstOutside = 0.0;
    for (int y = 0; y < image.Height; ++y)
    {
      for (int x = 0; x < image.Width; ++x)
      {
        const bool isGlass =
          !std::equal(plainGlass.At(x, y), plainGlass.At(x, y) + 3, plain.At(x, y));
        inside += isGlass ? 1 : 0;
        for (int c = 0; c < 3; ++c)
        {
          const double expected = isGlass
            ? (1.0 - alpha) * opaque.Get(x, y, c) + alpha * 255.0 * color[c]
            : opaque.Get(x, y, c);
          double& worst = isGlass ? worstInside : worstOutside;
          worst = std::max(worst, std::abs(expected - image.Get(x, y, c)));
        }
      }
    }
    std::cout << (peeling ? "peeling" : "default") << ": " << inside << " pixels of glass, off by "
              << worstInside << ", elsewhere " << worstOutside << "\n";
    CONTRACT_CHECK(inside > 1000, "no glass");
    // Two roundings to 1/255, and half floats of the order-independent buffer.
    CONTRACT_CHECK(worstInside <= 2.0, "behind the glass: " << worstInside);
    CONTRACT_CHECK(worstOutside <= 1.0, "beside the glass: " << worstOutside);
  }
}

//------------------------------------------------------------------------------
// Two glasses that overlap, in the wrong order, and one behind an opaque surface.
VTK_INDIRECT_TEST(TranslucentPeeling)
{
  for (bool peeling : { false, true })
  {
    auto with = [&](View& view)
    {
      view.Renderer->AddActor(MakeGlass(1.1, { 0.9, 0.2, 0.1 }, 0.5, 0.1));
      view.Renderer->AddActor(MakeGlass(0.8, { 0.1, 0.3, 0.9 }, 0.5, 0.4));
      view.Renderer->AddActor(MakeGlass(-0.5, { 0.1, 0.9, 0.1 }, 0.5, 0.2));
      view.Renderer->SetUseDepthPeeling(peeling);
      view.Renderer->SetMaximumNumberOfPeels(8);
      view.Renderer->SetOcclusionRatio(0.0);
    };
    CheckDelegate(with, peeling ? "with depth peeling" : "by default");
    // Opaque light behind the glasses comes through by the same factor as in plain VTK.
    const Pixels plain = GrabScene(Mode::Plain, [](View&) {});
    const Pixels plainGlass = GrabScene(Mode::Plain, with);
    const Pixels opaque = GrabScene(Mode::Full, [](View&) {});
    const Pixels image = GrabScene(Mode::Full, with);
    double worst = 0.0;
    for (size_t i = 0; i < image.Values.size(); i += 4)
    {
      for (size_t c = i; c < i + 3; ++c)
      {
        // image - plainGlass = T (opaque - plain) with T of 1, 1/2 or 1/4.
        const double change = double(image.Values[c]) - plainGlass.Values[c];
        const double base = double(opaque.Values[c]) - plain.Values[c];
        const double off = std::min({ std::abs(change - base), std::abs(change - 0.5 * base),
          std::abs(change - 0.25 * base) });
        worst = std::max(worst, off);
      }
    }
    std::cout << (peeling ? "peeling" : "default") << ": off by " << worst << "\n";
    CONTRACT_CHECK(worst <= 2.0, worst);
  }
}

//------------------------------------------------------------------------------
namespace
{
void AddVolume(View& view, bool smart, int blend)
{
  vtkNew<vtkImageData> data;
  data->SetDimensions(16, 16, 16);
  data->SetSpacing(0.03, 0.03, 0.03);
  data->SetOrigin(0.1, 0.1, 0.6);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* values = static_cast<unsigned char*>(data->GetScalarPointer());
  for (int i = 0; i < 16 * 16 * 16; ++i)
  {
    values[i] = static_cast<unsigned char>(i % 16 > 4 ? 200 : 0);
  }
  vtkSmartPointer<vtkVolumeMapper> mapper;
  if (smart)
  {
    mapper = vtkSmartPointer<vtkSmartVolumeMapper>::New();
  }
  else
  {
    mapper = vtkSmartPointer<vtkGPUVolumeRayCastMapper>::New();
  }
  mapper->SetInputData(data);
  mapper->SetBlendMode(blend);
  vtkNew<vtkColorTransferFunction> color;
  color->AddRGBPoint(0, 0, 0, 0);
  color->AddRGBPoint(255, 0.2, 0.4, 1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0, 0);
  opacity->AddPoint(50, 0);
  opacity->AddPoint(255, 0.7);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(color);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetScalarOpacityUnitDistance(0.03);
  view.Renderer->AddVolume(volume);
  // The volume extends behind this wall.
  view.Renderer->AddActor(MakeQuad({ 0.1, 0.1, 0.8 }, { 0.35, 0.1, 0.8 }, { 0.1, 0.6, 0.8 }));
  view.Renderer->ResetCameraClippingRange();
}
}

VTK_INDIRECT_TEST(Volumes)
{
  // A warning about newer VTKs' own volume shader, which Mesa gives without a pass as well.
  AllowWarning("`g_dataPos' used uninitialized");
  // Hidden parts, however they are drawn.
  const Pixels opaque = GrabScene(Mode::Full,
    [](View& view)
    {
      AddVolume(view, true, vtkVolumeMapper::COMPOSITE_BLEND);
      view.Renderer->GetVolumes()->GetLastProp()->VisibilityOff();
    });
  for (int blend : { vtkVolumeMapper::COMPOSITE_BLEND, vtkVolumeMapper::MAXIMUM_INTENSITY_BLEND,
         vtkVolumeMapper::ADDITIVE_BLEND })
  {
    for (bool smart : { true, false })
    {
      auto with = [&](View& view) { AddVolume(view, smart, blend); };
      CheckDelegate(with, "volume");
      const Pixels image = GrabScene(Mode::Full, with);
      // Pixels of the volume, hidden parts included: drawn alone on grey.
      const Pixels alone = GrabScene(Mode::Plain,
        [&](View& view)
        {
          view.Renderer->RemoveAllViewProps();
          AddVolume(view, smart, blend);
          view.Renderer->GetActors()->GetLastProp()->VisibilityOff();
          view.Renderer->SetBackground(0.4, 0.4, 0.4);
        });
      size_t volume = 0;
      double worstOutside = 0.0;
      size_t untouched = 0;
      for (size_t i = 0; i < image.Values.size(); i += 4)
      {
        bool changes = false;
        bool moved = false;
        double outside = 0.0;
        for (size_t c = i; c < i + 3; ++c)
        {
          changes = changes || alone.Values[c] != 102;
          moved = moved || image.Values[c] != opaque.Values[c];
          outside = std::max(outside, std::abs(double(image.Values[c]) - opaque.Values[c]));
        }
        volume += changes ? 1 : 0;
        untouched += changes && !moved ? 1 : 0;
        worstOutside = changes ? worstOutside : std::max(worstOutside, outside);
      }
      std::cout << "blend mode " << blend << ": " << volume << " pixels of volume, of which "
                << untouched << " are hidden; elsewhere off by " << worstOutside << "\n";
      CONTRACT_CHECK(volume > 300, "no volume");
      CONTRACT_CHECK(untouched < volume / 3, "the volume is missing");
      CONTRACT_CHECK(worstOutside <= 1.0, "beside the volume: " << worstOutside);
    }
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Overlay)
{
  auto with = [](View& view)
  {
    vtkNew<vtkTextActor> text;
    text->SetInput("overlay");
    text->GetTextProperty()->SetFontSize(24);
    text->GetTextProperty()->SetColor(1, 1, 0);
    text->SetPosition(20, 40);
    view.Renderer->AddActor(text);
  };
  CheckDelegate(with, "text");
  const Pixels plain = GrabScene(Mode::Plain, with);
  const Pixels image = GrabScene(Mode::Full, with);
  size_t letters = 0;
  for (size_t i = 0; i < plain.Values.size(); i += 4)
  {
    if (plain.Values[i] == 255 && plain.Values[i + 1] == 255 && plain.Values[i + 2] == 0)
    {
      ++letters;
      CONTRACT_CHECK(
        image.Values[i] == 255 && image.Values[i + 1] == 255 && image.Values[i + 2] == 0,
        "a pixel of the text");
    }
  }
  CONTRACT_CHECK(letters > 50, "no text: " << letters);
}

//------------------------------------------------------------------------------
// The background of an empty scene is VTK's, bit for bit, alpha included.
VTK_INDIRECT_TEST(Backgrounds)
{
  const vtkSmartPointer<vtkTexture> texture = MakeColorfulTexture();
  const std::pair<const char*, SetUp> kinds[] = {
    { "colour", [](View& view) { view.Renderer->SetBackground(0.3, 0.5, 0.7); } },
    { "gradient",
      [](View& view)
      {
        view.Renderer->SetBackground(0.1, 0.2, 0.3);
        view.Renderer->SetBackground2(0.9, 0.8, 0.2);
        view.Renderer->GradientBackgroundOn();
      } },
    { "transparent",
      [](View& view)
      {
        view.Renderer->SetBackground(0.3, 0.5, 0.7);
        view.Renderer->SetBackgroundAlpha(0.0);
      } },
    { "half transparent",
      [](View& view)
      {
        view.Renderer->SetBackground(0.3, 0.5, 0.7);
        view.Renderer->SetBackgroundAlpha(0.5);
      } },
    { "picture",
      [&](View& view)
      {
        view.Renderer->SetBackgroundTexture(texture);
        view.Renderer->TexturedBackgroundOn();
      } },
  };
  for (const auto& kind : kinds)
  {
    CheckDelegate(kind.second, kind.first);
    View view(140, 120);
    AddRoom(view.Renderer);
    kind.second(view);
    const Pixels plain = view.Grab();
    const std::vector<float> depth = GrabDepth(view.Window);
    vtkNew<vtkIndirectIlluminationPass> pass;
    view.Renderer->SetPass(pass);
    const Pixels image = view.Grab();
    size_t background = 0;
    size_t wrong = 0;
    size_t transparent = 0;
    for (size_t i = 0; i < depth.size(); ++i)
    {
      if (depth[i] >= 1.0f)
      {
        ++background;
        wrong +=
          std::equal(&plain.Values[4 * i], &plain.Values[4 * i] + 4, &image.Values[4 * i]) ? 0 : 1;
      }
      else
      {
        transparent += image.Values[4 * i + 3] != plain.Values[4 * i + 3] ? 1 : 0;
      }
    }
    CONTRACT_CHECK(background > 1000, kind.first << ": no background");
    CONTRACT_CHECK(wrong == 0, kind.first << ": " << wrong << " of " << background);
    CONTRACT_CHECK(transparent == 0, kind.first << ": alpha of " << transparent << " surfaces");
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(AntialiasingFXAA)
{
  auto with = [](View& view)
  {
    view.Renderer->SetBackground(0.2, 0.2, 0.5);
    view.Renderer->UseFXAAOn();
  };
  auto without = [](View& view) { view.Renderer->SetBackground(0.2, 0.2, 0.5); };
  CheckDelegate(with, "FXAA");
  const Pixels plain = GrabScene(Mode::Full, without);
  const Pixels smooth = GrabScene(Mode::Full, with);
  size_t changed = 0;
  size_t far = 0;
  for (int y = 0; y < plain.Height; ++y)
  {
    for (int x = 0; x < plain.Width; ++x)
    {
      const bool differs = !std::equal(plain.At(x, y), plain.At(x, y) + 3, smooth.At(x, y));
      changed += differs ? 1 : 0;
      far += differs && LargestStep(plain, x, y) < 4 ? 1 : 0;
    }
  }
  std::cout << "FXAA changes " << changed << " pixels, " << far << " of them away from edges\n";
  CONTRACT_CHECK(changed > 100, "no edge was smoothed");
  CONTRACT_CHECK(far < changed / 10, "flat parts were changed: " << far << " of " << changed);
}

//------------------------------------------------------------------------------
namespace
{
// The pass, or one that leaves the picture to VTK, within another pass.
template <typename Outer>
Pixels GrabWithin(int width, int height, bool within, Mode mode = Mode::Full)
{
  View view(width, height);
  AddRoom(view.Renderer);
  view.Renderer->SetBackground(0.2, 0.2, 0.5);
  vtkNew<vtkIndirectIlluminationPass> inner;
  if (mode == Mode::Delegate)
  {
    inner->SetIndirectScale(0.0);
    inner->ShadowsOff();
  }
  vtkNew<Outer> outer;
  if (within)
  {
    outer->SetDelegatePass(inner);
    view.Renderer->SetPass(outer);
  }
  else
  {
    view.Renderer->SetPass(inner);
  }
  view.Window->Render();
  return view.Grab();
}

Pixels Halve(const Pixels& image)
{
  Pixels result;
  result.Width = image.Width / 2;
  result.Height = image.Height / 2;
  result.Components = 4;
  for (int y = 0; y < result.Height; ++y)
  {
    for (int x = 0; x < result.Width; ++x)
    {
      for (int c = 0; c < 4; ++c)
      {
        const int sum = image.Get(2 * x, 2 * y, c) + image.Get(2 * x + 1, 2 * y, c) +
          image.Get(2 * x, 2 * y + 1, c) + image.Get(2 * x + 1, 2 * y + 1, c);
        result.Values.push_back(static_cast<unsigned char>((sum + 2) / 4));
      }
    }
  }
  return result;
}
}

VTK_INDIRECT_TEST(AntialiasingFXAAPass)
{
  const Pixels plain = GrabWithin<vtkOpenGLFXAAPass>(140, 120, false);
  const Pixels image = GrabWithin<vtkOpenGLFXAAPass>(140, 120, true);
  const Pixels byRenderer = GrabScene(Mode::Full,
    [](View& view)
    {
      view.Renderer->SetBackground(0.2, 0.2, 0.5);
      view.Renderer->UseFXAAOn();
    });
  const Difference difference = Compare(plain, image);
  const Difference other = Compare(byRenderer, image);
  std::cout << "vtkOpenGLFXAAPass around the pass: to the pass alone " << difference
            << "; to the renderer's own FXAA " << other << "\n";
  CONTRACT_CHECK(difference.Pixels > 100, "no edge was smoothed");
  CONTRACT_CHECK(other.Max <= 1.0, other);
}

//------------------------------------------------------------------------------
// Around the pass it has the same effect as around VTK's own rendering.
VTK_INDIRECT_TEST(AntialiasingSSAAPass)
{
  Difference toAverage[2];
  for (Mode mode : { Mode::Delegate, Mode::Full })
  {
    const Pixels plain = GrabWithin<vtkSSAAPass>(140, 120, false, mode);
    const Pixels image = GrabWithin<vtkSSAAPass>(140, 120, true, mode);
    const Pixels averaged = Halve(GrabWithin<vtkSSAAPass>(280, 240, false, mode));
    const Difference toPlain = Compare(plain, image);
    Difference& average = toAverage[mode == Mode::Full];
    average = Compare(averaged, image);
    std::cout << "vtkSSAAPass around " << (mode == Mode::Full ? "the pass" : "VTK")
              << ": to one sample a pixel " << toPlain << ", to four averaged " << average << "\n";
    CONTRACT_CHECK(average.Mean < toPlain.Mean, "no nearer to the average");
  }
  CONTRACT_CHECK(toAverage[1].Mean < 1.25 * toAverage[0].Mean, toAverage[1]);
}
