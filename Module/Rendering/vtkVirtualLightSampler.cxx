// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectGL.h"

#include "vtkVirtualLightSampler.h"

#include "vtkGeometryBufferPass.h"
#include "vtkImageData.h"
#include "vtkIndirectFrame.h"
#include "vtkIndirectKernelProgram.h"
#include "vtkIndirectKernels.h"
#include "vtkIndirectLightMap.h"
#include "vtkIndirectTarget.h"
#include "vtkIndirectUniforms.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkReflectiveShadowMapPass.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <cmath>

namespace
{
const vtkIndirectChannel Channels[] = {
  { "lights.position", "vtkiLightPosition", "position, area", GL_RGBA32F, "scene",
    "scene units, scene units squared" },
  { "lights.normal", "vtkiLightNormal", "normal, lobe exponent", GL_RGBA32F, "scene", "1" },
  { "lights.density", "vtkiLightDensity", "reflected radiance times area, source", GL_RGBA32F, "-",
    "VTK radiance times scene units squared" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
}

//------------------------------------------------------------------------------
struct vtkVirtualLightSampler::Internals
{
  vtkIndirectTarget Target{ Channels, false };
  vtkIndirectKernelProgram FromMaps{ "vtkIndirectVirtualLightFS.glsl" };
  vtkIndirectKernelProgram FromEye{ "vtkIndirectCameraLightFS.glsl" };

  std::vector<Source> Sources;
  std::vector<Sample> Pattern;
  vtkSmartPointer<vtkTextureObject> PatternTexture;
  vtkMTimeType PatternTime = 0;
  int NumberOfLights = 0;
  int Rows = 0;

  // What the lights were made from.
  vtkMTimeType MapTime = 0;
};

vtkVirtualLightSampler::vtkVirtualLightSampler()
  : Internal(new Internals)
{
}

vtkVirtualLightSampler::~vtkVirtualLightSampler() = default;

//------------------------------------------------------------------------------
void vtkVirtualLightSampler::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ActualNumberOfLights: " << this->GetActualNumberOfLights() << "\n";
  this->Internal->Target.Print(os, indent);
}

//------------------------------------------------------------------------------
int vtkVirtualLightSampler::GetActualNumberOfLights() const
{
  return this->Internal->NumberOfLights;
}

//------------------------------------------------------------------------------
const vtkIndirectTarget& vtkVirtualLightSampler::GetTarget() const
{
  return this->Internal->Target;
}

//------------------------------------------------------------------------------
vtkIndirectTarget& vtkVirtualLightSampler::GetTarget()
{
  return this->Internal->Target;
}

//------------------------------------------------------------------------------
size_t vtkVirtualLightSampler::GetBytes() const
{
  return this->Internal->Target.GetBytes() +
    static_cast<size_t>(this->Internal->Rows) * RowLength * sizeof(Sample);
}

//------------------------------------------------------------------------------
void vtkVirtualLightSampler::CopyLights(const vtkIndirectFrame& frame, vtkImageData* image)
{
  const double scale = frame.SceneScale;
  const int count = this->GetActualNumberOfLights();
  image->SetDimensions(3, count, 1);
  image->AllocateScalars(VTK_FLOAT, 4);
  auto* out = static_cast<float*>(image->GetScalarPointer());
  vtkIndirectTarget& target = this->GetTarget();
  const std::vector<float> channels[3] = { target.ReadBack(PositionArea),
    target.ReadBack(NormalExponent), target.ReadBack(DensityArea) };
  for (int i = 0; i < count; ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      std::copy(&channels[c][4 * i], &channels[c][4 * i] + 4, out + 12 * i + 4 * c);
    }
    for (int k = 0; k < 3; ++k)
    {
      out[12 * i + k] = static_cast<float>(out[12 * i + k] / scale + frame.SceneCenter[k]);
      out[12 * i + 8 + k] = static_cast<float>(out[12 * i + 8 + k] / scale / scale);
    }
    out[12 * i + 3] = static_cast<float>(out[12 * i + 3] / scale / scale);
  }
}

