// SPDX-License-Identifier: BSD-3-Clause
// The kernels of glsl/lib as C++, through GLM: the GPU's source code on the CPU.
#pragma once

#include <glm/glm.hpp> // for vectors and matrices

#define VTKI_HOST
#define VTKI_OUT(T) T&
#define VTKI_INOUT(T) T&

namespace vtkIndirectKernels
{
using glm::abs;
using glm::asinh;
using glm::atan;
using glm::cos;
using glm::cross;
using glm::dot;
using glm::exp;
using glm::floatBitsToUint;
using glm::floor;
using glm::fract;
using glm::ivec2;
using glm::ivec3;
using glm::length;
using glm::log;
using glm::mat3;
using glm::max;
using glm::min;
using glm::normalize;
using glm::pow;
using glm::sin;
using glm::sqrt;
using glm::uintBitsToFloat;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = glm::uint;
// clang-format off
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-variable"
#endif
namespace
{
#include "vtkIndirectLibPortable.glsl"
#include "vtkIndirectLibSurface.glsl"
#include "vtkIndirectLibAlbedo.glsl"
#include "vtkIndirectLibAntialiasing.glsl"
#include "vtkIndirectLibChannel.glsl"
#include "vtkIndirectLibCrease.glsl"
#include "vtkIndirectLibPlane.glsl"
#include "vtkIndirectLibLightMap.glsl"
#include "vtkIndirectLibTable.glsl"
#include "vtkIndirectLibVirtualLight.glsl"
#include "vtkIndirectLibGlossy.glsl"
#include "vtkIndirectLibSplat.glsl"
#include "vtkIndirectLibSubsplat.glsl"
#include "vtkIndirectLibShadow.glsl"
#include "vtkIndirectLibReceiverGrid.glsl"
#include "vtkIndirectLibSampling.glsl"
#include "vtkIndirectLibImportance.glsl"
#include "vtkIndirectLibColor.glsl"
#include "vtkIndirectLibHarmonics.glsl"
#include "vtkIndirectLibOccupancy.glsl"
#include "vtkIndirectLibDistanceField.glsl"
#include "vtkIndirectLibSphereSegments.glsl"
#include "vtkIndirectLibDepthTile.glsl"
#include "vtkIndirectLibSky.glsl"
#include "vtkIndirectLibPenumbra.glsl"
#include "vtkIndirectLibAreaLight.glsl"
#include "vtkIndirectLibLobe.glsl"
#include "vtkIndirectLibSenderLobe.glsl"
#include "vtkIndirectLibLobeSplat.glsl"
#include "vtkIndirectLibSphereProxy.glsl"
#include "vtkIndirectLibProxyRegion.glsl"
}
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
// clang-format on
}
