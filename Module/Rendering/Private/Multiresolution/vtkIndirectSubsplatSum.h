// SPDX-License-Identifier: BSD-3-Clause
// The part of vtkMultiresolutionSplattingPass that sums the light: subsplats, and lists of them for
// specular receivers.
#pragma once

#include "Gather/vtkIndirectGlossyGather.h"                  // for members
#include "Gather/vtkIndirectLobeGather.h"                    // for members
#include "Multiresolution/vtkIndirectGlossySubsplats.h"      // for members
#include "Multiresolution/vtkIndirectSubsplatIllumination.h" // for members
#include "Multiresolution/vtkIndirectSubsplatView.h"         // for members
#include "Senders/vtkIndirectLightBlock.h"                   // for members
#include "Sums/vtkIndirectReprojection.h"                    // for members
#include "Sums/vtkIndirectSum.h"
#include "vtkMultiresolutionSplattingPass.h" // for settings

struct vtkIndirectSubsplatSettings;

class vtkIndirectSubsplatSum : public vtkIndirectSum
{
public:
  explicit vtkIndirectSubsplatSum(vtkMultiresolutionSplattingPass& pass);

  void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const override;
  vtkIndirectAbilities GetAbilities(double tolerance) const override;
  void AddToReport(vtkIndirectReport& report) const override;
  std::vector<std::string> GetChannelNames() const override;
  int DrawChannel(const std::string& name, const vtkIndirectFrame& frame,
    const vtkIndirectGeometryBuffer& geometry) override;

  void AppendTo(vtkIndirectKey& key, const Input& input) const override;

protected:
  int FindReceiverStep(const vtkIndirectPlan& plan) const override
  {
    return this->IsCoarse(&plan) ? 1 << this->FindFinestLevel(&plan) : 1;
  }
  vtkIndirectEstimate Estimate(const Input& input) override;

private:
  /** Returns the tolerance that the thresholds follow when so much is asked for; 0: none does. */
  double FindErrorTolerance(double asked) const;
  /**
   * Returns the names of the thresholds that the irradiance's subsplats obey and that the user has
   * set.
   */
  std::vector<std::string> FindOwnThresholds() const;
  bool IsCoarse(const vtkIndirectPlan* plan) const;
  /** Returns the finest level in force; null: the one that is set. */
  int FindFinestLevel(const vtkIndirectPlan* plan) const;
  vtkIndirectSubsplatSettings MakeSettings(const Input& input) const;
  /** Returns true if a frame's irradiance holds at places that the eye sees again. */
  bool CanReproject(const Input& input) const;
  bool Fill(
    const Input& input, const vtkIndirectSubsplatSettings& settings, vtkIndirectTarget& pixels);
  bool FillInBatches(const Input& input, const vtkIndirectSubsplatSettings& settings);
  bool FillGlossy(const Input& input, const vtkIndirectSubsplatSettings& settings);

  const vtkMultiresolutionSplattingPass& Set;
  vtkIndirectLightBlock Lights{ this };
  vtkIndirectSubsplatPyramid Pyramid{ this };
  vtkIndirectSubsplatIllumination Illumination{ this };
  vtkIndirectSubsplatView View{ this };
  vtkIndirectReprojection Reprojection{ this, 32 };
  vtkIndirectGlossySubsplats GlossySubsplats{ this };
  vtkIndirectGlossyGather GlossyGather{ this };
  vtkIndirectLobeGather Lobes{ this };
  // The image of a batch of lights, where there are several.
  std::unique_ptr<vtkIndirectTarget> Batch;
  bool BatchIsHalf = false;
  vtkIndirectFullScreenProgram AddBatch{ this, "vtkIndirectSubsplatAddFS.glsl" };

  // The last frame, for the report.
  double Tolerance = 0.0;
  int Evaluations = -1;
  bool IsReprojected = false;
  int NumberOfLights = 0;
  std::string Renderer;
  bool GlossyIsListed = false;
  std::string WhyGlossyIsGathered;
};
