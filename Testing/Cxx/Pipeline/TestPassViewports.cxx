// SPDX-License-Identifier: BSD-3-Clause
// The pass in several viewports, layers, tiles and sizes of a window.
#include "vtkIndirectContractUtilities.h"

#include "vtkImageData.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkRSMGatherPass.h"
#include "vtkRenderWindow.h"
#include "vtkUnsignedCharArray.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>

using namespace contract;

namespace
{
// Rasterization at another place in the window rounds differently: single pixels at silhouettes may
// show the other surface. Elsewhere the picture is the same to one step.
void CheckSamePicture(const Pixels& a, const Pixels& b, const std::string& what)
{
  const Difference difference = Compare(a, b);
  size_t off = 0;
  for (size_t i = 0; a.Values.size() == b.Values.size() && i < a.Values.size(); i += 4)
  {
    int largest = 0;
    for (size_t c = i; c < i + 4; ++c)
    {
      largest = std::max(largest, std::abs(int(a.Values[c]) - int(b.Values[c])));
    }
    off += largest > 1 ? 1 : 0;
  }
  std::cout << what << ": " << difference << ", " << off << " by more than one step\n";
  CONTRACT_CHECK(difference.Max < 256.0, what << ": sizes differ");
  CONTRACT_CHECK(off <= a.Values.size() / 4 / 500, what << ": " << difference << ", " << off);
}

void AddSubView(View& view, vtkRenderer* renderer, double x0, double y0, double x1, double y1)
{
  renderer->SetViewport(x0, y0, x1, y1);
  view.Window->AddRenderer(renderer);
}

Pixels GrabRoom(int width, int height, bool withPass = true)
{
  View view(width, height);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  if (withPass)
  {
    view.Renderer->SetPass(pass);
  }
  return view.Grab();
}
}

//------------------------------------------------------------------------------
// 2 x 2 viewports show the same as a window of that size.
VTK_INDIRECT_TEST(ViewportsFour)
{
  const Pixels single = GrabRoom(96, 80);
  CONTRACT_CHECK(Mean(single, 0) > 20.0, "nothing to see");
  View view(192, 160);
  view.Window->RemoveRenderer(view.Renderer);
  vtkNew<vtkRenderer> renderers[4];
  vtkNew<vtkIndirectIlluminationPass> passes[4];
  for (int i = 0; i < 4; ++i)
  {
    AddRoom(renderers[i]);
    renderers[i]->SetPass(passes[i]);
    AddSubView(
      view, renderers[i], 0.5 * (i & 1), 0.5 * (i >> 1), 0.5 + 0.5 * (i & 1), 0.5 + 0.5 * (i >> 1));
  }
  for (int frame = 0; frame < 2; ++frame)
  {
    const Pixels all = view.Grab();
    for (int i = 0; i < 4; ++i)
    {
      CheckSamePicture(Crop(all, 96 * (i & 1), 80 * (i >> 1), 96, 80), single,
        "viewport " + std::to_string(i) + ", frame " + std::to_string(frame));
    }
  }
}

//------------------------------------------------------------------------------
// One pass object in all viewports: slower, but the same picture.
VTK_INDIRECT_TEST(ViewportsOnePass)
{
  const Pixels single = GrabRoom(96, 80);
  View view(192, 80);
  view.Window->RemoveRenderer(view.Renderer);
  vtkNew<vtkRenderer> renderers[2];
  vtkNew<vtkIndirectIlluminationPass> pass;
  for (int i = 0; i < 2; ++i)
  {
    AddRoom(renderers[i]);
    renderers[i]->SetPass(pass);
    AddSubView(view, renderers[i], 0.5 * i, 0.0, 0.5 + 0.5 * i, 1.0);
  }
  for (int frame = 0; frame < 2; ++frame)
  {
    const Pixels all = view.Grab();
    CheckSamePicture(Crop(all, 0, 0, 96, 80), single, "left");
    CheckSamePicture(Crop(all, 96, 0, 96, 80), single, "right");
  }
}

