#include "view/text_width_vtk.hpp"

#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "view/drawing.hpp"

namespace fingerpad {
namespace {

/// A font's file; empty where it is not installed.
std::string installed(const char* file) {
  const std::string path = std::string("/usr/share/fonts/truetype/dejavu/") + file;
  std::error_code ignored;
  return std::filesystem::exists(path, ignored) ? path : "";
}

}  // namespace

void set_font(vtkTextProperty* property, double size, bool bold) {
  static const std::string plain_file = installed("DejaVuSans.ttf");
  static const std::string bold_file = installed("DejaVuSans-Bold.ttf");
  const std::string& file = bold ? bold_file : plain_file;
  if (file.empty()) {
    property->SetFontFamilyToArial();
    property->SetBold(bold ? 1 : 0);
  } else {
    property->SetFontFamily(VTK_FONT_FILE);
    property->SetFontFile(file.c_str());
    property->SetBold(0);
  }
  property->SetFontSize(std::max(1, static_cast<int>(std::lround(size))));
}

double text_width(const std::string& words, double size, bool bold) {
  vtkNew<vtkTextProperty> property;
  set_font(property, size, bold);
  constexpr int pixels_an_inch = 72;  // at which a point is a pixel
  int bounds[4] = {0, -1, 0, -1};
  if (words.empty() || vtkTextRenderer::GetInstance() == nullptr ||
      !vtkTextRenderer::GetInstance()->GetBoundingBox(property, vtkStdString(words), bounds,
                                                      pixels_an_inch)) {
    return 0;
  }
  // SVG keeps a size's fraction, VTK rounds it: the wider of the two has room.
  return (bounds[1] - bounds[0] + 1) * std::max(1.0, size / property->GetFontSize());
}

}  // namespace fingerpad
