// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkEGLHeadlessRenderWindow
 * @brief   a render window with a real OpenGL context and no display
 *
 * The window owns an OpenGL core-profile context that it makes with EGL, so it renders without an X
 * server, a Wayland compositor or a monitor: on a cluster node with a GPU, and in a container with
 * Mesa's software rasterizer. It behaves as VTK's on-screen OpenGL windows do, except that it is
 * always off screen: SetShowWindow() and SetUseOffScreenBuffers() have no effect.
 *
 * The context is made by the first Render() or Initialize(), on the first of these that works:
 *
 * -# an EGL device that is a GPU,
 * -# Mesa's surfaceless platform,
 * -# an EGL device that renders in software,
 * -# EGL's default display.
 *
 * SetDeviceIndex() selects one EGL device instead; without a call of it VTK_INDIRECT_EGL_DEVICE in
 * the environment does; GetDeviceDescription() describes it. An EGL device that is a GPU but
 * renders in software is refused. The newest OpenGL version that the driver offers is used, from
 * 4.6 down to 3.2. Every window has its own context; windows on the same device share one EGL
 * display, which is closed with the last of them. Finalize() releases the context; rendering again
 * makes a new one.
 *
 * If no context can be made, the first Render() or Initialize() reports one error, which lists the
 * attempts and what to install; see GetLastErrorMessage(). The window then stays empty: Render()
 * has no effect, and reading pixels back returns VTK_ERROR and zeros (depth 1).
 *
 * If the machine has a graphics card, but the context renders in software, the first window of the
 * process reports one warning: the reason, and the remedy. There is no warning if software was
 * requested, by DeviceIndex or by LIBGL_ALWAYS_SOFTWARE, and none for cards that cannot render,
 * such as those of most virtual machines. See GetLastWarningMessage().
 *
 * @par Interactors:
 * An interactor must not need a display either. MakeRenderWindowInteractor() creates a
 * vtkGenericRenderWindowInteractor. A vtkXRenderWindowInteractor, which
 * vtkRenderWindowInteractor::New() creates on Linux, is refused with an error; see
 * vtkIndirectHeadlessFactory for programs that cannot be changed.
 *
 * @warning
 * A thread has one current context, be it of EGL or of GLX. In a program that also draws in an X
 * window from the same thread, call ReleaseCurrent() on one window before the other one is
 * rendered. To go on in another thread, call ReleaseCurrent() in the old one first.
 *
 * @sa
 * vtkIndirectHeadlessFactory vtkGenericOpenGLRenderWindow
 */

#ifndef vtkEGLHeadlessRenderWindow_h
#define vtkEGLHeadlessRenderWindow_h

#include "vtkGenericOpenGLRenderWindow.h"
#include "vtkIndirectHeadlessModule.h" // For export macro

#include <memory> // For std::unique_ptr
#include <string> // For std::string

class VTKINDIRECTHEADLESS_EXPORT vtkEGLHeadlessRenderWindow : public vtkGenericOpenGLRenderWindow
{
public:
  static vtkEGLHeadlessRenderWindow* New();
  vtkTypeMacro(vtkEGLHeadlessRenderWindow, vtkGenericOpenGLRenderWindow);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * True if a window made now, with the default DeviceIndex, can render. Makes a context to find
   * out, once in a process, and reports no error.
   */
  static bool IsSupported();

  /**
   * Reason why the last attempt to make a context failed; empty after a success or without an
   * attempt.
   */
  std::string GetLastErrorMessage();

  /**
   * Reason why the last context renders in software although the machine has a graphics card, and
   * the remedy, in one line. Empty if the context uses the card, if software was requested, and
   * before a context is made. Every window has it; only the first of a process reports it as a
   * warning.
   */
  std::string GetLastWarningMessage();

  ///@{
  /**
   * OpenGL's own description of the context, for instance "4.5 (Core Profile) Mesa 22.3.6" and
   * "llvmpipe (LLVM 15.0.6, 256 bits)". Empty while there is no context.
   */
  std::string GetGLVersion();
  std::string GetGLRenderer();
  ///@}

