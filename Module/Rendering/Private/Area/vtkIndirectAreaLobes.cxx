// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Area/vtkIndirectAreaLobes.h"

#include "Area/vtkIndirectAreaMaps.h"
#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Maps/vtkIndirectLobeTable.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"

#include <algorithm>

namespace
{
const vtkIndirectChannels ReflectedChannels = {
  { "area.glossy", "vtkiAreaGlossy", "what receivers reflect specularly of area lights", GL_RGBA32F,
    "-", "VTK radiance" },
};
const vtkIndirectChannels TableChannels = {
  { "lobe.transforms", "vtkiLobeTransforms", "entries of inverse transforms", GL_RGBA32F, "-",
    "1" },
  { "lobe.integrals", "vtkiLobeIntegrals", "of the lobe, and with Schlick's weight", GL_RGBA32F,
    "-", "1" },
};
}

//------------------------------------------------------------------------------
vtkIndirectAreaLobes::vtkIndirectAreaLobes(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Kernels{ { this, "vtkIndirectAreaLobeFS.glsl" }, { this, "vtkIndirectAreaLobeFS.glsl" } }
  , Tables(this, TableChannels, false)
  , Reflected(this, ReflectedChannels, false)
{
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaLobes::UpdateTables(const Input& input)
{
  constexpr int entries = vtkIndirectLobeEntries;
  if (!input.Frame.PhysicallyBased || this->Tables.GetFramebuffer())
  {
    return true;
  }
  if (!this->Tables.Resize(input.Frame.Window, entries, entries))
  {
    return false;
  }
  std::vector<float> values[2];
  for (const auto& row : vtkIndirectLobeTable)
  {
    for (const auto& entry : row)
    {
      values[0].insert(values[0].end(), entry, entry + 4);
      values[1].insert(values[1].end(), { entry[4], entry[5], 0.0f, 0.0f });
    }
  }
  for (int i = 0; i < 2; ++i)
  {
    this->Tables.Write(i, values[i]);
    this->Tables.GetTexture(i)->SetMinificationFilter(vtkTextureObject::Linear);
    this->Tables.GetTexture(i)->SetMagnificationFilter(vtkTextureObject::Linear);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaLobes::AddLamp(const Input& input, size_t number)
{
  const vtkIndirectFrame& frame = input.Frame;
  const bool image = input.Lamps.Get()[number]->Row >= 0;
  vtkIndirectProgram program = this->Kernels[image].Use(frame.Window,
    this->Block.GetDefinitions() + (input.Maps ? "#define VTKI_VISIBILITY\n" : "") +
      (frame.PhysicallyBased ? "#define VTKI_LOBE_TABLE\n" : "") +
      (image ? "#define VTKI_AREA_IMAGE\n" : ""));
  if (!program)
  {
    return false;
  }
  this->Block.Update(frame.Window, input.Lamps, number, 1, input.Maps);
  this->Block.Activate(program);
  input.Geometry.ActivateReceivers(program, frame);
  input.Geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Specular, program);
  if (frame.PhysicallyBased)
  {
    this->Tables.Activate(0, program);
    this->Tables.Activate(1, program);
    vtkIndirectSetUniform(
      program, "vtkiLobeShape", glm::vec2(vtkIndirectLobeEntries, vtkIndirectLeastRoughness));
  }
  if (image)
  {
    program->SetUniformf("vtkiAreaTolerance", static_cast<float>(input.Tolerance));
    input.Lamps.GetTexture().Activate(0, program);
  }
  if (input.Maps)
  {
    const size_t points = std::min(input.Maps->GetPoints(number).size(), input.Points);
    program->SetUniformi("vtkiAreaPoints", static_cast<int>(points));
    input.Maps->GetAtlas().Activate(program);
  }
  this->Kernels[image].Draw();
  return true;
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaLobes::Sum(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  if (!this->UpdateTables(input) ||
    !this->Reflected.Resize(frame.Window, frame.Size[0], frame.Size[1]))
  {
    return false;
  }
  this->Reflected.Begin();
  this->Reflected.Clear();
  const vtkIndirectAddition addition(frame.Window);
  const vtkIndirectAreaLamps::List& lamps = input.Lamps.Get();
  bool done = true;
  for (size_t i = 0; done && i < lamps.size(); ++i)
  {
    done = this->AddLamp(input, i);
  }
  this->Reflected.End();
  return done;
}
