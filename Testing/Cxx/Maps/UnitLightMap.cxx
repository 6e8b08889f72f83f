// SPDX-License-Identifier: BSD-3-Clause
// Geometry of the lights' maps: cameras, depth ranges, culling.
#include "Capture/vtkIndirectFootprint.h"
#include "Maps/vtkIndirectLightMap.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkIndirectTestUtilities.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLCamera.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;

namespace
{
// A scene of a few boxes somewhere in the world, and a light near it.
struct RandomScene
{
  vtkIndirectFrame Frame;
  vtkIndirectLight Light;
  double Size;

  RandomScene(Random& random, double away)
  {
    this->Size = random.NextMagnitude(1e-3, 1e3);
    const glm::dvec3 center = random.NextDirection() * (away * this->Size);
    glm::dvec3 lower(1e300);
    glm::dvec3 upper(-1e300);
    for (int i = 0; i < 3; ++i)
    {
      vtkIndirectCaster caster;
      const glm::dvec3 c = center + random.NextDirection() * (0.5 * this->Size);
      for (int k = 0; k < 3; ++k)
      {
        // Every third box is flat in one direction.
        const double half = this->Size * (k == i ? 0.0 : random.Next(0.01, 0.3));
        caster.Bounds[2 * k] = c[k] - half;
        caster.Bounds[2 * k + 1] = c[k] + half;
        lower[k] = std::min(lower[k], c[k] - half);
        upper[k] = std::max(upper[k], c[k] + half);
      }
      this->Frame.Casters.push_back(caster);
    }
    this->Frame.SceneCenter = 0.5 * (lower + upper);
    this->Frame.SceneScale = 1.0 / glm::length(upper - lower);

    this->Light.Color = glm::dvec3(1.0);
    this->Light.DirectionWC = random.NextDirection();
    if (random.Next() < 0.2)
    {
      // Exactly along an axis.
      this->Light.DirectionWC = glm::dvec3(0.0);
      this->Light.DirectionWC[random.NextBits() % 3] = random.Next() < 0.5 ? 1.0 : -1.0;
    }
    this->Light.Positional = random.Next() < 0.75;
    this->Light.ConeAngle = random.Next() < 0.4
      ? random.Next(1.0, 60.0)
      : (random.Next() < 0.5 ? random.Next(60.1, 89.9) : 180.0);
    this->Light.PositionWC = center + random.NextDirection() * (this->Size * random.Next(0.0, 2.0));
  }
};

glm::dvec3 PointIn(Random& random, const double bounds[6])
{
  return { random.Next(bounds[0], bounds[1]), random.Next(bounds[2], bounds[3]),
    random.Next(bounds[4], bounds[5]) };
}

// True if a map of that projection shows a point of a face's view coordinates.
bool Shows(const vtkIndirectLightMap& map, const glm::dvec3& p)
{
  const bool parallel = map.Projection == vtkIndirectKernels::VTKI_MAP_PARALLEL;
  const double w = map.HalfWidth * (parallel ? 1.0 : -p.z);
  return -p.z > 0.0 && std::abs(p.x) <= w && std::abs(p.y) <= w;
}
}

