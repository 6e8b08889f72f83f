// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIndirectHeadlessFactory
 * @brief   lets existing programs render without a display
 *
 * After vtkIndirectHeadlessFactory::Enable()
 *
 * - vtkRenderWindow::New() returns a vtkEGLHeadlessRenderWindow,
 * - vtkRenderWindowInteractor::New() returns a vtkGenericRenderWindowInteractor. Its Initialize()
 * renders once and its Start() returns at once, so a script that ends in Start() renders and goes
 * on; timers never fire, and events come only from the program itself. Where VTK's test harness has
 * put its vtkTestingInteractor in place, that one is kept.
 *
 * Windows that exist already are not affected, nor are classes that are created by their own name,
 * such as vtkXOpenGLRenderWindow. Disable() brings back what there was before. Neither call changes
 * other factories; this one is asked before them. The factory is off until it is enabled.
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
   * Switch the factory on or off for the whole process. Calling either twice changes nothing.
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
