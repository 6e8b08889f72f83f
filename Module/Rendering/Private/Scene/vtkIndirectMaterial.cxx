// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectMaterial.h"

#include "vtkActor.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkVersionMacros.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace
{
// The largest number of samples along an edge of a triangle, for the mean of a texture.
constexpr int MostSamples = 16;

double ReadComponent(vtkDataArray* array, vtkIdType at, int component)
{
  return at >= 0 && at < array->GetNumberOfTuples() ? array->GetComponent(at, component) : 0.0;
}

// Returns true if the actor's keys transform the coordinates of its textures.
bool TransformsCoordinates(vtkActor* actor)
{
  vtkInformation* keys = actor->GetPropertyKeys();
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  return keys && keys->Has(vtkProp::GENERAL_TEXTURE_TRANSFORM());
#else
  return keys && keys->Has(vtkProp::GeneralTextureTransform());
#endif
}

// Returns true if the user's shader code may set the colour: vertex shaders only set places.
bool HasShaderCode(vtkActor* actor)
{
  vtkShaderProperty* shaders = actor->GetShaderProperty();
  bool any = shaders->HasFragmentShaderCode();
  for (int i = 0; i < shaders->GetNumberOfShaderReplacements(); ++i)
  {
    any = any || shaders->GetNthShaderReplacementTypeAsString(i) != "Vertex";
  }
  return any;
}

vtkTexture* FindTexture(vtkProperty* property, const std::string& name)
{
  const auto& all = property->GetAllTextures();
  const auto at = all.find(name);
  return at == all.end() ? nullptr : at->second;
}

// Returns true for textures that VTK's Phong shading does not use as a colour.
bool IsOfPBR(const std::string& name)
{
  static const char* const names[] = { "albedoTex", "normalTex", "materialTex", "brdfTex",
    "emissiveTex", "anisotropyTex", "coatNormalTex", "colortexture" };
  return std::find(std::begin(names), std::end(names), name) != std::end(names);
}
}

//------------------------------------------------------------------------------
vtkIndirectMaterial::vtkIndirectMaterial(
  vtkActor* actor, vtkMapper* mapper, vtkDataSet* data, const Block& block)
{
  vtkProperty* property = actor->GetProperty();
  // Mappers of instances and impostors have a colour of bytes for each instance, with scalars or
  // not.
  const bool ofGlyphs = mapper->IsA("vtkGlyph3DMapper");
  const bool ofInstances =
    ofGlyphs || mapper->IsA("vtkOpenGLSphereMapper") || mapper->IsA("vtkOpenGLStickMapper");
  this->ReadProperty(property, ofInstances ? nullptr : actor->GetBackfaceProperty());
  if (ofInstances)
  {
    const double* color = property->GetColor();
    for (int c = 0; c < 3; ++c)
    {
      // VTK truncates colours of impostors to bytes and rounds colours of glyphs.
      const double byte = std::floor(255.0 * color[c] + (ofGlyphs ? 0.5 : 0.0));
      this->Plain[c] = this->Decode(this->Diffuse * byte / 255.0);
    }
  }
  if (HasShaderCode(actor))
  {
    this->LeftOut = "shader code of the user's own may colour it; the property's colour is taken";
  }
  if (block.HasColor)
  {
    this->Plain = this->Diffuse * block.Color;
    this->HasBack = false;
  }
  if (!block.HasColor || VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 4, 0))
  {
    this->ReadColors(mapper, data, block.ShowsScalars.value_or(mapper->GetScalarVisibility()));
    this->ReadScalars(mapper, data);
  }
  if (block.HasOwnScalars && this->LeftOut.empty())
  {
    this->LeftOut = "a block has scalars, colours of scalars or a texture of its own";
  }
  if (!ofInstances)
  {
    this->ReadTextures(actor, data);
  }
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectMaterial::FindPlain(vtkActor* actor)
{
  vtkIndirectMaterial material;
  material.ReadProperty(actor->GetProperty(), nullptr);
  return material.Finish(material.Plain, 1.0);
}

//------------------------------------------------------------------------------
void vtkIndirectMaterial::ReadProperty(vtkProperty* property, vtkProperty* back)
{
  this->Lit = property->GetLighting();
  this->Diffuse = property->GetDiffuse();
  if (property->GetInterpolation() == VTK_PBR)
  {
    this->PhysicallyBased = true;
    this->Encoded = VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0);
    this->Metallic = property->GetMetallic();
  }
  const double* color = property->GetDiffuseColor();
  this->Plain = this->Diffuse * glm::dvec3(color[0], color[1], color[2]);
  this->HasBack = back != nullptr;
  if (back)
  {
    color = back->GetDiffuseColor();
    this->Back = back->GetDiffuse() * glm::dvec3(color[0], color[1], color[2]);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectMaterial::ReadColors(vtkMapper* mapper, vtkDataSet* data, bool shown)
{
  vtkScalarsToColors* table = shown ? mapper->GetLookupTable() : nullptr;
  int cells = 0;
  vtkAbstractArray* scalars = table
    ? vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
        mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cells)
    : nullptr;
  if (!scalars)
  {
    return;
  }
  if (!mapper->GetUseLookupTableScalarRange())
  {
    table->SetRange(mapper->GetScalarRange());
  }
  table->Build();
  this->Colors = vtkSmartPointer<vtkUnsignedCharArray>::Take(
    table->MapScalars(scalars, mapper->GetColorMode(), mapper->GetArrayComponent()));
  this->ColorsAreOfCells = cells != 0;
  if (this->Colors && this->Colors->GetNumberOfComponents() < 3)
  {
    this->Colors = nullptr;
  }
  this->HasBack = this->HasBack && !this->Colors;
}

