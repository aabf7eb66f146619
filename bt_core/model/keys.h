// Which texts of attributes name a key of the blackboard, and what a SubTree shares with the tree
// outside: the rules of the language, for all who read trees.
//
//   <Drive goal="{goal}" speed="{=}" where="{@home}" text="goal_{x}"/>   goal, speed, @home, none
#ifndef COPPICE_BT_CORE_MODEL_KEYS_H_
#define COPPICE_BT_CORE_MODEL_KEYS_H_

#include <string_view>

#include "bt_core/model/document.h"
#include "bt_core/model/source_text.h"

namespace coppice {

/// The key that the text of an attribute names: "{goal}" is "goal", "=" and "{=}" are `own_name`.
/// "{@goal}" is "@goal", a key of the main tree. Blanks around a key do not count. Empty for a
/// literal, such as "goal_{x}": a key is the whole text or none of it.
std::string_view KeyOf(std::string_view text, std::string_view own_name);

/// True for a <SubTree> whose `_autoremap` is a true value: its keys are those of the tree outside,
/// but for the private ones and those that have attributes of their own.
bool IsAutoremapped(const Document& document, const Element& subtree);
bool IsAutoremapped(const StartTag& subtree);

/// True for a key that `_autoremap` leaves to the SubTree: it begins with an underscore.
bool IsPrivateKey(std::string_view key);

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_KEYS_H_
