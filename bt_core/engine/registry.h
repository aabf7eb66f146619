// The node types that a program knows: the built-in ones and the user's leaves.
//
//   Registry registry;
//   registry.Register<IsDark>("IsDark");
//   registry.Register<DriveTo>("DriveTo", std::ref(navigator));  // arguments of its constructor
//   registry.Condition("IsNight", [] { return Hour() < 6; });    // see nodes/lambda_leaf.h
//
// The manifest of a leaf is read off the leaf itself: Register makes one instance and asks it for
// its ports. Fill a Registry before use; afterwards it is read-only and may be shared by threads
// and trees.
#ifndef COPPICE_BT_CORE_ENGINE_REGISTRY_H_
#define COPPICE_BT_CORE_ENGINE_REGISTRY_H_

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

#include "bt_core/data/enum.h"
#include "bt_core/nodes/lambda_leaf.h"
#include "bt_core/nodes/leaf.h"
#include "bt_core/nodes/node_type.h"
#include "bt_core/nodes/user_control.h"
#include "bt_core/script/script.h"

namespace coppice {

class Registry {
 public:
  using Builder = std::function<std::unique_ptr<UserNode>()>;

  /// A tick of a node whose class is known, without virtual calls where that is possible. `before`
  /// is the node's status: what is not RUNNING starts.
  using TickFunction = Status (*)(UserNode& node, Status before);

  struct Entry {
    NodeType type = NodeType::kLeaf;
    ChildCount children{0, 0};
    Manifest manifest;
    Builder build;                                ///< nodes of the user only
    TickFunction tick = nullptr;                  ///< the same
    std::vector<PortDeclaration> declarations;    ///< the manifest's ports and the node's mailboxes
    std::shared_ptr<const void> types = nullptr;  ///< keeps those of a manifest without class
  };

  Registry();

  /// Adds node type T, a leaf, control node or decorator; every node of this type is made with
  /// copies of the arguments. Throws std::invalid_argument if the ID is taken or not a valid name,
  /// or a port has a reserved name.
  template <class T, class... Args>
  void Register(const std::string& id, Args... args) {
    AddNode<T>(id, T::kDescription, std::move(args)...);
  }

  /// Adds a condition that asks a function. Throws as Register does.
  template <class Function>
  void Condition(const std::string& id, Function check) {
    AddLambda<LambdaCondition<Function>>(id, nullptr, 0, "", std::move(check));
  }
  template <std::size_t count, class Function>
  void Condition(const std::string& id, const LambdaPort (&ports)[count], Function check,
                 const std::string& description = {}) {
    static_assert(count == LambdaCondition<Function>::Call::kArity, "one name for each parameter");
    AddLambda<LambdaCondition<Function>>(id, ports, count, description, std::move(check));
  }

  /// Adds an action that is done within one tick by a function. Throws as Register does.
  template <class Function>
  void Action(const std::string& id, Function run) {
    AddLambda<LambdaAction<Function>>(id, nullptr, 0, "", std::move(run));
  }
  template <std::size_t count, class Function>
  void Action(const std::string& id, const LambdaPort (&ports)[count], Function run,
              const std::string& description = {}) {
    static_assert(count == LambdaAction<Function>::Call::kArity, "one name for each parameter");
    AddLambda<LambdaAction<Function>>(id, ports, count, description, std::move(run));
  }

  /// Adds a node type whose nodes a function makes, for front ends that have classes of their own;
  /// the ports of `manifest` are those of the node that it makes. `tick`: as in Entry. A control
  /// node or decorator, one with children, is a UserControl. Throws as Register does.
  void AddBuilder(Manifest manifest, ChildCount children, Builder build,
                  TickFunction tick = &TickVirtually);

  /// Adds a second ID for a node type. Throws std::invalid_argument if there is no such type, or
  /// the ID is taken.
  void AddAlias(const std::string& id, const std::string& known);

