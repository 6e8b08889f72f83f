// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "vtkIndirectPyramidReader.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Multiresolution/vtkIndirectSubsplatPyramid.h"
#include "Multiresolution/vtkIndirectSubsplatSum.h"
#include "OpenGL/vtkIndirectComputeProgram.h"
#include "OpenGL/vtkIndirectKernels.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Scene/vtkIndirectFrame.h"
#include "Senders/vtkIndirectLightBlock.h"
#include "Senders/vtkIndirectVirtualLights.h"
#include "vtkIndirectDetails.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"

#include <algorithm>

namespace vtkIndirectTest
{
vtkStandardNewMacro(PyramidReader);

namespace
{
class ReadingSum : public vtkIndirectSubsplatSum
{
public:
  explicit ReadingSum(PyramidReader& reader)
    : vtkIndirectSubsplatSum(reader)
    , Reader(reader)
  {
  }

protected:
  vtkIndirectEstimate Estimate(const Input& input) override
  {
    this->Reader.Read(input);
    return this->vtkIndirectSubsplatSum::Estimate(input);
  }

private:
  PyramidReader& Reader;
};
}

//------------------------------------------------------------------------------
PyramidReader::PyramidReader()
  : vtkMultiresolutionSplattingPass(std::make_unique<ReadingSum>(*this))
{
}

//------------------------------------------------------------------------------
bool PyramidReader::IsLit(int x, int y) const
{
  const float* pixel = &this->Pixels[4 * (static_cast<size_t>(y) * this->Size[0] + x)];
  return vtkIndirectKernels::vtkiSurfaceIsLit({ pixel[0], pixel[1], pixel[2], pixel[3] });
}

//------------------------------------------------------------------------------
bool PyramidReader::IsSplit(int level, int x, int y) const
{
  const Level& of = this->Levels[level - 1];
  return vtkIndirectKernels::vtkiSubsplatIsSplit(of.At(of.Surface, x, y)[3]);
}

//------------------------------------------------------------------------------
std::vector<int> PyramidReader::FindLeaves(int x, int y) const
{
  std::vector<int> leaves;
  for (int level = static_cast<int>(this->Levels.size()); level-- > 0;)
  {
    const bool under = this->IsSplit(level + 1, x >> (level + 1), y >> (level + 1));
    if (under && (level == 0 || !this->IsSplit(level, x >> level, y >> level)))
    {
      leaves.push_back(level);
    }
  }
  return leaves;
}

//------------------------------------------------------------------------------
void PyramidReader::Read(const vtkIndirectEstimateInput& input)
{
  vtkOpenGLRenderWindow* window = input.Frame.Window;
  std::copy(input.Frame.Size, input.Frame.Size + 2, this->Size);
  this->RayOrigin = input.Frame.RayOrigin;
  this->RayDirection = input.Frame.RayDirection;
  this->Pixels = input.Geometry.GetTarget().ReadBack(vtkIndirectGeometryBuffer::Surface);
  this->Levels.clear();
  {
    vtkIndirectSubsplatSettings settings;
    const vtkIndirectSubsplatDetails& details = DetailsOf(this);
    settings.CoarsestResolution = details.CoarsestResolution;
    settings.FinestLevel = this->GetFinestLevel();
    settings.DepthRange = details.DepthRange;
    settings.PlaneThreshold = this->GetPlaneThreshold();
    settings.DepthThreshold = this->GetDepthThreshold();
    settings.NormalThreshold = this->GetNormalThreshold();
    settings.LightingThreshold = details.LightingThreshold;
    settings.Balance = details.Balance;
    settings.HasCompute = vtkIndirectComputeProgram::IsSupported();
    vtkOpenGLState* state = window->GetState();
    vtkOpenGLState::ScopedglViewport viewport(state);
    vtkOpenGLState::ScopedglScissor scissor(state);
    vtkOpenGLState::ScopedglBlendFuncSeparate blendFunc(state);
    vtkIndirectFullScreenState fullScreenState(window);
    vtkIndirectLightBlock lights;
    lights.Update(window, *input.Lights);
    vtkIndirectSubsplatPyramid pyramid;
    if (pyramid.Resize(window, this->Size, settings) && pyramid.Build(input, settings, lights))
    {
      for (size_t number = 1; number <= pyramid.GetNumberOfLevels(); ++number)
      {
        const vtkIndirectTarget& from = pyramid.GetSurface(number);
        Level level;
        level.Width = from.GetWidth();
        level.Height = from.GetHeight();
        level.NumberOfListed = settings.HasCompute ? pyramid.GetLists().Count(number - 1) : -1;
        level.Surface = from.ReadBack(0);
        level.Second = from.ReadBack(1);
        if (settings.DepthRange)
        {
          level.Third = from.ReadBack(2);
        }
        this->Levels.push_back(level);
      }
    }
    pyramid.Release(window);
    lights.Release(window);
  }
}
}
