// Registers node types and makes trees of XML.
//
//   BT::BehaviorTreeFactory factory;
//   factory.registerNodeType<Say>("Say");
//   BT::Tree tree = factory.createTreeFromFile("tree.xml");
//   tree.tickWhileRunning();
//
// An XML that is wrong throws RuntimeError with all problems, each with file:line:column.
#ifndef BT_FACTORY_H
#define BT_FACTORY_H

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include "behaviortree_cpp/behavior_tree.h"
#include "behaviortree_cpp/contrib/json.hpp"
#include "behaviortree_cpp/contrib/magic_enum.hpp"
#include "behaviortree_cpp/utils/polymorphic_cast_registry.hpp"

namespace coppice {
class Registry;
}

namespace BT {

using NodeBuilder = std::function<std::unique_ptr<TreeNode>(const std::string&, const NodeConfig&)>;

template <class T, class... Arguments>
NodeBuilder CreateBuilder(Arguments... arguments) {
  return [=](const std::string& name, const NodeConfig& config) {
    return TreeNode::Instantiate<T, Arguments...>(name, config, arguments...);
  };
}

template <class T>
TreeNodeManifest CreateManifest(const std::string& id, PortsList ports = getProvidedPorts<T>()) {
  if constexpr (has_static_method_metadata<T>::value) {
    return {getType<T>(), id, std::move(ports), T::metadata()};
  } else {
    return {getType<T>(), id, std::move(ports), {}};
  }
}

#ifdef BT_PLUGIN_EXPORT
#define BTCPP_EXPORT extern "C" __attribute__((visibility("default")))
#else
#define BTCPP_EXPORT static
#endif

/// Followed by the body of a function that registers the node types of a library, once in it. A
/// library that is loaded as a plugin is compiled with BT_PLUGIN_EXPORT defined.
#define BT_REGISTER_NODES(factory) \
  BTCPP_EXPORT void BT_RegisterNodesFromPlugin(BT::BehaviorTreeFactory& factory)

constexpr const char* PLUGIN_SYMBOL = "BT_RegisterNodesFromPlugin";

/// `*` stands for any characters.
bool WildcardMatch(const std::string& text, StringView filter);

/// A tree that is ready to run. One thread ticks and halts it.
class Tree {
 public:
  struct Subtree {
    using Ptr = std::shared_ptr<Subtree>;
    std::vector<TreeNode::Ptr> nodes;
    Blackboard::Ptr blackboard;
    std::string instance_name;
    std::string tree_ID;
  };

  std::vector<Subtree::Ptr> subtrees;  ///< in the order of their nodes; the first is the main tree
  std::unordered_map<std::string, TreeNodeManifest> manifests;

  Tree();
  Tree(Tree&&) noexcept;
  Tree& operator=(Tree&&) noexcept;
  Tree(const Tree&) = delete;
  Tree& operator=(const Tree&) = delete;
  ~Tree();

  void initialize() {}
  void haltTree();
  TreeNode* rootNode() const;

  /// Waits until a node asks for a tick or the time is over; true in the first case.
  bool sleep(std::chrono::system_clock::duration timeout);
  /// Any thread.
  void emitWakeUpSignal();
  std::shared_ptr<WakeUpSignal> wakeUpSignal() const;

  /// One tick. Throws NodeExecutionError if a node throws; the tree is halted then.
  NodeStatus tickExactlyOnce();
  /// One tick, and more as long as nodes ask for one at once.
  NodeStatus tickOnce();
  /// Until the root completes. Between ticks it sleeps for that time, or until a node asks for a
  /// tick or a timer of the tree is due.
  NodeStatus tickWhileRunning(std::chrono::milliseconds sleep_time = std::chrono::milliseconds(10));

#ifdef USE_BTCPP3_OLD_NAMES
  NodeStatus tickRoot() { return tickExactlyOnce(); }
  NodeStatus tickRootWhileRunning(
      std::chrono::milliseconds sleep_time = std::chrono::milliseconds(10)) {
    return tickWhileRunning(sleep_time);
  }
#endif

