#include "editor/timeline/tracks.h"

#include <algorithm>

namespace coppice::editor {

Tracks::Tracks(std::shared_ptr<const TreeDescription> tree)
    : tree_(std::move(tree)),
      shape_(ShapeOf(*tree_)),
      lanes_(tree_->nodes.size()),
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
  follower.Apply(
      events, [this](const StatusChange& change) { changed_.push_back(change.node); },
      [&](const Event& event) { Note(tick, word, events, event); });
  for (const NodeIndex node : changed_) lanes_[node].Set(tick, follower.status(node));
  for (const auto& [node, status] : returned_) {
    lanes_[node].Set(tick, status);
    if (status != follower.status(node)) touched_.push_back(node);
  }
}

void Tracks::Note(std::size_t tick, std::size_t word, const TickEvents& events,
                  const Event& event) {
  const auto at = static_cast<std::uint32_t>(tick);
  if (event.is_result()) {
    if (event.index < lanes_.size()) returned_.emplace_back(event.index, event.status());
  } else if (event.code == EventCode::kText) {
    if (event.text == EventText::kInjected) injections_.push_back({at, event.index});
  } else if (event.code != EventCode::kReset && event.index < writes_.size()) {
    // Three words stand before the bytes.
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(event.bytes.data());
    const auto* words = reinterpret_cast<const std::uint8_t*>(events.words.data);
    const auto offset = static_cast<std::size_t>(bytes - words) / sizeof(std::uint32_t) - 3;
    writes_[event.index].push_back({at, static_cast<std::uint32_t>(word + offset)});
  }
}

bool IsSameTree(const TreeDescription& a, const TreeDescription& b) {
  const auto same_text = [](const DescribedDocument& x, const DescribedDocument& y) {
    return x.text == y.text;
  };
  const auto same_node = [](const DescribedNode& x, const DescribedNode& y) {
    return x.path == y.path && x.id == y.id;
  };
  const auto same_slot = [](const DescribedSlot& x, const DescribedSlot& y) {
    return x.scope == y.scope && x.name == y.name && x.type == y.type;
  };
  return a.main_tree == b.main_tree &&
         std::equal(a.documents.begin(), a.documents.end(), b.documents.begin(), b.documents.end(),
                    same_text) &&
         std::equal(a.nodes.begin(), a.nodes.end(), b.nodes.begin(), b.nodes.end(), same_node) &&
         std::equal(a.slots.begin(), a.slots.end(), b.slots.begin(), b.slots.end(), same_slot);
}

}  // namespace coppice::editor
