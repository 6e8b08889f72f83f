// SPDX-License-Identifier: BSD-3-Clause
// Small triangles that the processor draws into a depth map, against planes in double precision.
#include "Capture/vtkIndirectSmallTriangles.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>

using namespace vtkIndirectTest;

namespace
{
constexpr int Columns = 48;
constexpr int Rows = 32;
constexpr float Empty = 1.0f;

// A view whose clip coordinates, of points between -1 and 1, are those of a camera that looks along
// -z from a distance, or the points themselves.
glm::mat4 MakeView(bool perspective)
{
  return perspective ? glm::perspective(0.9f, 1.5f, 0.25f, 8.0f) *
      glm::translate(glm::mat4(1.0f), glm::vec3(0.0f, 0.0f, -2.0f))
                     : glm::mat4(1.0f);
}

// Returns a point's place in texels from the first centre, and its depth.
glm::dvec3 Place(const glm::mat4& view, const glm::vec3& point)
{
  const glm::dvec4 clip = glm::dmat4(view) * glm::dvec4(point, 1.0);
  const glm::dvec3 p = 0.5 * glm::dvec3(clip) / clip.w + 0.5;
  return { p.x * Columns - 0.5, p.y * Rows - 0.5, p.z };
}

// The distance of a place from the outside of a triangle, negative outside, and the depth there.
glm::dvec2 Ask(const glm::dvec3 corners[3], const glm::dvec2& place)
{
  const auto cross = [](const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; };
  const glm::dvec2 p[3] = { corners[0], corners[1], corners[2] };
  const double area = cross(p[1] - p[0], p[2] - p[0]);
  double inside = 1e30;
  double depth = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec2 edge = p[(i + 2) % 3] - p[(i + 1) % 3];
    const double part = cross(edge, place - p[(i + 1) % 3]) / area;
    inside = std::min(inside, part * std::abs(area) / glm::length(edge));
    depth += part * corners[i].z;
  }
  return { inside, depth };
}

glm::vec3 RandomPoint(Random& random)
{
  return glm::vec3(random.Next(-1.2, 1.2), random.Next(-1.2, 1.2), random.Next(-0.9, 0.9));
}
}

VTK_INDIRECT_TEST(SmallTrianglesHaveTheirDepths)
{
  // Each triangle alone: texels whose centres lie clearly inside have the depth of its plane, those
  // outside stay empty, and the choice takes the triangle wherever it covers a centre.
  Random random(5);
  vtkIndirectSmallTriangles small;
  int wrong = 0;
  int covered = 0;
  int missed = 0;
  int toOpenGL = 0;
  int chosenInVain = 0;
  double most = 0.0;
  for (int turn = 0; turn < 4000; ++turn)
  {
    const glm::mat4 view = MakeView(turn % 2 == 1);
    const glm::vec3 first = RandomPoint(random);
    const double size = random.NextMagnitude(0.01, 0.6);
    std::vector<glm::vec3> points = { first };
    glm::dvec3 corners[3];
    for (int i = 0; i < 2; ++i)
    {
      points.push_back(first + glm::vec3(size * random.NextDirection()) * glm::vec3(1, 1, 0.2f));
    }
    for (size_t i = 0; i < 3; ++i)
    {
      corners[i] = Place(view, points[i]);
    }
    small.SetView(view, glm::ivec2(Columns, Rows));
    small.Project(points);
    const unsigned int indices[3] = { 0, 1, 2 };
    std::vector<float> depths(Columns * Rows, Empty);
    std::vector<size_t> left;
    std::vector<unsigned int> chosen;
    small.Draw(indices, 3, depths.data(), left);
    small.Choose(indices, 3, chosen);
    toOpenGL += static_cast<int>(left.size());
    bool covers = false;
    for (int i = 0; i < Columns * Rows; ++i)
    {
      const glm::dvec2 asked = Ask(corners, glm::dvec2(i % Columns, i / Columns));
      const float depth = depths[static_cast<size_t>(i)];
      if (std::abs(asked.x) > 0.004) // corners are placed at steps of 1/256
      {
        wrong += (asked.x > 0.0) != (depth != Empty) ? 1 : 0;
      }
      if (depth != Empty)
      {
        covers = true;
        ++covered;
      }
      if (asked.x > 0.05)
      {
        most = std::max(most, std::abs(asked.y - depth));
      }
    }
    missed += covers && chosen.empty() ? 1 : 0;
    chosenInVain += !covers && !chosen.empty() ? 1 : 0;
  }
  CheckEqual("triangles left to OpenGL", toOpenGL, 0);
  CheckEqual("texels covered otherwise than by the triangle", wrong, 0);
  CheckEqual("triangles that the choice has missed", missed, 0);
  Check("most are covered or left out", covered > 5000 && chosenInVain < 1000,
    std::to_string(covered) + " texels, " + std::to_string(chosenInVain) + " chosen in vain");
  Check("depths", most < 1e-5, std::to_string(most));
}

