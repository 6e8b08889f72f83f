// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/vtkIndirectRevision.h"

#include "Scene/vtkIndirectActors.h"
#include "Scene/vtkIndirectInformationKeys.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkAlgorithmOutput.h"
#include "vtkAssembly.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkGlyph3DMapper.h"
#include "vtkInformation.h"
#include "vtkLODProp3D.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProp3DFollower.h"
#include "vtkPropAssembly.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkScalarsToColors.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUniforms.h"

#if __has_include("vtkLODActor.h")
#include "vtkLODActor.h"
#include "vtkMapperCollection.h"
#define VTKI_LEVELS
#endif

#include <cstdint>
#include <cstring>

namespace
{
#ifdef VTKI_LEVELS
struct LevelAccess : vtkLODActor
{
  // VTK makes these two of the actor's own data when it first draws it.
  static bool IsOwn(vtkLODActor* actor, vtkMapper* mapper)
  {
    return mapper == actor->*(&LevelAccess::LowMapper) ||
      mapper == actor->*(&LevelAccess::MediumMapper);
  }
};
#endif

// Makes a mapper's default lookup table. The mapper would make it in its first draw and be modified
// by that: the second frame would see a changed mapper.
void MakeTable(vtkAbstractMapper* mapper)
{
  if (auto* known = vtkMapper::SafeDownCast(mapper))
  {
    known->GetLookupTable();
  }
}
}

//------------------------------------------------------------------------------
// Mixes bits into the number by splitmix64's finalizer (Steele, Lea, Flood 2014).
void vtkIndirectRevision::Add(vtkTypeUInt64 bits)
{
  this->Number += bits + 0x9e3779b97f4a7c15u;
  this->Number = (this->Number ^ (this->Number >> 30)) * 0xbf58476d1ce4e5b9u;
  this->Number = (this->Number ^ (this->Number >> 27)) * 0x94d049bb133111ebu;
  this->Number ^= this->Number >> 31;
}

//------------------------------------------------------------------------------
void vtkIndirectRevision::AddObject(vtkObject* object)
{
  this->Add(static_cast<vtkTypeUInt64>(reinterpret_cast<uintptr_t>(object)));
  this->Add(object ? object->GetMTime() : 0);
}

//------------------------------------------------------------------------------
void vtkIndirectRevision::AddMatrix(vtkMatrix4x4* matrix)
{
  for (int i = 0; matrix && i < 16; ++i)
  {
    vtkTypeUInt64 bits;
    std::memcpy(&bits, matrix->GetData() + i, sizeof bits);
    this->Add(bits);
  }
}

//------------------------------------------------------------------------------
// Adds data with its blocks, because the time of composite data leaves out that of its blocks.
void vtkIndirectRevision::AddData(vtkDataObject* data)
{
  this->AddObject(data);
  if (vtkCompositeDataSet::SafeDownCast(data))
  {
    vtkIndirectActors::ForEachBlock<vtkDataObject>(
      data, [this](vtkDataObject* block) { this->AddObject(block); });
  }
}