//------------------------------------------------------------------------------
// Other renderers are independent of a neighbour's pass, bit for bit.
VTK_INDIRECT_TEST(ViewportsNeighbors)
{
  Pixels images[2];
  for (int withPass = 0; withPass < 2; ++withPass)
  {
    View view(200, 160);
    view.Window->RemoveRenderer(view.Renderer);
    vtkNew<vtkRenderer> renderers[4];
    vtkNew<vtkIndirectIlluminationPass> pass;
    for (int i = 0; i < 4; ++i)
    {
      AddRoom(renderers[i]);
      renderers[i]->SetBackground(0.2 * i, 0.3, 0.4);
      AddSubView(view, renderers[i], 0.5 * (i & 1), 0.5 * (i >> 1), 0.5 + 0.5 * (i & 1),
        0.5 + 0.5 * (i >> 1));
    }
    if (withPass)
    {
      renderers[1]->SetPass(pass);
    }
    view.Grab();
    images[withPass] = view.Grab();
  }
  for (int i : { 0, 2, 3 })
  {
    const Difference difference = Compare(Crop(images[0], 100 * (i & 1), 80 * (i >> 1), 100, 80),
      Crop(images[1], 100 * (i & 1), 80 * (i >> 1), 100, 80));
    CONTRACT_CHECK(difference.Max == 0.0, "viewport " << i << ": " << difference);
  }
  CONTRACT_CHECK(
    Compare(Crop(images[0], 100, 0, 100, 80), Crop(images[1], 100, 0, 100, 80)).Max > 3.0,
    "the pass did nothing");
}

//------------------------------------------------------------------------------
// A viewport that begins at odd pixels and leaves a margin all around.
VTK_INDIRECT_TEST(ViewportOrigin)
{
  const Pixels single = GrabRoom(96, 80);
  View view(137, 131);
  AddRoom(view.Renderer);
  view.Renderer->SetViewport(17.0 / 137, 29.0 / 131, 113.0 / 137, 109.0 / 131);
  // VTK clears nothing outside of viewports: the card's old memory shows.
  const Pixels before = view.Grab();
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  const Pixels image = view.Grab();
  int size[2];
  int origin[2];
  view.Renderer->GetTiledSizeAndOrigin(&size[0], &size[1], &origin[0], &origin[1]);
  CONTRACT_CHECK(size[0] == 96 && size[1] == 80, size[0] << " x " << size[1]);
  CheckSamePicture(Crop(image, origin[0], origin[1], 96, 80), single, "inside");
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      const bool inside =
        x >= origin[0] && x < origin[0] + size[0] && y >= origin[1] && y < origin[1] + size[1];
      CONTRACT_CHECK(
        inside || image.Get(x, y, 0) == before.Get(x, y, 0), "margin at " << x << ", " << y);
    }
  }
}

//------------------------------------------------------------------------------
// A second layer over the first, each with its own pass.
VTK_INDIRECT_TEST(LayersOver)
{
  auto addOver = [](vtkRenderer* renderer)
  {
    renderer->AddActor(MakeSphere({ 0.3, 0.7, 0.9 }, 0.15, { 0.9, 0.9, 0.2 }));
    renderer->AddActor(MakeQuad({ 0.1, 0.5, 0.7 }, { 0.5, 0.5, 0.7 }, { 0.1, 0.9, 0.7 }));
    renderer->AddLight(MakeLight(LightKind::Spot, { 0.6, 1.0, 2.0 }, { 0.3, 0.7, 0.8 }));
  };
  const Pixels under = GrabRoom(120, 100);
  Pixels alone;
  {
    View view(120, 100);
    AddRoomSurfaces(view.Renderer); // sets the camera
    view.Renderer->RemoveAllViewProps();
    addOver(view.Renderer);
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->AntialiasingOff(); // each pixel belongs to one layer
    view.Renderer->SetPass(pass);
    alone = view.Grab();
  }
  View view(120, 100);
  view.Window->SetNumberOfLayers(2);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> first;
  vtkNew<vtkIndirectIlluminationPass> second;
  second->AntialiasingOff();
  view.Renderer->SetPass(first);
  vtkNew<vtkRenderer> over;
  over->SetLayer(1);
  addOver(over);
  over->SetActiveCamera(view.Renderer->GetActiveCamera());
  over->SetPass(second);
  view.Window->AddRenderer(over);
  const Pixels image = view.Grab();
  size_t covered = 0;
  size_t wrong = 0;
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      const bool isOver = alone.Get(x, y, 3) > 0;
      covered += isOver ? 1 : 0;
      const Pixels& expected = isOver ? alone : under;
      for (int c = 0; c < 3; ++c)
      {
        wrong += std::abs(image.Get(x, y, c) - expected.Get(x, y, c)) > 1 ? 1 : 0;
      }
    }
  }
  CONTRACT_CHECK(covered > 500, "nothing in the second layer");
  CONTRACT_CHECK(wrong == 0, wrong << " values are of neither layer");
}

