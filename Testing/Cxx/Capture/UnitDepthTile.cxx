// SPDX-License-Identifier: BSD-3-Clause
// Depth maps of single virtual lights and directions: their axes, their depths, and the planes of
// receivers in them.
#include "Capture/vtkIndirectDepthTile.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkIndirectTestUtilities.h"

#include <algorithm>
#include <cmath>

using namespace vtkIndirectTest;
using namespace vtkIndirectKernels;

namespace
{
vtkIndirectFrame MakeFrame(double scale)
{
  vtkIndirectFrame frame;
  frame.SceneScale = 1.0 / scale;
  frame.SceneCenter = glm::dvec3(3.0, -2.0, 5.0) * scale;
  vtkIndirectCaster caster;
  for (int i = 0; i < 3; ++i)
  {
    caster.Bounds[2 * i] = frame.SceneCenter[i] - 0.2 * (i + 1) * scale;
    caster.Bounds[2 * i + 1] = frame.SceneCenter[i] + 0.2 * (i + 1) * scale;
  }
  frame.Casters.push_back(caster);
  return frame;
}
}

VTK_INDIRECT_TEST(DepthTileAxes)
{
  Random random(7);
  double worst = 0.0;
  for (int i = 0; i < 10000; ++i)
  {
    glm::dvec3 n = random.NextDirection();
    n = i < 6 ? glm::dvec3(0.0) : n;
    if (i < 6)
    {
      n[i % 3] = i < 3 ? 1.0 : -1.0;
    }
    glm::vec3 x;
    glm::vec3 y;
    vtkiFrameAlong(glm::vec3(n), x, y);
    const glm::dvec3 right(x);
    const glm::dvec3 up(y);
    worst = std::max({ worst, std::abs(glm::dot(right, n)), std::abs(glm::dot(up, n)),
      std::abs(glm::dot(right, up)), std::abs(glm::length(right) - 1.0),
      glm::length(glm::cross(right, up) - n) });
  }
  CheckAtMost("axes are unit, at right angles and right-handed", worst, 1e-6, "rounding of floats");
}

VTK_INDIRECT_TEST(DepthTileDepths)
{
  double worst = 0.0;
  for (double depth = VTKI_TILE_NEAR; depth <= VTKI_TILE_FAR; depth *= 1.1)
  {
    const float stored =
      vtkiDepthToBuffer(static_cast<float>(depth), VTKI_TILE_NEAR, VTKI_TILE_FAR, false);
    const float inverse =
      1.0f / VTKI_TILE_NEAR - stored * (1.0f / VTKI_TILE_NEAR - 1.0f / VTKI_TILE_FAR);
    worst = std::max(worst, std::abs(inverse * depth - 1.0));
  }
  // Half a step of a float near one, 3e-8, times far over near.
  CheckAtMost("depths come back from the buffer", worst, 1.3e-4, "steps of a float times 2048");
}

// A receiver is visible if the stored depth is not nearer than its plane there, or than the
// receiver, in doubles.
VTK_INDIRECT_TEST(DepthTilePlanes)
{
  Random random(11);
  int counts[2][2] = {}; // in front of the plane, seen
  int wrong = 0;
  for (int i = 0; i < 40000; ++i)
  {
    const glm::dvec3 p(random.Next(-0.9, 0.9), random.Next(-0.9, 0.9), random.Next(-0.1, 0.9));
    const glm::dvec3 n = random.NextDirection();
    const glm::dvec3 ray(random.Next(-3.0, 3.0), random.Next(-3.0, 3.0), 1.0);
    const double bias = random.Next(0.0, 0.02);
    const double least = bias * (i % 2 == 0 ? 1.0 : VTKI_TILE_LEAST_BIAS);
    const double stored = random.Next(0.01, 1.0);
    const double facing = glm::dot(n, p);
    const double along = glm::dot(n, ray);
    const bool plane = facing < 0.0 && along < 0.0;
    const double onPlane = plane ? facing / along : 0.0;
    const double nearer = bias * std::max(p.z, plane ? std::min(p.z / -along, 2.0 * onPlane) : 0.0);
    const double mine = std::min((1.0 - least) * p.z, plane ? onPlane - nearer : p.z);
    const bool expected = p.z <= VTKI_TILE_NEAR || stored >= mine;
    ++counts[plane ? 1 : 0][expected ? 1 : 0];
    const bool found = vtkiIsSeenInPerspectiveTile(static_cast<float>(1.0 / stored),
      static_cast<float>(p.z), static_cast<float>(facing), static_cast<float>(along),
      static_cast<float>(bias), static_cast<float>(least));
    // Values that a float may round to either side do not count.
    wrong += found != expected && std::abs(stored - mine) > 1e-5 && std::abs(facing) > 1e-5 &&
        std::abs(along) > 1e-5
      ? 1
      : 0;
  }
  for (const auto& plane : counts)
  {
    Check(
      "there are such that are seen and such that are hidden", plane[0] > 100 && plane[1] > 100);
  }
  CheckEqual("receivers that are seen and should not be, or the other way round", wrong, 0);
}

