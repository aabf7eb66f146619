// Work that is done at a period while a branch is active: a decorator that looks after something as
// long as its child runs.
//
//   class WatchBattery : public Service {
//    public:
//     static constexpr const char* kDescription = "Keeps the charge up to date.";
//     Output<double> charge{this, "charge", "0 to 1"};
//
//    private:
//     void OnEnter() override { battery_.Open(); }
//     void OnPeriod() override { charge.Set(battery_.Read()); }
//     void OnExit() override { battery_.Close(); }
//   };
//
//   <WatchBattery charge="{charge}" period_msec="200"> <Patrol/> </WatchBattery>
//
// In the first tick of an activation OnEnter and then OnPeriod are called before the child is
// ticked; OnPeriod again in the first tick at or after each further period, in a fixed rhythm:
// periods that were missed are left out. The result is the child's. All functions are called on the
// ticking thread and must return soon.
#ifndef COPPICE_BT_CORE_NODES_SERVICE_H_
#define COPPICE_BT_CORE_NODES_SERVICE_H_

#include <chrono>
#include <utility>

#include "bt_core/nodes/user_control.h"

namespace coppice {

class Service : public UserDecorator {
 public:
  Input<unsigned> period{this, "period_msec", "time between two runs [ms]; 0: in every tick", 500};

  Status Tick(Children& child, bool starting) final {
    try {
      if (starting) {
        OnEnter();
        entered_ = true;
        next_ = now();
      }
      if (now() >= next_) RunNow();
      const Status result = child.Tick(0);
      if (result != Status::kRunning) {
        Exit();
      } else if (next_ > now()) {
        WakeAt(next_);
      }
      return result;
    } catch (...) {
      Exit();
      throw;
    }
  }
  void OnHalted() final { Exit(); }

 protected:
  /// The branch becomes active. If it throws, the node fails and OnExit is not called.
  virtual void OnEnter() {}
  virtual void OnPeriod() = 0;
  /// Once for each OnEnter: after the child's result, before a halt of the child, or after an
  /// exception.
  virtual void OnExit() {}

 private:
  void RunNow() {
    OnPeriod();
    const Duration step = std::chrono::milliseconds(*period);
    if (step > Duration::zero()) next_ += step * ((now() - next_) / step + 1);
  }
  void Exit() {
    if (std::exchange(entered_, false)) OnExit();
  }

  Time next_{};
  bool entered_ = false;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_SERVICE_H_
