#include "editor/commands/run_files.h"

#include <chrono>
#include <ctime>
#include <filesystem>
#include <iomanip>
#include <memory>
#include <sstream>
#include <utility>

#include "bt_core/analysis/formats/tree_file.h"
#include "bt_core/analysis/formats/write_record.h"
#include "bt_core/model/write_file.h"
#include "editor/workspace/file_dialog.h"
#include "editor/workspace/file_keeper.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

Outcome Write(const std::string& path, const std::string& bytes) {
  Diagnostics diagnostics;
  if (WriteFile(path, bytes, diagnostics)) return {};
  return Problem{path + " cannot be written: " + diagnostics.all().back().hint};
}

Outcome SaveRecord(EditorState& state, const std::string& path) {
  const RunView* run = state.workspace.run();
  if (!run || !run->run().has_tree()) return Problem{"nothing was received yet"};
  if (path.empty()) return Problem{"a record needs a name"};
  std::error_code error;
  if (fs::exists(path, error))
    return Problem{path + " is there already; a record is never overwritten"};
  Outcome written = Write(path, ToRecord(run->run().recording()));
  if (written) state.Notify("Saved " + path, state.now);
  return written;
}

Outcome SaveTree(EditorState& state, const TreeDescription& tree, const std::string& path) {
  if (path.empty()) return Problem{"a file needs a name"};
  if (Outcome may = MayReplace(state, path); !may) return may;
  Outcome written = Write(path, TreeFile(tree));
  if (!written) return written;
  state.Notify("Saved " + path, state.now);
  state.services.open_file(path);
  return {};
}

// Beside the record, or beside the file that is being edited.
fs::path FolderFor(EditorState& state, const RunView& run) {
  const OpenFile* const file = state.workspace.file();
  if (!run.source().is_robot()) return fs::path(run.name()).parent_path();
  return file ? fs::path(file->path).parent_path() : fs::path();
}

// When the run began, as "_2026-11-23_21-30-05"; nothing on simulated time, which has no date.
std::string DateOf(Time start) {
  constexpr std::time_t kYear2000 = 946684800;
  const auto seconds = static_cast<std::time_t>(
      std::chrono::duration_cast<std::chrono::seconds>(start.time_since_epoch()).count());
  if (seconds < kYear2000) return {};
  std::tm local{};
  localtime_r(&seconds, &local);
  std::ostringstream text;
  text << std::put_time(&local, "_%Y-%m-%d_%H-%M-%S");
  return text.str();
}

std::string NameOfRecord(const RunView& run) {
  if (!run.run().has_tree()) return "run.coppice";
  const Recording& recording = run.run().recording();
  const fs::path tree(recording.trees().front().main_tree);
  return tree.filename().string() + DateOf(recording.start()) + ".coppice";
}

void AskForTree(EditorState& state) {
  const RunView* const run = state.workspace.run();
  if (!run || !run->tree()) return state.Notify("no tree was received yet", state.now, true);
  const std::shared_ptr<const TreeDescription> tree = run->tree()->description();
  const std::string name = fs::path(tree->main_tree).filename().string() + ".xml";
  state.replaces.clear();
  OpenSaveDialog(state, "Save the tree of " + run->name() + " under a name",
                 (FolderFor(state, *run) / name).string(),
                 [&state, tree](const std::string& path) { return SaveTree(state, *tree, path); });
}

void AskForRecord(EditorState& state) {
  const RunView* const run = state.workspace.run();
  const std::string wanted = (FolderFor(state, *run) / NameOfRecord(*run)).string();
  OpenSaveDialog(state, "Save what was received from " + run->name() + " as a record",
                 FileKeeper(state, state.now).FreePath(wanted),
                 [&state](const std::string& path) { return SaveRecord(state, path); });
}

}  // namespace

void AddRunFileCommands(EditorState& state) {
  const auto is_run = [&state] { return state.workspace.run() != nullptr; };
  state.commands.Add({"run.save",
                      "Save what was received as a record",
                      {'S', kCtrl | kAlt},
                      [&state, is_run] {
                        if (is_run()) AskForRecord(state);
                      },
                      is_run});
  state.commands.Add({"run.save_tree",
                      "Save the tree of the robot or record",
                      {'S', kCtrl | kAlt | kShift},
                      [&state] { AskForTree(state); },
                      is_run});
}

}  // namespace coppice::editor