// The five views of a tile cover the half space in front of it, and each receiver is looked up in
// the view, and at the place, where its occluders are drawn.
VTK_INDIRECT_TEST(DepthTileHoldsAHalfSpace)
{
  Random random(23);
  vtkIndirectFrame frame;
  frame.SceneScale = 0.5;
  frame.SceneCenter = glm::dvec3(3.0, -2.0, 5.0);
  int counts[vtkIndirectDepthTile::NumberOfViews] = {};
  double worst = 0.0;
  double outermost = 0.0;
  int unseen = 0;
  int wrongDepths = 0;
  for (int i = 0; i < 4000; ++i)
  {
    const glm::dvec3 place(random.Next(-0.2, 0.2), random.Next(-0.2, 0.2), random.Next(-0.2, 0.2));
    const vtkIndirectDepthTile tile =
      vtkIndirectDepthTile::FromPlace(place, random.NextDirection());
    glm::dvec3 way = random.NextDirection();
    // Half of them within eighteen degrees of the horizon.
    const double height = glm::dot(way, tile.Forward);
    way += ((i % 2 ? std::abs(height) : 0.3 * std::abs(height)) - height) * tile.Forward;
    way *= random.Next(0.01, 0.5);
    const glm::dvec3 away(
      glm::dot(way, tile.Right), glm::dot(way, tile.Up), glm::dot(way, tile.Forward));
    const vtkiTileView found =
      vtkiFindTileView(glm::vec3(away), glm::vec3(0.0f, 0.0f, 1.0f), VTKI_TILE_TANGENT);
    const int number = found.strip + 1;
    ++counts[number];
    const vtkIndirectDepthTile view = tile.GetView(number);
    const glm::dvec3 world = (place + way) / frame.SceneScale + frame.SceneCenter;
    const glm::dvec4 clip = view.GetWorldToClip(frame) * glm::dvec4(world, 1.0);
    const glm::dvec2 drawn(clip.x / clip.w, clip.y / clip.w);
    const glm::dvec2 looked =
      (glm::dvec2(found.away) / static_cast<double>(found.away.z) - view.Middle) / view.HalfWidth;
    worst = std::max({ worst, std::abs(drawn.x - looked.x), std::abs(drawn.y - looked.y) });
    outermost = std::max({ outermost, std::abs(drawn.x), std::abs(drawn.y) });
    wrongDepths += std::abs(found.away.z - glm::dot(way, view.Forward)) > 1e-6 ? 1 : 0;
    double bounds[6];
    for (int k = 0; k < 6; ++k)
    {
      bounds[k] = world[k / 2] + (k % 2 ? 0.05 : -0.05);
    }
    unseen += (tile.FindViews(frame, bounds, 128) >> number) & 1u ? 0 : 1;
  }
  for (const int count : counts)
  {
    CheckAtLeast("receivers in each view", count, 200, "the test's own power");
  }
  CheckAtMost("from where one is drawn to where it is looked up", worst, 1e-4, "floats");
  CheckAtMost("none is outside of its view", outermost, 1.0 + 1e-5, "floats");
  CheckEqual("depths that are not those along the view", wrongDepths, 0);
  CheckEqual("boxes about receivers that are not drawn there", unseen, 0);
  // No two views share a texel of the tile.
  constexpr int texels = 128;
  std::vector<int> uses(static_cast<size_t>(texels) * texels * 5 / 4, 0);
  for (int number = 0; number < vtkIndirectDepthTile::NumberOfViews; ++number)
  {
    const glm::ivec2 first = vtkIndirectDepthTile::GetPlaceOfView(number, texels, true);
    const glm::ivec2 size = vtkIndirectDepthTile::GetSizeOfView(number, texels);
    for (int y = first.y; y < first.y + size.y; ++y)
    {
      for (int x = first.x; x < first.x + size.x; ++x)
      {
        ++uses.at(static_cast<size_t>(y * texels + x));
      }
    }
  }
  Check("views fill a tile", std::all_of(uses.begin(), uses.end(), [](int n) { return n == 1; }));
}

