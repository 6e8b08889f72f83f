// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkEnvironmentLight
 * @brief Light from all around the scene: the same radiance everywhere, or an image of the sky
 *
 * The light comes from infinitely far away. Without an image it is Radiance from every direction; a
 * surface that sees all of its hemisphere then has the irradiance E = Radiance. An image is
 * equirectangular and shows the surroundings as vtkSkybox does (of VTK up to 9.4, with its default
 * plane): its middle lies ahead (-z), its right half to the right (+x), its upper edge above (+y),
 * all of it turned by Up and Right. Its rows go from the nadir to the zenith, bottom row first, as
 * VTK's readers return them.
 *
 * Values are radiances in VTK's units. Images of bytes are divided by 255; with Encoded on, or
 * where a texture says so, values are decoded. Values that are negative or not finite count
 * as zero, and one warning tells how many there were.
 *
 * @code
 * vtkNew<vtkEnvironmentLight> sky;
 * sky->SetRadiance(1.0, 1.0, 1.0);
 * pass->SetEnvironment(sky);
 * @endcode
 */

#ifndef vtkEnvironmentLight_h
#define vtkEnvironmentLight_h

#include "vtkObject.h"
#include "vtkRenderingIndirectModule.h" // For export macro

#include <vector> // for the cells

class vtkImageData;
class vtkTexture;

class VTKRENDERINGINDIRECT_EXPORT vtkEnvironmentLight : public vtkObject
{
public:
  static vtkEnvironmentLight* New();
  vtkTypeMacro(vtkEnvironmentLight, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Radiance from every direction where there is no image. Default (1, 1, 1); not negative. */
  void SetRadiance(double red, double green, double blue);
  void SetRadiance(const double radiance[3])
  {
    this->SetRadiance(radiance[0], radiance[1], radiance[2]);
  }
  vtkGetVector3Macro(Radiance, double);
  ///@}

  ///@{
  /**
   * An equirectangular image with one (grey), three or four components (the fourth is ignored), of
   * any numeric type. Default null. It takes precedence over Texture.
   */
  virtual void SetImage(vtkImageData* image);
  vtkGetObjectMacro(Image, vtkImageData);
  ///@}

  ///@{
  /** A texture whose input is such an image. Default null. */
  virtual void SetTexture(vtkTexture* texture);
  vtkGetObjectMacro(Texture, vtkTexture);
  ///@}

  ///@{
  /**
   * Whether the values of an image are encoded by the transfer function of sRGB (IEC 61966-2-1), as
   * those of photographs in bytes are. Default off. Those of a texture that says so
   * (vtkTexture::SetUseSRGBColorSpace) are decoded in any case.
   */
  vtkSetMacro(Encoded, bool);
  vtkGetMacro(Encoded, bool);
  vtkBooleanMacro(Encoded, bool);
  ///@}

  ///@{
  /** Factor on the radiance, of an image too. Default 1, range 0 to 1e12. */
  vtkSetClampMacro(Scale, double, 0.0, 1.0e12);
  vtkGetMacro(Scale, double);
  ///@}

  ///@{
  /**
   * Where the upper edge of the image is, in world coordinates, of any length. Default (0, 1, 0).
   */
  vtkSetVector3Macro(Up, double);
  vtkGetVector3Macro(Up, double);
  ///@}

  ///@{
  /**
   * What lies to the right of the image's middle, of any length; the part across Up counts. Default
   * (1, 0, 0).
   */
  vtkSetVector3Macro(Right, double);
  vtkGetVector3Macro(Right, double);
  ///@}

  /** Radiance from a direction in world coordinates, of any length: of the image's nearest pixel.
   */
  void GetRadianceFrom(const double direction[3], double radiance[3]);

  /** The time of the image counts, and that of the texture with its input. */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  /** A piece of the sky: what it sends, and from where. */
  struct Cell
  {
    double Direction[3]; // world, unit, to the middle of the light that it sends
    double Light[3];     // radiance integrated over its solid angle
  };
  /**
   * The whole sky in cells of at most 1.4 degrees, none of them dark: integrals of the image, so
   * that a small bright sun loses nothing. Empty where no light comes from anywhere, or after an
   * error.
   */
  const std::vector<Cell>& GetCells();
#endif

protected:
  vtkEnvironmentLight();
  ~vtkEnvironmentLight() override;

  double Radiance[3] = { 1.0, 1.0, 1.0 };
  vtkImageData* Image = nullptr;
  vtkTexture* Texture = nullptr;
  bool Encoded = false;
  double Scale = 1.0;
  double Up[3] = { 0.0, 1.0, 0.0 };
  double Right[3] = { 1.0, 0.0, 0.0 };

private:
  vtkEnvironmentLight(const vtkEnvironmentLight&) = delete;
  void operator=(const vtkEnvironmentLight&) = delete;

  vtkImageData* FindImage();
  bool IsEncoded() const;
  void MakeCells();

  std::vector<Cell> Cells;
  vtkMTimeType CellsTime = 0; // of what they were made from
};

#endif
