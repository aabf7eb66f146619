// A run of a real tree in the process of the test, as a source of the editor: the test ticks it
// between frames. Every tick takes a millisecond, so that pictures are always the same.
#ifndef COPPICE_TESTS_EDITOR_EXECUTED_SOURCE_H_
#define COPPICE_TESTS_EDITOR_EXECUTED_SOURCE_H_

#include <memory>
#include <string>
#include <utility>

#include "tests/editor/driver.h"
#include "tests/editor/timeline/executed_run.h"
#include "tests/editor/told_source.h"

namespace coppice::editor {

class ExecutedSource final : public ToldSource {
 public:
  ExecutedSource(std::string name, const std::string& trees, bool is_robot = true)
      : ToldSource(std::move(name), is_robot), tree(trees) {
    follow_ = std::make_unique<coppice::editor::Follow>(tree.executor, even_);
  }

  void Ticks(int count) {
    for (int i = 0; i < count; ++i) tree.Tick();
  }
  /// So many ticks do not come through.
  void Lose(std::uint64_t ticks) {
    HistoryGap gap;
    gap.lost_ticks = ticks;
    even_.OnGap(gap);
    follow_->Begin(HistoryState::Cause::kLost);
  }
  void Note(const HistoryNote& note) { queue_.OnNote(note); }
  void Tell(const LiveNotice& notice) { queue_.OnNotice(notice); }
  void StopBefore(NodeIndex node) { TellStop(node, tree.executor.shared_program()->Path(node), 1); }

  ExecutedTree tree;

 private:
  class Even final : public HistoryHandler {
   public:
    explicit Even(HistoryHandler& handler) : handler_(handler) {}
    void OnTree(const TreeDescription& tree) override { handler_.OnTree(tree); }
    void OnState(const HistoryState& state) override { handler_.OnState(state); }
    void OnTick(const TickEvents& events) override {
      TickEvents even = events;
      even.duration = std::chrono::milliseconds(1);
      handler_.OnTick(even);
    }

    void OnGap(const HistoryGap& gap) override { handler_.OnGap(gap); }

   private:
    HistoryHandler& handler_;
  };

  Even even_{queue_};
  std::unique_ptr<coppice::editor::Follow> follow_;
};

/// A door that must be open before the robot passes.
inline constexpr char kDoorTrees[] = R"(<BehaviorTree ID="Main"><Sequence name="mission">
  <Fallback name="door"><Is as="open" name="IsDoorOpen"/>
    <Do as="open it" name="OpenDoor" count="{attempts}"/></Fallback>
  <SubTree ID="Pass" name="pass"/></Sequence></BehaviorTree>
  <BehaviorTree ID="Pass"><Do as="drive" name="Drive" count="{steps}"/></BehaviorTree>)";

/// Adds it to the editor, which owns it, and ticks it.
inline ExecutedSource* AddExecuted(Driver& driver, const std::string& name, int ticks,
                                   bool is_robot = true) {
  auto source = std::make_unique<ExecutedSource>(name, kDoorTrees, is_robot);
  ExecutedSource* added = source.get();
  added->tree.results["drive"] = Status::kRunning;
  added->Ticks(ticks);
  driver.editor.AddRun(std::move(source));
  driver.Frames();
  return added;
}

/// Two records that part in their 13th tick, the second of them shown and compared with the first.
inline bool ComparePartingRuns(Driver& driver) {
  AddExecuted(driver, "a.coppice", 20, false);
  auto other = std::make_unique<ExecutedSource>("b.coppice", kDoorTrees, false);
  other->tree.results["drive"] = Status::kRunning;
  other->Ticks(12);
  other->tree.results["drive"] = Status::kFailure;
  other->Ticks(8);
  driver.editor.AddRun(std::move(other));
  driver.Frames();
  driver.editor.state().run.tab = RunTab::kComparison;
  driver.Frames();
  const bool is_compared = driver.Click("run/compare/a.coppice");
  driver.Frames();
  return is_compared;
}

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_EXECUTED_SOURCE_H_