VTK_INDIRECT_TEST(DepthTileOfADirection)
{
  Random random(13);
  for (const double scale : { 1e-9, 1.0, 1e6 })
  {
    const vtkIndirectFrame frame = MakeFrame(scale);
    double worst = 0.0;
    int unseen = 0;
    int seenBeside = 0;
    for (int i = 0; i < 200; ++i)
    {
      const vtkIndirectDepthTile tile =
        vtkIndirectDepthTile::FromDirection(frame, random.NextDirection(), frame.Seen.Box);
      unseen += tile.CanSee(frame, frame.Casters[0].Bounds, 128) ? 0 : 1;
      const glm::dmat4 toClip = tile.GetWorldToClip(frame);
      for (int corner = 0; corner < 8; ++corner)
      {
        const double* b = frame.Casters[0].Bounds;
        const glm::dvec4 p = toClip *
          glm::dvec4(b[corner & 1], b[2 + ((corner >> 1) & 1)], b[4 + ((corner >> 2) & 1)], 1.0);
        worst = std::max({ worst, std::abs(p.x / p.w), std::abs(p.y / p.w), std::abs(p.z / p.w) });
      }
      double beside[6];
      for (int k = 0; k < 6; ++k)
      {
        const glm::dvec3 shift = 3.0 * scale * tile.Right;
        beside[k] = frame.Casters[0].Bounds[k] + shift[k / 2];
      }
      seenBeside += tile.CanSee(frame, beside, 128) ? 1 : 0;
    }
    CheckEqual("tiles that do not see what they are fitted to", unseen, 0);
    CheckEqual("tiles that see what is beside them", seenBeside, 0);
    CheckAtMost("all of it is in the image", worst, 1.0, "by construction");
    CheckAtLeast("which it fills", worst, 0.95, "the margin is a hundredth");
  }
}

// A receiver is visible if the stored depth is behind its plane at the texel's centre, in doubles;
// a texel tells nothing where the plane comes nearer and the stored depth is half a texel behind
// it.
VTK_INDIRECT_TEST(DepthTileSeesOverPlanes)
{
  Random random(17);
  int wrong = 0;
  int counts[3] = {}; // hidden, seen, ended
  for (int i = 0; i < 20000; ++i)
  {
    const glm::dvec3 n = random.NextDirection(); // right, up, and towards the light
    const double range = random.Next(0.3, 2.0);
    const glm::dvec2 texel(random.Next(0.005, 0.05), random.Next(0.005, 0.05));
    const glm::dvec2 shift = glm::dvec2(random.Next(-0.5, 0.5), random.Next(-0.5, 0.5)) * texel;
    const double depth = random.Next(0.1, 0.9);
    const double stored = i % 50 == 0 ? 1.0 : depth + random.Next(-0.05, 0.05);
    if (n.z < 0.05)
    {
      continue;
    }
    // Depth grows away from the light: the plane's at the centre, not beyond the receiver's.
    const double rise = glm::dot(glm::dvec2(n), shift) / n.z / range;
    const double margin = stored - (depth + std::min(rise, 0.0));
    // A length along the normal, over the range.
    const double half = 0.5 * std::max(texel.x, texel.y) / range;
    const double beyond = (stored - depth - rise) * n.z - half;
    if (std::abs(margin) < 1e-5 || std::abs(beyond) < 1e-5 || std::abs(rise) < 1e-5)
    {
      continue;
    }
    const bool ends = rise < 0.0 && beyond > 0.0;
    const int expected = ends ? 2 : margin > 0.0 || stored >= 1.0 ? 1 : 0;
    const glm::dvec2 slope = glm::dvec2(n) / texel * (texel * texel / (range * range));
    const glm::vec2 found = vtkiLookUpParallelTile(false, static_cast<float>(stored),
      static_cast<float>(depth), static_cast<float>(n.z / range), glm::vec2(slope),
      glm::vec2(shift / texel), static_cast<float>(half / range));
    wrong += found == glm::vec2(expected == 1, expected != 2) ? 0 : 1;
    ++counts[expected];
  }
  CheckEqual("otherwise than the plane says", wrong, 0);
  Check("of all kinds", counts[0] > 1000 && counts[1] > 1000 && counts[2] > 1000);
}

