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

// Of what people answer: how much is said in which way.
constexpr std::pair<knowledge::Intent, double> kReplies[] = {{knowledge::Intent::kYes, 0.3},
                                                             {knowledge::Intent::kNo, 0.2},
                                                             {knowledge::Intent::kCancel, 0.05}};
constexpr double kNumbers = 0.2, kNames = 0.25;
constexpr std::size_t kMostChoices = 2;  // "third" sounds like "first"

// What says an intent without names.
std::vector<Sentence> SentencesOf(const IntentRow& row, knowledge::Language language) {
  std::vector<Sentence> sentences;
  for (const auto& phrase : In(language, row.phrases)) {
    Sentence& sentence = sentences.emplace_back();
    for (const auto& word : phrase.words) sentence.push_back(word.text);
  }
  for (const knowledge::Example& example : In(language, row.examples)) {
    sentences.push_back(knowledge::SplitWords(example.text));
  }
  return sentences;
}

// "library", "the library", "the library one".
void AddWithArticle(const Sentence& words, std::vector<Sentence>& sentences) {
  if (words.empty()) return;
  Sentence bare = words;
  if (bare.size() > 1 && bare.front() == "the") bare.erase(bare.begin());
  sentences.push_back(bare);
  bare.insert(bare.begin(), "the");
  sentences.push_back(bare);
  bare.emplace_back("one");
  sentences.push_back(bare);
}

