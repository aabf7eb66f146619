// `coppice export TREE.xml -o tree.svg`: pictures of trees without a window.
#ifndef COPPICE_EDITOR_EXPORT_EXPORT_VERB_H_
#define COPPICE_EDITOR_EXPORT_EXPORT_VERB_H_

#include <string>
#include <vector>

#include "bt_core/base/command_line.h"

namespace coppice::editor {

const Command& ExportCommand();

/// Runs it with the arguments behind the verb. What is wrong goes to standard error. Returns 0, 1
/// if no picture was written, or 2 for a wrong command line.
int RunExport(const std::vector<std::string>& arguments);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_EXPORT_EXPORT_VERB_H_
