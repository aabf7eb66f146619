// The program of the page; shell.html is the page.
#include <emscripten/emscripten.h>

#include <cstdlib>
#include <iostream>

#include "editor/web/page.h"

using coppice::editor::Page;

// For the script of the page, which has put a file there.
extern "C" EMSCRIPTEN_KEEPALIVE void OpenFile(Page* page, const char* path) { page->Open(path); }

int main() {
  static const coppice::WallClock clock;
  static Page page(clock);
  if (!page.error().empty()) {
    std::cerr << page.error() << "\n";
    return 1;
  }
  if (const char* robot = std::getenv("COPPICE_ROBOT")) page.Connect(robot);
  EM_ASM({ Module.onStart($0); }, &page);
  page.Run();
  return 0;
}
