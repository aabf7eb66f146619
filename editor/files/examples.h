// The examples that are shipped: a tree, a record of it.
#ifndef COPPICE_EDITOR_FILES_EXAMPLES_H_
#define COPPICE_EDITOR_FILES_EXAMPLES_H_

#include <string>
#include <vector>

namespace coppice::editor {

struct Example {
  std::string title;
  std::string path;
};

/// Those that were there at the first call. Of an installed program in ../share/coppice/examples,
/// else in the sources.
const std::vector<Example>& Examples();

/// The path of the shipped example of that file name, whether it is there or not.
std::string PathOfExample(const std::string& name);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_EXAMPLES_H_