//------------------------------------------------------------------------------
void vtkVirtualLightSampler::UpdatePattern(
  const vtkIndirectFrame& frame, const std::vector<Source>& sources)
{
  Internals& in = *this->Internal;
  if (in.PatternTexture && in.Sources == sources && in.PatternTime >= this->GetMTime())
  {
    return;
  }
  in.Sources = sources;
  in.Pattern.clear();
  this->MakePattern(sources, in.Pattern);
  in.PatternTime = this->GetMTime();
  in.MapTime = 0;
  in.NumberOfLights = static_cast<int>(in.Pattern.size());
  in.Rows = std::max(1, (in.NumberOfLights + RowLength - 1) / RowLength);
  in.Pattern.resize(static_cast<size_t>(in.Rows) * RowLength, Sample{ 0.0f, 0.0f, 0.0f, 0.0f });
  if (!in.PatternTexture)
  {
    in.PatternTexture = vtkSmartPointer<vtkTextureObject>::New();
  }
  in.PatternTexture->SetContext(frame.Window);
  in.PatternTexture->SetMinificationFilter(vtkTextureObject::Nearest);
  in.PatternTexture->SetMagnificationFilter(vtkTextureObject::Nearest);
  in.PatternTexture->Create2DFromRaw(RowLength, in.Rows, 4, VTK_FLOAT, in.Pattern.data());
  in.Pattern.clear();
  in.Pattern.shrink_to_fit();
}

//------------------------------------------------------------------------------
bool vtkVirtualLightSampler::Update(
  const vtkIndirectFrame& frame, vtkReflectiveShadowMapPass* maps, const vtkGeometryBufferPass* eye)
{
  Internals& in = *this->Internal;
  std::vector<Source> sources;
  if (eye)
  {
    Source source;
    source.Size[0] = frame.Size[0];
    source.Size[1] = frame.Size[1];
    sources.push_back(source);
  }
  for (int i = 0; !eye && i < maps->GetNumberOfMaps(); ++i)
  {
    const vtkIndirectLightMap& map = maps->GetMap(i);
    for (int face = 0; face < map.NumberOfFaces; ++face)
    {
      Source source;
      source.Layer = map.FirstLayer + face;
      source.Light = i;
      source.Size[0] = source.Size[1] = maps->GetResolution();
      source.Disk = map.Projection == vtkIndirectKernels::VTKI_MAP_SINGLE;
      if (map.Projection == vtkIndirectKernels::VTKI_MAP_FACES)
      {
        source.CosCone =
          map.Light.ConeAngle < 90.0 ? std::cos(glm::radians(map.Light.ConeAngle)) : -1.0;
      }
      sources.push_back(source);
    }
  }
  this->UpdatePattern(frame, sources);
  const vtkMTimeType mapTime = eye ? 0 : maps->GetContentTime();
  if (!eye && in.MapTime == mapTime && in.Target.GetWidth() > 0)
  {
    return true;
  }
  in.MapTime = mapTime;

  vtkOpenGLState* state = frame.Window->GetState();
  vtkOpenGLState::ScopedglViewport viewport(state);
  vtkOpenGLState::ScopedglScissor scissor(state);
  if (!in.Target.Resize(frame.Window, RowLength, in.Rows))
  {
    return false;
  }
  if (eye)
  {
    in.FromEye.SetDefinitions(eye->GetAlbedoDefinitions());
  }
  vtkShaderProgram* program = (eye ? in.FromEye : in.FromMaps).Use(frame.Window, in.Target);
  if (!program)
  {
    return false;
  }
  in.Target.Begin();
  vtkIndirectKernelState kernelState(frame.Window);
  in.PatternTexture->Activate();
  program->SetUniformi("vtkiPattern", in.PatternTexture->GetTextureUnit());
  if (eye)
  {
    const vtkIndirectLight& light = frame.Lights.front();
    eye->ActivateAlbedo(program);
    eye->GetTarget().Activate(vtkGeometryBufferPass::Surface, program);
    vtkIndirectSetEyeUniforms(program, frame);
    vtkIndirectSetUniform(program, "vtkiSize", glm::vec2(frame.Size[0], frame.Size[1]));
    vtkIndirectSetUniform(program, "vtkiLightColor", glm::vec3(light.Color));
    vtkIndirectSetUniform(program, "vtkiToLight",
      glm::vec3(-glm::normalize(glm::dmat3(frame.WorldToView) * light.DirectionWC)));
    program->SetUniformi("vtkiParallel", frame.Parallel ? 1 : 0);
    in.FromEye.Draw();
    eye->GetTarget().Deactivate();
  }
  else
  {
    maps->Activate(program);
    in.FromMaps.Draw();
    maps->Deactivate();
  }
  in.PatternTexture->Deactivate();
  in.Target.End();
  this->ContentTime.Modified();
  return true;
}

//------------------------------------------------------------------------------
void vtkVirtualLightSampler::ReleaseGraphicsResources(vtkWindow* window)
{
  if (!window)
  {
    return;
  }
  Internals& in = *this->Internal;
  in.Target.Release(window);
  in.FromMaps.Release();
  in.FromEye.Release();
  if (in.PatternTexture)
  {
    in.PatternTexture->ReleaseGraphicsResources(window);
    in.PatternTexture = nullptr;
  }
  in.MapTime = 0;
}
