#include "robot_app/speech/ear/complete_request.h"

#include <algorithm>

#include "robot_app/knowledge/understanding/utterance.h"

namespace coppice::robot::speech {
namespace {

using knowledge::Kind;
using knowledge::Slot;

std::string Joined(const Sentence& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

// All but the whole.
void AddBeginnings(Sentence words, std::unordered_set<std::string>& beginnings) {
  while (words.size() > 1) {
    words.pop_back();
    beginnings.insert(Joined(words));
  }
}

// The kinds of the slots of "is there anything {diet} {day}", in their order.
std::vector<Kind> KindsOf(const std::string& example) {
  std::vector<Kind> kinds;
  for (std::size_t open = example.find('{'); open != std::string::npos;
       open = example.find('{', open + 1)) {
    const std::size_t close = example.find('}', open);
    if (const auto kind = knowledge::KindOf(example.substr(open + 1, close - open - 1))) {
      kinds.push_back(*kind);
    }
  }
  return kinds;
}

// Whether a sentence begins with these words and goes on.
bool BeginsWith(const Sentence& words, const Sentence& beginning) {
  return beginning.size() < words.size() &&
         std::equal(beginning.begin(), beginning.end(), words.begin());
}

}  // namespace

CompleteRequest::CompleteRequest(const SpokenLanguage& spoken)
    : table_(spoken.intents),
      fillers_(spoken.words.fillers),
      language_(spoken.language),
      understander_(spoken.intents, spoken.words, spoken.names, spoken.language) {
  const auto add_openings = [this](const std::vector<std::string>& texts) {
    const std::vector<Sentence> openings = AsSentences(texts);
    openings_.insert(openings.begin(), openings.end());
  };
  add_openings(spoken.words.greetings);
  for (const knowledge::IntentRow& row : table_) {
    for (const knowledge::Example& example : In(language_, row.examples)) {
      add_openings(example.openings);
    }
  }
  ForEachSentence(spoken, [this](const Sentence& sentence, double) {
    AddBeginnings(WithoutOpenings(sentence), sentences_);
    ends_.insert(EndOf(sentence));
  });
  for (const knowledge::Name& name : spoken.names) {
    if (name.language != language_) continue;
    Sentence words = knowledge::SplitWords(name.text);
    if (!words.empty() && words.front() == "the") words.erase(words.begin());
    names_.insert(Joined(words));
    AddBeginnings(words, names_that_go_on_);
  }
}

// The last word; of "on" and the like the one before, too: "eat on" is no end, "floor is it on" is.
std::string CompleteRequest::EndOf(const Sentence& words) const {
  const bool is_filler = !words.empty() && fillers_.count(words.back()) > 0;
  const std::size_t count = std::min<std::size_t>(is_filler ? 2 : 1, words.size());
  return Joined({words.end() - static_cast<std::ptrdiff_t>(count), words.end()});
}

bool CompleteRequest::IsSaid(const std::vector<knowledge::Alternative>& alternatives,
                             double least_sure) const {
  const auto meanings = knowledge::LikelyMeanings(understander_, alternatives);
  if (meanings.empty() || meanings.front().sure < least_sure) return false;
  const auto& [meant, text, share, sure] = meanings.front();
  return meant.verdict == knowledge::Verdict::kUnderstood && meant.unknown.empty() &&
         knowledge::CanBeAsked(meant.request.intent) && !TakesMore(meant.request) &&
         !GoesOn(knowledge::SplitWords(text));
}

// The longest one first: "please tell me", not "please".
Sentence CompleteRequest::WithoutOpenings(Sentence words) const {
  for (bool is_opened = true; is_opened;) {
    std::size_t longest = 0;
    for (const Sentence& opening : openings_) {
      if (BeginsWith(words, opening)) longest = std::max(longest, opening.size());
    }
    words.erase(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(longest));
    is_opened = longest > 0;
  }
  return words;
}

// "The lecture hall" may be followed by "A"; nothing follows "the dining hall", although there are
// halls with letters.
bool CompleteRequest::GoesOn(const Sentence& words) const {
  if (ends_.count(EndOf(words)) == 0) return true;
  if (sentences_.count(Joined(WithoutOpenings(words))) > 0) return true;
  for (auto begin = words.begin(); begin != words.end(); ++begin) {
    const std::string end = Joined({begin, words.end()});
    if (names_that_go_on_.count(end) > 0) return true;
    if (names_.count(end) > 0) return false;
  }
  return false;
}

// Whether an example has another slot behind those that are filled.
bool CompleteRequest::TakesMore(const knowledge::Request& request) const {
  for (const knowledge::IntentRow& row : table_) {
    if (row.intent != request.intent) continue;
    for (const knowledge::Example& example : In(language_, row.examples)) {
      const std::vector<Kind> kinds = KindsOf(example.text);
      const bool has_all = std::all_of(
          request.slots.begin(), request.slots.end(),
          [&](const Slot& slot) { return std::count(kinds.begin(), kinds.end(), slot.kind) > 0; });
      if (has_all && !kinds.empty() && request.Find(kinds.back()) == nullptr) return true;
    }
  }
  return false;
}

}  // namespace coppice::robot::speech
