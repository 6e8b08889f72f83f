// SPDX-License-Identifier: BSD-3-Clause
// Props that are not plain surfaces: their picture, and their lack of other effects.
#include "vtkIndirectContractReport.h"
#include "vtkIndirectContractRoom.h"
#include "vtkIndirectDetails.h"

#include "vtkAxesActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"
#include "vtkOutlineSource.h"
#include "vtkPointData.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkRadianceHintsPass.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkSkybox.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkTextProperty.h"
#include "vtkTexture.h"
#include "vtkUniformLightSampler.h"
#include "vtkVolume.h"

#include <algorithm>

using namespace contract;

namespace
{
// A sky whose colour changes with the height.
vtkSmartPointer<vtkTexture> MakeSky()
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(64, 32, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (int y = 0; y < 32; ++y)
  {
    for (int x = 0; x < 64; ++x)
    {
      auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, y, 0));
      pixel[0] = 90;
      pixel[1] = 110;
      pixel[2] = static_cast<unsigned char>(7 * y);
    }
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  return texture;
}
}

//------------------------------------------------------------------------------
// The sky writes only its colour: VTK's own picture, the same in every frame, without a surface.
VTK_INDIRECT_TEST(PropsSky)
{
  Room room;
  vtkNew<vtkSkybox> sky;
  sky->SetProjectionToSphere();
  sky->SetTexture(MakeSky());
  room.GetRenderer()->AddActor(sky);
  // Physically based, because VTK's environment light needs it, as scenes with skies usually are.
  vtkActor* sphere = room.GetRenderer()->GetActors()->GetItemAsObject(5)
    ? vtkActor::SafeDownCast(room.GetRenderer()->GetActors()->GetItemAsObject(5))
    : nullptr;
  CONTRACT_CHECK(sphere, "no sphere");
  sphere->GetProperty()->SetInterpolationToPBR();
  room.GetRenderer()->UseImageBasedLightingOn();
  room.GetRenderer()->SetEnvironmentTexture(sky->GetTexture());
  room.GetRenderer()->GetActiveCamera()->SetPosition(1.6, 0.9, 3.4);
  const Pixels plain = room.Grab(false);
  const Pixels first = room.Grab(true);
  const Floats depth = Read(room.Pass, "depth");
  const Floats normal = Read(room.Pass, "normal");
  const Floats albedo = Read(room.Pass, "albedo");
  CONTRACT_CHECK(Compare(first, room.Grab(true)).Max == 0.0, "the second frame differs");
  room.Pass->CachingOff();
  CONTRACT_CHECK(Compare(first, room.Grab(true)).Max == 0.0, "the third frame differs");
  size_t seen = 0;
  double worst = 0.0;
  double surface = 0.0;
  for (size_t i = 0; i < depth.Values.size(); ++i)
  {
    if (depth.Values[i] == 0.0f)
    {
      ++seen;
      worst = std::max(worst, Distance(plain, first, i));
      for (size_t c = 3 * i; c < 3 * i + 3; ++c)
      {
        surface = std::max(surface, std::abs(double(normal.Values[c])) + albedo.Values[c]);
      }
    }
  }
  std::cout << seen << " pixels of sky, off by " << worst << "\n";
  CONTRACT_CHECK(seen > 3000, "no sky");
  CONTRACT_CHECK(worst <= 1.0, "the sky is not VTK's: " << worst);
  CONTRACT_CHECK(surface == 0.0, "the sky has a surface: " << surface);
  CheckReported(room.Pass, "vtkOpenGLSkybox");
  CheckReported(room.Pass, "environment light");
}

//------------------------------------------------------------------------------
// Lit annotation in front of surfaces: VTK's own picture there, and elsewhere unchanged light.
VTK_INDIRECT_TEST(PropsColorOnly)
{
  Room room;
  const Pixels plainWithout = room.Grab(false);
  const Pixels without = room.Grab(true);
  vtkNew<vtkAxesActor> axes;
  axes->SetTotalLength(0.7, 0.7, 0.7);
  axes->SetShaftTypeToCylinder();
  axes->SetCylinderRadius(0.1);
  axes->AxisLabelsOff();
  room.GetRenderer()->AddActor(axes);
  const Pixels plain = room.Grab(false);
  const Pixels image = room.Grab(true);
  const Floats irradiance = Read(room.Pass, "irradiance");
  size_t seen = 0;
  double worst = 0.0;
  double elsewhere = 0.0;
  double light = 0.0;
  for (size_t i = 0; i < plain.Values.size() / 4; ++i)
  {
    if (!Differs(plain, plainWithout, i))
    {
      elsewhere = std::max(elsewhere, Distance(image, without, i));
      continue;
    }
    ++seen;
    worst = std::max(worst, Distance(plain, image, i));
    light += irradiance.Values[3 * i];
  }
  std::cout << seen << " pixels of axes, off by " << worst << ", others by " << elsewhere << "\n";
  CONTRACT_CHECK(seen > 300, "no axes");
  // One step of a byte: VTK's own picture is blended in bytes, to which floats are rounded.
  CONTRACT_CHECK(worst <= 1.0, "axes are not VTK's: " << worst);
  CONTRACT_CHECK(light == 0.0, "axes receive light: " << light);
  // A few pixels of the axes have the surface's colour and are not counted as visible.
  size_t changed = 0;
  for (size_t i = 0; i < plain.Values.size() / 4; ++i)
  {
    changed += !Differs(plain, plainWithout, i) && Distance(image, without, i) > 1.0 ? 1 : 0;
  }
  CONTRACT_CHECK(changed <= seen / 20, changed << " pixels beside the axes changed");
}

