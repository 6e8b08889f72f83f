// SPDX-License-Identifier: BSD-3-Clause
// Rays through the pixels of the eye's image or of a light map, for vtkiDepthOnRay.
#pragma once

#include "Scene/vtkIndirectFrame.h" // for the eye's rays
#include "vtkShaderProgram.h"

#include <glm/gtc/type_ptr.hpp>

struct vtkIndirectPixelRays
{
  // These are the tangents (perspective) or places in scene units (parallel): gl_FragCoord times xy
  // plus zw.
  glm::vec4 Pixels{ 1.0f };
  glm::vec3 Meet{ 0.0f }; // where all rays of a perspective meet, scene units

  static vtkIndirectPixelRays Make(const vtkIndirectFrame& frame)
  {
    const glm::dmat3& rays = frame.Parallel ? frame.RayOrigin : frame.RayDirection;
    return { glm::vec4(2.0 * rays[0].x / frame.Size[0], 2.0 * rays[1].y / frame.Size[1],
               rays[2].x - rays[0].x, rays[2].y - rays[1].y),
      glm::vec3(frame.RaysMeet) };
  }

  void SetUniforms(vtkShaderProgram* program) const
  {
    program->SetUniform4f("vtkiPixelRays", glm::value_ptr(this->Pixels));
    program->SetUniform3f("vtkiRaysMeet", glm::value_ptr(this->Meet));
  }
};
