// SPDX-License-Identifier: BSD-3-Clause
// Several contexts, their resources, and orders of creation and destruction.
#include "HeadlessTestTools.h"

#include "vtkOpenGLFramebufferObject.h"
#include "vtkOpenGLState.h"
#include "vtkTextureObject.h"

#include <cstdio>
#include <filesystem>
#include <thread>
#include <vector>

using namespace headlesstest;

namespace
{
//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(TwoWindows)
{
  SceneWindow first(Red, 64, 48);
  SceneWindow second(Green, 31, 77);
  for (int i = 0; i < 4; ++i)
  {
    first.Window->Render();
    CHECK(first.Window->IsCurrent(), "");
    second.Window->Render();
    CHECK(second.Window->IsCurrent() && !first.Window->IsCurrent(), "");
    // Reading a window makes it current.
    CHECK_IMAGE(first.Window, Red);
    CHECK_IMAGE(second.Window, Green);
    first.Window->SetSize(64 + i, 48);
    second.Window->SetSize(31, 77 - i);
  }
  CHECK(first.Window->GetGenericContext() != second.Window->GetGenericContext(), "");

  // The end of one window leaves the other current and usable.
  first.Window->Render();
  second.Window->Finalize();
  CHECK(first.Window->IsCurrent(), "");
  first.Window->Render();
  CHECK_IMAGE(first.Window, Red);
  second.Window->Render();
  CHECK_IMAGE(second.Window, Green);

  second.Window->MakeCurrent();
  first.Window->PushContext();
  CHECK(first.Window->IsCurrent(), "");
  first.Window->PopContext();
  CHECK(second.Window->IsCurrent(), "");
  second.Window->ReleaseCurrent();
  CHECK(!second.Window->IsCurrent() && !first.Window->IsCurrent(), "");
  first.Window->Render();
  CHECK_IMAGE(first.Window, Red);
}

//------------------------------------------------------------------------------
// A framebuffer of one window keeps its content while the other window is drawn.
VTK_INDIRECT_TEST(Framebuffers)
{
  SceneWindow first(Red);
  SceneWindow second(Green);
  first.Window->Render();
  second.Window->Render();

  vtkNew<vtkOpenGLFramebufferObject> framebuffers[2];
  vtkEGLHeadlessRenderWindow* windows[2] = { first.Window, second.Window };
  for (int i = 0; i < 2; ++i)
  {
    windows[i]->MakeCurrent();
    vtkOpenGLState* state = windows[i]->GetState();
    state->PushFramebufferBindings();
    framebuffers[i]->SetContext(windows[i]);
    framebuffers[i]->PopulateFramebuffer(16, 16, true, 1, VTK_FLOAT, true, 32, 0);
    framebuffers[i]->Bind();
    framebuffers[i]->ActivateDrawBuffer(0);
    CHECK(framebuffers[i]->CheckFrameBufferStatus(GL_FRAMEBUFFER), "");
    state->vtkglViewport(0, 0, 16, 16);
    state->vtkglScissor(0, 0, 16, 16);
    state->vtkglClearColor(0.25f + 0.5f * i, 1e-9f, 1e9f, 1.0f);
    state->vtkglClear(GL_COLOR_BUFFER_BIT);
    state->PopFramebufferBindings();
    CHECK_NO_GL_ERROR();
  }
  for (int i = 0; i < 2; ++i)
  {
    windows[i]->Render();
    CHECK_IMAGE(windows[i], i == 0 ? Red : Green);
  }
  for (int i = 0; i < 2; ++i)
  {
    windows[i]->MakeCurrent();
    vtkOpenGLState* state = windows[i]->GetState();
    state->PushFramebufferBindings();
    framebuffers[i]->Bind();
    framebuffers[i]->ActivateReadBuffer(0);
    float rgba[4] = { 0, 0, 0, 0 };
    glReadPixels(8, 8, 1, 1, GL_RGBA, GL_FLOAT, rgba);
    CHECK(rgba[0] == 0.25f + 0.5f * i && rgba[1] == 1e-9f && rgba[2] == 1e9f, rgba[0]);
    state->PopFramebufferBindings();
    CHECK_NO_GL_ERROR();
  }
  // Released with the window or before it.
  framebuffers[0]->ReleaseGraphicsResources(first.Window);
}

//------------------------------------------------------------------------------
int CountOpenFiles()
{
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd"))
  {
    (void)entry;
    ++count;
  }
  return count;
}

long GetResidentKilobytes()
{
  long pages = 0;
  long resident = 0;
  FILE* file = std::fopen("/proc/self/statm", "r");
  if (file)
  {
    if (std::fscanf(file, "%ld %ld", &pages, &resident) != 2)
    {
      resident = 0;
    }
    std::fclose(file);
  }
  return resident * 4;
}

VTK_INDIRECT_TEST(Recreate)
{
  SceneWindow scene(Red);
  int files = 0;
  long memory = 0;
  for (int i = 0; i < 25; ++i)
  {
    scene.Window->Render();
    CHECK_IMAGE(scene.Window, Red);
    scene.Window->Finalize();
    CHECK(scene.Window->GetGenericContext() == nullptr, "");
    CHECK(scene.Window->GetGLVersion().empty(), scene.Window->GetGLVersion());
    if (i == 4)
    {
      files = CountOpenFiles();
      memory = GetResidentKilobytes();
    }
  }
  CHECK(CountOpenFiles() == files, CountOpenFiles() << " instead of " << files);
  std::cout << "grown by " << GetResidentKilobytes() - memory << " KiB in 20 cycles\n";

  // Twice, and before a first render.
  scene.Window->Finalize();
  vtkNew<vtkEGLHeadlessRenderWindow> unused;
  unused->Finalize();

  for (int i = 0; i < 20; ++i)
  {
    SceneWindow other(Green);
    other.Window->Render();
    CHECK_IMAGE(other.Window, Green);
  }
  CHECK(CountOpenFiles() == files, CountOpenFiles() << " instead of " << files);

  // Only graphics resources.
  scene.Window->Render();
  scene.Window->ReleaseGraphicsResources(scene.Window);
  scene.Window->Render();
  CHECK_IMAGE(scene.Window, Red);
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(DestructionOrder)
{
  // The window before its renderer, which continues in another window.
  {
    SceneWindow scene(Red);
    scene.Window->Render();
    scene.Window = nullptr;
    CHECK(scene.Renderer->GetRenderWindow() == nullptr, "");
    vtkNew<vtkEGLHeadlessRenderWindow> window;
    window->SetSize(20, 20);
    window->AddRenderer(scene.Renderer);
    window->Render();
    CHECK_IMAGE(window, Red);
  }
  // The renderer before its window.
  {
    vtkNew<vtkEGLHeadlessRenderWindow> window;
    window->SetSize(20, 20);
    {
      Scene scene(Red);
      window->AddRenderer(scene.Renderer);
      window->Render();
      window->RemoveRenderer(scene.Renderer);
    }
    Scene scene(Green);
    window->AddRenderer(scene.Renderer);
    window->Render();
    CHECK_IMAGE(window, Green);
  }
  // A removed actor that outlives the window.
  {
    SceneWindow scene(Red);
    scene.Window->Render();
    scene.Renderer->RemoveActor(scene.Actor);
    scene.Window->Render();
    scene.Window = nullptr;
  }
  // Several windows, in both orders, with the other one current.
  for (int i = 0; i < 2; ++i)
  {
    SceneWindow first(Red);
    SceneWindow second(Green);
    first.Window->Render();
    second.Window->Render();
    (i == 0 ? first : second).Window = nullptr;
    SceneWindow& left = i == 0 ? second : first;
    left.Window->Render();
    CHECK_IMAGE(left.Window, i == 0 ? Green : Red);
  }
  // A texture that outlives its window.
  {
    vtkNew<vtkTextureObject> texture;
    SceneWindow scene(Red);
    scene.Window->Render();
    texture->SetContext(scene.Window);
    texture->Create2D(8, 8, 4, VTK_FLOAT, false);
    scene.Window = nullptr;
  }
  // A window that never renders.
  {
    SceneWindow scene(Red);
  }
}

//------------------------------------------------------------------------------
VTK_INDIRECT_TEST(Threads)
{
  SceneWindow scene(Red);
  scene.Window->Render();
  scene.Window->ReleaseCurrent();
  std::thread other(
    [&scene]()
    {
      scene.Window->Render();
      CHECK_IMAGE(scene.Window, Red);
      scene.Window->ReleaseCurrent();
    });
  other.join();
  scene.Window->Render();
  CHECK_IMAGE(scene.Window, Red);

  // While the context is current here, another thread gets an error rather than a crash.
  ErrorCounter errors(scene.Window);
  std::thread refused([&scene]() { scene.Window->Render(); });
  refused.join();
  CHECK(errors.Count == 1, errors.Count);
  scene.Window->Render();
  CHECK_IMAGE(scene.Window, Red);

  // A window in each of several threads.
  std::vector<std::thread> threads;
  std::array<bool, 4> drawn = {};
  for (size_t i = 0; i < drawn.size(); ++i)
  {
    threads.emplace_back(
      [&drawn, i]()
      {
        vtkNew<vtkEGLHeadlessRenderWindow> window;
        window->Initialize();
        drawn[i] = window->GetGenericContext() != nullptr && window->IsCurrent();
      });
  }
  for (auto& thread : threads)
  {
    thread.join();
  }
  CHECK(drawn[0] && drawn[1] && drawn[2] && drawn[3], "");
}
}
