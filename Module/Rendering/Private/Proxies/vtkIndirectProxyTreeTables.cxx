// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Proxies/vtkIndirectProxyTreeTables.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "Proxies/vtkIndirectProxyChannels.h"
#include "Proxies/vtkIndirectProxyTable.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

using namespace vtkIndirectProxyChannels;

namespace
{
constexpr int TexelsPerRow = vtkIndirectKernels::VTKI_ROW_LENGTH;

// Returns the rows of a table. Powers of two: small changes of the number of entries keep the
// textures.
int FindRows(size_t entries)
{
  int rows = 1;
  while (static_cast<size_t>(rows) * TexelsPerRow < entries)
  {
    rows *= 2;
  }
  return rows;
}

// Long enough for a look-up of the nearest entry: a texel takes longer than the arithmetic on it.
constexpr int TableLength = vtkIndirectKernels::VTKI_PROXY_TABLE;
std::vector<float> MakeTable()
{
  std::vector<float> values;
  for (int i = 0; i < TableLength; ++i)
  {
    const float place =
      static_cast<float>(i * (vtkIndirectProxyEntries - 1)) / static_cast<float>(TableLength - 1);
    const int row = std::min(static_cast<int>(place), vtkIndirectProxyEntries - 2);
    for (int k = 0; k < 4; ++k)
    {
      const float low = vtkIndirectProxyTable[row][k];
      values.push_back(
        low + (place - static_cast<float>(row)) * (vtkIndirectProxyTable[row + 1][k] - low));
    }
  }
  return values;
}

// Fills whole rows of a table.
void WriteRows(vtkIndirectTarget& target, int channel, std::vector<float>& values)
{
  const size_t row = static_cast<size_t>(TexelsPerRow) * 4;
  values.resize((values.size() + row - 1) / row * row, 0.0f);
  if (!values.empty())
  {
    target.Write(channel, values);
  }
}

void Append(std::vector<float>& values, const glm::vec3& xyz, float w)
{
  values.insert(values.end(), { xyz.x, xyz.y, xyz.z, w });
}
}

//------------------------------------------------------------------------------
vtkIndirectProxyTreeTables::vtkIndirectProxyTreeTables(vtkIndirectResource* owner)
  : vtkIndirectResource(owner)
  , Table(this, TableChannels, false)
  , Rows(this, RowsChannels, false)
  , Blocks(this, BlocksChannels, false)
  , Senders(this, SendersChannels, false)
  , Ranges(this, RangesChannels, false)
{
}

//------------------------------------------------------------------------------
bool vtkIndirectProxyTreeTables::Update(vtkOpenGLRenderWindow* window,
  const vtkIndirectProxyTree& tree, const std::vector<vtkIndirectProxyPolygon>& polygons)
{
  this->Polygons = vtkIndirectProxyLight::ChoosePolygons(polygons);
  const bool begins = this->Table.GetWidth() == 0;
  const std::vector<vtkIndirectProxyTree::Entry>& entries = tree.GetEntries();
  const std::vector<vtkIndirectProxyTree::Block>& blocks = tree.GetBlocks();
  this->NumberOfEntries = static_cast<int>(entries.size());
  this->NumberOfBlocks = static_cast<int>(blocks.size());
  this->HasAnyGroups = tree.HasGroups();
  const int rows = FindRows(entries.size());
  if (!this->Table.Resize(window, TableLength, 1) ||
    !this->Rows.Resize(window, TexelsPerRow, rows) || !this->Blocks.Resize(window, 2, rows))
  {
    this->NumberOfEntries = 0;
    return false;
  }
  if (begins)
  {
    this->Table.Write(0, MakeTable());
  }
  // Senders of the tree are followed by those of polygons.
  const int trees = static_cast<int>(tree.GetSenders().size());
  this->FirstPlace = this->NumberOfSenders = trees;
  for (const vtkIndirectProxyPolygon& polygon : this->Polygons)
  {
    this->NumberOfSenders += 2 *
      static_cast<int>(vtkIndirectProxyLight::FindPlaces(polygon, this->Polygons.size()).size());
  }
  std::vector<float> values[4];
  for (const vtkIndirectProxyTree::Entry& entry : entries)
  {
    Append(values[0], entry.Center, entry.Radius);
    const glm::vec4 region = vtkIndirectKernels::vtkiPackRegion({ entry.OuterCenter - entry.Center,
      entry.Outer, entry.Inner, entry.Bound, entry.Share, static_cast<float>(entry.Next) });
    Append(values[1], glm::vec3(region), region.w);
    Append(values[2], entry.Albedo, static_cast<float>(entry.Sender));
  }
  for (const vtkIndirectProxyTree::Block& block : blocks)
  {
    Append(values[3], block.Lower, 0.0f);
    Append(values[3], block.Upper, 0.0f);
  }
  for (int i = 0; i < 3; ++i)
  {
    WriteRows(this->Rows, i, values[i]);
  }
  if (!blocks.empty())
  {
    this->Blocks.Write(0, values[3]);
  }
  return this->UpdateSenders(window, tree);
}

