// A node that another number has only because a sibling came or went has not moved, and to say so
// would bury what the user did. So the order of siblings is compared as a whole: those that do not
// fit the heaviest rising part of it have moved, as few as possible.
#include "editor/diff/tree_diff.h"

#include <algorithm>
#include <map>
#include <utility>

#include "editor/diff/tree_match.h"

namespace coppice::editor {
namespace {

// The nearest node above that both trees have.
std::uint32_t KnownAbove(const Scene& scene, const std::vector<std::uint32_t>& other,
                         std::uint32_t node) {
  std::uint32_t above = scene.nodes[node].parent;
  while (above != kNoSceneNode && other[above] == kNoSceneNode) above = scene.nodes[above].parent;
  return above;
}

// Where each node stands now, and where it stood.
struct Sibling {
  std::uint32_t before = 0;  // number in the tree before
  bool same_number = false;  // among its siblings
};

// The places of siblings that do not keep their order. As few as possible are named, and rather
// those whose number has changed: the others are the heaviest rising part of the list.
std::vector<std::size_t> OutOfOrder(const std::vector<Sibling>& list) {
  std::vector<std::uint32_t> sorted;
  for (const Sibling& sibling : list) sorted.push_back(sibling.before);
  std::sort(sorted.begin(), sorted.end());
  struct Part {
    std::size_t weight = 0;
    std::size_t last = 0;  // place of its last one
  };
  std::vector<Part> best(list.size() +
                         1);  // Fenwick tree: the heaviest part that ends up to a rank
  std::vector<std::size_t> previous(list.size(), list.size());
  Part heaviest = {0, list.size()};
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto at = std::lower_bound(sorted.begin(), sorted.end(), list[i].before);
    const auto rank = static_cast<std::size_t>(at - sorted.begin());
    Part before;
    for (std::size_t r = rank; r > 0; r &= r - 1) {
      if (best[r].weight > before.weight) before = best[r];
    }
    if (before.weight > 0) previous[i] = before.last;
    const Part part = {before.weight + 2 * list.size() + (list[i].same_number ? 1 : 0), i};
    for (std::size_t r = rank + 1; r < best.size(); r += r & (~r + 1)) {
      if (part.weight > best[r].weight) best[r] = part;
    }
    if (part.weight > heaviest.weight) heaviest = part;
  }
  std::vector<bool> rising(list.size(), false);
  for (std::size_t i = heaviest.last; i < list.size(); i = previous[i]) rising[i] = true;
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (!rising[i]) out.push_back(i);
  }
  return out;
}

std::vector<bool> FindMoved(const Scene& before, const Scene& after, const TreeMatch& match) {
  std::vector<bool> moved(after.nodes.size(), false);
  std::vector<std::vector<std::uint32_t>> below(after.nodes.size() + 1);
  for (std::uint32_t i = 0; i < after.nodes.size(); ++i) {
    const std::uint32_t old = match.before_of[i];
    if (old == kNoSceneNode) continue;
    const std::uint32_t above = KnownAbove(after, match.before_of, i);
    const std::uint32_t old_above = KnownAbove(before, match.after_of, old);
    const std::uint32_t expected = above == kNoSceneNode ? kNoSceneNode : match.before_of[above];
    moved[i] = expected != old_above;
    if (!moved[i]) below[above == kNoSceneNode ? after.nodes.size() : above].push_back(i);
  }
  for (const std::vector<std::uint32_t>& siblings : below) {
    std::vector<Sibling> old;
    for (const std::uint32_t node : siblings) {
      const std::uint32_t number = before.nodes[match.before_of[node]].number;
      old.push_back({match.before_of[node], number == after.nodes[node].number});
    }
    for (const std::size_t place : OutOfOrder(old)) moved[siblings[place]] = true;
  }
  return moved;
}

const PortLine* FindPort(const Scene& scene, const SceneNode& node, std::string_view name) {
  for (std::uint32_t p = node.first_port; p < node.first_port + node.port_count; ++p) {
    if (scene.ports[p].name == name) return &scene.ports[p];
  }
  return nullptr;
}

void AddIfDifferent(std::string name, std::string_view before, std::string_view after,
                    std::vector<AttributeChange>& changes) {
  if (before == after) return;
  changes.push_back({std::move(name), std::string(before), std::string(after)});
}

std::vector<AttributeChange> CompareNodes(const Scene& before, const SceneNode& a,
                                          const Scene& after, const SceneNode& b) {
  std::vector<AttributeChange> changes;
  AddIfDifferent("type", a.id, b.id, changes);
  const bool named = a.name != a.id || b.name != b.id;
  if (named) AddIfDifferent("name", a.name, b.name, changes);
  for (std::uint32_t p = a.first_port; p < a.first_port + a.port_count; ++p) {
    const PortLine& port = before.ports[p];
    const PortLine* now = FindPort(after, b, port.name);
    AddIfDifferent(std::string(port.name), port.value, now ? now->value : "", changes);
  }
  for (std::uint32_t p = b.first_port; p < b.first_port + b.port_count; ++p) {
    const PortLine& port = after.ports[p];
    if (FindPort(before, a, port.name)) continue;
    AddIfDifferent(std::string(port.name), "", port.value, changes);
  }
  return changes;
}