VTK_INDIRECT_TEST(MapCameras)
{
  Random random(15);
  for (double away : { 0.0, 1e5 })
  {
    double worstView = 0.0;
    double worstImage = 0.0;
    double worstDepth = 0.0;
    double worstFace = 0.0;
    double worstAxis = 0.0;
    int faces = 0;
    for (int i = 0; i < 400; ++i)
    {
      RandomScene scene(random, away);
      scene.Frame.Parallel = i % 2 == 0;
      vtkIndirectLightMap map;
      map.Fit(scene.Frame, scene.Light);
      for (int face = 0; face < map.NumberOfFaces; ++face)
      {
        ++faces;
        vtkNew<vtkOpenGLCamera> camera;
        map.Faces[face].SetUp(camera, scene.Frame);
        const glm::dmat4 view = vtkIndirectFrame::ToGLM(camera->GetModelViewTransformMatrix());
        const glm::dmat4 projection =
          vtkIndirectFrame::ToGLM(camera->GetProjectionTransformMatrix(1.0, -1, 1));
        const glm::dmat4 sceneToFace = glm::inverse(map.Faces[face].GetToScene());
        const bool parallel = map.Projection == vtkIndirectKernels::VTKI_MAP_PARALLEL;
        for (int k = 0; k < 20; ++k)
        {
          const glm::dvec3 world =
            PointIn(random, scene.Frame.Casters[random.NextBits() % 3].Bounds);
          const glm::dvec4 inView = view * glm::dvec4(world, 1.0);
          const glm::dvec3 inScene = (world - scene.Frame.SceneCenter) * scene.Frame.SceneScale;
          const glm::dvec3 inFace = glm::dvec3(sceneToFace * glm::dvec4(inScene, 1.0));
          worstView =
            std::max(worstView, glm::length(glm::dvec3(inView) * scene.Frame.SceneScale - inFace));
          // By the light's frame, and by the shaders' kernel.
          const glm::dvec3 inLight =
            glm::dvec3(map.WorldToLight * glm::dvec4(world, 1.0)) * scene.Frame.SceneScale;
          const glm::dvec3 byKernel =
            glm::dvec3(vtkIndirectKernels::vtkiToFace(glm::vec3(inLight), face));
          worstFace =
            std::max(worstFace, glm::length(byKernel - inFace) / (1.0 + glm::length(inFace)));
          if (!Shows(map, inFace) || -inFace.z < map.Near)
          {
            continue;
          }
          const glm::dvec4 clip = projection * inView;
          const double w = map.HalfWidth * (parallel ? 1.0 : -inFace.z);
          worstImage =
            std::max(worstImage, glm::length(glm::dvec2(clip) / clip.w - glm::dvec2(inFace) / w));
          const double buffer = vtkIndirectKernels::vtkiDepthToBuffer(static_cast<float>(-inFace.z),
            static_cast<float>(map.Near), static_cast<float>(map.Far), parallel);
          worstDepth = std::max(worstDepth, std::abs(0.5 * clip.z / clip.w + 0.5 - buffer));
        }
        const glm::dvec3 axis = glm::dvec3(view * glm::dvec4(scene.Light.DirectionWC, 0.0));
        const glm::dvec3 inFace = glm::dmat3(sceneToFace) * scene.Light.DirectionWC;
        worstAxis = std::max(worstAxis, glm::length(axis - inFace));
      }
    }
    const std::string what = "away " + std::to_string(away) + ": ";
    // World coordinates 1e5 sizes away have steps of 1.5e-11 sizes; VTK's camera takes differences.
    const double steps = away > 0.0 ? 1e-9 : 1e-12;
    CheckAtMost(what + "camera's view against the face's", worstView, steps, "steps of doubles");
    CheckAtMost(what + "light frame and vtkiToFace against the face's", worstFace, 2e-7 + steps,
      "one rounding to float");
    CheckAtMost(what + "camera's image against the half width", worstImage, 1e3 * steps,
      "division by depths down to 1/1024 of the farthest");
    CheckAtMost(what + "camera's depth buffer against vtkiDepthToBuffer", worstDepth, 2e-6,
      "rounding of near, far and depth to float");
    CheckAtMost(what + "axis of the light", worstAxis, 1e3 * steps, "steps of doubles");
    CheckAtLeast(what + "faces tried", faces, 400, "the test's own power");
  }
}

