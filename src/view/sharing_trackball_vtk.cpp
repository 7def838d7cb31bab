#include "view/sharing_trackball_vtk.hpp"

#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

namespace fingerpad {

vtkStandardNewMacro(SharingTrackball);

void SharingTrackball::OnLeftButtonDown() {
  if (find_renderer()) this->StartRotate();
}

void SharingTrackball::OnMiddleButtonDown() {
  if (find_renderer()) this->StartPan();
}

void SharingTrackball::OnRightButtonDown() {
  if (find_renderer()) this->StartDolly();
}

bool SharingTrackball::find_renderer() {
  const int* at = this->Interactor->GetEventPosition();
  this->FindPokedRenderer(at[0], at[1]);
  return this->CurrentRenderer != nullptr;
}

}  // namespace fingerpad
