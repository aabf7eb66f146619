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
      ticked_child_(shape_.size() + 1) {
  statuses_.resize(shape_.size(), Status::kIdle);
  last_.resize(shape_.size(), Status::kIdle);
  for (const NodeShape& shape : shape_) asked_by_.push_back(shape.parent);
  if (!asked_by_.empty()) asked_by_[0] = NodeIndex(static_cast<std::uint32_t>(shape_.size()));
}

// Watched trees spend most of the time here, so there is nothing in the loop that could be outside
// of it.
const std::uint32_t* StatusFollower::Note(const std::uint32_t* at, const std::uint32_t* end) {
  const std::size_t size = shape_.size();
  const NodeIndex* const asked_by = asked_by_.data();
  Status* const statuses = statuses_.data();
  Status* const lasts = last_.data();
  NodeIndex* const ticked_child = ticked_child_.data();
  for (; at != end; ++at) {
    const std::uint32_t code = *at & 7;
    if (code > static_cast<std::uint32_t>(EventCode::kSkipped)) break;
    const NodeIndex node(*at >> 3);
    if (node >= size) continue;
    statuses[node] = static_cast<Status>(code);
    if (code == 0) continue;
    lasts[node] = static_cast<Status>(code);
    ticked_child[asked_by[node]] = node;
  }
  return at;
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
