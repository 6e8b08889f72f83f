// SPDX-License-Identifier: BSD-3-Clause
// Every level of the pyramid against one made on the CPU, at odd and prime sizes: minima and maxima
// bit for bit, means and deviations within rounding.
#include "vtkIndirectDetails.h"
#include "vtkIndirectPyramidReader.h"
#include "vtkIndirectRandomFrame.h"

#include "OpenGL/vtkIndirectKernels.h"
#include "vtkUniformLightSampler.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace vtkIndirectTest;

namespace
{
namespace Kernels = vtkIndirectKernels;

// Sizes whose levels are odd all the way down, or a single texel along an edge.
const std::vector<FrameSize> Sizes = { { 97, 61 }, { 127, 89 }, { 131, 1 }, { 1, 67 }, { 1, 1 },
  { 3, 113 }, { 65, 33 }, { 2, 2 } };

struct PyramidFrame : RandomFrame
{
  vtkNew<PyramidReader> Reader;

  explicit PyramidFrame(int number)
    : RandomFrame(
        number, Sizes[number % Sizes.size()], static_cast<FrameLight>(number % NumberOfFrameLights))
  {
    this->Sampler->SetNumberOfLights(16);
    this->Pass->SetReflectiveShadowMapResolution(64);
    this->Pass->SetEstimator(this->Reader);
    SET_DETAIL(this->Reader, CoarsestResolution, 4);
  }
  ~PyramidFrame() { this->Pass->SetEstimator(nullptr); }

  bool IsThere(int level, int x, int y) const
  {
    if (level == 0)
    {
      return x < this->Reader->Size[0] && y < this->Reader->Size[1] && this->Reader->IsLit(x, y);
    }
    const PyramidReader::Level& of = this->Reader->Levels[level - 1];
    return x < of.Width && y < of.Height &&
      of.At(of.Surface, x, y)[3] != Kernels::VTKI_SUBSPLAT_EMPTY;
  }
  // Depth and normal of a pixel, or of a level's texel.
  void Get(int level, int x, int y, double& depth, glm::dvec3& normal) const
  {
    if (level == 0)
    {
      const float* p =
        &this->Reader->Pixels[4 * (static_cast<size_t>(y) * this->Reader->Size[0] + x)];
      depth = p[0];
      normal = Kernels::vtkiSurfaceNormal({ p[0], p[1], p[2], p[3] });
    }
    else
    {
      const PyramidReader::Level& of = this->Reader->Levels[level - 1];
      const float* p = of.At(of.Surface, x, y);
      depth = p[2];
      normal = Kernels::vtkiOctahedralDecode({ p[0], p[1] });
    }
  }
  // Position at the centre of a texel's pixels inside the image.
  glm::dvec3 GetPlace(int level, int x, int y, double depth) const
  {
    const double edge = std::exp2(level);
    const glm::dvec2 size(this->Reader->Size[0], this->Reader->Size[1]);
    const glm::dvec2 lower = edge * glm::dvec2(x, y);
    const glm::dvec2 upper = glm::min(lower + edge, size);
    const glm::dvec3 h((lower + upper) / size - 1.0, 1.0);
    return this->Reader->RayOrigin * h + depth * (this->Reader->RayDirection * h);
  }
  double GetPixelWidth(double depth) const
  {
    return 2.0 / this->Reader->Size[0] *
      glm::length(this->Reader->RayOrigin[0] + depth * this->Reader->RayDirection[0]);
  }
};
}

