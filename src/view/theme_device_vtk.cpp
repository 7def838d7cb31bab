#include "view/theme_device_vtk.hpp"

#include <vtkContext2D.h>
#include <vtkObjectFactory.h>

#include <algorithm>
#include <cmath>

namespace fingerpad {

vtkStandardNewMacro(ThemeDevice);

Colour in_the_dark(const Colour& colour) {
  const auto [least, most] = std::minmax({colour.red, colour.green, colour.blue});
  constexpr int greyish = 48;  // between the channels
  if (most - least > greyish) return colour;
  constexpr double paper = 26, ink = 236;
  const auto turned = [](std::uint8_t channel) {
    return static_cast<std::uint8_t>(std::lround(paper + (255 - channel) / 255.0 * (ink - paper)));
  };
  return {turned(colour.red), turned(colour.green), turned(colour.blue), colour.opacity};
}

Colour colour_on(vtkContext2D* painter, const Colour& colour) {
  const auto* const device = ThemeDevice::SafeDownCast(painter->GetDevice());
  return device != nullptr && device->dark() ? in_the_dark(colour) : colour;
}

}  // namespace fingerpad
