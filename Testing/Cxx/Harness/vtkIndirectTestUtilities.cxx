// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIndirectTestUtilities.h"

#include "vtkIndirectEstimatorPass.h"

#include "Scene/vtkIndirectFrame.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkCamera.h"
#include "vtkCubeSource.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRSMGatherPass.h"
#include "vtkRegularPolygonSource.h"
#include "vtkRenderWindow.h"
#include "vtkSphereSource.h"
#include "vtkUniformLightSampler.h"
#ifdef VTK_INDIRECT_TEST_HEADLESS
#include "vtkEGLHeadlessRenderWindow.h"
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace vtkIndirectTest
{
namespace
{
bool Report(bool passed, const std::string& text, const std::string& origin)
{
  AddCheck();
  if (!passed)
  {
    AddFailure();
  }
  std::printf("%s %s%s%s%s\n", passed ? "  ok  " : "FAILED", text.c_str(),
    origin.empty() ? "" : " [", origin.c_str(), origin.empty() ? "" : "]");
  return passed;
}

std::string Format(const char* format, const std::string& what, double a, double b, double c)
{
  char text[512];
  std::snprintf(text, sizeof(text), format, what.c_str(), a, b, c);
  return text;
}
}

bool Check(const std::string& what, bool condition, const std::string& origin)
{
  return Report(condition, what, origin);
}

bool CheckEqual(const std::string& what, double measured, double expected)
{
  return Report(measured == expected,
    Format("%s: %.9g, expected exactly %.9g", what, measured, expected, 0.0), "");
}

bool CheckAbsolute(const std::string& what, double measured, double expected, double tolerance,
  const std::string& origin)
{
  return Report(std::abs(measured - expected) <= tolerance,
    Format("%s: %.9g, expected %.9g +- %.3g", what, measured, expected, tolerance), origin);
}

bool WouldPass(double measured, double expected, double tolerance)
{
  return std::abs(measured - expected) <= tolerance * std::abs(expected);
}

bool CheckRelative(const std::string& what, double measured, double expected, double tolerance,
  const std::string& origin)
{
  return Report(WouldPass(measured, expected, tolerance),
    Format("%s: %.9g, expected %.9g", what, measured, expected, 0.0) +
      Format("%s (%+.3e, allowed %.1e)", "", measured / expected - 1.0, tolerance, 0.0),
    origin);
}

bool CheckAtMost(const std::string& what, double measured, double limit, const std::string& origin)
{
  return Report(
    measured <= limit, Format("%s: %.6g, at most %.6g", what, measured, limit, 0.0), origin);
}

bool CheckAtLeast(const std::string& what, double measured, double limit, const std::string& origin)
{
  return Report(
    measured >= limit, Format("%s: %.6g, at least %.6g", what, measured, limit, 0.0), origin);
}

// Numbers -----------------------------------------------------------------------------------------
Random::Random(std::uint64_t seed)
{
  this->NextBits();
  this->State += seed;
  this->NextBits();
}

std::uint32_t Random::NextBits()
{
  const std::uint64_t old = this->State;
  this->State = old * 6364136223846793005ULL + 1442695040888963407ULL;
  const auto shifted = static_cast<std::uint32_t>(((old >> 18u) ^ old) >> 27u);
  const auto rotation = static_cast<std::uint32_t>(old >> 59u);
  return (shifted >> rotation) | (shifted << ((32u - rotation) & 31u));
}

double Random::Next(double lower, double upper)
{
  return lower + (upper - lower) * (this->NextBits() * (1.0 / 4294967296.0));
}

double Random::NextMagnitude(double lower, double upper)
{
  return lower * std::pow(upper / lower, this->Next());
}

glm::dvec3 Random::NextDirection()
{
  const double z = this->Next(-1.0, 1.0);
  const double phi = this->Next(0.0, 2.0 * vtkMath::Pi());
  const double r = std::sqrt(1.0 - z * z);
  return { r * std::cos(phi), r * std::sin(phi), z };
}

double Integrate(double lower, double upper, const std::function<double(double)>& f, int panels)
{
  // Abramowitz and Stegun, table 25.4, n = 16.
  static const double x[8] = { 0.0950125098376374, 0.2816035507792589, 0.4580167776572274,
    0.6178762444026438, 0.7554044083550030, 0.8656312023878318, 0.9445750230732326,
    0.9894009349916499 };
  static const double w[8] = { 0.1894506104550685, 0.1826034150449236, 0.1691565193950025,
    0.1495959888165767, 0.1246289712555339, 0.0951585116824928, 0.0622535239386479,
    0.0271524594117541 };
  const double half = 0.5 * (upper - lower) / panels;
  double sum = 0.0;
  for (int i = 0; i < panels; ++i)
  {
    const double center = lower + (2 * i + 1) * half;
    for (int k = 0; k < 8; ++k)
    {
      sum += w[k] * (f(center - half * x[k]) + f(center + half * x[k]));
    }
  }
  return sum * half;
}

double PolygonFormFactor(
  const glm::dvec3& position, const glm::dvec3& normal, const std::vector<glm::dvec3>& polygon)
{
  double sum = 0.0;
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3 a = glm::normalize(polygon[i] - position);
    const glm::dvec3 b = glm::normalize(polygon[(i + 1) % polygon.size()] - position);
    const glm::dvec3 c = glm::cross(a, b);
    const double sine = glm::length(c);
    if (sine > 0.0)
    {
      sum += std::atan2(sine, glm::dot(a, b)) * glm::dot(c / sine, normal);
    }
  }
  return std::abs(sum) / (2.0 * vtkMath::Pi());
}