//------------------------------------------------------------------------------
bool vtkIndirectProxyTreeTables::UpdateSenders(
  vtkOpenGLRenderWindow* window, const vtkIndirectProxyTree& tree)
{
  std::vector<float> places;
  std::vector<float> normals;
  std::vector<float> ranges;
  for (const vtkIndirectProxyTree::Sender& sender : tree.GetSenders())
  {
    Append(places, sender.Center, sender.Radius);
    Append(normals, glm::vec3(0.0f), 0.0f);
  }
  for (const vtkIndirectProxyTree::Mean& mean : tree.GetMeans())
  {
    Append(ranges, glm::vec3(static_cast<float>(mean.First), static_cast<float>(mean.Count), 0.0f),
      0.0f);
  }
  for (const vtkIndirectProxyPolygon& polygon : this->Polygons)
  {
    const glm::dvec3 normal = vtkIndirectProxyLight::FindNormal(polygon);
    const std::vector<glm::dvec3> own =
      vtkIndirectProxyLight::FindPlaces(polygon, this->Polygons.size());
    const double area = vtkIndirectProxyLight::FindSize(polygon) / static_cast<double>(own.size());
    for (const double side : { 1.0, -1.0 })
    {
      for (const glm::dvec3& place : own)
      {
        Append(places, glm::vec3(place), static_cast<float>(area));
        Append(normals, glm::vec3(side * normal), 1.0f);
      }
    }
  }
  const int rows = FindRows(places.size() / 4);
  // Every texel that shaders may read is written.
  ranges.resize(std::max(ranges.size(), size_t(4)), 0.0f);
  const int meanRows = FindRows(ranges.size() / 4);
  if (!this->Senders.Resize(window, TexelsPerRow, rows) ||
    !this->Ranges.Resize(window, TexelsPerRow, meanRows))
  {
    this->NumberOfEntries = 0;
    return false;
  }
  WriteRows(this->Senders, 0, places);
  WriteRows(this->Senders, 1, normals);
  WriteRows(this->Ranges, 0, ranges);
  return true;
}

//------------------------------------------------------------------------------
void vtkIndirectProxyTreeTables::SetTexelSize(
  const vtkIndirectProgram& program, const char* name, const vtkIndirectTarget& table)
{
  const float perTexel[2] = { 1.0f / static_cast<float>(TexelsPerRow),
    1.0f / static_cast<float>(std::max(table.GetHeight(), 1)) };
  program->SetUniform2f(name, perTexel);
}

//------------------------------------------------------------------------------
void vtkIndirectProxyTreeTables::Activate(const vtkIndirectProgram& program) const
{
  if (program->IsUniformUsed("vtkiSenderPlace"))
  {
    program->SetUniformi("vtkiSenderCount", this->NumberOfSenders);
    this->Senders.Activate(0, program);
    this->Senders.Activate(1, program);
  }
  if (program->IsUniformUsed("vtkiProxyBlocks"))
  {
    this->Blocks.Activate(0, program);
    program->SetUniformi("vtkiBlockCount", this->NumberOfBlocks);
  }
  this->Table.Activate(0, program);
  for (int i = 0; i < this->Rows.GetNumberOfChannels(); ++i)
  {
    this->Rows.Activate(i, program);
  }
  SetTexelSize(program, "vtkiEntryScale", this->Rows);
  program->SetUniformi("vtkiProxyCount", this->NumberOfEntries);
}

//------------------------------------------------------------------------------
void vtkIndirectProxyTreeTables::ReleaseOwn(vtkWindow*)
{
  this->NumberOfEntries = this->NumberOfBlocks = this->NumberOfSenders = 0;
}