//------------------------------------------------------------------------------
// A label that turns to the camera does not turn to a light, whether or not a frame draws maps.
VTK_INDIRECT_TEST(PropsBillboard)
{
  Room room;
  vtkNew<vtkBillboardTextActor3D> label;
  label->SetInput("label");
  label->SetPosition(0.2, 0.5, 0.5);
  label->GetTextProperty()->SetFontSize(24);
  label->GetTextProperty()->SetColor(1, 1, 0);
  room.GetRenderer()->AddActor(label);
  room.GetRenderer()->SetPass(room.Pass);
  const Pixels drawn = room.Window.Grab();
  const vtkIdType faces = CountOf(room.Pass, "faces_drawn");
  const Pixels cached = room.Window.Grab();
  CONTRACT_CHECK(faces > 0 && faces == CountOf(room.Pass, "faces_drawn"),
    "maps were to be drawn once, in the first frame");
  CONTRACT_CHECK(Compare(drawn, cached).Max == 0.0, Compare(drawn, cached));
  size_t yellow = 0;
  for (size_t i = 0; i < drawn.Values.size(); i += 4)
  {
    yellow += drawn.Values[i] > 100 && drawn.Values[i + 1] > 100 && drawn.Values[i + 2] < 30;
  }
  CONTRACT_CHECK(yellow > 50, "no label: " << yellow);
}

//------------------------------------------------------------------------------
// Splats: emissive ones add their light to the picture and change nothing else; others hide the
// surfaces behind them, and are in no map.
VTK_INDIRECT_TEST(PropsSplats)
{
  auto makeSplats = []
  {
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(0.3, 0.5, 0.6);
    points->InsertNextPoint(0.7, 0.6, 0.6);
    points->InsertNextPoint(1.2, 0.9, 0.6);
    vtkNew<vtkCellArray> vertices;
    vertices->InsertNextCell({ 0, 1, 2 });
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetVerts(vertices);
    vtkNew<vtkPointGaussianMapper> mapper;
    mapper->SetInputData(data);
    mapper->SetScaleFactor(0.06);
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.2, 0.3, 0.4);
    return actor;
  };
  Room room;
  room.Pass->SetVisibilityToNone();       // rounding decides visibility at a shadow's edge
  room.Pass->SetNumberOfBounces(1);       // rounding turns a path that meets an edge
  vtkNew<vtkUniformLightSampler> sampler; // a tree measures normals in the scene's diagonals
  room.Pass->SetSampler(sampler);
  room.GetRenderer()->SetBackground(0.1, 0.2, 0.3);
  const Pixels plainWithout = room.Grab(false);
  const Pixels without = room.Grab(true);
  const Floats irradiance = Read(room.Pass, "irradiance");
  const Floats depth = Read(room.Pass, "rsm0.depth");
  auto splats = makeSplats();
  auto* mapper = vtkPointGaussianMapper::SafeDownCast(splats->GetMapper());
  mapper->EmissiveOn();
  room.GetRenderer()->AddActor(splats);
  const Pixels plain = room.Grab(false);
  const Pixels image = room.Grab(true);
  // The splats enlarge the scene's bounds, to which positions are relative: rounding.
  const Difference same = Compare(irradiance, Read(room.Pass, "irradiance"));
  CONTRACT_CHECK(same.Max < 1e-4, "the light on surfaces: " << same);
  CONTRACT_CHECK(
    Compare(depth, Read(room.Pass, "rsm0.depth")).Max < 1e-5, "emissive splats are in the map");
  size_t seen = 0;
  double worst = 0.0;
  for (size_t i = 0; i < image.Values.size(); ++i)
  {
    if (i % 4 == 3)
    {
      continue; // alpha, which would darken the background
    }
    const int added = int(plain.Values[i]) - plainWithout.Values[i];
    seen += added > 5 ? 1 : 0;
    if (image.Values[i] < 255 && plain.Values[i] < 255)
    {
      worst = std::max(worst, std::abs(double(image.Values[i]) - without.Values[i] - added));
    }
  }
  std::cout << "emissive: " << seen << " values, off by " << worst << "\n";
  CONTRACT_CHECK(seen > 1000, "no splats");
  // Two roundings to bytes: of VTK's sum, splat by splat, and of this pass's.
  CONTRACT_CHECK(worst <= 2.0, "emissive splats add something else than VTK's: " << worst);

  mapper->EmissiveOff();
  room.Grab(true);
  CONTRACT_CHECK(Compare(depth, Read(room.Pass, "rsm0.depth")).Max < 1e-5, "splats are in the map");
  CheckReported(room.Pass, "splats have no surface");
  // Zero where splats are more than half opaque, otherwise unchanged.
  const Floats hidden = Read(room.Pass, "irradiance");
  size_t dark = 0;
  double changed = 0.0;
  for (size_t i = 0; i < hidden.Values.size(); i += 3)
  {
    const bool isDark = hidden.Values[i] == 0.0f && irradiance.Values[i] > 0.0f;
    dark += isDark ? 1 : 0;
    changed = isDark
      ? changed
      : std::max(changed, std::abs(double(hidden.Values[i]) - double(irradiance.Values[i])));
  }
  std::cout << "opaque: hide " << dark << " pixels, others change by " << changed << "\n";
  CONTRACT_CHECK(dark > 100 && dark < 2000, dark << " pixels hidden");
  CONTRACT_CHECK(changed < 1e-4, "beside splats: " << changed);
}

