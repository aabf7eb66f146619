#include "robot_app/knowledge/answers/dialogue.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "robot_app/knowledge/answers/request_text.h"
#include "robot_app/knowledge/store/notes.h"

namespace coppice::robot::knowledge {
namespace {

// The kinds that fill what an intent needs.
std::vector<Kind> NeedsOf(const IntentTable& table, Intent intent) {
  for (const IntentRow& row : table) {
    if (row.intent == intent) return row.needs;
  }
  return {};
}

}  // namespace

LanguageFiles LanguageFiles::Load(const std::string& folder, Diagnostics& diagnostics) {
  LanguageFiles files;
  files.intents = LoadIntentTable(folder + "/intents.yaml", diagnostics);
  for (const Language language : kLanguages) {
    In(language, files.words) = LoadLanguageWords(folder, language, diagnostics);
    In(language, files.texts) = AnswerTexts::Load(folder, language, diagnostics);
  }
  return files;
}

std::unique_ptr<Dialogue> Dialogue::Open(const std::string& database, const std::string& folder,
                                         Diagnostics& diagnostics) {
  auto opened = Database::Open(database);
  if (opened) return Make(*std::move(opened), folder, diagnostics);
  diagnostics.Error({database, 0, 0}, opened.problem());
  return nullptr;
}

std::unique_ptr<Dialogue> Dialogue::Make(Database database, const std::string& folder,
                                         Diagnostics& diagnostics) {
  LanguageFiles files = LanguageFiles::Load(folder, diagnostics);
  if (diagnostics.has_errors()) return nullptr;
  return std::unique_ptr<Dialogue>(new Dialogue(std::move(database), std::move(files)));
}

Dialogue::Dialogue(Database database, LanguageFiles files)
    : database_(std::move(database)), files_(std::move(files)) {}

// What it writes itself is no change of names.
void Dialogue::Refresh() {
  const std::int64_t version = database_.version();
  if (version_ == version) return;
  const std::vector<Name> names = Names(database_);
  for (const Language language : kLanguages) {
    In(language, understanders_) =
        std::make_unique<Understander>(files_.intents, In(language, files_.words), names, language);
  }
  version_ = version;
}

Day Dialogue::Today(WallTime now) const {
  const auto time = TimeOf(database_);
  return time ? time->Local(now).day : Day{};
}

void Dialogue::Forget() {
  question_.reset();
  last_.reset();
}

Answer Dialogue::Remembered(Answer answer) {
  last_ = answer;
  return answer;
}

Answer Dialogue::Hear(std::string_view text, WallTime now) {
  return Hear(std::vector<Alternative>{{std::string(text), 1}}, now).answer;
}

std::vector<Meaning> Dialogue::MeaningsOf(const std::vector<Alternative>& alternatives,
                                          const std::optional<ToldMeaning>& told) const {
  if (told && !alternatives.empty()) {
    const auto meant = CheckedMeaning(*told, files_.intents, understander());
    if (meant) return {{*meant, alternatives.front().text, 1, 1}};
  }
  return LikelyMeanings(understander(), alternatives);
}

HeardAnswer Dialogue::Hear(const std::vector<Alternative>& alternatives, WallTime now,
                           const std::optional<ToldMeaning>& told) {
  try {
    Refresh();
    if (question_ && question_->is_open(now)) {
      if (auto heard = AnswerQuestion(alternatives, now)) return *std::move(heard);
    }
    question_.reset();
    return AnswerNew(MeaningsOf(alternatives, told), now);
  } catch (const std::runtime_error&) {
    return {{AnswerMood::kUnknown, texts().Fill("not_now"), {}, false}, "", 0};
  }
}

Answer Dialogue::Press(const Request& request, WallTime now) {
  try {
    const std::optional<OpenQuestion> question = std::exchange(question_, std::nullopt);
    if (request.intent == Intent::kRepeat && last_) return *last_;
    if (question && request.intent == Intent::kNo) {
      return Remembered(Do({Intent::kCancel, {}}, now));
    }
    const bool is_agreed = question && request.intent == Intent::kYes;
    if (is_agreed && question->choices().size() == 1) {
      return Remembered(Do(question->choices().front().request, now));
    }
    return Remembered(Do(request, now));
  } catch (const std::runtime_error&) {
    return {AnswerMood::kUnknown, texts().Fill("not_now"), {}, false};
  }
}

TouchScreen Dialogue::Screen(const std::vector<std::string>& path) {
  try {
    const Snapshot snapshot(database_);
    return TouchMenu(files_.intents, texts(), database_, language_).After(path);
  } catch (const std::runtime_error&) {
    return {};
  }
}

// Nothing if it is no answer, but something new.
std::optional<HeardAnswer> Dialogue::AnswerQuestion(const std::vector<Alternative>& alternatives,
                                                    WallTime now) {
  const auto reply =
      question_->AnsweredBy(alternatives, understander(), In(language_, files_.words));
  if (reply) {
    question_.reset();
    return HeardAnswer{Remembered(Do(reply->request, now)), reply->text, reply->share};
  }
  if (question_->choices().size() < 2 || !last_) return std::nullopt;
  const std::vector<Meaning> meanings = LikelyMeanings(understander(), alternatives);
  const bool is_yes = !meanings.empty() && meanings.front().share >= kSureReply &&
                      meanings.front().understanding.request.intent == Intent::kYes;
  if (!is_yes) return std::nullopt;
  return HeardAnswer{*last_, meanings.front().text, meanings.front().share};  // but which of them?
}

HeardAnswer Dialogue::AnswerNew(const std::vector<Meaning>& meanings, WallTime now) {
  if (meanings.empty()) return {Remembered(NotHeard()), "", 0};
  const Meaning& best = meanings.front();
  if (best.sure < least_sure_) {
    const std::vector<Request> asked = WorthAsking(meanings, least_sure_);
    if (asked.empty()) return {Remembered(NotHeard()), "", best.share};
    return {Remembered(AskWhichRequest(asked, now)), best.text, best.share};
  }
  const Understanding& heard = best.understanding;
  if (heard.request.intent == Intent::kRepeat && heard.verdict == Verdict::kUnderstood && last_) {
    return {*last_, best.text, best.share};
  }
  return {Remembered(AnswerUnderstanding(heard, best.text, now)), best.text, best.share};
}

Answer Dialogue::AnswerUnderstanding(const Understanding& heard, std::string_view text,
                                     WallTime now) {
  switch (heard.verdict) {
    case Verdict::kUnderstood:
      return Do(heard.request, now);
    case Verdict::kAmbiguous:
      return AskWhichName(heard, now);
    case Verdict::kMissing:
      return AnswerMissing(heard, now);
    case Verdict::kUnknown:
      break;
  }
  return Refuse(heard, text, now);
}

Answer Dialogue::Do(const Request& request, WallTime now) {
  if (request.intent == Intent::kSpeakEnglish) language_ = Language::kEnglish;
  if (request.intent == Intent::kSpeakGerman) language_ = Language::kGerman;
  const Snapshot snapshot(database_);
  Answer answer = AnswerTo(database_, texts(), request, {language_, now, way_});
  answer.request = request;
  return answer;
}

Answer Dialogue::Refuse(const Understanding& heard, std::string_view text, WallTime now) {
  NoteUnknown(database_, std::string(text), language_, Today(now));
  const std::string sentence = heard.unknown.empty()
                                   ? texts().Fill("unknown")
                                   : texts().Fill("unknown_words", {{"words", heard.unknown}});
  return {AnswerMood::kUnknown, sentence, {}, false};
}

Answer Dialogue::NotHeard() const {
  return {AnswerMood::kUnknown, texts().Fill("not_heard"), {}, false};
}

std::vector<Choice> Dialogue::ChoicesByName(const std::vector<Request>& requests) const {
  std::vector<Choice> choices;
  for (const Request& request : requests) {
    const Slot& slot = request.slots.front();
    choices.push_back({NameOf(database_, slot.kind, slot.subject, language_), request});
  }
  return choices;
}

// "Did you mean Anna Weber or Paul Weber?"
Answer Dialogue::AskWhichName(const Understanding& heard, WallTime now) {
  return Ask("did_you_mean_", ChoicesByName(RequestsOf(heard)), now);
}

// "Did you ask where the library is, or when the library is open?"
Answer Dialogue::AskWhichRequest(const std::vector<Request>& requests, WallTime now) {
  if (DifferByName(requests)) return Ask("did_you_mean_", ChoicesByName(requests), now);
  std::vector<Choice> choices;
  for (const Request& request : requests) {
    choices.push_back({RequestText(database_, texts(), request, language_, Today(now)), request});
  }
  return Ask("asked_", std::move(choices), now);
}

// A single one is agreed to or not.
Answer Dialogue::Ask(const std::string& key, std::vector<Choice> choices, WallTime now) {
  static constexpr const char* kPlaceholders[] = {"first", "second", "third"};
  AnswerTexts::Values values;
  for (std::size_t i = 0; i < choices.size(); ++i) values[kPlaceholders[i]] = choices[i].label;
  Answer answer{
      AnswerMood::kAsking, texts().Fill(key + std::to_string(choices.size()), values), {}, false};
  question_.emplace(choices, now);
  for (Choice& choice : choices) choice.label = Capitalized(choice.label);
  if (choices.size() == 1) {
    choices.front().label = texts().Word("button_yes");
    choices.push_back({texts().Word("button_no"), {Intent::kCancel, {}}});
  }
  answer.choices = std::move(choices);
  return answer;
}

std::vector<std::string> Dialogue::ExpectedNames(WallTime now) {
  std::vector<std::string> expected;
  if (!question_ || !question_->is_open(now)) return expected;
  const std::vector<Name> names = Names(database_);
  for (const Choice& choice : question_->choices()) {
    for (const Name& name : names) {
      const bool is_named = name.language == language_ && !choice.request.slots.empty() &&
                            choice.request.slots.front() == Slot{name.kind, name.subject};
      if (is_named) expected.push_back(name.text);
    }
  }
  return expected;
}

// "Take me there": the place of which the robot has just spoken.
Answer Dialogue::AnswerMissing(const Understanding& heard, WallTime now) {
  const std::vector<Kind> kinds = NeedsOf(files_.intents, heard.request.intent);
  const bool takes_place = std::find(kinds.begin(), kinds.end(), Kind::kPlace) != kinds.end();
  if (takes_place && last_ && !last_->place.empty()) {
    Request request = heard.request;
    request.slots.push_back({Kind::kPlace, last_->place});
    return Do(request, now);
  }
  question_.emplace(heard.request, kinds, now);
  const char* const key = kinds.front() == Kind::kPerson     ? "which_person"
                          : kinds.front() == Kind::kCategory ? "which_category"
                                                             : "which_place";
  return {AnswerMood::kAsking, texts().Fill(key), {}, false};
}

}  // namespace coppice::robot::knowledge
