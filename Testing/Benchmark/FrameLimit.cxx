#include "FrameLimit.h"

#include "vtkRenderWindow.h"

//------------------------------------------------------------------------------
void FrameLimit::Watch(vtkRenderWindow* window, double seconds)
{
  this->Seconds = seconds;
  window->AddObserver(vtkCommand::StartEvent, this);
  window->AddObserver(vtkCommand::AbortCheckEvent, this);
}

//------------------------------------------------------------------------------
void FrameLimit::Execute(vtkObject* window, unsigned long event, void*)
{
  const auto now = std::chrono::steady_clock::now();
  if (event == vtkCommand::StartEvent)
  {
    this->Start = now;
  }
  else if (std::chrono::duration<double>(now - this->Start).count() > this->Seconds)
  {
    this->WasExceeded = true;
    vtkRenderWindow::SafeDownCast(window)->SetAbortRender(1);
  }
}
