#include "editor/workspace/file_dialog.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <utility>

#include "editor/files/examples.h"
#include "editor/keys/fuzzy.h"
#include "editor/live/record_source.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

constexpr double kFresh = 1;  // seconds for which a listing holds
constexpr std::size_t kMostFolders = 3;
constexpr int kBelowUp = 1;  // the first row is the way up

bool IsThere(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error);
}

bool IsFolder(const std::string& path) {
  std::error_code error;
  return fs::is_directory(path.empty() ? "." : path, error);
}

bool EndsWith(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// HOST:PORT or HOST:PORT/TREE.
bool IsEndpoint(const std::string& text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string::npos || colon == 0 || text.find('/') < colon) return false;
  const std::size_t end = std::min(text.find('/', colon), text.size());
  return end > colon + 1 && std::all_of(text.begin() + static_cast<std::ptrdiff_t>(colon) + 1,
                                        text.begin() + static_cast<std::ptrdiff_t>(end),
                                        [](unsigned char c) { return std::isdigit(c) != 0; });
}

// What was typed as a path on the disk: "~/a" is in the home folder, "a" in the shown one.
std::string Resolved(const std::string& folder, const std::string& typed) {
  const char* const home = std::getenv("HOME");
  if (typed.rfind("~/", 0) == 0 && home) return home + typed.substr(1);
  if (typed.empty()) return folder;
  return (fs::path(folder) / typed).string();
}

// The folder that is typed into, and what is searched in it.
std::pair<std::string, std::string> Split(const EditorState& state) {
  const std::string& typed = state.popup.text;
  const std::size_t slash = typed.rfind('/');
  if (slash == std::string::npos) return {state.popup.files.folder, typed};
  return {Resolved(state.popup.files.folder, typed.substr(0, slash + 1)), typed.substr(slash + 1)};
}

const Folder& Listed(EditorState& state, const std::string& path) {
  FileDialog& dialog = state.popup.files;
  if (dialog.listed_at < 0 || dialog.listed.path != path || state.now - dialog.listed_at > kFresh) {
    dialog.listed = ReadFolder(path);
    dialog.listed_at = state.now;
  }
  return dialog.listed;
}

bool IsForUs(const std::string& name) { return EndsWith(name, ".xml") || IsRecordName(name); }

FileRow RowOf(const std::string& folder, const FolderEntry& entry) {
  FileRow row;
  row.kind = entry.is_folder ? FileRowKind::kFolder : FileRowKind::kFile;
  row.title = entry.is_folder ? entry.name + "/" : entry.name;
  row.path = (fs::path(folder) / entry.name).string();
  row.word = entry.is_folder ? "folder" : IsRecordName(entry.name) ? "record" : "tree";
  return row;
}

void AddEntries(const Folder& folder, const std::string& typed, std::vector<FileRow>& rows) {
  struct Found {
    int score;
    const FolderEntry* entry;
  };
  std::vector<Found> found;
  for (const FolderEntry& entry : folder.entries) {
    const bool hidden = entry.name[0] == '.' && typed.rfind('.', 0) != 0;
    const int score = FuzzyScore(typed, entry.name);
    const bool wanted = entry.is_folder || IsForUs(entry.name) || entry.name == typed;
    if (!hidden && score > 0 && wanted) found.push_back({score, &entry});
  }
  std::stable_sort(found.begin(), found.end(), [](const Found& a, const Found& b) {
    if (a.entry->is_folder != b.entry->is_folder) return a.entry->is_folder;
    return a.score > b.score;
  });
  for (const Found& one : found) rows.push_back(RowOf(folder.path, *one.entry));
}

