// The undo history on the disk, beside the backup of unsaved work, so that undoing goes on after a
// restart.
//
//   HistoryStore store(folder);
//   project.Open(path, diagnostics);
//   store.Restore(project);        // the steps of the last time, if the file is as they left it
//   store.Update(project);         // every few seconds, and at the end
//
// Every editor writes a file of its own; the newest ones are kept. A step that is about several
// files is there if all of them are open and as it left them. Without a folder nothing is kept.
#ifndef COPPICE_EDITOR_FILES_HISTORY_STORE_H_
#define COPPICE_EDITOR_FILES_HISTORY_STORE_H_

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "editor/files/history_bytes.h"
#include "editor/files/open_project.h"

namespace coppice::editor {

class HistoryStore {
 public:
  static constexpr std::size_t kLimit = 8 << 20;  ///< bytes of one file
  static constexpr std::size_t kMostFiles = 16;

  explicit HistoryStore(std::string folder, std::size_t limit = kLimit);

  /// Writes the history if it is another one than the last time.
  void Update(const OpenProject& project);

  /// Puts what is known of the files that were not open the last time this was called in front of
  /// the project's history. Returns the number of steps.
  std::size_t Restore(OpenProject& project);

  /// Puts a text that was not saved in the place of the file's, together with its history. False if
  /// no history ends with that text; then nothing has changed.
  bool Resume(OpenProject& project, const std::string& path, const std::string& text);

 private:
  /// What other editors have left, the newest first.
  std::vector<StoredHistory> ReadAll() const;
  void RemoveOld() const;

  const std::string folder_;
  const std::size_t limit_;
  std::string path_;
  std::set<std::string> seen_;  // paths of files whose history was looked for
  std::uint64_t written_version_ = 0;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_HISTORY_STORE_H_
