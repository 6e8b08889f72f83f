// SPDX-License-Identifier: BSD-3-Clause
// Revisions tell when a prop, a texture or another object has changed: all caches use them.
//
// VTK's own times of a prop leave out many inputs of its drawing: clipping planes of its mapper,
// images of textures and their pipelines, levels of detail, sources of glyphs, uniforms of its
// shaders. The newest time of several objects also hides that one has gone, or has been replaced by
// an older one.
#pragma once

#include "vtkType.h" // for numbers

class vtkMatrix4x4;
class vtkObject;
class vtkPolyData;
class vtkProp;
class vtkTexture;

class vtkIndirectRevision
{
public:
  /**
   * Returns a number made of all that a prop is drawn from, after bringing pipelines up to date.
   * The number changes when anything has changed, come or gone. Revisions are only compared for
   * equality, and a double holds them.
   */
  static vtkTypeUInt64 Find(vtkProp* prop);

  /** Returns the same for a texture: its settings, its images and its lookup table. */
  static vtkTypeUInt64 Find(vtkTexture* texture);

  /** Returns the same for a mesh's shape, whatever its colours. */
  static vtkTypeUInt64 FindShape(vtkPolyData* mesh);

  /** Returns a revision that also depends on another one. */
  static vtkTypeUInt64 Join(vtkTypeUInt64 revision, vtkTypeUInt64 other);

private:
  vtkTypeUInt64 Number = 0;

  void Add(vtkTypeUInt64 bits);
  void AddObject(vtkObject* object);
  void AddMatrix(vtkMatrix4x4* matrix);
  void AddData(class vtkDataObject* data);
  void AddInputs(class vtkAlgorithm* algorithm);
  void AddTexture(vtkTexture* texture);
  void AddTextureMatrix(class vtkActor* actor);
  void AddProperty(class vtkProperty* property);
  void AddShaders(vtkProp* prop);
  void AddMapper(class vtkAbstractMapper* mapper);
  void AddLevels(class vtkActor* prop);
  void AddProp(vtkProp* prop, bool whole);
  vtkTypeUInt64 Get() const { return this->Number >> 12; }
};
