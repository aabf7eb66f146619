// Tests one leaf without a robot, without ROS and without a tree of its own.
//
//   LeafHarness harness = LeafHarness::For<Wait>();      // constructor arguments go here
//   harness.Set("seconds", 2.0);
//   EXPECT_EQ(harness.Tick(), Status::kRunning);
//   harness.Advance(std::chrono::seconds(2));
//   EXPECT_EQ(harness.Tick(), Status::kSuccess);
//
// Every port is bound to a key of its own name, except those given as literals. The leaf runs in
// the real executor on simulated time, so what the test sees is what the robot does.
#ifndef COPPICE_BT_CORE_TESTING_LEAF_HARNESS_H_
#define COPPICE_BT_CORE_TESTING_LEAF_HARNESS_H_

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "bt_core/engine/executor.h"

namespace coppice {

class LeafHarness {
 public:
  /// A harness for leaf type T; the arguments go to its constructor.
  template <class T, class... Args>
  static LeafHarness For(Args... args) {
    auto registry = std::make_shared<Registry>();
    registry->Register<T>("Leaf", std::move(args)...);
    return LeafHarness(std::move(registry));
  }

  explicit LeafHarness(std::shared_ptr<const Registry> registry);
  LeafHarness(LeafHarness&&) noexcept;
  ~LeafHarness();

  /// Gives an input its value, as if another node had written the key.
  template <class T>
  void Set(const std::string& port, const T& value) {
    Inbox& inbox = *executor_->inbox();
    inbox.Post(SlotOf(port, TypeOf<T>()), 0, Value(value));
  }

  /// What an output wrote. Throws std::out_of_range if nothing was written yet.
  template <class T>
  T Get(const std::string& port) const {
    const Value& value = executor_->blackboard()[SlotOf(port, TypeOf<T>())].value;
    if (!value.has_value()) throw std::out_of_range("port \"" + port + "\" was not written");
    return value.Get<T>();
  }
  bool WasWritten(const std::string& port) const;

  Status Tick();
  void Halt();
  void Advance(Duration duration) { clock_->Advance(duration); }

  /// When the leaf asked to be ticked again; kNever if it did not.
  Time next_tick() const { return executor_->next_tick(); }

  /// What the leaf said in the last tick or halt, for example why it failed.
  const std::vector<std::string>& messages() const;
  std::string message() const { return messages().empty() ? "" : messages().back(); }

 private:
  class MessageSink;
  SlotIndex SlotOf(const std::string& port, const Type& type) const;

  std::unique_ptr<SimulatedClock> clock_;
  std::unique_ptr<MessageSink> sink_;
  std::unique_ptr<Executor> executor_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_LEAF_HARNESS_H_
