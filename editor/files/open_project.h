// The files that are being edited, as one project: their texts in memory, one history for all of
// them, and how they relate to the disk. Knows no window.
//
//   OpenProject project;
//   project.Open("patrol.xml", diagnostics);
//   Draft draft(*project.Find("patrol.xml")->document, {node});
//   DeleteNodes(draft);
//   project.Do({"Delete Beep", {std::move(draft).Finish("patrol.xml")}}, {}, diagnostics);
//   project.Undo();
//   project.Save("patrol.xml", diagnostics);
//
// A change is made whole or not at all. Undoing gives the same bytes as before; saving an unchanged
// file writes nothing. Files may be malformed: they are kept as text, and changed as text.
#ifndef COPPICE_EDITOR_FILES_OPEN_PROJECT_H_
#define COPPICE_EDITOR_FILES_OPEN_PROJECT_H_

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bt_core/model/document.h"
#include "editor/files/change.h"
#include "editor/files/history.h"

namespace coppice::editor {

struct EditedFile {
  std::string path;
  std::string text;                  ///< as it is being edited
  std::optional<Document> document;  ///< of the text; nothing if that is malformed
  Diagnostics problems;              ///< of parsing it
  std::string saved;                 ///< what is on the disk, as far as known
  std::optional<std::string> other;  ///< what somebody else wrote there while the user edited
  bool is_new = false;               ///< it was never on the disk
  bool is_gone = false;              ///< somebody has removed it from there
  std::uint32_t version = 0;         ///< counts the changes of the text
  std::uint32_t saved_version = 0;   ///< and of what is saved

  bool is_dirty() const { return is_new || is_gone || !IsAsSaved(); }
  /// Would anything be lost without saving it? Not of a new file that nobody has touched.
  bool has_unsaved_work() const { return is_new ? version > 1 : is_dirty(); }

  std::filesystem::file_time_type time;  ///< of the file when it was read or written
  std::uintmax_t size = 0;

 private:
  // Compared once: every frame asks, and files have megabytes.
  bool IsAsSaved() const {
    const std::pair<std::uint32_t, std::uint32_t> versions{version, saved_version};
    if (compared_ != versions) is_as_saved_ = text == saved;
    compared_ = versions;
    return is_as_saved_;
  }

  mutable std::pair<std::uint32_t, std::uint32_t> compared_{UINT32_MAX, UINT32_MAX};
  mutable bool is_as_saved_ = false;
};

class OpenProject {
 public:
  /// The file of that path, read if it is not open yet; null if it cannot be read. The pointer is
  /// good for as long as the project.
  const EditedFile* Open(const std::string& path, Diagnostics& diagnostics);

  /// A file that is not on the disk yet.
  const EditedFile& Create(const std::string& path, std::string text);

  /// The open file of that path, or null.
  const EditedFile* Find(const std::string& path) const;

  const std::map<std::string, EditedFile>& files() const { return files_; }

  /// Makes a change; false if a result would be malformed, then nothing has changed. An empty
  /// change is no step of the history. `selected` is the selection before it.
  bool Do(NamedChange change, std::vector<FilePlace> selected, Diagnostics& diagnostics);

  /// Replaces the whole text of a file, which may be malformed: what is typed. With `join` it is
  /// one step with the last one, if that has the same name and is about the same file.
  void SetText(const std::string& path, std::string name, std::string text, bool join = false);

  /// Undoes or repeats a step; null if there is none. Its selected_before or selected_after is what
  /// was selected.
  const Step* Undo();
  const Step* Redo();
  const History& history() const { return history_; }

  /// Parses what the next Undo and Redo would have to parse, so that they are quick. False if there
  /// was nothing to parse.
  bool ReadAhead();

  /// Steps of an earlier time, which end with the texts as they are; they come before all others.
  void Remember(std::vector<Step> undo, std::vector<Step> redo);
  /// Goes on with a text that was not saved the last time, as if the editor had never ended.
  void Resume(const std::string& path, std::string text);

  /// Writes the file if it is dirty. False, with the reason, if it cannot be written, or if
  /// somebody else changed it in the meantime and `overwrite` is not given; then `other` is set.
  bool Save(const std::string& path, Diagnostics& diagnostics, bool overwrite = false);
  /// Writes it under another name, under which it is open from now on. The history stays.
  bool SaveAs(const std::string& path, const std::string& new_path, Diagnostics& diagnostics);

  /// Looks for files that were changed or removed by others. Those that the user has not changed
  /// are read again, and those where the changes do not meet are merged (merge.h), as a step that
  /// can be undone; the others get `other`, and those that are not there any more are `is_gone`.
  /// Returns the paths of all.
  std::vector<std::string> LookAtDisk();

  /// Ends the disagreement with the disk: the text of the other side becomes the file's text, or
  /// what it holds becomes known and the next save overwrites it.
  void TakeTheirs(const std::string& path);
  /// Merges. Where both changed the same place the user's stays, or theirs if it says so for this
  /// conflict of MergeTexts (merge.h). Returns how many conflicts there are, or -1 if the result
  /// would be malformed: then nothing has changed.
  int MergeTheirs(const std::string& path, const std::vector<bool>& theirs = {});
  void KeepMine(const std::string& path);

  /// Counts all changes of all files.
  std::uint64_t version() const { return version_; }

 private:
  EditedFile* Get(const std::string& path);
  static void Know(EditedFile& file, std::string saved);
  void Replace(EditedFile& file, std::string text, std::optional<Document> document);
  void Run(std::size_t step, bool forward);
  bool ReadAhead(std::size_t step, bool forward);
  const Step* LastOf(const std::string& path, const std::string& name) const;

  std::map<std::string, EditedFile> files_;
  History history_;
  std::uint64_t version_ = 0;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_OPEN_PROJECT_H_
