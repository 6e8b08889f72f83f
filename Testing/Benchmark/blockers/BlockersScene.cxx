// SPDX-License-Identifier: BSD-3-Clause
#include "BlockersScene.h"

#include "Visibility/vtkIndirectSightLines.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <fstream>

using vtkIndirectTest::Random;

namespace
{
std::vector<double> ReadNumbers(const std::string& name)
{
  std::ifstream file(name, std::ios::binary | std::ios::ate);
  std::vector<double> numbers(file ? static_cast<size_t>(file.tellg()) / sizeof(double) : 0);
  file.seekg(0);
  file.read(reinterpret_cast<char*>(numbers.data()),
    static_cast<std::streamsize>(numbers.size() * sizeof(double)));
  return numbers;
}

const glm::dvec3 ToEye = glm::normalize(glm::dvec3(0.4, 0.35, 0.85));

glm::dvec3 Turn(const glm::dvec3& p, double angle)
{
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return { c * p.x + s * p.z, p.y, c * p.z - s * p.x };
}
}

//------------------------------------------------------------------------------
bool BlockersScene::Read(const std::string& spheres, const std::string& triangles)
{
  const std::vector<double> s = ReadNumbers(spheres);
  for (size_t i = 0; i + 3 < s.size(); i += 4)
  {
    this->Spheres.emplace_back(s[i], s[i + 1], s[i + 2], s[i + 3]);
  }
  const std::vector<double> t = triangles.empty() ? std::vector<double>() : ReadNumbers(triangles);
  for (size_t i = 0; i + 8 < t.size(); i += 9)
  {
    this->Triangles.push_back({ glm::dvec3(t[i], t[i + 1], t[i + 2]),
      glm::dvec3(t[i + 3], t[i + 4], t[i + 5]), glm::dvec3(t[i + 6], t[i + 7], t[i + 8]) });
  }
  this->HasMesh = !this->Triangles.empty();
  if (this->Spheres.empty() || (!triangles.empty() && !this->HasMesh))
  {
    return false;
  }
  // To scene units.
  glm::dvec3 lower(1e300);
  glm::dvec3 upper(-1e300);
  auto include = [&](const glm::dvec3& p, double radius)
  {
    lower = glm::min(lower, p - radius);
    upper = glm::max(upper, p + radius);
  };
  for (const Triangle& triangle : this->Triangles)
  {
    for (const glm::dvec3& corner : triangle)
    {
      include(corner, 0.0);
    }
  }
  for (const glm::dvec4& sphere : this->Spheres)
  {
    if (!this->HasMesh)
    {
      include(glm::dvec3(sphere), sphere.w);
    }
  }
  const glm::dvec3 center = 0.5 * (lower + upper);
  const double scale = 1.0 / glm::length(upper - lower);
  for (glm::dvec4& sphere : this->Spheres)
  {
    sphere = glm::dvec4(scale * (glm::dvec3(sphere) - center), scale * sphere.w);
  }
  for (Triangle& triangle : this->Triangles)
  {
    for (glm::dvec3& corner : triangle)
    {
      corner = scale * (corner - center);
    }
  }
  this->Lower = scale * (lower - center);
  this->Upper = scale * (upper - center);
  double area = 0.0;
  if (this->HasMesh)
  {
    for (const Triangle& t3 : this->Triangles)
    {
      this->Tree.Add(t3.data());
      area += 0.5 * glm::length(glm::cross(t3[1] - t3[0], t3[2] - t3[0]));
      this->Areas.push_back(area);
    }
    this->Tree.Finish();
  }
  else
  {
    for (const glm::dvec4& sphere : this->Spheres)
    {
      area += 4.0 * vtkMath::Pi() * sphere.w * sphere.w;
      this->Areas.push_back(area);
    }
    this->Tessellate();
  }
  return true;
}

