// In a browser there is no git.
#include "editor/files/git_head.h"

namespace coppice::editor {

std::shared_ptr<const std::string> GitHead::TextOf(const std::string&) { return nullptr; }

void GitHead::Look() {}

void GitHead::Wait() {}

}  // namespace coppice::editor
