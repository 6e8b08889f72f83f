// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Gather/vtkIndirectAreaLobes.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Frame/vtkIndirectFrame.h"
#include "Gather/vtkIndirectAreaMaps.h"
#include "LightMaps/vtkIndirectLobeTable.h"
#include "OpenGL/vtkIndirectUniforms.h"

#include <algorithm>
#include <string>

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
constexpr size_t MostPoints = vtkIndirectAreaLamps::MostPoints;
constexpr size_t RowsOfLobePoint = 5; // rows of a point in the block
constexpr size_t RowsOfSides = 10;
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
void vtkIndirectAreaLobes::SetPoints(
  const Input& input, const vtkIndirectProgram& program, size_t number)
{
  const Lamp& lamp = *input.Lamps.Get()[number];
  const vtkIndirectAreaMaps& maps = *input.Maps;
  const std::vector<vtkIndirectAreaLamps::Point>& points = maps.GetPoints(number);
  const size_t count = std::min(points.size(), input.Points);
  std::vector<glm::vec4> block(RowsOfLobePoint * MostPoints + RowsOfSides, glm::vec4(0.0f));
  for (size_t k = 0; k < count; ++k)
  {
    const vtkIndirectAreaLamps::Point& point = points[k];
    block[k] = glm::vec4(glm::dvec4(lamp.GetPlace(point.Place), 0.0));
    block[MostPoints + k] = glm::vec4(glm::dvec4(point.Weight, 0.0));
    block[2 * MostPoints + k] = glm::vec4(maps.GetMiddle(point, 0), maps.GetMiddle(point, 1));
    block[3 * MostPoints + k] = maps.GetWindow(point, 0);
    block[4 * MostPoints + k] = maps.GetWindow(point, 1);
  }
  glm::vec4* const sides = &block[RowsOfLobePoint * MostPoints];
  for (size_t side = 0; side < 2; ++side)
  {
    sides[side] = glm::vec4(maps.GetRange(number, side));
    for (size_t strip = 0; strip < 4; ++strip)
    {
      sides[2 + 4 * side + strip] = maps.GetStripWindow(number, side, strip);
    }
  }
  this->Block.Update(input.Frame.Window, block.data(), block.size() * sizeof(glm::vec4));
  this->Block.Activate(program);
  program->SetUniformi("vtkiAreaCount", static_cast<int>(count));
}

//------------------------------------------------------------------------------
bool vtkIndirectAreaLobes::AddLamp(const Input& input, size_t number)
{
  const Lamp& lamp = *input.Lamps.Get()[number];
  const vtkIndirectFrame& frame = input.Frame;
  const bool image = lamp.Row >= 0;
  vtkIndirectProgram program = this->Kernels[image].Use(frame.Window,
    "#define VTKI_AREA_POINTS " + std::to_string(MostPoints) + "\n" +
      (input.Maps ? "#define VTKI_VISIBILITY\n" : "") +
      (frame.PhysicallyBased ? "#define VTKI_LOBE_TABLE\n" : "") +
      (image ? "#define VTKI_AREA_IMAGE\n" : ""));
  if (!program)
  {
    return false;
  }
  vtkIndirectAreaLamps::SetUniforms(program, frame, lamp);
  const vtkIndirectTarget& geometry = input.Geometry.GetTarget();
  geometry.Activate(vtkIndirectGeometryBuffer::Surface, program);
  geometry.Activate(vtkIndirectGeometryBuffer::Specular, program);
  if (frame.PhysicallyBased)
  {
    this->Tables.Activate(0, program);
    this->Tables.Activate(1, program);
    vtkIndirectSetUniform(
      program, "vtkiLobeShape", glm::vec2(vtkIndirectLobeEntries, vtkIndirectLeastRoughness));
  }
  if (image)
  {
    const int place[2] = { lamp.Row, lamp.Pyramid.GetTop() };
    program->SetUniform2i("vtkiAreaImage", place);
    program->SetUniformf("vtkiAreaTolerance", static_cast<float>(input.Tolerance));
    input.Lamps.GetTexture().Activate(0, program);
  }
  else
  {
    vtkIndirectSetUniform(program, "vtkiAreaRadiance", glm::vec3(lamp.Radiance));
  }
  if (input.Maps)
  {
    this->SetPoints(input, program, number);
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
