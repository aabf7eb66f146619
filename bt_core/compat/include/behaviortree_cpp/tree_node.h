// What all nodes have in common.
//
// A node is made once, when its tree is made, and ticked by Coppice's executor. Its ports are
// resolved then: getInput() of a port that providedPorts() declares looks up no key. Functions are
// for the ticking thread unless they say otherwise.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "behaviortree_cpp/basic_types.h"
#include "behaviortree_cpp/blackboard.h"
#include "behaviortree_cpp/internal/port_table.h"
#include "behaviortree_cpp/scripting/script_parser.hpp"
#include "behaviortree_cpp/utils/signal.h"
#include "behaviortree_cpp/utils/strcat.hpp"
#include "behaviortree_cpp/utils/wakeup_signal.hpp"

namespace BT {

/// What a node type is: its kind, its ID in XML and its ports.
struct TreeNodeManifest {
  NodeType type;
  std::string registration_ID;
  PortsList ports;
  KeyValueVector metadata;
};

using PortsRemapping = std::unordered_map<std::string, std::string>;
using NonPortAttributes = std::unordered_map<std::string, std::string>;

enum class PreCond { FAILURE_IF = 0, SUCCESS_IF, SKIP_IF, WHILE_TRUE, COUNT_ };
static const std::array<std::string, 4> PreCondNames = {"_failureIf", "_successIf", "_skipIf",
                                                        "_while"};
enum class PostCond { ON_HALTED = 0, ON_FAILURE, ON_SUCCESS, ALWAYS, COUNT_ };
static const std::array<std::string, 4> PostCondNames = {"_onHalted", "_onFailure", "_onSuccess",
                                                         "_post"};
template <>
std::string toStr<PostCond>(const PostCond& condition);
template <>
std::string toStr<PreCond>(const PreCond& condition);

/// What a node is made from.
struct NodeConfig {
  NodeConfig() {}

  Blackboard::Ptr blackboard;
  std::shared_ptr<ScriptingEnumsRegistry> enums;
  PortsRemapping input_ports;  ///< as written in XML, or the default
  PortsRemapping output_ports;
  NonPortAttributes other_attributes;
  const TreeNodeManifest* manifest = nullptr;
  uint16_t uid = 0;  ///< from 1, in preorder
  std::string path;  ///< unique in the tree
  std::map<PreCond, std::string> pre_conditions;
  std::map<PostCond, std::string> post_conditions;
};
using NodeConfiguration = NodeConfig;

template <class T>
inline constexpr bool hasNodeNameCtor() {
  return std::is_constructible<T, const std::string&>::value;
}
template <class T, class... Arguments>
inline constexpr bool hasNodeFullCtor() {
  return std::is_constructible<T, const std::string&, const NodeConfig&, Arguments...>::value;
}

class TreeNode;

namespace internal {

class TreeRun;

/// What watches and replaces the ticks of one node.
struct NodeCallbacks;

}  // namespace internal

class TreeNode {
 public:
  using Ptr = std::shared_ptr<TreeNode>;
  using StatusChangeSignal = Signal<TimePoint, const TreeNode&, NodeStatus, NodeStatus>;
  using StatusChangeSubscriber = StatusChangeSignal::Subscriber;
  using StatusChangeCallback = StatusChangeSignal::CallableFunction;
  using PreTickCallback = std::function<NodeStatus(TreeNode&)>;
  using PostTickCallback = std::function<NodeStatus(TreeNode&, NodeStatus)>;
  using TickMonitorCallback = std::function<void(TreeNode&, NodeStatus, std::chrono::microseconds)>;

  TreeNode(std::string name, NodeConfig config);
  TreeNode(const TreeNode&) = delete;
  TreeNode& operator=(const TreeNode&) = delete;
  virtual ~TreeNode();

  /// Ticks the node in its tree: what control nodes and decorators do with their children.
  virtual NodeStatus executeTick();
  /// Halts it if it is RUNNING, and makes it IDLE.
  void haltNode();
  bool isHalted() const { return status() == NodeStatus::IDLE; }
  NodeStatus status() const {
    const NodeStatus own = own_status_.load(std::memory_order_relaxed);
    return own != kOutside ? own : StatusInTree();
  }
  /// Waits until the node is not IDLE. Any thread but the ticking one.
  NodeStatus waitValidStatus();

  const std::string& name() const { return name_; }
  virtual NodeType type() const = 0;
  uint16_t UID() const { return config_.uid; }
  const std::string& fullPath() const { return config_.path; }
  const std::string& registrationName() const { return registration_id_; }
  const NodeConfig& config() const { return config_; }
  NodeConfig& config() { return config_; }

