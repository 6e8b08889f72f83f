// SPDX-License-Identifier: BSD-3-Clause
// Random scenes, summed by splats and by the gather of the same lights.
#ifndef vtkIndirectSplattingScene_h
#define vtkIndirectSplattingScene_h

#include "Multiresolution/vtkIndirectRandomFrame.h"
#include "vtkIndirectSplattingPass.h" // for members

#include <cstdlib> // for the environment
#include <string>  // for names

namespace vtkIndirectTest
{
/** Forces a way by name for as long as it lives, for passes that are made or released after. */
struct ForcedPath
{
  explicit ForcedPath(const std::string& paths) { setenv("VTK_INDIRECT_PATHS", paths.c_str(), 1); }
  ~ForcedPath() { unsetenv("VTK_INDIRECT_PATHS"); }
  ForcedPath(const ForcedPath&) = delete;
  void operator=(const ForcedPath&) = delete;
};

/** How splats are summed. */
enum class SplatWay
{
  TILES,
  QUADS,
  ELLIPSOIDS
};
constexpr int NumberOfSplatWays = 3;
inline const char* GetName(SplatWay way)
{
  return way == SplatWay::TILES ? "tiles" : way == SplatWay::QUADS ? "quads" : "ellipsoids";
}

/** A scene with splatting beside what it has. */
template <typename Base>
struct SplattingFrameOf : Base
{
  using Base::Base;

  vtkNew<vtkIndirectSplattingPass> Splats;

  Image SplatLights(SplatWay way)
  {
    const ForcedPath path(way == SplatWay::TILES ? "splats=tiles" : "splats=blend");
    this->Splats->SetSplatShape(way == SplatWay::QUADS ? vtkIndirectSplattingPass::SCREEN_QUADS
                                                       : vtkIndirectSplattingPass::ELLIPSOIDS);
    this->Splats->Modified();
    this->Pass->SetEstimator(this->Splats);
    this->Render();
    return this->Copy("irradiance");
  }
};
using SplattingFrame = SplattingFrameOf<RandomFrame>;
}

#endif