//------------------------------------------------------------------------------
// A renderer that preserves colour and depth draws into the existing scene: the same surfaces are
// visible as without a pass.
VTK_INDIRECT_TEST(LayersPreserve)
{
  // In each mode: the surface visible at a pixel, distinguished by colour.
  auto grab = [](bool withPass)
  {
    View view(120, 100);
    view.Renderer->AddActor(MakeSphere({ 0, 0, 0 }, 0.5, { 0.9, 0, 0 }));
    auto light = MakeLight(LightKind::Directional, { 0.3, 0.2, 1 }, { 0, 0, 0 });
    view.Renderer->AddLight(light);
    view.Renderer->SetBackground(0.0, 0.0, 0.4);
    vtkCamera* camera = view.Renderer->GetActiveCamera();
    camera->SetPosition(0, 0, 4);
    camera->SetClippingRange(1, 10);
    vtkNew<vtkRenderer> second;
    second->AddActor(MakeSphere({ 0.4, 0, 0 }, 0.5, { 0, 0.9, 0 }));
    second->AddLight(light);
    second->SetActiveCamera(camera);
    second->PreserveColorBufferOn();
    second->PreserveDepthBufferOn();
    view.Window->AddRenderer(second);
    vtkNew<vtkIndirectIlluminationPass> passes[2];
    if (withPass)
    {
      view.Renderer->SetPass(passes[0]);
      second->SetPass(passes[1]);
    }
    return view.Grab();
  };
  const Pixels plain = grab(false);
  const Pixels image = grab(true);
  auto classify = [](const Pixels& pixels, int x, int y)
  {
    const unsigned char* p = pixels.At(x, y);
    return p[2] > 50 ? 0 : (p[0] > p[1] ? 1 : 2);
  };
  size_t counts[3] = { 0, 0, 0 };
  size_t wrong = 0;
  for (int y = 0; y < plain.Height; ++y)
  {
    for (int x = 0; x < plain.Width; ++x)
    {
      const int kind = classify(plain, x, y);
      ++counts[kind];
      wrong += kind != classify(image, x, y) ? 1 : 0;
    }
  }
  CONTRACT_CHECK(counts[0] > 500 && counts[1] > 500 && counts[2] > 500, "nothing to see");
  // Terminators are black in one picture and faintly lit in the other.
  CONTRACT_CHECK(wrong <= 20, wrong << " pixels show another surface");
}

