// SPDX-License-Identifier: BSD-3-Clause
// A sampler of virtual lights as the pipeline sees it: the table of its lights, the time at which
// they last changed, and its abilities. A vtkVirtualLightSampler holds the user's settings and one
// of these, which makes the lights; the pipeline has further ones of its own.
#ifndef vtkIndirectSampler_h
#define vtkIndirectSampler_h

#include "OpenGL/vtkIndirectTarget.h" // for members
#include "vtkSmartPointer.h"          // for the guard
#include "vtkTimeStamp.h"             // for a member

#include <memory> // for tables
#include <vector> // for rows

class vtkIndirectContextGuard;
class vtkIndirectGeometryBuffer;
class vtkIndirectMapSampler;
class vtkIndirectSurfaces;
class vtkOpenGLRenderWindow;
class vtkIndirectLightMaps;
class vtkVirtualLightSampler;
class vtkWindow;
struct vtkIndirectEmitter;
struct vtkIndirectFrame;
struct vtkIndirectFurtherSenders;
struct vtkIndirectReport;

/** The properties of a sampler that decide what surrounds it in a frame. */
struct vtkIndirectSamplerAbilities
{
  /** Lights that are asked for. As many are made of the sky and of area lights together, and of
   * each body of glass. */
  int NumberOfLights = 256;
  bool Directions = false;   // lights may be directions, which costs estimators a little more
  bool Walks = false;        // rays through the scene find lights of all bounces; no map is read
  bool TakesSenders = false; // the lights also stand for the further senders that it is given
  bool Divides = false;      // the lights have branches, which near receivers sum in their place
  bool HasMore = false;      // a still frame of the same scene would have more lights than the last
};

class vtkIndirectSampler
{
public:
  /** Holds also the vtkVirtualLightSampler, where the lights are made for one. */
  using Pointer = std::shared_ptr<vtkIndirectSampler>;

