// What the robot could not answer, for the operator, and the names that he adds for it. Both
// outlive an import.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_STORE_NOTES_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_STORE_NOTES_H_

#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "robot_app/knowledge/store/database.h"
#include "robot_app/knowledge/store/language.h"
#include "robot_app/knowledge/store/site_time.h"

namespace coppice::robot::knowledge {

/// A question without an answer.
struct UnknownRequest {
  std::string text;
  Language language = Language::kEnglish;
  int count = 0;     ///< how often it was asked
  std::string last;  ///< the day: "2026-11-25"
};

/// Nobody's words are kept for ever: of more than this many the longest ago is forgotten.
inline constexpr int kMostUnknown = 1000;

/// Nothing but what was said and the day are written down. Shortens what is longer than a sentence.
/// If it cannot be written, it is lost: who asked is answered all the same.
void NoteUnknown(Database& database, const std::string& text, Language language, Day today);

/// The most frequent ones first.
std::vector<UnknownRequest> UnknownRequests(const Database& database);
/// Forgets them.
Outcome ClearUnknown(Database& database);

/// Adds a name. A problem if there is no such subject.
Outcome AddSynonym(Database& database, const Name& name);
/// A problem if it was not there.
Outcome RemoveSynonym(Database& database, const Name& name);
/// All that were added; `is_main` says nothing.
std::vector<Name> Synonyms(const Database& database);
/// Those whose subject no import knows any more.
std::vector<Name> StraySynonyms(const Database& database);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_STORE_NOTES_H_
