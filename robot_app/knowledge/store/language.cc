#include "robot_app/knowledge/store/language.h"

#include <algorithm>

namespace coppice::robot::knowledge {
namespace {

constexpr std::array kCodes = {"en", "de"};
constexpr std::array kWords = {"person", "place", "category", "line",
                               "stop",   "diet",  "day",      "topic"};

// The value whose word this is.
template <class Enum, std::size_t kCount>
std::optional<Enum> ValueOf(std::string_view word, const std::array<const char*, kCount>& words) {
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) return std::nullopt;
  return static_cast<Enum>(found - words.begin());
}

}  // namespace

const char* Code(Language language) { return kCodes[static_cast<std::size_t>(language)]; }
std::optional<Language> LanguageOf(std::string_view code) {
  return ValueOf<Language>(code, kCodes);
}

const char* Word(Kind kind) { return kWords[static_cast<std::size_t>(kind)]; }
std::optional<Kind> KindOf(std::string_view word) { return ValueOf<Kind>(word, kWords); }
std::vector<std::string> KindWords() { return {kWords.begin(), kWords.end()}; }

}  // namespace coppice::robot::knowledge
