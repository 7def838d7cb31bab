#include "view/close_request.hpp"

#include <X11/Xlib.h>

namespace fingerpad::test {

std::string ask_to_close(const std::string& display, unsigned long window) {
  Display* const server = XOpenDisplay(display.c_str());
  if (server == nullptr) return "no X server at " + display;
  XEvent event{};
  event.xclient.type = ClientMessage;
  event.xclient.window = window;
  event.xclient.message_type = XInternAtom(server, "WM_PROTOCOLS", False);
  event.xclient.format = 32;
  event.xclient.data.l[0] = static_cast<long>(XInternAtom(server, "WM_DELETE_WINDOW", False));
  event.xclient.data.l[1] = CurrentTime;
  XSendEvent(server, window, False, NoEventMask, &event);
  XCloseDisplay(server);
  return "";
}

}  // namespace fingerpad::test