  /** The material of a frame's lights. */
  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkIndirectLightMaps& Maps;          // without maps where the frame has none
    const vtkIndirectGeometryBuffer& Geometry; // surfaces that the eye sees
    double ErrorTolerance = 0.02;              // of the irradiance, over its mean
    int NumberOfBounces = 1;                   // asked for, for samplers that know several
    bool Interactive = false;                  // the window gives a frame a second or less
    /** The sky and area lights, which light surfaces besides the frame's lights. */
    const std::vector<vtkIndirectEmitter>* Emitters = nullptr;
    /** The scene's surfaces, up to date for samplers that walk. */
    const vtkIndirectSurfaces* Surfaces = nullptr;
    /** Senders of later bounces, for samplers that take senders; null: there are none. */
    const vtkIndirectFurtherSenders* Further = nullptr;
  };

  /** Channels of the table, a texel a light; empty places have no density. */
  enum Channel
  {
    PositionArea, // scene units; or unit direction to the light, minus its solid angle
    NormalReach,  // of the sender, unit; distance within which its branches are summed, 0: none
    DensityArea   // reflected radiance times area, or radiance times solid angle; source, or of
                  // branches the blunt area (vtkiFindPatchLight)
  };
  /** Channels of the table of lobes, a texel a light; lights without a lobe have no density. */
  enum LobeChannel
  {
    LobeDirectionExponent, // unit direction in which most is sent; exponent
    LobeDensityArea        // flux over the hemisphere, in the unit of DensityArea's; 0
  };
  /** Lights in a row of the table. */
  static constexpr int RowLength = 256;

  /** A light as the table has it, in scene units. */
  struct Row
  {
    double Position[3];
    double Area;
    double Normal[3];
    double DensityArea[3];
    double Reach = 0.0;
    double BluntArea = 0.0; // of a branch
    /** Unit; this and the next two are the lobe's. Without density there is none. */
    double LobeDirection[3] = { 0.0, 0.0, 1.0 };
    double LobeExponent = 0.0;
    double LobeDensityArea[3] = { 0.0, 0.0, 0.0 };
  };

  /** owner: the public object that holds it; null for the pipeline's own samplers. */
  explicit vtkIndirectSampler(vtkVirtualLightSampler* owner = nullptr);
  virtual ~vtkIndirectSampler();
  vtkIndirectSampler(const vtkIndirectSampler&) = delete;
  void operator=(const vtkIndirectSampler&) = delete;

  /** The lights of a public sampler, which is held as long as they are; null for null. */
  static Pointer Get(vtkVirtualLightSampler* sampler);

  /**
   * Lets go of all graphics resources when the window's context ends, and at once of those of
   * another window. To be called in every frame, before Update.
   */
  void HoldContext(vtkOpenGLRenderWindow* window);
  /** Gives back what it holds in the window's context; without a window nothing happens. */
  void Release(vtkWindow* window);

  /** Brings the lights up to date. Returns false, after an error, when it cannot. */
  virtual bool Update(const Input& input) = 0;
  /** Default: the owner's number of lights, and nothing else. */
  virtual vtkIndirectSamplerAbilities GetAbilities() const;
  /** Finds senders for samplers that take some, and makes no lights of them; null: it cannot. */
  virtual const vtkIndirectFurtherSenders* UpdateSenders(const Input&) { return nullptr; }
  /**
   * Makes the pattern by which lights are taken from the surfaces that the eye sees where a
   * headlight is the only light; null: the pipeline's own pattern does.
   */
  virtual vtkIndirectMapSampler* GetViewPattern() { return nullptr; }
  /** Says what the last frame's lights were made of. Default: nothing. */
  virtual void AddToReport(vtkIndirectReport&) const {}
  /** Bytes of textures and buffers. */
  virtual size_t GetBytes() const;

  /** Number of lights in the last frame. */
  int GetActualNumberOfLights() const { return this->NumberOfLights; }
  const vtkIndirectTarget& GetTable() const { return this->Table; }
  /**
   * The nodes of a tree below the lights, vtkIndirectKernels::VTKI_BRANCHES a light; null where no
   * light has any.
   */
  const vtkIndirectTarget* GetBranches() const { return this->Branches.get(); }
  /**
   * The lights' specular lobes, in the places of their lights; null where none has one. A receiver
   * gets of a lobe what vtkiSenderLobeWeight says (vtkIndirectLibSenderLobe.glsl).
   */
  const vtkIndirectTarget* GetLobes() const { return this->Lobes.get(); }
  /** Grows whenever the lights have changed, or have been released. */
  vtkMTimeType GetContentTime() const { return this->ContentTime.GetMTime(); }
  /** Grows with the owner's settings. */
  vtkMTimeType GetSettingsTime() const;

protected:
  /** Gives back the resources of a subclass, in the context of this window. */
  virtual void ReleaseOwn(vtkWindow*) {}
  /** Makes room in the table. Returns false, after an error, when OpenGL refuses. */
  bool Resize(vtkOpenGLRenderWindow* window, int numberOfLights);
  /** The table, to be filled; then the lights have changed. */
  vtkIndirectTarget& BeginChange();
  /**
   * Makes these the lights, of a source that is no vtkLight, with the branches of all of them or
   * none, and with lobes where one of the lights has one; branches have none. Returns false, after
   * an error, when OpenGL refuses.
   */
  bool Write(const vtkIndirectFrame& frame, const std::vector<Row>& lights,
    const std::vector<Row>& branches = {});
  /**
   * Room for the lobes of the lights that Resize made room for, to be filled; null, after an error,
   * when OpenGL refuses.
   */
  vtkIndirectTarget* MakeLobes(vtkOpenGLRenderWindow* window);
  /** From now on no light has a lobe. */
  void ReleaseLobes(vtkWindow* window);

private:
  static void Fill(vtkIndirectTarget& table, const std::vector<Row>& rows, double source);
  bool WriteLobes(vtkOpenGLRenderWindow* window, const std::vector<Row>& lights);
  void ReleaseBranches(vtkWindow* window);

  vtkVirtualLightSampler* Owner;
  vtkSmartPointer<vtkIndirectContextGuard> Guard;
  vtkIndirectTarget Table;
  std::unique_ptr<vtkIndirectTarget> Branches;
  std::unique_ptr<vtkIndirectTarget> Lobes;
  vtkTimeStamp ContentTime;
  int NumberOfLights = 0;
};

#endif
