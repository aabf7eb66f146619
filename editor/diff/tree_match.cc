// After each key that is typed, two versions of a tree of tens of thousands of nodes are compared.
// Almost always they differ in one place; the way down to it is looked for first, and the general
// search only sees what is left.
#include "editor/diff/tree_match.h"

#include <algorithm>
#include <unordered_map>

namespace coppice::editor {
namespace {

using Hash = std::uint64_t;

Hash Combine(Hash hash, Hash value) { return (hash ^ value) * 1099511628211ULL + (hash >> 29); }

Hash HashText(Hash hash, std::string_view text) {
  return Combine(hash, std::hash<std::string_view>{}(text));
}

// What is seen of a node beside its texts.
Hash LooksOf(const SceneNode& node) {
  return (static_cast<Hash>(node.shape) << 3U) | (Hash{node.run_node != kNoNode} << 2U) |
         (Hash{node.recursive} << 1U) | Hash{node.disabled};
}

// One tree with what its nodes are compared by.
struct Side {
  std::vector<std::uint32_t> ChildrenOf(std::uint32_t node) const {
    std::vector<std::uint32_t> children;
    for (std::uint32_t c = node + 1; c < scene.nodes[node].end; c = scene.nodes[c].end) {
      children.push_back(c);
    }
    return children;
  }

  const Scene& scene;
  const std::vector<Hash>& named;
  const std::vector<Hash>& whole;
};

class Matcher {
 public:
  Matcher(const Side& before, const Side& after) : before_(before), after_(after) {
    match_.before_of.assign(after.scene.nodes.size(), kNoSceneNode);
    match_.after_of.assign(before.scene.nodes.size(), kNoSceneNode);
  }

  TreeMatch Run() {
    if (before_.scene.nodes.empty() || after_.scene.nodes.empty()) return match_;
    MatchAroundOneChange();
    MatchEqual(true);
    if (IsFree(0, 0) && before_.named[0] == after_.named[0]) Join(0, 0);
    MatchChildrenOfAll();
    MatchParents();
    MatchChildrenOfAll();
    MatchEqual(false);
    return match_;
  }

 private:
  bool IsFree(std::uint32_t before, std::uint32_t after) const {
    return match_.after_of[before] == kNoSceneNode && match_.before_of[after] == kNoSceneNode;
  }

  void Join(std::uint32_t before, std::uint32_t after) {
    match_.before_of[after] = before;
    match_.after_of[before] = after;
  }

  // The two are equal with everything below them.
  void JoinBranches(std::uint32_t before, std::uint32_t after) {
    const std::uint32_t size = before_.scene.nodes[before].end - before;
    for (std::uint32_t i = 0; i < size; ++i) {
      if (IsFree(before + i, after + i)) Join(before + i, after + i);
    }
  }

  // Most changes are in one place: on the way down to it, all branches on both sides are equal.
  // What is found here need not be searched for.
  void MatchAroundOneChange() {
    std::uint32_t before = 0;
    std::uint32_t after = 0;
    while (IsFree(before, after) && before_.named[before] == after_.named[after]) {
      if (before_.whole[before] == after_.whole[after]) return JoinBranches(before, after);
      if (IsInside(before_, before, after_, after) || IsInside(after_, after, before_, before)) {
        return;
      }
      Join(before, after);
      std::vector<std::uint32_t> left = before_.ChildrenOf(before);
      std::vector<std::uint32_t> right = after_.ChildrenOf(after);
      JoinEqualEnds(left, right);
      if (left.size() != 1 || right.size() != 1) return;
      before = left[0];
      after = right[0];
    }
  }

  // Whether the branch stands somewhere in the larger one, which is then a wrapping of it.
  static bool IsInside(const Side& side, std::uint32_t node, const Side& larger,
                       std::uint32_t branch) {
    if (SizeOf(side, node) >= SizeOf(larger, branch)) return false;
    const auto first = larger.whole.begin() + branch;
    const auto end = larger.whole.begin() + larger.scene.nodes[branch].end;
    return std::find(first, end, side.whole[node]) != end;
  }

  // Takes equal branches off both ends of two lists of children.
  void JoinEqualEnds(std::vector<std::uint32_t>& before, std::vector<std::uint32_t>& after) {
    const auto equal = [this](std::uint32_t a, std::uint32_t b) {
      return before_.whole[a] == after_.whole[b] && SizeOf(before_, a) == SizeOf(after_, b);
    };
    const auto ends =
        std::mismatch(before.begin(), before.end(), after.begin(), after.end(), equal);
    for (auto a = before.begin(), b = after.begin(); a != ends.first; ++a, ++b)
      JoinBranches(*a, *b);
    before.erase(before.begin(), ends.first);
    after.erase(after.begin(), ends.second);
    while (!before.empty() && !after.empty() && equal(before.back(), after.back())) {
      JoinBranches(before.back(), after.back());
      before.pop_back();
      after.pop_back();
    }
  }

