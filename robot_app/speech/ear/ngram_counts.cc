#include "robot_app/speech/ear/ngram_counts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace coppice::robot::speech {
namespace {

constexpr std::uint32_t kBegin = 1, kEnd = 2;  // of a sentence
constexpr double kNever = 1e-9;                // how likely a sentence begins within another

template <class Weights>
double Sum(const Weights& weights) {
  double sum = 0;
  for (const auto& [words, weight] : weights) sum += weight;
  return sum;
}

}  // namespace

NgramCounts::NgramCounts() : words_{"", "<s>", "</s>"} {
  for (Word word = kBegin; word <= kEnd; ++word) numbers_[words_[word]] = word;
}

NgramCounts::Word NgramCounts::NumberOf(const std::string& word) {
  const auto [found, is_new] = numbers_.emplace(word, static_cast<Word>(words_.size()));
  if (is_new) words_.push_back(word);
  return found->second;
}

std::vector<NgramCounts::Word> NgramCounts::NumbersOf(const std::vector<std::string>& words) {
  std::vector<Word> numbers;
  for (const std::string& word : words) numbers.push_back(NumberOf(word));
  return numbers;
}

void NgramCounts::Add(const std::vector<std::string>& sentence, double weight) {
  std::vector<Word> words = NumbersOf(sentence);
  words.insert(words.begin(), kBegin);
  words.push_back(kEnd);
  Count(words, weight);
}

// All that end with the second or a later word.
void NgramCounts::Count(const std::vector<Word>& words, double weight) {
  for (std::size_t end = 1; end < words.size(); ++end) {
    for (std::size_t length = 1; length <= std::min(kOrder, end + 1); ++length) {
      Ngram ngram{};
      std::copy_n(words.begin() + static_cast<std::ptrdiff_t>(end + 1 - length), length,
                  ngram.begin());
      counts_[length - 1][ngram] += weight;
    }
  }
}

// A trigram knows two words: behind a greeting the first two of a sentence are new to it.
void NgramCounts::AddBefore(const std::vector<std::vector<std::string>>& greetings, double share) {
  const auto begins = [](const Counts& counts) {
    return std::vector<Counted>(counts.lower_bound({kBegin}), counts.lower_bound({kBegin + 1}));
  };
  const std::vector<Counted> firsts = begins(counts_[1]), seconds = begins(counts_[2]);
  for (const std::vector<std::string>& greeting : greetings) {
    std::vector<Word> words = NumbersOf(greeting);
    words.insert(words.begin(), kBegin);
    const double each = share / static_cast<double>(greetings.size());
    Count(words, each * Sum(firsts));
    const Word before = words[words.size() - 2], last = words.back();
    for (const auto& [begin, weight] : firsts) {
      const Word first = begin[1];
      counts_[0][{first}] += each * weight;
      counts_[1][{last, first}] += each * weight;
      counts_[2][{before, last, first}] += each * weight;
    }
    for (const auto& [begin, weight] : seconds) {
      counts_[2][{last, begin[1], begin[2]}] += each * weight;
    }
  }
}

void NgramCounts::AddBehind(const std::vector<std::vector<std::string>>& courtesies, double share) {
  std::array<std::vector<Counted>, kOrder> ends;  // what stands last
  for (std::size_t last = 0; last < kOrder; ++last) {
    std::copy_if(counts_[last].begin(), counts_[last].end(), std::back_inserter(ends[last]),
                 [last](const Counted& counted) { return counted.first[last] == kEnd; });
  }
  for (const std::vector<std::string>& courtesy : courtesies) {
    std::vector<Word> words = NumbersOf(courtesy);
    words.push_back(kEnd);
    const double each = share / static_cast<double>(courtesies.size());
    Count(words, each * Sum(ends[0]));
    for (std::size_t last = 0; last < kOrder; ++last) {
      for (auto [ngram, weight] : ends[last]) {
        ngram[last] = words[0];
        counts_[last][ngram] += each * weight;
        if (last == 1) counts_[2][{ngram[0], words[0], words[1]}] += each * weight;
      }
    }
  }
}

std::vector<std::string> NgramCounts::Words() const {
  std::vector<std::string> words(words_.begin() + kEnd, words_.end());
  std::sort(words.begin(), words.end());
  return words;
}

// Whether something was counted that begins with these words and has one more.
bool NgramCounts::GoesOn(const Ngram& words, std::size_t length) const {
  const auto next = counts_[length].lower_bound(words);
  return next != counts_[length].end() &&
         std::equal(words.begin(), words.begin() + static_cast<std::ptrdiff_t>(length),
                    next->first.begin());
}

std::string NgramCounts::Line(double probability, const Ngram& words, std::size_t length) const {
  char number[32];
  std::snprintf(number, sizeof number, "%.4f", std::log10(probability));
  std::string line = number;
  for (std::size_t i = 0; i < length; ++i) line += (i == 0 ? "\t" : " ") + words_[words[i]];
  if (length < kOrder) {
    const double back_off = GoesOn(words, length) ? lower : 1;
    std::snprintf(number, sizeof number, "\t%.4f", std::log10(back_off));
    line += number;
  }
  return line + "\n";
}

std::vector<double> NgramCounts::UnigramProbabilities() const {
  std::vector<double> probabilities(words_.size(), kNever);
  const double all = Sum(counts_[0]), all_anywhere = Sum(anywhere_);
  const double share = all_anywhere > 0 ? anywhere : 0;
  for (const auto& [words, weight] : counts_[0]) {
    probabilities[words[0]] += (1 - share) * weight / all;
  }
  for (const auto& [word, weight] : anywhere_) {
    probabilities[word] += share * weight / all_anywhere;
  }
  return probabilities;
}

std::string NgramCounts::Arpa() const {
  const std::vector<double> unigrams = UnigramProbabilities();
  std::vector<double> followed(words_.size());  // how often a word was, by any other
  for (const auto& [words, weight] : counts_[1]) followed[words[0]] += weight;
  const auto bigram = [&](const Ngram& words, double weight) {
    return (1 - lower) * weight / followed[words[0]] + lower * unigrams[words[1]];
  };

  std::string text = "\\data\\\nngram 1=" + std::to_string(words_.size() - 1) +
                     "\nngram 2=" + std::to_string(counts_[1].size()) +
                     "\nngram 3=" + std::to_string(counts_[2].size()) + "\n";
  text += "\n\\1-grams:\n";
  for (Word word = kBegin; word < words_.size(); ++word) text += Line(unigrams[word], {word}, 1);
  text += "\n\\2-grams:\n";
  for (const auto& [words, weight] : counts_[1]) text += Line(bigram(words, weight), words, 2);
  text += "\n\\3-grams:\n";
  for (auto begin = counts_[2].begin(); begin != counts_[2].end();) {
    const auto end = counts_[2].lower_bound({begin->first[0], begin->first[1] + 1});
    double sum = 0;
    for (auto next = begin; next != end; ++next) sum += next->second;
    for (; begin != end; ++begin) {
      const auto& [words, weight] = *begin;
      const Ngram shorter = {words[1], words[2]};
      const double shorter_probability = bigram(shorter, counts_[1].at(shorter));
      text += Line((1 - lower) * weight / sum + lower * shorter_probability, words, kOrder);
    }
  }
  return text + "\n\\end\\\n";
}

}  // namespace coppice::robot::speech
