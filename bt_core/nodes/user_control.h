// Base classes of the user's own control nodes and decorators.
//
//   class Alternate : public UserControl {
//    public:
//     static constexpr const char* kDescription = "Ticks one child per activation, in turn.";
//     Status Tick(Children& children, bool starting) override {
//       if (starting) current_ = (current_ + 1) % children.size();
//       return children.Tick(current_);
//     }
//
//    private:
//     std::uint32_t current_ = 0;
//   };
//
//   class Invert : public UserDecorator {
//    public:
//     static constexpr const char* kDescription = "SUCCESS becomes FAILURE and the reverse.";
//     Status Tick(Children& child, bool) override {
//       const Status status = child.Tick(0);
//       if (status == Status::kSuccess) return Status::kFailure;
//       return status == Status::kFailure ? Status::kSuccess : status;
//     }
//   };
//
// Ports, Say, Fail, now() and WakeAt are those of leaves (leaf.h). What is kept between activations
// is a member, as `current_` above.
//
// The engine keeps the children in order, so the author cannot forget it: when Tick returns
// anything but RUNNING, or throws, all children are made idle and those that run are halted; a halt
// of the node halts them in document order, right after OnHalted. So a SKIPPED child needs no care
// either: return SKIPPED if no child had anything to do. All calls are on the ticking thread.
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

/// The children of one node, numbered from 0 in document order.
class Children {
 public:
  Children() = default;
  Children(ChildHost& host, std::vector<NodeIndex> nodes)
      : host_(&host), nodes_(std::move(nodes)) {}

  std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }

  /// Ticks a child: starts it, unless it is RUNNING. The result is never IDLE. A child that throws
  /// returns FAILURE. Undefined for k >= size().
  Status Tick(std::uint32_t k) { return host_->TickChild(nodes_[k]); }

  /// IDLE, RUNNING, or what it returned last in this activation of the parent.
  Status status(std::uint32_t k) const { return host_->StatusOfChild(nodes_[k]); }

  /// Halts a child if it is RUNNING and makes it IDLE.
  void Halt(std::uint32_t k) { host_->HaltChild(nodes_[k]); }

  /// The same for child k and all behind it; what a reactive node does when child k - 1 runs.
  void HaltFrom(std::uint32_t k) {
    for (; k < size(); ++k) Halt(k);
  }

 private:
  ChildHost* host_ = nullptr;
  std::vector<NodeIndex> nodes_;
};

/// A control node: one child or more; a derived class may declare another kChildren.
class UserControl : public UserNode {
 public:
  static constexpr NodeCategory kCategory = NodeCategory::kControl;
  static constexpr ChildCount kChildren{1, UINT32_MAX};

  /// One tick: decides which children are ticked, and the result. `starting` is true for the first
  /// tick of an activation.
  virtual Status Tick(Children& children, bool starting) = 0;

  /// The node was RUNNING and is no longer wanted. Its children are halted right after.
  virtual void OnHalted() {}

  Status Tick(bool starting) final { return Tick(children_, starting); }
  void Halt() final { OnHalted(); }
  /// The engine's.
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
