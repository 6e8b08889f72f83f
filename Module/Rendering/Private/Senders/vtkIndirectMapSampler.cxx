// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Senders/vtkIndirectMapSampler.h"

#include "Maps/vtkIndirectLightMap.h"
#include "Maps/vtkIndirectLightMaps.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectPatternTexture.h"
#include "Senders/vtkIndirectSampleWarp.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <cmath>

namespace
{
using Source = vtkIndirectMapSampler::Source;
using Drawing = vtkIndirectMapSampler::Drawing;

// Makes the sources that samples take shares of: the faces of the maps, or the charts that samples
// are warped in, by their numbers. There is a chart for each light, or chart -1 for all of them.
std::vector<Source> MakeSources(
  const vtkIndirectLightMaps& maps, const Drawing& drawing, bool windows)
{
  std::vector<Source> sources;
  const int count = maps.GetNumberOfMaps();
  if (drawing.By == Drawing::FLUX)
  {
    Source all;
    all.Layer = -1;
    sources.assign(count > 0 ? 1 : 0, all);
    return sources;
  }
  for (int i = 0; i < count; ++i)
  {
    const vtkIndirectLightMap& map = maps.GetMap(i);
    Source source;
    source.Light = i;
    if (drawing.By == Drawing::LIT_TEXELS)
    {
      source.Layer = i;
      sources.push_back(source);
      continue;
    }
    source.Size[0] = source.Size[1] = maps.GetTexels();
    source.Disk = map.Projection == vtkIndirectKernels::VTKI_MAP_SINGLE;
    if (map.Projection == vtkIndirectKernels::VTKI_MAP_FACES)
    {
      source.CosCone =
        map.Light.ConeAngle < 90.0 ? std::cos(glm::radians(map.Light.ConeAngle)) : -1.0;
    }
    if (windows && map.HasSenderWindow())
    {
      source.MiddleOfWindow = 0.5 + 0.5 * map.Window.Middle / map.HalfWidth;
      source.HalfWindow = 0.5 * map.Window.HalfWidth / map.HalfWidth;
    }
    for (int face = 0; face < map.NumberOfFaces; ++face)
    {
      source.Layer = map.FirstLayer + face;
      sources.push_back(source);
    }
  }
  for (int i = 0; windows && i < count; ++i)
  {
    if (maps.GetMap(i).HasSenderWindow())
    {
      Source source;
      source.Light = i;
      source.Layer = maps.GetMap(i).Window.Layer;
      source.Size[0] = source.Size[1] = maps.GetTexels();
      sources.push_back(source);
    }
  }
  return sources;
}
}

//------------------------------------------------------------------------------
struct vtkIndirectMapSampler::Internals : vtkIndirectResource
{
  using vtkIndirectResource::vtkIndirectResource;
  void ReleaseOwn(vtkWindow*) override { this->MapTime = 0; }

  vtkIndirectPatternTexture Pattern{ this };
  vtkIndirectSampleWarp Warp{ this };
  vtkIndirectFullScreenProgram Program{ this, "vtkIndirectVirtualLightFS.glsl" };
  vtkIndirectFullScreenProgram LobeProgram{ this, "vtkIndirectVirtualLobeFS.glsl" };
  vtkMTimeType MapTime = 0; // time of the maps that the lights were made from
};

vtkIndirectMapSampler::vtkIndirectMapSampler(vtkVirtualLightSampler* owner)
  : vtkIndirectSampler(owner)
  , Internal(new Internals(this))
{
}

vtkIndirectMapSampler::~vtkIndirectMapSampler() = default;

//------------------------------------------------------------------------------
bool vtkIndirectMapSampler::Update(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkIndirectLightMaps& maps = input.Maps;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  const Drawing drawing = this->GetDrawing();
  const std::vector<Source> sources = MakeSources(maps, drawing, this->TakesWindows());
  const bool changed = in.Pattern.Update(window, *this, sources);
  if (!changed && in.MapTime == maps.GetContentTime())
  {
    return true;
  }
  in.MapTime = 0;
  vtkIndirectFullScreenState fullScreen(window);
  if (!this->Resize(window, in.Pattern.GetNumberOfSamples()))
  {
    return false;
  }
  vtkIndirectTarget& table = this->BeginChange();
  if (sources.empty())
  {
    this->RemoveLobes();
    in.MapTime = maps.GetContentTime();
    return true;
  }
  const bool warped = drawing.By != Drawing::NOTHING;
  if (!warped)
  {
    in.Warp.Release(window);
  }
  else if (!in.Warp.Update(window, maps, drawing, in.Pattern))
  {
    return false;
  }
  in.Program.SetDefinitions(drawing.Modulated ? "#define VTKI_AMBIENT_OCCLUSION\n" : "");
  const bool drawn = in.Program.Run(window, table,
    [&](const vtkIndirectProgram& program)
    {
      warped ? in.Warp.Activate(program) : in.Pattern.Activate(program);
      maps.Activate(program);
      program->SetUniformf("vtkiShareOfArea", static_cast<float>(drawing.ShareOfArea));
    });
  if (!drawn || !this->DrawLobes(input, warped))
  {
    return false;
  }
  in.MapTime = maps.GetContentTime();
  return true;
}

//------------------------------------------------------------------------------
// Draws the lobes where the maps hold specular reflections of senders.
bool vtkIndirectMapSampler::DrawLobes(const Input& input, bool warped)
{
  Internals& in = *this->Internal;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  if (!input.Maps.HasSpecular())
  {
    this->RemoveLobes();
    return true;
  }
  vtkIndirectTarget* lobes = this->MakeLobes(window);
  vtkIndirectFullScreenState fullScreen(window);
  return lobes &&
    in.LobeProgram.Run(window, *lobes,
      [&](const vtkIndirectProgram& program)
      {
        warped ? in.Warp.Activate(program) : in.Pattern.Activate(program);
        input.Maps.Activate(program);
      });
}