double FacingSquaresFormFactor(double x)
{
  const double x2 = x * x;
  const double root = std::sqrt(1.0 + x2);
  return 2.0 / (vtkMath::Pi() * x2) *
    (0.5 * std::log((1.0 + x2) * (1.0 + x2) / (1.0 + 2.0 * x2)) +
      2.0 * x * root * std::atan(x / root) - 2.0 * x * std::atan(x));
}

double PerpendicularSquaresFormFactor()
{
  return (2.0 * std::atan(1.0) - std::sqrt(2.0) * std::atan(std::sqrt(0.5)) +
           0.25 * std::log(0.75)) /
    vtkMath::Pi();
}

double FacingDisksFormFactor(double radius1, double radius2)
{
  const double ratio = radius2 / radius1;
  const double x = 1.0 + (1.0 + radius2 * radius2) / (radius1 * radius1);
  return 0.5 * (x - std::sqrt(x * x - 4.0 * ratio * ratio));
}

double Percentile(std::vector<double>& values, double share)
{
  std::sort(values.begin(), values.end());
  const auto at = static_cast<size_t>(share * (values.size() - 1) + 0.5);
  return values.empty() ? NAN : values[at];
}

double Image::Mean(int component) const
{
  double sum = 0.0;
  for (size_t i = component; i < this->Values.size(); i += this->Components)
  {
    sum += this->Values[i];
  }
  return sum / (static_cast<double>(this->Width) * this->Height);
}

double FindRelativeError(const Image& image, const Image& expected, const Image& normal)
{
  double squares = 0.0;
  double sum = 0.0;
  double count = 0.0;
  for (int y = 0; y < image.Height; ++y)
  {
    for (int x = 0; x < image.Width; ++x)
    {
      if (normal.Color(x, y) != glm::dvec3(0.0))
      {
        const glm::dvec3 wanted = expected.Color(x, y);
        const glm::dvec3 difference = image.Color(x, y) - wanted;
        squares += glm::dot(difference, difference);
        sum += wanted.x + wanted.y + wanted.z;
        count += 3.0;
      }
    }
  }
  return std::sqrt(squares * count) / sum;
}

// Scenes ------------------------------------------------------------------------------------------
Scene::Scene(int width, int height)
{
#ifdef VTK_INDIRECT_TEST_HEADLESS
  if (!vtkEGLHeadlessRenderWindow::IsSupported())
  {
    Skip("no OpenGL without a display here");
  }
  this->Window = vtkSmartPointer<vtkEGLHeadlessRenderWindow>::New();
#else
  Skip("built without VTK::IndirectHeadless");
#endif
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->SetPass(this->Pass);
  this->Gather->SetModeToAllTexels();
  this->Gather->InterpolationOff();
  this->Pass->SetEstimator(this->Gather);
  this->Pass->SetSampler(this->Sampler);
  // Closed forms and sums in double precision do not include occlusion.
  this->Pass->SetVisibilityToNone();
  this->Pass->SetNumberOfBounces(1);
}

Scene::~Scene()
{
  if (this->Window)
  {
    this->Pass->ReleaseGraphicsResources(this->Window);
    this->Window->Finalize();
  }
}

vtkActor* Scene::AddSource(vtkAlgorithm* source, const glm::dvec3& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkProperty* property = actor->GetProperty();
  property->SetColor(color.x, color.y, color.z);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  this->Renderer->AddActor(actor);
  return actor;
}

vtkActor* Scene::AddQuad(const glm::dvec3& origin, const glm::dvec3& point1,
  const glm::dvec3& point2, const glm::dvec3& color)
{
  vtkNew<vtkPlaneSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetOrigin(origin.x, origin.y, origin.z);
  source->SetPoint1(point1.x, point1.y, point1.z);
  source->SetPoint2(point2.x, point2.y, point2.z);
  return this->AddSource(source, color);
}

