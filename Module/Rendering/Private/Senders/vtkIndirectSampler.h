// SPDX-License-Identifier: BSD-3-Clause
// A sampler of virtual lights as the pipeline sees it: the table of its lights, the time of their
// last change, and its abilities. A vtkVirtualLightSampler holds the user's settings and an object
// of this class, which makes the lights; the pipeline has further objects of its own.
#pragma once

#include "OpenGL/vtkIndirectResource.h" // for the base class
#include "OpenGL/vtkIndirectTarget.h"   // for members
#include "Plan/vtkIndirectEstimate.h"   // for batches
#include "vtkSmartPointer.h"            // for the guard
#include "vtkTimeStamp.h"               // for a member

#include <memory> // for tables
#include <vector> // for rows

class vtkIndirectContextGuard;
class vtkIndirectGeometryBuffer;
class vtkIndirectMapSampler;
class vtkIndirectSettingList;
class vtkIndirectSurfaces;
class vtkOpenGLRenderWindow;
class vtkIndirectLightMaps;
class vtkVirtualLightSampler;
struct vtkIndirectFrame;
struct vtkIndirectFurtherSenders;
struct vtkIndirectLight;
struct vtkIndirectPlan;
struct vtkIndirectReport;

/** These are the properties of a sampler that the rest of a frame depends on. */
struct vtkIndirectSamplerAbilities
{
  /** An automatic number of lights is at most this one. */
  static constexpr int MostAutomaticLights = 1024;
  /**
   * Returns how many times as many senders, texels of maps and vertices of walks, so many lights
   * are worth: with 8192 lights the relMSE of a brain to all bounces is 0.0098 with as many senders
   * as usual, and 0.0062 with four times as many.
   */
  static constexpr int FindDetail(int lights) { return lights > MostAutomaticLights ? 4 : 1; }

  /**
   * Wanted number of lights. The sky and area lights together get as many, and so does each body
   * of glass.
   */
  int NumberOfLights = 256;
  int MostLights = 0;        // an automatic number may grow up to this one; 0: the number is fixed
  bool Directions = false;   // lights may be directions, which costs estimators a little more
  bool Walks = false;        // rays through the scene find lights of all bounces; no map is read
  bool TakesSenders = false; // the lights also represent given further senders
  bool Divides = false;      // the lights have branches, which near receivers sum in their place
  bool HasMore = false;      // a still frame of the same scene would have more lights than the last
                             // frame
};

class vtkIndirectSampler : public vtkIndirectResource
{
public:
  /** The pointer also holds the vtkVirtualLightSampler if the lights are made for one. */
  using Pointer = std::shared_ptr<vtkIndirectSampler>;

