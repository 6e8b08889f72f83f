// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/vtkIndirectGL.h"

#include "Multiresolution/vtkIndirectSubsplatView.h"

#include "Scene/vtkIndirectFrame.h"

#include "Capture/vtkIndirectGeometryBuffer.h"
#include "Multiresolution/vtkIndirectSubsplatIllumination.h"
#include "OpenGL/vtkIndirectUniforms.h"

#include <algorithm>

namespace
{
enum View
{
  LevelView,
  OutlineView,
  EvaluatedView,
  UpsampledView
};
}

//------------------------------------------------------------------------------
std::vector<std::string> vtkIndirectSubsplatView::GetNames(size_t levels)
{
  std::vector<std::string> names = { "subsplat.level", "subsplat.outline" };
  // The last level has no illumination.
  for (const char* name : { "subsplat.evaluated", "subsplat.upsampled" })
  {
    for (size_t number = 0; number < levels; ++number)
    {
      names.push_back(name + std::to_string(number));
    }
  }
  return names;
}

//------------------------------------------------------------------------------
int vtkIndirectSubsplatView::Draw(const std::string& name, const vtkIndirectFrame& frame,
  const vtkIndirectGeometryBuffer& geometry, const vtkIndirectSubsplatPyramid& pyramid,
  const vtkIndirectSubsplatIllumination& illumination, const vtkIndirectTarget& pixels, double unit)
{
  const size_t levels = pyramid.GetNumberOfLevels();
  const std::vector<std::string> names = GetNames(levels);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
  {
    return 0;
  }
  const size_t index = static_cast<size_t>(found - names.begin());
  size_t coarsest = levels - 1;
  size_t finest = 0;
  int view = static_cast<int>(index);
  if (index >= 2)
  {
    view = index - 2 < levels ? EvaluatedView : UpsampledView;
    coarsest = finest = (index - 2) % levels;
  }
  vtkIndirectProgram program = this->View.Use(frame.Window);
  if (!program)
  {
    return 0;
  }
  for (size_t number = coarsest + 1; number-- > finest;)
  {
    // Pixels are no level of the pyramid: any texture serves for the unread sampler.
    const size_t own = std::max<size_t>(number, 1);
    program->SetUniform2i("vtkiSize", frame.Size);
    program->SetUniformi("vtkiLevel", static_cast<int>(number));
    program->SetUniformi("vtkiView", view);
    program->SetUniformf("vtkiIrradianceUnit", static_cast<float>(unit));
    geometry.GetTarget().Activate(vtkIndirectGeometryBuffer::Surface, program);
    pixels.Activate(0, program);
    pyramid.GetSurface(own).Activate(0, program);
    illumination.GetLevel(own).Activate(0, program, "vtkiLevelIrradiance");
    pyramid.GetSurface(number + 1).Activate(0, program, "vtkiCoarserSurface");
    this->View.Draw();
  }
  return view == LevelView ? 1 : 3;
}
