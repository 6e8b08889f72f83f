// SPDX-License-Identifier: BSD-3-Clause
// The colours that VTK shades the surfaces of one mapper, actor and data set with, for stages that
// read the scene on the processor: rays, voxels, and spheres.
//
// An albedo is the diffusely reflected share of light that VTK does not divide by pi; for PBR it
// includes the factor 1 - metallic. It depends on the property and the back's property, the
// scalars' colours (also where VTK interpolates scalars before it maps them), blocks of composite
// mappers, textures, and for PBR the textures of base colour and of metal. An unlit surface has no
// albedo.
#pragma once

#include "Scene/vtkIndirectMaterialImage.h" // for members

#include "vtkDataArray.h"         // for a member
#include "vtkScalarsToColors.h"   // for a member
#include "vtkSmartPointer.h"      // for members
#include "vtkType.h"              // for ids
#include "vtkUnsignedCharArray.h" // for a member

#include <glm/glm.hpp> // for colours
#include <optional>    // for optional flags
#include <string>      // for reasons
#include <vector>      // for members

class vtkActor;
class vtkDataSet;
class vtkMapper;
class vtkProperty;

class vtkIndirectMaterial
{
public:
  /** A place on a triangle of the data, by the corners' points and weights. */
  struct Place
  {
    vtkIdType Cell;
    vtkIdType Points[3];
    double Weights[3];
    bool Front;
  };
  /** These are the attributes that a block of a composite mapper has of its own. */
  struct Block
  {
    bool Shown = true;
    bool Opaque = true;
    bool HasColor = false; // before VTK 9.4 the colour replaces scalars, too
    glm::dvec3 Color{ 0.0 };
    std::optional<bool> ShowsScalars; // replaces the mapper's flag
    bool HasOwnScalars = false;       // or a texture; neither is read
  };

  vtkIndirectMaterial() = default; // black
  vtkIndirectMaterial(vtkActor* actor, vtkMapper* mapper, vtkDataSet* data)
    : vtkIndirectMaterial(actor, mapper, data, Block())
  {
  }
  vtkIndirectMaterial(vtkActor* actor, vtkMapper* mapper, vtkDataSet* data, const Block& block);
  /**
   * Returns the albedo of an actor's property alone, without scalars, textures and the back's
   * property.
   */
  static glm::dvec3 FindPlain(vtkActor* actor);

  bool IsPhysicallyBased() const { return this->PhysicallyBased; }
  bool IsLit() const { return this->Lit; }
  /** Returns true if there is one colour for each cell, not for each point. */
  bool IsByCell() const { return this->Colors && this->ColorsAreOfCells; }
  /** Returns true if the textures change over a triangle. */
  bool HasPattern() const;

  glm::dvec3 Find(const Place& place) const;
  /** Returns the mean over the front of a triangle; a texture's mean is that of samples. */
  glm::dvec3 FindMean(vtkIdType cell, const vtkIdType points[3]) const;
  /** Returns the albedo of a point, or of a cell if IsByCell; without textures. */
  glm::dvec3 Get(vtkIdType number) const { return this->Finish(this->GetColor(number), 1.0); }
  /** Returns the mean over all points or cells, times the means of textures. */
  glm::dvec3 GetMean() const;
  /** Returns the reason why these are not the colours that VTK draws; empty if they are. */
  const std::string& GetLeftOut() const { return this->LeftOut; }
  size_t GetBytes() const;

private:
  void ReadProperty(vtkProperty* property, vtkProperty* back);
  double Decode(double value) const;
  void ReadColors(vtkMapper* mapper, vtkDataSet* data, bool shown);
  void ReadScalars(vtkMapper* mapper, vtkDataSet* data);
  void ReadTextures(vtkActor* actor, vtkDataSet* data);
  glm::dvec3 GetColor(vtkIdType at) const;
  glm::dvec3 FindColor(const Place& place) const;
  glm::dvec2 FindCoordinates(const Place& place) const;
  glm::dvec3 Finish(const glm::dvec3& color, double metal) const;

  bool Lit = false;
  bool PhysicallyBased = false;
  bool Encoded = false; // true if colours, times the coefficient, are encoded with gamma 2.2
  double Metallic = 0.0;
  double Diffuse = 1.0;    // already in Plain and Back
  glm::dvec3 Plain{ 0.0 }; // without scalars
  bool HasBack = false;
  glm::dvec3 Back{ 0.0 };
  vtkSmartPointer<vtkUnsignedCharArray> Colors;
  bool ColorsAreOfCells = false;
  // Scalars that are interpolated before they are mapped.
  vtkSmartPointer<vtkScalarsToColors> Table;
  std::vector<double> Scalars;
  vtkSmartPointer<vtkDataArray> Coordinates;
  std::vector<vtkIndirectMaterialImage> Images; // images that multiply each other
  vtkIndirectMaterialImage Metal;               // its blue channel
  bool ImagesOnBack = true;
  std::string LeftOut;
};