//------------------------------------------------------------------------------
// vtkWindowToImageFilter renders large images in tiles.
VTK_INDIRECT_TEST(Tiles)
{
  auto grab = [](int width, int height, int scale, bool withPass, bool antialiasing = false)
  {
    View view(width, height);
    AddRoom(view.Renderer);
    vtkNew<vtkIndirectIlluminationPass> pass;
    pass->SetAntialiasing(antialiasing);
    if (withPass)
    {
      view.Renderer->SetPass(pass);
    }
    view.Window->Render();
    vtkNew<vtkWindowToImageFilter> filter;
    filter->SetInput(view.Window);
    filter->SetInputBufferTypeToRGBA();
    filter->ReadFrontBufferOff();
    filter->SetScale(scale);
    filter->Update();
    vtkImageData* image = filter->GetOutput();
    Pixels result;
    result.Width = image->GetDimensions()[0];
    result.Height = image->GetDimensions()[1];
    result.Components = 4;
    const auto* values = static_cast<const unsigned char*>(image->GetScalarPointer());
    result.Values.assign(values, values + size_t(4) * result.Width * result.Height);
    return result;
  };
  const Pixels tiled = grab(128, 128, 2, true);
  const Pixels whole = grab(256, 256, 1, true);
  const Difference difference = Compare(tiled, whole);
  std::cout << "tiles against one window: " << difference << "\n";
  // VTK's own tiles move silhouettes by a pixel in places.
  const Difference plain = Compare(grab(128, 128, 2, false), grab(256, 256, 1, false));
  std::cout << "the same of plain VTK: " << plain << "\n";
  CONTRACT_CHECK(difference.Mean < plain.Mean + 0.3, difference);

  // No seam: across it, rows and columns differ by no more than in the whole picture.
  double seam[2] = { 0, 0 };
  double reference[2] = { 0, 0 };
  for (int i = 0; i < 256; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      seam[0] += std::abs(tiled.Get(127, i, c) - tiled.Get(128, i, c));
      seam[1] += std::abs(tiled.Get(i, 127, c) - tiled.Get(i, 128, c));
      reference[0] += std::abs(whole.Get(127, i, c) - whole.Get(128, i, c));
      reference[1] += std::abs(whole.Get(i, 127, c) - whole.Get(i, 128, c));
    }
  }
  for (int k = 0; k < 2; ++k)
  {
    seam[k] /= 3 * 256;
    reference[k] /= 3 * 256;
    std::cout << "mean step across the seam " << seam[k] << ", in one window " << reference[k]
              << "\n";
    // Interpolation ends at a tile's edge, which accounts for up to half a step of 255.
    CONTRACT_CHECK(seam[k] < reference[k] + 0.5, "a seam");
  }

  // Antialiasing is the same but for outlines that a seam cuts: a tile does not see their
  // continuation, and searches 31 pixels along them.
  const Pixels smoothTiled = grab(128, 128, 2, true, true);
  const Pixels smoothWhole = grab(256, 256, 1, true, true);
  size_t smooth = 0;
  size_t cut = 0;
  size_t wrong = 0;
  for (int y = 0; y < 256; ++y)
  {
    for (int x = 0; x < 256; ++x)
    {
      const bool near = std::min(std::abs(2 * x - 255), std::abs(2 * y - 255)) <= 2 * 32;
      const int added = smoothTiled.Get(x, y, 0) - tiled.Get(x, y, 0);
      const int expected = smoothWhole.Get(x, y, 0) - whole.Get(x, y, 0);
      smooth += std::abs(expected) > 8 ? 1 : 0;
      // Lights summed at other pixels change contrasts by a few of 255.
      const bool differs = std::abs(added - expected) > 8;
      cut += near && differs ? 1 : 0;
      wrong += !near && differs ? 1 : 0;
    }
  }
  std::cout << smooth << " antialiased pixels, " << cut << " of them cut by a seam, " << wrong
            << " wrong elsewhere\n";
  // 259 pixels of outlines; borders of shadows are data of a surface, and stay unchanged.
  CONTRACT_CHECK(smooth > 200, "no edge was antialiased");
  CONTRACT_CHECK(10 * cut < smooth, cut << " pixels are cut by a seam");
  // 11 of 707: spots of single virtual lights along creases, summed at other pixels.
  CONTRACT_CHECK(50 * wrong < smooth, wrong << " pixels away from seams");

  // Averaged down it is close to the picture without tiles.
  const Pixels small = grab(128, 128, 1, true);
  double mean = 0.0;
  for (int y = 0; y < 128; ++y)
  {
    for (int x = 0; x < 128; ++x)
    {
      for (int c = 0; c < 3; ++c)
      {
        const double average = 0.25 *
          (tiled.Get(2 * x, 2 * y, c) + tiled.Get(2 * x + 1, 2 * y, c) +
            tiled.Get(2 * x, 2 * y + 1, c) + tiled.Get(2 * x + 1, 2 * y + 1, c));
        mean += std::abs(average - small.Get(x, y, c)) / (3 * 128 * 128);
      }
    }
  }
  std::cout << "averaged down: mean difference " << mean << "\n";
  CONTRACT_CHECK(mean < 2.0, "averaged down: " << mean);
}

