// Closes a window as the button in its frame does.
#ifndef COPPICE_TESTS_EDITOR_APP_CLOSE_WINDOW_H_
#define COPPICE_TESTS_EDITOR_APP_CLOSE_WINDOW_H_

#include <string>

namespace coppice::editor {

/// Asks the window of that title to close (WM_DELETE_WINDOW, ICCCM 4.2.8.1). False if there is none
/// on that display.
bool CloseWindow(const std::string& display, const std::string& title);

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_APP_CLOSE_WINDOW_H_
