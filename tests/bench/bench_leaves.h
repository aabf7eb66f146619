// The leaves that are measured, and a tree that is ready to tick.
#ifndef COPPICE_TESTS_BENCH_BENCH_LEAVES_H_
#define COPPICE_TESTS_BENCH_BENCH_LEAVES_H_

#include <memory>
#include <string>
#include <vector>

#include "bt_core/engine/events/event_stream.h"
#include "bt_core/engine/executor.h"

namespace coppice::bench {

std::shared_ptr<const Registry> BenchRegistry();

/// Throws std::runtime_error if the text has errors.
std::shared_ptr<const Program> Load(const std::string& text);

/// Listens and does nothing.
class IdleSink : public TickSink {
 public:
  void OnTick(const TickEvents&) override {}
};

class IdleListener : public EventListener {
 public:
  void OnState(const StreamState&) override {}
  void OnTick(const TickEvents&) override {}
};

/// A tree on simulated time with so many idle sinks. The keys battery, charging and counter, where
/// the tree has them, are 80, false and 0.
struct Tree {
  explicit Tree(const std::string& text, int sinks = 0);
  SimulatedClock clock;
  std::vector<IdleSink> listeners;
  Executor executor;
};

/// A loop of `count` accesses inside one leaf, so that nothing but the port is measured.
std::string ReadLoop(int count);
std::string WriteLoop(int count);

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_BENCH_LEAVES_H_