VTK_INDIRECT_TEST(PyramidMinMax)
{
  double texels = 0.0;
  double border = 0.0; // texels with children outside of the image
  int empty = 0;
  int depths = 0;
  int normals = 0;
  double worst = 0.0;
  for (int number = 0; number < 16; ++number)
  {
    PyramidFrame scene(1400 + number);
    PyramidReader* const reader = scene.Reader;
    SET_DETAIL(reader, DepthRange, true);
    scene.Render();
    CheckEqual("width of level 1", reader->Levels[0].Width, (reader->Size[0] + 1) / 2);
    for (int level = 1; level <= static_cast<int>(reader->Levels.size()); ++level)
    {
      const PyramidReader::Level& of = reader->Levels[level - 1];
      for (int y = 0; y < of.Height; ++y)
      {
        for (int x = 0; x < of.Width; ++x)
        {
          // Depths from the pixels themselves.
          float least = 0.0f;
          float most = 0.0f;
          bool there = false;
          const int edge = 1 << level;
          for (int v = y * edge; v < std::min((y + 1) * edge, reader->Size[1]); ++v)
          {
            for (int u = x * edge; u < std::min((x + 1) * edge, reader->Size[0]); ++u)
            {
              if (reader->IsLit(u, v))
              {
                const float depth =
                  reader->Pixels[4 * (static_cast<size_t>(v) * reader->Size[0] + u)];
                least = there ? std::min(least, depth) : depth;
                most = there ? std::max(most, depth) : depth;
                there = true;
              }
            }
          }
          const float* minimum = of.At(of.Second, x, y);
          const float* maximum = of.At(of.Third, x, y);
          empty += there != scene.IsThere(level, x, y);
          depths += minimum[3] != least || maximum[3] != most;
          border += (x + 1) * edge > reader->Size[0] || (y + 1) * edge > reader->Size[1];
          texels += there;
          // Normals: of pixels, whose decoding rounds; of higher levels bit for bit from the level
          // below.
          for (int c = 0; c < 3 && there; ++c)
          {
            float lower = 2.0f;
            float upper = -2.0f;
            for (int child = 0; child < 4; ++child)
            {
              const int u = 2 * x + (child & 1);
              const int v = 2 * y + (child >> 1);
              if (!scene.IsThere(level - 1, u, v))
              {
                continue;
              }
              if (level == 1)
              {
                double depth;
                glm::dvec3 normal;
                scene.Get(0, u, v, depth, normal);
                lower = std::min(lower, static_cast<float>(normal[c]));
                upper = std::max(upper, static_cast<float>(normal[c]));
              }
              else
              {
                const PyramidReader::Level& finer = reader->Levels[level - 2];
                lower = std::min(lower, finer.At(finer.Second, u, v)[c]);
                upper = std::max(upper, finer.At(finer.Third, u, v)[c]);
              }
            }
            if (level == 1)
            {
              worst = std::max({ worst, std::abs(static_cast<double>(minimum[c]) - lower),
                std::abs(static_cast<double>(maximum[c]) - upper) });
            }
            else
            {
              normals += minimum[c] != lower || maximum[c] != upper;
            }
          }
        }
      }
    }
  }
  CheckAtLeast("texels with a surface", texels, 5000, "the test's own power");
  CheckAtLeast("texels that reach beyond the image", border, 500, "as above");
  CheckEqual("texels that are empty on one side only", empty, 0);
  CheckEqual("texels of which a depth differs in any bit", depths, 0);
  CheckEqual("normals' components that differ in any bit from the level below", normals, 0);
  CheckAtMost("normals' components of the first level, worst difference", worst, 5e-7,
    "2^-21: decoding rounds, and so does the inverse square root of a card");
}

