// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "BlockersShaders.h"

#include "BlockersMaps.h"
#include "OpenGL/vtkIndirectChannel.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Visibility/vtkIndirectDistanceField.h"
#include "Visibility/vtkIndirectSphereGrid.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <vector>

namespace
{
// A picture of 512 x 512 with a receiver at every fourth pixel either way, as the gather
// interpolates.
constexpr int Edge = 128;

const vtkIndirectChannel Channels[] = {
  { "sum", "vtkiSum", "sum over lights", GL_RGBA32F, "-", "-" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};

vtkSmartPointer<vtkTextureObject> MakeTexture(vtkOpenGLRenderWindow* window)
{
  auto texture = vtkSmartPointer<vtkTextureObject>::New();
  texture->SetContext(window);
  texture->SetMinificationFilter(vtkTextureObject::Nearest);
  texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  return texture;
}

vtkSmartPointer<vtkTextureObject> Upload(
  vtkOpenGLRenderWindow* window, std::vector<float> values, int width, int height, int components)
{
  auto texture = MakeTexture(window);
  texture->Create2DFromRaw(static_cast<unsigned int>(width), static_cast<unsigned int>(height),
    components, VTK_FLOAT, values.data());
  return texture;
}

void Append(std::vector<float>& values, const glm::dvec3& v, double w)
{
  for (const double number : { v.x, v.y, v.z, w })
  {
    values.push_back(static_cast<float>(number));
  }
}
}

//------------------------------------------------------------------------------
void MeasureShaders(const std::string& name, const BlockersScene& scene,
  const vtkIndirectDistanceField& voxels, const BlockersMaps& maps,
  const vtkIndirectSphereGrid& grid)
{
  vtkIndirectTest::Scene context(64, 64);
  context.Render();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(context.Window);
  window->MakeCurrent();

  std::vector<float> places;
  std::vector<float> normals;
  std::vector<BlockersPlace> seen;
  for (const BlockersPlace& place : scene.MakePicture(Edge))
  {
    Append(places, place.Position, 1.0);
    Append(normals, place.Normal, 0.0);
    if (place.Cosine > 0.0)
    {
      seen.push_back(place);
    }
  }
  std::vector<float> lights;
  for (const BlockersPlace& light : scene.Lights)
  {
    Append(lights, light.Position, scene.GetLightArea(light));
  }
  for (const BlockersPlace& light : scene.Lights)
  {
    Append(lights, light.Normal, 0.0);
  }
  double segments = 0.0;
  for (const BlockersPlace& receiver : seen)
  {
    for (const BlockersPlace& light : scene.Lights)
    {
      const glm::dvec3 way = light.Position - receiver.Position;
      segments += glm::dot(receiver.Normal, way) > 0.0 && glm::dot(light.Normal, way) < 0.0;
    }
  }
  const int count = static_cast<int>(scene.Lights.size());
  const auto placeTexture = Upload(window, places, Edge, Edge, 4);
  const auto normalTexture = Upload(window, normals, Edge, Edge, 4);
  const auto lightTexture = Upload(window, lights, count, 2, 4);
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  const auto mapTexture = Upload(window, maps.GetAtlas(columns), columns * BlockersMaps::Texels,
    columns * BlockersMaps::Rows, 1);

  vtkIndirectTarget target(Channels, false);
  target.Resize(window, Edge, Edge);
  const char* const ways[4][2] = { { "nothing", "" },
    { "voxels", "#define VTKI_VISIBILITY\n#define VTKI_VOXEL_SEGMENTS\n" },
    { "depth maps", "#define VTKI_VISIBILITY\n#define VTKI_DEPTH_TILES\n" },
    { "spheres", "#define VTKI_VISIBILITY\n#define VTKI_SPHERE_SEGMENTS\n" } };
  double milliseconds[4] = { 1e300, 1e300, 1e300, 1e300 };
  double sums[4] = {};
  vtkIndirectFullScreenProgram programs[4] = { { "BlockersFS.glsl" }, { "BlockersFS.glsl" },
    { "BlockersFS.glsl" }, { "BlockersFS.glsl" } };
  // In turn; the first round builds the programs.
  for (int round = 0; round < 8; ++round)
  {
    for (int way = 0; way < 4; ++way)
    {
      vtkShaderProgram* program = programs[way].Use(window, ways[way][1]);
      if (!program)
      {
        return;
      }
      vtkOpenGLState::ScopedglViewport viewport(window->GetState());
      vtkOpenGLState::ScopedglScissor scissor(window->GetState());
      vtkIndirectFullScreenState state(window);
      target.Begin();
      auto activate = [program](vtkTextureObject* texture, const char* uniform)
      {
        texture->Activate();
        program->SetUniformi(uniform, texture->GetTextureUnit());
      };
      activate(placeTexture, "vtkiPlaces");
      activate(normalTexture, "vtkiNormals");
      activate(lightTexture, "vtkiLights");
      program->SetUniformi("vtkiLightCount", count);
      if (way == 1)
      {
        voxels.Activate(window, program);
      }
      if (way == 2)
      {
        activate(mapTexture, "vtkiDepthTiles");
        const float shape[3] = { static_cast<float>(columns), static_cast<float>(columns),
          static_cast<float>(BlockersMaps::Texels) };
        program->SetUniform3f("vtkiTileShape", shape);
      }
      if (way == 3)
      {
        grid.Activate(window, program);
      }
      glFinish();
      const std::clock_t start = std::clock();
      programs[way].Draw();
      glFinish();
      const double spent = 1e3 * static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
      milliseconds[way] = round > 0 ? std::min(milliseconds[way], spent) : milliseconds[way];
      for (vtkTextureObject* texture :
        { placeTexture.Get(), normalTexture.Get(), lightTexture.Get(), mapTexture.Get() })
      {
        texture->Deactivate();
      }
      if (way == 1)
      {
        voxels.Deactivate();
      }
      if (way == 3)
      {
        grid.Deactivate();
      }
      target.End();
      const std::vector<float> image = target.ReadBack(0);
      sums[way] = 0.0;
      for (size_t i = 0; i < image.size(); i += 4)
      {
        sums[way] += image[i];
      }
    }
  }
  // What the processor finds at the same pixels, so that no shader is fast by being wrong.
  double expected = 0.0;
  for (const BlockersPlace& receiver : seen)
  {
    for (const BlockersPlace& light : scene.Lights)
    {
      const double weight = scene.GetWeight(receiver, light);
      expected += weight > 0.0 && grid.IsFree(receiver.Position, light.Position) ? weight : 0.0;
    }
  }
  for (int way = 0; way < 4; ++way)
  {
    std::printf("| %s | %s | %.0f | %.1f | %+.1f%% |\n", name.c_str(), ways[way][0],
      milliseconds[way], 1e6 * (milliseconds[way] - milliseconds[0]) / segments,
      100.0 * (sums[way] / expected - 1.0));
  }
  for (vtkIndirectFullScreenProgram& program : programs)
  {
    program.Release();
  }
  target.Release(window);
}
