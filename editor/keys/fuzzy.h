// Finding by a few letters: "fs" finds "Fit selection".
#ifndef COPPICE_EDITOR_KEYS_FUZZY_H_
#define COPPICE_EDITOR_KEYS_FUZZY_H_

#include <string_view>

namespace coppice::editor {

/// How well `pattern` fits: 0 if its letters do not occur in `text` in that order, else more for
/// letters that follow each other or start a word, and for short texts. Ignores case and blanks
/// of the pattern. An empty pattern fits everything with 1.
int FuzzyScore(std::string_view pattern, std::string_view text);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_KEYS_FUZZY_H_
