// SPDX-License-Identifier: BSD-3-Clause
// The room with the pass, and pictures of it pixel by pixel, for tests of single props in it.
#ifndef vtkIndirectContractRoom_h
#define vtkIndirectContractRoom_h

#include "vtkIndirectContractUtilities.h"

#include "vtkRSMGatherPass.h"

#include <algorithm>

namespace contract
{
// The room with an additional prop, and all irradiance summed at every pixel, independent of the
// neighbouring pixels.
struct Room
{
  View Window{ 160, 120 };
  vtkNew<vtkIndirectIlluminationPass> Pass;
  vtkNew<vtkRSMGatherPass> Gather;

  Room()
  {
    AddRoom(this->Window.Renderer);
    this->Gather->InterpolationOff();
    this->Pass->SetEstimator(this->Gather);
    this->Pass->AntialiasingOff(); // it depends on the neighbouring pixels, too
  }
  vtkRenderer* GetRenderer() { return this->Window.Renderer; }
  Pixels Grab(bool indirect)
  {
    this->GetRenderer()->SetPass(indirect ? this->Pass.Get() : nullptr);
    return this->Window.Grab();
  }
};

inline bool Differs(const Pixels& a, const Pixels& b, size_t pixel)
{
  return !std::equal(&a.Values[4 * pixel], &a.Values[4 * pixel] + 3, &b.Values[4 * pixel]);
}

inline double Distance(const Pixels& a, const Pixels& b, size_t pixel)
{
  double distance = 0.0;
  for (size_t c = 4 * pixel; c < 4 * pixel + 3; ++c)
  {
    distance = std::max(distance, std::abs(double(a.Values[c]) - double(b.Values[c])));
  }
  return distance;
}

inline void CheckReported(vtkIndirectIlluminationPass* pass, const std::string& what)
{
  const std::string report = pass->GetReport(false);
  CONTRACT_CHECK(report.find(what) != std::string::npos, "no '" << what << "' in " << report);
}
}

#endif
