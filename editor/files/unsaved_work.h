// Copies of unsaved work, so that a crash, a kill or a power cut costs some seconds at most.
//
//   UnsavedWork work(folder);
//   work.Keep(project);                                  // every few seconds, and at the end
//   work.Look(project);                                  // likewise
//   for (const UnsavedCopy& copy : work.left()) ...      // of editors that have ended: offer them
//   work.Forget(copy);                                   // restored, or not wanted
//
// Every editor has copies of its own and holds a lock for as long as it lives (flock of a file
// beside them, which the system lets go when the program ends, however it ends). So nothing that
// another editor left is ever overwritten: it stays until somebody has taken or forgotten it.
// Without a folder nothing is kept. One thread.
#ifndef COPPICE_EDITOR_FILES_UNSAVED_WORK_H_
#define COPPICE_EDITOR_FILES_UNSAVED_WORK_H_

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/base/outcome.h"
#include "editor/files/open_project.h"

namespace coppice::editor {

struct UnsavedCopy {
  std::string path;                        ///< of the edited file, absolute
  bool is_new = false;                     ///< that never was on the disk: a name, no more
  std::filesystem::file_time_type time{};  ///< when it was kept
  std::string file;                        ///< of the copy
  int editor = 0;                          ///< process that has it in its hands; 0: that has ended
};

class UnsavedWork {
 public:
  explicit UnsavedWork(std::string folder = {});
  ~UnsavedWork();  // the copies stay
  UnsavedWork(const UnsavedWork&) = delete;
  UnsavedWork& operator=(const UnsavedWork&) = delete;

  /// Writes the texts that changed since the last time and are not saved; removes the copies of
  /// those that are.
  void Keep(const OpenProject& project);
  /// Why the last Keep could not keep something, for people; empty: it has kept all.
  const std::string& trouble() const { return trouble_; }
  /// The user does not want what is not saved.
  void DropOwn();

  /// Looks what other editors have. A copy of what an open file holds on the disk anyway goes.
  void Look(const OpenProject& project);
  /// Of editors that have ended, the newest first.
  const std::vector<UnsavedCopy>& left() const { return left_; }
  /// Of other editors that are at work.
  const std::vector<UnsavedCopy>& elsewhere() const { return elsewhere_; }

  /// Nothing if it cannot be read any more.
  static std::optional<std::string> TextOf(const UnsavedCopy& copy);
  void Forget(const UnsavedCopy& copy);

  /// The path by which copies know a file.
  static std::string AbsolutePath(const std::string& path);

 private:
  struct Kept {
    std::uint32_t version = 0;  // of the text
    std::string file;
  };
  std::string LockOf(const std::string& session) const;
  bool TakeLock();
  Outcome Write(const EditedFile& file);
  int EditorOf(const std::string& session) const;

  const std::string folder_;
  std::string session_;  // the beginning of the names of our files; empty: there are none yet
  int lock_ = -1;
  std::map<std::string, Kept> kept_;  // by path of the edited file
  std::string trouble_;
  std::vector<UnsavedCopy> left_;
  std::vector<UnsavedCopy> elsewhere_;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_UNSAVED_WORK_H_
