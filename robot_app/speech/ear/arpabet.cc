#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "robot_app/speech/ear/pronunciations.h"

namespace coppice::robot::speech {
namespace {

struct Sounds {
  std::string_view ipa, arpabet;
};

// Longer ones first: the first that the rest of a phoneme begins with is taken.
constexpr Sounds kSounds[] = {
    {"tʃ", "CH"},    {"dʒ", "JH"}, {"ts", "T S"}, {"pf", "P F"}, {"aɪ", "AY"}, {"aʊ", "AW"},
    {"eɪ", "EY"},    {"oʊ", "OW"}, {"əʊ", "OW"},  {"ɔɪ", "OY"},  {"ɔø", "OY"}, {"ɔy", "OY"},
    {"iə", "IY AH"}, {"ɑː", "AA"}, {"aː", "AA"},  {"eː", "EY"},  {"iː", "IY"}, {"oː", "OW"},
    {"uː", "UW"},    {"yː", "UW"}, {"øː", "ER"},  {"ɛː", "EH"},  {"ɔː", "AO"}, {"ɜː", "ER"},
    {"a", "AA"},     {"æ", "AE"},  {"ɐ", "AH"},   {"ə", "AH"},   {"ɚ", "ER"},  {"ɜ", "ER"},
    {"ʌ", "AH"},     {"ɑ", "AA"},  {"ɒ", "AA"},   {"ɔ", "AO"},   {"e", "EH"},  {"ɛ", "EH"},
    {"i", "IY"},     {"ɪ", "IH"},  {"ᵻ", "IH"},   {"o", "OW"},   {"ø", "ER"},  {"œ", "ER"},
    {"u", "UW"},     {"ʊ", "UH"},  {"y", "UW"},   {"ʏ", "UH"},   {"b", "B"},   {"ç", "K"},
    {"d", "D"},      {"ð", "DH"},  {"f", "F"},    {"ɡ", "G"},    {"g", "G"},   {"h", "HH"},
    {"j", "Y"},      {"k", "K"},   {"l", "L"},    {"m", "M"},    {"n", "N"},   {"ŋ", "NG"},
    {"p", "P"},      {"r", "R"},   {"ɹ", "R"},    {"ɾ", "R"},    {"ʁ", "R"},   {"s", "S"},
    {"ʃ", "SH"},     {"t", "T"},   {"θ", "TH"},   {"v", "V"},    {"w", "W"},   {"x", "K"},
    {"z", "Z"},      {"ʒ", "ZH"}};

const Sounds* FirstOf(std::string_view rest) {
  const auto* const found = std::find_if(
      std::begin(kSounds), std::end(kSounds),
      [rest](const Sounds& sounds) { return rest.substr(0, sounds.ipa.size()) == sounds.ipa; });
  return found == std::end(kSounds) ? nullptr : found;
}

constexpr std::array kOnes = {"zero", "one", "two",   "three", "four",
                              "five", "six", "seven", "eight", "nine"};
constexpr std::array kTeens = {"ten",     "eleven",  "twelve",    "thirteen", "fourteen",
                               "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"};
constexpr std::array kTens = {"",      "",      "twenty",  "thirty", "forty",
                              "fifty", "sixty", "seventy", "eighty", "ninety"};

using SpokenWords = std::vector<std::string>;

SpokenWords Digits(const std::string& digits, const char* zero) {
  SpokenWords words;
  for (const char digit : digits) {
    words.emplace_back(digit == '0' ? zero : kOnes[static_cast<std::size_t>(digit - '0')]);
  }
  return words;
}

SpokenWords operator+(SpokenWords words, const SpokenWords& more) {
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

// Below 100; nothing for 0.
SpokenWords Tens(std::size_t number) {
  if (number == 0) return {};
  if (number < 10) return {kOnes[number]};
  if (number < 20) return {kTeens[number - 10]};
  SpokenWords words = {kTens[number / 10]};
  return number % 10 == 0 ? words : words + SpokenWords{kOnes[number % 10]};
}

}  // namespace

std::string ArpabetOf(const std::string& ipa) {
  std::string all;
  std::string_view rest = ipa;
  while (!rest.empty()) {
    const Sounds* const sounds = FirstOf(rest);
    if (sounds != nullptr) {
      if (!all.empty()) all += " ";
      all += sounds->arpabet;
    }
    rest.remove_prefix(sounds == nullptr ? 1 : sounds->ipa.size());  // stress, length
  }
  return all;
}

std::vector<SpokenWords> SpokenNumber(const std::string& digits) {
  std::vector<SpokenWords> all;
  if (digits.empty() || digits.size() > 4 || digits[0] == '0') {
    return {Digits(digits, "oh"), Digits(digits, "zero")};
  }
  const std::size_t number = std::stoul(digits);
  if (digits.size() <= 2) return {Tens(number), Digits(digits, "oh"), Digits(digits, "zero")};
  all = {Digits(digits, "oh"), Digits(digits, "zero")};
  if (digits.size() == 4) {
    if (number % 100 >= 10) all.push_back(Tens(number / 100) + Tens(number % 100));
    return all;
  }
  const SpokenWords hundreds = {kOnes[number / 100], "hundred"};
  all.push_back(hundreds + Tens(number % 100));
  if (number % 100 > 0) all.push_back(hundreds + SpokenWords{"and"} + Tens(number % 100));
  if (number % 100 >= 10) all.push_back(Tens(number / 100) + Tens(number % 100));
  return all;
}

}  // namespace coppice::robot::speech
