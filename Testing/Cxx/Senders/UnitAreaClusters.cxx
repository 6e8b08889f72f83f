// SPDX-License-Identifier: BSD-3-Clause
// Lights that represent a rectangle of pixels: its total light, at its positions.
#include "Emitters/vtkIndirectEmitterAccess.h"
#include "Senders/vtkIndirectAreaClusters.h"
#include "vtkAreaLight.h"
#include "vtkImageData.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace vtkIndirectTest;

namespace
{
using AreaClusters = vtkIndirectAreaClusters;

// Pixels of colours, on a rectangle of 2 by 1.
struct Picture
{
  int Columns;
  int Rows;
  std::vector<float> Radiances;

  Picture(int columns, int rows, const std::function<glm::dvec3(int, int)>& color)
    : Columns(columns)
    , Rows(rows)
  {
    for (int y = 0; y < rows; ++y)
    {
      for (int x = 0; x < columns; ++x)
      {
        const glm::dvec3 c = color(x, y);
        this->Radiances.insert(this->Radiances.end(),
          { static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z) });
      }
    }
  }

  AreaClusters::Image GetImage() const
  {
    AreaClusters::Image image;
    image.Corner = { 0.0, 0.0, 1.0 };
    image.Edge1 = { 2.0, 0.0, 0.0 };
    image.Edge2 = { 0.0, 1.0, 0.0 };
    image.Columns = this->Columns;
    image.Rows = this->Rows;
    image.Radiances = this->Radiances.data();
    return image;
  }

  glm::dvec3 Sum() const
  {
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < this->Radiances.size(); ++i)
    {
      sum[static_cast<int>(i % 3)] += this->Radiances[i];
    }
    return sum * 2.0 / (1.0 * this->Columns * this->Rows);
  }
};

std::vector<AreaClusters::Light> MakeLights(
  const std::vector<AreaClusters::Image>& images, int count)
{
  return AreaClusters::MakeLights(images, count, 0.0).Lights;
}

glm::dvec3 Sum(const std::vector<AreaClusters::Light>& lights)
{
  glm::dvec3 sum(0.0);
  for (const AreaClusters::Light& light : lights)
  {
    sum += light.DensityArea;
  }
  return sum;
}
}

VTK_INDIRECT_TEST(AreaClustersKeepTheLight)
{
  Random random(11);
  auto noise = [&random](int, int)
  { return glm::dvec3(random.Next(), random.Next(), std::pow(random.Next(), 8.0)); };
  const Picture pictures[] = { { 1, 1, [](int, int) { return glm::dvec3(1.0, 0.5, 0.25); } },
    { 8, 8, [](int x, int y) { return glm::dvec3((x + y) % 2, 0.3, 0.0); } },
    { 100, 60, [](int x, int) { return x < 37 ? glm::dvec3(4.0) : glm::dvec3(0.0, 0.01, 0.0); } },
    { 300, 200,
      [](int x, int y) { return x == 123 && y == 45 ? glm::dvec3(1e4) : glm::dvec3(0.0); } },
    { 640, 480, noise }, { 1030, 7, noise } };
  for (const Picture& picture : pictures)
  {
    const std::string name =
      std::to_string(picture.Columns) + " x " + std::to_string(picture.Rows) + ": ";
    for (const int count : { 1, 16, 256 })
    {
      for (const bool minMax : { false, true })
      {
        const std::vector<AreaClusters::Light> lights = minMax
          ? AreaClusters::MakeMinMaxLights({ picture.GetImage() }, count)
          : MakeLights({ picture.GetImage() }, count);
        CheckAtMost(name + (minMax ? "squares of " : "lights of ") + std::to_string(count),
          static_cast<double>(lights.size()), count, "as asked for");
        const glm::dvec3 sum = Sum(lights);
        const glm::dvec3 all = picture.Sum();
        for (int c = 0; c < 3; ++c)
        {
          CheckAbsolute(name + "light", sum[c], all[c], 1e-10 * (all.x + all.y + all.z),
            "rounding of sums in double precision");
        }
      }
    }
  }
}