  /// Called at every change of the status, on the ticking thread, while the subscriber lives.
  StatusChangeSubscriber subscribeToStatusChange(StatusChangeCallback callback);
  /// Before the tick: SUCCESS, FAILURE, SKIPPED or RUNNING take the place of the tick, IDLE does
  /// not.
  void setPreTickFunction(PreTickCallback callback);
  /// After the tick: SUCCESS or FAILURE take the place of its result.
  void setPostTickFunction(PostTickCallback callback);
  void setTickMonitorCallback(TickMonitorCallback callback);

  /// The value of an input port, or why there is none. Any thread.
  template <class T>
  Result getInput(StringView key, T& destination) const {
    const coppice::Value* const value = OpenInput(key);
    if (value && internal::ReadAsIs(*value, destination)) return Result();
    return ReadSlowly(key, destination);
  }
  template <class T>
  Expected<T> getInput(StringView key) const {
    if constexpr (std::is_same_v<internal::KeptAs<T>, T>) {
      const coppice::Value* const value = OpenInput(key);
      if (value && value->type() == &internal::TypeFor<T>()) return value->template Get<T>();
    }
    return ExpectSlowly<T>(key);
  }
  template <class T>
  Expected<Timestamp> getInputStamped(StringView key, T& destination) const;
  template <class T>
  Expected<StampedValue<T>> getInputStamped(StringView key) const {
    StampedValue<T> out;
    const Expected<Timestamp> stamp = getInputStamped(key, out.value);
    if (!stamp) return nonstd::make_unexpected(stamp.error());
    out.stamp = *stamp;
    return out;
  }

  /// Writes the key of an output port. Any thread. Throws LogicError if the key has another type.
  template <class T>
  Result setOutput(StringView key, const T& value);

  /// The value of the key of a port, to be changed in place.
  AnyPtrLocked getLockedPortContent(const std::string& key);
  /// As written in XML, or the default; empty if there is none.
  StringView getRawPortValue(const std::string& key) const;

  static bool isBlackboardPointer(StringView text, StringView* stripped_pointer = nullptr);
  static StringView stripBlackboardPointer(StringView text);
  /// The key that a port's text names: "{key}", or the port's own name for "{=}".
  static Expected<StringView> getRemappedKey(StringView port_name, StringView remapped_port);

  /// Asks for a tick at once. Any thread.
  void emitWakeUpSignal();
#ifdef USE_BTCPP3_OLD_NAMES
  void emitStateChanged() { emitWakeUpSignal(); }
#endif
  bool requiresWakeUp() const { return run_ != nullptr; }

  /// Makes a node; it knows the config also if its class takes the name only.
  template <class DerivedT, class... Arguments>
  static std::unique_ptr<TreeNode> Instantiate(const std::string& name, const NodeConfig& config,
                                               Arguments... arguments) {
    static_assert(hasNodeFullCtor<DerivedT, Arguments...>() || hasNodeNameCtor<DerivedT>());
    if constexpr (hasNodeFullCtor<DerivedT, Arguments...>()) {
      return std::make_unique<DerivedT>(name, config, arguments...);
    } else {
      auto node = std::make_unique<DerivedT>(name, arguments...);
      node->config() = config;
      return node;
    }
  }

 protected:
  friend class BehaviorTreeFactory;
  friend class StatusChangeLogger;
  friend class DecoratorNode;
  friend class ControlNode;
  friend class Tree;
  friend class internal::TreeRun;

  /// What the class does. Not to be called by users: see executeTick().
  virtual NodeStatus tick() = 0;
  void resetStatus();
  void setRegistrationID(StringView id) { registration_id_ = id; }
  void modifyPortsRemapping(const PortsRemapping& new_remapping);
  /// Within tick(): what status() says until it returns.
  void setStatus(NodeStatus new_status);

  using PreScripts = std::array<ScriptFunction, std::size_t(PreCond::COUNT_)>;
  using PostScripts = std::array<ScriptFunction, std::size_t(PostCond::COUNT_)>;
  PreScripts& preConditionsScripts() { return pre_scripts_; }
  PostScripts& postConditionsScripts() { return post_scripts_; }

  template <class T>
  T parseString(const std::string& text) const;

  /// True if the engine is calling, and the class does its work; false if a parent of the user's
  /// calls: then the answer is TickThroughEngine().
  bool IsEngineCalling() const { return own_status_.load(std::memory_order_relaxed) != kOutside; }
  NodeStatus TickThroughEngine();
  NodeStatus TickAsItself() { return IsEngineCalling() ? tick() : TickThroughEngine(); }

 private:
  friend class internal::TreeRun;

  template <class T>
  [[gnu::noinline]] Result ReadSlowly(StringView key, T& destination) const {
    const Expected<Timestamp> stamp = getInputStamped(key, destination);
    if (!stamp) return nonstd::make_unexpected(stamp.error());
    return Result();
  }

