#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <utility>

#include "bt_core/base/command_line.h"
#include "bt_core/base/json.h"
#include "bt_core/base/read_file.h"
#include "bt_core/cli/verbs.h"
#include "bt_core/engine/executor.h"

namespace coppice {
namespace {

// Real time hardly passes between ticks that follow each other at once, but it does pass.
constexpr Duration kDefaultStep = std::chrono::microseconds(1);

constexpr double kMostTicks = 1e15;
constexpr double kLongestStep = 1e9;  // ms: twelve days

// What the scripted leaves have in common: their scripts, and the list of what happened in this
// tick, as JSON.
struct Stage {
  std::map<std::string, std::vector<Status>> scripts;
  std::vector<std::string> events;

  void Add(const std::vector<std::string>& event) {
    events.push_back(JsonArray(event, JsonString));
  }
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
    stage_.Add({"tick", name_, ToString(result)});
    return result;
  }
  void Halt() override { stage_.Add({"halt", name_}); }

 private:
  Stage& stage_;
  std::string name_;
  std::size_t next_ = 0;
};

std::optional<Status> ReadStatus(const JsonValue& json) {
  for (const Status known :
       {Status::kRunning, Status::kSuccess, Status::kFailure, Status::kSkipped}) {
    if (json.is(JsonValue::Kind::kString) && json.text == ToString(known)) return known;
  }
  return std::nullopt;
}

void ReadScripts(const std::string& path, Stage& stage, Diagnostics& diagnostics) {
  const std::optional<std::string> text = ReadFile(path, diagnostics, kLongestJson);
  const auto json = text ? ParseJson(*text, path, diagnostics) : std::nullopt;
  if (!json) return;
  const JsonValue* const leaves = json->Find("leaves");
  if (!leaves || !leaves->is(JsonValue::Kind::kObject)) {
    diagnostics.Error(json->where, "expected {\"leaves\": {\"name\": [\"SUCCESS\", ...]}}");
    return;
  }
  for (const JsonValue& leaf : leaves->children) {
    for (const JsonValue& entry : leaf.children) {
      if (const auto status = ReadStatus(entry)) {
        stage.scripts[leaf.key].push_back(*status);
      } else {
        diagnostics.Error(entry.where, "leaf \"" + leaf.key + "\": " + PrintJson(entry) +
                                           " is not RUNNING, SUCCESS, FAILURE or SKIPPED");
      }
    }
  }
}

void PrintTicks(std::shared_ptr<const Program> program, Stage& stage, std::int64_t ticks,
                Duration step) {
  SimulatedClock clock(std::chrono::seconds(1));
  Executor executor(std::move(program), clock, {ExceptionPolicy::kRethrow});
  for (std::int64_t tick = 1; tick <= ticks; ++tick) {
    stage.events.clear();
    JsonObject line;
    line.Add("tick", static_cast<std::uint64_t>(tick));
    try {
      line.AddText("status", ToString(executor.Tick()));
    } catch (const TickError& error) {
      std::cerr << "tick " << tick << ": " << error.what() << "\n";
      std::cout << line.AddBool("error", true).Finish() << "\n";
      return;
    }
    line.Add("events", JsonArray(stage.events, [](const std::string& event) { return event; }));
    std::cout << line.Finish() << "\n";
    clock.Advance(step);
  }
}

}  // namespace

const Command& TraceCommand() {
  static const Command command{
      "coppice trace",
      "run a tree with scripted leaves",
      {"FILE", 1, 1},
      R"(Runs a tree whose leaves are scripted and prints what each tick did, one JSON line
per tick. SCRIPT: {"leaves": {"name": ["RUNNING", "SUCCESS"]}}, one entry per tick of the
leaf, the last one repeats; a leaf without script succeeds. Leaves are all nodes that are not
built in.)",
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
  Diagnostics diagnostics;
  if (options.Has("--leaves")) ReadScripts(options.Get("--leaves"), stage, diagnostics);
  if (diagnostics.has_errors()) return std::cerr << diagnostics.ToString(), 2;
  auto registry = std::make_shared<Registry>();
  registry->SetFallback(
      [&stage](const std::string& name) { return std::make_unique<ScriptedLeaf>(stage, name); });
  auto program = CompileFile(options.files[0], registry, diagnostics, options.Get("--tree"));
  std::cerr << diagnostics.ToString();
  if (!program) {
    std::cout << JsonObject().AddBool("load_error", true).Finish() << "\n";
    return 2;
  }
  PrintTicks(
      std::move(program), stage, options.Whole("--ticks", 1),
      options.Has("--step") ? std::chrono::milliseconds(options.Whole("--step", 0)) : kDefaultStep);
  return 0;
}

}  // namespace coppice
