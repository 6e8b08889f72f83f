// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkIndirectEmitterBase
 * @brief Abstract: a source of light of one radiance everywhere, or of an image of radiances
 *
 * Values are radiances in VTK's units: a surface that sees one radiance in all of its hemisphere
 * has the irradiance E = radiance. Images of bytes are divided by 255; values are decoded with
 * Encoded on, or if a texture declares them encoded. Negative or non-finite values count as zero,
 * and one warning gives their number. An image of fewer scalars than points, or radiances beyond
 * 1e18, cause one error, and the source sends no light.
 *
 * @sa vtkEnvironmentLight vtkAreaLight
 */

#ifndef vtkIndirectEmitterBase_h
#define vtkIndirectEmitterBase_h

#include "vtkIndirectSettings.h" // For properties
#include "vtkObject.h"
#include "vtkRenderingIndirectModule.h" // For export macro

class vtkImageData;
class vtkTexture;

class VTKRENDERINGINDIRECT_EXPORT vtkIndirectEmitterBase : public vtkObject
{
public:
  vtkTypeMacro(vtkIndirectEmitterBase, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Radiance without an image. Default (1, 1, 1); finite and not negative. */
  void SetRadiance(double red, double green, double blue);
  void SetRadiance(const double radiance[3])
  {
    this->SetRadiance(radiance[0], radiance[1], radiance[2]);
  }
  vtkGetVector3Macro(Radiance, double);
  ///@}

  ///@{
  /**
   * An image of one slice with one (grey), three or four components (the fourth is ignored), of any
   * numeric type. Default null. The image takes precedence over Texture.
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
   * Decode the values of an image by the transfer function of sRGB (IEC 61966-2-1), which encodes
   * photographs in bytes. Default off. The values of a texture with
   * vtkTexture::SetUseSRGBColorSpace are decoded in any case.
   */
  vtkIndirectFlagMacro(Encoded);
  ///@}

  ///@{
  /** Factor on the radiance, also of an image. Default 1, range 0 to 1e12. */
  vtkIndirectClampMacro(Scale, double, 0.0, 1.0e12);
  ///@}

  /** Grows also with the image, and with the texture and its pipeline's output. */
  vtkMTimeType GetMTime() override;

protected:
  vtkIndirectEmitterBase();
  ~vtkIndirectEmitterBase() override;

  /** Returns the image in use, up to date; null if there is none. */
  vtkImageData* FindImage();
  /** Returns true if the values of that image are encoded. */
  bool IsEncoded() const;

  double Radiance[3] = { 1.0, 1.0, 1.0 };
  vtkImageData* Image = nullptr;
  vtkTexture* Texture = nullptr;

private:
  struct SettingsType
  {
    bool Encoded = false;
    double Scale = 1.0;
  };
  SettingsType Settings;
  vtkTypeUInt64 PictureRevision = 0; // revision of the image or texture at the last request

  vtkIndirectEmitterBase(const vtkIndirectEmitterBase&) = delete;
  void operator=(const vtkIndirectEmitterBase&) = delete;
};

#endif