  /**
   * Source of the context: "EGL device <n>", "EGL surfaceless platform" or "EGL default display".
   * Empty without a context.
   */
  std::string GetPlatformName();

  /**
   * The number of EGL devices, GPUs and software ones, that DeviceIndex can choose from. Unlike in
   * other render windows the default DeviceIndex is -1, which chooses automatically; it is read
   * when the context is made. If the index does not exist, or the device does not work, no other is
   * tried and the window reports an error.
   */
  int GetNumberOfDevices() override;

  /**
   * Description of the EGL device with that index, in one line that begins with "EGL device
   * <index>: hardware" or "EGL device <index>: software". There follow, as far as EGL knows them:
   * the card, the vendor of the driver, the driver (else that of the kernel), the files of the card
   * and of its render node, its number in CUDA, and the index of another device with the same card,
   * as when the drivers of two vendors both list it. Empty for an index that does not exist.
   */
  static std::string GetDeviceDescription(int index);

  ///@{
  /**
   * Make the context, if there is none, and make it current. Initialize() and CreateAWindow() are
   * equivalent.
   */
  void Initialize() override;
  void CreateAWindow() override;
  ///@}

  ///@{
  /**
   * Release all graphics resources, then the context. Finalize() and DestroyWindow() are
   * equivalent.
   */
  void Finalize() override;
  void DestroyWindow() override;
  ///@}

  ///@{
  /**
   * Make the context current in the calling thread, test if it is, or release it from the thread.
   * Without a context MakeCurrent() has no effect.
   */
  void MakeCurrent() override;
  bool IsCurrent() override;
  void ReleaseCurrent() override;
  void PushContext() override;
  void PopContext() override;
  ///@}

  ///@{
  /**
   * The stages of a frame. They have no effect without a context.
   */
  void Render() override;
  void Start() override;
  void End() override;
  void Frame() override;
  void WaitForCompletion() override;
  ///@}

  ///@{
  /**
   * Describe the context's capabilities. Both make it if needed; SupportsOpenGL() reports no error.
   */
  const char* ReportCapabilities() override;
  int SupportsOpenGL() override;
  ///@}

  /**
   * A context of EGL is always direct. Returns 1.
   */
  vtkTypeBool IsDirect() override { return 1; }

  /**
   * This window never takes over a context. Returns false.
   */
  bool InitializeFromCurrentContext() override { return false; }

  ///@{
  /**
   * The window is always off screen, independent of these.
   */
  void SetShowWindow(bool) override {}
  void SetUseOffScreenBuffers(bool) override {}
  ///@}

  /**
   * The EGLContext, or nullptr if there is none. There is no window and no drawable, and the
   * display is not exposed, because interactors would take it for one of X.
   */
  void* GetGenericContext() override;

  ///@{
  /**
   * Interactors that do not need a display.
   */
  vtkRenderWindowInteractor* MakeRenderWindowInteractor() override;
  void SetInteractor(vtkRenderWindowInteractor* interactor) override;
  ///@}

  ///@{
  /**
   * Read depths back. Without a context they return VTK_ERROR and fill in 1.
   */
  float* GetZbufferData(int x1, int y1, int x2, int y2) override;
  int GetZbufferData(int x1, int y1, int x2, int y2, float* z) override;
  int GetZbufferData(int x1, int y1, int x2, int y2, vtkFloatArray* buffer) override;
  ///@}

  void OpenGLInit() override;
  void OpenGLInitContext() override;

protected:
  vtkEGLHeadlessRenderWindow();
  ~vtkEGLHeadlessRenderWindow() override;

  int ReadPixels(
    const vtkRecti& rect, int front, int glFormat, int glType, void* data, int right) override;

private:
  vtkEGLHeadlessRenderWindow(const vtkEGLHeadlessRenderWindow&) = delete;
  void operator=(const vtkEGLHeadlessRenderWindow&) = delete;

  bool EnsureContext();
  void Fail(const std::string& reason);

  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
