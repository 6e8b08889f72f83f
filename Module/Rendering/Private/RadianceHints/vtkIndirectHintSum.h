// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkRadianceHintsPass that sums the light: the grid of hints, their fields, and the
// look-up at receivers.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h"  // for members
#include "OpenGL/vtkIndirectKey.h"                // for keys
#include "OpenGL/vtkIndirectPointProgram.h"       // for members
#include "RadianceHints/vtkIndirectHintFields.h"  // for members
#include "RadianceHints/vtkIndirectHintGrid.h"    // for members
#include "RadianceHints/vtkIndirectHintSenders.h" // for members
#include "Sums/vtkIndirectReceiverGrid.h"         // for members
#include "Sums/vtkIndirectSum.h"
#include "vtkRadianceHintsPass.h" // for settings

class vtkIndirectHintSum : public vtkIndirectSum
{
public:
  explicit vtkIndirectHintSum(vtkRadianceHintsPass& pass);

  void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const override;
  vtkIndirectAbilities GetAbilities(double tolerance) const override;
  vtkIndirectVisibilityNeeds GetVisibilityNeeds(const vtkIndirectPlan& plan) const override;
  vtkIndirectSampler::Pointer ChooseSampler(
    const vtkIndirectSampler::Pointer& users, const vtkIndirectPlan& plan) override;
  size_t GetMainMemoryBytes() const override { return this->Grid.GetMainMemoryBytes(); }
  void AddToReport(vtkIndirectReport& report) const override;

  /** Returns the irradiance of the last frame at every Step-th pixel. */
  const vtkIndirectReceiverGrid& GetCoarse() const { return this->Coarse[this->CoarseNow]; }

  /** This is the place of a hint in scene units and its field: `Order` squared numbers each for
   * three colours, first the reds; order 3 in RGB only. For tests. */
  struct Hint
  {
    double Position[3];
    std::vector<double> Coefficients;
  };
  std::vector<Hint> ReadHints();

  vtkIndirectHintGrid Grid{ this };

protected:
  vtkIndirectEstimate Estimate(const Input& input) override;
  void ReleaseOwn(vtkWindow* window) override;

private:
  /**
   * Returns the tolerance that the grid is chosen by when so much is asked for; 0: the user chose
   * it.
   */
  double FindErrorTolerance(double asked) const;
  bool UpdateGeometry(const Input& input);
  bool UpdateLight(const Input& input, bool anew);
  bool LookUp(const Input& input);
  bool FillMixedCells(const Input& input);
  std::string GetLookupDefinitions(int step) const;
  void ActivateLookup(const vtkIndirectProgram& program, const Input& input);

  vtkRadianceHintsPass& Set;
  vtkIndirectHintGrid::Settings GridSettings;
  vtkIndirectHintFields Fields{ this };
  vtkIndirectHintFields::Settings FieldSettings; // of the last frame
  vtkIndirectReceiverGrid Coarse[2];
  int CoarseNow = 0;
  bool CoarseValid = false;
  int StillFrames = 0;   // since something changed
  bool Converged = true; // the last look-up kept nothing of those before it
  vtkIndirectFullScreenProgram LookUpKernel{ this, "vtkIndirectHintFS.glsl" };
  vtkIndirectPointProgram MixedCells{ this, "vtkIndirectHintCellVS.glsl",
    "vtkIndirectHintMixedFS.glsl" };
  vtkIndirectPointProgram Pixels{ this, "vtkIndirectHintCellVS.glsl",
    "vtkIndirectHintPixelFS.glsl" };
  const std::shared_ptr<vtkIndirectHintSenders> Senders;
  vtkIndirectKey LightKey;
  int NumberOfSmallProps = 0;    // smaller than a cell of the last frame's grid
  bool NothingReflects = false;  // bounces after the first have no surface
  double Tolerance = 0.0;        // that the last frame was asked for and the grid was chosen by
  long long NumberOfUpdates = 0; // of the hints' light, since construction
  size_t VoxelUpdates = 0;       // that the grid was made from
};