// Recent files that are still there, their folders, robots, and the examples.
void AddKnown(EditorState& state, std::vector<FileRow>& rows) {
  const std::size_t first = rows.size();
  std::vector<std::string> folders;
  for (const std::string& path : state.recent.files) {
    if (!state.paths.IsThere(path, state.now)) continue;
    rows.push_back({FileRowKind::kFile, path, path, "recent"});
    folders.push_back(fs::path(path).parent_path().string());
  }
  std::size_t count = 0;
  for (auto folder = folders.begin(); folder != folders.end() && count < kMostFolders; ++folder) {
    if (std::find(folders.begin(), folder, *folder) != folder) continue;
    rows.push_back({FileRowKind::kFolder, *folder + "/", *folder, "project"});
    ++count;
  }
  for (const OfferedRobot& robot : state.OfferedRobots()) {
    rows.push_back({FileRowKind::kRobot, robot.endpoint, robot.endpoint, robot.word()});
  }
  for (const Example& example : Examples()) {
    rows.push_back({FileRowKind::kFile, example.title, example.path, "example"});
  }
  rows.erase(std::remove_if(
                 rows.begin() + static_cast<std::ptrdiff_t>(first), rows.end(),
                 [&](const FileRow& row) { return FuzzyScore(state.popup.text, row.title) == 0; }),
             rows.end());
}

void SetText(EditorState& state, std::string text) {
  state.popup.text = text;
  state.popup.choice = text.empty() ? kBelowUp : 0;
  state.popup.new_text = std::move(text);
  state.popup.error.clear();
  state.popup.files.walked = false;
}

void ShowFolder(EditorState& state, const std::string& path) {
  const Folder folder = ReadFolder(path);
  if (!folder.problem.empty()) {
    state.popup.error = path + ": " + folder.problem;
    return;
  }
  state.popup.files.folder = fs::path(path).lexically_normal().string();
  const bool saves = state.popup.files.save != nullptr;
  const std::string& text = state.popup.text;
  SetText(state, saves ? text.substr(text.rfind('/') + 1) : "");
}

void GoUp(EditorState& state) {
  std::error_code error;
  const fs::path here = fs::absolute(state.popup.files.folder, error).lexically_normal();
  const fs::path at = here.has_filename() ? here : here.parent_path();
  ShowFolder(state, at.parent_path().string());
}

void Complete(EditorState& state, const FileRow& row) {
  const std::string& typed = state.popup.text;
  const std::size_t slash = typed.rfind('/');
  const std::string before = slash == std::string::npos ? "" : typed.substr(0, slash + 1);
  const bool is_listed = row.word == "folder" || row.word == "tree" || row.word == "record";
  SetText(state, is_listed ? before + row.title : row.path);
}

std::string FolderOfShownFile(const EditorState& state) {
  const OpenFile* const shown = state.workspace.file();
  return shown ? fs::path(shown->path).parent_path().string() : "";
}

void Close(EditorState& state) { state.popup.kind = Popup::kNone; }

void Open(EditorState& state, const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error)) {
    state.popup.error = path + ": " + (error ? error.message() : "there is no such file");
  } else if (state.services.open_file(path)) {
    Close(state);
  } else {
    state.popup.error = "nothing to show in this file; see Problems";
  }
}

void Connect(EditorState& state, const std::string& endpoint) {
  const Outcome connected = state.services.connect(endpoint);
  state.popup.error = connected.problem();
  if (connected) Close(state);
}

// Closed before it is asked: saving may ask further.
void Save(EditorState& state) {
  const FileDialog dialog = state.popup.files;
  const std::string text = state.popup.text;
  Close(state);
  const Outcome saved = dialog.save(text.empty() ? "" : Resolved(dialog.folder, text));
  if (saved) return;
  state.popup.kind = Popup::kOpen;
  state.popup.error = saved.problem();
}

}  // namespace

void OpenFileDialog(EditorState& state) {
  state.OpenPopup(Popup::kOpen);
  state.popup.choice = kBelowUp;
  state.popup.files = {};
  state.popup.files.folder = FolderOfShownFile(state);
}

void OpenConnectDialog(EditorState& state) {
  const std::vector<KnownRobot>& known = state.recent.robots;
  state.OpenPopup(Popup::kConnect, known.empty() ? "127.0.0.1:1667" : known.front().endpoint);
  state.popup.files = {};
}