vtkActor* Scene::AddSphere(
  const glm::dvec3& center, double radius, int resolution, const glm::dvec3& color)
{
  vtkNew<vtkSphereSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetCenter(center.x, center.y, center.z);
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  return this->AddSource(source, color);
}

vtkActor* Scene::AddBox(const glm::dvec3& lower, const glm::dvec3& upper, const glm::dvec3& color)
{
  vtkNew<vtkCubeSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetBounds(lower.x, upper.x, lower.y, upper.y, lower.z, upper.z);
  return this->AddSource(source, color);
}

vtkActor* Scene::AddDisk(const glm::dvec3& center, const glm::dvec3& normal, double radius,
  int sides, const glm::dvec3& color)
{
  vtkNew<vtkRegularPolygonSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->SetNumberOfSides(sides);
  source->SetRadius(radius);
  source->SetCenter(center.x, center.y, center.z);
  source->SetNormal(normal.x, normal.y, normal.z);
  source->GeneratePolylineOff();
  return this->AddSource(source, color);
}

vtkLight* Scene::AddPoint(const glm::dvec3& position, const glm::dvec3& attenuation)
{
  return this->AddSpot(position, position + glm::dvec3(0.0, 0.0, -1.0), 180.0, 0.0, attenuation);
}

vtkLight* Scene::AddSpot(const glm::dvec3& position, const glm::dvec3& target, double coneAngle,
  double exponent, const glm::dvec3& attenuation)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(true);
  light->SetPosition(position.x, position.y, position.z);
  light->SetFocalPoint(target.x, target.y, target.z);
  light->SetConeAngle(coneAngle);
  light->SetExponent(exponent);
  light->SetAttenuationValues(attenuation.x, attenuation.y, attenuation.z);
  light->SetColor(1.0, 1.0, 1.0);
  this->Renderer->AddLight(light);
  return light;
}

vtkLight* Scene::AddDirectional(const glm::dvec3& direction)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  light->SetPositional(false);
  light->SetPosition(0.0, 0.0, 0.0);
  light->SetFocalPoint(direction.x, direction.y, direction.z);
  light->SetColor(1.0, 1.0, 1.0);
  this->Renderer->AddLight(light);
  return light;
}

void Scene::SetIntensities(double intensity)
{
  vtkLightCollection* lights = this->Renderer->GetLights();
  for (int i = 0; i < lights->GetNumberOfItems(); ++i)
  {
    vtkLight::SafeDownCast(lights->GetItemAsObject(i))->SetIntensity(intensity);
  }
}

void Scene::SetEye(const glm::dvec3& position, const glm::dvec3& target, const glm::dvec3& up,
  double viewAngle, double nearPlane, double farPlane)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(position.x, position.y, position.z);
  camera->SetFocalPoint(target.x, target.y, target.z);
  camera->SetViewUp(up.x, up.y, up.z);
  camera->SetViewAngle(viewAngle);
  camera->SetClippingRange(nearPlane, farPlane);
}

void Scene::SetParallelEye(double scale)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->ParallelProjectionOn();
  camera->SetParallelScale(scale);
}

void Scene::Render()
{
  this->Window->Render();
}

Image Scene::Copy(const std::string& name)
{
  Image image;
  vtkNew<vtkImageData> data;
  if (!this->Pass->CopyBuffer(name, data))
  {
    Check("copies buffer " + name, false);
    // Later checks would read an empty image; one has failed, hence so has the test.
    Skip("no more to check");
  }
  image.Width = data->GetDimensions()[0];
  image.Height = data->GetDimensions()[1];
  image.Components = data->GetNumberOfScalarComponents();
  const auto* values = static_cast<const float*>(data->GetScalarPointer());
  image.Values.assign(
    values, values + static_cast<size_t>(image.Width) * image.Height * image.Components);
  return image;
}

std::vector<VirtualLight> Scene::CopyLights()
{
  const Image image = this->Copy("lights");
  std::vector<VirtualLight> lights;
  for (int i = 0; i < image.Height; ++i)
  {
    lights.push_back({ image.Color(0, i), image.At(0, i)[3], image.Color(1, i), image.Color(2, i),
      static_cast<int>(image.At(2, i)[3]) });
  }
  return lights;
}

glm::dvec3 Scene::GetReflectedFlux()
{
  glm::dvec3 sum(0.0);
  for (const VirtualLight& light : this->CopyLights())
  {
    sum += light.DensityArea;
  }
  return sum;
}

