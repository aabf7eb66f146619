// Finding by a few letters: "fs" finds "Fit selection".
#ifndef COPPICE_EDITOR_KEYS_FUZZY_H_
#define COPPICE_EDITOR_KEYS_FUZZY_H_

#include <string_view>

namespace coppice::editor {

/// How well `pattern` fits: 0 if its letters do not occur in `text` in that order. The whole text
/// comes first, then a word of it, its beginning, the beginning of a word; among the others letters
/// that follow each other or start a word count, and short texts. Ignores case and blanks of the
/// pattern. An empty pattern fits everything with 1.
int FuzzyScore(std::string_view pattern, std::string_view text);

/// Two that fit alike are less than this apart, others more than eight times this.
inline constexpr int kSameFit = 1000000;

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_KEYS_FUZZY_H_