Sentence Joined(Sentence words, const Sentence& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Of so many the one for the i-th sentence: in turn, so that all are used with little written.
// Shifted from round to round, as every other sentence has an article.
std::size_t InTurn(std::size_t i, std::size_t count) { return (i + i / count) % count; }

bool BeginsWithVowel(const Sentence& words) {
  return std::string("aeiou").find(words.front().front()) != std::string::npos;
}

void Spread(const std::vector<Sentence>& sentences, double weight,
            const std::function<void(const Sentence&, double)>& add) {
  for (const Sentence& sentence : sentences) {
    add(sentence, weight / static_cast<double>(sentences.size()));
  }
}

class Writer {
 public:
  Writer(const SpokenLanguage& spoken, const std::function<void(const Sentence&, double)>& add)
      : spoken_(spoken), add_(add) {
    std::map<std::string, std::string> people;  // how the robot calls them
    for (const Name& name : spoken.names) {
      if (name.kind == Kind::kPerson && name.is_main) people[name.subject] = name.text;
    }
    for (const Name& name : spoken.names) AddName(name, people[name.subject]);
    for (const Name& name : spoken.words.days) AddName(name, {});
    AddLines();
    for (const auto& [short_form, words] : spoken.words.contractions) {
      contractions_[words] = short_form;
    }
  }

  void Write() {
    for (const IntentRow& row : spoken_.intents) {
      for (const auto& example : In(spoken_.language, row.examples)) WriteExample(example);
      Hand(kExamples);
      for (const auto& phrase : In(spoken_.language, row.phrases)) WritePhrase(row, phrase);
      Hand(kPhrases);
      if (row.is_bare) WriteNames(row, {}, 1);
      Hand(row.intent == knowledge::Intent::kSmallTalk ? kSmallTalk : kBare);
    }
  }

 private:
  static constexpr double kExamples = 0.7, kPhrases = 0.2, kBare = 0.15, kSmallTalk = 1.2;
  static constexpr double kOpened = 0.6;  // where there are openings
  static constexpr double kContracted = 0.3;
  static constexpr std::size_t kManyNames = 1000;

  struct Frame {
    Sentence before;
    std::string ending;  // of the name: "s"
    Sentence after;
    std::size_t every = 1, first = 0;  // only each of so many names, from this one on
  };

  // Hands on what was collected, with weights that add up to `share`.
  void Hand(double share) {
    double sum = 0;
    for (const auto& [sentence, weight] : collected_) sum += weight;
    for (const auto& [sentence, weight] : collected_) Add(sentence, share * weight / sum);
    collected_.clear();
  }

  // "where is" is as often "wheres".
  void Add(const Sentence& sentence, double weight) {
    Sentence contracted;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
      const auto found = i + 1 < sentence.size()
                             ? contractions_.find(sentence[i] + " " + sentence[i + 1])
                             : contractions_.end();
      contracted.push_back(found == contractions_.end() ? sentence[i] : found->second);
      i += found == contractions_.end() ? 0 : 1;
    }
    if (contracted.size() == sentence.size()) return add_(sentence, weight);
    add_(sentence, (1 - kContracted) * weight);
    add_(contracted, kContracted * weight);
  }

  void AddName(const Name& name, const std::string& person) {
    if (name.language != spoken_.language) return;
    Sentence words;
    for (std::string& word : knowledge::SplitWords(name.text)) {
      if (words.empty() && word == "the") continue;
      words.push_back(std::move(word));
    }
    if (words.empty()) return;
    names_[name.kind].insert(words);
    // "Doctor Weber", "Doctor Anna Weber", but no "Doctor IT support".
    const bool is_called_so = !name.is_main && person.find(name.text) != std::string::npos;
    if (name.kind != Kind::kPerson || !is_called_so) return;
    for (const std::string& title : spoken_.words.titles) {
      names_[name.kind].insert(Joined({title}, words));
    }
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

  // "take me to" + "library", "the library" + ...
  void WriteNames(Kind kind, const Frame& frame, double weight) {
    const std::set<Sentence>& names = names_[kind];
    const std::size_t turns = TurnsFor(names), turn = frames_++ % turns;
    const double each = weight * static_cast<double>(turns) / static_cast<double>(names.size());
    std::size_t i = 0, n = 0;
    for (const Sentence& name : names) {
      const bool is_turn = n++ % turns == turn;
      for (const bool is_definite : {false, true}) {
        if (is_definite && !MayBeDefinite(kind)) continue;
        if (i++ % frame.every != frame.first || !is_turn) continue;
        collected_.emplace_back(SentenceOf(frame, name, is_definite), each);
      }
    }
  }

  static Sentence SentenceOf(const Frame& frame, const Sentence& name, bool is_definite) {
    Sentence sentence = Joined(frame.before, name);
    sentence.back() += frame.ending;
    sentence = Joined(std::move(sentence), frame.after);
    const std::size_t begin = frame.before.size();
    if (begin > 0 && sentence[begin - 1] == "a" && BeginsWithVowel(name)) {
      sentence[begin - 1] = "an";
    }
    if (is_definite) sentence.insert(sentence.begin() + static_cast<std::ptrdiff_t>(begin), "the");
    return sentence;
  }

  // Thousands of people in hundreds of frames would be millions of sentences. Each frame takes
  // some of them then, in turn: a name is heard by the words before it, whichever they are.
  static std::size_t TurnsFor(const std::set<Sentence>& names) {
    return std::max<std::size_t>(1, names.size() / kManyNames);
  }

  // Of categories the sentences say how they are called: "the nearest", "all", "a".
  static bool MayBeDefinite(Kind kind) { return kind == Kind::kPlace || kind == Kind::kStop; }
  void WriteNames(const IntentRow& row, const Sentence& before, double weight) {
    for (const Kind kind : row.needs) WriteNames(kind, {before, {}, {}}, weight);
    for (const Kind kind : row.takes) WriteNames(kind, {before, {}, {}}, weight);
  }

  // A phrase that leads somewhere needs a word in between: "take me" + "to" + "the library".
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
    for (const knowledge::Example& example : examples) {
      const std::string& text = example.text;
      const Sentence words = knowledge::Words(text.substr(0, text.find('{')));
      if (words.empty() || spoken_.words.fillers.count(words.back()) == 0) continue;
      if (2 * ++count[words.back()] > examples.size()) return words.back();
    }
    return {};
  }

  // With and without its openings.
  void WriteExample(const knowledge::Example& example) {
    const std::size_t first = collected_.size();
    WriteText(example.text);
    const std::vector<Sentence> openings = AsSentences(example.openings);
    const std::size_t count = collected_.size() - first;
    if (openings.empty() || count == 0) return;
    double sum = 0;
    for (std::size_t i = first; i < first + count; ++i) {
      sum += collected_[i].second;
      collected_[i].second *= 1 - kOpened;
    }
    const std::size_t most = std::max(count, openings.size());
    for (std::size_t i = 0; i < most; ++i) {
      collected_.emplace_back(
          Joined(openings[InTurn(i, openings.size())], collected_[first + i % count].first),
          kOpened * sum / static_cast<double>(most));
    }
  }

  // Of a second slot, such as the day, every sentence takes another name in turn if two words are
  // between: a trigram knows no more. Else with all of them, but only "the library", not "library".
  void WriteText(const std::string& example) {
    const std::size_t open = example.find('{');
    const std::size_t close = example.find('}', open);
    const Sentence before = knowledge::SplitWords(example.substr(0, open));
    if (close == std::string::npos) {
      collected_.emplace_back(before, 1);
      return;
    }
    const auto kind = knowledge::KindOf(example.substr(open + 1, close - open - 1));
    if (!kind) return;
    std::string after = example.substr(close + 1);
    const bool has_ending = after.rfind("'s", 0) == 0;
    const std::string ending = has_ending ? "s" : "";
    if (has_ending) after.erase(0, 2);
    const std::size_t second = after.find('{');
    if (second == std::string::npos) {
      return WriteNames(*kind, {before, ending, knowledge::SplitWords(after)}, 1);
    }
    const std::size_t end = after.find('}', second);
    const auto other = knowledge::KindOf(after.substr(second + 1, end - second - 1));
    if (!other) return;
    const std::set<Sentence>& names = names_[*other];
    const Sentence between = knowledge::SplitWords(after.substr(0, second));
    const std::size_t every = between.size() > 1 ? names.size() : MayBeDefinite(*kind) ? 2 : 1;
    const std::size_t turns = TurnsFor(names);
    const double weight = static_cast<double>(turns) / static_cast<double>(names.size());
    std::size_t next = 0;
    for (const Sentence& name : names) {
      const std::size_t i = next++;
      if (i % turns != 0) continue;
      const Sentence behind =
          Joined(Joined(between, name), knowledge::SplitWords(after.substr(end + 1)));
      WriteNames(*kind, {before, ending, behind, every, every == 2 ? 1 : i % every}, weight);
    }
  }

  const SpokenLanguage& spoken_;
  const std::function<void(const Sentence&, double)>& add_;
  std::map<Kind, std::set<Sentence>> names_;
  std::map<std::string, std::string> contractions_;  // "where is" -> "wheres"
  std::vector<std::pair<Sentence, double>> collected_;
  std::size_t frames_ = 0;  // so far
};

}  // namespace

