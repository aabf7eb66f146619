// What of the checker's words the user is shown: types that no model describes are one remark, not
// one at every node, and a file that was just begun is not blamed for being empty.
#ifndef COPPICE_EDITOR_DOCUMENT_SHOWN_PROBLEMS_H_
#define COPPICE_EDITOR_DOCUMENT_SHOWN_PROBLEMS_H_

#include <vector>

#include "bt_core/base/diagnostic.h"

namespace coppice::editor {

/// `is_new`: the file was never saved. The remark about models comes last, with the place of the
/// first such type.
std::vector<Diagnostic> ShownProblems(const std::vector<Diagnostic>& problems, bool is_new);

/// True for that remark: it is about the project, so its node gets no mark.
bool IsAboutModels(const Diagnostic& problem);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_DOCUMENT_SHOWN_PROBLEMS_H_
