// Questions about the last tick of a run: why, and why not.
#ifndef COPPICE_TESTS_BT_CORE_ANALYSIS_ASKED_RUN_H_
#define COPPICE_TESTS_BT_CORE_ANALYSIS_ASKED_RUN_H_

#include <gtest/gtest.h>

#include "bt_core/analysis/why/why_text.h"
#include "tests/bt_core/analysis/recorded_run.h"

namespace coppice {

// A run that is asked about its last tick.
class Asked {
 public:
  explicit Asked(const Recording& run) : run_(run) {
    Diagnostics diagnostics;
    tree_ = CompileRecorded(run.trees().back(), std::make_shared<Registry>(), diagnostics);
    EXPECT_EQ(diagnostics.ToString(), "");
  }

  Why Ask(const std::string& path) {
    Diagnostics diagnostics;
    const NodeIndex node = tree_.Find(path, diagnostics);
    EXPECT_EQ(diagnostics.ToString(), "");
    std::size_t last = run_.ticks().size() - 1;
    const TickView now = run_.Before(last);
    std::optional<TickView> before;
    if (const auto earlier = run_.TickBefore(last)) before = run_.Before(*earlier);
    return WhyOf(tree_, now, before ? &*before : nullptr, node);
  }

  std::string Print(const std::string& path) { return PrintWhy(tree_, Ask(path), run_.start()); }
  std::string WhyNotText(const std::string& path) {
    const Why why = Ask(path);
    return why.why_not ? SentenceOf(tree_, *why.why_not) : "it was ticked";
  }
  std::string Json(const std::string& path) { return WhyToJson(tree_, Ask(path), run_.start()); }
  const RecordedTree& tree() const { return tree_; }

 private:
  const Recording& run_;
  RecordedTree tree_;
};

class Lamp final : public Condition {
 public:
  static constexpr const char* kDescription = "Is it dark?";
  Input<double> lux{this, "lux", "brightness"};
  bool Check() override { return *lux < 10; }
};

inline std::shared_ptr<Registry> Lamps() {
  auto registry = std::make_shared<Registry>();
  registry->Register<Lamp>("Lamp");
  return registry;
}

inline constexpr char kPatrol[] =
    "<BehaviorTree ID='Main'><Fallback name='root'><Sequence name='safety'>"
    "<ScriptCondition name='battery_low' code='battery &lt; 20'/><AlwaysSuccess name='dock'/>"
    "</Sequence><Sequence name='work'><Lamp name='dark' lux='{lux}'/><Sleep name='drive' "
    "msec='1000'/></Sequence></Fallback></BehaviorTree>";

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_ANALYSIS_ASKED_RUN_H_