  /// Adds a node type without class: trees with it can be checked, but not run. `types` keeps the
  /// types of its ports. Without effect if the ID is taken.
  void AddManifest(Manifest manifest, ChildCount children, std::shared_ptr<const void> types);

  /// True if the node type is there and is one of Coppice.
  bool HasBuiltIn(std::string_view id) const;

  /// Takes a node type away, for a file that has another one of that name.
  void Remove(const std::string& id) { entries_.erase(id); }

  /// Adds the node types of a shared library (engine/plugin.h), which stays loaded until the
  /// program ends. Throws std::runtime_error, "PATH: why", if it cannot be loaded, was built for
  /// another version of Coppice, or one of its node types cannot be added; then none of them is.
  void LoadPlugin(const std::string& path);

  /// What an ID that nobody registered becomes, instead of an error. The builder gets the
  /// instance's name.
  void SetFallback(std::function<std::unique_ptr<Leaf>(const std::string& name)> build) {
    fallback_ = std::move(build);
  }
  const auto& fallback() const { return fallback_; }

  /// The TickFunction of any node. A node that returns IDLE, which none may, throws
  /// std::logic_error.
  static Status TickVirtually(UserNode& node, Status before);

  /// Makes the names of an enum (data/enum.h) stand for their numbers in every script, also if no
  /// port has this type.
  template <class E>
  void RegisterEnum() {
    AddEnumerators(EnumeratorsOf<E>());
  }

  /// Makes a name stand for a number in every script. Throws std::invalid_argument if it stands for
  /// another number already.
  void AddScriptConstant(const std::string& name, std::int64_t value);
  /// ScriptConstants::are_real.
  void MakeScriptConstantsReal() { script_constants_.are_real = true; }

  /// Names that stand for numbers in every script: those above and the enumerators of the types
  /// that ports of registered nodes have. A name that two enums give different numbers is none of
  /// them.
  const ScriptConstants& script_constants() const { return script_constants_; }

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
  static Status TickAs(UserNode& node, Status before) {
    if constexpr (std::is_base_of_v<coppice::Condition, T> && HasCheck<T>::value) {
      return static_cast<T&>(node).T::Check() ? Status::kSuccess : Status::kFailure;
    } else {
      return TickVirtually(node, before);
    }
  }

  // A class that has work of its own, such as a thread, ends it in BeforeDestruction, while the
  // object is still whole: in its destructor it would be too late for what is derived from it.
  template <class T>
  class Ending final : public T {
   public:
    using T::T;
    ~Ending() override { this->BeforeDestruction(); }
  };
  template <class T, class = void>
  struct MadeAs {
    using Type = T;
  };
  template <class T>
  struct MadeAs<T, std::void_t<decltype(std::declval<T&>().BeforeDestruction())>> {
    using Type = Ending<T>;
  };
  template <class T>
  using Made = typename MadeAs<T>::Type;

  template <class T, class... Args>
  void AddNode(const std::string& id, const std::string& description, Args... args) {
    Entry entry;
    entry.manifest = {id, T::kCategory, description, {}};
    entry.build = [arguments = std::make_tuple(std::move(args)...)] {
      return std::apply([](auto&... a) { return std::make_unique<Made<T>>(a...); }, arguments);
    };
    entry.tick = &TickAs<T>;
    if constexpr (std::is_base_of_v<UserControl, T>) {
      entry.type = NodeType::kUser;
      entry.children = T::kChildren;
    }
    Add(std::move(entry));
  }

  template <class T, class Function>
  void AddLambda(const std::string& id, const LambdaPort* ports, std::size_t count,
                 const std::string& description, Function function) {
    AddNode<T>(id, description, std::vector<LambdaPort>(ports, ports + count), std::move(function));
  }

  void Add(Entry entry);
  void AddEnumerators(const EnumeratorList& list);

  std::map<std::string, Entry, std::less<>> entries_;
  ScriptConstants script_constants_;
  std::set<std::string, std::less<>> ambiguous_constants_;
  std::function<std::unique_ptr<Leaf>(const std::string&)> fallback_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_ENGINE_REGISTRY_H_
