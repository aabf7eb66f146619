// The node types that a program knows: the built-in ones and the user's leaves.
//
//   Registry registry;
//   registry.Register<IsDark>("IsDark");
//   registry.Register<DriveTo>("DriveTo", std::ref(navigator));   // arguments go to every
//   DriveTo's constructor
//
// The manifest of a leaf is read off the leaf itself: Register makes one instance and asks it for
// its ports. Fill a Registry before use; afterwards it is read-only and may be shared by threads
// and trees.
#ifndef COPPICE_BT_CORE_ENGINE_REGISTRY_H_
#define COPPICE_BT_CORE_ENGINE_REGISTRY_H_

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "bt_core/nodes/leaf.h"
#include "bt_core/nodes/node_type.h"
#include "bt_core/nodes/user_control.h"

namespace coppice {

class Registry {
 public:
  using Builder = std::function<std::unique_ptr<UserNode>()>;

  /// A tick of a node whose class is known, without virtual calls.
  using TickFunction = Status (*)(UserNode& node, bool starting);

  struct Entry {
    NodeType type = NodeType::kLeaf;
    ChildCount children{0, 0};
    Manifest manifest;
    Builder build;                              ///< nodes of the user only
    TickFunction tick = nullptr;                ///< the same
    std::vector<PortDeclaration> declarations;  ///< the manifest's ports and the node's mailboxes
  };

  Registry();

  /// Adds node type T, a leaf, control node or decorator. Throws std::invalid_argument if the ID is
  /// taken or not a valid name.
  template <class T, class... Args>
  void Register(const std::string& id, Args... args) {
    Builder build = [arguments = std::make_tuple(std::move(args)...)] {
      return std::apply([](auto&... a) { return std::make_unique<T>(a...); }, arguments);
    };
    Entry entry;
    entry.manifest = {id, T::kCategory, T::kDescription, {}};
    entry.build = std::move(build);
    entry.tick = &TickAs<T>;
    if constexpr (std::is_base_of_v<UserControl, T>) {
      entry.type = NodeType::kUser;
      entry.children = T::kChildren;
    }
    Add(std::move(entry));
  }

  /// What an ID that nobody registered becomes, instead of an error. The builder gets the
  /// instance's name.
  void SetFallback(std::function<std::unique_ptr<Leaf>(const std::string& name)> build) {
    fallback_ = std::move(build);
  }
  const auto& fallback() const { return fallback_; }

  /// The node type of that ID, or null.
  const Entry* Find(std::string_view id) const;

  /// All IDs in alphabetical order.
  std::vector<std::string> Ids() const;
  const std::map<std::string, Entry, std::less<>>& entries() const { return entries_; }

 private:
  // Calls the function of T itself: the builder makes a T, so nothing overrides it.
  template <class T, class = void>
  struct HasCheck : std::false_type {};
  template <class T>
  struct HasCheck<T, std::void_t<decltype(std::declval<T&>().T::Check())>> : std::true_type {};
  template <class T>
  static Status TickAs(UserNode& node, bool starting) {
    if constexpr (std::is_base_of_v<Condition, T> && HasCheck<T>::value) {
      return static_cast<T&>(node).T::Check() ? Status::kSuccess : Status::kFailure;
    } else {
      return node.Tick(starting);
    }
  }

  void Add(Entry entry);

  std::map<std::string, Entry, std::less<>> entries_;
  std::function<std::unique_ptr<Leaf>(const std::string&)> fallback_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_REGISTRY_H_