//------------------------------------------------------------------------------
// The report names props that take no part, and their number.
VTK_INDIRECT_TEST(PropsLeftOut)
{
  Room room;
  for (int i = 0; i < 3; ++i)
  {
    auto glass = MakeSphere({ 0.3 + 0.2 * i, 0.7, 0.5 }, 0.08);
    glass->GetProperty()->SetOpacity(0.5);
    room.GetRenderer()->AddActor(glass);
  }
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  image->SetSpacing(0.1, 0.1, 0.1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  image->GetPointData()->GetScalars()->Fill(100);
  vtkNew<vtkSmartVolumeMapper> mapper;
  mapper->SetInputData(image);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  room.GetRenderer()->AddVolume(volume);
  room.Grab(true);
  CheckReported(room.Pass, "volumes neither send nor receive");
  const std::string why =
    contract::Report(room.Pass).FindReason("left_out", "vtkOpenGLActor, 3 props");
  CONTRACT_CHECK(why.find("translucent geometry") == 0, why);
}

//------------------------------------------------------------------------------
// The report distinguishes props of one class: by a name, else by mapper and source.
VTK_INDIRECT_TEST(PropsNames)
{
  Room room;
  auto entry = [&]
  {
    const contract::Report report(room.Pass);
    for (int i = 0; report.Has("left_out." + std::to_string(i)); ++i)
    {
      const std::string what = report.Get("left_out." + std::to_string(i) + ".what");
      if (what.find("vtkOpenGLActor") == 0)
      {
        return what;
      }
    }
    return std::string();
  };
  const char* const names[] = { nullptr, "head.vtp", "tail.vtp", "fin.vtp" };
  const std::string from = "vtkOpenGLPolyDataMapper of vtkSphereSource";
  const std::string expected[] = { "vtkOpenGLActor (" + from + ")",
    "vtkOpenGLActor, 2 props (" + from + "; 'head.vtp', " + from + ")",
    "vtkOpenGLActor, 3 props (" + from + "; 'head.vtp', " + from + "; 'tail.vtp', " + from + ")",
    "vtkOpenGLActor, 4 props (" + from + "; 'head.vtp', " + from + "; 'tail.vtp', " + from +
      "; and others)" };
  for (int i = 0; i < 4; ++i)
  {
    auto glass = MakeSphere({ 0.3 + 0.1 * i, 0.7, 0.5 }, 0.05);
    glass->GetProperty()->SetOpacity(0.5);
    if (names[i])
    {
      vtkNew<vtkInformation> keys;
      keys->Set(vtkIndirectIlluminationPass::NAME(), names[i]);
      glass->SetPropertyKeys(keys);
    }
    room.GetRenderer()->AddActor(glass);
    room.Grab(true);
    CONTRACT_CHECK(entry() == expected[i], entry());
  }
}

//------------------------------------------------------------------------------
// Unlit lines receive no light and cost radiance hints nothing. Tubes are lit, and have no polygons
// to bound them.
VTK_INDIRECT_TEST(PropsHints)
{
  vtkIdType active[3];
  for (int kind : { 0, 1, 2 })
  {
    Room room;
    vtkNew<vtkRadianceHintsPass> hints;
    SET_DETAIL(hints, NumberOfRays, 16); // hints are counted, not used
    room.Pass->SetEstimator(hints);
    vtkNew<vtkOutlineSource> source;
    source->SetBounds(0.2, 0.8, 0.05, 0.45, 0.2, 0.6);
    auto outline = MakeActor(source, { 1, 1, 0 });
    outline->GetProperty()->SetLineWidth(4);
    outline->GetProperty()->SetRenderLinesAsTubes(kind == 2);
    outline->SetVisibility(kind > 0);
    room.GetRenderer()->AddActor(outline);
    room.Grab(true);
    active[kind] = hints->GetNumberOfActiveHints();
  }
  std::cout << "active hints: " << active[0] << ", with an outline " << active[1] << ", with tubes "
            << active[2] << "\n";
  CONTRACT_CHECK(active[0] > 0, "no hints");
  CONTRACT_CHECK(active[1] == active[0], "an outline has hints");
  CONTRACT_CHECK(active[2] > active[0], "tubes have no hints");
}
