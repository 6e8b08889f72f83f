// SPDX-License-Identifier: BSD-3-Clause
// The virtual lights of a frame: the lights of one sampler, or of several samplers one after the
// other.
#pragma once

#include "OpenGL/vtkIndirectFullScreenProgram.h" // for members
#include "OpenGL/vtkIndirectResource.h"          // for the base class
#include "OpenGL/vtkIndirectTarget.h"            // for members
#include "Senders/vtkIndirectSampler.h"          // for its input
#include "vtkTimeStamp.h"                        // for a member

#include <string>  // for definitions
#include <utility> // for contents
#include <vector>  // for samplers

class vtkImageData;

class vtkIndirectVirtualLights : public vtkIndirectResource
{
public:
  using Input = vtkIndirectSampler::Input;
  using Samplers = std::vector<vtkIndirectSampler::Pointer>;

  explicit vtkIndirectVirtualLights(vtkIndirectResource* owner = nullptr);

  /**
   * Brings the samplers' lights up to date and joins them. The table of a single sampler is read
   * directly. Returns false, after an error, when a sampler fails.
   */
  bool Update(const Input& input, const Samplers& samplers);

  /**
   * Sets the share of their child distance within which nodes above leaves are divided. Default: 1.
   */
  void SetChildDistanceScale(double scale) { this->ChildDistanceScale = static_cast<float>(scale); }

  /** Returns true if the samplers' lights are still those of the last update. */
  bool AreThere() const;

  int GetNumberOfLights() const { return this->NumberOfLights; }
  int GetNumberOfRows() const;
  /** Returns true if some lights may be directions. */
  bool HasDirections() const { return this->WithDirections; }
  /** Returns definitions for shaders that read lights (vtkIndirectLightRow.glsl). */
  std::string GetDefinitions() const
  {
    return std::string(this->WithDirections ? "#define VTKI_DIRECTIONS\n" : "") +
      (this->HasBranches() ? "#define VTKI_DIVIDED\n" : "");
  }
  /**
   * Returns true if some lights have a specular lobe. GetLobes returns the table of lobes, or null.
   */
  bool HasLobes() const { return this->CurrentLobes != nullptr; }
  const vtkIndirectTarget* GetLobes() const { return this->CurrentLobes; }
  /** Returns true if receivers near a light sum its branches (vtkIndirectBranches.glsl). */
  bool HasBranches() const { return this->CurrentBranches != nullptr; }
  /** Grows whenever the lights, or the samplers that they come from, change. */
  vtkMTimeType GetContentTime() const { return this->ContentTime.GetMTime(); }
  const vtkIndirectTarget& GetTable() const { return *this->Current; }

  /** Binds the table, and the branches if there are any, and sets its extent. */
  void Activate(const vtkIndirectProgram& program) const;

  /** Binds the lobes, if there are any. */
  void ActivateLobes(const vtkIndirectProgram& program) const;

  ///@{
  /**
   * Copy the lights, or their branches: a row of three texels of four floats for each, in world
   * units.
   */
  void CopyLights(const vtkIndirectFrame& frame, vtkImageData* image) const;
  void CopyBranches(const vtkIndirectFrame& frame, vtkImageData* image) const;
  ///@}
  /** Copies the lobes: a row of two texels of four floats for each, in world units. */
  void CopyLobes(const vtkIndirectFrame& frame, vtkImageData* image) const;

protected:
  void ReleaseOwn(vtkWindow* window) override;

private:
  static void Copy(
    const vtkIndirectFrame& frame, const vtkIndirectTarget& table, int count, vtkImageData* image);
  void ActivateBranches(const vtkIndirectProgram& program) const;
  bool Join(const Input& input, const Samplers& samplers);
  enum Part
  {
    Lights,
    Branches,
    Lobes
  };
  static const vtkIndirectTarget* GetPart(const vtkIndirectSampler::Pointer& sampler, Part part);
  static bool HasPart(const Samplers& samplers, Part part);
  bool JoinTables(
    vtkOpenGLRenderWindow* window, const Samplers& samplers, vtkIndirectTarget& table, Part part);

  vtkIndirectTarget Joined;
  vtkIndirectTarget JoinedBranches;
  vtkIndirectTarget JoinedLobes;
  vtkIndirectFullScreenProgram Program{ this, "vtkIndirectJoinLightsFS.glsl" };
  vtkIndirectFullScreenProgram LobeProgram{ this, "vtkIndirectJoinLightsFS.glsl" };
  const vtkIndirectTarget* Current = nullptr;
  const vtkIndirectTarget* CurrentBranches = nullptr;
  const vtkIndirectTarget* CurrentLobes = nullptr;
  int NumberOfLights = 0;
  float ChildDistanceScale = 1.0f;
  bool WithDirections = false;
  std::vector<std::pair<vtkIndirectSampler*, vtkMTimeType>> Contents; // samplers of the last
                                                                      // update, and their times
  vtkTimeStamp ContentTime;
  vtkMTimeType JoinedTime = 0; // time of the contents in the joined tables; 0: none
};
