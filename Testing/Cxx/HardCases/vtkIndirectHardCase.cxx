// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectHardCase.h"

#include "vtkActor.h"
#include "vtkAreaLight.h"
#include "vtkCellArray.h"
#include "vtkEnvironmentLight.h"
#include "vtkFloatArray.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProperty.h"
#include "vtkRSMReferencePass.h"
#include "vtkTrivialProducer.h"
#include "vtkVirtualLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vtkIndirectTest
{
double GetLargest(const Image& image)
{
  float largest = 0.0f;
  for (float value : image.Values)
  {
    largest = std::max(largest, value);
  }
  return largest;
}

double GetShareOfDifferent(
  const Image& image, const Image& expected, double tolerance, const Comparison& how)
{
  if (image.Values.size() != expected.Values.size() || image.Values.empty())
  {
    return 1.0;
  }
  const int components = expected.Components;
  const int last = std::min(how.LastComponent, components - 1);
  auto length = [&](size_t i)
  {
    double sum = 0.0;
    for (int c = how.FirstComponent; c <= last; ++c)
    {
      sum += std::pow(double(expected.Values[i + c]), 2.0);
    }
    return std::sqrt(sum);
  };
  double least = how.Least;
  for (size_t i = 0; i < expected.Values.size(); i += components)
  {
    least = std::max(least, 2e-4 * length(i));
  }
  int different = 0;
  for (size_t i = 0; i < expected.Values.size(); i += components)
  {
    double sum = 0.0;
    for (int c = how.FirstComponent; c <= last; ++c)
    {
      sum += std::pow(image.Values[i + c] / how.Factor - expected.Values[i + c], 2.0);
    }
    different += std::sqrt(sum) <= tolerance * std::max(length(i), least) ? 0 : 1;
  }
  return static_cast<double>(different) * components / expected.Values.size();
}

namespace
{
// Adds something to a scene for as long as it exists. Its place and size are those of the scene's
// bounds; a scene without bounds gets nothing.
class Addition
{
public:
  Addition(Scene& scene, UserChoice::AdditionType type)
    : Where(scene)
  {
    double bounds[6];
    scene.Renderer->ComputeVisiblePropBounds(bounds);
    const glm::dvec3 lower(bounds[0], bounds[2], bounds[4]);
    const glm::dvec3 upper(bounds[1], bounds[3], bounds[5]);
    const double size = glm::length(upper - lower);
    if (!(size > 0.0) || !std::isfinite(size) || bounds[0] > bounds[1])
    {
      return;
    }
    if (type == UserChoice::SKY)
    {
      scene.Pass->SetEnvironment(this->Sky);
    }
    else if (type == UserChoice::GLASS)
    {
      this->Ball = scene.AddSphere(0.5 * (lower + upper), 0.1 * size, 12, glm::dvec3(1.0));
      this->Ball->GetProperty()->SetInterpolationToPBR();
      this->Ball->GetProperty()->SetRoughness(0.1);
      this->Ball->GetProperty()->SetOpacity(0.1);
      this->Ball->GetProperty()->SetBaseIOR(1.5);
    }
    else if (type != UserChoice::NOTHING)
    {
      // Its edges are half the scene's, and it shines down from above.
      const glm::dvec3 corner(lower.x, upper.y + 0.1 * size, lower.z);
      this->Lamp->SetOrigin(corner.x, corner.y, corner.z);
      this->Lamp->SetPoint1(corner.x + 0.5 * size, corner.y, corner.z);
      this->Lamp->SetPoint2(corner.x, corner.y, corner.z + 0.5 * size);
      this->Lamp->SetMethod(type == UserChoice::VIRTUAL_LIGHTS ? vtkAreaLight::VIRTUAL_LIGHTS
                                                               : vtkAreaLight::AUTOMATIC);
      scene.Pass->AddAreaLight(this->Lamp);
    }
  }
  ~Addition()
  {
    this->Where.Pass->SetEnvironment(nullptr);
    this->Where.Pass->RemoveAllAreaLights();
    if (this->Ball)
    {
      this->Where.Renderer->RemoveActor(this->Ball);
    }
  }

private:
  Scene& Where;
  vtkNew<vtkEnvironmentLight> Sky;
  vtkNew<vtkAreaLight> Lamp;
  vtkActor* Ball = nullptr;
};
}

//------------------------------------------------------------------------------
HardCase::HardCase(const std::string& name, int width, int height)
  : Scene(width, height)
  , Name(name)
{
  this->Pass->SetReflectiveShadowMapResolution(32);
  this->SetEye({ 2.2, 1.6, 2.3 }, { 0.4, 0.3, 0.4 }, { 0, 1, 0 }, 32, 0.5, 6);
}

void HardCase::AddCorner(const glm::dvec3& color)
{
  this->AddQuad({ 0, 0, 0 }, { 0, 0, 1 }, { 1, 0, 0 }, color);
  this->AddQuad({ 0, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, color);
  this->AddQuad({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, color);
}

vtkActor* HardCase::AddTriangles(const std::vector<glm::dvec3>& points,
  const std::vector<float>& normals, const std::vector<int>& corners, const glm::dvec3& color)
{
  vtkNew<vtkPolyData> data;
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const glm::dvec3& p : points)
  {
    places->InsertNextPoint(p.x, p.y, p.z);
  }
  data->SetPoints(places);
  vtkNew<vtkCellArray> cells;
  for (size_t i = 0; i + 2 < corners.size(); i += 3)
  {
    cells->InsertNextCell({ corners[i], corners[i + 1], corners[i + 2] });
  }
  data->SetPolys(cells);
  if (!normals.empty())
  {
    vtkNew<vtkFloatArray> array;
    array->SetNumberOfComponents(3);
    for (size_t i = 0; i < normals.size(); i += 3)
    {
      array->InsertNextTuple(&normals[i]);
    }
    data->GetPointData()->SetNormals(array);
  }
  vtkNew<vtkTrivialProducer> source;
  source->SetOutput(data);
  return this->AddSource(source, color);
}

//------------------------------------------------------------------------------
Image HardCase::Sum(int mode)
{
  vtkSmartPointer<vtkIndirectEstimatorPass> estimator = this->Pass->GetEstimator();
  vtkNew<vtkRSMReferencePass> reference;
  reference->SetMode(mode);
  this->Pass->SetEstimator(reference);
  this->Render();
  const Image image = this->Copy("irradiance");
  this->Pass->SetEstimator(estimator);
  return image;
}

void HardCase::CheckBuffersFit()
{
  const Image final = this->Copy("final");
  const Image direct = this->Copy("direct");
  const Image indirect = this->Copy("indirect");
  const Image irradiance = this->Copy("irradiance");
  const Image glossy = this->Copy("glossy");
  const Image albedo = this->Copy("albedo");
  const Image normal = this->Copy("normal");
  const Image depth = this->Copy("depth");
  int sums = 0;
  int products = 0;
  int normals = 0;
  int depths = 0;
  for (size_t i = 0; i < final.Values.size(); ++i)
  {
    const double sum = double(direct.Values[i]) + indirect.Values[i];
    sums += std::abs(final.Values[i] - sum) <= 1e-6 * sum ? 0 : 1;
    const double product = double(albedo.Values[i]) * irradiance.Values[i] + glossy.Values[i];
    // Below the least normal float, shaders may flush to zero.
    products += std::abs(indirect.Values[i] - product) <= 1e-6 * product + 1e-37 ? 0 : 1;
  }
  for (int i = 0; i < static_cast<int>(final.Values.size()); i += 3)
  {
    const double length = std::hypot(normal.Values[i], normal.Values[i + 1], normal.Values[i + 2]);
    const bool lit = length > 0.0;
    normals += lit && std::abs(length - 1.0) > 1e-5 ? 1 : 0;
    depths += lit && !(depth.At(i / 3 % depth.Width, i / 3 / depth.Width)[0] > 0.0f) ? 1 : 0;
  }
  CheckEqual("values of final that are not direct + indirect", sums, 0);
  CheckEqual("values of indirect that are not albedo * irradiance + glossy", products, 0);
  CheckEqual("normals that are neither zero nor unit vectors", normals, 0);
  CheckEqual("lit pixels without a depth", depths, 0);
}

//------------------------------------------------------------------------------
// Checks depth maps of the lights, after a frame without: each light counts fully or not at all.
void HardCase::CheckMaps(int numberOfMaps)
{
  const Image open = this->Copy("irradiance");
  this->Pass->SetVisibilityToMaps();
  this->Render();
  this->CheckBuffers(numberOfMaps);
  this->CheckBuffersFit();
  const Image seen = this->Copy("irradiance");
  int brighter = 0;
  for (size_t i = 0; this->NormalsAreDefined && i < open.Values.size(); ++i)
  {
    brighter += seen.Values[i] <= open.Values[i] * (1.0f + 1e-5f) ? 0 : 1;
  }
  CheckEqual("values that are larger where lights can be hidden", brighter, 0);
  this->Pass->SetVisibilityToNone();
}

//------------------------------------------------------------------------------
Image HardCase::CheckEstimators(
  int numberOfMaps, const std::function<void(const EstimatorEntry&)>& more)
{
  const Image truth = this->Sum(vtkRSMReferencePass::ALL_TEXELS);
  Comparison how;
  how.Least = this->Radiance;
  for (const EstimatorEntry& estimator : GetEstimators())
  {
    // Extreme numbers are as hard at every hint of a coarse grid as of a finer one.
    if (estimator.Name == std::string("hints, finer"))
    {
      continue;
    }
    const bool possible = numberOfMaps > 0 || !estimator.NeedsMaps;
    std::printf("       %s; %s%s\n", this->Name.c_str(), estimator.Name,
      possible ? "" : ": not, because it needs a map and this light has none");
    if (!possible)
    {
      continue;
    }
    estimator.Install(this->Pass, this->NumberOfLights);
    if (!this->NormalsAreDefined)
    {
      // Lights of this estimator change with each frame, so no other frame's sum can be compared.
      this->Render();
    }
    else if (estimator.Sum != EstimatorEntry::OTHER)
    {
      const bool all = estimator.Sum == EstimatorEntry::ALL_TEXELS;
      const Image expected = all ? truth : this->Sum(vtkRSMReferencePass::VIRTUAL_LIGHTS);
      this->Render();
      CheckAtMost("share of pixels that are not the sum in double precision",
        GetShareOfDifferent(this->Copy("irradiance"), expected, 1e-4, how), 1e-3,
        "1e-4: rounding of floats, largest where surfaces meet");
    }
    else
    {
      this->Render();
    }
    this->CheckBuffers(numberOfMaps);
    this->CheckBuffersFit();
    if (more)
    {
      more(estimator);
    }
    if (estimator.Sum == EstimatorEntry::LIGHTS)
    {
      this->CheckMaps(numberOfMaps);
    }
  }
  this->CheckUserChoices(numberOfMaps);
  return truth;
}

//------------------------------------------------------------------------------
void HardCase::CheckUserChoices(int numberOfMaps)
{
  // The first scene of a test gets all choices. Its further scenes mostly differ in one number, and
  // get three choices each in turn, because a frame takes most of a second.
  constexpr size_t Further = 3;
  static size_t scenes = 0;
  const size_t turn = scenes++;
  const std::vector<UserChoice>& choices = GetUserChoices();
  const size_t turns = (choices.size() + Further - 1) / Further;
  for (size_t i = 0; i < choices.size(); ++i)
  {
    const UserChoice& choice = choices[i];
    if ((numberOfMaps == 0 && choice.NeedsMaps) || (turn > 0 && i / Further != turn % turns))
    {
      continue;
    }
    std::printf("       %s; %s\n", this->Name.c_str(), choice.Name);
    choice.Install(this->Pass);
    {
      const Addition addition(*this, choice.Addition);
      this->Render();
    }
    this->CheckBuffers(0);
    this->CheckBuffersFit();
  }
  GetEstimators().back().Install(this->Pass, this->NumberOfLights);
}
}
