// What leaves do that only the robot's program knows (stand_in.h) and that nobody has told
// anything, as rules by type.
#ifndef COPPICE_BT_CORE_TESTING_DEFAULT_LEAVES_H_
#define COPPICE_BT_CORE_TESTING_DEFAULT_LEAVES_H_

#include <vector>

#include "bt_core/engine/program.h"
#include "bt_core/testing/scenario.h"

namespace coppice {

/// A condition is true, an action takes a second and succeeds. Without a model, what is named
/// IsSomething or HasSomething is taken for a condition.
std::vector<PlacedRule> DefaultLeaves(const Program& program);

/// By chance, behind the rules that are `given`: a condition is true in half of the cases and stays
/// what it is for up to five seconds; an action takes up to two seconds and succeeds in four of
/// five. Both write one of a few values of the port's type to each output: that of its default,
/// true and false, small numbers, the port's name; nothing where the type is not known or another
/// one. A type that a given rule for types fits has that one alone, be its pattern less specific
/// ("<*Fault>").
std::vector<PlacedRule> RandomLeaves(const Program& program,
                                     const std::vector<PlacedRule>& given = {});

}  // namespace coppice

#endif  // COPPICE_BT_CORE_TESTING_DEFAULT_LEAVES_H_
