// SPDX-License-Identifier: BSD-3-Clause
// The tables of a hint grid as textures, each made when a program first needs it.
#include "RadianceHints/vtkIndirectHintGrid.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>
#include <string>

namespace
{
// Texels in a row of the table of rays: OpenGL's least limit on textures. Rows are longer if there
// would be too many.
constexpr int LeastRayRowLength = 1024;
}

//------------------------------------------------------------------------------
void vtkIndirectHintGrid::Bind(Table table, vtkOpenGLRenderWindow* window,
  const vtkIndirectProgram& program, const char* uniform)
{
  if (this->Textures[table].IsEmpty())
  {
    this->Make(table, window);
  }
  this->Textures[table].Activate(program, uniform);
}

//------------------------------------------------------------------------------
void vtkIndirectHintGrid::Make(Table table, vtkOpenGLRenderWindow* window)
{
  std::vector<glm::vec4> texels;
  int width = RowLength;
  switch (table)
  {
    case MaskTable:
      this->Textures[table].Set(
        window, vtkIndirectDataTexture::BYTES, 2, this->MaskSize, this->Masks.data());
      return;
    case HintTable:
      texels = this->Hints;
      break;
    case RayTable:
      this->RayRowLength = LeastRayRowLength;
      while (this->Hits.size() / 4 >
        static_cast<size_t>(this->RayRowLength) * vtkTextureObject::GetMaximumTextureSize(window))
      {
        this->RayRowLength *= 2;
      }
      width = this->RayRowLength;
      texels.resize(this->Hits.size() / 4);
      std::copy(this->Hits.begin(), this->Hits.end(), texels.empty() ? nullptr : &texels[0].x);
      break;
    case AlbedoTable:
      texels = this->Albedo;
      break;
    case DirectionTable:
      texels = this->Directions;
      break;
    default:
      for (const Surfel& surfel : this->Surfels)
      {
        texels.emplace_back(table == SurfelPosition
            ? surfel.Position
            : (table == SurfelNormal ? surfel.Normal : surfel.Albedo),
          surfel.Depth);
      }
  }
  const int rows = std::max(1, (static_cast<int>(texels.size()) + width - 1) / width);
  texels.resize(static_cast<size_t>(rows) * width, glm::vec4(0.0f));
  this->Textures[table].Set(
    window, vtkIndirectDataTexture::FLOATS, 4, { width, rows, 0 }, texels.data());
}

//------------------------------------------------------------------------------
void vtkIndirectHintGrid::Activate(vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program)
{
  this->Bind(HintTable, window, program, "vtkiHints");
  for (int grid = 0; grid < this->GetNumberOfGrids(); ++grid)
  {
    float rows[3][4] = {};
    const Region& region = this->Current.Regions[grid];
    const glm::dvec3 cell = this->GetCell(grid);
    for (int axis = 0; axis < 3; ++axis)
    {
      rows[0][axis] = static_cast<float>(region.Lower[axis]);
      rows[1][axis] = static_cast<float>(cell[axis]);
      rows[2][axis] = static_cast<float>(region.Size[axis]);
    }
    rows[0][3] = static_cast<float>(this->First[grid]);
    rows[1][3] = static_cast<float>(glm::length(cell));
    const std::string n = std::to_string(grid);
    program->SetUniform4f(("vtkiGridLower" + n).c_str(), rows[0]);
    program->SetUniform4f(("vtkiGridCell" + n).c_str(), rows[1]);
    program->SetUniform4f(("vtkiGridSize" + n).c_str(), rows[2]);
  }
  program->SetUniformi("vtkiHintCount", this->GetNumberOfHints());
}

//------------------------------------------------------------------------------
void vtkIndirectHintGrid::ActivateMasks(
  vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program)
{
  this->Bind(MaskTable, window, program, "vtkiMasks");
}

//------------------------------------------------------------------------------
void vtkIndirectHintGrid::ActivateRays(
  vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program)
{
  this->Bind(RayTable, window, program, "vtkiRays");
  this->Bind(DirectionTable, window, program, "vtkiDirections");
  program->SetUniformi("vtkiRayEdge", this->RayEdge);
  program->SetUniformi("vtkiRayRowLength", this->RayRowLength);
}

//------------------------------------------------------------------------------
void vtkIndirectHintGrid::ActivateAlbedo(
  vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program)
{
  this->Bind(AlbedoTable, window, program, "vtkiHintAlbedo");
}

//------------------------------------------------------------------------------
void vtkIndirectHintGrid::ActivateSurfels(
  vtkOpenGLRenderWindow* window, const vtkIndirectProgram& program)
{
  const char* const names[] = { "vtkiSurfelPosition", "vtkiSurfelNormal", "vtkiSurfelAlbedo" };
  for (int i = 0; i < 3; ++i)
  {
    this->Bind(static_cast<Table>(SurfelPosition + i), window, program, names[i]);
  }
  program->SetUniformi("vtkiSurfelCount", static_cast<int>(this->Surfels.size()));
}
