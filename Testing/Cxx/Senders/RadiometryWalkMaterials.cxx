// SPDX-License-Identifier: BSD-3-Clause
// Rays and voxels read the same colours of an actor that VTK draws into lights' maps: of blocks, of
// textures, of physically based shading; users' shaders are reported.
#include "Scene/vtkIndirectSurfaces.h"
#include "Visibility/vtkIndirectOccupancyVolume.h"

#include "Scene/vtkIndirectFrame.h"
#include "vtkIndirectIlluminationPass.h"
#include "vtkIndirectWalkScene.h"

#include "vtkActor.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRadianceHintsPass.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVersionMacros.h"

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 90)
#include "vtkCompositePolyDataMapper.h"
using CompositeMapper = vtkCompositePolyDataMapper;
#else
#include "vtkCompositePolyDataMapper2.h"
using CompositeMapper = vtkCompositePolyDataMapper2;
#endif

#include <algorithm>
#include <string>

using namespace vtkIndirectTest;

namespace
{
vtkSmartPointer<vtkPolyData> MakeFloor(double x, double width)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(x, 0, 0);
  plane->SetPoint1(x, 0, 1);
  plane->SetPoint2(x + width, 0, 0);
  plane->SetResolution(5, 5);
  plane->Update();
  return plane->GetOutput();
}

// A texture of four colours in a square, or of one.
vtkSmartPointer<vtkTexture> MakeTexture(bool plain, bool encoded)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(2, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const unsigned char bytes[] = { 200, 40, 90, 60, 220, 30, 130, 130, 250, 250, 180, 20 };
  for (int i = 0; i < 12; ++i)
  {
    static_cast<unsigned char*>(image->GetScalarPointer())[i] = bytes[plain ? i % 3 : i];
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->SetUseSRGBColorSpace(encoded);
  return texture;
}

struct FloorScene : WalkScene
{
  vtkNew<vtkActor> Actor;

  FloorScene()
  {
    this->Renderer->AddActor(this->Actor);
    this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 0.5, 0.5, 0.5 });
    this->AddSpot({ 0.6, 1.5, 0.7 }, { 0.5, 0, 0.5 }, 50, 1, { 1, 0, 0 });
    this->SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0, 0.4 }, { 0, 1, 0 }, 36, 0.5, 6);
    this->Gather->SpecularTransportOff();
    this->Actor->GetProperty()->SetColor(0.9, 0.8, 0.7);
    this->Actor->GetProperty()->SetDiffuse(0.9);
  }
  void SetFloor()
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(MakeFloor(0, 1));
    this->Actor->SetMapper(mapper);
  }
};
}

// One block has its own colour, before VTK 9.4 in place of scalars, one has scalars, one is hidden;
// blocks inherit a colour; and without scalars.
VTK_INDIRECT_TEST(WalkBlocks)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 3; ++i)
  {
    vtkSmartPointer<vtkPolyData> floor = MakeFloor(i / 3.0, 1.0 / 3.0);
    vtkNew<vtkUnsignedCharArray> colors;
    colors->SetNumberOfComponents(3);
    for (vtkIdType k = 0; k < floor->GetNumberOfPoints(); ++k)
    {
      colors->InsertNextTuple3(60, 200, static_cast<double>(4 * k));
    }
    floor->GetPointData()->SetScalars(colors);
    blocks->SetBlock(i, floor);
  }
  vtkNew<vtkMultiBlockDataSet> all;
  all->SetBlock(0, blocks);
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  vtkNew<CompositeMapper> mapper;
  mapper->SetInputDataObject(all);
  mapper->SetCompositeDataDisplayAttributes(attributes);
  FloorScene scene;
  scene.Actor->SetMapper(mapper);
  const double red[3] = { 0.9, 0.1, 0.05 };
  attributes->SetBlockColor(blocks->GetBlock(0), red);
  attributes->SetBlockVisibility(blocks->GetBlock(2), false);
  mapper->Modified();
  scene.CompareWithMaps("blocks", 1);
  attributes->SetBlockColor(blocks, red);
  mapper->Modified();
  scene.CompareWithMaps("a block of blocks", 1);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  attributes->SetBlockScalarVisibility(blocks->GetBlock(1), false);
  mapper->Modified();
  scene.CompareWithMaps("a block without its scalars", 1);
