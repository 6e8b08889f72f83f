// SPDX-License-Identifier: BSD-3-Clause
// Textures of sums over spheres.
#pragma once

#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectChannel.h"

namespace vtkIndirectProxyChannels
{
// Returns one of several channels with the same meaning.
constexpr vtkIndirectChannel MakeChannel(
  const char* name, const char* uniform, const char* meaning, const char* unit = "VTK irradiance")
{
  return { name, uniform, meaning, GL_RGBA32F, "world", unit };
}

const vtkIndirectChannels TableChannels = {
  { "proxies.table", "vtkiProxyTable", "zonal logarithms of what spheres leave", GL_RGBA32F, "-",
    "-" },
};
const vtkIndirectChannels RowsChannels = {
  { "proxies.center", "vtkiProxyCenter", "centre, radius", GL_RGBA32F, "scene", "scene units" },
  { "proxies.region", "vtkiProxyRegion", "where it counts", GL_RGBA32F, "scene", "bits" },
  { "proxies.albedo", "vtkiProxyAlbedo", "albedo, sender", GL_RGBA32F, "-", "1" },
};
const vtkIndirectChannels BlocksChannels = {
  { "proxies.blocks", "vtkiProxyBlocks", "corners of a box", GL_RGBA32F, "scene", "scene units" },
};
const vtkIndirectChannels SendersChannels = {
  { "proxies.sender", "vtkiSenderPlace", "place, radius", GL_RGBA32F, "scene", "scene units" },
  { "proxies.facing", "vtkiSenderNormal", "normal, whether there is one", GL_RGBA32F, "scene",
    "1" },
};
const vtkIndirectChannels RangesChannels = {
  { "proxies.ranges", "vtkiMeanRange", "first sender, number", GL_RG32F, "-", "-" },
};
const vtkIndirectChannels SenderLightChannels = {
  MakeChannel("proxies.light0", "vtkiSenderLight0", "irradiance by normals"),
  MakeChannel("proxies.light1", "vtkiSenderLight1", "irradiance by normals"),
  MakeChannel("proxies.light2", "vtkiSenderLight2", "irradiance by normals"),
  MakeChannel("proxies.light3", "vtkiSenderLight3", "irradiance by normals"),
};
const vtkIndirectChannels SentLightChannels = {
  { "proxies.sent0", "vtkiSentLight0", "irradiance by normals, in pairs", GL_RGBA32F, "world",
    "two halves of bits each" },
  { "proxies.sent1", "vtkiSentLight1", "irradiance by normals, in pairs", GL_RGBA32F, "world",
    "two halves of bits each" },
};
const vtkIndirectChannels CoarseChannels = {
  MakeChannel("proxies.coarse0", "vtkiCoarse0", "what coarse receivers get"),
  MakeChannel("proxies.coarse1", "vtkiCoarse1", "what coarse receivers get"),
  MakeChannel("proxies.coarse2", "vtkiCoarse2", "what coarse receivers get"),
  MakeChannel("proxies.coarse3", "vtkiCoarse3", "what coarse receivers get"),
};
const vtkIndirectChannels SharedChannels = {
  MakeChannel("proxies.shared0", "vtkiShared0", "what receivers of tiles get"),
  MakeChannel("proxies.shared1", "vtkiShared1", "what receivers of tiles get"),
  MakeChannel("proxies.shared2", "vtkiShared2", "what receivers of tiles get"),
  MakeChannel("proxies.shared3", "vtkiShared3", "what receivers of tiles get"),
};
const vtkIndirectChannels CountChannels = {
  { "proxies.count", "vtkiSharedCount", "receivers of a tile", GL_R32F, "-", "1" },
};
const vtkIndirectChannels BlendedChannels = {
  MakeChannel("proxies.hidden0", "vtkiHidden0", "sums over spheres", "-"),
  MakeChannel("proxies.hidden1", "vtkiHidden1", "sums over spheres", "-"),
  MakeChannel("proxies.hidden2", "vtkiHidden2", "sums over spheres", "-"),
  MakeChannel("proxies.hidden3", "vtkiHidden3", "sums over spheres", "-"),
  MakeChannel("proxies.sent", "vtkiSent", "sums over spheres", "-"),
};
}
