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

constexpr char kUsage[] =
    "coppice record HOST:PORT -o FILE [--tree NAME] [--from-now] [--max-file-mb N [--keep N]]\n"
    "               [--seconds N]\n"
    "  Records a robot into a file for `coppice replay`, until Ctrl+C. Goes on when the "
    "connection\n"
    "  breaks; a run that begins anew becomes another file. Prints what is missing, if anything.\n"
    "  --tree NAME      of several trees, by name or number\n"
    "  --from-now       without the past that the robot has kept\n"
    "  --max-file-mb N  a file that is so long is followed by another: FILE.2, ...\n"
    "  --keep N         of so many files the oldest is removed\n"
    "  --seconds N      ends by itself\n"
    "  A robot that asks for a token finds it in COPPICE_LIVE_TOKEN.";

constexpr auto kLookPeriod = std::chrono::milliseconds(50);
constexpr std::int64_t kMostMegabytes = 1 << 20;
constexpr std::int64_t kLongest = 365 * 86400;  // s

// At most `most`; `otherwise` if the option is not given; -1 if it is no such number.
std::int64_t NumberOf(const Options& options, const char* name, std::int64_t otherwise,
                      std::int64_t most) {
  if (!options.Has(name)) return otherwise;
  const std::int64_t number = options.GetNumber(name).value_or(-1);
  return number > most ? -1 : number;
}

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

int Record(const Options& options, const RemoteRecorderOptions& record, std::int64_t seconds) {
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
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(seconds);
    while (!interrupt.came() && std::chrono::steady_clock::now() < end) {
      std::this_thread::sleep_for(kLookPeriod);
      printer.Look(recorder.connection());
    }
  }
  recorder.Close();
  return Report(recorder, path);
}

}  // namespace

int RunRecord(const Arguments& arguments) {
  const auto options = ParseOptions(
      arguments, {"-o", "--tree", "--max-file-mb", "--keep", "--seconds"}, {"--from-now"}, kUsage);
  if (!options) return 2;
  const std::int64_t megabytes = NumberOf(*options, "--max-file-mb", 0, kMostMegabytes);
  const std::int64_t keep = NumberOf(*options, "--keep", 0, kMostMegabytes);
  const std::int64_t seconds = NumberOf(*options, "--seconds", kLongest, kLongest);
  if (options->files.size() != 1 || !options->Has("-o") || megabytes < 0 || keep < 0 ||
      seconds < 0) {
    std::cerr << "usage: " << kUsage << "\n";
    return 2;
  }
  try {
    RemoteRecorderOptions record;
    record.max_file_bytes = static_cast<std::uint64_t>(megabytes) << 20;
    record.keep_files = static_cast<std::uint32_t>(keep);
    return Record(*options, record, seconds);
  } catch (const std::exception& error) {  // no such address, no file
    std::cerr << error.what() << "\n";
    return 2;
  }
}

}  // namespace coppice
