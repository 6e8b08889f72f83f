// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkIndirectEstimatorPass
 * @brief Abstract: geometry buffer, maps and virtual lights in, irradiance out
 *
 * The irradiance is in VTK's units, where a constant radiance L over the hemisphere gives E = L and
 * a diffuse surface sends out albedo times E. Its texture has the size of the viewport.
 *
 * Estimators that know how also compute what receivers reflect specularly, by the lobes of VTK's
 * Phong model; see SpecularTransport. It comes without the material's specular colour, by which the
 * composite multiplies it.
 */

#ifndef vtkIndirectEstimatorPass_h
#define vtkIndirectEstimatorPass_h

#include "vtkOpenGLRenderPass.h"
#include "vtkRenderingIndirectModule.h" // For export macro
#include "vtkSmartPointer.h"            // For the guard

#include <memory> // for the target and the voxels
#include <string> // for names
#include <vector> // for names

class vtkGeometryBufferPass;
class vtkIndirectContextGuard;
class vtkIndirectOccupancyVolume;
class vtkIndirectStageTimer;
class vtkIndirectTarget;
class vtkOpenGLRenderWindow;
class vtkReflectiveShadowMapPass;
class vtkShaderProgram;
class vtkVirtualLightSampler;
struct vtkIndirectFrame;
struct vtkIndirectReport;

class VTKRENDERINGINDIRECT_EXPORT vtkIndirectEstimatorPass : public vtkOpenGLRenderPass
{
public:
  vtkTypeMacro(vtkIndirectEstimatorPass, vtkOpenGLRenderPass);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** An estimator has no picture of its own: this is an error. See Estimate. */
  void Render(const vtkRenderState* s) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

  /** Short name for reports, e.g. "gather". */
  virtual const char* GetMethodName() const = 0;
  /** Most bounces that this estimator computes. */
  virtual int GetMaximumNumberOfBounces() const { return 1; }

  ///@{
  /**
   * Whether receivers with Phong's model and a specular coefficient reflect indirect light
   * specularly, where the estimator can compute it. Costs nothing where there are none. Default on.
   */
  vtkSetMacro(SpecularTransport, bool);
  vtkGetMacro(SpecularTransport, bool);
  vtkBooleanMacro(SpecularTransport, bool);
  ///@}
  /** Whether this estimator can compute specular reflection of receivers. */
  virtual bool ComputesGlossy() const { return false; }

  ///@{
  /**
   * Whether what stands between senders and receivers is looked up in voxels of the scene. Without
   * it light passes through everything on its second way. Default off, of radiance hints on.
   */
  vtkSetMacro(Occupancy, bool);
  vtkGetMacro(Occupancy, bool);
  vtkBooleanMacro(Occupancy, bool);
  ///@}

  ///@{
  /** Voxels along the longest edge of the scene. Default 128, range 16 to 128. */
  vtkSetClampMacro(OccupancyResolution, int, 16, 128);
  vtkGetMacro(OccupancyResolution, int);
  ///@}

  /** How often frames of this estimator have made the scene's voxels anew. */
  vtkGetMacro(NumberOfVoxelUpdates, vtkIdType);

#ifndef __VTK_WRAP__
  /**
   * Senders that a shader may look for from one place. Mesa's llvmpipe ends all loops of an
   * invocation after 65535 rounds together, and a round is a sender or four steps on the way to it:
   * this leaves 124 steps a sender, four times what rooms need.
   */
  static constexpr int MaximumNumberOfSegments = 2048;

  /**
   * Lets go of all graphics resources when the window's context ends, also while the pass uses
   * another estimator and does not know this one. To be called in every frame.
   */
  void HoldContext(vtkOpenGLRenderWindow* window);

  /** What a frame's estimate reads; eye stands in for the maps where a headlight needs none. */
  struct Input
  {
    const vtkIndirectFrame& Frame;
    const vtkGeometryBufferPass& Geometry;
    vtkReflectiveShadowMapPass& Maps;
    vtkVirtualLightSampler* Sampler; // null when the estimator asked for none
    bool EyeIsMap;
    int NumberOfBounces = 1;     // as asked for
    bool Caching = true;         // off: nothing may be kept from earlier frames
    double ErrorTolerance = 0.0; // relative; 0: the estimator's own parameters
    std::shared_ptr<vtkIndirectOccupancyVolume> Voxels; // as some frame left them
    bool Still = false; // nothing has changed since this estimator's last frame
  };

  /**
   * The sampler whose lights this estimator reads: the user's, one of its own, or null when it
   * reads the maps themselves.
   */
  virtual vtkVirtualLightSampler* ChooseSampler(vtkVirtualLightSampler* users)
  {
    return users;
  }
  /** The same for a frame whose only light is a headlight, which has no map. */
  virtual vtkVirtualLightSampler* ChooseHeadlightSampler(vtkVirtualLightSampler* users)
  {
    return this->ChooseSampler(users);
  }

