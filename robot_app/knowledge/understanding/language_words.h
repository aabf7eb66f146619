// What the understanding knows of a language beside names and intents: words.LANGUAGE.yaml.
#ifndef COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_LANGUAGE_WORDS_H_
#define COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_LANGUAGE_WORDS_H_

#include <map>
#include <set>
#include <string>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "robot_app/knowledge/store/language.h"

namespace coppice::robot::knowledge {

/// All folded (folded_text.h).
struct LanguageWords {
  std::set<std::string> fillers;                    ///< say nothing: articles, courtesies
  std::set<std::string> from;                       ///< before where something begins
  std::set<std::string> of;                         ///< before whom or what something belongs to
  std::set<std::string> titles;                     ///< before a family name
  std::map<std::string, std::string> numbers;       ///< "four" -> "4", 0 to 12
  std::map<std::string, std::string> contractions;  ///< "whats" -> "what is"
  std::vector<std::string> greetings;               ///< before any sentence: "excuse me"
  std::vector<std::string> courtesies;              ///< behind any sentence: "please"
  std::vector<std::string> line_patterns;           ///< "line {}": how a line of traffic is called
  std::map<std::string, std::size_t> ordinals;      ///< "first" -> 0
  std::vector<Name> days;                           ///< of Kind::kDay
};

/// Reads words.en.yaml or words.de.yaml of a folder.
LanguageWords LoadLanguageWords(const std::string& folder, Language language,
                                Diagnostics& diagnostics);

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_ROBOT_APP_KNOWLEDGE_UNDERSTANDING_LANGUAGE_WORDS_H_
