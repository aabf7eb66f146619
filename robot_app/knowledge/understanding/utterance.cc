#include "robot_app/knowledge/understanding/utterance.h"

#include <cctype>

#include "robot_app/knowledge/store/folded_text.h"

namespace coppice::robot::knowledge {
namespace {

bool IsDigit(char c) { return c >= '0' && c <= '9'; }

// The digits that words from `at` on mean, and how many words these are. A single "one" is no
// number: it stands for anything.
std::pair<std::string, std::size_t> NumberAt(const std::vector<std::string>& words, std::size_t at,
                                             const LanguageWords& language) {
  std::string digits;
  std::size_t end = at;
  for (; end < words.size(); ++end) {
    const auto number = language.numbers.find(words[end]);
    if (number == language.numbers.end()) break;
    digits += number->second;
  }
  if (end - at == 1 && (digits == "1" || digits == "0")) return {{}, 0};
  return {digits, end - at};
}

std::vector<std::string> WithDigits(const std::vector<std::string>& words,
                                    const LanguageWords& language) {
  std::vector<std::string> result;
  for (std::size_t i = 0; i < words.size();) {
    const auto [digits, count] = NumberAt(words, i, language);
    result.push_back(count > 0 ? digits : words[i]);
    i += std::max<std::size_t>(count, 1);
  }
  return result;
}

}  // namespace

std::vector<std::string> SplitWords(std::string_view text) {
  std::vector<std::string> words;
  for (const std::string& word : Words(text)) {
    for (std::size_t i = 0; i < word.size(); ++i) {
      if (i == 0 || IsDigit(word[i]) != IsDigit(word[i - 1])) words.emplace_back();
      words.back() += word[i];
    }
  }
  return words;
}

std::vector<std::string> SplitWords(std::string_view text, const LanguageWords& language) {
  std::vector<std::string> words;
  for (std::string& word : SplitWords(text)) {
    const auto contraction = language.contractions.find(word);
    if (contraction == language.contractions.end()) {
      words.push_back(std::move(word));
      continue;
    }
    for (std::string& part : Words(contraction->second)) words.push_back(std::move(part));
  }
  return words;
}

Utterance TakeApart(std::string_view text, const LanguageWords& language) {
  Utterance utterance;
  for (std::string& word : WithDigits(SplitWords(text, language), language)) {
    if (utterance.words.size() == kMostWords) break;
    const bool is_filler = language.fillers.count(word) > 0;
    utterance.content.set(utterance.words.size(), !is_filler);
    utterance.exact.set(utterance.words.size(), is_filler);
    utterance.words.push_back(Sounding(std::move(word)));
  }
  for (std::size_t i = 1; i < utterance.words.size(); ++i) {
    utterance.joined.push_back(Sounding(utterance.words[i - 1].text + utterance.words[i].text));
  }
  return utterance;
}

}  // namespace coppice::robot::knowledge
