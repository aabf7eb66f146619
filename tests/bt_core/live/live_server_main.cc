// Runs the watched tree with a live view on a free port, until its input ends. Prints the port.
#include <iostream>
#include <thread>

#include "bt_core/engine/runner.h"
#include "bt_core/live/live_publisher.h"
#include "tests/bt_core/live/watched_tree.h"

int main() {
  coppice::WallClock clock;
  coppice::Executor executor(coppice::WatchedProgram(), clock);
  coppice::LiveOptions live_options;
  live_options.port = 0;
  const coppice::LivePublisher live(executor, live_options);
  executor.Tick();  // from here on there is something to see
  std::cout << live.port() << std::endl;

  coppice::RunOptions options;
  options.period = std::chrono::milliseconds(10);
  options.forever = true;
  coppice::Runner runner(executor, options);
  std::thread input([&] {
    for (std::string line; std::getline(std::cin, line);) {
    }
    runner.RequestStop();
  });
  runner.Run();
  input.join();
  std::cout << executor.ticks() << " ticks" << std::endl;
  return 0;
}
