#include <iostream>
#include <optional>
#include <string_view>

#include "bt_core/analysis/formats/export.h"
#include "bt_core/analysis/formats/import_btlog.h"
#include "bt_core/analysis/formats/tree_file.h"
#include "bt_core/analysis/formats/write_record.h"
#include "bt_core/analysis/load_recording.h"
#include "bt_core/base/command_line.h"
#include "bt_core/base/read_file.h"
#include "bt_core/cli/replay/replay.h"
#include "bt_core/model/write_file.h"

namespace coppice {
namespace {

bool EndsIn(std::string_view name, std::string_view ending) {
  return name.size() > ending.size() && name.substr(name.size() - ending.size()) == ending;
}

std::optional<Recording> Read(const Options& options, Diagnostics& diagnostics) {
  const std::string& path = options.files[0];
  if (!EndsIn(path, ".btlog")) return LoadRecording(path, diagnostics, MemoryOf(options));
  const std::optional<std::string> bytes = ReadFile(path, diagnostics, kLongestBtlog);
  return bytes ? FromBtlog(*bytes, path, diagnostics) : std::nullopt;
}

std::optional<std::string> ToTreeFile(const Recording& run) {
  return run.trees().empty() ? std::string() : TreeFile(run.trees().back());
}

std::optional<std::string> Convert(const Recording& run, const std::string& out,
                                   Diagnostics& diagnostics) {
  if (EndsIn(out, ".coppice")) return ToRecord(run);
  if (EndsIn(out, ".btlog")) return ToBtlog(run, diagnostics);
  if (EndsIn(out, ".json")) return ToChromeTrace(run);
  if (EndsIn(out, ".csv")) return ToCsv(run);
  if (EndsIn(out, ".bag")) return ToRosbag(run, diagnostics);
  if (EndsIn(out, ".xml")) return ToTreeFile(run);
  diagnostics.Error({out}, "is of no known format",
                    "expected .coppice, .btlog, .json, .csv, .bag or .xml");
  return std::nullopt;
}

}  // namespace

const Command& ConvertCommand() {
  static const Command command{"coppice convert",
                               "turn a recorded run into another format",
                               {"IN OUT", 2, 2},
                               R"(Between formats, which the endings of the names say.
IN:   .coppice   a record
      .btlog     a log of BehaviorTree.CPP's FileLogger2
OUT:  .coppice, .btlog
      .json      trace of Chrome; opens in ui.perfetto.dev
      .csv       changes, writes and messages, one per line
      .bag       bag of ROS 1
      .xml       the tree that ran last, as one file)",
                               {MemoryOption()}};
  return command;
}

int RunConvert(const std::vector<std::string>& arguments) {
  const Options options = ParseOptions(ConvertCommand(), arguments);
  if (options.exit) return *options.exit;
  Diagnostics diagnostics;
  const std::optional<Recording> run = Read(options, diagnostics);
  std::optional<std::string> bytes;
  if (run) bytes = Convert(*run, options.files[1], diagnostics);
  const bool written = bytes && WriteFile(options.files[1], *bytes, diagnostics);
  std::cerr << diagnostics.ToString();
  return written ? 0 : 2;
}

}  // namespace coppice