std::vector<Sentence> AsSentences(const std::vector<std::string>& texts) {
  std::vector<Sentence> sentences;
  for (const std::string& text : texts) sentences.push_back(knowledge::SplitWords(text));
  return sentences;
}

void ForEachSentence(const SpokenLanguage& spoken,
                     const std::function<void(const Sentence&, double)>& add) {
  Writer(spoken, add).Write();
}

void ForEachReply(const SpokenLanguage& spoken,
                  const std::function<void(const Sentence&, double)>& add) {
  for (const auto& [intent, weight] : kReplies) {
    for (const IntentRow& row : spoken.intents) {
      if (row.intent == intent) Spread(SentencesOf(row, spoken.language), weight, add);
    }
  }
  std::vector<Sentence> numbers;
  for (const auto& [word, number] : spoken.words.ordinals) {
    if (number < kMostChoices) AddWithArticle({word}, numbers);
  }
  Spread(numbers, kNumbers, add);
}

void ForEachNamed(const std::vector<std::string>& names,
                  const std::function<void(const Sentence&, double)>& add) {
  std::vector<Sentence> sentences;
  for (const std::string& name : names) AddWithArticle(knowledge::SplitWords(name), sentences);
  Spread(sentences, kNames, add);
}

}  // namespace coppice::robot::speech
