// SPDX-License-Identifier: BSD-3-Clause
#include "Pipeline/vtkIndirectIdleFrames.h"

#include "vtkCommand.h"
#include "vtkRenderWindow.h"

namespace
{
// Milliseconds from a frame to the next: events that have come in meanwhile are handled first.
constexpr unsigned long Pause = 10;
}

//------------------------------------------------------------------------------
vtkIndirectIdleFrames::vtkIndirectIdleFrames()
{
  this->Command->SetClientData(this);
  this->Command->SetCallback(&vtkIndirectIdleFrames::OnTimer);
}

//------------------------------------------------------------------------------
vtkIndirectIdleFrames::~vtkIndirectIdleFrames()
{
  this->Stop();
}

//------------------------------------------------------------------------------
void vtkIndirectIdleFrames::Stop()
{
  if (this->Interactor)
  {
    this->Interactor->RemoveObserver(this->Tag);
  }
  this->Interactor = nullptr;
  this->Timers.clear();
  this->Timer = 0;
}

//------------------------------------------------------------------------------
bool vtkIndirectIdleFrames::CanFollow(vtkRenderWindow* window)
{
  vtkRenderWindowInteractor* const interactor = window->GetInteractor();
  return interactor && interactor->GetInitialized();
}

//------------------------------------------------------------------------------
// A timer of an earlier frame may have fired unnoticed, since an interactor style that is in motion
// has all events to itself. This may be a callback of such a timer, so none is destroyed here: VTK
// 9.1's X interactor steps from the entry of a timer in its list to the next one after the event.
void vtkIndirectIdleFrames::EndFrame(vtkRenderWindow* window, long long left)
{
  const bool goesOn = left > 0 && (!this->IsOwn || left != this->Left);
  this->Left = left;
  this->IsOwn = false;
  vtkRenderWindowInteractor* const interactor = window->GetInteractor();
  if (interactor != this->Interactor)
  {
    this->Stop();
  }
  // Interactors without timers return 0.
  this->Timer = goesOn && CanFollow(window) ? interactor->CreateOneShotTimer(Pause) : 0;
  if (this->Timer == 0)
  {
    return;
  }
  this->Timers.push_back(this->Timer);
  if (!this->Interactor)
  {
    this->Interactor = interactor;
    this->Tag = interactor->AddObserver(vtkCommand::TimerEvent, this->Command);
  }
}

//------------------------------------------------------------------------------
void vtkIndirectIdleFrames::OnTimer(vtkObject*, unsigned long, void* self, void* data)
{
  auto* const idle = static_cast<vtkIndirectIdleFrames*>(self);
  const vtkWeakPointer<vtkRenderWindowInteractor> interactor = idle->Interactor;
  if (!interactor || !data || idle->Timer == 0 || *static_cast<int*>(data) != idle->Timer)
  {
    return;
  }
  // An interactor has an entry of each timer that has fired until somebody destroys the timer.
  std::vector<int>& timers = idle->Timers;
  for (; timers.size() > 1; timers.erase(timers.begin()))
  {
    interactor->DestroyTimer(timers.front());
  }
  // The frame may delete the pass: nothing of it is read after that.
  idle->IsOwn = true;
  interactor->Render();
}
