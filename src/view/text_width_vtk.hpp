#pragma once

class vtkTextProperty;

namespace fingerpad {

/// The font of all pictures: DejaVu Sans where Debian puts it (tools/setup installs it), else VTK's own.
/// @param size  of an em [px]; VTK draws whole pixels
void set_font(vtkTextProperty* property, double size, bool bold);

}  // namespace fingerpad