  Blackboard::Ptr rootBlackboard();
  void applyVisitor(const std::function<void(const TreeNode*)>& visitor) const;
  void applyVisitor(const std::function<void(TreeNode*)>& visitor);
  uint16_t getUID() { return ++uid_counter_; }

  /// The nodes of a class whose path matches (WildcardMatch).
  template <class NodeType = TreeNode>
  std::vector<const TreeNode*> getNodesByPath(StringView filter) const {
    std::vector<const TreeNode*> found;
    for (const auto& subtree : subtrees) {
      for (const auto& node : subtree->nodes) {
        const bool is_one = dynamic_cast<const NodeType*>(node.get()) != nullptr;
        if (is_one && WildcardMatch(node->fullPath(), filter)) found.push_back(node.get());
      }
    }
    return found;
  }

  /// For loggers: the engine's side.
  internal::TreeRun& run() const { return *run_; }

 private:
  friend class BehaviorTreeFactory;

  enum class Ticks { kOne, kUntilQuiet, kUntilDone };
  NodeStatus TickRoot(Ticks ticks, std::chrono::milliseconds sleep_time);

  std::unique_ptr<internal::TreeRun> run_;
  uint16_t uid_counter_ = 0;
};

class BehaviorTreeFactory {
 public:
  BehaviorTreeFactory();
  ~BehaviorTreeFactory();
  BehaviorTreeFactory(BehaviorTreeFactory&&) noexcept;
  BehaviorTreeFactory& operator=(BehaviorTreeFactory&&) noexcept;
  BehaviorTreeFactory(const BehaviorTreeFactory&) = delete;
  BehaviorTreeFactory& operator=(const BehaviorTreeFactory&) = delete;

  /// False if there is no such type. Throws LogicError for a built-in one.
  bool unregisterBuilder(const std::string& id);
  /// Throws BehaviorTreeException if the ID is taken.
  void registerBuilder(const TreeNodeManifest& manifest, const NodeBuilder& builder);
  template <class T>
  void registerBuilder(const std::string& id, const NodeBuilder& builder) {
    registerBuilder(CreateManifest<T>(id), builder);
  }

  void registerSimpleAction(const std::string& id,
                            const SimpleActionNode::TickFunctor& tick_functor,
                            PortsList ports = {});
  void registerSimpleCondition(const std::string& id,
                               const SimpleConditionNode::TickFunctor& tick_functor,
                               PortsList ports = {});
  void registerSimpleDecorator(const std::string& id,
                               const SimpleDecoratorNode::TickFunctor& tick_functor,
                               PortsList ports = {});

  /// The node types of a shared library with BT_REGISTER_NODES; it stays loaded. Throws
  /// RuntimeError if it cannot be loaded or has none.
  void registerFromPlugin(const std::string& file_path);
  /// The plugins of all ROS 1 packages that export one, as `rospack plugins --attrib=bt_lib_plugin
  /// behaviortree_cpp_v3` lists them.
  void registerFromROSPlugins();

  void registerBehaviorTreeFromFile(const std::filesystem::path& filename);
  void registerBehaviorTreeFromText(const std::string& xml_text);
  std::vector<std::string> registeredBehaviorTrees() const;
  void clearRegisteredBehaviorTrees();

  std::unique_ptr<TreeNode> instantiateTreeNode(const std::string& name, const std::string& id,
                                                const NodeConfig& config) const;

