// The node types that can be added or changed to, by what is typed.
#ifndef COPPICE_EDITOR_PANELS_POPUP_TYPE_CHOICES_H_
#define COPPICE_EDITOR_PANELS_POPUP_TYPE_CHOICES_H_

#include <string>
#include <vector>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

struct TypeChoice {
  std::string type;
  std::string kind;  ///< category, "SubTree", or "new" for a type that nobody knows yet
  std::string note;  ///< what it is for
  std::string xml;   ///< the element to insert
  int score = 0;
};

/// The best choices, best first, at most `limit`: whole words, then beginnings, then other letters
/// (FuzzyScore); of those that fit alike, what was used last.
/// `with_trees`: the trees of the file too, as SubTrees.
std::vector<TypeChoice> FindTypes(const EditorState& state, const std::string& typed,
                                  bool with_trees, std::size_t limit);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_PANELS_POPUP_TYPE_CHOICES_H_
