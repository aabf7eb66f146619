// Tests one node of the user without a robot, without ROS and without a tree of its own.
//
//   LeafHarness harness = LeafHarness::For<Wait>();      // constructor arguments go here
//   harness.Set("seconds", 2.0);
//   EXPECT_EQ(harness.Tick(), Status::kRunning);
//   harness.Advance(std::chrono::seconds(2));
//   EXPECT_EQ(harness.Tick(), Status::kSuccess);
//
// A decorator or control node gets children that do as they are told:
//
//   LeafHarness harness = LeafHarness::WithChildren<Alternate>(2);
//   harness.SetChild(0, {Status::kRunning, Status::kSuccess});
//   harness.Tick();
//   EXPECT_EQ(harness.TakeChildEvents(), std::vector<std::string>{"start 0"});
//
// Every port is bound to a key of its own name; one with a default has that value until the test
// sets it. The node runs in the real executor on simulated time, so what the test sees is what the
// robot does. All calls from one thread.
#ifndef COPPICE_BT_CORE_TESTING_LEAF_HARNESS_H_
#define COPPICE_BT_CORE_TESTING_LEAF_HARNESS_H_

#include <cstdint>
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
    return WithChildren<T>(0, std::move(args)...);
  }

  /// The same for a decorator (1 child) or a control node.
  template <class T, class... Args>
  static LeafHarness WithChildren(std::uint32_t children, Args... args) {
    auto registry = std::make_shared<Registry>();
    registry->Register<T>("Node", std::move(args)...);
    return LeafHarness(std::move(registry), "Node", children);
  }

  /// The same for a node type of a registry: a lambda, a node of a plugin, a built-in node. Throws
  /// std::invalid_argument if there is no such type or it does not take so many children.
  LeafHarness(std::shared_ptr<const Registry> registry, const std::string& id,
              std::uint32_t children = 0);
  LeafHarness(LeafHarness&&) noexcept;
  ~LeafHarness();

  /// Gives an input its value, as if another node had written the key. Throws std::invalid_argument
  /// if there is no such port or it has another type.
  template <class T>
  void Set(const std::string& port, const T& value) {
    SetValue(port, Value(value));
  }
  /// The same for a value whose type is known only when the program runs.
  void SetValue(const std::string& port, Value value);

  /// What an output wrote. Throws std::out_of_range if nothing was written yet.
  template <class T>
  T Get(const std::string& port) const {
    const Value& value = executor_->blackboard()[SlotOf(port, TypeOf<T>())].value;
    if (!value.has_value()) throw std::out_of_range("port \"" + port + "\" was not written");
    return value.Get<T>();
  }
  bool WasWritten(const std::string& port) const;

  /// Of a port whose type is known only when the program runs: the type, null if it takes any, and
  /// the value, which may be empty. Throw std::invalid_argument if there is no such port.
  const Type* TypeOfPort(const std::string& port) const;
  const Value& ValueOf(const std::string& port) const;

  Status Tick();
  void Halt();
  void Advance(Duration duration) { clock_->Advance(duration); }

  /// Ticks until the node is done: moves the time to each wake-up that it asks for, and where it
  /// asks for none waits for a message from another thread. Returns kRunning if after `limit` of
  /// real time it is still not done.
  Status TickUntilDone(Duration limit = std::chrono::seconds(10));

  /// After a Halt: asks the node whether it has stopped, without a tick, until it says so; between
  /// two questions the time moves by `step`. False if after 10 s of real time it has not.
  bool WaitUntilStopped(Duration step = Duration::zero());

  /// When the node asked to be ticked again; kNever if it did not.
  Time next_tick() const { return executor_->next_tick(); }

  /// What the node said in the last tick or halt, for example why it failed.
  const std::vector<std::string>& messages() const;
  std::string message() const { return messages().empty() ? "" : messages().back(); }

  /// Child k returns these results in turn, one per tick, and then repeats the last. A child that
  /// nobody has told anything returns SUCCESS.
  void SetChild(std::uint32_t k, std::vector<Status> results);
  Status child_status(std::uint32_t k) const;

  /// What happened to the children since the last call: "start 0", "tick 0", "halt 0".
  std::vector<std::string> TakeChildEvents();

 private:
  class MessageSink;
  struct Children;
  SlotIndex SlotOf(const std::string& port) const;
  SlotIndex SlotOf(const std::string& port, const Type& type) const;

  std::unique_ptr<SimulatedClock> clock_;
  std::unique_ptr<MessageSink> sink_;
  std::unique_ptr<Children> children_;
  std::unique_ptr<Executor> executor_;
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_LEAF_HARNESS_H_
