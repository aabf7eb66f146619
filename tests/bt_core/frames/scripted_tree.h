// A tree whose leaves do what the test says: statuses, values and messages.
#ifndef COPPICE_TESTS_BT_CORE_FRAMES_SCRIPTED_TREE_H_
#define COPPICE_TESTS_BT_CORE_FRAMES_SCRIPTED_TREE_H_

#include <functional>
#include <memory>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>

#include "bt_core/engine/executor.h"

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

inline std::shared_ptr<const Program> CompileScripted(LeafScript& script, const std::string& xml) {
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

inline std::shared_ptr<const Program> ScriptedProgram(LeafScript& script) {
  return CompileScripted(script, R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main"><Sequence name="top">
    <Scripted name="first" number="{number}" ratio="{ratio}"/>
    <Fallback><Scripted name="second" text="{text}"/><Scripted name="third"/></Fallback>
  </Sequence></BehaviorTree></root>)");
}

/// What the same tree may be swapped for.
inline std::shared_ptr<const Program> OtherScriptedProgram(LeafScript& script) {
  return CompileScripted(script, R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <BehaviorTree ID="Main"><Sequence name="top">
    <Scripted name="first" number="{number}" ratio="{ratio}"/>
    <Scripted name="new" text="{text}"/>
  </Sequence></BehaviorTree></root>)");
}

/// Lets a second or less go by, gives the leaves something to do, and ticks.
inline void TickAtRandom(std::mt19937& random, LeafScript& script, SimulatedClock& clock,
                         Executor& executor) {
  clock.Advance(Duration(random() % 1000000));
  script.write = random() % 3 == 0;
  script.number = static_cast<int>(random());
  script.ratio = static_cast<double>(random()) / 7;
  script.text.assign(random() % 40, static_cast<char>(random()));
  script.message = random() % 4 ? "" : "message " + std::to_string(random());
  script.status = [&random] { return static_cast<Status>(1 + random() % 4); };
  if (random() % 20 == 0) executor.Halt();
  executor.Tick();
}

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_FRAMES_SCRIPTED_TREE_H_