  /** Makes the frame's irradiance. Returns false, after an error, when it cannot. */
  virtual bool Estimate(const Input& input, vtkIndirectStageTimer& timer) = 0;
  /**
   * Whether a further Estimate would leave the irradiance as it is while nothing changes. The pass
   * asks for one in every frame until then.
   */
  virtual bool IsConverged() const
  {
    return true;
  }

  ///@{
  /**
   * How the composite reads the last frame's irradiance: a file in glsl/stage with a function
   * `vec3 vtkiFetchIrradiance(vec2 position)`, and what it needs to be bound. Default: a value for
   * every pixel, in the irradiance texture.
   */
  virtual const char* GetIrradianceShader() const
  {
    return "vtkIndirectIrradianceTexture.glsl";
  }
  virtual void ActivateIrradiance(vtkShaderProgram* program);
  virtual void DeactivateIrradiance();
  ///@}
  /**
   * What lobes of a specular coefficient of one reflect, in the unit of the irradiance; null where
   * the last frame has none.
   */
  const vtkIndirectTarget* GetGlossy() const
  {
    return this->HasGlossy ? this->Glossy.get() : nullptr;
  }
  /** Whether a frame's receivers are to reflect specularly. */
  bool WantsGlossy(const vtkIndirectFrame& frame) const;
  /** Irradiance that a stored value of one stands for. */
  double GetIrradianceUnit() const
  {
    return this->IrradianceUnit;
  }
  /** Of textures and buffers. */
  virtual size_t GetBytes() const;
  /** Of voxels, triangles and tables in main memory. */
  virtual size_t GetMainMemoryBytes() const;

  /**
   * The error that the estimator's parameters are chosen by when the pass asks for so much, 0 for
   * nothing; 0 when none of them are. Default: none.
   */
  virtual double FindErrorTolerance(double) const
  {
    return 0.0;
  }

  /** Says what the last frame modelled and left out. Default: one bounce without visibility. */
  virtual void AddToReport(vtkIndirectReport& report) const;
  /** Says whether receivers reflected specularly in the last frame, and if not why. */
  void AddSpecularToReport(vtkIndirectReport& report) const;

  /** Names of buffers of the estimator's own that can be looked at. */
  virtual std::vector<std::string> GetChannelNames() const
  {
    return {};
  }
  /**
   * Draws one of them, of the last frame, into the bound target of the frame's size, which is
   * clear. Returns the number of its components, 1 or 3, or 0 when it cannot.
   */
  virtual int DrawChannel(const std::string&, const vtkIndirectFrame&, const vtkGeometryBufferPass&)
  {
    return 0;
  }
#endif

protected:
  vtkIndirectEstimatorPass();
  ~vtkIndirectEstimatorPass() override;

#ifndef __VTK_WRAP__
  /**
   * Whether the irradiance is stored in 16-bit floats, of which one stands for `unit`, and whether
   * a 16-bit depth buffer comes with it. The default is 32-bit floats, one, and none.
   */
  void SetIrradianceStorage(vtkWindow* window, bool half, double unit, bool depth);

  /**
   * Creates or resizes the texture of what is reflected specularly, stored like the irradiance, for
   * a frame that has it, and releases it for others; HasGlossy says which. After
   * SetIrradianceStorage. Returns false, after an error, when OpenGL refuses.
   */
  bool ResizeGlossy(const Input& input);
  /**
   * Brings the frame's voxels up to date, which all estimators share, and keeps hold of them.
   * Returns whether they differ from those of this estimator's last frame.
   */
  bool UpdateVoxels(const Input& input);
  /** For Occupancy, before anything is summed: voxels, and distances between them. */
  void UpdateSight(const Input& input, vtkIndirectStageTimer& timer);
  /** Whether senders can be hidden: Occupancy is on, and voxels are occupied. */
  bool IsBlocked() const;
  void AddVisibilityToReport(vtkIndirectReport& report) const;

  std::shared_ptr<vtkIndirectOccupancyVolume> Voxels;
#endif

  bool SpecularTransport = true;
  bool HasGlossy = false;
  vtkSmartPointer<vtkIndirectContextGuard> Guard;
  std::unique_ptr<vtkIndirectTarget> Irradiance;
  std::unique_ptr<vtkIndirectTarget> Glossy;
  bool Occupancy = false;
  int OccupancyResolution = 128;
  vtkIdType NumberOfVoxelUpdates = 0;

private:
  size_t VoxelsSeen = 0; // their number of updates
  double IrradianceUnit = 1.0;
  bool IrradianceIsHalf = false;
  bool IrradianceHasDepth = false;
  vtkIndirectEstimatorPass(const vtkIndirectEstimatorPass&) = delete;
  void operator=(const vtkIndirectEstimatorPass&) = delete;
};

#endif
