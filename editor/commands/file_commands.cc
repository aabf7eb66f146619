#include "editor/commands/file_commands.h"

#include <utility>

#include "editor/workspace/file_dialog.h"
#include "editor/workspace/file_keeper.h"
#include "editor/workspace/tree_editor.h"

namespace coppice::editor {
namespace {

class FileCommands {
 public:
  explicit FileCommands(EditorState& state) : state_(state) {}

  void AddAll() {
    EditorState& s = state_;
    Add("file.open", "Open file", {'O', kCtrl}, [&s] { OpenFileDialog(s); });
    Add("file.reload", "Reload file", {'R', kCtrl}, [&s] { s.workspace.Reload(s.now); });
    Add("file.new", "New file", {'N', kCtrl}, [&s] { s.workspace.New(s.now); });
    Add("file.save", "Save", {'S', kCtrl}, [&s] { FileKeeper(s, s.now).Save(); });
    Add("file.save_as", "Save as", {'S', kCtrl | kShift}, [&s] { FileKeeper(s, s.now).AskPath(); });
    Add("file.save_over", "Overwrite what somebody else wrote", {},
        [&s] { FileKeeper(s, s.now).Save(true); });
    Add("file.merge", "Merge what somebody else wrote, keeping mine where both changed", {},
        [&s] { TreeEditor(s, s.now).MergeTheirs(); });
    Add("file.take_theirs", "Take what somebody else wrote", {},
        [&s] { TreeEditor(s, s.now).TakeTheirs(); });
    Add("file.quit", "Quit", {'Q', kCtrl}, [&s] { FileKeeper(s, s.now).Quit(); });
    AddUnsaved();
  }

 private:
  void Add(std::string id, std::string title, KeyChord keys, std::function<void()> run) {
    state_.commands.Add({std::move(id), std::move(title), keys, std::move(run)});
  }

  void AddUnsaved() {
    AddAboutOffered("file.restore", "Restore unsaved work",
                    [](FileKeeper& keeper, const UnsavedCopy& copy) { keeper.Restore(copy); });
    AddAboutOffered("file.forget", "Forget the unsaved work of the last session",
                    [](FileKeeper& keeper, const UnsavedCopy& copy) { keeper.Forget(copy); });
    Add("file.unsaved", "Unsaved work of earlier sessions", {},
        [&s = state_] { FileKeeper(s, s.now).OfferAll(); });
  }

  using Answer = std::function<void(FileKeeper&, const UnsavedCopy&)>;
  void AddAboutOffered(std::string id, std::string title, Answer answer) {
    Add(std::move(id), std::move(title), {}, [&s = state_, answer = std::move(answer)] {
      FileKeeper keeper(s, s.now);
      const UnsavedCopy* const copy = keeper.Offered();
      if (!copy) return s.Notify("everything was saved in the last session", s.now, true);
      answer(keeper, UnsavedCopy(*copy));
    });
  }

  EditorState& state_;
};

}  // namespace

void AddFileCommands(EditorState& state) { FileCommands(state).AddAll(); }

}  // namespace coppice::editor
