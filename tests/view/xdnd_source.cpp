#include "view/xdnd_source.hpp"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <chrono>
#include <cstring>
#include <thread>

namespace fingerpad::test {
namespace {

class Source {
 public:
  Source(Display* display, Window target, std::string path)
      : display_(display), target_(target), uri_("file://" + std::move(path) + "\r\n") {
    own_ = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    XSetSelectionOwner(display_, atom("XdndSelection"), own_, CurrentTime);
  }

  std::string drop() {
    const auto version = 5L;
    send("XdndEnter", version << 24, static_cast<long>(atom("text/uri-list")), 0, 0);
    const long middle = 200L << 16 | 200L;
    send("XdndPosition", 0, middle, CurrentTime, static_cast<long>(atom("XdndActionCopy")));
    if (!wait_for("XdndStatus")) return "no XdndStatus came";
    send("XdndDrop", 0, CurrentTime, 0, 0);
    return wait_for("XdndFinished") ? "" : "no XdndFinished came";
  }

 private:
  Atom atom(const char* name) { return XInternAtom(display_, name, False); }

  void send(const char* type, long one, long two, long three, long four) {
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.display = display_;
    event.xclient.window = target_;
    event.xclient.message_type = atom(type);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(own_);
    event.xclient.data.l[1] = one;
    event.xclient.data.l[2] = two;
    event.xclient.data.l[3] = three;
    event.xclient.data.l[4] = four;
    XSendEvent(display_, target_, False, NoEventMask, &event);
    XFlush(display_);
  }

  /// Hands the file's name to who asks for it.
  void serve(const XSelectionRequestEvent& request) {
    XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                    reinterpret_cast<const unsigned char*>(uri_.data()), static_cast<int>(uri_.size()));
    XEvent answer{};
    answer.xselection.type = SelectionNotify;
    answer.xselection.requestor = request.requestor;
    answer.xselection.selection = request.selection;
    answer.xselection.target = request.target;
    answer.xselection.property = request.property;
    answer.xselection.time = request.time;
    XSendEvent(display_, request.requestor, False, NoEventMask, &answer);
    XFlush(display_);
  }

  bool wait_for(const char* type) {
    for (int i = 0; i < 1000; ++i) {
      while (XPending(display_) > 0) {
        XEvent event;
        XNextEvent(display_, &event);
        if (event.type == SelectionRequest) serve(event.xselectionrequest);
        if (event.type == ClientMessage && event.xclient.message_type == atom(type)) return true;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
  }

  Display* display_;
  Window target_, own_;
  std::string uri_;
};

}  // namespace

std::string drop_file(const std::string& display_name, unsigned long window, const std::string& path) {
  Display* const display = XOpenDisplay(display_name.c_str());
  if (display == nullptr) return "no display " + display_name;
  std::string fault = Source(display, window, path).drop();
  XCloseDisplay(display);
  return fault;
}

}  // namespace fingerpad::test
