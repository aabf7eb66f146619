#include "bt_core/engine/events/status_follower.h"

#include <utility>

#include "bt_core/engine/program.h"

namespace coppice {

TreeShape ShapeOf(const Program& program) {
  TreeShape shape;
  shape.reserve(program.nodes.size());
  for (NodeIndex node{0}; node < program.nodes.size(); ++node) {
    const NodeRecord& record = program.nodes[node];
    shape.push_back({program.info[node].parent, record.end, RunsOneChild(record.type)});
  }
  return shape;
}

StatusFollower::StatusFollower(TreeShape shape, std::vector<Status> statuses,
                               std::vector<Status> last)
    : shape_(std::move(shape)),
      statuses_(std::move(statuses)),
      last_(last.empty() ? statuses_ : std::move(last)),
      ticked_child_(shape_.size()) {
  statuses_.resize(shape_.size(), Status::kIdle);
  last_.resize(shape_.size(), Status::kIdle);
}

// As Executor::statuses().
void StatusFollower::Settle() {
  for (NodeIndex node{1}; node < shape_.size(); ++node) {
    const NodeIndex parent = shape_[node].parent;
    const NodeIndex ticked = ticked_child_[parent];
    const bool is_behind = shape_[parent].runs_one_child && ticked > parent && node > ticked;
    if (statuses_[parent] != Status::kRunning || is_behind) statuses_[node] = Status::kIdle;
  }
}

}  // namespace coppice
