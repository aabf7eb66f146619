// Runs one tree in the oracle and in the engine and compares, after every tick or halt: which
// leaves were ticked and halted in which order, the result of the root, the status of every node,
// what hooks have added to the key "hooks" (one character each), and when the next tick is wanted.
#ifndef COPPICE_TESTS_CONFORMANCE_SIDE_BY_SIDE_H_
#define COPPICE_TESTS_CONFORMANCE_SIDE_BY_SIDE_H_

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/engine/events/for_each_event.h"
#include "bt_core/engine/events/status_follower.h"
#include "bt_core/engine/executor.h"
#include "tests/conformance/oracle.h"

namespace coppice::conformance {

/// The XML of a shape.
std::string ToXml(const Shape& shape);

/// What both sides did, as numbers that are cheap to compare.
using Log = std::vector<std::int64_t>;

class SideBySide {
 public:
  /// `choose` is asked for the result of each leaf that the oracle ticks; the engine's leaves get
  /// the same results in the same order. kThrow makes the engine's leaf throw instead of failing.
  static constexpr int kThrow = 5;
  SideBySide(const Shape& shape, std::function<int()> choose);
  ~SideBySide();

  void Tick();
  void Halt();

  /// Writes to a key of the main tree from outside; the next call is Tick.
  template <class T>
  void Write(const std::string& key, const T& value, const std::string& text) {
    world_.Write("{@" + key + "}", text);
    executor_->Writer<T>(key).Send(value);
  }

  /// From now on the statuses are those that somebody sees who is told of every change.
  void Listen();
  void Advance(Duration duration);

  /// Empty if both sides did the same so far; else both logs. Starts a new comparison.
  std::string Difference();

 private:
  class ScriptedLeaf;
  void LogStatuses();
  void LogHooks();
  std::string Print(const Log& log) const;

  const Shape shape_;
  std::string xml_;
  std::function<int()> choose_;
  std::vector<int> choices_;     // of the oracle in this tick
  std::size_t next_choice_ = 0;  // of the engine
  Log expected_;
  Log actual_;
  std::size_t expected_hooks_ = 0;  // bytes of the key "hooks" that are in the log
  std::size_t actual_hooks_ = 0;
  World world_;
  std::unique_ptr<OracleNode> oracle_;
  std::vector<OracleNode*> oracle_nodes_;  // in preorder, as the program's
  SimulatedClock clock_;
  class Watcher : public TickSink {
   public:
    void OnTick(const TickEvents& events) override {
      ForEachRun(
          events.words,
          [this](const std::uint32_t* at, const std::uint32_t* end) {
            return noted->Note(at, end);
          },
          [](const Event&) {});
      EventReader reader(events.words);
      for (Event event; reader.Next(event);) follower->Apply(event);
    }
    std::optional<StatusFollower> follower;  // none: does not watch
    std::optional<StatusFollower> noted;     // knows the same, but settles only when it is asked
  } watcher_;
  std::unique_ptr<Executor> executor_;
};

}  // namespace coppice::conformance

#endif  // COPPICE_TESTS_CONFORMANCE_SIDE_BY_SIDE_H_
