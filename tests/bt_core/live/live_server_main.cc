// Runs the watched tree with a live view on a free port, until its input ends. Prints the port,
// that of browsers (0 without "web") and, with COPPICE_LIVE_TOKEN in the environment, the tokens:
// that of readers, and for browsers those of control and readers.
//
// usage: bt_core_live_server [deadline_ms=N] [wait_ms=N] [history_kib=N] [read_only] [moving] [two]
//                            [web=FOLDER]
//   two: another tree at the same ports
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <optional>
#include <string>
#include <thread>

#include "bt_core/engine/runner.h"
#include "bt_core/live/server/live_publisher.h"
#include "bt_core/live/server/token_keys.h"
#include "tests/bt_core/live/watched_tree.h"

namespace {

coppice::LiveOptions ReadOptions(int count, char** arguments, bool& two) {
  coppice::LiveOptions options;
  options.port = 0;
  if (const char* token = std::getenv(coppice::kTokenVariable)) options.token = token;
  for (int i = 1; i < count; ++i) {
    const std::string argument = arguments[i];
    const std::string name = argument.substr(0, argument.find('='));
    const int number = std::atoi(argument.c_str() + std::min(name.size() + 1, argument.size()));
    if (name == "deadline_ms") options.deadline = std::chrono::milliseconds(number);
    if (name == "wait_ms") options.wait_for_client = std::chrono::milliseconds(number);
    if (name == "history_kib") options.history_bytes = static_cast<std::size_t>(number) << 10;
    if (name == "read_only") options.read_only = true;
    if (name == "moving") options.permission = [] { return coppice::Problem{"the robot moves"}; };
    if (name == "web") {
      options.web = true;
      options.web_port = 0;
      options.web_folder = argument.substr(argument.find('=') + 1);
    }
    if (name == "two") two = true;
  }
  return options;
}

coppice::LiveTreeOptions Named(const char* name) {
  coppice::LiveTreeOptions options;
  options.name = name;
  return options;
}

coppice::RunOptions ForEver() {
  coppice::RunOptions options;
  options.period = std::chrono::milliseconds(10);
  options.forever = true;
  return options;
}

// A tree that runs on a thread of its own.
class Companion {
 public:
  explicit Companion(coppice::LiveServer& server)
      : publisher_(stream_, server, Named("companion")), thread_([this] { runner_.Run(); }) {}
  ~Companion() {
    runner_.Stop();
    thread_.join();
  }

 private:
  coppice::WallClock clock_;
  coppice::Executor executor_{coppice::WatchedProgram(), clock_};
  coppice::EventStream stream_{executor_};
  coppice::LivePublisher publisher_;
  coppice::Runner runner_{executor_, ForEver()};
  std::thread thread_;
};

}  // namespace

int main(int count, char** arguments) {
  bool two = false;
  const coppice::LiveOptions live_options = ReadOptions(count, arguments, two);
  coppice::WallClock clock;
  coppice::Executor executor(coppice::WatchedProgram(), clock);
  coppice::EventStream stream(executor);
  coppice::LiveServer server(live_options);
  const coppice::LivePublisher live(stream, server, live_options);
  std::optional<Companion> companion;
  if (two) companion.emplace(server);
  if (live_options.wait_for_client == coppice::Duration::zero()) {
    executor.Tick();  // from here on there is something to see
    stream.Flush();
  }
  const coppice::LiveWeb& web = live.web();
  std::cout << live.port() << " " << web.port << " " << live.read_token() << " "
            << web.control_token << " " << web.read_token << std::endl;

  coppice::Runner runner(executor, ForEver());
  std::thread input([&] {
    for (std::string line; std::getline(std::cin, line);) {
    }
    runner.RequestStop();
  });
  runner.Run();
  input.join();
  companion.reset();
  std::cout << executor.ticks() << " ticks" << std::endl;
  return 0;
}