VTK_INDIRECT_TEST(MapDepthRange)
{
  Random random(16);
  int beyond = 0;
  int before = 0;
  int aside = 0;
  int badRange = 0;
  int tried = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const RandomScene scene(random, i % 3 == 0 ? 1e5 : 0.0);
    vtkIndirectLightMap map;
    map.Fit(scene.Frame, scene.Light);
    const bool parallel = map.Projection == vtkIndirectKernels::VTKI_MAP_PARALLEL;
    badRange += !(map.Near >= 0.0 && map.Near < map.Far && std::isfinite(map.Far));
    badRange += !parallel && map.Near < map.Far / 1024.0 * (1.0 - 1e-12);
    for (int face = 0; face < map.NumberOfFaces; ++face)
    {
      const glm::dmat4 sceneToFace = glm::inverse(map.Faces[face].GetToScene());
      for (int k = 0; k < 50; ++k)
      {
        const glm::dvec3 world = PointIn(random, scene.Frame.Casters[k % 3].Bounds);
        const glm::dvec3 p = glm::dvec3(sceneToFace *
          glm::dvec4((world - scene.Frame.SceneCenter) * scene.Frame.SceneScale, 1.0));
        if (parallel)
        {
          aside += !Shows(map, p);
        }
        if (!Shows(map, p))
        {
          continue;
        }
        ++tried;
        beyond += -p.z > map.Far;
        // Surfaces nearer than this share of the farthest are left out of a map.
        before += -p.z < map.Near && -p.z > map.Far / 1024.0;
      }
    }
  }
  CheckEqual("ranges out of order", badRange, 0);
  CheckEqual("casters outside a parallel map", aside, 0);
  CheckEqual("casters beyond the far plane", beyond, 0);
  CheckEqual("casters before the near plane", before, 0);
  CheckAtLeast("points tried", tried, 10000, "the test's own power");
}

VTK_INDIRECT_TEST(MapCulling)
{
  Random random(17);
  int culledVisible = 0;
  int culled = 0;
  int kept = 0;
  int visible = 0;
  for (int i = 0; i < 2000; ++i)
  {
    const RandomScene scene(random, i % 3 == 0 ? 1e5 : 0.0);
    vtkIndirectLightMap map;
    map.Fit(scene.Frame, scene.Light);
    for (int face = 0; face < map.NumberOfFaces; ++face)
    {
      const glm::dmat4 sceneToFace = glm::inverse(map.Faces[face].GetToScene());
      for (int box = 0; box < 6; ++box)
      {
        double bounds[6];
        const glm::dvec3 c =
          scene.Frame.SceneCenter + random.NextDirection() * (random.Next(0.0, 2.0) * scene.Size);
        for (int k = 0; k < 3; ++k)
        {
          const double half = scene.Size * random.NextMagnitude(1e-3, 1.0);
          bounds[2 * k] = c[k] - half;
          bounds[2 * k + 1] = c[k] + half;
        }
        bool shown = false;
        for (int k = 0; k < 60 && !shown; ++k)
        {
          const glm::dvec3 world = PointIn(random, bounds);
          const glm::dvec3 p =
            glm::dvec3(sceneToFace * glm::dvec4(scene.Frame.ToScene(world), 1.0));
          shown = Shows(map, p) && -p.z >= map.Near;
        }
        const bool sees = map.Faces[face].CanSee(scene.Frame, bounds, 1 << 20);
        visible += shown;
        culled += !sees;
        kept += sees;
        culledVisible += shown && !sees;
      }
    }
  }
  CheckEqual("visible boxes that were culled", culledVisible, 0);
  CheckAtLeast("visible boxes tried", visible, 5000, "the test's own power");
  CheckAtLeast(
    "share of boxes culled", double(culled) / (culled + kept), 0.2, "culling does something");
  // The conservative test of all six sides keeps few boxes that no ray meets.
  CheckAtLeast(
    "share of kept boxes that are visible", double(visible) / kept, 0.5, "culling is sharp");
}

