// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkVirtualLightSampler
 * @brief Chooses virtual lights among the texels of the lights' maps
 *
 * A virtual light stands for some texels of a map: position, normal, the area A of the surface that
 * those texels cover, and their reflected radiance times that area, B A (Keller 1997, "Instant
 * radiosity"; Dachsbacher and Stamminger 2005). A light drawn from M texels with probability
 * density p counts 1/p texels, in B A and in A alike, so the sums over all lights do not depend on
 * how many there are.
 *
 * Subclasses make a pattern of map coordinates; this class turns it into lights on the GPU.
 */

#ifndef vtkVirtualLightSampler_h
#define vtkVirtualLightSampler_h

#include "vtkObject.h"
#include "vtkRenderingIndirectModule.h" // For export macro

#include <memory> // for the internals
#include <vector> // for patterns

class vtkGeometryBufferPass;
class vtkImageData;
class vtkIndirectTarget;
class vtkReflectiveShadowMapPass;
class vtkShaderProgram;
class vtkWindow;
struct vtkIndirectFrame;

class VTKRENDERINGINDIRECT_EXPORT vtkVirtualLightSampler : public vtkObject
{
public:
  vtkTypeMacro(vtkVirtualLightSampler, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** Number of virtual lights in the last frame. */
  int GetActualNumberOfLights() const;

  /** Gives back what it holds in the window's context; without a window nothing happens. */
  virtual void ReleaseGraphicsResources(vtkWindow* window);

#ifndef __VTK_WRAP__
  /** A rectangle of texels that lights are drawn from: a face of a map, or the geometry buffer. */
  struct Source
  {
    int Layer = 0;
    int Light = 0; // sources of one light share its lights
    int Size[2] = { 1, 1 };
    bool Disk = false; // only the inscribed disk is lit
    // Faces of a cube: cosine of the cone of light about its axis, -1 for all directions; 2: no
    // cube.
    double CosCone = 2.0;

    bool operator==(const Source& other) const
    {
      return this->Layer == other.Layer && this->Light == other.Light &&
        this->Size[0] == other.Size[0] && this->Size[1] == other.Size[1] &&
        this->Disk == other.Disk && this->CosCone == other.CosCone;
    }
  };

  /** A choice: map coordinates in [0,1), layer, texels that it stands for. */
  struct Sample
  {
    float U;
    float V;
    float Layer;
    float Texels;
  };

  enum Channel
  {
    PositionArea,
    NormalExponent,
    DensityArea
  };
  /** Lights in a row of the textures. */
  static constexpr int RowLength = 256;

  /**
   * Brings the lights up to date with the maps. eye: the geometry buffer when it serves as a
   * headlight's map, else null. Returns false, after an error, when OpenGL refuses.
   */
  bool Update(const vtkIndirectFrame& frame, vtkReflectiveShadowMapPass* maps,
    const vtkGeometryBufferPass* eye);

  const vtkIndirectTarget& GetTarget() const;
  vtkIndirectTarget& GetTarget();
  /** Grows whenever the lights have changed. */
  vtkMTimeType GetContentTime() const
  {
    return this->ContentTime.GetMTime();
  }
  size_t GetBytes() const;

  /** Copies the lights of the last frame: a row each of three texels, in world units. */
  void CopyLights(const vtkIndirectFrame& frame, vtkImageData* image);
#endif

protected:
  vtkVirtualLightSampler();
  ~vtkVirtualLightSampler() override;

#ifndef __VTK_WRAP__
  /** Fills a pattern for these sources; its samples of a source sum to that source's texels. */
  virtual void MakePattern(const std::vector<Source>& sources, std::vector<Sample>& pattern) = 0;
#endif

  vtkTimeStamp ContentTime;

private:
  vtkVirtualLightSampler(const vtkVirtualLightSampler&) = delete;
  void operator=(const vtkVirtualLightSampler&) = delete;

  void UpdatePattern(const vtkIndirectFrame& frame, const std::vector<Source>& sources);

  struct Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
