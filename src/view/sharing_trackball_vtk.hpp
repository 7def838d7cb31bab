#pragma once

#include <vtkInteractorStyleTrackballCamera.h>

namespace fingerpad {

/// The trackball without its grip on the focus: that would keep timers and keys from us while it turns.
class SharingTrackball : public vtkInteractorStyleTrackballCamera {
 public:
  static SharingTrackball* New();
  vtkTypeMacro(SharingTrackball, vtkInteractorStyleTrackballCamera);

  void OnLeftButtonDown() override;
  void OnMiddleButtonDown() override;
  void OnRightButtonDown() override;

 private:
  bool find_renderer();
};

}  // namespace fingerpad