// Checks for all texels that rectangles contain a texel's centre or not.
VTK_INDIRECT_TEST(MapTexelCenters)
{
  Random random(17);
  const int texels = 16;
  int missed = 0;
  int held = 0;
  int kept = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const glm::dvec2 lower(random.Next(-1.2, 1.1), random.Next(-1.2, 1.1));
    const glm::dvec2 upper = lower + glm::dvec2(random.Next(0.0, 0.2), random.Next(0.0, 0.2));
    bool holds = false;
    for (int k = -8; k < 2 * texels; ++k)
    {
      for (int j = -8; j < 2 * texels; ++j)
      {
        const glm::dvec2 center = 2.0 * glm::dvec2(k + 0.5, j + 0.5) / double(texels) - 1.0;
        holds = holds ||
          (center.x >= lower.x && center.x <= upper.x && center.y >= lower.y &&
            center.y <= upper.y);
      }
    }
    const bool keeps = vtkIndirectFootprint::HasTexelCenter(lower, upper, glm::dvec2(texels));
    missed += holds && !keeps;
    held += holds;
    kept += keeps;
  }
  CheckEqual("rectangles with a centre that are left out", missed, 0);
  CheckAtLeast("rectangles with one", held, 500, "the test's own power");
  CheckAtMost("rectangles that are kept, over those", double(kept) / held, 1.4,
    "a sixteenth of a texel on each side, of rectangles of 0 to 1.6 texels");
}

VTK_INDIRECT_TEST(MapProjections)
{
  Random random(18);
  const RandomScene scene(random, 0.0);
  struct
  {
    double Cone;
    bool Positional;
    int Projection;
    int Faces;
  } cases[] = { { 1.0, true, 1, 1 }, { 60.0, true, 1, 1 }, { 60.01, true, 2, 5 },
    { 89.9, true, 2, 5 }, { 90.0, true, 2, 6 }, { 180.0, true, 2, 6 }, { 30.0, false, 0, 1 } };
  for (const auto& c : cases)
  {
    vtkIndirectLight light = scene.Light;
    light.PositionWC = scene.Frame.SceneCenter;
    light.Positional = c.Positional;
    light.ConeAngle = c.Cone;
    vtkIndirectLightMap map;
    map.Fit(scene.Frame, light);
    const std::string what = "cone " + std::to_string(c.Cone) + ": ";
    CheckEqual(what + "projection", map.Projection, c.Projection);
    CheckEqual(what + "faces", map.NumberOfFaces, c.Faces);
    if (c.Projection == 1)
    {
      CheckRelative(what + "half width", map.HalfWidth,
        std::tan(vtkMath::RadiansFromDegrees(c.Cone)), 1e-12, "definition");
    }
  }
  // From outside, one face aimed at the scene: it contains the scene, and is no wider than
  // necessary.
  for (int i = 0; i < 200; ++i)
  {
    const RandomScene other(random, 0.0);
    const double distance = random.NextMagnitude(1.5, 1e6);
    vtkIndirectLight light = other.Light;
    light.Positional = true;
    light.ConeAngle = random.Next(50.0, 180.0);
    light.PositionWC =
      other.Frame.SceneCenter + random.NextDirection() * (distance / other.Frame.SceneScale);
    vtkIndirectLightMap map;
    map.Fit(other.Frame, light);
    int outside = 0;
    for (const vtkIndirectCaster& caster : other.Frame.Casters)
    {
      for (int k = 0; k < 8; ++k)
      {
        const glm::dvec4 corner(caster.Bounds[k & 1], caster.Bounds[2 + ((k >> 1) & 1)],
          caster.Bounds[4 + ((k >> 2) & 1)], 1.0);
        const glm::dvec3 p = other.Frame.SceneScale * glm::dvec3(map.WorldToLight * corner);
        const double across = glm::length(glm::dvec2(p)) / -p.z;
        outside += across <= map.HalfWidth && -p.z >= map.Near && -p.z <= map.Far ? 0 : 1;
      }
    }
    const std::string what = std::to_string(distance) + " sizes away: ";
    CheckEqual(what + "faces", map.NumberOfFaces, 1);
    CheckEqual(what + "corners outside of the map", outside, 0);
    CheckRelative(what + "half width", map.HalfWidth,
      0.505 / std::sqrt(distance * distance - 0.505 * 0.505), 1e-9, "sphere around it, and 1 %");
  }
}

