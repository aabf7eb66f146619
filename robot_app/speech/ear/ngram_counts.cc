#include "robot_app/speech/ear/ngram_counts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace coppice::robot::speech {
namespace {

constexpr std::size_t kOrder = 3;
constexpr char kBegin[] = "<s>", kEnd[] = "</s>";

std::string Line(double probability, const std::vector<std::string>& words, double back_off) {
  char number[32];
  std::snprintf(number, sizeof number, "%.4f", std::log10(probability));
  std::string line = number;
  for (const std::string& word : words) line += (&word == &words.front() ? "\t" : " ") + word;
  if (back_off > 0) {
    std::snprintf(number, sizeof number, "\t%.4f", std::log10(back_off));
    line += number;
  }
  return line + "\n";
}

double Sum(const std::map<std::string, double>& weights) {
  double sum = 0;
  for (const auto& [word, weight] : weights) sum += weight;
  return sum;
}

}  // namespace

void NgramCounts::Add(const std::vector<std::string>& sentence, double weight) {
  std::vector<std::string> words = {kBegin};
  words.insert(words.end(), sentence.begin(), sentence.end());
  words.push_back(kEnd);
  AddNgrams(words, weight);
}

// All that end with the second or a later word.
void NgramCounts::AddNgrams(const std::vector<std::string>& words, double weight) {
  for (std::size_t i = 1; i < words.size(); ++i) {
    for (std::size_t length = 0; length < kOrder && length <= i; ++length) {
      const History history(words.begin() + static_cast<long>(i - length),
                            words.begin() + static_cast<long>(i));
      counts_[history][words[i]] += weight;
    }
  }
}

NgramCounts::Followers NgramCounts::FollowersOf(const History& history) const {
  const auto found = counts_.find(history);
  return found == counts_.end() ? Followers() : found->second;
}

// A trigram knows two words: behind a greeting the first two of a sentence are new to it.
void NgramCounts::AddBefore(const std::vector<std::vector<std::string>>& greetings, double share) {
  const Followers firsts = FollowersOf({kBegin});
  std::map<std::string, Followers> seconds;
  for (const auto& [first, weight] : firsts) seconds[first] = FollowersOf({kBegin, first});
  for (const std::vector<std::string>& greeting : greetings) {
    std::vector<std::string> words = {kBegin};
    words.insert(words.end(), greeting.begin(), greeting.end());
    const double each = share / static_cast<double>(greetings.size());
    AddNgrams(words, each * Sum(firsts));
    const std::string &before = words[words.size() - 2], last = words.back();
    for (const auto& [first, weight] : firsts) {
      for (const History& history : {History{}, History{last}, History{before, last}}) {
        counts_[history][first] += each * weight;
      }
      Followers& after = counts_[{last, first}];
      for (const auto& [second, times] : seconds[first]) after[second] += each * times;
    }
  }
}

void NgramCounts::AddBehind(const std::vector<std::vector<std::string>>& courtesies, double share) {
  std::vector<std::pair<History, double>> ends;  // what may stand last, and how often it does
  for (const auto& [history, followers] : counts_) {
    const auto end = followers.find(kEnd);
    if (end != followers.end()) ends.emplace_back(history, end->second);
  }
  for (std::vector<std::string> words : courtesies) {
    const double each = share / static_cast<double>(courtesies.size());
    words.emplace_back(kEnd);
    for (const auto& [history, weight] : ends) {
      counts_[history][words[0]] += each * weight;
      if (history.empty()) AddNgrams(words, each * weight);
      if (history.size() == 1) counts_[{history[0], words[0]}][words[1]] += each * weight;
    }
  }
}

std::vector<std::string> NgramCounts::Words() const {
  std::vector<std::string> words;
  const auto unigrams = counts_.find({});
  if (unigrams != counts_.end()) {
    for (const auto& [word, weight] : unigrams->second) words.push_back(word);
  }
  for (const auto& [word, weight] : anywhere_) words.push_back(word);
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

std::string NgramCounts::Arpa() const {
  std::array<std::string, kOrder> lines;
  std::array<std::size_t, kOrder> count{};
  std::map<History, double> probability;  // of each n-gram, its last word included
  const double all = std::max(Sum(counts_.at({})), 1e-9), all_anywhere = Sum(anywhere_);
  const double share = all_anywhere > 0 ? anywhere : 0;
  for (const std::string& word : Words()) {
    const auto counted = counts_.at({}).find(word);
    const auto any = anywhere_.find(word);
    probability[{word}] =
        (counted == counts_.at({}).end() ? 0 : (1 - share) * counted->second / all) +
        (any == anywhere_.end() ? 0 : share * any->second / all_anywhere);
  }
  for (std::size_t length = 1; length < kOrder; ++length) {
    for (const auto& [history, followers] : counts_) {
      if (history.size() != length) continue;
      const double sum = Sum(followers);
      for (const auto& [word, weight] : followers) {
        History shorter(history.begin() + 1, history.end());
        shorter.push_back(word);
        History whole = history;
        whole.push_back(word);
        probability[whole] = (1 - lower) * weight / sum + lower * probability.at(shorter);
      }
    }
  }
  probability[{kBegin}] = 1e-9;
  for (const auto& [words, value] : probability) {
    const bool is_history = words.size() < kOrder && counts_.count(words) > 0;
    lines[words.size() - 1] += Line(value, words,
                                    words.size() == kOrder ? 0
                                    : is_history           ? lower
                                                           : 1);
    ++count[words.size() - 1];
  }
  std::string text = "\\data\\\n";
  for (std::size_t i = 0; i < kOrder; ++i) {
    text += "ngram " + std::to_string(i + 1) + "=" + std::to_string(count[i]) + "\n";
  }
  for (std::size_t i = 0; i < kOrder; ++i) {
    text += "\n\\" + std::to_string(i + 1) + "-grams:\n" + lines[i];
  }
  return text + "\n\\end\\\n";
}

}  // namespace coppice::robot::speech
