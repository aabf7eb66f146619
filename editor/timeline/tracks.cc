#include "editor/timeline/tracks.h"

#include <algorithm>
#include <limits>

namespace coppice::editor {
namespace {

// The same texts and nodes, and all slots of the other one. Robots may make keys while they run.
bool Extends(const TreeDescription& tree, const TreeDescription& before) {
  const auto same_text = [](const DescribedDocument& a, const DescribedDocument& b) {
    return a.text == b.text;
  };
  const auto same_node = [](const DescribedNode& a, const DescribedNode& b) {
    return a.path == b.path && a.id == b.id;
  };
  const auto same_slot = [](const DescribedSlot& a, const DescribedSlot& b) {
    return a.scope == b.scope && a.name == b.name && a.type == b.type;
  };
  return tree.main_tree == before.main_tree && tree.slots.size() >= before.slots.size() &&
         std::equal(tree.documents.begin(), tree.documents.end(), before.documents.begin(),
                    before.documents.end(), same_text) &&
         std::equal(tree.nodes.begin(), tree.nodes.end(), before.nodes.begin(), before.nodes.end(),
                    same_node) &&
         std::equal(before.slots.begin(), before.slots.end(), tree.slots.begin(), same_slot);
}

constexpr std::size_t kNoTick = std::numeric_limits<std::size_t>::max();

}  // namespace

Tracks::Tracks(std::shared_ptr<const TreeDescription> tree)
    : tree_(std::move(tree)),
      shape_(ShapeOf(*tree_)),
      lanes_(tree_->nodes.size()),
      ended_in_(tree_->nodes.size(), kNoTick),
      writes_(tree_->slots.size()) {}

void Tracks::Begin(std::size_t tick, const HistoryState& state) {
  touched_.clear();
  for (std::size_t i = 0; i < lanes_.size(); ++i) {
    lanes_[i].Set(tick, i < state.statuses.size() ? state.statuses[i] : Status::kIdle);
  }
}

void Tracks::Add(std::size_t tick, std::size_t word, const TickEvents& events,
                 HistoryFollower& follower) {
  if (word == 0) {
    for (const NodeIndex node : touched_) lanes_[node].Set(tick, follower.status(node));
    touched_.clear();
  }
  changed_.clear();
  returned_.clear();
  restarted_.clear();
  follower.Apply(
      events, [&](const StatusChange& change) { NoteChange(tick, change); },
      [&](const Event& event) { Note(tick, word, events, event); });
  for (const NodeIndex node : changed_) lanes_[node].Set(tick, follower.status(node));
  for (const auto& [node, status] : returned_) {
    lanes_[node].Set(tick, status);
    if (status != follower.status(node)) touched_.push_back(node);
  }
  for (const NodeIndex node : restarted_) {
    if (follower.status(node) == Status::kRunning) lanes_[node].Restart(tick);
  }
}

void Tracks::NoteChange(std::size_t tick, const StatusChange& change) {
  changed_.push_back(change.node);
  if (change.from == Status::kRunning) ended_in_[change.node] = tick;
  const bool runs_again = change.to == Status::kRunning && ended_in_[change.node] == tick;
  if (runs_again) restarted_.push_back(change.node);
}

void Tracks::Note(std::size_t tick, std::size_t word, const TickEvents& events,
                  const Event& event) {
  const auto at = static_cast<std::uint32_t>(tick);
  if (event.is_result()) {
    if (event.index < lanes_.size()) returned_.emplace_back(event.node(), event.status());
  } else if (event.code == EventCode::kText) {
    if (event.text == EventText::kInjected) injections_.push_back({at, event.node()});
  } else if (event.code != EventCode::kReset && event.index < writes_.size()) {
    // Three words stand before the bytes.
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(event.bytes.data());
    const auto* words = reinterpret_cast<const std::uint8_t*>(events.words.data);
    const auto offset = static_cast<std::size_t>(bytes - words) / sizeof(std::uint32_t) - 3;
    writes_[event.index].push_back({at, static_cast<std::uint32_t>(word + offset)});
  }
}

bool Tracks::GoOnAs(std::shared_ptr<const TreeDescription> tree) {
  if (!Extends(*tree, *tree_)) return false;
  tree_ = std::move(tree);
  writes_.resize(tree_->slots.size());
  return true;
}

}  // namespace coppice::editor
