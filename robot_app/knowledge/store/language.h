// The languages that the robot speaks, and what people may name: the vocabulary of names.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_STORE_LANGUAGE_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_STORE_LANGUAGE_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coppice::robot::knowledge {

enum class Language : std::uint8_t { kEnglish, kGerman };
inline constexpr std::array kLanguages = {Language::kEnglish, Language::kGerman};

/// "en" or "de" (ISO 639-1), as in files, and back.
const char* Code(Language language);
std::optional<Language> LanguageOf(std::string_view code);

/// A value for each language.
template <class T>
using ByLanguage = std::array<T, kLanguages.size()>;
template <class T>
T& In(Language language, ByLanguage<T>& values) {
  return values[static_cast<std::size_t>(language)];
}
template <class T>
const T& In(Language language, const ByLanguage<T>& values) {
  return values[static_cast<std::size_t>(language)];
}

/// What a name names. The subject of a stop is its name, that of a line what is written on the
/// vehicle, that of a day "today", "tomorrow", "day_after_tomorrow" or "monday" to "sunday"; all
/// others have an id.
enum class Kind : std::uint8_t {
  kPerson,
  kPlace,
  kCategory,
  kLine,
  kStop,
  kDiet,
  kDay,
  kTopic,
};
inline constexpr std::array kKinds = {Kind::kPerson, Kind::kPlace, Kind::kCategory, Kind::kLine,
                                      Kind::kStop,   Kind::kDiet,  Kind::kDay,      Kind::kTopic};

/// "person", "place" ..., as in files and in the database, and back.
const char* Word(Kind kind);
std::optional<Kind> KindOf(std::string_view word);
std::vector<std::string> KindWords();

/// A name or synonym of a subject.
struct Name {
  Kind kind = Kind::kPlace;
  std::string subject;
  Language language = Language::kEnglish;
  std::string text;
  bool is_main = false;  ///< what the robot itself says
};

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_STORE_LANGUAGE_H_
