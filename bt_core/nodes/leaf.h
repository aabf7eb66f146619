// Base classes of leaves: what a user derives from.
//
//   class IsDark : public Condition {          class Blink : public SyncAction {
//    public:                                    public:
//     static constexpr const char*               static constexpr const char*
//         kDescription = "...";                      kDescription = "...";
//     Input<double> lux{this, "lux", "..."};     Status Run() override { ...; return
//     Status::kSuccess; } bool Check() override {                  };
//       return *lux < 10.0;
//     }
//   };
//
// All functions are called on the ticking thread and must return soon: what takes time is started
// in OnStart and reported through a Mailbox. A leaf that throws fails; the text of the exception
// becomes its message.
#ifndef COPPICE_BT_CORE_NODES_LEAF_H_
#define COPPICE_BT_CORE_NODES_LEAF_H_

#include <string>
#include <string_view>
#include <utility>

#include "bt_core/base/clock.h"
#include "bt_core/base/status.h"
#include "bt_core/data/port.h"
#include "bt_core/model/manifest.h"

namespace coppice {

/// What a leaf may ask of the tree that ticks it.
class LeafHost {
 public:
  /// The time of the tree's clock at which this tick began; the same for all nodes in one tick.
  Time now() const { return now_; }

  /// Asks for a tick at that time at the latest, if this leaf is still running then.
  void WakeAt(Time time) {
    if (time < wake_at_) wake_at_ = time;
  }

  /// Why the leaf did what it did, for people: shown in the live view, kept in the record.
  virtual void AddMessage(std::string text) = 0;

 protected:
  ~LeafHost() = default;

  Time now_{0};
  Time wake_at_ = kNever;
};

class Leaf : public PortOwner {
 public:
  /// One tick. `starting` is true for the first tick of an activation.
  virtual Status Tick(bool starting) = 0;

  /// Called when a running leaf is no longer wanted. Must stop what it has started.
  virtual void Halt() {}

  void set_host(LeafHost* host) { host_ = host; }

 protected:
  Time now() const { return host_->now(); }
  void WakeAt(Time time) { host_->WakeAt(time); }

  /// Returns kFailure and says why.
  Status Fail(std::string reason) {
    host_->AddMessage(std::move(reason));
    return Status::kFailure;
  }
  void Say(std::string text) { host_->AddMessage(std::move(text)); }

 private:
  LeafHost* host_ = nullptr;
};

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
  /// The activation ends before the action does: stop it.
  virtual void OnHalted() = 0;

  Status Tick(bool starting) final { return starting ? OnStart() : OnRunning(); }
  void Halt() final { OnHalted(); }
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_LEAF_H_
