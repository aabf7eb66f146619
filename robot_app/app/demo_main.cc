// coppice-demo: see demo.h.
#include <csignal>
#include <exception>
#include <iostream>

#include "robot_app/app/demo.h"

namespace {

volatile int interrupted = 0;

}  // namespace

int main(int argc, char** argv) {
  const auto settings = coppice::robot::ReadDemoSettings({argv + 1, argv + argc});
  if (settings.exit) return *settings.exit;
  std::signal(SIGINT, [](int) { interrupted = 1; });
  std::signal(SIGTERM, [](int) { interrupted = 1; });
  try {
    return coppice::robot::RunDemo(settings, interrupted);
  } catch (const std::exception& error) {
    std::cerr << "coppice-demo: " << error.what() << "\n";
    return 2;
  }
}
