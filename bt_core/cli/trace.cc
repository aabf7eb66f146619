#include <algorithm>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <utility>

#include "bt_core/base/command_line.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/engine/executor.h"

namespace coppice {
namespace {

using Json = nlohmann::ordered_json;

// Real time hardly passes between ticks that follow each other at once, but it does pass.
constexpr Duration kDefaultStep = std::chrono::microseconds(1);

constexpr double kMostTicks = 1e15;
constexpr double kLongestStep = 1e9;  // ms: twelve days

// What the scripted leaves have in common: their scripts, and the list of what happened in this
// tick.
struct Stage {
  std::map<std::string, std::vector<Status>> scripts;
  Json events = Json::array();
};

class ScriptedLeaf : public Leaf {
 public:
  ScriptedLeaf(Stage& stage, std::string name) : stage_(stage), name_(std::move(name)) {}

  Status Tick(bool) override {
    Status result = Status::kSuccess;
    const auto script = stage_.scripts.find(name_);
    if (script != stage_.scripts.end() && !script->second.empty()) {
      const std::size_t last = script->second.size() - 1;
      result = script->second[std::min(next_++, last)];
    }
    stage_.events.push_back({"tick", name_, ToString(result)});
    return result;
  }
  void Halt() override { stage_.events.push_back({"halt", name_}); }

 private:
  Stage& stage_;
  std::string name_;
  std::size_t next_ = 0;
};

bool ReadStatus(const Json& text, Status& status) {
  for (const Status known :
       {Status::kRunning, Status::kSuccess, Status::kFailure, Status::kSkipped}) {
    if (text.is_string() && text.get<std::string>() == ToString(known)) {
      status = known;
      return true;
    }
  }
  return false;
}

bool ReadScripts(const std::string& path, Stage& stage) {
  std::ifstream file(path);
  const Json json = Json::parse(file, nullptr, false);
  if (!json.is_object() || !json.contains("leaves") || !json["leaves"].is_object()) {
    std::cerr << path << ": error: expected {\"leaves\": {\"name\": [\"SUCCESS\", ...]}}\n";
    return false;
  }
  for (const auto& [name, entries] : json["leaves"].items()) {
    for (const Json& entry : entries) {
      Status status;
      if (!ReadStatus(entry, status)) {
        std::cerr << path << ": error: leaf \"" << name << "\": " << entry
                  << " is not RUNNING, SUCCESS, FAILURE or SKIPPED\n";
        return false;
      }
      stage.scripts[name].push_back(status);
    }
  }
  return true;
}

// In one line, whatever bytes the names are made of.
void Print(const Json& json) {
  std::cout << json.dump(-1, ' ', false, Json::error_handler_t::replace) << "\n";
}

void PrintTicks(std::shared_ptr<const Program> program, Stage& stage, std::int64_t ticks,
                Duration step) {
  SimulatedClock clock(std::chrono::seconds(1));
  Executor executor(std::move(program), clock, {ExceptionPolicy::kRethrow});
  for (std::int64_t tick = 1; tick <= ticks; ++tick) {
    stage.events = Json::array();
    try {
      const Status status = executor.Tick();
      Print({{"tick", tick}, {"status", ToString(status)}, {"events", stage.events}});
    } catch (const TickError& error) {
      std::cerr << "tick " << tick << ": " << error.what() << "\n";
      return Print({{"tick", tick}, {"error", true}});
    }
    clock.Advance(step);
  }
}

}  // namespace

const Command& TraceCommand() {
  static const Command command{
      "coppice trace",
      "run a tree with scripted leaves",
      {"FILE", 1, 1},
      R"(Runs a tree whose leaves are scripted and prints what each tick did, one JSON line per tick.
SCRIPT: {"leaves": {"name": ["RUNNING", "SUCCESS"]}}, one entry per tick of the leaf, the last one
repeats; a leaf without script succeeds. Leaves are all nodes that are not built in.)",
      {CommandOption::Text("--leaves", "SCRIPT.json", "what the leaves do"),
       CommandOption::Whole("--ticks", "N", 0, kMostTicks, "how many; else 1"),
       CommandOption::Text("--tree", "ID", "which tree of the file; else the main one"),
       CommandOption::Whole(
           "--step", "MS", 0, kLongestStep,
           "time that passes from tick to tick, for Timeout and the like; else 0.001")}};
  return command;
}

int RunTrace(const Arguments& arguments) {
  const Options options = ParseOptions(TraceCommand(), arguments);
  if (options.exit) return *options.exit;
  Stage stage;
  if (options.Has("--leaves") && !ReadScripts(options.Get("--leaves"), stage)) return 2;

  auto registry = std::make_shared<Registry>();
  registry->SetFallback(
      [&stage](const std::string& name) { return std::make_unique<ScriptedLeaf>(stage, name); });
  Diagnostics diagnostics;
  auto program = CompileFile(options.files[0], registry, diagnostics, options.Get("--tree"));
  std::cerr << diagnostics.ToString();
  if (!program) {
    Print({{"load_error", true}});
    return 2;
  }
  PrintTicks(
      std::move(program), stage, options.Whole("--ticks", 1),
      options.Has("--step") ? std::chrono::milliseconds(options.Whole("--step", 0)) : kDefaultStep);
  return 0;
}

}  // namespace coppice