VTK_INDIRECT_TEST(PyramidMeans)
{
  double texels = 0.0;
  double turn = 0.0;
  double depthError = 0.0;
  double spreadError = 0.0;
  double deviationError = 0.0;
  int wrong = 0;
  for (int number = 0; number < 16; ++number)
  {
    PyramidFrame scene(1500 + number);
    PyramidReader* const reader = scene.Reader;
    // Neither the lighting nor neighbours split texels: the state depends on the surface.
    SET_DETAIL(reader, LightingThreshold, 0.0);
    SET_DETAIL(reader, Balance, false);
    scene.Render();
    for (int level = 1; level <= static_cast<int>(reader->Levels.size()); ++level)
    {
      const PyramidReader::Level& of = reader->Levels[level - 1];
      for (int y = 0; y < of.Height; ++y)
      {
        for (int x = 0; x < of.Width; ++x)
        {
          glm::dvec3 normal(0.0);
          glm::dvec3 place(0.0);
          double nearest = 1e30;
          double farthest = 0.0;
          int count = 0;
          glm::dvec3 normals[4];
          glm::dvec3 places[4];
          double deviations[4];
          double spreads[4];
          for (int child = 0; child < 4; ++child)
          {
            const int u = 2 * x + (child & 1);
            const int v = 2 * y + (child >> 1);
            if (!scene.IsThere(level - 1, u, v))
            {
              continue;
            }
            double depth;
            scene.Get(level - 1, u, v, depth, normals[count]);
            places[count] = scene.GetPlace(level - 1, u, v, depth);
            deviations[count] = spreads[count] = 0.0;
            if (level > 1)
            {
              const PyramidReader::Level& finer = reader->Levels[level - 2];
              deviations[count] = finer.At(finer.Second, u, v)[0];
              spreads[count] = finer.At(finer.Second, u, v)[1];
            }
            nearest = std::min(nearest, -places[count].z);
            farthest = std::max(farthest, -places[count].z);
            normal += normals[count];
            place += places[count];
            ++count;
          }
          wrong += (count > 0) != scene.IsThere(level, x, y);
          // Normals that nearly cancel have no mean.
          if (count == 0 || glm::length(normal) < 0.1 * count)
          {
            continue;
          }
          normal = glm::normalize(normal);
          place /= count;
          const double width = scene.GetPixelWidth(0.5 * (nearest + farthest)) * std::exp2(level);
          double deviation = 0.0;
          double spread = 0.0;
          for (int i = 0; i < count; ++i)
          {
            deviation = std::max(deviation,
              std::abs(glm::dot(normal, places[i] - place)) / width + 0.5 * deviations[i]);
            spread = std::max(spread, glm::length(normals[i] - normal) + spreads[i]);
          }
          const float* second = of.At(of.Second, x, y);
          deviationError = std::max(deviationError,
            std::abs(second[0] - std::min(deviation, 60000.0)) / std::max(deviation, 1e-2));
          spreadError =
            std::max(spreadError, std::abs(second[1] - spread) / std::max(spread, 1e-2));
          texels += 1.0;
          const bool mixed = deviation > 0.99 * reader->GetPlaneThreshold() ||
            spread > 0.99 * reader->GetNormalThreshold();
          if (mixed)
          {
            continue; // holds the nearest child's surface instead
          }
          double depth;
          glm::dvec3 found;
          scene.Get(level, x, y, depth, found);
          turn = std::max(turn, glm::length(found - normal));
          // The depth lies on the plane through the mean position, in front of all children and of
          // their tangent planes on its ray; this measures its distance over the texel's width.
          const glm::dvec3 at = scene.GetPlace(level, x, y, depth);
          const glm::dvec3 origin = scene.GetPlace(level, x, y, 0.0);
          const glm::dvec3 way = scene.GetPlace(level, x, y, 1.0) - origin;
          const double middle = glm::dot(normal, place - origin) / glm::dot(normal, way);
          const glm::dvec3 seen = origin + glm::clamp(middle, 0.5 * nearest, 2.0 * farthest) * way;
          double before = -1e30;
          for (int i = 0; i < count; ++i)
          {
            const double tangent =
              glm::dot(normals[i], places[i] - seen) / std::max(glm::dot(normals[i], normal), 0.5);
            before = std::max({ before, glm::dot(normal, places[i] - seen), tangent });
          }
          place = seen + before * normal;
          const bool bounded = depth <= 0.5 * nearest * 1.001 || depth >= 2.0 * farthest * 0.999;
          if (!bounded)
          {
            depthError = std::max(depthError, std::abs(glm::dot(normal, at - place)));
          }
        }
      }
    }
  }
  CheckAtLeast("texels with a surface", texels, 5000, "the test's own power");
  CheckEqual("texels that are empty on one side only", wrong, 0);
  CheckAtMost("mean normals, worst difference", turn, 1e-6, "sums of four in 32-bit floats");
  CheckAtMost("mean planes, worst distance in diagonals of the scene", depthError, 4e-6,
    "places of up to 2.5 diagonals, some ten roundings of 2^-24 each");
  CheckAtMost("deviations, worst relative difference", deviationError, 2e-3,
    "half floats, 2^-10 where bits are cut off, and 1e-5 of rounding over a hundredth");
  CheckAtMost("spreads, worst relative difference", spreadError, 2e-3, "as above");
}