void OpenSaveDialog(EditorState& state, std::string hint, const std::string& path,
                    std::function<Outcome(const std::string&)> save) {
  state.OpenPopup(Popup::kOpen, fs::path(path).filename().string());
  state.popup.files = {};
  state.popup.files.folder = fs::path(path).parent_path().string();
  state.popup.files.hint = std::move(hint);
  state.popup.files.save = std::move(save);
}

void OpenPickDialog(EditorState& state, std::string hint,
                    std::function<Outcome(const std::string&)> use) {
  OpenSaveDialog(state, std::move(hint), (fs::path(FolderOfShownFile(state)) / "").string(),
                 std::move(use));
}

Outcome MayReplace(EditorState& state, const std::string& path) {
  std::error_code error;
  if (!fs::exists(path, error) || std::exchange(state.replaces, path) == path) return {};
  return Problem{"there is a file of that name already: Enter once more replaces it"};
}

std::string ShownFolder(const EditorState& state) {
  std::error_code error;
  fs::path folder = Split(state).first;
  if (folder.empty()) folder = ".";  // the one that the editor was started in
  return fs::absolute(folder, error).lexically_normal().string();
}

std::vector<FileRow> FileRows(EditorState& state) {
  const auto [folder, typed] = Split(state);
  const FileDialog& dialog = state.popup.files;
  std::vector<FileRow> rows;
  if (!dialog.save && IsEndpoint(state.popup.text)) {
    rows.push_back(
        {FileRowKind::kRobot, "connect to " + state.popup.text, state.popup.text, "robot"});
  }
  const Folder& listed = Listed(state, folder);
  if (!listed.problem.empty() && rows.empty()) {
    state.popup.error = ShownFolder(state) + ": " + listed.problem;
  }
  if (typed.empty() || dialog.save) {
    rows.push_back(
        {FileRowKind::kFolder, "../", (fs::path(ShownFolder(state)) / "..").string(), "folder"});
  }
  AddEntries(listed, dialog.save ? "" : typed, rows);
  if (state.popup.text.find('/') == std::string::npos && !dialog.save) AddKnown(state, rows);
  return rows;
}

void ChooseFile(EditorState& state, const FileRow& row) {
  if (row.kind == FileRowKind::kFolder) return ShowFolder(state, row.path);
  if (row.kind == FileRowKind::kRobot) return Connect(state, row.path);
  if (!state.popup.files.save) return Open(state, row.path);
  Complete(state, row);
}

void PressInFileDialog(EditorState& state, const std::vector<FileRow>& rows, KeyEvent key) {
  PopupState& popup = state.popup;
  const FileRow* const chosen = popup.choice >= 0 && popup.choice < static_cast<int>(rows.size())
                                    ? &rows[static_cast<std::size_t>(popup.choice)]
                                    : nullptr;
  switch (key.key) {
    case kKeyTab:
      if (chosen) Complete(state, *chosen);
      return;
    case kKeyUp:
    case kKeyDown:
      popup.files.walked = true;
      return;
    case kKeyLeft:
    case kKeyBackspace:
      if (popup.files.was_empty) GoUp(state);
      return;
    case kKeyEnter:
    case kKeyKeypadEnter:
      break;
    default:
      return;
  }
  if (popup.files.save && !popup.files.walked) {
    const std::string path = Resolved(popup.files.folder, popup.text);
    return !popup.text.empty() && IsFolder(path) ? ShowFolder(state, path) : Save(state);
  }
  const std::string typed = Resolved(popup.files.folder, popup.text);
  if (!popup.text.empty() && !popup.files.walked && IsThere(typed)) {
    return IsFolder(typed) ? ShowFolder(state, typed) : Open(state, typed);
  }
  if (chosen) return ChooseFile(state, *chosen);
  Open(state, typed);
}

}  // namespace coppice::editor
