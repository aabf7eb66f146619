#include "editor/scene/tree_match.h"

#include <algorithm>
#include <unordered_map>

namespace coppice::editor {
namespace {

using Hash = std::uint64_t;

Hash Combine(Hash hash, Hash value) { return (hash ^ value) * 1099511628211ULL + (hash >> 29); }

Hash HashText(Hash hash, std::string_view text) {
  return Combine(hash, std::hash<std::string_view>{}(text));
}

// One tree with what its nodes are compared by.
struct Side {
  explicit Side(const Scene& tree) : scene(tree) {
    const auto count = static_cast<std::uint32_t>(scene.nodes.size());
    named.resize(count);
    whole.resize(count);
    for (std::uint32_t i = count; i-- > 0;) {
      const SceneNode& node = scene.nodes[i];
      named[i] = HashText(HashText(17, node.id), node.name);
      Hash hash = named[i];
      for (std::uint32_t p = node.first_port; p < node.first_port + node.port_count; ++p) {
        hash = HashText(HashText(hash, scene.ports[p].name), scene.ports[p].value);
      }
      for (std::uint32_t c = i + 1; c < node.end; c = scene.nodes[c].end) {
        hash = Combine(hash, whole[c]);
      }
      whole[i] = hash;
    }
  }

  std::vector<std::uint32_t> ChildrenOf(std::uint32_t node) const {
    std::vector<std::uint32_t> children;
    for (std::uint32_t c = node + 1; c < scene.nodes[node].end; c = scene.nodes[c].end) {
      children.push_back(c);
    }
    return children;
  }

  const Scene& scene;
  std::vector<Hash> named;  // type and name
  std::vector<Hash> whole;  // the node with its ports and everything below it
};

class Matcher {
 public:
  Matcher(const Scene& before, const Scene& after) : before_(before), after_(after) {
    match_.before_of.assign(after.nodes.size(), kNoNode);
    match_.after_of.assign(before.nodes.size(), kNoNode);
  }

  TreeMatch Run() {
    if (before_.scene.nodes.empty() || after_.scene.nodes.empty()) return match_;
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
    return match_.after_of[before] == kNoNode && match_.before_of[after] == kNoNode;
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

  // Equal branches anywhere, from the top; `unique`: only if there is one of them on each side.
  void MatchEqual(bool unique) {
    struct Places {
      std::vector<std::uint32_t> before;
      std::uint32_t after = 0;
      std::size_t next = 0;
    };
    std::unordered_map<Hash, Places> places;
    for (std::uint32_t i = 0; i < before_.whole.size(); ++i) {
      if (match_.after_of[i] == kNoNode) places[before_.whole[i]].before.push_back(i);
    }
    for (std::uint32_t i = 0; i < after_.whole.size(); ++i) {
      if (match_.before_of[i] == kNoNode) ++places[after_.whole[i]].after;
    }
    for (std::uint32_t i = 0; i < after_.whole.size(); ++i) {
      if (match_.before_of[i] != kNoNode) continue;
      Places& place = places[after_.whole[i]];
      if (unique && (place.after != 1 || place.before.size() != 1)) continue;
      while (place.next < place.before.size() &&
             match_.after_of[place.before[place.next]] != kNoNode) {
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
      if (before == kNoNode || before_.whole[before] == after_.whole[after]) continue;
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
      if (match_.after_of[before[i]] != kNoNode) continue;
      waiting[keys_before[by_place ? i : before[i]]].push_back(before[i]);
    }
    for (std::size_t i = 0; i < after.size(); ++i) {
      if (match_.before_of[after[i]] != kNoNode) continue;
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
      if (match_.before_of[after] != kNoNode) continue;
      for (const std::uint32_t child : after_.ChildrenOf(after)) {
        const std::uint32_t before = match_.before_of[child];
        if (before == kNoNode) continue;
        const std::uint32_t parent = before_.scene.nodes[before].parent;
        if (parent == kNoNode || !IsFree(parent, after)) continue;
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

TreeMatch MatchTrees(const Scene& before, const Scene& after) {
  return Matcher(before, after).Run();
}

}  // namespace coppice::editor
