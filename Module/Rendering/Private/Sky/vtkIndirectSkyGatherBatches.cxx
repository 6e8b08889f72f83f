// SPDX-License-Identifier: BSD-3-Clause
// The sky of a finer picture, which is summed in batches of directions, and how much of the sky a
// picture sees.
#include "OpenGL/vtkIndirectGL.h"

#include "Sky/vtkIndirectSkyGather.h"

#include "Capture/vtkIndirectCreases.h"
#include "Capture/vtkIndirectGeometryBuffer.h"
#include "OpenGL/vtkIndirectUniforms.h"
#include "Plan/vtkIndirectPlan.h"
#include "Scene/vtkIndirectFrame.h"
#include "vtkEnvironmentLight.h"

#include <algorithm>

namespace
{
// A pixel with a smaller share sees no more than light that leaks.
constexpr float LeastShare = 0.002f;
}

//------------------------------------------------------------------------------
void vtkIndirectSkyGather::SetBatches(int directions, int texels, int step)
{
  this->DirectionsOfBatch = directions;
  this->TexelsOfBatch = texels;
  this->Step = step;
}

//------------------------------------------------------------------------------
// Every so many directions of a finer sky are in a batch.
void vtkIndirectSkyGather::UpdateFiner(const Input& input)
{
  const size_t batches = static_cast<size_t>(input.Batch.Count);
  if (this->Directions.UpdateFiner(*input.Projection, input.Environment,
        this->DirectionsOfBatch * input.Batch.Count, input.Plan.NumberOfStillSkyDirections))
  {
    this->OpenSkyIsThere = false;
    this->Summed = this->Directions.GetOthers();
  }
  std::vector<glm::dvec3> directions;
  const std::vector<glm::dvec3>& lattice = this->Directions.GetLattice();
  for (size_t i = static_cast<size_t>(input.Batch.Number); i < lattice.size(); i += batches)
  {
    directions.push_back(lattice[i]);
  }
  this->Others.SetDirections(std::move(directions));
  this->Others.Fit(input.Frame);
  this->Others.Request(input.Frame, this->TexelsOfBatch);
}

//------------------------------------------------------------------------------
// Makes the terms of a batch of a finer sky, which are numbered as its maps are.
vtkIndirectSkyGather::Terms vtkIndirectSkyGather::MakeBatch(
  const vtkIndirectLightBatch& batch) const
{
  const size_t batches = static_cast<size_t>(batch.Count);
  Terms terms;
  for (vtkIndirectSkyMaps::Term& term : this->MakeTerms(this->Summed, false))
  {
    if (term.Number % batches == static_cast<size_t>(batch.Number))
    {
      terms.push_back({ term.Number / batches, term.Light });
    }
  }
  return terms;
}

//------------------------------------------------------------------------------
// A pixel without neighbours on its surface asks some of the last batch's directions.
vtkIndirectSkyGather::Terms vtkIndirectSkyGather::MakeOwnBatch(
  const vtkIndirectLightBatch& batch) const
{
  const Terms all = this->MakeBatch(batch);
  const size_t stride = std::max<size_t>(1, (all.size() + OwnBlock - 1) / OwnBlock);
  Terms own;
  for (size_t i = 0; i < all.size(); i += stride)
  {
    own.push_back(all[i]);
  }
  return own;
}

//------------------------------------------------------------------------------
// Adds a batch's directions to the sum; the last one makes the sum irradiance.
bool vtkIndirectSkyGather::AddBatch(const Input& input)
{
  const vtkIndirectFrame& frame = input.Frame;
  const vtkIndirectLightBatch& batch = input.Batch;
  this->Keeps = false;
  this->KeepsStill = true;
  if (!this->Resize(input) || !this->UpdateOpenSky(input))
  {
    return false;
  }
  vtkIndirectFullScreenState kernelState(frame.Window);
  bool done = input.Creases.Update(frame, input.Geometry, 1) &&
    this->SumOthers(input, this->MakeBatch(batch));
  if (batch.Number + 1 < batch.Count)
  {
    return done;
  }
  done = done && this->Smoothing.Resize(frame, input.Geometry.GetTarget()) &&
    (this->Step == 1 || this->FilterRows(input)) && this->FilterColumns(input) &&
    this->Smooth(input);
  return done && (this->Directions.GetStrong().empty() || this->SumStrong(input));
}

//------------------------------------------------------------------------------
bool vtkIndirectSkyGather::TakeShares(const Input& input, const vtkIndirectSkyGather& finer)
{
  if (!this->KeepsStill)
  {
    return true;
  }
  vtkIndirectFullScreenState kernelState(input.Frame.Window);
  return this->Reprojection.KeepStill(
    { input.Frame, input.Geometry, 1 }, finer.Smoothing.GetShares());
}

//------------------------------------------------------------------------------
double vtkIndirectSkyGather::FindMedianShare() const
{
  const vtkIndirectTarget& shares = this->Smoothing.GetShares();
  if (!this->KeepsStill || !shares.GetFramebuffer())
  {
    return 1.0;
  }
  const std::vector<float> texels = shares.ReadBack(0);
  std::vector<float> seen;
  for (size_t i = 0; i + 3 < texels.size(); i += 4)
  {
    const float share = texels[i] + texels[i + 1] + texels[i + 2];
    if (share > LeastShare)
    {
      seen.push_back(share);
    }
  }
  if (seen.empty())
  {
    return 1.0;
  }
  const auto middle = seen.begin() + static_cast<std::ptrdiff_t>(seen.size() / 2);
  std::nth_element(seen.begin(), middle, seen.end());
  return *middle;
}
