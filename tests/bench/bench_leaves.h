// The leaves that are measured, and a tree that is ready to tick.
#ifndef COPPICE_TESTS_BENCH_BENCH_LEAVES_H_
#define COPPICE_TESTS_BENCH_BENCH_LEAVES_H_

#include <memory>
#include <string>

#include "bt_core/engine/executor.h"

namespace coppice::bench {

std::shared_ptr<const Registry> BenchRegistry();

/// Throws std::runtime_error if the text has errors.
std::shared_ptr<const Program> Load(const std::string& text);

/// A tree on simulated time.
struct Tree {
  explicit Tree(const std::string& text);
  SimulatedClock clock;
  Executor executor;
};

/// A loop of `count` accesses inside one leaf, so that nothing but the port is measured.
std::string ReadLoop(int count);
std::string WriteLoop(int count);

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_BENCH_LEAVES_H_
