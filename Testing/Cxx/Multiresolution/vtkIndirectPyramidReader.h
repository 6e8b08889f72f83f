// SPDX-License-Identifier: BSD-3-Clause
// Multiresolution splatting that reads back the pyramid of each frame.
#ifndef vtkIndirectPyramidReader_h
#define vtkIndirectPyramidReader_h

#include "vtkMultiresolutionSplattingPass.h"

#include <glm/glm.hpp> // for vectors
#include <vector>      // for levels

struct vtkIndirectEstimateInput;

namespace vtkIndirectTest
{
class PyramidReader : public vtkMultiresolutionSplattingPass
{
public:
  static PyramidReader* New();
  vtkTypeMacro(PyramidReader, vtkMultiresolutionSplattingPass);

  struct Level
  {
    int Width = 0;
    int Height = 0;
    int NumberOfListed = -1;    // in the list of split texels; -1: no list
    std::vector<float> Surface; // octahedral normal, depth, state
    std::vector<float> Second;  // deviation and spread, or minima
    std::vector<float> Third;   // maxima for the paper's refinement
    const float* At(const std::vector<float>& channel, int x, int y) const
    {
      return &channel[4 * (static_cast<size_t>(y) * this->Width + x)];
    }
  };

  /** The last frame's surfaces of the geometry buffer, four floats a pixel, and its rays. */
  int Size[2] = { 0, 0 };
  std::vector<float> Pixels;
  glm::dmat3 RayOrigin{ 0.0 };
  glm::dmat3 RayDirection{ 0.0 };
  /** [i] is level i + 1, of texels of 2^(i + 1) pixels. */
  std::vector<Level> Levels;

  bool IsLit(int x, int y) const;
  bool IsSplit(int level, int x, int y) const;
  /** Levels of the leaves that contain a pixel: unsplit texels under a split one. */
  std::vector<int> FindLeaves(int x, int y) const;

  void Read(const vtkIndirectEstimateInput& input);

protected:
  PyramidReader();
  ~PyramidReader() override = default;
};
}

#endif
