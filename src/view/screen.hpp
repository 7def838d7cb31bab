#pragma once

#include <memory>
#include <string>

namespace fingerpad {

/// True if DISPLAY names an X server that answers. VTK ends the process where it finds none, so look before
/// rendering.
bool has_display();

/// A screen that nobody sees (Xvfb), for pictures on a machine without one. DISPLAY names it while it lives;
/// it ends with this object, and with the thread that made it, however that ends.
class VirtualScreen {
 public:
  /// Throws Error (usage) where Xvfb is not installed, and (fault) where it does not start.
  VirtualScreen();
  ~VirtualScreen();
  VirtualScreen(const VirtualScreen&) = delete;
  VirtualScreen& operator=(const VirtualScreen&) = delete;

  const std::string& display() const noexcept { return display_; }

 private:
  std::string display_;           ///< as in DISPLAY
  std::string previous_display_;  ///< put back at the end
  bool had_display_ = false;
  int process_ = -1;
};

/// Something to draw on: empty where there is a display, else a virtual screen, to be kept while anything is
/// drawn. Throws Error as VirtualScreen does.
std::unique_ptr<VirtualScreen> screen_to_draw_on();

/// Throws Error (usage) where no window can open: none is of use on a virtual screen.
/// @param instead  what can be done without one
void need_display(std::string_view instead);

inline constexpr std::string_view picture_instead = "write a picture instead (view --png FILE)";
inline constexpr std::string_view headless_instead =
    "touch without a window (--headless, with --device recorded, network or another that needs none)";

}  // namespace fingerpad
