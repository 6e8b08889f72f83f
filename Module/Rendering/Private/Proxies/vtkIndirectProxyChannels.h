// SPDX-License-Identifier: BSD-3-Clause
// Textures of sums over spheres.
#ifndef vtkIndirectProxyChannels_h
#define vtkIndirectProxyChannels_h

#include "OpenGL/vtkIndirectGL.h"

#include "OpenGL/vtkIndirectChannel.h"

namespace vtkIndirectProxyChannels
{
const vtkIndirectChannel TableChannels[] = {
  { "proxies.table", "vtkiProxyTable", "zonal logarithms of what spheres leave", GL_RGBA32F, "-",
    "-" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel RowsChannels[] = {
  { "proxies.center", "vtkiProxyCenter", "centre, radius", GL_RGBA32F, "scene", "scene units" },
  { "proxies.region", "vtkiProxyRegion", "where it counts", GL_RGBA32F, "scene", "bits" },
  { "proxies.albedo", "vtkiProxyAlbedo", "albedo, sender", GL_RGBA32F, "-", "1" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel BlocksChannels[] = {
  { "proxies.blocks", "vtkiProxyBlocks", "corners of a box", GL_RGBA32F, "scene", "scene units" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel SendersChannels[] = {
  { "proxies.sender", "vtkiSenderPlace", "place, radius", GL_RGBA32F, "scene", "scene units" },
  { "proxies.facing", "vtkiSenderNormal", "normal, whether there is one", GL_RGBA32F, "scene",
    "1" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
const vtkIndirectChannel RangesChannels[] = {
  { "proxies.ranges", "vtkiMeanRange", "first sender, number", GL_RG32F, "-", "-" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
#define VTKI_LIGHT_CHANNEL(name, uniform)                                                          \
  {                                                                                                \
    name, uniform, "irradiance by normals", GL_RGBA32F, "world", "VTK irradiance"                  \
  }
const vtkIndirectChannel SenderLightChannels[] = {
  VTKI_LIGHT_CHANNEL("proxies.light0", "vtkiSenderLight0"),
  VTKI_LIGHT_CHANNEL("proxies.light1", "vtkiSenderLight1"),
  VTKI_LIGHT_CHANNEL("proxies.light2", "vtkiSenderLight2"),
  VTKI_LIGHT_CHANNEL("proxies.light3", "vtkiSenderLight3"),
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
#undef VTKI_LIGHT_CHANNEL
const vtkIndirectChannel SentLightChannels[] = {
  { "proxies.sent0", "vtkiSentLight0", "irradiance by normals, in pairs", GL_RGBA32F, "world",
    "two halves of bits each" },
  { "proxies.sent1", "vtkiSentLight1", "irradiance by normals, in pairs", GL_RGBA32F, "world",
    "two halves of bits each" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
#define VTKI_COARSE_CHANNEL(name, uniform)                                                         \
  {                                                                                                \
    name, uniform, "what coarse receivers get", GL_RGBA32F, "world", "VTK irradiance"              \
  }
const vtkIndirectChannel CoarseChannels[] = {
  VTKI_COARSE_CHANNEL("proxies.coarse0", "vtkiCoarse0"),
  VTKI_COARSE_CHANNEL("proxies.coarse1", "vtkiCoarse1"),
  VTKI_COARSE_CHANNEL("proxies.coarse2", "vtkiCoarse2"),
  VTKI_COARSE_CHANNEL("proxies.coarse3", "vtkiCoarse3"),
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
#undef VTKI_COARSE_CHANNEL
#define VTKI_SHARED_CHANNEL(name, uniform)                                                         \
  {                                                                                                \
    name, uniform, "what receivers of tiles get", GL_RGBA32F, "world", "VTK irradiance"            \
  }
const vtkIndirectChannel SharedChannels[] = {
  VTKI_SHARED_CHANNEL("proxies.shared0", "vtkiShared0"),
  VTKI_SHARED_CHANNEL("proxies.shared1", "vtkiShared1"),
  VTKI_SHARED_CHANNEL("proxies.shared2", "vtkiShared2"),
  VTKI_SHARED_CHANNEL("proxies.shared3", "vtkiShared3"),
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
#undef VTKI_SHARED_CHANNEL
const vtkIndirectChannel CountChannels[] = {
  { "proxies.count", "vtkiSharedCount", "receivers of a tile", GL_R32F, "-", "1" },
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr },
};
#define VTKI_SUM_CHANNEL(name, uniform)                                                            \
  {                                                                                                \
    name, uniform, "sums over spheres", GL_RGBA32F, "world", "-"                                   \
  }
const vtkIndirectChannel BlendedChannels[] = { VTKI_SUM_CHANNEL("proxies.hidden0", "vtkiHidden0"),
  VTKI_SUM_CHANNEL("proxies.hidden1", "vtkiHidden1"),
  VTKI_SUM_CHANNEL("proxies.hidden2", "vtkiHidden2"),
  VTKI_SUM_CHANNEL("proxies.hidden3", "vtkiHidden3"), VTKI_SUM_CHANNEL("proxies.sent", "vtkiSent"),
  { nullptr, nullptr, nullptr, 0, nullptr, nullptr } };
#undef VTKI_SUM_CHANNEL
}
#endif