//------------------------------------------------------------------------------
// A window of any size shows the same as a new window of that size.
VTK_INDIRECT_TEST(Resize)
{
  View view(64, 64);
  AddRoom(view.Renderer);
  vtkNew<vtkIndirectIlluminationPass> pass;
  view.Renderer->SetPass(pass);
  const int sizes[][2] = { { 64, 64 }, { 160, 120 }, { 80, 60 }, { 1, 1 }, { 1, 2000 }, { 1999, 3 },
    { 3, 5 }, { 64, 64 }, { 63, 65 } };
  for (const auto& size : sizes)
  {
    view.Window->SetSize(size[0], size[1]);
    const Pixels resized = view.Grab();
    const Pixels fresh = GrabRoom(size[0], size[1]);
    const Difference difference = Compare(resized, fresh);
    CONTRACT_CHECK(difference.Max == 0.0, size[0] << " x " << size[1] << ": " << difference);
    for (const char* name : { "final", "irradiance", "depth", "normal" })
    {
      const Floats buffer = Read(pass, name);
      CONTRACT_CHECK(buffer.Width == size[0] && buffer.Height == size[1],
        name << " of " << size[0] << " x " << size[1]);
    }
  }
  view.Renderer->SetViewport(0.5, 0.5, 0.5, 0.5);
  view.Grab();
}

//------------------------------------------------------------------------------
// Both eyes of a stereo picture: each equals the picture of a camera at its place.
VTK_INDIRECT_TEST(StereoEyes)
{
  Pixels eyes[2];
  for (int eye : { 0, 1 })
  {
    for (bool stereo : { true, false })
    {
      View view(160, 120);
      AddRoom(view.Renderer);
      vtkCamera* camera = view.Renderer->GetActiveCamera();
      camera->SetEyeAngle(6.0);
      if (stereo)
      {
        view.Window->SetStereoType(eye == 0 ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
        view.Window->StereoCapableWindowOn();
        view.Window->StereoRenderOn();
      }
      else
      {
        // VTK shears the image: the eye is beside the camera, and points in the focal plane stay in
        // place.
        const double shift = camera->GetDistance() *
          std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetEyeAngle())) * (eye ? 1.0 : -1.0);
        const double halfWidth = camera->GetDistance() * 160.0 / 120.0 *
          std::tan(vtkMath::RadiansFromDegrees(0.5 * camera->GetViewAngle()));
        double place[3];
        camera->GetPosition(place);
        camera->SetPosition(place[0] + shift, place[1], place[2]);
        camera->GetFocalPoint(place);
        camera->SetFocalPoint(place[0] + shift, place[1], place[2]);
        camera->SetWindowCenter(-shift / halfWidth, 0.0);
      }
      const Pixels plain = view.Grab();
      vtkNew<vtkIndirectIlluminationPass> pass;
      pass->AntialiasingOff(); // the same pixels as without the pass
      vtkNew<vtkRSMGatherPass> gather;
      gather->InterpolationOff(); // it depends on pixels, which would make the pictures differ
      pass->SetEstimator(gather);
      view.Renderer->SetPass(pass);
      const Pixels image = view.Grab();
      CONTRACT_CHECK(Mean(image, 0) > Mean(plain, 0) + 5.0, "no indirect light");
      if (stereo)
      {
        eyes[eye] = image;
        // With shadows off, and without indirect light, it is VTK's own picture.
        pass->SetIndirectScale(0.0);
        view.Renderer->GetLights()->InitTraversal();
        view.Renderer->GetLights()->GetNextItem()->SetShadowAttenuation(0.0);
        CheckSamePicture(plain, view.Grab(), eye ? "right eye over VTK's" : "left eye over VTK's");
      }
      else
      {
        CheckSamePicture(eyes[eye], image, eye ? "right eye" : "left eye");
      }
    }
  }
  CONTRACT_CHECK(Compare(eyes[0], eyes[1]).Pixels > 2000, "both eyes see the same");
}
