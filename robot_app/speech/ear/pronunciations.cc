#include "robot_app/speech/ear/pronunciations.h"

#include <algorithm>
#include <cctype>
#include <fstream>

#include "robot_app/knowledge/store/folded_text.h"

namespace coppice::robot::speech {
namespace {

void AddOnce(std::vector<std::string>& all, const std::string& one) {
  if (!one.empty() && std::find(all.begin(), all.end(), one) == all.end()) all.push_back(one);
}

bool IsNumber(const std::string& word) {
  return !word.empty() && std::all_of(word.begin(), word.end(),
                                      [](unsigned char c) { return std::isdigit(c) != 0; });
}

std::string Joined(const std::string& a, const std::string& b) {
  return a.empty() ? b : b.empty() ? a : a + " " + b;
}

}  // namespace

// Lines are "where W EH R" and, for another way to say it, "where(2) HH W EH R".
Expected<Pronunciations> Pronunciations::Load(const std::string& path) {
  std::ifstream file(path);
  if (!file) return Problem{"cannot read the dictionary " + path};
  Pronunciations result;
  for (std::string line; std::getline(file, line);) {
    const std::size_t space = line.find(' ');
    if (space == std::string::npos) continue;
    const std::string word = line.substr(0, std::min(space, line.find('(')));
    AddOnce(result.words_[knowledge::Folded(word)], line.substr(space + 1));
  }
  return result;
}

std::vector<std::string> Pronunciations::Of(const std::string& word) const {
  return IsNumber(word) ? OfNumber(word) : OfWord(word);
}

std::vector<std::string> Pronunciations::OfWord(const std::string& word) const {
  const auto known = words_.find(word);
  if (known != words_.end()) return known->second;
  std::vector<std::string> all;
  for (const char* const voice : {"en-us", "de"}) {
    std::string spoken;
    for (const std::string& phoneme : reader_.Phonemes(word, voice)) {
      spoken = Joined(spoken, ArpabetOf(phoneme));
    }
    AddOnce(all, spoken);
  }
  return all;
}

std::vector<std::string> Pronunciations::OfNumber(const std::string& digits) const {
  std::vector<std::string> all;
  for (const auto& words : SpokenNumber(digits)) {
    std::string spoken;
    for (const std::string& word : words) spoken = Joined(spoken, OfWord(word).at(0));
    AddOnce(all, spoken);
  }
  return all;
}

}  // namespace coppice::robot::speech
