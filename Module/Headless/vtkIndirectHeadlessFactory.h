// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIndirectHeadlessFactory
 * @brief   lets existing programs render without a display
 *
 * After vtkIndirectHeadlessFactory::Enable()
 *
 * - vtkRenderWindow::New() returns a vtkEGLHeadlessRenderWindow,
 * - vtkRenderWindowInteractor::New() returns a vtkGenericRenderWindowInteractor. Its Initialize()
 * renders once and its Start() returns immediately, so a script that ends in Start() renders and
 * continues; timers never fire, and events come only from the program itself. If VTK's test harness
 * has installed its vtkTestingInteractor, that one is kept.
 *
 * Existing windows are not affected, nor are classes that are created by their own name, such as
 * vtkXOpenGLRenderWindow. Disable() restores the previous classes. Neither call changes other
 * factories; this one comes before them. The factory is off until it is enabled.
 *
 * @sa
 * vtkEGLHeadlessRenderWindow
 */

#ifndef vtkIndirectHeadlessFactory_h
#define vtkIndirectHeadlessFactory_h

#include "vtkIndirectHeadlessModule.h" // For export macro
#include "vtkObjectFactory.h"

class VTKINDIRECTHEADLESS_EXPORT vtkIndirectHeadlessFactory : public vtkObjectFactory
{
public:
  static vtkIndirectHeadlessFactory* New();
  vtkTypeMacro(vtkIndirectHeadlessFactory, vtkObjectFactory);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Switch the factory on or off for the whole process. Repeated calls have no effect.
   */
  static void Enable();
  static void Disable();
  static bool IsEnabled();
  ///@}

  const char* GetVTKSourceVersion() override;
  const char* GetDescription() override;

protected:
  vtkIndirectHeadlessFactory();
  ~vtkIndirectHeadlessFactory() override = default;

  vtkObject* CreateObject(const char* className) override;

private:
  vtkIndirectHeadlessFactory(const vtkIndirectHeadlessFactory&) = delete;
  void operator=(const vtkIndirectHeadlessFactory&) = delete;
};

#endif
