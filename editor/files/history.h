// What was done, so that it can be undone and done again: without limit, and across files. A step
// costs the bytes that it changed, in both directions. The steps next to what is shown keep their
// documents as well, so that undoing them parses nothing.
#ifndef COPPICE_EDITOR_FILES_HISTORY_H_
#define COPPICE_EDITOR_FILES_HISTORY_H_

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "editor/files/change.h"

namespace coppice::editor {

/// How one file changed.
struct FileStep {
  std::string path;
  std::vector<Edit> forward;
  std::vector<Edit> back;
  std::optional<Document> before;  ///< if it is kept
  std::optional<Document> after;
};

struct Step {
  std::string name;
  std::vector<FileStep> files;
  std::vector<FilePlace> selected_before;
  std::vector<FilePlace> selected_after;
};

class History {
 public:
  /// Adds a step that was done; what was undone is forgotten.
  void Add(Step step);

  /// Forgets the step that was done last; it becomes part of the next.
  void DropLast() {
    steps_.pop_back();
    --done_;
  }

  /// The step to undo, or null. Moves back over it.
  const Step* TakeUndo();
  /// The step to do again, or null. Moves over it.
  const Step* TakeRedo();

  /// Puts steps of an earlier time in front: `undo` before all others. `redo` can be done again if
  /// there is nothing else.
  void Prepend(std::vector<Step> undo, std::vector<Step> redo);

  /// Keeps the documents of a step again, which was forgotten.
  void Keep(std::size_t step, std::size_t file, std::optional<Document> before,
            std::optional<Document> after);

  /// A file has another name from now on.
  void Rename(const std::string& path, const std::string& new_path);

  const std::vector<Step>& steps() const { return steps_; }
  /// So many of the steps are done; those behind are undone.
  std::size_t done() const { return done_; }

  /// What TakeUndo and TakeRedo would give.
  const Step* undo() const { return done_ > 0 ? &steps_[done_ - 1] : nullptr; }
  const Step* redo() const { return done_ < steps_.size() ? &steps_[done_] : nullptr; }

 private:
  void ForgetDocuments(std::size_t step);

  std::vector<Step> steps_;
  std::size_t done_ = 0;
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_FILES_HISTORY_H_
