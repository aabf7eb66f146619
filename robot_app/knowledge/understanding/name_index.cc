#include "robot_app/knowledge/understanding/name_index.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace coppice::robot::knowledge {
namespace {

constexpr double kLeastSimilar = 0.66;  // of two words
constexpr double kForeign = 0.97;       // a name of another language fits a little less
constexpr double kFillerWeight = 0.1;
// How much of an utterance its words explain.
double Explained(const WordSet& words, const WordSet& content) {
  return 0.5 + static_cast<double>((words & content).count()) +
         0.3 * static_cast<double>((words & ~content).count());
}

constexpr std::size_t kMostBetween = 1;  // words within a name that are not of it

}  // namespace

NameIndex::NameIndex(const std::vector<Name>& names, const LanguageWords& language,
                     Language spoken) {
  for (const Name& name : names) {
    const bool is_foreign = name.language != spoken;
    if (name.kind == Kind::kTopic && is_foreign) continue;
    if (name.kind != Kind::kLine) {
      Add(name, name.text, language, is_foreign);
      continue;
    }
    if (is_foreign) continue;
    for (std::string pattern : language.line_patterns) {
      Add(name, pattern.replace(pattern.find("{}"), 2, name.text), language, false);
    }
  }
  for (const Name& name : language.days) Add(name, name.text, language, false);
  Weigh(language);
}

int NameIndex::WordId(const std::string& text) {
  const auto found = std::find_if(words_.begin(), words_.end(),
                                  [&text](const Word& word) { return word.word.text == text; });
  if (found != words_.end()) return static_cast<int>(found - words_.begin());
  words_.push_back({Sounding(text), 1});
  return static_cast<int>(words_.size()) - 1;
}

void NameIndex::Add(const Name& name, const std::string& text, const LanguageWords& language,
                    bool is_foreign) {
  const std::vector<std::string> words = SplitWords(text, language);
  if (words.empty() || words.size() > kMostWords) return;
  const auto subject =
      std::find(subjects_.begin(), subjects_.end(), std::pair(name.kind, name.subject));
  Entry entry{name.kind, static_cast<int>(subject - subjects_.begin()), is_foreign, {}};
  if (subject == subjects_.end()) subjects_.emplace_back(name.kind, name.subject);
  // Articles are no part of a name, unless it has nothing else; but of what people say.
  for (const std::string& word : words) {
    const bool is_filler = language.fillers.count(word) > 0 && word.size() > 1;
    if (!is_filler || name.kind == Kind::kTopic || name.kind == Kind::kLine) {
      entry.words.push_back(WordId(word));
    }
  }
  if (entry.words.empty()) {
    for (const std::string& word : words) entry.words.push_back(WordId(word));
  }
  entries_.push_back(entry);
  if (entry.words.size() != 2) return;
  // Also in one word.
  entry.words = {WordId(words_[static_cast<std::size_t>(entry.words[0])].word.text +
                        words_[static_cast<std::size_t>(entry.words[1])].word.text)};
  entries_.push_back(entry);
}

void NameIndex::Weigh(const LanguageWords& language) {
  std::vector<std::set<int>> subjects(words_.size());
  for (const Entry& entry : entries_) {
    for (const int word : entry.words)
      subjects[static_cast<std::size_t>(word)].insert(entry.subject);
  }
  for (std::size_t i = 0; i < words_.size(); ++i) {
    Word& word = words_[i];
    word.weight = 1 / (1 + std::log(static_cast<double>(subjects[i].size())));
    word.is_filler = word.word.text.size() > 1 && language.fillers.count(word.word.text) > 0;
  }
}

// What people say by the way consists of fillers.
double NameIndex::WeightOf(const Entry& entry, std::size_t word) const {
  const bool is_filler = words_[word].is_filler && entry.kind != Kind::kTopic;
  return words_[word].weight * (is_filler ? kFillerWeight : 1);
}

NameIndex::Table NameIndex::SimilarityOf(const std::vector<SoundingWord>& words,
                                         const WordSet& exact) const {
  Table table;
  for (std::size_t i = 0; i < words.size(); ++i) {
    std::vector<double>& row = table.emplace_back();
    for (const Word& known : words_) {
      const double similarity = Similarity(words[i], known.word);
      row.push_back(similarity < (exact[i] ? 1 : kLeastSimilar) ? 0 : similarity);
    }
  }
  return table;
}

// From each word of the utterance on: the words of the name one after the other, each at the best
// place among the next ones, fillers not counted; one that fits nowhere is left out.
NameIndex::Match NameIndex::BestMatch(const Entry& entry, const WordSet& content,
                                      const Table& single, const Table& joined) const {
  const std::size_t count = single.size();
  double whole = 0;
  for (const int word : entry.words) whole += WeightOf(entry, static_cast<std::size_t>(word));
  Match best;
  for (std::size_t start = 0; start < count; ++start) {
    Match match;
    std::size_t at = start;
    for (const int id : entry.words) {
      const auto word = static_cast<std::size_t>(id);
      double similarity = 0;
      WordSet used;
      std::size_t next = at;
      std::size_t last = at;
      if (match.words.any()) {
        while (last + 1 < count && !content[last]) ++last;
        last += kMostBetween;
      }
      for (std::size_t i = at; i <= last && i < count; ++i) {
        if (single[i][word] > similarity) {
          similarity = single[i][word];
          used = WordSet().set(i);
          next = i + 1;
        }
        if (i + 1 < count && joined[i][word] > similarity) {
          similarity = joined[i][word];
          used = WordSet().set(i).set(i + 1);
          next = i + 2;
        }
      }
      match.fit += similarity * WeightOf(entry, word) / whole;
      match.words |= used;
      at = next;
    }
    if (match.fit > best.fit + 1e-9) best = match;
  }
  return best;
}

std::vector<Candidate> NameIndex::Find(const Utterance& utterance) const {
  const Table single = SimilarityOf(utterance.words, utterance.exact),
              joined =
                  SimilarityOf(utterance.joined, ~utterance.content | (~utterance.content >> 1));
  std::map<int, Candidate> best;
  for (const Entry& entry : entries_) {
    Match match = BestMatch(entry, utterance.content, single, joined);
    if (entry.is_foreign) match.fit *= kForeign;
    if (match.fit < kLeastFit) continue;
    const double value = match.fit * match.fit * Explained(match.words, utterance.content);
    Candidate& candidate = best[entry.subject];
    if (value <= candidate.value) continue;
    const auto& [kind, subject] = subjects_[static_cast<std::size_t>(entry.subject)];
    candidate = {kind, subject, match.fit, value, match.words};
  }
  std::vector<Candidate> candidates;
  for (const auto& [subject, candidate] : best) candidates.push_back(candidate);
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.value > b.value; });
  return candidates;
}

}  // namespace coppice::robot::knowledge
