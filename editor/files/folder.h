// What is in a folder of the disk, for those who choose a file.
#ifndef COPPICE_EDITOR_FILES_FOLDER_H_
#define COPPICE_EDITOR_FILES_FOLDER_H_

#include <string>
#include <vector>

namespace coppice::editor {

struct FolderEntry {
  std::string name;
  bool is_folder = false;  ///< or a link to one
};

struct Folder {
  std::string path;                  ///< as it was asked for; empty: the current one
  std::vector<FolderEntry> entries;  ///< folders first, both by name; hidden ones too
  std::string problem;               ///< why it cannot be read, in the system's words; else empty
};

/// Takes as long as the disk does.
Folder ReadFolder(const std::string& path);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_FOLDER_H_
