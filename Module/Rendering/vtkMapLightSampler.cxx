// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkMapLightSampler.h"

#include "Frame/vtkIndirectFrame.h"
#include "LightMaps/vtkIndirectLightMap.h"
#include "OpenGL/vtkIndirectFullScreenProgram.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectTarget.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "VirtualLights/vtkIndirectPatternTexture.h"
#include "vtkReflectiveShadowMapPass.h"

#include <cmath>

//------------------------------------------------------------------------------
struct vtkMapLightSampler::Internals
{
  vtkIndirectPatternTexture Pattern;
  vtkIndirectFullScreenProgram Program{ "vtkIndirectVirtualLightFS.glsl" };
  vtkIndirectFullScreenProgram LobeProgram{ "vtkIndirectVirtualLobeFS.glsl" };
  vtkMTimeType MapTime = 0; // of the maps that the lights were made from
};

vtkMapLightSampler::vtkMapLightSampler()
  : Internal(new Internals)
{
}

vtkMapLightSampler::~vtkMapLightSampler() = default;

//------------------------------------------------------------------------------
void vtkMapLightSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

//------------------------------------------------------------------------------
size_t vtkMapLightSampler::GetBytes() const
{
  return this->Superclass::GetBytes() + this->Internal->Pattern.GetBytes();
}

//------------------------------------------------------------------------------
bool vtkMapLightSampler::Update(const Input& input)
{
  Internals& in = *this->Internal;
  const vtkReflectiveShadowMapPass& maps = input.Maps;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  std::vector<Source> sources;
  for (int i = 0; i < maps.GetNumberOfMaps(); ++i)
  {
    const vtkIndirectLightMap& map = maps.GetMap(i);
    for (int face = 0; face < map.NumberOfFaces; ++face)
    {
      Source source;
      source.Layer = map.FirstLayer + face;
      source.Light = i;
      source.Size[0] = source.Size[1] = maps.GetTexels();
      source.Disk = map.Projection == vtkIndirectKernels::VTKI_MAP_SINGLE;
      if (map.Projection == vtkIndirectKernels::VTKI_MAP_FACES)
      {
        source.CosCone =
          map.Light.ConeAngle < 90.0 ? std::cos(glm::radians(map.Light.ConeAngle)) : -1.0;
      }
      sources.push_back(source);
    }
  }
  const bool changed = in.Pattern.Update(window, *this, sources);
  if (!changed && in.MapTime == maps.GetContentTime())
  {
    return true;
  }
  in.MapTime = 0;
  vtkOpenGLState* state = window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  if (!this->Resize(window, in.Pattern.GetNumberOfSamples()))
  {
    return false;
  }
  vtkIndirectTarget& table = this->BeginChange();
  if (sources.empty())
  {
    this->ReleaseLobes(window);
    in.MapTime = maps.GetContentTime();
    return true;
  }
  vtkShaderProgram* program = in.Program.Use(window, table);
  if (!program)
  {
    return false;
  }
  table.Begin();
  {
    vtkIndirectFullScreenState fullScreen(window);
    in.Pattern.Activate(program);
    maps.Activate(program);
    in.Program.Draw();
    maps.Deactivate();
    in.Pattern.Deactivate();
  }
  table.End();
  if (!this->DrawLobes(input))
  {
    return false;
  }
  in.MapTime = maps.GetContentTime();
  return true;
}

//------------------------------------------------------------------------------
// Where the maps have what senders reflect specularly.
bool vtkMapLightSampler::DrawLobes(const Input& input)
{
  Internals& in = *this->Internal;
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  if (!input.Maps.HasSpecular())
  {
    this->ReleaseLobes(window);
    return true;
  }
  vtkIndirectTarget* lobes = this->MakeLobes(window);
  vtkShaderProgram* program = lobes ? in.LobeProgram.Use(window, *lobes) : nullptr;
  if (!program)
  {
    return false;
  }
  lobes->Begin();
  {
    vtkIndirectFullScreenState fullScreen(window);
    in.Pattern.Activate(program);
    input.Maps.Activate(program);
    in.LobeProgram.Draw();
    input.Maps.Deactivate();
    in.Pattern.Deactivate();
  }
  lobes->End();
  return true;
}

//------------------------------------------------------------------------------
void vtkMapLightSampler::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!window)
  {
    return;
  }
  this->Superclass::ReleaseGraphicsResources(window);
  this->Internal->Pattern.Release(window);
  this->Internal->Program.Release();
  this->Internal->LobeProgram.Release();
  this->Internal->MapTime = 0;
}
