// What somebody else says was meant: a service that may only choose among the intents and quote the
// names. It is checked like any other input: the intent must be in the table, and the names are
// looked for as if they had been typed.
//
//   CheckedMeaning({Intent::kGuide, {{Kind::kPlace, "the libary"}}}, table, english)
//   // kUnderstood: guide, place = library
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_TOLD_MEANING_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_TOLD_MEANING_H_

#include <optional>
#include <string>
#include <vector>

#include "robot_app/knowledge/understanding/understanding.h"

namespace coppice::robot::knowledge {

struct NamedSlot {
  Kind kind = Kind::kPlace;
  std::string words;  ///< as they were said
};

struct ToldMeaning {
  std::optional<Intent> intent;  ///< none: nothing that can be answered
  std::vector<NamedSlot> slots;
};

/// What it means here. Nothing if it does not fit: a slot that the intent does not take, or a name
/// that nobody has. A name that fits two is ambiguous, a needed one that was not told is missing.
std::optional<Understanding> CheckedMeaning(const ToldMeaning& told, const IntentTable& table,
                                            const Understander& understander);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_TOLD_MEANING_H_
