#include "robot_app/speech/ear/spoken_sentences.h"

#include <algorithm>
#include <map>
#include <set>

#include "robot_app/knowledge/store/folded_text.h"
#include "robot_app/knowledge/understanding/utterance.h"

namespace coppice::robot::speech {
namespace {

using knowledge::IntentRow;
using knowledge::Kind;
using knowledge::Name;

class Writer {
 public:
  Writer(const SpokenLanguage& spoken, const std::function<void(const Sentence&, double)>& add)
      : spoken_(spoken), add_(add) {
    for (const Name& name : spoken.names) AddName(name.kind, name.text, name.language);
    for (const Name& name : spoken.words.days) AddName(name.kind, name.text, name.language);
    AddLines();
  }

  void Write() {
    for (const IntentRow& row : spoken_.intents) {
      for (const std::string& example : In(spoken_.language, row.examples)) WriteExample(example);
      Hand(kExamples);
      for (const auto& phrase : In(spoken_.language, row.phrases)) WritePhrase(row, phrase);
      Hand(kPhrases);
      if (row.is_bare) WriteNames(row, {}, 1);
      Hand(row.intent == knowledge::Intent::kSmallTalk ? kExamples : kBare);
    }
  }

 private:
  static constexpr double kExamples = 0.5, kPhrases = 0.4, kBare = 0.15;

  // Hands on what was collected, with weights that add up to `share`.
  void Hand(double share) {
    double sum = 0;
    for (const auto& [sentence, weight] : collected_) sum += weight;
    for (const auto& [sentence, weight] : collected_) add_(sentence, share * weight / sum);
    collected_.clear();
  }

  void AddName(Kind kind, const std::string& text, knowledge::Language language) {
    if (language != spoken_.language) return;
    Sentence words;
    for (std::string& word : knowledge::SplitWords(text)) {
      if (words.empty() && word == "the") continue;
      words.push_back(std::move(word));
    }
    if (!words.empty()) names_[kind].insert(words);
  }

  // "line {}", "the {}": as people call what is written on a tram.
  void AddLines() {
    const std::set<Sentence> lines = names_[Kind::kLine];
    for (const std::string& pattern : spoken_.words.line_patterns) {
      const std::size_t slot = pattern.find("{}");
      for (const Sentence& line : lines) {
        Sentence words = knowledge::Words(pattern.substr(0, slot));
        words.insert(words.end(), line.begin(), line.end());
        names_[Kind::kLine].insert(words);
      }
    }
  }

  // "take me to" + "restroom", "the restroom" + ...
  void WriteNames(Kind kind, const Sentence& before, const Sentence& after, double weight) {
    const bool may_be_definite =
        kind == Kind::kPlace || kind == Kind::kCategory || kind == Kind::kStop;
    const double each = weight / static_cast<double>(names_[kind].size());
    for (const Sentence& name : names_[kind]) {
      Sentence sentence = before;
      sentence.insert(sentence.end(), name.begin(), name.end());
      sentence.insert(sentence.end(), after.begin(), after.end());
      collected_.emplace_back(sentence, each);
      if (!may_be_definite) continue;
      sentence.insert(sentence.begin() + static_cast<std::ptrdiff_t>(before.size()), "the");
      collected_.emplace_back(std::move(sentence), each);
    }
  }
  void WriteNames(const IntentRow& row, const Sentence& before, double weight) {
    for (const Kind kind : row.needs) WriteNames(kind, before, {}, weight);
    for (const Kind kind : row.takes) WriteNames(kind, before, {}, weight);
  }

  // A phrase that leads somewhere needs a word in between: "take me" + "to" + "the restroom".
  void WritePhrase(const IntentRow& row, const knowledge::Phrase& phrase) {
    Sentence words;
    for (const auto& word : phrase.words) words.push_back(word.text);
    if (row.needs.empty()) collected_.emplace_back(words, phrase.weight);
    const std::string between = WordBeforeNames(row);
    if (between.empty() || words.back() == between) return WriteNames(row, words, phrase.weight);
    words.push_back(between);
    WriteNames(row, words, phrase.weight);
  }

  // The one that most examples of a row have there: "to". Empty if they differ.
  std::string WordBeforeNames(const IntentRow& row) const {
    std::map<std::string, std::size_t> count;
    const auto& examples = In(spoken_.language, row.examples);
    for (const std::string& example : examples) {
      const Sentence words = knowledge::Words(example.substr(0, example.find('{')));
      if (words.empty() || spoken_.words.fillers.count(words.back()) == 0) continue;
      if (2 * ++count[words.back()] > examples.size()) return words.back();
    }
    return {};
  }

  // What stands for a second name is left out.
  void WriteExample(const std::string& example) {
    const std::size_t open = example.find('{');
    const std::size_t close = example.find('}', open);
    const Sentence before = knowledge::SplitWords(example.substr(0, open));
    if (close == std::string::npos) {
      collected_.emplace_back(before, 1);
      return;
    }
    const auto kind = knowledge::KindOf(example.substr(open + 1, close - open - 1));
    const std::string after = example.substr(close + 1);
    if (!kind) return;
    WriteNames(*kind, before, knowledge::SplitWords(after.substr(0, after.find('{'))), 1);
  }

  const SpokenLanguage& spoken_;
  const std::function<void(const Sentence&, double)>& add_;
  std::map<Kind, std::set<Sentence>> names_;
  std::vector<std::pair<Sentence, double>> collected_;
};

}  // namespace

void ForEachSentence(const SpokenLanguage& spoken,
                     const std::function<void(const Sentence&, double)>& add) {
  Writer(spoken, add).Write();
}

}  // namespace coppice::robot::speech
