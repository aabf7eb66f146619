#include "bt_core/cli/replay.h"

#include <fnmatch.h>

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <optional>

#include "bt_core/base/command_line.h"
#include "bt_core/cli/replay_printer.h"
#include "bt_core/record/record_reader.h"

namespace coppice {
namespace {

constexpr char kUsage[] =
    "coppice replay FILE [--json] [--node PATTERN] [--from SECONDS] [--to SECONDS]\n"
    "  Prints what happened in a recorded run, tick by tick.\n"
    "  --json     one JSON object per line\n"
    "  --node     only nodes whose path fits, for example 'patrol/*'\n"
    "  --from/to  only that part, in seconds since the start of the record";

/// What of the record is wanted.
struct Filter {
  std::string pattern;  ///< empty: all nodes
  Time from{INT64_MIN};
  Time to = kNever;

  bool Has(Time time) const { return from <= time && time <= to; }
};

// Seconds since the start -> time of the record; false if it is no number.
bool ReadTime(const Options& options, const std::string& name, Time start, Time& time) {
  if (!options.Has(name)) return true;
  const std::string text = options.Get(name);
  char* end = nullptr;
  const double seconds = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0' && seconds > -1e9 && seconds < 1e9) {
    time = start + std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9));
    return true;
  }
  std::cerr << name << " needs a number of seconds, not \"" << text << "\"\nusage: " << kUsage
            << "\n";
  return false;
}

// Keeps what is of the nodes that are wanted. False if nothing is left to show.
bool KeepNodes(RecordedTick& tick, const std::vector<bool>& wanted) {
  const auto remove = [&](auto& list) {
    for (auto at = list.begin(); at != list.end();) {
      at = wanted[at->node] ? at + 1 : list.erase(at);
    }
  };
  remove(tick.changes);
  remove(tick.messages);
  tick.writes.clear();
  return !tick.changes.empty() || !tick.messages.empty();
}

std::vector<bool> Fitting(const std::vector<RecordedNode>& nodes, const std::string& pattern) {
  std::vector<bool> wanted;
  for (const RecordedNode& node : nodes) {
    wanted.push_back(fnmatch(pattern.c_str(), node.path.c_str(), 0) == 0);
  }
  return wanted;
}

ReplaySummary PrintAll(RecordReader& reader, const Filter& filter, ReplayPrinter& printer) {
  const std::vector<bool> wanted = Fitting(reader.header().nodes, filter.pattern);
  printer.Header(reader.header());
  ReplaySummary summary(reader.header());
  std::size_t damages = 0;
  while (true) {
    std::optional<RecordEntry> entry = reader.Next();
    for (; damages < reader.damages().size(); ++damages) printer.Damage(reader.damages()[damages]);
    if (!entry) break;
    const Time time = std::visit([](const auto& e) { return e.time; }, *entry);
    if (!filter.Has(time)) continue;
    if (auto* tick = std::get_if<RecordedTick>(&*entry)) {
      if (!filter.pattern.empty() && !KeepNodes(*tick, wanted)) continue;
    }
    summary.Add(*entry);
    std::visit([&](const auto& e) { printer.Entry(e); }, *entry);
  }
  summary.closed = reader.closed();
  summary.damages = reader.damages().size();
  printer.Summary(summary);
  return summary;
}

}  // namespace

int RunReplay(const std::vector<std::string>& arguments) {
  const std::optional<Options> options =
      ParseOptions(arguments, {"--node", "--from", "--to"}, {"--json"}, kUsage);
  if (!options) return 2;
  if (options->files.size() != 1) {
    std::cerr << "expected one file\nusage: " << kUsage << "\n";
    return 2;
  }
  Diagnostics diagnostics;
  std::optional<RecordReader> reader = RecordReader::Open(options->files[0], diagnostics);
  std::cerr << diagnostics.ToString();
  if (!reader) return 2;

  Filter filter;
  filter.pattern = options->Get("--node");
  const Time start = reader->header().start;
  if (!ReadTime(*options, "--from", start, filter.from)) return 2;
  if (!ReadTime(*options, "--to", start, filter.to)) return 2;

  const auto printer = options->Has("--json") ? MakeJsonPrinter(std::cout, reader->header())
                                              : MakeTextPrinter(std::cout, reader->header());
  return PrintAll(*reader, filter, *printer).complete() ? 0 : 1;
}

}  // namespace coppice