  template <class T>
  [[gnu::noinline]] Expected<T> ExpectSlowly(StringView key) const {
    Expected<T> out;
    const Result result = getInput(key, *out);
    if (!result) return nonstd::make_unexpected(result.error());
    return out;
  }

  // Of a port that is resolved, on the ticking thread; else null.
  const coppice::Value* OpenInput(StringView key) const {
    if (!gate_->is_open()) return nullptr;
    const internal::PortLink* const port = ports_.Find(key);
    return port && port->input ? &port->input->value : nullptr;
  }

  // What stands behind an input port.
  struct Source {
    const PortInfo* info = nullptr;
    std::string text;                      // a literal
    Any default_value;                     // one without text
    std::shared_ptr<internal::Cell> cell;  // of a key
    std::string error;                     // or why there is nothing
  };
  Source SourceOf(const std::string& key) const;
  static Any ValueOf(const internal::Cell& cell, Timestamp& stamp);
  std::shared_ptr<internal::Cell> CellOfOutput(StringView key, std::string& error) const;
  template <class T>
  T FromText(const PortInfo* info, const std::string& text) const;

  // Called after each tick and halt of the tree.
  Signal<>::Subscriber SubscribeToTickEnd(std::function<void()> callback);

  // Conditions that code has set; those of the XML are the engine's.
  void FindScripts();
  Expected<NodeStatus> AskPreScripts(NodeStatus before);
  void RunPostScript(PostCond condition);
  void RunPostScripts(NodeStatus result);

  static constexpr auto kOutside = static_cast<NodeStatus>(-1);  // of a call of the engine

  NodeStatus StatusInTree() const;
  NodeStatus TickWithScripts();
  void HaltForEngine();
  virtual void halt() = 0;

  std::string name_;
  NodeConfig config_;
  std::string registration_id_;
  PreScripts pre_scripts_;
  PostScripts post_scripts_;

  internal::TreeRun* run_ = nullptr;  // null: in no tree
  internal::Gate* gate_;
  std::uint32_t index_ = 0;
  bool has_scripts_ = false;
  std::atomic<NodeStatus> own_status_{kOutside};  // while the engine calls
  internal::PortTable ports_;
  std::unique_ptr<internal::NodeCallbacks, void (*)(internal::NodeCallbacks*)> callbacks_;
};

template <class T>
T TreeNode::parseString(const std::string& text) const {
  if constexpr (std::is_enum_v<T>) {
    return internal::EnumFromText<T>(text, config_.enums.get());
  } else {
    return convertFromString<T>(text);
  }
}

template <class T>
T TreeNode::FromText(const PortInfo* info, const std::string& text) const {
  if (info && info->converter()) return info->converter()(text).template cast<T>();
  return parseString<T>(text);
}

template <class T>
Expected<Timestamp> TreeNode::getInputStamped(StringView key, T& destination) const {
  const Source source = SourceOf(std::string(key));
  if (!source.error.empty()) return nonstd::make_unexpected(source.error);
  try {
    if (!source.cell) {
      destination = source.default_value.empty() ? FromText<T>(source.info, source.text)
                                                 : source.default_value.template cast<T>();
      return Timestamp{};
    }
    Timestamp stamp;
    const Any value = ValueOf(*source.cell, stamp);
    if constexpr (std::is_same_v<T, Any>) {
      destination = value;
    } else {
      if (value.empty()) {
        return nonstd::make_unexpected(
            StrCat("getInput() failed because it was unable to find the "
                   "key [",
                   key, "] remapped to [", source.text, "]"));
      }
      if (!std::is_same_v<T, std::string> && value.isString()) {
        destination = FromText<T>(source.info, value.template cast<std::string>());
      } else {
        auto converted = config_.blackboard->tryCastWithPolymorphicFallback<T>(&value);
        if (!converted) return nonstd::make_unexpected(converted.error());
        destination = *std::move(converted);
      }
    }
    return stamp;
  } catch (const std::exception& error) {
    return nonstd::make_unexpected(StrCat("getInput(): ", error.what()));
  }
}

template <class T>
Result TreeNode::setOutput(StringView key, const T& value) {
  if (gate_->is_open()) {
    const internal::PortLink* const port = ports_.Find(key);
    if (port && port->output) {
      internal::WriteTo(*port->output, value, port->name);
      return Result();
    }
  }
  std::string error;
  const auto cell = CellOfOutput(key, error);
  if (!cell) return nonstd::make_unexpected(error);
  internal::WriteTo(*cell, value, key);
  return Result();
}

/// Every port of T is the key of its own name.
template <class T>
void assignDefaultRemapping(NodeConfig& config) {
  for (const auto& [name, port] : getProvidedPorts<T>()) {
    if (port.direction() != PortDirection::OUTPUT) config.input_ports[name] = "{=}";
    if (port.direction() != PortDirection::INPUT) config.output_ports[name] = "{=}";
  }
}

}  // namespace BT
