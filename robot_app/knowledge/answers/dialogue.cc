#include "robot_app/knowledge/answers/dialogue.h"

#include <algorithm>
#include <stdexcept>

#include "robot_app/knowledge/store/notes.h"

namespace coppice::robot::knowledge {
namespace {

constexpr double kSure = 0.72;  // of a name in an answer to "which one?"

// The kinds that fill what an intent needs.
std::vector<Kind> NeedsOf(const IntentTable& table, Intent intent) {
  for (const IntentRow& row : table) {
    if (row.intent == intent) return row.needs;
  }
  return {};
}

bool IsSame(const Slot& slot, const Candidate& candidate) {
  return slot.kind == candidate.kind && slot.subject == candidate.subject;
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
  LanguageFiles files = LanguageFiles::Load(folder, diagnostics);
  auto opened = Database::Open(database);
  if (!opened) diagnostics.Error({database, 0, 0}, opened.problem());
  if (diagnostics.has_errors()) return nullptr;
  return std::unique_ptr<Dialogue>(new Dialogue(*std::move(opened), std::move(files)));
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
  try {
    Refresh();
    if (question_) {
      if (auto answer = AnswerQuestion(text, now)) return Remembered(*std::move(answer));
    }
    question_.reset();
    const Understanding heard = understander().Understand(text);
    if (heard.request.intent == Intent::kRepeat && heard.verdict == Verdict::kUnderstood && last_) {
      return *last_;
    }
    return Remembered(AnswerUnderstanding(heard, text, now));
  } catch (const std::runtime_error&) {
    return {AnswerMood::kUnknown, texts().Fill("not_now"), {}, false};
  }
}

Answer Dialogue::Press(const Request& request, WallTime now) {
  try {
    question_.reset();
    if (request.intent == Intent::kRepeat && last_) return *last_;
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

// Nothing if the text is no answer to it, but something new.
std::optional<Answer> Dialogue::AnswerQuestion(std::string_view text, WallTime now) {
  const Question question = *question_;
  const Understanding heard = understander().Understand(text);
  const bool is_new = heard.verdict == Verdict::kUnderstood && heard.request.slots.empty();
  if (is_new && (heard.request.intent == Intent::kNo || heard.request.intent == Intent::kCancel)) {
    question_.reset();
    return Do({Intent::kCancel, {}}, now);
  }
  std::optional<Slot> chosen = Chosen(text);
  if (is_new && heard.request.intent == Intent::kYes && question.choices.size() == 1) {
    chosen = question.choices.front();
  }
  if (!chosen) return std::nullopt;
  question_.reset();
  Request request = question.request;
  request.slots.insert(request.slots.begin(), *chosen);
  return Do(request, now);
}

// One of the choices if it fits better than the others, by name or by its number.
std::optional<Slot> Dialogue::Chosen(std::string_view text) const {
  const Question& question = *question_;
  const LanguageWords& words = In(language_, files_.words);
  if (!question.choices.empty()) {
    for (const std::string& word : SplitWords(text)) {
      const auto ordinal = words.ordinals.find(word);
      if (ordinal == words.ordinals.end()) continue;
      if (ordinal->second < question.choices.size()) return question.choices[ordinal->second];
    }
  }
  std::vector<Candidate> found = understander().FindNames(text, question.kinds);
  const auto end = std::remove_if(found.begin(), found.end(), [&](const Candidate& candidate) {
    if (question.choices.empty()) return candidate.fit < kSure;
    return std::none_of(question.choices.begin(), question.choices.end(),
                        [&](const Slot& choice) { return IsSame(choice, candidate); });
  });
  found.erase(end, found.end());
  if (found.empty() || (found.size() > 1 && found[1].value >= 0.93 * found[0].value)) {
    return std::nullopt;
  }
  return Slot{found[0].kind, found[0].subject};
}

Answer Dialogue::AnswerUnderstanding(const Understanding& heard, std::string_view text,
                                     WallTime now) {
  switch (heard.verdict) {
    case Verdict::kUnderstood:
      return Do(heard.request, now);
    case Verdict::kAmbiguous:
      return AskBack(heard);
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

Answer Dialogue::AskBack(const Understanding& heard) {
  static constexpr const char* kPlaceholders[] = {"first", "second", "third"};
  AnswerTexts::Values values;
  std::vector<Kind> kinds;
  for (std::size_t i = 0; i < heard.choices.size(); ++i) {
    const Slot& choice = heard.choices[i];
    values[kPlaceholders[i]] = NameOf(database_, choice.kind, choice.subject, language_);
    kinds.push_back(choice.kind);
  }
  question_ = Question{heard.request, heard.choices, kinds};
  const std::string key = "did_you_mean_" + std::to_string(heard.choices.size());
  return {AnswerMood::kAsking, texts().Fill(key, values), {}, false};
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
  question_ = Question{heard.request, {}, kinds};
  const char* const key = kinds.front() == Kind::kPerson     ? "which_person"
                          : kinds.front() == Kind::kCategory ? "which_category"
                                                             : "which_place";
  return {AnswerMood::kAsking, texts().Fill(key), {}, false};
}

}  // namespace coppice::robot::knowledge