  // Equal branches anywhere, from the top; `unique`: only if there is one of them on each side.
  void MatchEqual(bool unique) {
    struct Places {
      std::vector<std::uint32_t> before;
      std::uint32_t after = 0;
      std::size_t next = 0;
    };
    std::unordered_map<Hash, Places> places;
    for (std::uint32_t i = 0; i < before_.whole.size(); ++i) {
      if (match_.after_of[i] == kNoSceneNode) places[before_.whole[i]].before.push_back(i);
    }
    for (std::uint32_t i = 0; i < after_.whole.size(); ++i) {
      if (match_.before_of[i] == kNoSceneNode) ++places[after_.whole[i]].after;
    }
    for (std::uint32_t i = 0; i < after_.whole.size(); ++i) {
      if (match_.before_of[i] != kNoSceneNode) continue;
      Places& place = places[after_.whole[i]];
      if (unique && (place.after != 1 || place.before.size() != 1)) continue;
      while (place.next < place.before.size() &&
             match_.after_of[place.before[place.next]] != kNoSceneNode) {
        ++place.next;
      }
      if (place.next == place.before.size()) continue;
      const std::uint32_t found = place.before[place.next];
      if (SizeOf(before_, found) == SizeOf(after_, i)) JoinBranches(found, i);
    }
  }

  static std::uint32_t SizeOf(const Side& side, std::uint32_t node) {
    return side.scene.nodes[node].end - node;
  }

  // Parents come first in preorder, so what is found here is itself looked into.
  void MatchChildrenOfAll() {
    for (std::uint32_t after = 0; after < after_.whole.size(); ++after) {
      const std::uint32_t before = match_.before_of[after];
      if (before == kNoSceneNode || before_.whole[before] == after_.whole[after]) continue;
      const std::vector<std::uint32_t> old_children = before_.ChildrenOf(before);
      const std::vector<std::uint32_t> new_children = after_.ChildrenOf(after);
      MatchLists(old_children, new_children, before_.whole, after_.whole);
      MatchLists(old_children, new_children, before_.named, after_.named);
      MatchLists(old_children, new_children, Types(before_, old_children),
                 Types(after_, new_children), true);
    }
  }

  static std::vector<Hash> Types(const Side& side, const std::vector<std::uint32_t>& nodes) {
    std::vector<Hash> types;
    for (const std::uint32_t node : nodes) types.push_back(HashText(3, side.scene.nodes[node].id));
    return types;
  }

  // Those with the same key, in order. Keys are by node, or by place in the list.
  void MatchLists(const std::vector<std::uint32_t>& before, const std::vector<std::uint32_t>& after,
                  const std::vector<Hash>& keys_before, const std::vector<Hash>& keys_after,
                  bool by_place = false) {
    std::unordered_map<Hash, std::vector<std::uint32_t>> waiting;
    for (std::size_t i = before.size(); i-- > 0;) {
      if (match_.after_of[before[i]] != kNoSceneNode) continue;
      waiting[keys_before[by_place ? i : before[i]]].push_back(before[i]);
    }
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (match_.before_of[after[i]] != kNoSceneNode) continue;
      const auto found = waiting.find(keys_after[by_place ? i : after[i]]);
      if (found == waiting.end() || found->second.empty()) continue;
      const std::uint32_t partner = found->second.back();
      found->second.pop_back();
      if (before_.whole[partner] == after_.whole[after[i]]) {
        JoinBranches(partner, after[i]);
      } else {
        Join(partner, after[i]);
      }
    }
  }

  // A node of another type around the same children is the same node. Children come later in
  // preorder, so this walks backwards.
  void MatchParents() {
    for (auto after = static_cast<std::uint32_t>(after_.whole.size()); after-- > 0;) {
      if (match_.before_of[after] != kNoSceneNode) continue;
      for (const std::uint32_t child : after_.ChildrenOf(after)) {
        const std::uint32_t before = match_.before_of[child];
        if (before == kNoSceneNode) continue;
        const std::uint32_t parent = before_.scene.nodes[before].parent;
        if (parent == kNoSceneNode || !IsFree(parent, after)) continue;
        Join(parent, after);
        break;
      }
    }
  }

  const Side before_;
  const Side after_;
  TreeMatch match_;
};

}  // namespace

TreeHashes HashTree(const Scene& scene) {
  const auto count = static_cast<std::uint32_t>(scene.nodes.size());
  TreeHashes hashes;
  hashes.named.resize(count);
  hashes.whole.resize(count);
  hashes.shown.resize(count);
  for (std::uint32_t i = count; i-- > 0;) {
    const SceneNode& node = scene.nodes[i];
    hashes.named[i] = HashText(HashText(17, node.id), node.name);
    Hash hash = hashes.named[i];
    for (std::uint32_t p = node.first_port; p < node.first_port + node.port_count; ++p) {
      hash = HashText(HashText(hash, scene.ports[p].name), scene.ports[p].value);
    }
    hashes.shown[i] = Combine(HashText(hash, node.note), LooksOf(node));
    for (std::uint32_t c = i + 1; c < node.end; c = scene.nodes[c].end) {
      hash = Combine(hash, hashes.whole[c]);
    }
    hashes.whole[i] = hash;
  }
  return hashes;
}

TreeMatch MatchTrees(const Scene& before, const Scene& after) {
  return MatchTrees(before, HashTree(before), after, HashTree(after));
}

TreeMatch MatchTrees(const Scene& before, const TreeHashes& before_hashes, const Scene& after,
                     const TreeHashes& after_hashes) {
  return Matcher({before, before_hashes.named, before_hashes.whole},
                 {after, after_hashes.named, after_hashes.whole})
      .Run();
}

}  // namespace coppice::editor