  template <class T, class... Arguments>
  void registerNodeType(const std::string& id, const PortsList& ports, Arguments... arguments) {
    static_assert(
        std::is_base_of_v<ActionNodeBase, T> || std::is_base_of_v<ControlNode, T> ||
            std::is_base_of_v<DecoratorNode, T> || std::is_base_of_v<ConditionNode, T>,
        "a node derives from ActionNodeBase, ConditionNode, ControlNode or DecoratorNode");
    static_assert(!std::is_abstract_v<T>, "a pure virtual function is missing: tick() or halt()?");
    if constexpr (internal::IsBuiltIn<T>::value) {
      static_assert(std::is_same_v<typename T::BuiltInClass, T>,
                    "the built-in nodes cannot be derived from");
      RegisterAlias(id, T::kBuiltInId);
    } else {
      static_assert(hasNodeNameCtor<T>() || hasNodeFullCtor<T, Arguments...>(),
                    "the class needs a public constructor (const std::string&, const NodeConfig&) "
                    "or (const std::string&)");
      registerBuilder(CreateManifest<T>(id, ports), CreateBuilder<T>(arguments...));
    }
  }
  template <class T, class... Arguments>
  void registerNodeType(const std::string& id, Arguments... arguments) {
    if constexpr (!internal::IsBuiltIn<T>::value) {
      constexpr bool has_ports = has_static_method_providedPorts<T>::value;
      constexpr bool is_full = hasNodeFullCtor<T, Arguments...>();
      static_assert(std::is_abstract_v<T> || !is_full || has_ports,
                    "the class needs a function `static PortsList providedPorts()`");
      static_assert(std::is_abstract_v<T> || !has_ports || is_full,
                    "a class with providedPorts() needs a public constructor (const std::string&, "
                    "const NodeConfig&, ...) that fits the arguments");
    }
    registerNodeType<T>(id, getProvidedPorts<T>(), arguments...);
  }

  const std::unordered_map<std::string, NodeBuilder>& builders() const;
  const std::unordered_map<std::string, TreeNodeManifest>& manifests() const;
  const std::set<std::string>& builtinNodes() const;
  /// For the engine.
  std::shared_ptr<const coppice::Registry> registry() const;

  /// The main tree of a text or file. The blackboard becomes that of the main tree.
  Tree createTreeFromText(const std::string& text,
                          Blackboard::Ptr blackboard = Blackboard::create());
  Tree createTreeFromFile(const std::filesystem::path& file_path,
                          Blackboard::Ptr blackboard = Blackboard::create());
  /// One of the registered trees.
  Tree createTree(const std::string& tree_name, Blackboard::Ptr blackboard = Blackboard::create());

  void addMetadataToManifest(const std::string& node_id, const KeyValueVector& metadata);

  /// A name that stands for a number in scripts and in ports of enums.
  void registerScriptingEnum(StringView name, int value);
  template <class EnumType>
  void registerScriptingEnums() {
    for (const auto& [value, name] : magic_enum::enum_entries<EnumType>()) {
      registerScriptingEnum(name, static_cast<int>(value));
    }
  }

  /// What takes the place of nodes in a test: another node type or a TestNode. `filter`: the name
  /// of an instance, a registration ID or a path with `*`.
  using SubstitutionRule =
      std::variant<std::string, TestNodeConfig, std::shared_ptr<TestNodeConfig>>;
  void addSubstitutionRule(StringView filter, SubstitutionRule rule);
  void loadSubstitutionRuleFromJSON(const std::string& json_text);
  void clearSubstitutionRules();
  const std::unordered_map<std::string, SubstitutionRule>& substitutionRules() const;

  /// Ports of std::shared_ptr<Base> take keys that hold std::shared_ptr<Derived>.
  template <class Derived, class Base>
  void registerPolymorphicCast() {
    polymorphicCastRegistry().registerCast<Derived, Base>();
  }
  PolymorphicCastRegistry& polymorphicCastRegistry();
  const PolymorphicCastRegistry& polymorphicCastRegistry() const;
  std::shared_ptr<PolymorphicCastRegistry> polymorphicCastRegistryPtr() const;

 private:
  void RegisterAlias(const std::string& id, const std::string& built_in);

  struct PImpl;
  std::unique_ptr<PImpl> _p;
};

/// The values and types of all keys.
void BlackboardClone(const Blackboard& source, Blackboard& destination);
std::vector<Blackboard::Ptr> BlackboardBackup(const Tree& tree);
void BlackboardRestore(const std::vector<Blackboard::Ptr>& backup, Tree& tree);
nlohmann::json ExportTreeToJSON(const Tree& tree);
void ImportTreeFromJSON(const nlohmann::json& json, Tree& tree);

}  // namespace BT

#endif  // BT_FACTORY_H
