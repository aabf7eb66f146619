// Base classes of leaves: what a user derives from.
//
//   class IsDark : public Condition {
//    public:
//     static constexpr const char* kDescription = "Is it dark?";
//     Input<double> lux{this, "lux", "how bright it is [lx]"};
//     bool Check() override { return *lux < 10.0; }
//   };
//
// An action that is done at once derives from SyncAction and has Run() instead, which returns its
// result; one that takes time derives from Action.
//
// All functions are called on the ticking thread and must return soon: what takes time is started
// in OnStart and reported through a Mailbox. A leaf that throws fails; the text of the exception
// becomes its message.
#ifndef COPPICE_BT_CORE_NODES_LEAF_H_
#define COPPICE_BT_CORE_NODES_LEAF_H_

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>

#include "bt_core/base/clock.h"
#include "bt_core/base/status.h"
#include "bt_core/data/port.h"
#include "bt_core/model/manifest.h"
#include "bt_core/nodes/control.h"

namespace coppice {

/// What a node of the user may ask of the tree that ticks it.
class LeafHost {
 public:
  /// The time of the tree's clock at which this tick began; the same for all nodes in one tick.
  Time now() const { return now_; }

  /// Asks for a tick at that time at the latest. Holds until the next tick, which may come earlier
  /// for another reason: a node that still waits then asks again.
  void WakeAt(Time time) {
    if (time < wake_at_) wake_at_ = time;
  }

  /// Why the leaf did what it did, for people: shown in the live view, kept in the record.
  virtual void AddMessage(std::string text) = 0;

  /// Called in Halt: the node needs until `limit` after now to stop. See Action::OnDraining.
  virtual void Drain(Duration limit) = 0;

  /// The number of the node that is called now, in preorder.
  virtual NodeIndex current_node() const { return {}; }

  // For the engine: SKIPPED does not end what a RUNNING node has begun.
  bool keeps_skipped_nodes() const { return kept_ != 0; }
  /// True if the node that is ticked now was skipped while it was RUNNING: it goes on.
  virtual bool ResumeSkipped() { return false; }
  /// The node that is ticked now has returned SKIPPED.
  virtual void KeepSkipped() {}

 protected:
  ~LeafHost() = default;

  std::uint32_t kept_ = 0;  // number of skipped nodes that keep something

  Time now_{};
  Time wake_at_ = kNever;
};

/// What all nodes of the user have in common: leaves here, inner nodes in user_control.h.
class UserNode : public PortOwner {
 public:
  /// One tick. `starting` is true for the first tick of an activation.
  virtual Status Tick(bool starting) = 0;

  /// Called when a running node is no longer wanted. Must stop what it has started.
  virtual void Halt() {}

  /// After a Halt that called Drain: true when everything has stopped. Asked in every tick.
  virtual bool HasStopped() { return true; }

  /// Called by the engine before anything else; virtual for nodes that contain another one.
  virtual void set_host(LeafHost* host) { host_ = host; }
  LeafHost& host() const { return *host_; }

 protected:
  Time now() const { return host_->now(); }
  void WakeAt(Time time) { host_->WakeAt(time); }

  /// Returns kFailure and says why.
  Status Fail(std::string reason) {
    host_->AddMessage(std::move(reason));
    return Status::kFailure;
  }
  void Say(std::string text) { host_->AddMessage(std::move(text)); }
  void DrainFor(Duration limit) { host_->Drain(limit); }

 private:
  LeafHost* host_ = nullptr;
};

/// A node without children.
class Leaf : public UserNode {};

/// A question about the world, answered at once.
class Condition : public Leaf {
 public:
  static constexpr NodeCategory kCategory = NodeCategory::kCondition;
  virtual bool Check() = 0;
  Status Tick(bool) final { return Check() ? Status::kSuccess : Status::kFailure; }
};

/// An action that is done within one tick.
class SyncAction : public Leaf {
 public:
  static constexpr NodeCategory kCategory = NodeCategory::kAction;
  virtual Status Run() = 0;
  Status Tick(bool) final { return Run(); }
};

/// An action that takes more than one tick. It is ticked when a message or a wake-up time comes,
/// and at the period of the loop that runs the tree.
class Action : public Leaf {
 public:
  static constexpr NodeCategory kCategory = NodeCategory::kAction;

  /// First tick of an activation.
  virtual Status OnStart() = 0;
  /// Every further tick while it returned kRunning.
  virtual Status OnRunning() = 0;
  /// The activation ends before the action does: stop it. What takes several ticks to stop, such as
  /// the cancelling of a remote goal, calls DrainFor(limit) here: the tree goes on, OnDraining is
  /// asked in each tick, and a new activation begins only when it has answered true or `limit` is
  /// over; until then the node is RUNNING.
  virtual void OnHalted() = 0;

  /// True when the action has stopped. Asked only after DrainFor.
  virtual bool OnDraining() { return true; }

  Status Tick(bool starting) final { return starting ? OnStart() : OnRunning(); }
  void Halt() final { OnHalted(); }
  bool HasStopped() final { return OnDraining(); }
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_LEAF_H_
