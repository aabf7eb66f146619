// Trees as text: for Graphviz, and as a list for notes and wikis.
#ifndef COPPICE_EDITOR_EXPORT_OUTLINE_TEXTS_H_
#define COPPICE_EDITOR_EXPORT_OUTLINE_TEXTS_H_

#include <string>
#include <vector>

#include "editor/scene/scene.h"

namespace coppice::editor {

/// A digraph for `dot`. Trees become clusters.
std::string ToDot(const std::vector<const Scene*>& trees);

/// A heading for each tree, and its nodes as a nested list with type, ports and notes.
std::string ToMarkdown(const std::vector<const Scene*>& trees);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_EXPORT_OUTLINE_TEXTS_H_
