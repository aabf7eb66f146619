// The sentences that the robot says, as data: answers.en.yaml and answers.de.yaml. "{place}" stands
// for what is filled in.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_ANSWER_TEXTS_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_ANSWER_TEXTS_H_

#include <map>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/knowledge/store/language.h"
#include "robot_app/knowledge/store/site_time.h"

namespace coppice::robot::knowledge {

class AnswerTexts {
 public:
  using Values = std::map<std::string, std::string>;

  /// Reads a folder's file of that language. Keys that are missing, unknown or use a value that
  /// nobody fills in are errors.
  static AnswerTexts Load(const std::string& folder, Language language, Diagnostics& diagnostics);

  /// The sentence of the key with the values filled in, beginning with a capital. An unknown key
  /// throws std::out_of_range, as below.
  std::string Fill(const std::string& key, const Values& values = {}) const;
  /// Likewise, as a part of a sentence.
  std::string Part(const std::string& key, const Values& values) const;
  /// As it is in the file.
  const std::string& Word(const std::string& key) const { return texts_.at(key); }

  /// "a, b and c".
  std::string List(const std::vector<std::string>& items) const;
  /// "ground floor", "first floor", ...
  std::string Floor(int floor) const;
  /// "today", "tomorrow", "the day after tomorrow" or "on Friday"; farther away "on Friday, 25
  /// December".
  std::string DayName(Day day, Day today) const;
  /// "Friday, 25 December".
  std::string Date(Day day) const;

 private:
  std::map<std::string, std::string> texts_;
};

/// With a capital at its beginning (ASCII and Latin letters with accents).
std::string Capitalized(std::string text);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_ANSWER_TEXTS_H_