VTK_INDIRECT_TEST(AreaClustersAreWhereTheLightIs)
{
  // Even radiance: pieces of equal size, as nearly square as halving allows.
  const Picture even(1, 1, [](int, int) { return glm::dvec3(3.0); });
  std::vector<AreaClusters::Light> lights = MakeLights({ even.GetImage() }, 128);
  CheckEqual("pieces of a rectangle", static_cast<double>(lights.size()), 128);
  double worst = 0.0;
  for (const AreaClusters::Light& light : lights)
  {
    worst = std::max(worst, std::abs(light.Area / (2.0 / 128.0) - 1.0));
    // Middles of a grid of 16 by 8.
    const glm::dvec2 place = glm::dvec2(light.Position) * 8.0;
    worst = std::max(worst, std::abs(place.x - std::floor(place.x) - 0.5));
    worst = std::max(worst, std::abs(place.y - std::floor(place.y) - 0.5));
    worst = std::max(worst, std::abs(light.Position.z - 1.0) + std::abs(light.Normal.z - 1.0));
  }
  CheckAtMost("a grid of squares", worst, 1e-9, "rounding of sums of 4096");

  // A single bright pixel is one light of its own size, for any number of lights.
  const Picture spark(
    300, 200, [](int x, int y) { return glm::dvec3(x == 123 && y == 45 ? 7.0 : 0.0); });
  lights = MakeLights({ spark.GetImage() }, 256);
  CheckEqual("a bright pixel", static_cast<double>(lights.size()), 1);
  CheckAbsolute("its place", lights[0].Position.x, 2.0 * 123.5 / 300.0, 1e-9, "rounding");
  CheckAbsolute("its row", lights[0].Position.y, 45.5 / 200.0, 1e-9, "rounding");
  CheckRelative("its area", lights[0].Area, 2.0 / 60000.0, 1e-9, "rounding");
  lights = MakeLights({ spark.GetImage() }, 1);
  CheckRelative("and by itself in a dark piece", lights[0].Area, 2.0 / 60000.0, 1e-9, "rounding");

  // A step: light comes only from the bright side.
  const Picture step(100, 60, [](int x, int) { return glm::dvec3(x < 25 ? 1.0 : 0.0); });
  for (const AreaClusters::Light& light : MakeLights({ step.GetImage() }, 64))
  {
    Check("the bright side", light.Position.x < 0.5);
  }

  // If half is a hundred times as bright, it has most of the lights.
  const Picture uneven(64, 64, [](int x, int) { return glm::dvec3(x < 32 ? 1.0 : 0.01); });
  lights = MakeLights({ uneven.GetImage() }, 256);
  const auto bright = std::count_if(lights.begin(), lights.end(),
    [](const AreaClusters::Light& light) { return light.Position.x < 1.0; });
  CheckAtLeast("lights of the brighter half", static_cast<double>(bright), 200,
    "squared edges go with the square root of the radiance: 10 to 1 would be 233");
}

// Each generation of branches holds the light of the node above it, and lies within it.
VTK_INDIRECT_TEST(AreaClustersHaveBranches)
{
  constexpr size_t perNode = 8;
  constexpr size_t all = perNode * (perNode + 1);
  const Picture picture(50, 40, [](int x, int y) { return glm::dvec3(1 + x % 7, y % 3, 0.5); });
  AreaClusters::Image image = picture.GetImage();
  image.TwoSided = true;
  const AreaClusters::LightTree tree = AreaClusters::MakeLights({ image }, 32, 1e-4);
  CheckEqual("lights", static_cast<double>(tree.Lights.size()), 32);
  CheckEqual("branches", static_cast<double>(tree.Branches.size()), 32.0 * all);
  double worst = 0.0;
  int families = 0;
  auto add = [&](const AreaClusters::Light& node, const AreaClusters::Light* first, size_t step)
  {
    glm::dvec3 sum(0.0);
    glm::dvec3 place(0.0);
    for (size_t i = 0; i < perNode && first[i * step].ChildDistance >= 0.0; ++i)
    {
      const AreaClusters::Light& child = first[i * step];
      const double light = child.DensityArea.x + child.DensityArea.y + child.DensityArea.z;
      sum += child.DensityArea;
      place += light * child.Position;
      worst = std::max(worst, glm::length(child.Normal - node.Normal));
      CheckAtMost("distance", child.ChildDistance, node.ChildDistance, "it falls with the light");
    }
    const double light = sum.x + sum.y + sum.z;
    worst = std::max(worst, glm::length(sum - node.DensityArea) / light);
    worst = std::max(worst, glm::length(place / light - node.Position));
    ++families;
  };
  for (size_t i = 0; i < tree.Lights.size(); ++i)
  {
    const AreaClusters::Light* const branches = &tree.Branches[i * all];
    Check("a light divides", tree.Lights[i].ChildDistance > 0.0);
    add(tree.Lights[i], branches, perNode + 1);
    for (size_t k = 0; k < perNode; ++k)
    {
      if (branches[k * (perNode + 1)].ChildDistance > 0.0)
      {
        add(branches[k * (perNode + 1)], branches + k * (perNode + 1) + 1, 1);
      }
    }
  }
  CheckAtMost("light, place and normal of families", worst, 1e-9, "rounding of sums");
  CheckAtLeast("families", families, 64, "children divide, too");
}

