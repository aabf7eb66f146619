#include "tests/fuzz/history_check.h"

#include <cstdlib>

namespace coppice::fuzz {

void Require(bool condition) {
  if (!condition) std::abort();
}

void HistoryCheck::OnTree(const TreeDescription& tree) {
  nodes_ = tree.nodes.size();
  slots_ = tree.slots.size();
  shape_ = ShapeOf(tree);
  Require(nodes_ > 0 && shape_[0].end == nodes_);
  follower_.reset();
}

void HistoryCheck::OnState(const HistoryState& state) {
  Require(state.statuses.size() == nodes_ && state.last.size() == nodes_);
  Require(state.values.size() == slots_);
  follower_.emplace(shape_, state);
}

void HistoryCheck::OnTick(const TickEvents& events) {
  Require(follower_.has_value());
  ++ticks_;
  follower_->Apply(
      events, [](const StatusChange&) {}, [this](const Event& event) { Check(event); });
}

void HistoryCheck::Check(const Event& event) const {
  const bool is_slot = event.code == EventCode::kWrite || event.code == EventCode::kDelivery;
  Require(event.index < (is_slot ? slots_ : nodes_));
  Require(event.writer == kNoNode || event.writer < nodes_);
}

}  // namespace coppice::fuzz
