// A change of one or several files as a value with a name, as the history keeps it.
#ifndef COPPICE_EDITOR_FILES_CHANGE_H_
#define COPPICE_EDITOR_FILES_CHANGE_H_

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/model/document.h"
#include "bt_core/model/edit.h"

namespace coppice::editor {

/// An element in a file, by the offset of its '<'.
struct FilePlace {
  std::string path;
  std::uint32_t offset = 0;
};
inline bool operator==(const FilePlace& a, const FilePlace& b) {
  return a.path == b.path && a.offset == b.offset;
}

/// What happens to one file.
struct FileChange {
  std::string path;
  std::vector<Edit> steps;              ///< each is about the text that the one before it leaves
  std::optional<Document> after;        ///< the result, parsed; without it the project parses
  std::vector<std::uint32_t> selected;  ///< offsets in the result of what is to be selected
};

struct NamedChange {
  std::string name;               ///< "Move OpenDoor", for menus and the history
  std::vector<FileChange> files;  ///< each file once

  bool is_empty() const {
    for (const FileChange& file : files) {
      if (!file.steps.empty()) return false;
    }
    return true;
  }
};

/// The smallest single splice that makes `after` of `before`; empty if they are the same.
Edit Difference(std::string_view before, std::string_view after);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_CHANGE_H_