// Squares are small along an edge of the picture's, and as large as can be elsewhere.
VTK_INDIRECT_TEST(AreaClustersByMinAndMax)
{
  const Picture step(64, 64, [](int x, int) { return glm::dvec3(x < 21 ? 1.0 : 0.25); });
  const std::vector<AreaClusters::Light> lights =
    AreaClusters::MakeMinMaxLights({ step.GetImage() }, 512);
  double nearest = 0.0;
  double farthest = 1e9;
  double area = 0.0;
  for (const AreaClusters::Light& light : lights)
  {
    // The edge is at column 21, and blocks of 16 columns around it end at 16 and 32.
    const double column = light.Position.x * 32.0;
    const bool atEdge = column > 20.0 && column < 22.0;
    nearest = atEdge ? std::max(nearest, light.Area) : nearest;
    farthest = column > 32.0 ? std::min(farthest, light.Area) : farthest;
    area += light.Area;
  }
  const double cell = 2.0 / 4096.0;
  CheckRelative("at the edge cells", nearest, cell, 1e-9, "rounding");
  CheckRelative("elsewhere an eighth of the edge", farthest, 64.0 * cell, 1e-9, "rounding");
  CheckRelative("areas", area, 2.0, 1e-9, "squares of one radiance cover the rectangle");

  const Picture even(1, 1, [](int, int) { return glm::dvec3(1.0); });
  CheckEqual("one radiance",
    static_cast<double>(AreaClusters::MakeMinMaxLights({ even.GetImage() }, 256).size()), 64);
  AreaClusters::Image image = even.GetImage();
  image.TwoSided = true;
  CheckEqual("both sides",
    static_cast<double>(AreaClusters::MakeMinMaxLights({ image, even.GetImage() }, 256).size()),
    48);
  CheckEqual("one for each side",
    static_cast<double>(AreaClusters::MakeMinMaxLights({ image, even.GetImage() }, 1).size()), 3);
  CheckEqual("none", static_cast<double>(AreaClusters::MakeMinMaxLights({}, 64).size()), 0);
}

VTK_INDIRECT_TEST(AreaClustersOfSeveral)
{
  const Picture white(1, 1, [](int, int) { return glm::dvec3(1.0); });
  const Picture dark(16, 16, [](int, int) { return glm::dvec3(0.0); });
  AreaClusters::Image one = white.GetImage();
  AreaClusters::Image large = one;
  large.Edge1 *= 4.0;
  AreaClusters::Image flat = one;
  flat.Edge2 = 3.0 * flat.Edge1;
  CheckEqual("dark ones, and those without an area",
    static_cast<double>(MakeLights({ dark.GetImage(), flat }, 64).size()), 0);
  CheckEqual("none", static_cast<double>(MakeLights({}, 64).size()), 0);
  std::vector<AreaClusters::Light> lights = MakeLights({ one, large }, 2);
  CheckEqual("one each at least", static_cast<double>(lights.size()), 2);
  CheckEqual("even where there are to be fewer",
    static_cast<double>(MakeLights({ one, large }, 1).size()), 2);

  one.TwoSided = true;
  lights = MakeLights({ one }, 64);
  CheckEqual("of two sides", static_cast<double>(lights.size()), 64);
  double up = 0.0;
  for (const AreaClusters::Light& light : lights)
  {
    up += light.Normal.z * light.DensityArea.x;
  }
  CheckAbsolute("to either side the same", up, 0.0, 1e-12, "rounding");
  CheckRelative("each side sends the radiance", Sum(lights).x, 2.0 * 2.0, 1e-12, "rounding");
}

VTK_INDIRECT_TEST(AreaLightReadsImages)
{
  vtkNew<vtkAreaLight> light;
  light->SetOrigin(1.0, 0.0, 0.0);
  light->SetPoint1(3.0, 0.0, 0.0);
  light->SetPoint2(1.0, 3.0, 0.0);
  double normal[3];
  light->GetNormal(normal);
  Check("it sends light along the product of its edges",
    normal[0] == 0.0 && normal[1] == 0.0 && normal[2] == 1.0);
  CheckEqual("area", light->GetArea(), 6.0);
  int columns = 0;
  int rows = 0;
  light->SetRadiance(1.0, 2.0, 3.0);
  light->SetScale(2.0);
  CheckEqual("without an image one radiance",
    vtkIndirectEmitterAccess::GetRadiances(light, columns, rows)[1], 4.0);
  Check("of one piece", columns == 1 && rows == 1);

  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 2, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  for (int i = 0; i < 6; ++i)
  {
    image->SetScalarComponentFromDouble(i % 3, i / 3, 0, 0, i == 4 ? 255.0 : 0.0);
  }
  light->SetImage(image);
  const std::vector<float>& radiances =
    vtkIndirectEmitterAccess::GetRadiances(light, columns, rows);
  Check("as many pieces as pixels", columns == 3 && rows == 2 && radiances.size() == 18);
  CheckEqual("bytes are parts of 255, times Radiance and Scale", radiances[3 * 4 + 2], 6.0);
  double mean[3];
  light->GetMeanRadiance(mean);
  CheckRelative("mean", mean[1], 4.0 / 6.0, 1e-7, "floats");
  const vtkMTimeType before = light->GetMTime();
  image->SetScalarComponentFromDouble(0, 0, 0, 0, 255.0);
  image->Modified();
  Check("a change of the image is one of the light", light->GetMTime() > before);
  CheckEqual("and is read", vtkIndirectEmitterAccess::GetRadiances(light, columns, rows)[0], 2.0);
}
