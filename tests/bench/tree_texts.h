// The trees that are measured, as XML.
#ifndef COPPICE_TESTS_BENCH_TREE_TEXTS_H_
#define COPPICE_TESTS_BENCH_TREE_TEXTS_H_

#include <string>

namespace coppice::bench {

/// Exactly `nodes` nodes, all of which are visited in every tick; the root succeeds. A composite
/// has `arity` children, over which the remaining nodes are split evenly. Its kind goes by depth:
/// Sequence, Fallback, ReactiveSequence, and again. Under a Fallback all children but the last are
/// wrapped in an Inverter, so that they fail; with too few nodes for that it is a Sequence. Leaves
/// alternate between <CondOk/> and <ActOk/>.
std::string FullTree(int arity, int nodes);

/// A ReactiveFallback of 50 monitors that fail and one action that runs for ever.
std::string FlatArbiter();
/// The same with each monitor in a Sequence with an action.
std::string GuardedArbiter();
/// The same with monitors that read two ports.
std::string PortArbiter();
/// The same with a ScriptCondition `battery < i` as the i-th monitor.
std::string ScriptArbiter();

/// A Sequence of `count` times the same node, given as XML.
std::string SequenceOf(int count, const std::string& node);

/// A Parallel of `count` Timeout nodes of one hour, each with an action that runs for ever.
std::string ArmedTimeouts(int count);

/// ` name="script"` with the script as it must stand in XML.
std::string Attribute(const std::string& name, const std::string& script);

}  // namespace coppice::bench

#endif  // COPPICE_TESTS_BENCH_TREE_TEXTS_H_