//------------------------------------------------------------------------------
// As vtkSphereSource does with 12 meridians and 7 circles, poles included.
void BlockersScene::Tessellate()
{
  constexpr int meridians = 12;
  constexpr int bands = 6;
  auto at = [](int i, int j)
  {
    const double theta = vtkMath::Pi() * j / bands;
    const double phi = 2.0 * vtkMath::Pi() * i / meridians;
    return glm::dvec3(
      std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
  };
  std::vector<Triangle> unit;
  for (int j = 0; j < bands; ++j)
  {
    for (int i = 0; i < meridians; ++i)
    {
      if (j > 0)
      {
        unit.push_back({ at(i, j), at(i + 1, j), at(i, j + 1) });
      }
      if (j + 1 < bands)
      {
        unit.push_back({ at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
      }
    }
  }
  for (const glm::dvec4& sphere : this->Spheres)
  {
    for (const Triangle& t : unit)
    {
      const glm::dvec3 center(sphere);
      this->Triangles.push_back(
        { center + sphere.w * t[0], center + sphere.w * t[1], center + sphere.w * t[2] });
    }
  }
}

//------------------------------------------------------------------------------
std::vector<glm::dvec4> BlockersScene::TurnSpheres(double angle) const
{
  std::vector<glm::dvec4> turned;
  for (const glm::dvec4& sphere : this->Spheres)
  {
    turned.emplace_back(Turn(glm::dvec3(sphere), angle), sphere.w);
  }
  return turned;
}

//------------------------------------------------------------------------------
std::vector<BlockersScene::Triangle> BlockersScene::TurnTriangles(double angle) const
{
  std::vector<Triangle> turned = this->Triangles;
  for (Triangle& triangle : turned)
  {
    for (glm::dvec3& corner : triangle)
    {
      corner = Turn(corner, angle);
    }
  }
  return turned;
}

//------------------------------------------------------------------------------
bool BlockersScene::IsFree(const glm::dvec3& start, const glm::dvec3& end) const
{
  if (this->HasMesh)
  {
    return !this->Tree.IsBlocked(start, end);
  }
  const glm::dvec3 along = end - start;
  const double length2 = glm::dot(along, along);
  for (const glm::dvec4& sphere : this->Spheres)
  {
    const glm::dvec3 away = start - glm::dvec3(sphere);
    const double c = glm::dot(away, away) - sphere.w * sphere.w;
    const double b = glm::dot(away, along);
    if (b < 0.0 && b + length2 > 0.0 && b * b > length2 * c)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
double BlockersScene::FindDistance(
  const glm::dvec3& start, const glm::dvec3& direction, double most) const
{
  vtkIndirectTriangleTree::Hit hit;
  return this->Tree.FindNearest(start, direction, vtkIndirectTriangleTree::None, hit) &&
      hit.Distance < most
    ? hit.Distance
    : 0.0;
}

//------------------------------------------------------------------------------
BlockersPlace BlockersScene::DrawPlace(Random& random) const
{
  const double area = random.Next() * this->Areas.back();
  const size_t i = std::min<size_t>(
    std::lower_bound(this->Areas.begin(), this->Areas.end(), area) - this->Areas.begin(),
    this->Areas.size() - 1);
  if (!this->HasMesh)
  {
    const glm::dvec3 normal = random.NextDirection();
    const glm::dvec4& sphere = this->Spheres[i];
    return { glm::dvec3(sphere) + sphere.w * normal, normal, 0.0 };
  }
  const Triangle& t = this->Triangles[i];
  const double u = std::sqrt(random.Next());
  const double v = random.Next();
  return { (1.0 - u) * t[0] + u * (1.0 - v) * t[1] + u * v * t[2],
    glm::normalize(glm::cross(t[1] - t[0], t[2] - t[0])), 0.0 };
}

//------------------------------------------------------------------------------
// Places inside of other spheres are behind their surfaces, too.
bool BlockersScene::IsSeen(
  const glm::dvec3& position, const glm::dvec3& normal, const glm::dvec3& toEye) const
{
  const glm::dvec3 place = position + vtkIndirectSightLines::Lift * normal;
  if (!this->HasMesh)
  {
    for (const glm::dvec4& sphere : this->Spheres)
    {
      if (glm::length(place - glm::dvec3(sphere)) < sphere.w)
      {
        return false;
      }
    }
  }
  return this->IsFree(place, place + 3.0 * toEye);
}

//------------------------------------------------------------------------------
// area: all that they are seen as, across the way.
std::vector<BlockersPlace> BlockersScene::DrawSeen(
  Random& random, const glm::dvec3& toEye, int count, double& area) const
{
  std::vector<BlockersPlace> places;
  long tries = 0;
  while (static_cast<int>(places.size()) < count)
  {
    ++tries;
    BlockersPlace place = this->DrawPlace(random);
    place.Cosine = glm::dot(place.Normal, toEye);
    if (random.Next() < place.Cosine && this->IsSeen(place.Position, place.Normal, toEye))
    {
      places.push_back(place);
    }
  }
  area = this->Areas.back() * count / static_cast<double>(tries);
  return places;
}

//------------------------------------------------------------------------------
void BlockersScene::MakePairs(int receivers, int lights)
{
  Random random(2007);
  double area = 0.0;
  this->Receivers = this->DrawSeen(random, ToEye, receivers, area);
  this->Lights =
    this->DrawSeen(random, glm::normalize(glm::dvec3(-0.5, 0.8, 0.5)), lights, this->LitArea);
  for (int r = 0; r < receivers; ++r)
  {
    for (int l = 0; l < lights; ++l)
    {
      const BlockersPlace& receiver = this->Receivers[static_cast<size_t>(r)];
      const BlockersPlace& light = this->Lights[static_cast<size_t>(l)];
      const double weight = this->GetWeight(receiver, light);
      if (weight > 0.0)
      {
        const double lift = vtkIndirectSightLines::Lift;
        const bool visible = this->IsFree(
          receiver.Position + lift * receiver.Normal, light.Position + lift * light.Normal);
        this->Pairs.push_back({ r, l, weight, visible });
      }
    }
  }
}

//------------------------------------------------------------------------------
double BlockersScene::GetLightArea(const BlockersPlace& light) const
{
  return this->LitArea / (static_cast<double>(this->Lights.size()) * light.Cosine);
}

//------------------------------------------------------------------------------
// The disk kernel; all lights have the same flux.
double BlockersScene::GetWeight(const BlockersPlace& receiver, const BlockersPlace& light) const
{
  const glm::dvec3 way = light.Position - receiver.Position;
  const double atReceiver = glm::dot(receiver.Normal, way);
  const double atLight = -glm::dot(light.Normal, way);
  const double distance2 = glm::dot(way, way);
  return atReceiver > 0.0 && atLight > 0.0
    ? atReceiver * atLight / distance2 / (vtkMath::Pi() * distance2 + this->GetLightArea(light))
    : 0.0;
}

//------------------------------------------------------------------------------
std::vector<BlockersPlace> BlockersScene::MakePicture(int edge) const
{
  const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.0), ToEye));
  const glm::dvec3 up = glm::cross(ToEye, right);
  std::vector<BlockersPlace> picture;
  for (int y = 0; y < edge; ++y)
  {
    for (int x = 0; x < edge; ++x)
    {
      const glm::dvec3 place =
        0.4 * ((2.0 * (x + 0.5) / edge - 1.0) * right + (2.0 * (y + 0.5) / edge - 1.0) * up);
      BlockersPlace seen{ glm::dvec3(0.0), glm::dvec3(0.0), 0.0 };
      double nearest = -1e300;
      for (const glm::dvec4& sphere : this->Spheres)
      {
        const glm::dvec3 away = place - glm::dvec3(sphere);
        const double along = glm::dot(away, ToEye);
        const double root = sphere.w * sphere.w - glm::dot(away, away) + along * along;
        if (root > 0.0 && std::sqrt(root) - along > nearest)
        {
          nearest = std::sqrt(root) - along;
          seen.Position = place + nearest * ToEye;
          seen.Normal = glm::normalize(seen.Position - glm::dvec3(sphere));
          seen.Cosine = glm::dot(seen.Normal, ToEye);
        }
      }
      picture.push_back(seen);
    }
  }
  return picture;
}