VTK_INDIRECT_TEST(SmallTrianglesLeaveNoGap)
{
  // A net of triangles over the whole view, regular, with corners on centres, and with corners at
  // random: each centre belongs to one triangle.
  Random random(7);
  vtkIndirectSmallTriangles small;
  constexpr unsigned int n = 40;
  for (int turn = 0; turn < 4; ++turn)
  {
    std::vector<glm::vec3> points;
    std::vector<unsigned int> indices;
    for (unsigned int j = 0; j <= n; ++j)
    {
      for (unsigned int i = 0; i <= n; ++i)
      {
        const double jitter = turn < 2 ? 0.0 : 0.02;
        points.emplace_back(i * 2.6 / n - 1.3 + random.Next(-jitter, jitter),
          j * 2.6 / n - 1.3 + random.Next(-jitter, jitter), 0.0);
        if (turn == 1)
        {
          // Corners on centres.
          const glm::vec2 texels(Columns, Rows);
          const glm::vec2 at = glm::round(0.5f * texels * (glm::vec2(points.back()) + 1.0f)) + 0.5f;
          points.back() = glm::vec3(2.0f * at / texels - 1.0f, 0.0f);
        }
        if (i < n && j < n)
        {
          const unsigned int a = j * (n + 1) + i;
          indices.insert(indices.end(), { a, a + 1, a + n + 2, a, a + n + 2, a + n + 1 });
        }
      }
    }
    small.SetView(MakeView(false), glm::ivec2(Columns, Rows));
    small.Project(points);
    std::vector<int> count(Columns * Rows, 0);
    for (size_t i = 0; i < indices.size(); i += 3)
    {
      std::vector<float> depths(Columns * Rows, Empty);
      std::vector<size_t> left;
      small.Draw(&indices[i], 3, depths.data(), left);
      for (size_t k = 0; k < depths.size(); ++k)
      {
        count[k] += depths[k] != Empty ? 1 : 0;
      }
    }
    const auto other = std::count_if(count.begin(), count.end(), [](int c) { return c != 1; });
    CheckEqual("centres in no triangle or in several, turn " + std::to_string(turn),
      static_cast<int>(other), 0);
  }
}

VTK_INDIRECT_TEST(SmallTrianglesLeaveOthersToOpenGL)
{
  const glm::mat4 view = MakeView(true);
  vtkIndirectSmallTriangles small;
  small.SetView(view, glm::ivec2(200, 200));
  // A large one, one that the near plane cuts, one that passes the camera, one beyond the far
  // plane, one behind the camera, and one beside the view.
  small.Project({ { -0.9f, -0.9f, 0 }, { 0.9f, -0.9f, 0 }, { 0, 0.9f, 0 }, { 0, 0, 1.9f },
    { 0.01f, 0, 1.6f }, { 0, 0.01f, 1.6f }, { 0, 0, 2.5f }, { 0, 0.1f, -7 }, { 0.1f, 0, 2.5f },
    { 0, 0.1f, 2.6f }, { 40, 0, 0 }, { 41, 0, 0 }, { 40, 1, 0 } });
  const unsigned int indices[] = { 0, 1, 2, 3, 4, 5, 6, 4, 5, 4, 5, 7, 6, 8, 9, 10, 11, 12 };
  std::vector<float> depths(200 * 200, Empty);
  std::vector<size_t> left;
  small.Draw(indices, 18, depths.data(), left);
  Check("left are those that the near and the far plane cut and the large one",
    left == std::vector<size_t>({ 0, 3, 6, 9 }), std::to_string(left.size()));
  Check("nothing else is drawn",
    std::all_of(depths.begin(), depths.end(), [](float depth) { return depth == Empty; }));
}
