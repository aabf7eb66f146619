// https://docs.google.com/document/d/1CvAClvFfyA5R-PhYUmn5OOQtYMH4h6I0nSsKchNAySU, "Trace Event
// Format". Each node is a thread, so that its slices lie on one line, in the order of the tree.
#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>

#include "bt_core/analysis/formats/export.h"
#include "bt_core/analysis/why/run_walk.h"
#include "bt_core/base/json.h"
#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

constexpr std::uint64_t kTickThread = 1;
constexpr std::uint64_t kFirstNodeThread = 2;

std::string Microseconds(Duration time) {
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", static_cast<double>(time.count()) * 1e-3);
  return text;
}

class Tracer final : public RunVisitor {
 public:
  explicit Tracer(Time start) : start_(start) { AddName(kTickThread, "ticks", 0); }

  void OnSection(const TreeDescription& tree, const Recording::Section& section) override {
    EndAll(section.state.time);
    tree_ = &tree;
    since_.assign(tree.nodes.size(), std::nullopt);
    for (NodeIndex node{0}; node < tree.nodes.size(); ++node) {
      const std::string& path = tree.nodes[node].path;
      if (threads_.emplace(path, kFirstNodeThread + threads_.size()).second) {
        AddName(threads_[path], path, threads_[path]);
      }
      if (section.state.statuses[node] == Status::kRunning) since_[node] = section.state.time;
    }
  }

  void OnTickBegin(const TickEvents& events) override {
    now_ = events.start;
    if (events.result == Status::kIdle) return;
    JsonObject tick = Begin("X", "tick " + std::to_string(events.tick), kTickThread, events.start);
    tick.Add("dur", Microseconds(events.duration));
    tick.Add(
        "args",
        JsonObject().Add("tick", events.tick).AddText("result", ToString(events.result)).Finish());
    Add(tick);
  }

  void OnChange(const StatusChange& change, const TickEvents& events) override {
    if (change.to == Status::kRunning) {
      since_[change.node] = events.start;
    } else if (change.from == Status::kRunning) {
      End(change.node, events.start, change.to);
    } else if (change.to != Status::kIdle) {
      JsonObject instant = Begin("i", ToString(change.to), ThreadOf(change.node), events.start);
      Add(instant.AddText("s", "t"));
    }
  }

  void OnEvent(const Event& event, const TickEvents& events) override {
    if (event.code == EventCode::kText && event.text != EventText::kInjected) {
      JsonObject instant = Begin("i", event.bytes, ThreadOf(event.node()), events.start);
      Add(instant.AddText("s", "t"));
    }
    const bool writes = event.code == EventCode::kWrite || event.code == EventCode::kDelivery;
    if (writes && tree_->slots[event.index].has_key) AddCounter(event, events.start);
  }

  std::string Finish() {
    EndAll(now_);
    return "{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n" + json_ + "\n]}\n";
  }

 private:
  std::uint64_t ThreadOf(NodeIndex node) { return threads_[tree_->nodes[node].path]; }

  JsonObject Begin(const char* phase, std::string_view name, std::uint64_t thread, Time time) {
    JsonObject object;
    object.AddText("ph", phase).AddText("name", name).Add("pid", std::uint64_t{1});
    object.Add("tid", thread).Add("ts", Microseconds(time - start_));
    return object;
  }

  void Add(const JsonObject& object) { json_ += (json_.empty() ? "" : ",\n") + object.Finish(); }

  void AddName(std::uint64_t thread, const std::string& name, std::uint64_t place) {
    for (const bool is_name : {true, false}) {
      JsonObject args;
      if (is_name) args.AddText("name", name);
      if (!is_name) args.Add("sort_index", place);
      JsonObject object;
      object.AddText("ph", "M").AddText("name", is_name ? "thread_name" : "thread_sort_index");
      object.Add("pid", std::uint64_t{1}).Add("tid", thread).Add("args", args.Finish());
      Add(object);
    }
  }

  void AddCounter(const Event& event, Time time) {
    const ValueForm form = FormOfValue(event.bytes);
    const bool is_number = form == ValueForm::kBool || form == ValueForm::kSigned ||
                           form == ValueForm::kUnsigned || form == ValueForm::kDouble;
    if (!is_number) return;
    const DescribedSlot& slot = tree_->slots[event.index];
    std::string number = ValueBytesToJson(event.bytes);
    if (form == ValueForm::kBool) number = number == "true" ? "1" : "0";
    if (number.front() == '"' || number == "null") return;  // not a number, infinite
    JsonObject counter = Begin("C", slot.scope + "{" + slot.name + "}", 0, time);
    Add(counter.Add("args", JsonObject().Add("value", number).Finish()));
  }

  void End(NodeIndex node, Time time, Status result) {
    if (!since_[node]) return;
    const std::string& path = tree_->nodes[node].path;
    const char* const how = result == Status::kIdle ? "halted" : ToString(result);
    JsonObject slice = Begin("X", path.substr(path.rfind('/') + 1), ThreadOf(node), *since_[node]);
    slice.Add("dur", Microseconds(time - *since_[node]));
    Add(slice.Add("args", JsonObject().AddText("ends", how).Finish()));
    since_[node].reset();
  }

  void EndAll(Time time) {
    for (NodeIndex node{0}; node < since_.size(); ++node) {
      if (since_[node]) End(node, std::max(time, *since_[node]), Status::kRunning);
    }
  }

  const Time start_;
  const TreeDescription* tree_ = nullptr;
  std::map<std::string, std::uint64_t> threads_;  // per path
  std::vector<std::optional<Time>> since_;        // per node that runs
  Time now_{};
  std::string json_;
};

}  // namespace

std::string ToChromeTrace(const Recording& run) {
  Tracer tracer(run.start());
  WalkRun(run, tracer);
  return tracer.Finish();
}

}  // namespace coppice
