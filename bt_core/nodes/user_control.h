// Base classes of the user's own control nodes and decorators.
//
//   class Alternate : public UserControl {                    // one child per activation, in turn
//    public:
//     static constexpr const char* kDescription = "Ticks its children in turn, one per
//     activation."; Status Tick(Children& children, bool starting) override {
//       if (starting) current_ = (current_ + 1) % children.size();
//       return children.Tick(current_);
//     }
//    private:
//     std::uint32_t current_ = 0;
//   };
//
// The engine, not the author, resets and halts children: when Tick returns anything but RUNNING all
// children are made idle, and a halt of the node halts them. All calls are on the ticking thread.
#ifndef COPPICE_BT_CORE_NODES_USER_CONTROL_H_
#define COPPICE_BT_CORE_NODES_USER_CONTROL_H_

#include <cstdint>
#include <utility>
#include <vector>

#include "bt_core/nodes/control.h"
#include "bt_core/nodes/leaf.h"
#include "bt_core/nodes/node_type.h"

namespace coppice {

/// What the engine does for the children of a user's node.
class ChildHost {
 public:
  virtual Status TickChild(NodeIndex node) = 0;
  virtual void HaltChild(NodeIndex node) = 0;
  virtual Status StatusOfChild(NodeIndex node) const = 0;

 protected:
  ~ChildHost() = default;
};

/// The children of one node, numbered from 0.
class Children {
 public:
  Children() = default;
  Children(ChildHost& host, std::vector<NodeIndex> nodes)
      : host_(&host), nodes_(std::move(nodes)) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }

  /// Ticks a child. Undefined for k >= size().
  Status Tick(std::uint32_t k) { return host_->TickChild(nodes_[k]); }

  /// IDLE, RUNNING, or what it returned last in this activation of the parent.
  Status status(std::uint32_t k) const { return host_->StatusOfChild(nodes_[k]); }

  /// Halts a child if it is RUNNING and makes it IDLE.
  void Halt(std::uint32_t k) { host_->HaltChild(nodes_[k]); }

 private:
  ChildHost* host_ = nullptr;
  std::vector<NodeIndex> nodes_;
};

class UserControl : public UserNode {
 public:
  static constexpr NodeCategory kCategory = NodeCategory::kControl;
  static constexpr ChildCount kChildren{1, UINT32_MAX};

  /// One tick. `starting` is true for the first tick of an activation.
  virtual Status Tick(Children& children, bool starting) = 0;

  /// The node was RUNNING and is no longer wanted. Its children are halted right after.
  virtual void OnHalted() {}

  Status Tick(bool starting) final { return Tick(children_, starting); }
  void Halt() final { OnHalted(); }
  void set_children(Children children) { children_ = std::move(children); }

 private:
  Children children_;
};

/// A node with exactly one child: children.Tick(0).
class UserDecorator : public UserControl {
 public:
  static constexpr NodeCategory kCategory = NodeCategory::kDecorator;
  static constexpr ChildCount kChildren{1, 1};
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_USER_CONTROL_H_