std::string OrNone(const std::string& value) { return value.empty() ? "(none)" : value; }

class Merger {
 public:
  Merger(const Scene& before, const Scene& after)
      : before_(before), after_(after), match_(MatchTrees(before, after)) {
    kind_of_.assign(after.nodes.size(), 0);
    result_.of_before.assign(before.nodes.size(), kNoSceneNode);
    result_.of_after.assign(after.nodes.size(), kNoSceneNode);
    for (const NodeDiff& diff : DiffTrees(before, after)) {
      if (diff.after == kNoSceneNode) continue;
      if (!diff.attributes.empty()) changes_[diff.after] = diff.attributes;
      std::uint8_t& kind = kind_of_[diff.after];
      if (kind == 0) kind = static_cast<std::uint8_t>(1 + static_cast<int>(diff.kind));
    }
  }

  MergedTree Run() {
    result_.scene.tree_id = after_.tree_id;
    result_.scene.scopes = after_.scopes;
    if (after_.nodes.empty()) result_.scene.tree_id = before_.tree_id;
    AddRoot();
    return std::move(result_);
  }

 private:
  std::uint32_t Add(const Scene& from, std::uint32_t node, std::uint32_t parent,
                    std::uint32_t number, std::uint8_t kind) {
    SceneNode copy = from.nodes[node];
    Scene& scene = result_.scene;
    const auto index = static_cast<std::uint32_t>(scene.nodes.size());
    const auto first = static_cast<std::uint32_t>(scene.ports.size());
    const auto begin = from.ports.begin() + copy.first_port;
    scene.ports.insert(scene.ports.end(), begin, begin + copy.port_count);
    copy.first_port = first;
    copy.parent = parent;
    copy.number = number;
    copy.end = index + 1;
    copy.scope = 0;
    copy.path = parent == kNoSceneNode ? std::to_string(number)
                                       : scene.nodes[parent].path + "." + std::to_string(number);
    scene.nodes.push_back(std::move(copy));
    result_.kinds.push_back(kind);
    (&from == &after_ ? result_.of_after : result_.of_before)[node] = index;
    return index;
  }

  void Close(std::uint32_t index) {
    result_.scene.nodes[index].end = static_cast<std::uint32_t>(result_.scene.nodes.size());
  }

  // A removed root stays above what has come out of it; else it is shown below the new root.
  void AddRoot() {
    const bool removed = !before_.nodes.empty() && match_.after_of[0] == kNoSceneNode;
    if (after_.nodes.empty()) {
      if (removed) AddRemoved(0, kNoSceneNode, 1);
      return;
    }
    const std::uint32_t old = match_.before_of[0];
    bool came_out = removed && old != kNoSceneNode;
    for (std::uint32_t i = came_out ? old : 0; i != 0 && came_out; i = before_.nodes[i].parent) {
      came_out = match_.after_of[before_.nodes[i].parent] == kNoSceneNode;
    }
    if (came_out) {
      came_out_ = old;
      return AddRemoved(0, kNoSceneNode, 1);
    }
    AddAfter(0, kNoSceneNode, 1);
    if (!removed) return;
    std::uint32_t count = 0;
    const auto& nodes = result_.scene.nodes;
    for (std::uint32_t c = 1; c < nodes.size(); c = nodes[c].end) ++count;
    AddRemoved(0, 0, count + 1);
    Close(0);
  }

  std::string_view Keep(std::string text) { return result_.texts.emplace_back(std::move(text)); }

  // Says old and new of what changed in a node that was just added.
  void ShowChanges(std::uint32_t node, const std::vector<AttributeChange>& changes) {
    SceneNode& shown = result_.scene.nodes[node];
    std::string was;
    for (const AttributeChange& change : changes) {
      if (change.name == "type" || change.name == "name") {
        if (!change.before.empty()) was += (was.empty() ? "" : ", ") + change.before;
      } else {
        ShowPort(shown, change);
      }
    }
    if (!was.empty()) shown.name = Keep(std::string(shown.name) + " (was " + was + ")");
  }

  void ShowPort(SceneNode& node, const AttributeChange& change) {
    const std::string_view value = Keep(OrNone(change.before) + " \u2192 " + OrNone(change.after));
    std::vector<PortLine>& ports = result_.scene.ports;
    for (std::size_t p = node.first_port; p < node.first_port + node.port_count; ++p) {
      if (ports[p].name != change.name) continue;
      ports[p].value = value;
      ports[p].key = {};
      return;
    }
    ports.push_back({Keep(change.name), value, PortDirection::kInput, {}, nullptr});
    ++node.port_count;
  }