// A receiver inside a closed body sees nothing outside: beyond the body's rim a texel does not tell
// that the receiver is visible, in tiles of both kinds.
VTK_INDIRECT_TEST(DepthTileEndsAtARim)
{
  Random random(31);
  const double texel = 0.02; // at depth one
  int leaks[2] = {};
  int counted = 0;
  for (int i = 0; i < 100000; ++i)
  {
    // A sphere around (0, 0, 1), which the light sees from the origin along z, over a far wall.
    const double radius = 0.25;
    const glm::dvec3 center(0.0, 0.0, 1.0);
    const glm::dvec3 inward = random.NextDirection();
    const glm::dvec3 p = center - radius * inward;
    const glm::dvec2 at = glm::dvec2(p) / p.z / texel;
    const glm::dvec3 ray(texel * (glm::floor(at) + 0.5), 1.0);
    const double facing = glm::dot(inward, p);
    const double nearest = glm::dot(ray, center) / glm::dot(ray, ray);
    const bool isBeyond = glm::length(nearest * ray - center) > radius;
    if (facing >= 0.0 || !isBeyond)
    {
      continue; // the body hides its back, and all that its texels show
    }
    ++counted;
    const double wall = 3.0;
    const double bias = VTKI_TILE_ROUGHNESS * texel;
    const float inverse = static_cast<float>(1.0 / wall);
    const float depth = static_cast<float>(p.z);
    const float along = static_cast<float>(glm::dot(inward, ray));
    leaks[0] += !vtkiEndsInPerspectiveTile(
                  inverse, depth, static_cast<float>(facing), along, static_cast<float>(bias))
      ? 1
      : 0;
    // The same sphere from a direction, for which the far wall is where depths end.
    const glm::dvec2 place = glm::dvec2(p) / texel;
    const glm::dvec2 offset = glm::floor(place) + 0.5 - place;
    const double towards = -inward.z;
    if (towards > 0.0 && glm::length(texel * (place + offset)) > radius)
    {
      const glm::vec2 found =
        vtkiLookUpParallelTile(false, 1.0f, static_cast<float>(p.z / wall - bias / wall),
          static_cast<float>(towards / wall), glm::vec2(glm::dvec2(inward) * texel / (wall * wall)),
          glm::vec2(offset), static_cast<float>(0.5 * texel / (wall * wall)));
      leaks[1] += found.x > 0.0f ? 1 : 0;
    }
  }
  CheckAtLeast("texels beyond the rim", counted, 100, "the test's own power");
  CheckAtMost("perspective: share of texels that show light",
    static_cast<double>(leaks[0]) / counted, 0.1,
    "walls within two texels of a receiver's plane, at grazing angles; 1 without the rule");
  CheckEqual("parallel: texels that show light", leaks[1], 0);
}