#endif
  mapper->ScalarVisibilityOff();
  scene.CompareWithMaps("no scalars", 1);
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 3, 0)
  attributes->SetBlockColorMode(blocks->GetBlock(0), VTK_COLOR_MODE_DIRECT_SCALARS);
  mapper->Modified();
  scene.UseWalk(1024, 2);
  const std::string report = scene.Pass->GetReport();
  Check("the report names a block's own way", report.find("of its own") != std::string::npos);
#endif
}

VTK_INDIRECT_TEST(WalkTextures)
{
  for (int kind = 0; kind < 5; ++kind)
  {
    FloorScene scene;
    scene.SetFloor();
    vtkProperty* property = scene.Actor->GetProperty();
    const char* const names[] = { "encoded texture", "two textures", "base colour of PBR",
      "metal of PBR", "actor's texture under PBR" };
    if (kind >= 2)
    {
      property->SetInterpolationToPBR();
      property->SetMetallic(kind == 3 ? 0.8 : 0.25);
    }
    switch (kind)
    {
      case 0:
        scene.Actor->SetTexture(MakeTexture(false, true));
        break;
      case 1:
      {
        scene.Actor->SetTexture(MakeTexture(false, false));
        vtkSmartPointer<vtkTexture> second = MakeTexture(true, false);
        second->SetBlendingMode(vtkTexture::VTK_TEXTURE_BLENDING_MODE_MODULATE);
        property->SetTexture("second", second);
        break;
      }
      case 3:
        property->SetTexture("materialTex", MakeTexture(false, false));
        break;
      case 4:
        scene.Actor->SetTexture(MakeTexture(false, false));
        break;
      default:
        property->SetTexture("albedoTex", MakeTexture(false, true));
    }
    scene.CompareWithMaps(names[kind], 1, 0.025);
  }
}

// The mean albedo of voxels takes the mean of a texture over each triangle.
VTK_INDIRECT_TEST(OccupancyTextures)
{
  vtkNew<vtkActor> actor;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeFloor(0, 1));
  actor->SetMapper(mapper);
  actor->SetTexture(MakeTexture(false, false));
  vtkIndirectFrame frame;
  vtkIndirectCaster caster;
  caster.Prop = actor;
  frame.Casters.push_back(caster);
  const double bounds[6] = { 0, 1, -0.5, 0.5, 0, 1 };
  std::copy(bounds, bounds + 6, frame.SceneBounds);
  vtkIndirectOccupancyVolume volume;
  volume.KeepSurfaces();
  volume.Update(frame, vtkIndirectSurfaces(), 16);
  const glm::dvec3 mean =
    glm::dvec3(200 + 60 + 130 + 250, 40 + 220 + 130 + 180, 90 + 30 + 250 + 20) / (4.0 * 255.0);
  for (int c = 0; c < 3; ++c)
  {
    CheckRelative("mean albedo", volume.GetMeanAlbedo()[c], mean[c], 0.05,
      "a triangle of a fifth of an edge has one sample, of four pixels in all");
  }
}

// A shader's effect is unknown: the report names it, and the property's colour is sent.
VTK_INDIRECT_TEST(WalkShaderCode)
{
  FloorScene scene;
  scene.SetFloor();
  scene.Actor->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Color::Impl", true,
    "//VTK::Color::Impl\n  diffuseColor = vec3(1.0, 0.0, 0.0);\n", false);
  scene.UseWalk(1024, 2);
  const std::string report = scene.Pass->GetReport();
  Check("the report names it", report.find("shader code of the user's own") != std::string::npos);
  vtkNew<vtkRadianceHintsPass> hints;
  scene.Pass->SetSampler(nullptr);
  scene.Pass->SetEstimator(hints);
  scene.Pass->SetNumberOfBounces(8);
  scene.Render();
  Check("so does that of hints",
    scene.Pass->GetReport().find("shader code of the user's own") != std::string::npos);
  scene.Pass->SetEstimator(nullptr);
}

