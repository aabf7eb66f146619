// Copies of unsaved work, so that a crash or a power cut costs some seconds at most.
//
//   Backup backup(folder);
//   backup.Update(project);                       // every few seconds
//   if (auto text = backup.Find(*project.Find(path))) { /* offer to restore it */ }
//
// A copy is there for as long as its file is not saved. Without a folder nothing is kept.
#ifndef COPPICE_EDITOR_FILES_BACKUP_H_
#define COPPICE_EDITOR_FILES_BACKUP_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "editor/files/open_project.h"

namespace coppice::editor {

class Backup {
 public:
  explicit Backup(std::string folder) : folder_(std::move(folder)) {}

  /// Writes the texts that changed since the last time and are not saved; removes the copies of
  /// those that are.
  void Update(const OpenProject& project);

  /// What was not saved when an editor ended the last time; nothing if there is no copy, or if it
  /// is the same as the file.
  std::optional<std::string> Find(const EditedFile& file) const;

  /// Forgets the copy of that file.
  void Remove(const std::string& path);

 private:
  std::string PathOf(const std::string& path) const;

  std::string folder_;
  std::map<std::string, std::uint32_t> written_;  // version of the text, by path
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_BACKUP_H_
