// A conversation with one person: what was asked back is remembered until the answer, and the last
// answer; nothing else is.
//
//   auto dialogue = Dialogue::Open("campus.db", folder_of_language_files, diagnostics);
//   dialogue->Hear("where is the office of Weber", now).text   // Did you mean ... or ...?
//   dialogue->Hear("Anna", now).text                           // Anna Weber is in office 101 ...
//
// What was heard uncertainly is acted on only if it is sure enough what was meant; else the robot
// asks back, or says that it has not understood.
//
// What cannot be answered is noted for the operator (store/notes.h). When an import or the operator
// has changed the database, the next question is understood with the new names. For one thread.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_DIALOGUE_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_DIALOGUE_H_

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/knowledge/answers/answer.h"
#include "robot_app/knowledge/answers/open_question.h"
#include "robot_app/knowledge/answers/touch_menu.h"
#include "robot_app/knowledge/understanding/told_meaning.h"

namespace coppice::robot::knowledge {

/// The files of one folder: intents.yaml and for each language words and answers.
struct LanguageFiles {
  IntentTable intents;
  ByLanguage<LanguageWords> words;
  ByLanguage<AnswerTexts> texts;

  static LanguageFiles Load(const std::string& folder, Diagnostics& diagnostics);
};

/// An answer to what was heard uncertainly.
struct HeardAnswer {
  Answer answer;
  std::string text;  ///< that is answered; empty: it was not understood
  double share = 0;  ///< the chance that it was meant, 0..1
};

class Dialogue {
 public:
  /// Null, with the reasons, if the database or a file cannot be read.
  static std::unique_ptr<Dialogue> Open(const std::string& database, const std::string& folder,
                                        Diagnostics& diagnostics);
  static std::unique_ptr<Dialogue> Make(Database database, const std::string& folder,
                                        Diagnostics& diagnostics);

  /// Answers what somebody has said or typed. A damaged database is an answer, too: not now.
  Answer Hear(std::string_view text, WallTime now);
  /// Answers one of the texts that somebody may have said. `told`: what a service says was meant by
  /// the likeliest one; if it fits, it goes before the own understanding.
  HeardAnswer Hear(const std::vector<Alternative>& alternatives, WallTime now,
                   const std::optional<ToldMeaning>& told = std::nullopt);
  /// Answers what was pressed. An open question is forgotten, unless yes or no answers it.
  Answer Press(const Request& request, WallTime now);
  /// The buttons behind a path of touch_menu.h.
  TouchScreen Screen(const std::vector<std::string>& path);
  /// Another person: nothing of the conversation is left. The language stays.
  void Forget();

  Language language() const { return language_; }
  void set_language(Language language) { language_ = language; }
  /// A share below which it asks back (likely_meanings.h).
  void set_least_sure(double share) { least_sure_ = share; }
  /// While a question is open: the names of its choices, for who listens for the answer. Nothing if
  /// none is, or if anything may be answered.
  std::vector<std::string> ExpectedNames(WallTime now);
  /// To make out what is heard next took so long: an open question waits as much longer for it.
  void Wait(std::chrono::nanoseconds longer) {
    if (question_) question_->Wait(longer);
  }
  /// Whoever else has answered: no question is open any more.
  void CloseQuestion() { question_.reset(); }
  /// From where the robot is; without it as the crow flies from its home.
  void set_way(WayFromHere way) { way_ = std::move(way); }

 private:
  Dialogue(Database database, LanguageFiles files);
  void Refresh();
  const Understander& understander() const { return *In(language_, understanders_); }
  const AnswerTexts& texts() const { return In(language_, files_.texts); }
  Day Today(WallTime now) const;

  std::optional<HeardAnswer> AnswerQuestion(const std::vector<Alternative>& alternatives,
                                            WallTime now);
  HeardAnswer AnswerNew(const std::vector<Meaning>& meanings, WallTime now);
  std::vector<Meaning> MeaningsOf(const std::vector<Alternative>& alternatives,
                                  const std::optional<ToldMeaning>& told) const;
  Answer AnswerUnderstanding(const Understanding& heard, std::string_view text, WallTime now);
  Answer Do(const Request& request, WallTime now);
  Answer Refuse(const Understanding& heard, std::string_view text, WallTime now);
  Answer AskWhichName(const Understanding& heard, WallTime now);
  Answer AskWhichRequest(const std::vector<Request>& requests, WallTime now);
  std::vector<Choice> ChoicesByName(const std::vector<Request>& requests) const;
  Answer NotHeard() const;
  Answer Ask(const std::string& key, std::vector<Choice> choices, WallTime now);
  Answer AnswerMissing(const Understanding& heard, WallTime now);
  Answer Remembered(Answer answer);

  Database database_;
  LanguageFiles files_;
  ByLanguage<std::unique_ptr<Understander>> understanders_;
  std::optional<std::int64_t> version_;  // of the names in the understanders
  Language language_ = Language::kEnglish;
  WayFromHere way_;
  double least_sure_ = kSureEnough;
  std::optional<OpenQuestion> question_;
  std::optional<Answer> last_;
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_ANSWERS_DIALOGUE_H_
