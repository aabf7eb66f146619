// What differs between two versions of a tree, in words.
#ifndef COPPICE_EDITOR_DIFF_DIFF_SENTENCE_H_
#define COPPICE_EDITOR_DIFF_DIFF_SENTENCE_H_

#include <string>

#include "editor/diff/tree_diff.h"

namespace coppice::editor {

/// One sentence: `"Retry" has changed: num_attempts was "3" and is "5" now`. The scenes are those
/// that the difference was found in.
std::string Sentence(const NodeDiff& diff, const Scene& before, const Scene& after);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DIFF_DIFF_SENTENCE_H_