VTK_INDIRECT_TEST(IntervalsWithoutLength)
{
  const vtkIndirectInterval flat = vtkIndirectInterval::Find(0.0, 0.0, 0.0);
  CheckEqual("half of an interval of a flat scene", flat.Half, 0.0);
  CheckEqual("the middle", flat.Middle, 0.0);
  const vtkIndirectInterval point = vtkIndirectInterval::Find(0.3, 0.3, 1.0, 0.0, 0.8);
  CheckAtMost("half of an interval around a point", point.Half, 1e-7, "2^-24 of the map");
  CheckAbsolute("its middle", point.Middle, 0.3, 1e-7, "a quarter of its half width");
}

VTK_INDIRECT_TEST(MapWindow)
{
  // The eye sees a small part of each scene: the window holds this part, has texels as fine as the
  // pixels need, or as fine as its size allows, and stays where it is when the part moves a little.
  Random random(61);
  constexpr int texels = 512;
  int windows = 0;
  int kept = 0;
  int onCubes = 0;
  int tooWide = 0;
  double widestOfAll = 0.0;
  for (int run = 0; run < 400; ++run)
  {
    RandomScene scene(random, 0.0);
    vtkIndirectLightMap map;
    map.Fit(scene.Frame, scene.Light);
    if (map.Projection == vtkIndirectKernels::VTKI_MAP_FACES)
    {
      map.FitWindow(scene.Frame, texels);
      onCubes += map.Window.HalfWidth > 0.0 ? 1 : 0;
      continue;
    }
    const double size = random.NextMagnitude(1e-3, 0.3);
    const glm::dvec3 middle = scene.Frame.ToScene(PointIn(random, scene.Frame.Casters[0].Bounds));
    auto look = [&](const glm::dvec3& from)
    {
      scene.Frame.Seen = {};
      Random places(run);
      for (int i = 0; i < 1000; ++i)
      {
        scene.Frame.Seen.Places.push_back(
          { from + places.NextDirection() * (0.5 * size * places.Next()), size / 300.0 });
      }
      map.FitWindow(scene.Frame, texels);
      return map.Window;
    };
    const vtkIndirectShadowMap::WindowType window = look(middle);
    if (window.HalfWidth == 0.0)
    {
      continue;
    }
    ++windows;
    tooWide += window.HalfWidth > 0.5 * map.HalfWidth ? 1 : 0;
    const vtkIndirectDepthTile view = map.GetView(map.NumberOfFaces);
    double widest = 0.0; // texel over pixel
    for (const vtkIndirectSeen::Place& place : scene.Frame.Seen.Places)
    {
      const glm::dvec3 p = view.ToView(place.At);
      const double scale = view.Parallel ? 1.0 : p.z;
      const glm::dvec2 at = glm::dvec2(p) / scale - view.Middle;
      const bool inMap =
        map.Light.Positional ? std::max(std::abs(p.x), std::abs(p.y)) <= map.HalfWidth * p.z : true;
      if (inMap && std::max(std::abs(at.x), std::abs(at.y)) <= window.HalfWidth)
      {
        widest = std::max(widest, 2.0 * window.HalfWidth / texels * scale / place.Pixel);
      }
    }
    widestOfAll = map.Light.Positional ? widestOfAll : std::max(widestOfAll, widest);
    const vtkIndirectShadowMap::WindowType next =
      look(middle + random.NextDirection() * (1e-3 * size));
    kept += next.HalfWidth == window.HalfWidth && next.Middle == window.Middle ? 1 : 0;
  }
  CheckEqual("windows on the faces of cubes", onCubes, 0);
  CheckEqual("windows wider than half of their map", tooWide, 0);
  CheckAtMost("widest texel of a sun's window over a pixel", widestOfAll, 1.5,
    "WidestTexel; of a spot's window the nearest places decide");
  CheckAtLeast("windows", windows, 60, "more than half of the maps have one face, of small parts");
  CheckAtLeast("windows kept after a small move", kept, 0.95 * windows,
    "a step is an eighth of a window, the move a 2000th");
}
