// Saving; and what is not saved: asked about before it would be lost, offered again after an editor
// ended with it.
//
//   FileKeeper(state, now).Save();
//   FileKeeper(state, now).Quit();       // asks if something is not saved
#ifndef COPPICE_EDITOR_WORKSPACE_FILE_KEEPER_H_
#define COPPICE_EDITOR_WORKSPACE_FILE_KEEPER_H_

#include <functional>
#include <string>
#include <vector>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

class FileKeeper {
 public:
  FileKeeper(EditorState& state, double now) : state_(state), now_(now) {}

  /// Saves all files. Asks for a path for those that have none, one after the other. `then` is
  /// called when all are saved, and not at all if one cannot be or the user does not want it.
  void Save(bool overwrite = false, const std::function<void()>& then = {});
  /// Asks for another path for the shown file.
  void AskPath();
  /// Saves a file under another path. One that is there already is replaced when it is asked for a
  /// second time.
  Outcome SaveAs(const std::string& path, const std::string& new_path);

  /// Ends the editor; asks before if something is not saved: save, discard, or go on.
  void Quit();
  /// The paths of files that are not saved.
  std::vector<std::string> Unsaved() const;

  /// Of what editors that ended have left: the newest that is about an open file, or null.
  const UnsavedCopy* Offered() const;
  /// What other living editors have not saved of an open file, or null.
  const UnsavedCopy* Elsewhere() const;
  /// Offers all that editors that ended have left.
  void OfferAll();
  /// Opens the file and puts the unsaved text into its place, as a step that can be undone.
  void Restore(UnsavedCopy copy);
  void Forget(const UnsavedCopy& copy) { state_.work.Forget(copy); }

  /// That path or, if there is such a file, the next free one: "a-2.xml".
  std::string FreePath(const std::string& wanted) const;

 private:
  void AskPath(const std::string& path, const std::function<void()>& then);
  std::string OpenPathOf(const UnsavedCopy& copy) const;

  EditorState& state_;
  const double now_;
};

/// "a moment ago", "5 minutes ago", "3 hours ago", "2 days ago".
std::string AgeOf(const UnsavedCopy& copy);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_FILE_KEEPER_H_
