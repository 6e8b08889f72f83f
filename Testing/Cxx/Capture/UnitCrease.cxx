// SPDX-License-Identifier: BSD-3-Clause
// The plane of a surface across a crease: what it hides from a receiver.
#include "OpenGL/vtkIndirectKernels.h"
#include "vtkIndirectTestUtilities.h"

#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

VTK_INDIRECT_TEST(CreaseHides)
{
  // A receiver over a floor that is turned at random. The oracle is the place where a segment from
  // the receiver meets the floor. Segments within rounding of a limit are left out.
  Random random(11);
  const double extent = 0.015;
  int wrong = 0;
  int hidden = 0;
  int counted = 0;
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec3 floor = random.NextDirection();
    const glm::dvec3 foot = 0.5 * random.NextDirection();
    const double height = 0.02 * random.Next();
    const glm::dvec3 position = foot + height * floor;
    const glm::dvec3 to = (i % 2 == 0 ? 0.05 : 0.5) * random.NextDirection();
    const vtkiCrease crease = { glm::vec3(floor), static_cast<float>(glm::dot(floor, foot)),
      static_cast<float>(extent * extent) };
    const double descent = -glm::dot(floor, to);
    const double behind = descent - height - VTKI_CREASE_MARGIN;
    const double away = descent > 0.0 ? height / descent * glm::length(to) : 1e30;
    if (std::abs(behind) < 1e-5 || std::abs(away / extent - 1.0) < 1e-3)
    {
      continue;
    }
    const bool expected = behind > 0.0 && away < extent;
    const bool measured = vtkiHidesInCrease(crease, glm::vec3(position), glm::vec3(to));
    ++counted;
    hidden += expected ? 1 : 0;
    wrong += measured != expected ? 1 : 0;
  }
  CheckEqual("answers that differ from the segment's place on the floor", wrong, 0);
  Check("a tenth to nine tenths are hidden", 10 * hidden > counted && 10 * hidden < 9 * counted,
    std::to_string(hidden) + " of " + std::to_string(counted));
  // Without a crease nothing is hidden.
  const vtkiCrease none = { glm::vec3(0.0f), 0.0f, 0.0f };
  Check("no crease hides nothing", !vtkiHidesInCrease(none, glm::vec3(0.3f), glm::vec3(0.1f)));
}

VTK_INDIRECT_TEST(CreaseMeets)
{
  const glm::vec3 floor(0.0f, 1.0f, 0.0f);
  const glm::vec3 wall(1.0f, 0.0f, 0.0f);
  // The receiver stands on the floor one unit before the wall.
  auto meets = [](const glm::vec3& facet, const glm::vec3& other, const glm::vec3& offset)
  { return vtkiMeetsInCrease(facet, other, offset, VTKI_CREASE_COSINE); };
  Check("a wall on a floor", meets(floor, wall, glm::vec3(-1.0f, 0.5f, 0.2f)));
  Check("the floor below a wall", meets(wall, floor, glm::vec3(1.0f, -0.5f, 0.2f)));
  Check("not the far side of a step", !meets(floor, wall, glm::vec3(1.0f, -0.5f, 0.0f)));
  Check("not the back of a wall", !meets(floor, wall, glm::vec3(1.0f, 0.5f, 0.0f)));
  Check("not the same floor", !meets(floor, floor, glm::vec3(1.0f, 0.0f, 0.0f)));
  const glm::vec3 slope = glm::normalize(glm::vec3(0.4f, 1.0f, 0.0f));
  const glm::vec3 up(-1.0f, 0.2f, 0.0f);
  Check("a slope is no wall", !meets(floor, slope, up));
  Check("a slope is a fold", vtkiMeetsInCrease(floor, slope, up, VTKI_FOLD_COSINE));
  Check("a roof is no fold", !vtkiMeetsInCrease(floor, slope, -up, VTKI_FOLD_COSINE));
  Check("facets of a curved surface are not flat",
    !vtkiIsFlat(floor, glm::normalize(glm::vec3(0.1f, 1.0f, 0.0f)), glm::vec3(1.0f, 0.0f, 0.0f)));
  Check("a plane is flat", vtkiIsFlat(floor, floor, glm::vec3(1.0f, 0.01f, 0.3f)));
}