//------------------------------------------------------------------------------
// Reads scalars that VTK interpolates before it maps them to colours: then lines of constant colour
// run through triangles.
void vtkIndirectMaterial::ReadScalars(vtkMapper* mapper, vtkDataSet* data)
{
  if (!this->Colors || this->ColorsAreOfCells || !mapper->GetInterpolateScalarsBeforeMapping() ||
    !mapper->CanUseTextureMapForColoring(data))
  {
    return;
  }
  int cells = 0;
  auto* scalars =
    vtkDataArray::SafeDownCast(vtkAbstractMapper::GetAbstractScalars(data, mapper->GetScalarMode(),
      mapper->GetArrayAccessMode(), mapper->GetArrayId(), mapper->GetArrayName(), cells));
  if (!scalars)
  {
    return;
  }
  this->Table = mapper->GetLookupTable();
  const int components = scalars->GetNumberOfComponents();
  const bool magnitude =
    this->Table->GetVectorMode() == vtkScalarsToColors::MAGNITUDE && components > 1;
  const int component =
    std::min(std::max({ this->Table->GetVectorComponent(), mapper->GetArrayComponent(), 0 }),
      components - 1);
  this->Scalars.resize(static_cast<size_t>(scalars->GetNumberOfTuples()));
  for (size_t i = 0; i < this->Scalars.size(); ++i)
  {
    const vtkIdType at = static_cast<vtkIdType>(i);
    double square = 0.0;
    for (int c = 0; magnitude && c < components; ++c)
    {
      square += scalars->GetComponent(at, c) * scalars->GetComponent(at, c);
    }
    this->Scalars[i] = magnitude ? std::sqrt(square) : scalars->GetComponent(at, component);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectMaterial::ReadTextures(vtkActor* actor, vtkDataSet* data)
{
  vtkProperty* property = actor->GetProperty();
  this->Coordinates = data->GetPointData()->GetTCoords();
  if (!this->Coordinates)
  {
    return;
  }
  bool left = false;
  const auto add = [&](vtkTexture* texture)
  {
    // VTK ignores further textures without a mode.
    const int mode = texture->GetBlendingMode();
    const bool first = this->Images.empty();
    left = left || (!first && mode > vtkTexture::VTK_TEXTURE_BLENDING_MODE_MODULATE) ||
      (!first && mode == vtkTexture::VTK_TEXTURE_BLENDING_MODE_REPLACE);
    vtkIndirectMaterialImage image;
    if ((first || mode == vtkTexture::VTK_TEXTURE_BLENDING_MODE_MODULATE) && image.Read(texture))
    {
      this->Images.push_back(std::move(image));
    }
  };
  if (this->PhysicallyBased)
  {
    if (vtkTexture* color = FindTexture(property, "albedoTex"))
    {
      add(color);
    }
    this->Metal.Read(FindTexture(property, "materialTex"));
  }
  else
  {
    if (actor->GetTexture())
    {
      add(actor->GetTexture());
    }
    for (const auto& named : property->GetAllTextures())
    {
      if (named.second && !IsOfPBR(named.first))
      {
        add(named.second);
      }
    }
    this->ImagesOnBack = property->GetShowTexturesOnBackface();
  }
  if (!this->Images.empty() && (left || TransformsCoordinates(actor)) && this->LeftOut.empty())
  {
    this->LeftOut = left ? "of textures that are blended the first is taken"
                         : "the transform of its texture's coordinates is not taken";
  }
  if (this->Images.empty() && this->Metal.IsEmpty())
  {
    this->Coordinates = nullptr;
  }
}

//------------------------------------------------------------------------------
bool vtkIndirectMaterial::HasPattern() const
{
  return this->Metal.Varies() ||
    std::any_of(this->Images.begin(), this->Images.end(),
      [](const vtkIndirectMaterialImage& image) { return image.Varies(); });
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectMaterial::GetColor(vtkIdType at) const
{
  if (!this->Colors || at < 0 || at >= this->Colors->GetNumberOfTuples())
  {
    return this->Plain;
  }
  const unsigned char* c = this->Colors->GetPointer(at * this->Colors->GetNumberOfComponents());
  return { this->Decode(this->Diffuse * c[0] / 255.0), this->Decode(this->Diffuse * c[1] / 255.0),
    this->Decode(this->Diffuse * c[2] / 255.0) };
}

//------------------------------------------------------------------------------
double vtkIndirectMaterial::Decode(double value) const
{
  return this->Encoded ? std::pow(value, 2.2) : value;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectMaterial::Finish(const glm::dvec3& color, double metal) const
{
  // The capture of surfaces clamps the albedo in the same way.
  const glm::dvec3 albedo = (1.0 - metal * this->Metallic) * color;
  return this->Lit && std::isfinite(albedo.x + albedo.y + albedo.z)
    ? glm::clamp(albedo, glm::dvec3(0.0), glm::dvec3(1.0))
    : glm::dvec3(0.0);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectMaterial::GetMean() const
{
  const vtkIdType count = this->Colors ? this->Colors->GetNumberOfTuples() : 0;
  const vtkIdType step = std::max<vtkIdType>(1, count / 1000);
  glm::dvec3 sum(0.0);
  double number = 0.0;
  for (vtkIdType i = 0; i < std::max<vtkIdType>(count, 1); i += step)
  {
    sum += this->GetColor(i);
    number += 1.0;
  }
  for (const vtkIndirectMaterialImage& image : this->Images)
  {
    sum *= image.GetMean();
  }
  return this->Finish(sum / number, this->Metal.IsEmpty() ? 1.0 : this->Metal.GetMean().b);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectMaterial::FindColor(const Place& place) const
{
  if (!place.Front && this->HasBack)
  {
    return this->Back;
  }
  if (this->Table)
  {
    double scalar = 0.0;
    for (int i = 0; i < 3; ++i)
    {
      const size_t point = static_cast<size_t>(place.Points[i]);
      scalar += place.Weights[i] * (point < this->Scalars.size() ? this->Scalars[point] : 0.0);
    }
    double color[3];
    this->Table->GetColor(scalar, color);
    return this->Diffuse * glm::dvec3(color[0], color[1], color[2]);
  }
  if (!this->Colors || this->ColorsAreOfCells)
  {
    return this->GetColor(place.Cell);
  }
  glm::dvec3 sum(0.0);
  for (int i = 0; i < 3; ++i)
  {
    sum += place.Weights[i] * this->GetColor(place.Points[i]);
  }
  return sum;
}

//------------------------------------------------------------------------------
glm::dvec2 vtkIndirectMaterial::FindCoordinates(const Place& place) const
{
  glm::dvec2 at(0.0);
  for (int i = 0; i < 3; ++i)
  {
    for (int c = 0; c < std::min(this->Coordinates->GetNumberOfComponents(), 2); ++c)
    {
      at[c] += place.Weights[i] * ReadComponent(this->Coordinates, place.Points[i], c);
    }
  }
  return at;
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectMaterial::Find(const Place& place) const
{
  glm::dvec3 color = this->FindColor(place);
  double metal = 1.0;
  if (this->Coordinates && (place.Front || this->ImagesOnBack))
  {
    const glm::dvec2 at = this->FindCoordinates(place);
    for (const vtkIndirectMaterialImage& image : this->Images)
    {
      color *= image.Find(at);
    }
    metal = this->Metal.IsEmpty() ? 1.0 : this->Metal.Find(at).b;
  }
  return this->Finish(color, metal);
}

//------------------------------------------------------------------------------
glm::dvec3 vtkIndirectMaterial::FindMean(vtkIdType cell, const vtkIdType points[3]) const
{
  // Samples are the centres of the small triangles that the edges are divided into, including those
  // upside down: an edge a pixel.
  int edge = 1;
  if (this->HasPattern())
  {
    const vtkIdType* const pixels =
      (this->Images.empty() ? this->Metal : this->Images.front()).GetCounts();
    glm::dvec2 corners[3];
    for (int i = 0; i < 3; ++i)
    {
      corners[i] = this->FindCoordinates(
                     { cell, { points[i], points[i], points[i] }, { 1.0, 0.0, 0.0 }, true }) *
        glm::dvec2(pixels[0], pixels[1]);
    }
    const double longest = std::max({ glm::length(corners[1] - corners[0]),
      glm::length(corners[2] - corners[0]), glm::length(corners[2] - corners[1]) });
    edge = longest < MostSamples ? std::max(static_cast<int>(std::ceil(longest)), 1) : MostSamples;
  }
  glm::dvec3 sum(0.0);
  int count = 0;
  for (int half = 0; half < (edge > 1 ? 2 : 1); ++half)
  {
    for (int i = 0; i < edge - half; ++i)
    {
      for (int k = 0; k < edge - half - i; ++k, ++count)
      {
        const double a = (i + (1.0 + half) / 3.0) / edge;
        const double b = (k + (1.0 + half) / 3.0) / edge;
        sum +=
          this->Find({ cell, { points[0], points[1], points[2] }, { 1.0 - a - b, a, b }, true });
      }
    }
  }
  return sum / static_cast<double>(count);
}

//------------------------------------------------------------------------------
size_t vtkIndirectMaterial::GetBytes() const
{
  size_t bytes = this->Scalars.size() * sizeof(double) + this->Metal.GetBytes() +
    (this->Colors ? static_cast<size_t>(this->Colors->GetNumberOfValues()) : 0);
  for (const vtkIndirectMaterialImage& image : this->Images)
  {
    bytes += image.GetBytes();
  }
  return bytes;
}
