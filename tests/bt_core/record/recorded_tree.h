// A tree whose leaves do what the test says, for recording: statuses, values and messages.
#ifndef COPPICE_TESTS_BT_CORE_RECORD_RECORDED_TREE_H_
#define COPPICE_TESTS_BT_CORE_RECORD_RECORDED_TREE_H_

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "bt_core/engine/executor.h"
#include "bt_core/record/entries.h"
#include "bt_core/record/record_reader.h"

namespace coppice {

/// What the next ticks of the leaves bring; shared by all leaves of a tree.
struct LeafScript {
  std::function<Status()> status = [] { return Status::kRunning; };
  int number = 0;
  double ratio = 0;
  std::string text;
  bool write = false;
  std::string message;
};

class Scripted : public Leaf {
 public:
  static constexpr NodeCategory kCategory = NodeCategory::kAction;
  static constexpr const char* kDescription = "Does what the script says.";
  Output<int> number{this, "number", "a number"};
  Output<double> ratio{this, "ratio", "a ratio"};
  Output<std::string> text{this, "text", "a text"};
  explicit Scripted(LeafScript* script) : script_(*script) {}
  Status Tick(bool) override {
    if (script_.write) {
      number.Set(script_.number);
      ratio.Set(script_.ratio);
      text.Set(script_.text);
    }
    if (!script_.message.empty()) Say(script_.message);
    return script_.status();
  }

 private:
  LeafScript& script_;
};

inline std::shared_ptr<const Program> RecordedProgram(LeafScript& script) {
  const std::string xml = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main"><Sequence name="top">
    <Scripted name="first" number="{number}" ratio="{ratio}"/>
    <Fallback><Scripted name="second" text="{text}"/><Scripted name="third"/></Fallback>
  </Sequence></BehaviorTree></root>)";
  auto registry = std::make_shared<Registry>();
  registry->Register<Scripted>("Scripted", &script);
  Diagnostics diagnostics;
  auto project = Project::FromText(xml, "recorded.xml", diagnostics);
  if (!project) throw std::runtime_error(diagnostics.ToString());
  auto program = Compile(std::make_shared<const Project>(*std::move(project)), std::move(registry),
                         diagnostics);
  if (!program) throw std::runtime_error(diagnostics.ToString());
  return program;
}

/// Keeps all ticks as a record would.
class Keeper : public TickSink {
 public:
  void OnTick(const TickEvents& events) override {
    RecordedTick tick{events.start,   events.tick, events.result,
                      events.changes, {},          events.messages};
    for (const SlotIndex slot : events.writes) {
      const Value& value = events.blackboard[slot].value;
      tick.writes.push_back(
          {slot, value.has_value() ? RecordedValue(value.Print()) : std::nullopt});
    }
    if (!tick.changes.empty() || !tick.writes.empty() || !tick.messages.empty()) {
      ticks.push_back(tick);
    }
  }
  std::vector<RecordedTick> ticks;
};

/// A tick as text, so that two of them can be compared and printed.
inline std::string Describe(const RecordedTick& tick) {
  std::string text = std::to_string(tick.time.count()) + " #" + std::to_string(tick.tick) + " " +
                     ToString(tick.result);
  for (const StatusChange& c : tick.changes) {
    text += " n" + std::to_string(c.node) + ":" + ToString(c.from) + ">" + ToString(c.to);
  }
  for (const RecordedWrite& w : tick.writes) {
    text += " s" + std::to_string(w.slot) + "=" + w.value.value_or("(none)");
  }
  for (const NodeMessage& m : tick.messages) text += " m" + std::to_string(m.node) + m.text;
  return text;
}

template <class Ticks>
std::vector<std::string> DescribeAll(const Ticks& ticks) {
  std::vector<std::string> texts;
  for (const RecordedTick& tick : ticks) texts.push_back(Describe(tick));
  return texts;
}

/// Everything that a reader finds.
struct WholeRecord {
  std::vector<RecordedTick> ticks;
  std::vector<RecordedNote> notes;
  std::vector<RecordedGap> gaps;
  std::vector<RecordDamage> damages;
  bool closed = false;
};

inline WholeRecord ReadAll(RecordReader& reader) {
  WholeRecord all;
  while (auto entry = reader.Next()) {
    if (auto* tick = std::get_if<RecordedTick>(&*entry)) all.ticks.push_back(*tick);
    if (auto* note = std::get_if<RecordedNote>(&*entry)) all.notes.push_back(*note);
    if (auto* gap = std::get_if<RecordedGap>(&*entry)) all.gaps.push_back(*gap);
  }
  all.damages = reader.damages();
  all.closed = reader.closed();
  return all;
}

inline WholeRecord ReadRecord(const std::string& path) {
  Diagnostics diagnostics;
  auto reader = RecordReader::Open(path, diagnostics);
  if (!reader) throw std::runtime_error(diagnostics.ToString());
  return ReadAll(*reader);
}

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_RECORD_RECORDED_TREE_H_
