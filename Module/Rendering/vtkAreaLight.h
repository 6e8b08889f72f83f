// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkAreaLight
 * @brief A rectangle that sends light: the same radiance everywhere, or an image that may change
 *
 * It lies where a vtkPlaneSource with the same three points does, and sends light to the side that
 * (Point1 - Origin) x (Point2 - Origin) points to. With TwoSided it sends light to the other side,
 * too. The radiance is the same in every direction (Lambert). An image is spread over the rectangle
 * with its first pixel at Origin and its rows along Point1 - Origin; each pixel is a piece of one
 * radiance, the image's times Radiance. The rectangle itself is drawn if Visible is on.
 *
 * @code
 * vtkNew<vtkAreaLight> window;
 * window->SetOrigin(0.0, 1.0, 0.0);
 * window->SetPoint1(0.0, 1.0, 1.0);
 * window->SetPoint2(0.0, 2.0, 0.0);
 * window->SetRadiance(5.0, 5.0, 5.0);
 * pass->AddAreaLight(window);
 * @endcode
 *
 * Direct illumination from dynamic area lights: Nichols and Wyman 2009.
 *
 * @sa vtkAreaLightSampler
 */

#ifndef vtkAreaLight_h
#define vtkAreaLight_h

#include "vtkIndirectEmitterBase.h"
#include "vtkIndirectSettings.h"        // For properties
#include "vtkRenderingIndirectModule.h" // For export macro

#include <vector> // for the radiances

class vtkInformationObjectBaseKey;

class VTKRENDERINGINDIRECT_EXPORT vtkAreaLight final : public vtkIndirectEmitterBase
{
public:
  static vtkAreaLight* New();
  vtkTypeMacro(vtkAreaLight, vtkIndirectEmitterBase);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The key of vtkRenderer::GetInformation under which a renderer keeps its area lights, a
   * vtkCollection, until a pass is switched on. Python's vtkindirect.enable gives them to the pass.
   */
  static vtkInformationObjectBaseKey* AREA_LIGHTS();

  ///@{
  /** A corner, in world coordinates. Default (-0.5, -0.5, 0). */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /** The corner at the end of the image's first row. Default (0.5, -0.5, 0). */
  vtkSetVector3Macro(Point1, double);
  vtkGetVector3Macro(Point1, double);
  ///@}

  ///@{
  /**
   * The corner at the end of the image's first column. Default (-0.5, 0.5, 0). The light is a
   * parallelogram if the edges are not at right angles.
   */
  vtkSetVector3Macro(Point2, double);
  vtkGetVector3Macro(Point2, double);
  ///@}

  enum MethodType
  {
    AUTOMATIC = 0,
    CLOSED_FORM = 1,
    VIRTUAL_LIGHTS = 2
  };

  ///@{
  /**
   * The way that its direct light is computed. CLOSED_FORM: Lambert's polygon and depth maps of
   * points of the rectangle, in the buffer `area`. VIRTUAL_LIGHTS: the estimator sums pieces of the
   * rectangle (vtkAreaLightSampler) as virtual lights, in the buffer `bounce`, and
   * vtkIndirectIlluminationPass::Visibility hides them as any; estimators that take no virtual
   * lights beside the lights' maps leave the closed form, and the report says so. AUTOMATIC: the
   * closed form, or, with an estimator's preset PAPER that takes virtual lights, those of
   * vtkAreaLightSampler::MIN_MAX. Default AUTOMATIC.
   */
  vtkIndirectClampMacro(Method, int, AUTOMATIC, VIRTUAL_LIGHTS);
  void SetMethodToAutomatic() { this->SetMethod(AUTOMATIC); }
  void SetMethodToClosedForm() { this->SetMethod(CLOSED_FORM); }
  void SetMethodToVirtualLights() { this->SetMethod(VIRTUAL_LIGHTS); }
  ///@}

  ///@{
  /** Send light to both sides. Default off. */
  vtkIndirectFlagMacro(TwoSided);
  ///@}

  ///@{
  /**
   * Show the rectangle in the picture: its radiance, or its image, from the sides that it sends
   * light to, in front of the objects that it hides. It is not a prop: it hides nothing from any
   * light, adds to no bounds, and cannot be picked. Default off, because VTK's lights are
   * invisible.
   */
  vtkIndirectFlagMacro(Visible);
  ///@}

  ///@{
  /** Switch the light on. Default on. */
  vtkIndirectFlagMacro(Switch);
  ///@}

  /**
   * Returns the unit normal of the side that it sends light to; (0, 0, 0) if the corners span no
   * area.
   */
  void GetNormal(double normal[3]) const;
  /** Returns the area in world units squared. */
  double GetArea() const;
  /**
   * Returns the mean radiance over its area, Scale included. Times the area it is the radiant flux
   * of one side over pi.
   */
  void GetMeanRadiance(double radiance[3]);

protected:
  vtkAreaLight();
  ~vtkAreaLight() override;

  double Origin[3] = { -0.5, -0.5, 0.0 };
  double Point1[3] = { 0.5, -0.5, 0.0 };
  double Point2[3] = { -0.5, 0.5, 0.0 };

private:
  vtkAreaLight(const vtkAreaLight&) = delete;
  void operator=(const vtkAreaLight&) = delete;

  friend struct vtkIndirectEmitterAccess; // its comments describe the next members

  const std::vector<float>& GetRadiances(int& columns, int& rows);
  bool ShinesInto(const double center[3], double size);
  void ReadRadiances();

  struct SettingsType
  {
    int Method = AUTOMATIC;
    bool TwoSided = false;
    bool Visible = false;
    bool Switch = true;
  };
  SettingsType Settings;

  std::vector<float> Radiances;
  double Mean[3] = { 0.0, 0.0, 0.0 };
  int Columns = 0;
  int Rows = 0;
  vtkMTimeType RadiancesTime = 0; // time of the data that they were read from
  vtkMTimeType FaultTime = 0;     // time of the error that reported why it is off
};

#endif