// Hints send the colours of blocks and of textures of PBR in all bounces: a floor beside a ball
// gets what it gets beside a ball of that colour.
VTK_INDIRECT_TEST(HintsTakeColoursOfBlocksAndTextures)
{
  const auto draw = [](int kind)
  {
    Scene scene(40, 30);
    scene.AddQuad({ -1, 0, 1 }, { 1, 0, 1 }, { -1, 0, -1 }, { 0.8, 0.8, 0.8 });
    scene.AddQuad({ -1, 0, -1 }, { 1, 0, -1 }, { -1, 1, -1 }, { 0.8, 0.8, 0.8 });
    scene.AddSpot({ 0.9, 1.5, 0.9 }, { 0, 0.3, 0 }, 40, 1, { 1, 0, 0 });
    scene.SetEye({ 1.2, 1.6, 2.3 }, { 0, 0.2, 0 }, { 0, 1, 0 }, 36, 0.5, 6);
    // A byte of 243 stands for 0.896, one of 63 for 0.050.
    const double red[3] = { 0.896, 0.05, 0.05 };
    vtkActor* ball = scene.AddSphere({ 0, 0.4, 0 }, 0.35, 32, { 0.5, 0.5, 0.5 });
    vtkProperty* property = ball->GetProperty();
    if (kind == 0 || kind == 2)
    {
      property->SetColor(red[0], red[1], red[2]);
    }
    if (kind >= 2)
    {
      property->SetInterpolationToPBR();
      property->SetMetallic(0.0);
    }
    vtkNew<vtkCompositeDataDisplayAttributes> attributes;
    vtkNew<vtkMultiBlockDataSet> blocks;
    if (kind == 1)
    {
      ball->GetMapper()->Update();
      blocks->SetBlock(0, ball->GetMapper()->GetInputDataObject(0, 0));
      attributes->SetBlockColor(blocks->GetBlock(0), red);
      vtkNew<CompositeMapper> mapper;
      mapper->SetInputDataObject(blocks);
      mapper->SetCompositeDataDisplayAttributes(attributes);
      ball->SetMapper(mapper);
    }
    if (kind == 3)
    {
      ball->GetMapper()->Update();
      vtkNew<vtkPolyData> mesh;
      mesh->ShallowCopy(ball->GetMapper()->GetInputDataObject(0, 0));
      vtkNew<vtkFloatArray> coordinates;
      coordinates->SetNumberOfComponents(2);
      coordinates->SetNumberOfTuples(mesh->GetNumberOfPoints());
      coordinates->Fill(0.5);
      mesh->GetPointData()->SetTCoords(coordinates);
      vtkPolyDataMapper::SafeDownCast(ball->GetMapper())->SetInputData(mesh);
      vtkNew<vtkImageData> image;
      image->SetDimensions(1, 1, 1);
      image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
      const unsigned char encoded[3] = { 243, 63, 63 };
      std::copy(encoded, encoded + 3, static_cast<unsigned char*>(image->GetScalarPointer()));
      vtkNew<vtkTexture> texture;
      texture->SetInputData(image);
      texture->UseSRGBColorSpaceOn();
      property->SetColor(1, 1, 1);
      property->SetBaseColorTexture(texture);
    }
    vtkNew<vtkRadianceHintsPass> hints;
    scene.Pass->SetEstimator(hints);
    scene.Pass->SetNumberOfBounces(8);
    scene.Render();
    const Image bounce = scene.Copy("bounce");
    scene.Pass->SetEstimator(nullptr);
    return glm::dvec3(bounce.Mean(0), bounce.Mean(1), bounce.Mean(2));
  };
  const char* const names[] = { "a colour", "a block's colour", "a colour of PBR",
    "a texture of PBR" };
  for (const int kind : { 1, 3 })
  {
    const glm::dvec3 expected = draw(kind - 1);
    const glm::dvec3 found = draw(kind);
    for (int c = 0; c < 3; ++c)
    {
      CheckRelative(names[kind], found[c], expected[c], 0.05, "a grid's injection of few senders");
    }
    CheckAtLeast(std::string(names[kind]) + " is seen: red over green", found.x / found.y, 1.05,
      "the test's own power");
  }
}