// A floor that meets a wall is seen up to the crease, whichever of the two surfaces a texel shows.
VTK_INDIRECT_TEST(DepthTileSeesIntoCreases)
{
  Random random(37);
  const double texel = 0.04; // at depth one
  int counted = 0;
  int lost[3] = {};
  int hidden = 0;
  while (counted < 20000)
  {
    // Two planes through a point, before the light at the origin, whose angle is below 180 degrees.
    const glm::dvec3 crease(random.Next(-0.2, 0.2), random.Next(-0.2, 0.2), random.Next(0.2, 0.8));
    const glm::dvec3 floor = random.NextDirection();
    const glm::dvec3 wall = random.NextDirection();
    const double height[2] = { -glm::dot(floor, crease), -glm::dot(wall, crease) };
    const auto inverse = [&](const glm::dvec3& ray)
    { return std::max(-glm::dot(floor, ray) / height[0], -glm::dot(wall, ray) / height[1]); };
    const glm::dvec2 at(random.Next(-0.3, 0.3), random.Next(-0.3, 0.3));
    const glm::dvec3 way(at, 1.0);
    const glm::dvec2 offset = texel * (glm::floor(at / texel) + 0.5) - at;
    const glm::dvec3 ray(at + offset, 1.0);
    const double onFloor = -glm::dot(floor, way) / height[0];
    const double onWall = -glm::dot(wall, ray) / height[1];
    // The light sees the floor at the receiver, and the wall at the texel's centre.
    if (height[0] < 0.1 || height[1] < 0.1 || onFloor < 1.0 || onFloor < inverse(way) ||
      onWall < -glm::dot(floor, ray) / height[0])
    {
      continue; // the receiver sees no floor, or the texel's centre no wall
    }
    ++counted;
    const auto depth = static_cast<float>(1.0 / onFloor);
    const auto stored = static_cast<float>(inverse(ray));
    const glm::dvec2 side(offset.x < 0.0 ? -texel : texel, offset.y < 0.0 ? -texel : texel);
    const glm::vec2 rise(inverse(ray + glm::dvec3(side.x, 0.0, 0.0)) - stored,
      inverse(ray + glm::dvec3(0.0, side.y, 0.0)) - stored);
    const float byTwo = glm::dot(glm::vec2(glm::abs(offset) / texel), rise);
    const bool meets = vtkiMeetsInPerspectiveTile(stored, depth, byTwo);
    // Moving frames read one texel beyond.
    const glm::vec2 beyond = vtkiStepBeyond(glm::vec2(offset));
    const glm::dvec2 step(beyond);
    const double steps = glm::dot(offset / texel, step) / glm::dot(step, step);
    const auto byOne =
      static_cast<float>(steps * (inverse(ray + texel * glm::dvec3(step, 0.0)) - stored));
    const bool meetsAtOne = vtkiMeetsInPerspectiveTile(stored, depth, byOne);
    const auto bias = static_cast<float>(VTKI_TILE_ROUGHNESS * texel);
    const bool seen = vtkiIsSeenInPerspectiveTile(stored, depth, static_cast<float>(-height[0]),
      static_cast<float>(glm::dot(floor, ray)), bias, VTKI_TILE_LEAST_BIAS * bias);
    lost[0] += seen ? 0 : 1;
    lost[1] += seen || meets ? 0 : 1;
    lost[2] += seen || meetsAtOne ? 0 : 1;
    // A sheet between the light and the floor, parallel to the map.
    hidden += vtkiMeetsInPerspectiveTile(1.2f * static_cast<float>(onFloor), depth, 0.0f) ? 1 : 0;
  }
  CheckAtLeast("receivers that their own texel hides", lost[0], 1000, "the test's own power");
  CheckAtMost("share of them that the next texels hide, too",
    static_cast<double>(lost[1]) / lost[0], 0.01,
    "walls that the light sees at less than 7 degrees");
  CheckAtMost("share of them that one texel beyond hides, too",
    static_cast<double>(lost[2]) / lost[0], 0.2,
    "walls that rise across the line through the texels");
  CheckEqual("receivers that see through a sheet", hidden, 0);
}

