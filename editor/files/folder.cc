#include "editor/files/folder.h"

#include <algorithm>
#include <filesystem>
#include <system_error>

namespace coppice::editor {

Folder ReadFolder(const std::string& path) {
  namespace fs = std::filesystem;
  Folder folder;
  folder.path = path;
  std::error_code error;
  fs::directory_iterator at(path.empty() ? "." : path, error);
  for (; !error && at != fs::directory_iterator(); at.increment(error)) {
    std::error_code ignored;
    folder.entries.push_back({at->path().filename().string(), at->is_directory(ignored)});
  }
  if (error) folder.problem = error.message();
  std::sort(folder.entries.begin(), folder.entries.end(),
            [](const FolderEntry& a, const FolderEntry& b) {
              return a.is_folder != b.is_folder ? a.is_folder : a.name < b.name;
            });
  return folder;
}

}  // namespace coppice::editor
