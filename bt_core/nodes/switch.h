// Switch2 .. Switch6 and Switch: one of several children, chosen by a value.
//
// In every tick the value is compared with the cases in order; the child of the first that matches
// is ticked, the last child if none does or the value is not set. When the choice changes, the
// child that ran before is halted first.
//
//   chosen child   SUCCESS    FAILURE    RUNNING    SKIPPED
//   result         SUCCESS    FAILURE    RUNNING    SKIPPED
//
// A value matches a case if it has the same text, or if both are numbers that differ by at most the
// epsilon of float; true and false are the numbers 1 and 0, and a name that scripts know is its
// number. An enum matches its name and its number. Source: BehaviorTree.CPP 4.
#ifndef COPPICE_BT_CORE_NODES_SWITCH_H_
#define COPPICE_BT_CORE_NODES_SWITCH_H_

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "bt_core/data/blackboard.h"
#include "bt_core/nodes/children.h"
#include "bt_core/script/script.h"

namespace coppice {

/// True if a value stands for the same as a text, in which the names of `constants` are numbers.
bool MatchesText(const Value& value, std::string_view text, const ScriptConstants& constants);

namespace internal {

template <class Tree>
Status TickChosen(Tree& tree, NodeIndex node, std::uint64_t choice) {
  const NodeIndex chosen = ChildAt(tree, node, choice);
  for (NodeIndex child = node + 1; child != tree.EndOf(node); child = tree.EndOf(child)) {
    if (child != chosen && tree.status(child) == Status::kRunning) tree.Halt(child);
  }
  return PassOn(tree, node, tree.Tick(chosen));
}

}  // namespace internal

/// Port 0: the value, of any type. Ports 1 .. n: the texts of the cases. n + 1 children.
template <class Tree>
Status TickSwitchN(Tree& tree, NodeIndex node) {
  const std::uint32_t cases = internal::CountChildren(tree, node) - 1;
  const Slot* variable = tree.SlotOf(node, 0);
  std::uint32_t choice = 0;
  const auto matches = [&] {
    const Slot* text = tree.SlotOf(node, choice + 1);
    return text && text->value.has_value() &&
           MatchesText(variable->value, text->value.template Get<std::string>(), tree.constants());
  };
  if (!variable || !variable->value.has_value()) choice = cases;
  while (choice < cases && !matches()) ++choice;
  return internal::TickChosen(tree, node, choice);
}

/// Port 0: the value, of any type. Port 1: the texts of the cases, separated by semicolons. Throws
/// std::invalid_argument unless there is one child for each and one more.
template <class Tree>
Status TickSwitch(Tree& tree, NodeIndex node) {
  const Slot* variable = tree.SlotOf(node, 0);
  const bool is_set = variable && variable->value.has_value();
  std::string_view rest = tree.template Port<std::string>(node, 1);
  std::uint32_t cases = 0;
  std::uint32_t choice = UINT32_MAX;
  for (bool more = true; more; ++cases) {
    const std::size_t semicolon = rest.find(';');
    const std::string_view text = rest.substr(0, semicolon);
    if (is_set && choice == UINT32_MAX && MatchesText(variable->value, text, tree.constants()))
      choice = cases;
    more = semicolon != std::string_view::npos;
    if (more) rest.remove_prefix(semicolon + 1);
  }
  const std::uint32_t children = internal::CountChildren(tree, node);
  if (children != cases + 1) {
    throw std::invalid_argument(std::to_string(cases) + " cases need " + std::to_string(cases + 1) +
                                " children, but there are " + std::to_string(children));
  }
  return internal::TickChosen(tree, node, choice == UINT32_MAX ? cases : choice);
}

}  // namespace coppice

#endif  // COPPICE_BT_CORE_NODES_SWITCH_H_
