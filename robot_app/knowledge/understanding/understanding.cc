#include "robot_app/knowledge/understanding/understanding.h"

#include <algorithm>

namespace coppice::robot::knowledge {
namespace {

constexpr double kLeastSimilarCue = 0.74;
constexpr std::size_t kMostBetween = 2;        // words within a phrase that are not of it
constexpr double kUsual = 1.3;                 // of a phrase that says what is wanted
constexpr double kFurther = 0.25;              // of its weight, for a phrase beside another one
constexpr double kNeeded = 1.6, kTaken = 1.2;  // of a slot that is filled
constexpr double kUnexplained = 0.55;          // against a row, a word
constexpr double kMissing = 0.8;               // likewise, a slot
constexpr double kLeastScore = 0.9;
constexpr double kClearer = 0.2;  // a name of another kind that leaves less unexplained
constexpr double kLeastTopic = 0.78;
constexpr std::size_t kMostChoices = 3;

// The words of a phrase from `start` on; none if it is not there.
WordSet MatchAt(const Phrase& phrase, const Utterance& utterance, std::size_t start) {
  WordSet found;
  std::size_t at = start;
  for (const SoundingWord& word : phrase.words) {
    const std::size_t last = found.none() ? at : at + kMostBetween;
    bool is_there = false;
    for (std::size_t i = at; i <= last && i < utterance.words.size() && !is_there; ++i) {
      const double least = utterance.exact[i] ? 1 : kLeastSimilarCue;
      if (Similarity(utterance.words[i], word) < least) continue;
      is_there = true;
      found.set(i);
      at = i + 1;
    }
    if (!is_there) return {};
  }
  return found;
}

WordSet MatchOf(const Phrase& phrase, const Utterance& utterance) {
  for (std::size_t start = 0; start < utterance.words.size(); ++start) {
    const WordSet found = MatchAt(phrase, utterance, start);
    if (found.any()) return found;
  }
  return {};
}

bool IsIn(const std::vector<Kind>& kinds, Kind kind) {
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

std::string TextOf(const WordSet& words, const Utterance& utterance) {
  std::string text;
  for (std::size_t i = 0; i < utterance.words.size(); ++i) {
    if (words[i]) text += (text.empty() ? "" : " ") + utterance.words[i].text;
  }
  return text;
}

}  // namespace

const Slot* Request::Find(Kind kind) const {
  for (const Slot& slot : slots) {
    if (slot.kind == kind) return &slot;
  }
  return nullptr;
}

Understander::Understander(const IntentTable& table, const LanguageWords& words,
                           const std::vector<Name>& names, Language language)
    : table_(table), words_(words), language_(language), index_(names, words, language) {
  for (const IntentRow& row : table) {
    for (const Phrase& phrase : In(language, row.phrases)) {
      for (const SoundingWord& word : phrase.words) vocabulary_.insert(word.text);
    }
  }
}

Utterance Understander::Hear(std::string_view text) const {
  Utterance utterance = TakeApart(text, words_);
  for (std::size_t i = 0; i < utterance.words.size(); ++i) {
    if (vocabulary_.count(utterance.words[i].text) > 0) utterance.exact.set(i);
  }
  return utterance;
}

// Phrases of the greatest weight first; one that adds no word counts nothing.
double Understander::FindCues(const IntentRow& row, const Utterance& utterance,
                              WordSet& cues) const {
  double sum = 0;
  for (const Phrase& phrase : In(language_, row.phrases)) {
    const WordSet found = MatchOf(phrase, utterance);
    if ((found & ~cues).none()) continue;
    sum += cues.any() ? kFurther * phrase.weight : phrase.weight;
    cues |= found;
  }
  return sum;
}

// Where a row takes a stop and a place, one is where somebody goes and the other where it begins.
bool Understander::Suits(const IntentRow& row, const Utterance& utterance,
                         const Candidate& candidate) const {
  if (!row.Takes(candidate.kind)) return false;
  if (candidate.kind == Kind::kTopic) return candidate.fit >= kLeastTopic;
  if (!row.Takes(Kind::kStop) || !row.Takes(Kind::kPlace)) return true;
  if (candidate.kind != Kind::kStop && candidate.kind != Kind::kPlace) return true;
  std::size_t first = 0;
  while (!candidate.words[first]) ++first;
  bool is_origin = false;
  for (std::size_t i = first; i > 0 && i + 3 > first; --i) {
    const std::string& word = utterance.words[i - 1].text;
    if (words_.from.count(word) > 0) is_origin = true;
    if (utterance.content[i - 1]) break;
  }
  return is_origin == (candidate.kind == Kind::kPlace);
}

Understander::Reading Understander::Read(const IntentRow& row, const Utterance& utterance,
                                         const std::vector<Candidate>& candidates,
                                         std::optional<Kind> needed) const {
  Reading reading;
  reading.row = &row;
  const double cues = FindCues(row, utterance, reading.cues);
  reading.explained = reading.cues;
  reading.score = cues;
  const auto take = [&reading](const Candidate& candidate, double weight) {
    reading.slots.push_back(&candidate);
    reading.explained |= candidate.words;
    reading.score += weight * candidate.fit;
  };
  WordSet taken;
  for (const Candidate& candidate : candidates) {
    if (!IsIn(row.needs, candidate.kind) || !Suits(row, utterance, candidate)) continue;
    if (reading.slots.empty()) {
      if (needed && candidate.kind != *needed) continue;
      take(candidate, kNeeded);
      taken = candidate.words;
      reading.needed = taken;
    }
    const Candidate& best = *reading.slots.front();
    if (candidate.value >= kAsGoodName * best.value && (candidate.words & best.words).any()) {
      reading.rivals.push_back(&candidate);
    }
  }
  for (const Kind kind : row.takes) {
    const auto found =
        std::find_if(candidates.begin(), candidates.end(), [&](const Candidate& candidate) {
          return candidate.kind == kind && candidate.fit >= kSureName &&
                 (candidate.words & taken).none() && Suits(row, utterance, candidate);
        });
    if (found == candidates.end()) continue;
    take(*found, kTaken);
    taken |= found->words;
  }
  reading.is_missing = !row.needs.empty() && reading.rivals.empty();
  if (reading.is_missing) reading.score -= kMissing;
  const std::size_t unexplained = (utterance.content & ~reading.explained).count();
  reading.score -= kUnexplained * static_cast<double>(unexplained);
  const bool is_meant = cues >= kUsual || (row.is_bare && !reading.slots.empty()) ||
                        (cues > 0 && row.needs.empty() && !reading.slots.empty());
  if (!is_meant) reading.score = 0;
  return reading;
}

// Whether a word that nobody knows belongs to what is asked for: a number, the word before it as in
// "post office", or one behind it as in "office of the president".
bool Understander::IsOfName(const WordSet& left, const WordSet& name,
                            const Utterance& utterance) const {
  for (std::size_t i = 0; i < utterance.words.size(); ++i) {
    if (!left[i]) continue;
    const char first = utterance.words[i].text.front();
    if (first >= '0' && first <= '9') return true;
    if (i + 1 < utterance.words.size() && name[i + 1]) return true;
    bool has_of = false;
    for (std::size_t before = i; before > 0 && !utterance.content[before - 1]; --before) {
      has_of |= words_.of.count(utterance.words[before - 1].text) > 0;
      if (has_of && before > 1 && name[before - 2]) return true;
    }
  }
  return false;
}

Understanding Understander::Judge(const Reading& reading, const Utterance& utterance) const {
  Understanding result;
  const WordSet left = utterance.content & ~reading.explained;
  const std::size_t explained = (utterance.content & reading.explained).count();
  result.unknown = TextOf(left, utterance);
  if (reading.score < kLeastScore || left.count() > explained ||
      (reading.slots.empty() && left.any()) || IsOfName(left, reading.needed, utterance)) {
    return result;
  }
  result.request.intent = reading.row->intent;
  for (const Candidate* const slot : reading.slots) {
    if (!IsIn(reading.row->needs, slot->kind)) {
      result.request.slots.push_back({slot->kind, slot->subject});
    }
  }
  result.verdict = reading.is_missing ? Verdict::kMissing : Verdict::kUnderstood;
  if (reading.rivals.empty()) return result;
  const Candidate& best = *reading.rivals.front();
  if (best.fit < kSureName && left.any()) return {Verdict::kUnknown, {}, {}, result.unknown};
  if (reading.rivals.size() == 1 && best.fit >= kSureName) {
    result.request.slots.insert(result.request.slots.begin(), {best.kind, best.subject});
    return result;
  }
  result.verdict = Verdict::kAmbiguous;
  for (const Candidate* const rival : reading.rivals) {
    if (result.choices.size() < kMostChoices)
      result.choices.push_back({rival->kind, rival->subject});
  }
  return result;
}

Understanding Understander::Understand(std::string_view text) const {
  const Utterance utterance = Hear(text);
  const std::vector<Candidate> candidates = index_.Find(utterance);
  Reading best;
  for (const IntentRow& row : table_) {
    Reading reading = Read(row, utterance, candidates);
    if (reading.score > best.score) best = std::move(reading);
    if (row.needs.size() < 2) continue;
    for (const Kind needed : row.needs) {  // "the office of Weber" is the person's
      Reading other = Read(row, utterance, candidates, needed);
      if (other.score > best.score + kClearer) best = std::move(other);
    }
  }
  if (best.row) return Judge(best, utterance);
  Understanding unknown;
  unknown.unknown = TextOf(utterance.content, utterance);
  return unknown;
}

std::vector<Candidate> Understander::FindNames(std::string_view text,
                                               const std::vector<Kind>& kinds) const {
  std::vector<Candidate> found;
  for (Candidate& candidate : index_.Find(Hear(text))) {
    if (IsIn(kinds, candidate.kind)) found.push_back(std::move(candidate));
  }
  return found;
}

}  // namespace coppice::robot::knowledge