// Every occluder of a receiver has its place in the tile, also flat casters that extend beyond it.
VTK_INDIRECT_TEST(DepthTileHasAllThatHides)
{
  Random random(29);
  int blocked = 0;
  int missed = 0;
  double smallest = 1.0;
  for (int scene = 0; scene < 300; ++scene)
  {
    vtkIndirectFrame frame;
    for (int k = 0; k < 5; ++k)
    {
      vtkIndirectCaster caster;
      const int across = static_cast<int>(random.Next(0.0, 3.0));
      const bool flat = random.Next() < 0.7;
      for (int axis = 0; axis < 3; ++axis)
      {
        // Planes that meet, coincide, or pass each other.
        const double middle = 0.1 * std::floor(random.Next(-4.0, 5.0));
        const double half = flat && axis == across ? 0.0 : 0.05 * std::floor(random.Next(1.0, 8.0));
        caster.Bounds[2 * axis] = middle - half;
        caster.Bounds[2 * axis + 1] = middle + half;
      }
      frame.Casters.push_back(caster);
    }
    glm::dvec3 toLight = random.NextDirection();
    if (scene % 10 == 0)
    {
      toLight = glm::normalize(glm::dvec3(toLight.x, 0.0, toLight.z)); // along planes
    }
    const vtkIndirectDepthTile tile =
      vtkIndirectDepthTile::FromDirection(frame, toLight, frame.Seen.Box);
    smallest = std::min(smallest, std::min(tile.HalfWidth.x, tile.HalfWidth.y));
    for (int i = 0; i < 400; ++i)
    {
      // From a point of one caster towards the light, through the bounds of another, or its own.
      const double* const from = frame.Casters[static_cast<size_t>(random.Next(0.0, 5.0))].Bounds;
      const glm::dvec3 p(random.Next(from[0], from[1]), random.Next(from[2], from[3]),
        random.Next(from[4], from[5]));
      const double* const b = frame.Casters[static_cast<size_t>(random.Next(0.0, 5.0))].Bounds;
      double near = 1e-6;
      double far = 10.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        if (toLight[axis] == 0.0)
        {
          far = p[axis] > b[2 * axis] && p[axis] < b[2 * axis + 1] ? far : -1.0;
          continue;
        }
        const double first = (b[2 * axis] - p[axis]) / toLight[axis];
        const double second = (b[2 * axis + 1] - p[axis]) / toLight[axis];
        near = std::max(near, std::min(first, second));
        far = std::min(far, std::max(first, second));
      }
      if (near > far)
      {
        continue;
      }
      ++blocked;
      const glm::dvec3 d = p - tile.Place;
      const bool inside = std::abs(glm::dot(d, tile.Right)) <= tile.HalfWidth.x &&
        std::abs(glm::dot(d, tile.Up)) <= tile.HalfWidth.y;
      const glm::dvec3 q = d + near * toLight;
      const double depth = glm::dot(q, tile.Forward);
      missed += inside && depth >= tile.Near && depth <= tile.Far ? 0 : 1;
    }
  }
  CheckAtLeast("segments that something blocks", blocked, 5000, "the test's own power");
  CheckEqual("of which the tile does not have both ends", missed, 0);
  // A ground under a ball.
  vtkIndirectFrame frame;
  for (const double half : { 0.5, 0.01 })
  {
    vtkIndirectCaster caster;
    for (int axis = 0; axis < 3; ++axis)
    {
      const bool flat = axis == 1 && half > 0.1;
      caster.Bounds[2 * axis] = axis == 1 ? 0.0 : -half;
      caster.Bounds[2 * axis + 1] = flat ? 0.0 : axis == 1 ? 2.0 * half : half;
    }
    frame.Casters.push_back(caster);
  }
  double widest = 0.0;
  for (int i = 0; i < 200; ++i)
  {
    const glm::dvec2 half =
      vtkIndirectDepthTile::FromDirection(frame, random.NextDirection(), frame.Seen.Box).HalfWidth;
    widest = std::max({ widest, half.x, half.y });
  }
  CheckAtMost("half width of tiles over that of the ball", widest / 0.01, 1.01 * std::sqrt(3.0),
    "the diagonal of its bounds, and the margin");
}