std::vector<Scene::Receiver> Scene::GetReceivers()
{
  const Image depth = this->Copy("depth");
  const Image normal = this->Copy("normal");
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const glm::dmat4 viewToWorld =
    glm::inverse(vtkIndirectFrame::ToGLM(camera->GetModelViewTransformMatrix()));
  const glm::dmat4 projection = vtkIndirectFrame::ToGLM(
    camera->GetProjectionTransformMatrix(this->Renderer->GetTiledAspectRatio(), -1, 1));
  const glm::dmat4 unproject = glm::inverse(projection);
  std::vector<Receiver> receivers;
  for (int y = 0; y < depth.Height; ++y)
  {
    for (int x = 0; x < depth.Width; ++x)
    {
      const double d = depth.At(x, y)[0];
      const glm::dvec4 clip = projection * glm::dvec4(0.0, 0.0, -d, 1.0);
      const glm::dvec4 view = unproject *
        glm::dvec4(2.0 * (x + 0.5) / depth.Width - 1.0, 2.0 * (y + 0.5) / depth.Height - 1.0,
          clip.z / clip.w, 1.0);
      const glm::dvec3 n = normal.Color(x, y);
      receivers.push_back({ glm::length(n) > 0.5,
        glm::dvec3(viewToWorld * glm::dvec4(glm::dvec3(view) / view.w, 1.0)), n, x, y });
    }
  }
  return receivers;
}

double Scene::ReadReport(const std::string& key)
{
  const std::string report = this->Pass->GetReport(false);
  const std::string name = "\"" + key + "\": ";
  const size_t at = report.find(name);
  return at == std::string::npos ? -1.0 : std::stod(report.substr(at + name.size()));
}

void Scene::CheckBuffers(int numberOfMaps)
{
  std::vector<std::string> names = { "final", "direct", "indirect", "irradiance", "glossy",
    "albedo", "normal", "depth" };
  // Estimators that read the maps directly have no virtual lights.
  if (this->ReadReport("virtual_lights") > 0.0)
  {
    names.push_back("lights");
  }
  for (int i = 0; i < numberOfMaps; ++i)
  {
    for (const char* channel : { ".depth", ".normal", ".density" })
    {
      names.push_back("rsm" + std::to_string(i) + channel);
    }
  }
  int bad = 0;
  for (const std::string& name : names)
  {
    const Image image = this->Copy(name);
    const bool signs = name.find("normal") != std::string::npos;
    int badHere = 0;
    for (int y = 0; y < image.Height; ++y)
    {
      for (int x = 0; x < image.Width; ++x)
      {
        for (int c = 0; c < image.Components; ++c)
        {
          const float v = image.At(x, y)[c];
          // In the buffer of lights only positions and normals have signs.
          const bool negative =
            v < 0.0f && !signs && (name != "lights" || (x == 0 && c == 3) || x == 2);
          badHere += !std::isfinite(v) || negative ? 1 : 0;
        }
      }
    }
    if (badHere)
    {
      std::printf("       %d of them in %s\n", badHere, name.c_str());
    }
    bad += badHere;
  }
  CheckEqual(
    "values in " + std::to_string(names.size()) + " buffers that are not finite or below zero", bad,
    0);
}

glm::dvec3 Gather(
  const std::vector<VirtualLight>& lights, const glm::dvec3& position, const glm::dvec3& normal)
{
  glm::dvec3 sum(0.0);
  for (const VirtualLight& light : lights)
  {
    const glm::dvec3 d = light.Position - position;
    const double r2 = glm::dot(d, d);
    const double sender = -glm::dot(light.Normal, d);
    const double receiver = glm::dot(normal, d);
    if (r2 > 0.0 && sender > 0.0 && receiver > 0.0)
    {
      sum += light.DensityArea * (sender * receiver / r2 / (vtkMath::Pi() * r2 + light.Area));
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
void CompareLight(Scene& scene, const std::string& buffer,
  const std::function<bool(const Scene::Receiver&)>& counts,
  const std::function<double(const Scene::Receiver&)>& expect, const LightTolerance& tolerance,
  const std::string& name)
{
  scene.Render();
  const Image light = scene.Copy(buffer);
  const std::vector<Scene::Receiver> receivers = scene.GetReceivers();
  double sum = 0.0;
  double expectedSum = 0.0;
  double squares = 0.0;
  int count = 0;
  for (size_t i = 0; i < receivers.size(); ++i)
  {
    if (!receivers[i].Lit || !counts(receivers[i]))
    {
      continue;
    }
    const double expected = expect(receivers[i]);
    const double measured = light.Values[3 * i];
    sum += measured;
    expectedSum += expected;
    squares += (measured - expected) * (measured - expected);
    ++count;
  }
  const std::string what = name.empty() ? buffer : name + ": " + buffer;
  Check("receivers are seen", count > 100, "a test of nothing passes");
  CheckRelative(what + ": mean", sum, expectedSum, tolerance.Mean, tolerance.Origin);
  CheckAtMost(what + ": RMS error over the mean", std::sqrt(squares * count) / expectedSum,
    tolerance.RMS, tolerance.Origin);
}
}
