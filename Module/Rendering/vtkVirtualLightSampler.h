// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkVirtualLightSampler
 * @brief Abstract: where virtual lights come from
 *
 * A virtual light is a place that sends light: position, normal, the area A of the surface that it
 * stands for, and that surface's reflected radiance times the area, B A (Keller 1997, "Instant
 * radiosity"; Dachsbacher and Stamminger 2005). Or it is a direction that light comes from, with
 * the solid angle that it stands for and the radiance times that.
 *
 * Where a light falls on something specular, a virtual light has a lobe, too: about the direction
 * in which it is reflected (Dachsbacher and Stamminger 2006, "Splatting indirect illumination", eq.
 * 3).
 *
 * A sampler owns the table of its lights and the time at which they last changed. Subclasses say
 * where the lights come from: vtkMapLightSampler from the lights' maps, others from elsewhere.
 */

#ifndef vtkVirtualLightSampler_h
#define vtkVirtualLightSampler_h

#include "vtkObject.h"
#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkSmartPointer.h"            // For the guard

#include <memory> // for the table
#include <vector> // for rows

class vtkImageData;
class vtkIndirectContextGuard;
class vtkIndirectGeometryBuffer;
class vtkIndirectSurfaces;
class vtkIndirectTarget;
class vtkMapLightSampler;
class vtkOpenGLRenderWindow;
class vtkReflectiveShadowMapPass;
class vtkWindow;
struct vtkIndirectEmitter;
struct vtkIndirectFurtherSenders;
struct vtkIndirectFrame;
struct vtkIndirectReport;

class VTKRENDERINGINDIRECT_EXPORT vtkVirtualLightSampler : public vtkObject
{
public:
  vtkTypeMacro(vtkVirtualLightSampler, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Number of virtual lights that it is asked for. Lights of the sky, of area lights and of what
   * leaves glass are as many, for each of these. Default 256.
   */
  virtual int GetNumberOfLights() { return 256; }

  /** Number of virtual lights in the last frame. */
  int GetActualNumberOfLights() const;

  /** Gives back what it holds in the window's context; without a window nothing happens. */
  virtual void ReleaseGraphicsResources(vtkWindow* window);

#ifndef __VTK_WRAP__
  /** What lights may be made from. */
  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkReflectiveShadowMapPass& Maps;    // without maps where the frame has none
    const vtkIndirectGeometryBuffer& Geometry; // what the eye sees
    double ErrorTolerance = 0.0;               // of the irradiance, over its mean; 0: standard
    int NumberOfBounces = 1;                   // asked for, for samplers that know several
    bool Interactive = false;                  // whether the window gives a frame a second or less
    /** What lights surfaces besides the frame's lights: the sky, and area lights. */
    const std::vector<vtkIndirectEmitter>* Emitters = nullptr;
    /** The scene's surfaces, up to date for samplers that walk. */
    const vtkIndirectSurfaces* Surfaces = nullptr;
    /** Senders of later bounces, for samplers that TakeSenders; null: there are none. */
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

  /**
   * Lets go of all graphics resources when the window's context ends, and at once of those of
   * another window. To be called in every frame, before Update.
   */
  void HoldContext(vtkOpenGLRenderWindow* window);

  /** Brings the lights up to date. Returns false, after an error, when it cannot. */
  virtual bool Update(const Input& input) = 0;

  /** Whether lights may be directions, which takes estimators a little more work. */
  virtual bool HasDirections() const
  {
    return false;
  }

  /** Whether lights come from rays through the scene, of all bounces, and not from maps. */
  virtual bool Walks() const
  {
    return false;
  }

  /** Whether further senders that it is given are among those that its lights are made of. */
  virtual bool TakesSenders() const
  {
    return false;
  }

  /** Whether a still frame of the same scene would have more lights than the last one. */
  virtual bool HasMore() const
  {
    return false;
  }

  /** Says what the last frame's lights were made of. Default: nothing. */
  virtual void AddToReport(vtkIndirectReport&) const {}

  /**
   * The pattern by which lights are taken from what the eye sees where a headlight is the only
   * light; null: the pass's own.
   */
  virtual vtkMapLightSampler* GetViewPattern()
  {
    return nullptr;
  }

  const vtkIndirectTarget& GetTable() const
  {
    return *this->Table;
  }
  /**
   * The nodes of a tree below the lights, vtkIndirectKernels::VTKI_BRANCHES a light; null where no
   * light has any.
   */
  const vtkIndirectTarget* GetBranches() const
  {
    return this->Branches.get();
  }
  /**
   * The lights' specular lobes, in the places of their lights; null where none has one. A receiver
   * gets of a lobe what vtkiSenderLobeWeight says (vtkIndirectLibSenderLobe.glsl).
   */
  const vtkIndirectTarget* GetLobes() const
  {
    return this->Lobes.get();
  }
  /** Grows whenever the lights have changed, or have been released. */
  vtkMTimeType GetContentTime() const
  {
    return this->ContentTime.GetMTime();
  }
  virtual size_t GetBytes() const;
#endif

#ifndef __VTK_WRAP__
  /** A light as the table has it, in scene units. */
  struct Row
  {
    double Position[3];
    double Area;
    double Normal[3];
    double DensityArea[3];
    double Reach = 0.0;
    double BluntArea = 0.0; // of a branch
    /** Unit; what follows is the lobe's, and without density there is none. */
    double LobeDirection[3] = { 0.0, 0.0, 1.0 };
    double LobeExponent = 0.0;
    double LobeDensityArea[3] = { 0.0, 0.0, 0.0 };
  };
#endif

protected:
  vtkVirtualLightSampler();
  ~vtkVirtualLightSampler() override;

#ifndef __VTK_WRAP__
  /** Whether ReleaseGraphicsResources has anything to release in the window's context. */
  bool CanBeOf(vtkWindow* window);

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
#endif

private:
  vtkVirtualLightSampler(const vtkVirtualLightSampler&) = delete;
  void operator=(const vtkVirtualLightSampler&) = delete;

#ifndef __VTK_WRAP__
  static void Fill(vtkIndirectTarget& table, const std::vector<Row>& rows, double source);
  bool WriteLobes(vtkOpenGLRenderWindow* window, const std::vector<Row>& lights);
#endif
  void ReleaseBranches(vtkWindow* window);

  vtkSmartPointer<vtkIndirectContextGuard> Guard;
  std::unique_ptr<vtkIndirectTarget> Table;
  std::unique_ptr<vtkIndirectTarget> Branches;
  std::unique_ptr<vtkIndirectTarget> Lobes;
  vtkTimeStamp ContentTime;
  int NumberOfLights = 0;
};

#endif
