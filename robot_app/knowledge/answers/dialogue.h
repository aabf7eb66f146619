// A conversation with one person: what was asked back is remembered until the answer, and the last
// answer; nothing else is.
//
//   auto dialogue = Dialogue::Open("campus.db", folder_of_language_files, diagnostics);
//   dialogue->Hear("where is the office of Weber", now).text   // Did you mean ... or ...?
//   dialogue->Hear("Anna", now).text                           // Anna Weber is in office 101 ...
//
// What cannot be answered is noted for the operator (store/notes.h). When an import or the operator
// has changed the database, the next question is understood with the new names. For one thread.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_DIALOGUE_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_DIALOGUE_H_

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/knowledge/answers/answer.h"
#include "robot_app/knowledge/answers/touch_menu.h"

namespace coppice::robot::knowledge {

/// The files of one folder: intents.yaml and for each language words and answers.
struct LanguageFiles {
  IntentTable intents;
  ByLanguage<LanguageWords> words;
  ByLanguage<AnswerTexts> texts;

  static LanguageFiles Load(const std::string& folder, Diagnostics& diagnostics);
};

class Dialogue {
 public:
  /// Null, with the reasons, if the database or a file cannot be read.
  static std::unique_ptr<Dialogue> Open(const std::string& database, const std::string& folder,
                                        Diagnostics& diagnostics);

  /// Answers what somebody has said or typed. A damaged database is an answer, too: not now.
  Answer Hear(std::string_view text, WallTime now);
  /// Answers what was pressed. An open question is forgotten.
  Answer Press(const Request& request, WallTime now);
  /// The buttons behind a path of touch_menu.h.
  TouchScreen Screen(const std::vector<std::string>& path);
  /// Another person: nothing of the conversation is left. The language stays.
  void Forget();

  Language language() const { return language_; }
  void set_language(Language language) { language_ = language; }
  /// From where the robot is; without it as the crow flies from its home.
  void set_way(WayFromHere way) { way_ = std::move(way); }

 private:
  /// What the robot has asked back.
  struct Question {
    Request request;            // without the slot in question
    std::vector<Slot> choices;  // empty: any of the kinds
    std::vector<Kind> kinds;
  };

  Dialogue(Database database, LanguageFiles files);
  void Refresh();
  const Understander& understander() const { return *In(language_, understanders_); }
  const AnswerTexts& texts() const { return In(language_, files_.texts); }
  Day Today(WallTime now) const;

  std::optional<Answer> AnswerQuestion(std::string_view text, WallTime now);
  std::optional<Slot> Chosen(std::string_view text) const;
  Answer AnswerUnderstanding(const Understanding& heard, std::string_view text, WallTime now);
  Answer Do(const Request& request, WallTime now);
  Answer Refuse(const Understanding& heard, std::string_view text, WallTime now);
  Answer AskBack(const Understanding& heard);
  Answer AnswerMissing(const Understanding& heard, WallTime now);
  Answer Remembered(Answer answer);

  Database database_;
  LanguageFiles files_;
  ByLanguage<std::unique_ptr<Understander>> understanders_;
  std::optional<std::int64_t> version_;  // of the names in the understanders
  Language language_ = Language::kEnglish;
  WayFromHere way_;
  std::optional<Question> question_;
  std::optional<Answer> last_;
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_DIALOGUE_H_
