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
  if (this->Interactor && this->Timer != 0)
  {
    this->Interactor->RemoveObserver(this->Tag);
    this->Interactor->DestroyTimer(this->Timer);
  }
  this->Interactor = nullptr;
  this->Timer = 0;
}

//------------------------------------------------------------------------------
void vtkIndirectIdleFrames::EndFrame(vtkRenderWindow* window, long long left)
{
  const bool goesOn = left > 0 && (!this->IsOwn || left < this->Left);
  this->Left = left;
  vtkRenderWindowInteractor* const interactor = window->GetInteractor();
  if (interactor != this->Interactor || !goesOn)
  {
    this->Stop();
  }
  if (goesOn && this->Timer == 0 && interactor && interactor->GetInitialized())
  {
    // Interactors without timers return 0.
    this->Timer = interactor->CreateOneShotTimer(Pause);
    if (this->Timer != 0)
    {
      this->Interactor = interactor;
      this->Tag = interactor->AddObserver(vtkCommand::TimerEvent, this->Command);
    }
  }
}

//------------------------------------------------------------------------------
void vtkIndirectIdleFrames::OnTimer(vtkObject*, unsigned long, void* self, void* data)
{
  auto* const idle = static_cast<vtkIndirectIdleFrames*>(self);
  const vtkWeakPointer<vtkRenderWindowInteractor> interactor = idle->Interactor;
  if (!interactor || !data || *static_cast<int*>(data) != idle->Timer)
  {
    return;
  }
  idle->Stop();
  idle->IsOwn = true;
  interactor->Render();
  idle->IsOwn = false;
}
