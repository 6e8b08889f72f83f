// SPDX-License-Identifier: BSD-3-Clause
#include "CardScene.h"

#include "vtkActor.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkEGLHeadlessRenderWindow.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkXMLImageDataReader.h"
#include "vtkXMLPolyDataReader.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <fstream>
#include <stdexcept>

using Json = nlohmann::json;
using Vector = std::array<double, 3>;

namespace
{
//------------------------------------------------------------------------------
void SetCamera(vtkCamera* camera, const Json& values)
{
  camera->SetPosition(values.at("Position").get<Vector>().data());
  camera->SetFocalPoint(values.at("FocalPoint").get<Vector>().data());
  camera->SetViewUp(values.at("ViewUp").get<Vector>().data());
  camera->SetViewAngle(values.at("ViewAngle"));
  camera->SetParallelProjection(values.at("ParallelProjection").get<int>());
  camera->SetParallelScale(values.at("ParallelScale"));
  auto range = values.at("ClippingRange").get<std::array<double, 2>>();
  camera->SetClippingRange(range.data());
}

//------------------------------------------------------------------------------
void AddLight(vtkRenderer* renderer, const Json& values)
{
  vtkNew<vtkLight> light;
  light->SetLightType(values.at("LightType"));
  light->SetPositional(values.at("Positional").get<int>());
  light->SetPosition(values.at("Position").get<Vector>().data());
  light->SetFocalPoint(values.at("FocalPoint").get<Vector>().data());
  light->SetDiffuseColor(values.at("DiffuseColor").get<Vector>().data());
  light->SetSpecularColor(values.at("SpecularColor").get<Vector>().data());
  light->SetAmbientColor(values.at("AmbientColor").get<Vector>().data());
  light->SetIntensity(values.at("Intensity"));
  light->SetConeAngle(values.at("ConeAngle"));
  light->SetExponent(values.at("Exponent"));
  light->SetAttenuationValues(values.at("AttenuationValues").get<Vector>().data());
  renderer->AddLight(light);
}

//------------------------------------------------------------------------------
void SetMaterial(vtkProperty* property, const Json& values)
{
  property->SetAmbientColor(values.at("AmbientColor").get<Vector>().data());
  property->SetDiffuseColor(values.at("DiffuseColor").get<Vector>().data());
  property->SetSpecularColor(values.at("SpecularColor").get<Vector>().data());
  property->SetAmbient(values.at("Ambient"));
  property->SetDiffuse(values.at("Diffuse"));
  property->SetSpecular(values.at("Specular"));
  property->SetSpecularPower(values.at("SpecularPower"));
  property->SetOpacity(values.at("Opacity"));
  property->SetInterpolation(values.at("Interpolation"));
  property->SetMetallic(values.at("Metallic"));
  property->SetRoughness(values.at("Roughness"));
  property->SetBaseIOR(values.at("BaseIOR"));
}

//------------------------------------------------------------------------------
void AddActor(vtkRenderer* renderer, const Json& values, const std::string& folder)
{
  const std::string path = folder + "/" + values.at("File").get<std::string>();
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  if (reader->GetOutput()->GetNumberOfCells() == 0)
  {
    throw std::runtime_error(path + " cannot be read");
  }
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(reader->GetOutput());
  mapper->SetScalarVisibility(values.at("Colored").get<bool>());
  mapper->SetColorModeToDirectScalars();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  SetMaterial(actor->GetProperty(), values);
  vtkNew<vtkMatrix4x4> matrix;
  matrix->DeepCopy(values.at("Matrix").get<std::array<double, 16>>().data());
  actor->SetUserMatrix(matrix);
  renderer->AddActor(actor);
}
}

//------------------------------------------------------------------------------
card::Scene::Scene(const std::string& folder)
  : Folder(folder)
{
  std::ifstream file(folder + "/scene.json");
  if (!file)
  {
    throw std::runtime_error(folder + " has no scene.json");
  }
  try
  {
    const Json values = Json::parse(file);
    this->Name = values.at("Name");
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetBackground(values.at("Background").get<Vector>().data());
    for (const Json& light : values.at("Lights"))
    {
      AddLight(this->Renderer, light);
    }
    for (const Json& actor : values.at("Actors"))
    {
      AddActor(this->Renderer, actor, folder);
    }
    SetCamera(this->Renderer->GetActiveCamera(), values.at("Camera"));
  }
  catch (const Json::exception& error)
  {
    throw std::runtime_error(folder + "/scene.json: " + error.what());
  }
}

//------------------------------------------------------------------------------
card::Scene::~Scene()
{
  if (this->Window)
  {
    this->Window->RemoveRenderer(this->Renderer);
  }
}

//------------------------------------------------------------------------------
void card::Scene::Open(int width, int height)
{
  this->Window = vtkSmartPointer<vtkEGLHeadlessRenderWindow>::New();
  this->Window->SetSize(width, height);
  this->Window->Initialize();
  if (!this->Window->GetGenericContext())
  {
    throw std::runtime_error(this->Window->GetLastErrorMessage());
  }
  this->Window->AddRenderer(this->Renderer);
}

//------------------------------------------------------------------------------
double card::Scene::GetDiagonal()
{
  double bounds[6];
  this->Renderer->ComputeVisiblePropBounds(bounds);
  return vtkBoundingBox(bounds).GetDiagonalLength();
}

//------------------------------------------------------------------------------
card::Image card::Scene::GetReference(const std::string& layer)
{
  if (!this->References)
  {
    vtkNew<vtkXMLImageDataReader> reader;
    reader->SetFileName((this->Folder + "/reference.vti").c_str());
    reader->Update();
    this->References = reader->GetOutput();
  }
  vtkImageData* data = this->References;
  vtkDataArray* array = data->GetPointData()->GetArray(layer.c_str());
  if (!array)
  {
    throw std::runtime_error(this->Folder + "/reference.vti has no " + layer);
  }
  Image image;
  image.Width = data->GetDimensions()[0];
  image.Height = data->GetDimensions()[1];
  image.Components = array->GetNumberOfComponents();
  image.Values.resize(array->GetNumberOfValues());
  for (size_t i = 0; i < image.Values.size(); ++i)
  {
    const vtkIdType value = static_cast<vtkIdType>(i);
    image.Values[i] = static_cast<float>(
      array->GetComponent(value / image.Components, static_cast<int>(value % image.Components)));
  }
  return image;
}
