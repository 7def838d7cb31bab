#pragma once

#include <vtkOpenGLContextDevice2D.h>

#include "base/colour.hpp"

class vtkContext2D;

namespace fingerpad {

/// The screen as drawings are painted onto it, light or dark: it knows which, so that whatever paints a
/// drawing there can ask (colour_on).
class ThemeDevice : public vtkOpenGLContextDevice2D {
 public:
  static ThemeDevice* New();
  vtkTypeMacro(ThemeDevice, vtkOpenGLContextDevice2D);

  void set_dark(bool dark) { dark_ = dark; }
  bool dark() const { return dark_; }

 private:
  bool dark_ = false;
};

/// What a drawing's colour becomes where it is dark: greys change places, so that paper is dark and ink
/// bright; colours, which mean something, stay.
Colour in_the_dark(const Colour& colour);

/// A drawing's colour as this painter shows it.
Colour colour_on(vtkContext2D* painter, const Colour& colour);

}  // namespace fingerpad
