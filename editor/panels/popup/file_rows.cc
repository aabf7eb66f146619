#include "editor/panels/popup/file_rows.h"

#include <algorithm>

#include "editor/panels/popup/popup_rows.h"
#include "editor/workspace/file_dialog.h"

namespace coppice::editor {

std::string FileHint(const EditorState& state) {
  const FileDialog& dialog = state.popup.files;
  const std::string what =
      dialog.save ? dialog.hint : "Open a tree, a record, or HOST:PORT of a robot";
  return what + "   in " + ShownFolder(state) + "   (Tab completes, Backspace goes up)";
}

void DrawFileRows(const Ui& ui, EditorState& state) {
  const std::vector<FileRow> rows = FileRows(state);
  state.popup.rows = std::max<std::size_t>(rows.size(), 1);
  const FileRow* clicked = nullptr;
  {
    const bool has_choice = !state.popup.files.save || state.popup.files.walked;
    PopupRows list(ui, state, rows.size(), has_choice);
    for (const FileRow& row : rows) {
      if (list.Next(row.title, "", row.word)) clicked = &row;
    }
  }
  if (clicked) return ChooseFile(state, *clicked);
  const std::vector<KeyEvent> keys = state.input.keys;
  for (const KeyEvent& key : keys) {
    if (state.popup.kind == Popup::kOpen) PressInFileDialog(state, rows, key);
  }
}

}  // namespace coppice::editor
