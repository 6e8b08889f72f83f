// SPDX-License-Identifier: BSD-3-Clause
// Textures of a hint grid's tables, each made when it is first bound.
#ifndef vtkIndirectHintTables_h
#define vtkIndirectHintTables_h

#include "vtkSmartPointer.h" // for members

#include <cstddef>     // for size_t
#include <glm/glm.hpp> // for vectors
#include <vector>      // for content

class vtkOpenGLRenderWindow;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

class vtkIndirectHintTables
{
public:
  enum Table
  {
    Hints,
    Masks,
    Rays,
    Directions,
    SurfelPosition,
    SurfelNormal,
    SurfelAlbedo,
    Albedo,
    NumberOfTables
  };

  vtkIndirectHintTables();
  ~vtkIndirectHintTables();

  bool Has(Table table) const { return this->Textures[table] != nullptr; }
  /** Rows of `width` texels of four floats; the last row is padded with zeros. */
  void Make(Table table, vtkOpenGLRenderWindow* window, std::vector<glm::vec4> texels, int width);
  /** A volume of two bytes a texel. */
  void Make(Table table, vtkOpenGLRenderWindow* window, const glm::ivec3& size,
    const std::vector<unsigned char>& bytes);

  /** Releases all textures, whose content is out of date. */
  void Clear();

  /** Pair with Deactivate, one for all tables. */
  void Bind(Table table, vtkShaderProgram* program, const char* uniform);
  void Deactivate();

  size_t GetBytes() const;
  void Release(vtkWindow* window);

private:
  vtkTextureObject* Begin(Table table, vtkOpenGLRenderWindow* window);

  vtkSmartPointer<vtkTextureObject> Textures[NumberOfTables];
};

#endif
