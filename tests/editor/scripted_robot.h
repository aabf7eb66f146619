// A robot of which the test says what it does: it tells a history, as robots do.
#ifndef COPPICE_TESTS_EDITOR_SCRIPTED_ROBOT_H_
#define COPPICE_TESTS_EDITOR_SCRIPTED_ROBOT_H_

#include <cstdint>
#include <string>

#include "bt_core/data/value_bytes.h"
#include "bt_core/live/groot2/client_robot_tree.h"
#include "tests/editor/told_source.h"

namespace coppice::editor {

class ScriptedRobot final : public ToldSource {
 public:
  /// `xml`: as robots send it in the Groot2 protocol.
  ScriptedRobot(std::string endpoint, const std::string& xml)
      : ToldSource(std::move(endpoint), true) {
    SetTree(xml);
  }

  void SetTree(const std::string& xml) {
    Diagnostics diagnostics;
    tree_ = ReadRobotTree(xml, name(), diagnostics);
    state_.statuses.assign(tree_.uids.size(), Status::kIdle);
    state_.last = state_.statuses;
    state_.values.clear();
    TellAll();
  }

  /// `before`: the last status of a node that is idle.
  void Set(std::uint16_t uid, Status status, Status before = Status::kIdle) {
    const NodeIndex node = tree_.Find(uid);
    state_.statuses[node] = status;
    state_.last[node] = status == Status::kIdle ? before : status;
    state_.cause = HistoryState::Cause::kJump;
    queue_.OnState(state_);
  }

  /// A tick in which a key gets that text as its value.
  void Write(const std::string& scope, const std::string& key, const std::string& text) {
    SlotIndex slot{0};
    while (slot < slots().size() && (slots()[slot].scope != scope || slots()[slot].name != key)) {
      ++slot;
    }
    std::string bytes;
    AppendValueBytes(Value(text), bytes);
    if (slot == slots().size()) {
      slots().push_back({scope, key, "std::string", true});
      state_.values.push_back(bytes);
      state_.cause = HistoryState::Cause::kJump;
      TellAll();
      return;
    }
    state_.values[slot] = bytes;
    EventWriter words;
    words.Add(EventCode::kWrite, slot, 0, bytes);
    Tick(words.words());
  }

  /// A tick with these events.
  void Tick(EventWords words = {}) {
    ++state_.tick;
    state_.time += std::chrono::milliseconds(100);
    queue_.OnTick({state_.tick, state_.time, Duration(0), state_.statuses[0], true, words});
  }

  void Stop(NodeIndex node) { TellStop(node, tree_.description.nodes[node].path, state_.tick); }

 private:
  std::vector<DescribedSlot>& slots() { return tree_.description.slots; }
  void TellAll() {
    queue_.OnTree(tree_.description);
    queue_.OnState(state_);
  }

  RobotTree tree_;
  HistoryState state_;
};

}  // namespace coppice::editor

#endif  // COPPICE_TESTS_EDITOR_SCRIPTED_ROBOT_H_