  /** This is the data that a frame's lights are made from. */
  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectLightMaps& Maps;          // without maps where the frame has none
    const vtkIndirectGeometryBuffer& Geometry; // surfaces that the eye sees
    double ErrorTolerance = 0.02;              // of the irradiance, over its mean
    int NumberOfBounces = 1;       // wanted number, for samplers that find several bounces
    bool Interactive = false;      // the window's rate is a frame a second or more
    vtkIndirectLightBatch Batch{}; // the tables hold these lights alone
    /** The sky and area lights, which light surfaces besides the frame's lights. */
    const std::vector<vtkIndirectLight>* Emitters = nullptr;
    /** The frame's lights are among the emitters, whose light changes from frame to frame. */
    bool LightsTurn = false;
    /** These are the scene's surfaces, up to date for samplers that walk. */
    const vtkIndirectSurfaces* Surfaces = nullptr;
    /**
     * These are the senders of later bounces, for samplers that take senders; null: there are none.
     */
    const vtkIndirectFurtherSenders* Further = nullptr;
  };

  /** Channels of the table, with a texel for each light; empty places have no density. */
  enum Channel
  {
    PositionArea,        // scene units; or unit direction to the light, minus its solid angle
    NormalChildDistance, // unit normal of the sender; distance within which its branches are
                         // summed, 0: none
    DensityArea // reflected radiance times area, or radiance times solid angle; source, or of
                // branches the contact softening (vtkiFindPatchLight)
  };
  /**
   * Channels of the table of lobes, with a texel for each light; lights without a lobe have no
   * density.
   */
  enum LobeChannel
  {
    LobeDirectionExponent, // unit direction of the greatest radiance; exponent
    LobeDensityArea        // flux over the hemisphere, in the unit of DensityArea's; 0
  };
  /** These are the lights in a row of the table. */
  static constexpr int RowLength = 256;

  /** This is a light's row of the table, in scene units. */
  struct Row
  {
    double Position[3];
    double Area;
    double Normal[3];
    double DensityArea[3];
    double ChildDistance = 0.0;
    double ContactSoftening = 0.0; // only for a branch
    /** Unit; this and the next two are the lobe's. Without density there is no lobe. */
    double LobeDirection[3] = { 0.0, 0.0, 1.0 };
    double LobeExponent = 0.0;
    double LobeDensityArea[3] = { 0.0, 0.0, 0.0 };
  };

  /** owner: the public object that holds this one; null for the pipeline's own samplers. */
  explicit vtkIndirectSampler(vtkVirtualLightSampler* owner = nullptr);
  ~vtkIndirectSampler() override;

  /** Returns the lights of a public sampler, which they keep alive; null for null. */
  static Pointer Get(vtkVirtualLightSampler* sampler);

  /**
   * Makes the sampler release all graphics resources when the window's context ends, and at once if
   * they are of another window. Must be called in every frame, before Update.
   */
  void HoldContext(vtkOpenGLRenderWindow* window);

  /**
   * Adds the owner's settings: those in force in the last frame, of this plan, or, for null, those
   * that are set.
   */
  virtual void AddSettings(vtkIndirectSettingList& list, const vtkIndirectPlan* plan) const;
  /** Brings the lights up to date. Returns false, after an error, when that fails. */
  virtual bool Update(const Input& input) = 0;
  /** Updates the lights, and puts the input's batch into the tables. */
  bool UpdateBatch(const Input& input);
  /** Returns the abilities. Default: the owner's number of lights, and nothing else. */
  virtual vtkIndirectSamplerAbilities GetAbilities() const;
  /**
   * Finds senders for samplers that take some, and makes no lights of them; returns null if the
   * sampler cannot.
   */
  virtual const vtkIndirectFurtherSenders* UpdateSenders(const Input&) { return nullptr; }
  /**
   * Makes the pattern that draws lights from the surfaces that the eye sees, for a headlight that
   * is the only light; null: the pipeline's own pattern is used.
   */
  virtual vtkIndirectMapSampler* GetHeadlightPattern() { return nullptr; }
  /** Adds the sources of the last frame's lights to the report. Default: nothing. */
  virtual void AddToReport(vtkIndirectReport&) const {}

  /** Returns the number of lights in the last frame. */
  int GetActualNumberOfLights() const { return this->NumberOfLights; }
  const vtkIndirectTarget& GetTable() const { return this->Table; }
  /**
   * Returns the nodes of a tree below the lights, vtkIndirectKernels::VTKI_BRANCHES for each light;
   * null if no light has branches.
   */
  const vtkIndirectTarget* GetBranches() const { return this->Branches.get(); }
  /**
   * Returns the lights' specular lobes, in the order of the lights; null if no light has a lobe.
   * vtkiSenderLobeWeight gives the light that a receiver gets from a lobe
   * (vtkIndirectLibSenderLobe.glsl).
   */
  const vtkIndirectTarget* GetLobes() const { return this->Lobes.get(); }
  /** Grows whenever the lights change or are released. */
  vtkMTimeType GetContentTime() const { return this->ContentTime.GetMTime(); }
  /** Grows with the owner's settings. */
  vtkMTimeType GetSettingsTime() const;

protected:
  bool CanRelease(vtkWindow* window) override;
  void ReleaseOwn(vtkWindow* window) override;
  /** Makes room in the table. Returns false, after an error, when OpenGL refuses. */
  bool Resize(vtkOpenGLRenderWindow* window, int numberOfLights);
  /** Returns the table, to be filled, and marks the lights as changed. */
  vtkIndirectTarget& BeginChange();
  /**
   * Replaces the lights by these, of a source that is not a vtkLight. The branches are those of all
   * lights, or empty. Lobes are written if one of the lights has a lobe; branches have no lobes.
   * Returns false, after an error, when OpenGL refuses.
   */
  bool Write(const vtkIndirectFrame& frame, const std::vector<Row>& lights,
    const std::vector<Row>& branches = {});
  /**
   * Makes room for the lobes of as many lights as Resize made room for, and returns it to be
   * filled; returns null, after an error, when OpenGL refuses.
   */
  vtkIndirectTarget* MakeLobes(vtkOpenGLRenderWindow* window);
  /** Removes the lobes of all lights. */
  void RemoveLobes() { this->Lobes.reset(); }

private:
  static void Fill(vtkIndirectTarget& table, const std::vector<Row>& rows, double source);
  bool WriteBatch(const vtkIndirectFrame& frame);
  bool WriteAll(const vtkIndirectFrame& frame, const std::vector<Row>& lights,
    const std::vector<Row>& branches);
  bool WriteLobes(vtkOpenGLRenderWindow* window, const std::vector<Row>& lights);

  vtkVirtualLightSampler* Owner;
  vtkSmartPointer<vtkIndirectContextGuard> Guard;
  vtkIndirectTarget Table;
  std::unique_ptr<vtkIndirectTarget> Branches;
  std::unique_ptr<vtkIndirectTarget> Lobes;
  vtkTimeStamp ContentTime;
  int NumberOfLights = 0;
  vtkIndirectLightBatch Batch{}; // in the tables
  // All lights, where the tables hold a batch of them.
  std::vector<Row> Rows;
  std::vector<Row> BranchRows;
};
