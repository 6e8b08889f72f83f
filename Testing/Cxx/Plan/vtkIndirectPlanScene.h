// SPDX-License-Identifier: BSD-3-Clause
// Facts of a frame for tests of the plan.
#ifndef vtkIndirectPlanScene_h
#define vtkIndirectPlanScene_h

#include "Plan/vtkIndirectPlan.h"
#include "Scene/vtkIndirectFrame.h"

#include <string>
#include <vector>

namespace vtkIndirectTest
{
// A scene of one box under lights; no OpenGL, no VTK.
inline vtkIndirectFrame MakeFrame(const std::vector<vtkIndirectLight>& lights)
{
  vtkIndirectFrame frame;
  frame.Size[0] = 64;
  frame.Size[1] = 48;
  frame.Casters.resize(1);
  frame.CoversFully = true;
  frame.Lights = lights;
  for (size_t i = 0; i < lights.size(); ++i)
  {
    frame.Lights[i].Index = static_cast<int>(i);
  }
  return frame;
}

inline vtkIndirectLight MakeLight(double color = 1.0)
{
  vtkIndirectLight light;
  light.Color = glm::dvec3(color);
  return light;
}

inline vtkIndirectLight MakeHeadlight()
{
  vtkIndirectLight light = MakeLight();
  light.Headlight = light.FollowsCamera = true;
  return light;
}

inline std::string Find(const vtkIndirectPlan::Entries& entries, const std::string& what)
{
  for (const auto& entry : entries)
  {
    if (entry.first == what)
    {
      return entry.second;
    }
  }
  return {};
}
}

#endif
