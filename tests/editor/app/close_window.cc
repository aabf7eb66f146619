#include "tests/editor/app/close_window.h"

#include <X11/Xlib.h>
#include <X11/Xutil.h>

#include <cstring>

namespace coppice::editor {
namespace {

Window Find(Display* display, Window below, const std::string& title) {
  char* name = nullptr;
  const bool is_it = XFetchName(display, below, &name) != 0 && name && title == name;
  if (name) XFree(name);
  if (is_it) return below;
  Window root = 0, parent = 0, found = 0;
  Window* children = nullptr;
  unsigned count = 0;
  if (XQueryTree(display, below, &root, &parent, &children, &count) == 0) return 0;
  for (unsigned i = 0; i < count && found == 0; ++i) found = Find(display, children[i], title);
  if (children) XFree(children);
  return found;
}

}  // namespace

bool CloseWindow(const std::string& display_name, const std::string& title) {
  Display* const display = XOpenDisplay(display_name.c_str());
  if (!display) return false;
  const Window window = Find(display, DefaultRootWindow(display), title);
  if (window != 0) {
    XEvent event;
    std::memset(&event, 0, sizeof(event));
    event.xclient.type = ClientMessage;
    event.xclient.window = window;
    event.xclient.message_type = XInternAtom(display, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] =
        static_cast<long>(XInternAtom(display, "WM_DELETE_WINDOW", False));  // NOLINT: Xlib's type
    event.xclient.data.l[1] = CurrentTime;
    XSendEvent(display, window, False, NoEventMask, &event);
  }
  XCloseDisplay(display);
  return window != 0;
}

}  // namespace coppice::editor
