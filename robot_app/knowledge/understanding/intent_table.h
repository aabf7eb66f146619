// The one table of what people can want of the robot: intents.yaml. Speech and touch lead to the
// same rows, so whatever can be said can be pressed.
//
//   openings:
//     en: {ask: [can you tell me, do you know]}
//   intents:
//   - intent: departures
//     takes: [line, stop]                    # slots that may be filled
//     bare: false                            # a slot alone does not mean it
//     touch: [departures, "{line}"]          # the buttons that lead here; {slot} is a choice
//     says:
//       en:
//         strong: [next bus, departures]
//         weak: [bus]
//         examples: ["when does {line} leave", "(ask) when {line} leaves", "{day}'s departures"]
//       de: ...
//
// Of the slots in `needs: [place, person]` one must be filled. A strong phrase alone
// says what is wanted, one of the `usual` ones too unless something else is said, a weak one only
// beside a slot. Examples are for people, for the grammar of the speech recognizer and for the test
// that understands each of them; in front of one that begins with "(ask)" each of these openings
// may stand, or none.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_INTENT_TABLE_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_INTENT_TABLE_H_

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/knowledge/store/language.h"
#include "robot_app/knowledge/understanding/utterance.h"

namespace coppice::robot::knowledge {

enum class Intent : std::uint8_t {
  kFindPlace,
  kNearestPlace,
  kListPlaces,
  kFindPerson,
  kContact,
  kOccupants,
  kGuide,
  kMenu,
  kDepartures,
  kOpeningHours,
  kSmallTalk,
  kHelp,
  kRepeat,
  kCancel,
  kYes,
  kNo,
  kSpeakEnglish,
  kSpeakGerman,
};
inline constexpr std::size_t kIntents = 18;

/// "find_place" ..., as in files, and back.
const char* Word(Intent intent);
std::optional<Intent> IntentOf(std::string_view word);

/// Words that follow each other, with at most one other between two.
struct Phrase {
  std::vector<SoundingWord> words;
  double weight = 1;
};

/// What somebody may say: "take me to {place}".
struct Example {
  std::vector<std::string> openings;  ///< that may stand in front: "could you"
  std::string text;
};

struct IntentRow {
  Intent intent = Intent::kFindPlace;
  std::vector<Kind> needs;         ///< one of them must be there; empty: none
  std::vector<Kind> takes;         ///< may be there
  bool is_bare = false;            ///< a slot alone means this
  std::vector<std::string> touch;  ///< never empty
  ByLanguage<std::vector<Phrase>> phrases;
  ByLanguage<std::vector<Example>> examples;  ///< never empty

  bool Takes(Kind kind) const;
};

/// A row for each intent, in the order of the file: of equals the first one wins.
using IntentTable = std::vector<IntentRow>;

/// All that is wrong is reported: intents that are missing, unknown or have no example or touch
/// path.
IntentTable LoadIntentTable(const std::string& path, Diagnostics& diagnostics);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_INTENT_TABLE_H_