//------------------------------------------------------------------------------
void vtkIndirectRevision::AddInputs(vtkAlgorithm* algorithm)
{
  const bool runs = vtkIndirectActors::RunsPipeline(algorithm);
  for (int port = 0; port < algorithm->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < algorithm->GetNumberOfInputConnections(port); ++i)
    {
      vtkAlgorithmOutput* output = algorithm->GetInputConnection(port, i);
      if (runs)
      {
        output->GetProducer()->Update(output->GetIndex());
      }
      this->AddData(algorithm->GetInputDataObject(port, i));
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectRevision::AddTexture(vtkTexture* texture)
{
  this->AddObject(texture);
  if (texture)
  {
    this->AddInputs(texture);
    this->AddObject(texture->GetLookupTable());
    this->AddObject(texture->GetTransform());
  }
}

//------------------------------------------------------------------------------
// Adds the matrix of texture coordinates that a user has set as a key. vtkActor writes the same key
// when it draws a texture with a transform; AddTexture has that transform.
void vtkIndirectRevision::AddTextureMatrix(vtkActor* actor)
{
  vtkInformation* keys = actor->GetPropertyKeys();
  const bool ofTexture = actor->GetTexture() && actor->GetTexture()->GetTransform();
  if (ofTexture || !keys || !keys->Has(vtkProp::GeneralTextureTransform()))
  {
    return;
  }
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(keys->Get(vtkProp::GeneralTextureTransform()));
  this->AddMatrix(matrix);
}

//------------------------------------------------------------------------------
void vtkIndirectRevision::AddProperty(vtkProperty* property)
{
  this->AddObject(property);
  if (!property)
  {
    return;
  }
  for (const auto& [name, texture] : property->GetAllTextures())
  {
    this->AddTexture(texture);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectRevision::AddShaders(vtkProp* prop)
{
  vtkShaderProperty* shaders = prop->GetShaderProperty();
  this->AddObject(shaders);
  this->AddObject(shaders->GetVertexCustomUniforms());
  this->AddObject(shaders->GetFragmentCustomUniforms());
  this->AddObject(shaders->GetGeometryCustomUniforms());
}

//------------------------------------------------------------------------------
void vtkIndirectRevision::AddMapper(vtkAbstractMapper* mapper)
{
  if (!mapper)
  {
    this->AddObject(nullptr);
    return;
  }
  // Pipelines come first: running them modifies some mappers.
  this->AddInputs(mapper);
  MakeTable(mapper);
  this->AddObject(mapper); // with its lookup table
  vtkPlaneCollection* planes = mapper->GetClippingPlanes();
  for (int i = 0; planes && i < planes->GetNumberOfItems(); ++i)
  {
    this->AddObject(planes->GetItem(i));
  }
  if (auto* glyphs = vtkGlyph3DMapper::SafeDownCast(mapper))
  {
    this->AddObject(glyphs->GetBlockAttributes());
  }
  else if (auto* splats = vtkPointGaussianMapper::SafeDownCast(mapper))
  {
    this->AddObject(splats->GetScaleFunction());
    this->AddObject(splats->GetScalarOpacityFunction());
  }
}

//------------------------------------------------------------------------------
// Adds the levels of detail that a vtkLODActor has been given.
void vtkIndirectRevision::AddLevels(vtkActor* prop)
{
#ifdef VTKI_LEVELS
  auto* actor = vtkLODActor::SafeDownCast(prop);
  vtkMapperCollection* mappers = actor ? actor->GetLODMappers() : nullptr;
  for (int i = 0; mappers && i < mappers->GetNumberOfItems(); ++i)
  {
    auto* mapper = vtkMapper::SafeDownCast(mappers->GetItemAsObject(i));
    if (!LevelAccess::IsOwn(actor, mapper))
    {
      this->AddMapper(mapper);
    }
  }
#else
  (void)prop;
#endif
}

//------------------------------------------------------------------------------
// whole: false for a part of another prop, which VTK modifies whenever it draws it.
void vtkIndirectRevision::AddProp(vtkProp* prop, bool whole)
{
  this->Add(static_cast<vtkTypeUInt64>(reinterpret_cast<uintptr_t>(prop)));
  if (!prop)
  {
    return;
  }
  this->Add(prop->GetVisibility() ? 1 : 0);
  // Only these two keys count: passes write other keys in every frame.
  this->Add(
    vtkIndirectInformationKeys::IsSet(prop, vtkIndirectInformationKeys::CastsShadows()) ? 1 : 0);
  this->Add(
    vtkIndirectInformationKeys::IsSet(prop, vtkIndirectInformationKeys::SendsLight()) ? 1 : 0);
  this->AddShaders(prop);
  if (vtkAssembly::SafeDownCast(prop) || vtkPropAssembly::SafeDownCast(prop))
  {
    prop->InitPathTraversal();
    while (vtkAssemblyPath* path = prop->GetNextPath())
    {
      vtkAssemblyNode* node = path->GetLastNode();
      vtkProp* part = node->GetViewProp();
      this->AddMatrix(node->GetMatrix() ? node->GetMatrix() : part->GetMatrix());
      if (part != prop)
      {
        this->AddProp(part, false);
      }
    }
    return;
  }
  if (whole)
  {
    auto* actor = vtkActor::SafeDownCast(prop);
    vtkMapper* mapper = actor ? actor->GetMapper() : nullptr;
    MakeTable(mapper);
    // An actor's time of redrawing runs the pipeline of any mapper.
    const bool runs = !mapper || vtkIndirectActors::RunsPipeline(mapper);
    this->Add(runs ? prop->GetRedrawMTime() : prop->GetMTime());
  }
  if (auto* follower = vtkProp3DFollower::SafeDownCast(prop))
  {
    this->AddProp(follower->GetProp3D(), false);
  }
  else if (auto* levels = vtkLODProp3D::SafeDownCast(prop))
  {
    this->Add(static_cast<vtkTypeUInt64>(levels->GetLastRenderedLODID()));
    vtkNew<vtkPropCollection> actors;
    levels->GetActors(actors);
    vtkCollectionSimpleIterator it;
    actors->InitTraversal(it);
    while (vtkProp* level = actors->GetNextProp(it))
    {
      this->AddProp(level, false);
    }
  }
  else if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    this->AddProperty(actor->GetProperty());
    this->AddProperty(actor->GetBackfaceProperty());
    this->AddTexture(actor->GetTexture());
    this->AddTextureMatrix(actor);
    this->AddMapper(actor->GetMapper());
    this->AddLevels(actor);
  }
  else if (!whole)
  {
    this->Add(prop->GetRedrawMTime());
  }
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkIndirectRevision::Find(vtkProp* prop)
{
  vtkIndirectRevision revision;
  revision.AddProp(prop, true);
  return revision.Get();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkIndirectRevision::Find(vtkTexture* texture)
{
  vtkIndirectRevision revision;
  revision.AddTexture(texture);
  return revision.Get();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkIndirectRevision::FindShape(vtkPolyData* mesh)
{
  vtkIndirectRevision revision;
  revision.AddObject(mesh->GetPoints());
  revision.AddObject(mesh->GetPolys());
  revision.AddObject(mesh->GetStrips());
  return revision.Get();
}

//------------------------------------------------------------------------------
vtkTypeUInt64 vtkIndirectRevision::Join(vtkTypeUInt64 revision, vtkTypeUInt64 other)
{
  vtkIndirectRevision joined;
  joined.Add(revision);
  joined.Add(other);
  return joined.Get();
}
