// Choosing a file, to open it or to save one: what the dialog lists and what its keys do. Without
// ImGui; panels/popup/file_rows draws it.
//
//   OpenFileDialog(state);                      // trees, records, HOST:PORT of robots
//   OpenSaveDialog(state, "Save a under a name", "a.xml", save);
//
// What is typed is a path, seen from the shown folder: its folder is listed, and the last part
// searched in it.
#ifndef COPPICE_EDITOR_WORKSPACE_FILE_DIALOG_H_
#define COPPICE_EDITOR_WORKSPACE_FILE_DIALOG_H_

#include <functional>
#include <string>
#include <vector>

#include "editor/workspace/editor_state.h"

namespace coppice::editor {

enum class FileRowKind { kFolder, kFile, kRobot };

struct FileRow {
  FileRowKind kind = FileRowKind::kFile;
  std::string title;
  std::string path;  ///< what it opens
  std::string word;  ///< what it is: "folder", "tree", "record", "recent", "example"
};

void OpenFileDialog(EditorState& state);

/// HOST:PORT is asked for: it begins with the robot that was met last.
void OpenConnectDialog(EditorState& state);

/// `save` is asked with the path; with a problem the dialog stays.
void OpenSaveDialog(EditorState& state, std::string hint, const std::string& path,
                    std::function<Outcome(const std::string&)> save);

/// For a file that is not opened itself: listed is the folder of the shown one. `use` as `save`.
void OpenPickDialog(EditorState& state, std::string hint,
                    std::function<Outcome(const std::string&)> use);

/// A problem the first time if there is a file of that name; said once more, it may be replaced.
Outcome MayReplace(EditorState& state, const std::string& path);

/// What is above the rows: the folder that is listed.
std::string ShownFolder(const EditorState& state);

/// What fits what is typed, best first, and folders before files. Without anything typed also
/// recent files, their folders, and examples. Reads the folder at most once a second.
std::vector<FileRow> FileRows(EditorState& state);

/// Tab completes, Enter opens or saves, Backspace and Left without anything typed go up.
void PressInFileDialog(EditorState& state, const std::vector<FileRow>& rows, KeyEvent key);

/// Opens the row: a folder is listed, a file or robot opened, a name to save under taken over.
void ChooseFile(EditorState& state, const FileRow& row);

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_FILE_DIALOG_H_
