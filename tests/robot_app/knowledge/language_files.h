// The shipped files of both languages.
#ifndef COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_LANGUAGE_FILES_H_
#define COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_LANGUAGE_FILES_H_

#include <stdexcept>
#include <string>

#include "robot_app/knowledge/answers/dialogue.h"
#include "tests/support/folders.h"

namespace coppice::robot::knowledge {

inline std::string LanguageFolder() { return SourceFolder() + "/robot_app/knowledge/language"; }

inline const LanguageFiles& ShippedLanguageFiles() {
  static const LanguageFiles files = [] {
    Diagnostics diagnostics;
    LanguageFiles loaded = LanguageFiles::Load(LanguageFolder(), diagnostics);
    if (!diagnostics.all().empty()) throw std::runtime_error(diagnostics.ToString());
    return loaded;
  }();
  return files;
}

}  // namespace coppice::robot::knowledge

#endif  // COPPICE_TESTS_ROBOT_APP_KNOWLEDGE_LANGUAGE_FILES_H_