  // Removed children come behind the sibling that they stood behind.
  void AddAfter(std::uint32_t node, std::uint32_t parent, std::uint32_t number) {
    const std::uint32_t index = Add(after_, node, parent, number, kind_of_[node]);
    const auto changes = changes_.find(node);
    if (changes != changes_.end()) ShowChanges(index, changes->second);
    const std::uint32_t old = match_.before_of[node];
    std::uint32_t next = old == kNoSceneNode ? kNoSceneNode : old + 1;
    const std::uint32_t old_end = old == kNoSceneNode ? kNoSceneNode : before_.nodes[old].end;
    std::uint32_t count = 0;
    const auto add_removed = [&] {
      for (; next != kNoSceneNode && next < old_end && match_.after_of[next] == kNoSceneNode;
           next = before_.nodes[next].end) {
        AddRemoved(next, index, ++count);
      }
    };
    add_removed();
    for (std::uint32_t c = node + 1; c < after_.nodes[node].end; c = after_.nodes[c].end) {
      AddAfter(c, index, ++count);
      // Only behind the child that comes next in the old order; moved ones are passed over.
      while (next != kNoSceneNode && next < old_end && match_.after_of[next] != kNoSceneNode &&
             match_.after_of[next] <= c) {
        next = before_.nodes[next].end;
        add_removed();
      }
    }
    for (; next != kNoSceneNode && next < old_end; next = before_.nodes[next].end) {
      if (match_.after_of[next] == kNoSceneNode) AddRemoved(next, index, ++count);
    }
    Close(index);
  }

  void AddRemoved(std::uint32_t node, std::uint32_t parent, std::uint32_t number) {
    constexpr auto kKind = static_cast<std::uint8_t>(1 + static_cast<int>(DiffKind::kRemoved));
    const std::uint32_t index = Add(before_, node, parent, number, kKind);
    std::uint32_t count = 0;
    for (std::uint32_t c = node + 1; c < before_.nodes[node].end; c = before_.nodes[c].end) {
      if (match_.after_of[c] == kNoSceneNode) AddRemoved(c, index, ++count);
      if (c == came_out_) AddAfter(0, index, ++count);
    }
    Close(index);
  }

  const Scene& before_;
  const Scene& after_;
  const TreeMatch match_;
  std::vector<std::uint8_t> kind_of_;
  std::uint32_t came_out_ =
      kNoSceneNode;  // node before that is the root now, if the old one is gone
  std::map<std::uint32_t, std::vector<AttributeChange>> changes_;  // by node after
  MergedTree result_;
};

}  // namespace

const char* ToString(DiffKind kind) {
  constexpr const char* kNames[] = {"added", "removed", "moved", "changed"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::vector<NodeDiff> DiffTrees(const Scene& before, const Scene& after) {
  const TreeMatch match = MatchTrees(before, after);
  const std::vector<bool> moved = FindMoved(before, after, match);
  std::vector<NodeDiff> diffs;
  for (std::uint32_t i = 0; i < after.nodes.size(); ++i) {
    const std::uint32_t old = match.before_of[i];
    if (old == kNoSceneNode) {
      diffs.push_back({DiffKind::kAdded, kNoSceneNode, i, {}});
      continue;
    }
    if (moved[i]) diffs.push_back({DiffKind::kMoved, old, i, {}});
    auto changes = CompareNodes(before, before.nodes[old], after, after.nodes[i]);
    if (!changes.empty()) diffs.push_back({DiffKind::kChanged, old, i, std::move(changes)});
  }
  for (std::uint32_t i = 0; i < before.nodes.size(); ++i) {
    if (match.after_of[i] == kNoSceneNode)
      diffs.push_back({DiffKind::kRemoved, i, kNoSceneNode, {}});
  }
  return diffs;
}

std::string ToString(const NodeDiff& diff, const Scene& before, const Scene& after) {
  constexpr char kSigns[] = {'+', '-', '>', '~'};
  const bool removed = diff.after == kNoSceneNode;
  const SceneNode& node = removed ? before.nodes[diff.before] : after.nodes[diff.after];
  std::string text(1, kSigns[static_cast<std::size_t>(diff.kind)]);
  text += " " + node.path + " " + std::string(node.name);
  if (diff.kind == DiffKind::kMoved) text += " (was " + before.nodes[diff.before].path + ")";
  const char* separator = ": ";
  for (const AttributeChange& change : diff.attributes) {
    text += separator + change.name + " \"" + change.before + "\" -> \"" + change.after + "\"";
    separator = ", ";
  }
  return text;
}

MergedTree MergeTrees(const Scene& before, const Scene& after) {
  return Merger(before, after).Run();
}

}  // namespace coppice::editor
