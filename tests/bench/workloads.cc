#include "tests/bench/workloads.h"

#include <stdexcept>

#include "tests/bench/bench_leaves.h"
#include "tests/bench/tree_texts.h"

namespace coppice::bench {
namespace {

constexpr char kTwoTerms[] = "battery > 20 && !charging";

std::string Guarded(const std::string& attribute, const std::string& script) {
  return SequenceOf(100, "<ActOk" + Attribute(attribute, script) + "/>");
}

}  // namespace

// The peer's figures for where it is not installed: callgrind on the same trees, g++ 12.2 -O3.
const std::vector<Workload>& Workloads() {
  static const std::vector<Workload> all = {
      {"full_4ary_100", "node", 100, 45, 913, FullTree(4, 100)},
      {"full_4ary_1000", "node", 1000, 45, 966, FullTree(4, 1000)},
      {"full_4ary_10000", "node", 10000, 50, 999, FullTree(4, 10000)},
      {"full_4ary_100000", "node", 100000, 50, 957, FullTree(4, 100000)},
      {"full_2ary_1000", "node", 1000, 50, 1008, FullTree(2, 1000)},
      {"full_4ary_1000, 1 sink", "node", 1000, 0, 0, FullTree(4, 1000), 1},
      {"full_4ary_1000, 5 sinks", "node", 1000, 0, 0, FullTree(4, 1000), 5},
      {"full_4ary_1000, streamed", "node", 1000, 0, 0, FullTree(4, 1000), 0, true},
      {"arbiter_flat_50", "tick", 1, 2000, 42090, FlatArbiter()},
      {"arbiter_guarded_50", "tick", 1, 4000, 107940, GuardedArbiter()},
      {"arbiter_port_50", "tick", 1, 3000, 127096, PortArbiter()},
      {"arbiter_script_50", "tick", 1, 5000, 136828, ScriptArbiter()},
      {"port_read", "access", 1000, 10, 708, ReadLoop(1000)},
      {"port_write", "access", 1000, 20, 768, WriteLoop(1000)},
      {"script_condition_two_terms", "node", 100, 0, 4554,
       SequenceOf(100, "<ScriptCondition" + Attribute("code", kTwoTerms) + "/>")},
      {"guard_skip_if_true", "node", 100, 0, 3000, Guarded("_skipIf", kTwoTerms)},
      {"guard_failure_if_false", "node", 100, 0, 2966,
       Guarded("_failureIf", "battery <= 20 || charging")},
      {"hook_on_success", "node", 100, 0, 0, Guarded("_onSuccess", "counter = counter + 1")},
  };
  return all;
}

const Workload& FindWorkload(const std::string& name) {
  for (const Workload& workload : Workloads()) {
    if (workload.name == name) return workload;
  }
  throw std::invalid_argument("no workload \"" + name + "\"");
}

}  // namespace coppice::bench
