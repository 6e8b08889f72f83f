// SPDX-License-Identifier: BSD-3-Clause
// The colours of what one mapper of an actor draws of one data set, as VTK shades it, for whoever
// reads the scene on the processor: rays, voxels, and spheres.
//
// An albedo is what diffusion reflects, of light that VTK does not divide by pi: of PBR times
// 1 - metallic. It follows the property and that of the back, scalars' colours (also where VTK
// interpolates scalars before it maps them), blocks of composite mappers, textures, and of PBR the
// textures of base colour and of metal. An unlit surface has none.
#ifndef vtkIndirectMaterial_h
#define vtkIndirectMaterial_h

#include "Frame/vtkIndirectMaterialImage.h" // for members

#include "vtkDataArray.h"         // for a member
#include "vtkScalarsToColors.h"   // for a member
#include "vtkSmartPointer.h"      // for members
#include "vtkType.h"              // for ids
#include "vtkUnsignedCharArray.h" // for a member

#include <glm/glm.hpp> // for colours
#include <optional>    // for what has a say or none
#include <string>      // for reasons
#include <vector>      // for members

class vtkActor;
class vtkDataSet;
class vtkMapper;
class vtkProperty;

class vtkIndirectMaterial
{
public:
  /** A place on a triangle of the data: corners by their points, and these corners' weights. */
  struct Place
  {
    vtkIdType Cell;
    vtkIdType Points[3];
    double Weights[3];
    bool Front;
  };
  /** What a block of a composite mapper has of its own. */
  struct Block
  {
    bool Shown = true;
    bool Opaque = true;
    bool HasColor = false; // before VTK 9.4 in place of scalars, too
    glm::dvec3 Color{ 0.0 };
    std::optional<bool> ShowsScalars; // in place of the mapper's
    bool HasOwnScalars = false;       // or a texture: that is not taken
  };

  vtkIndirectMaterial() = default; // black
  vtkIndirectMaterial(vtkActor* actor, vtkMapper* mapper, vtkDataSet* data)
    : vtkIndirectMaterial(actor, mapper, data, Block())
  {
  }
  vtkIndirectMaterial(vtkActor* actor, vtkMapper* mapper, vtkDataSet* data, const Block& block);
  /** The albedo of an actor's property alone, without scalars, textures and the back's property. */
  static glm::dvec3 FindPlain(vtkActor* actor);

  bool IsPhysicallyBased() const { return this->PhysicallyBased; }
  bool IsLit() const { return this->Lit; }
  /** Whether there is one colour a cell, and not one a point. */
  bool IsByCell() const { return this->Colors && this->ColorsAreOfCells; }
  /** Whether its textures change over a triangle. */
  bool HasPattern() const;

  glm::dvec3 Find(const Place& place) const;
  /** Over the front of a triangle; of a texture a mean of samples. */
  glm::dvec3 FindMean(vtkIdType cell, const vtkIdType points[3]) const;
  /** Of a point, or of a cell where IsByCell; without textures. */
  glm::dvec3 Get(vtkIdType number) const;
  /** Over all points or cells, times the means of textures. */
  glm::dvec3 GetMean() const;
  /** Why these are not the colours that VTK draws; empty where they are. */
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
  bool Encoded = false; // colours are, times the coefficient, with gamma 2.2
  double Metallic = 0.0;
  double Diffuse = 1.0;    // in Plain and Back already
  glm::dvec3 Plain{ 0.0 }; // without scalars
  bool HasBack = false;
  glm::dvec3 Back{ 0.0 };
  vtkSmartPointer<vtkUnsignedCharArray> Colors;
  bool ColorsAreOfCells = false;
  // Scalars that are interpolated before they are mapped.
  vtkSmartPointer<vtkScalarsToColors> Table;
  std::vector<double> Scalars;
  vtkSmartPointer<vtkDataArray> Coordinates;
  std::vector<vtkIndirectMaterialImage> Images; // which multiply each other
  vtkIndirectMaterialImage Metal;               // its blue
  bool ImagesOnBack = true;
  std::string LeftOut;
};
#endif
