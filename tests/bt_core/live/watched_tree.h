// A small tree with a SubTree in the middle and a value of every kind, for watching it from
// outside.
#ifndef COPPICE_TESTS_BT_CORE_LIVE_WATCHED_TREE_H_
#define COPPICE_TESTS_BT_CORE_LIVE_WATCHED_TREE_H_

#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "bt_core/engine/executor.h"

namespace coppice {

struct Spot {
  double x = 0;
  double y = 0;
};

template <>
struct ValueTraits<Spot> {
  static constexpr const char* kName = "Spot";
  static bool Parse(std::string_view, Spot&) { return false; }
  static std::string Print(const Spot& spot) {
    return std::to_string(static_cast<int>(spot.x)) + ";" +
           std::to_string(static_cast<int>(spot.y));
  }
};

/// Writes one value of each kind.
class Fill : public SyncAction {
 public:
  static constexpr const char* kDescription = "Writes a value of <each> kind & counts.";
  Output<bool> flag{this, "flag", "a truth"};
  Output<int> number{this, "number", "how often it ran"};
  Output<unsigned long> large{this, "large", "more than 32 bits"};
  Output<double> ratio{this, "ratio", "a half [1]"};
  Output<double> third{this, "third", "no short binary number"};
  Output<std::string> text{this, "text", R"(a "quoted" text)"};
  Output<Spot> spot{this, "spot", "a place [m]"};
  Status Run() override {
    flag.Set(true);
    number.Set(++runs_);
    large.Set(1UL << 40);
    ratio.Set(0.5);
    third.Set(1.0 / 3.0);
    text.Set("näher & näher");
    spot.Set({3, -4});
    return Status::kSuccess;
  }

 private:
  int runs_ = 0;
};

/// Succeeds in its odd runs, fails in the even ones.
class Alternate : public SyncAction {
 public:
  static constexpr const char* kDescription = "Succeeds and fails in turn.";
  Input<std::string> word{this, "word", "not used", "hello"};
  Status Run() override {
    success_ = !success_;
    return success_ ? Status::kSuccess : Status::kFailure;
  }

 private:
  bool success_ = false;
};

class RunForEver : public Action {
 public:
  static constexpr const char* kDescription = "Runs until it is halted.";
  Status OnStart() override { return Status::kRunning; }
  Status OnRunning() override { return Status::kRunning; }
  void OnHalted() override {}
};

inline constexpr const char* kWatchedTree = R"(<root BTCPP_format="4" main_tree_to_execute="Main">
  <!-- uids: ReactiveSequence 1, Fill 2, ForceSuccess 3, SubTree 4, Alternate 5, RunForEver 6 -->
  <BehaviorTree ID="Main">
    <ReactiveSequence name="top &amp; first">
      <Fill flag="{flag}" number="{number}" large="{large}" ratio="{ratio}" third="{third}"
            text="{text}" spot="{spot}"/>
      <ForceSuccess>
        <SubTree ID="Inner" name="inner" said="{text}" literal="7"/>
      </ForceSuccess>
      <RunForEver name="last"/>
    </ReactiveSequence>
  </BehaviorTree>
  <BehaviorTree ID="Inner">
    <Alternate word="{said}"/>
  </BehaviorTree>
</root>)";

inline std::shared_ptr<const Program> CompileText(const std::string& text) {
  auto registry = std::make_shared<Registry>();
  registry->Register<Fill>("Fill");
  registry->Register<Alternate>("Alternate");
  registry->Register<RunForEver>("RunForEver");
  Diagnostics diagnostics;
  auto project = Project::FromText(text, "watched.xml", diagnostics);
  if (!project) throw std::runtime_error(diagnostics.ToString());
  auto program = Compile(std::make_shared<const Project>(*std::move(project)), std::move(registry),
                         diagnostics);
  if (!program) throw std::runtime_error(diagnostics.ToString());
  return program;
}

inline std::shared_ptr<const Program> WatchedProgram() { return CompileText(kWatchedTree); }

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_LIVE_WATCHED_TREE_H_
