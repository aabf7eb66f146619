#include <chrono>
#include <iostream>
#include <stdexcept>
#include <thread>

#include "bt_core/base/command_line.h"
#include "bt_core/cli/live/interrupt.h"
#include "bt_core/cli/live/remote_recorder.h"
#include "bt_core/cli/verbs.h"

namespace coppice {
namespace {

constexpr auto kLookPeriod = std::chrono::milliseconds(50);
constexpr double kMostMegabytes = 1 << 20;
constexpr std::int64_t kLongest = 365 * 86400;  // s

// Says it once when the connection comes or goes.
class ConnectionPrinter {
 public:
  void Look(const LiveConnection& connection) {
    if (connection.is_live == was_live_ && connection.problem == problem_) return;
    was_live_ = connection.is_live;
    problem_ = connection.problem;
    std::cerr << (was_live_ ? "connected" : "waiting: " + problem_) << std::endl;
  }

 private:
  bool was_live_ = false;
  std::string problem_;
};

int Report(const RemoteRecorder& recorder, const std::string& path) {
  const RemoteRecorder::Counts counts = recorder.counts();
  std::cout << path << ": " << counts.ticks << " ticks, " << counts.bytes << " bytes";
  if (counts.runs > 1) std::cout << ", " << counts.runs << " runs";
  if (counts.lost_ticks > 0) std::cout << ", " << counts.lost_ticks << " ticks are missing";
  std::cout << "\n";
  const std::string error = recorder.error();
  if (!error.empty()) std::cerr << error << "\n";
  return error.empty() && counts.lost_ticks == 0 && counts.runs > 0 ? 0 : 1;
}

int Record(const Options& options, const RemoteRecorderOptions& record) {
  const std::string path = options.Get("-o");
  LiveClientOptions live;
  live.name = "coppice record";
  live.token = TokenFromEnvironment();
  live.tree = options.Get("--tree");
  live.with_past = !options.Has("--from-now");
  const Interrupt interrupt;
  RemoteRecorder recorder(path, record);
  {
    const LiveClient client(options.files[0], recorder, live);
    ConnectionPrinter printer;
    const auto end = std::chrono::steady_clock::now() +
                     std::chrono::seconds(options.Whole("--seconds", kLongest));
    while (!interrupt.came() && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(kLookPeriod);
      printer.Look(recorder.connection());
    }
  }
  recorder.Close();
  return Report(recorder, path);
}

}  // namespace

const Command& RecordCommand() {
  static const Command command{
      "coppice record",
      "record a robot over the network",
      {"HOST:PORT", 1, 1},
      R"(Records a robot into a file for `coppice replay`, until Ctrl+C. Goes on when the connection
breaks; a run that begins anew becomes another file. Prints what is missing, if anything.
A robot that asks for a token finds it in COPPICE_LIVE_TOKEN.)",
      {CommandOption::Text("-o", "FILE", "into that file").Needed(),
       CommandOption::Text("--tree", "NAME", "of several trees, by name or number"),
       CommandOption::Flag("--from-now", "without the past that the robot has kept"),
       CommandOption::Whole("--max-file-mb", "N", 0, kMostMegabytes,
                            "a file that is so long is followed by another: FILE.2, ..."),
       CommandOption::Whole("--keep", "N", 0, kMostMegabytes,
                            "of so many files the oldest is removed"),
       CommandOption::Whole("--seconds", "N", 0, kLongest, "ends by itself")}};
  return command;
}

int RunRecord(const Arguments& arguments) {
  const Options options = ParseOptions(RecordCommand(), arguments);
  if (options.exit) return *options.exit;
  try {
    RemoteRecorderOptions record;
    record.max_file_bytes = static_cast<std::uint64_t>(options.Whole("--max-file-mb", 0)) << 20;
    record.keep_files = static_cast<std::uint32_t>(options.Whole("--keep", 0));
    return Record(options, record);
  } catch (const std::exception& error) {  // no such address, no file
    std::cerr << error.what() << "\n";
    return 2;
  }
}

}  // namespace coppice
