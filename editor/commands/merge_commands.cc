#include "editor/commands/merge_commands.h"

#include <memory>
#include <utility>
#include <vector>

#include "editor/files/merge.h"

namespace coppice::editor {
namespace {

// What the user decides, and about what.
struct Dispute {
  std::string path;
  std::string before, mine, theirs;  // of the whole file
  std::vector<MergeConflict> conflicts;
  std::vector<bool> takes_theirs;  // for each conflict
};

std::string InOneLine(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!blank) line += c;
    if (blank && !line.empty() && line.back() != ' ') line += ' ';
  }
  return line.empty() ? "(nothing)" : line;
}

// The file, if it still waits for the user's word.
const EditedFile* Disputed(const EditorState& state, const std::string& path) {
  const EditedFile* const file = state.workspace.project().Find(path);
  return file && file->other ? file : nullptr;
}

// Both sides may go on writing while the user decides. True if there are places about which nothing
// is decided yet.
bool HasNewPlaces(const EditedFile& file, Dispute& dispute) {
  const bool same =
      file.saved == dispute.before && file.text == dispute.mine && *file.other == dispute.theirs;
  if (same) return false;
  dispute = {dispute.path, file.saved, file.text, *file.other, {}, {}};
  dispute.conflicts = MergeTexts(dispute.before, dispute.mine, dispute.theirs).conflicts;
  dispute.takes_theirs.assign(dispute.conflicts.size(), false);
  return !dispute.conflicts.empty();
}

std::vector<Choice> RowsOf(const std::shared_ptr<Dispute>& dispute) {
  std::vector<Choice> rows;
  for (std::size_t i = 0; i < dispute->conflicts.size(); ++i) {
    const MergeConflict& conflict = dispute->conflicts[i];
    const bool takes_theirs = dispute->takes_theirs[i];
    const std::string& stays = takes_theirs ? conflict.theirs : conflict.mine;
    const std::string& goes = takes_theirs ? conflict.mine : conflict.theirs;
    Choice row;
    row.kind = takes_theirs ? "theirs" : "mine";
    row.title = InOneLine(stays);
    row.note = (takes_theirs ? "mine goes: " : "theirs goes: ") + InOneLine(goes);
    row.run = [dispute, i] { dispute->takes_theirs[i] = !dispute->takes_theirs[i]; };
    rows.push_back(std::move(row));
  }
  return rows;
}

Outcome Merge(EditorState& state, Dispute& dispute, double now) {
  const EditedFile* const file = Disputed(state, dispute.path);
  if (!file) {
    state.Notify("this is settled already", now);
    return {};
  }
  if (HasNewPlaces(*file, dispute))
    return Problem{"it was changed again meanwhile: look at it once more"};
  if (state.workspace.project().MergeTheirs(dispute.path, dispute.takes_theirs) < 0) {
    return Problem{"this would give malformed XML: choose otherwise, or take theirs (Ctrl+P)"};
  }
  state.workspace.Refresh(now);
  state.Notify("Merged; Ctrl+S saves it", now);
  return {};
}

void Resolve(EditorState& state) {
  const auto dispute = std::make_shared<Dispute>();
  dispute->path = DisputedFile(state);
  if (dispute->path.empty()) {
    return state.Notify("nobody else has changed this file", state.now, true);
  }
  HasNewPlaces(*Disputed(state, dispute->path), *dispute);
  const std::string name = dispute->path.substr(dispute->path.rfind('/') + 1);
  state.Ask({name +
                 " was changed by somebody else too: a click on a place, or Space, changes whose "
                 "stays; Enter merges",
             [&state, dispute](const std::string&) { return Merge(state, *dispute, state.now); },
             [dispute](const std::string&) { return RowsOf(dispute); }, false});
}

}  // namespace

std::string DisputedFile(const EditorState& state) {
  for (const auto& [path, file] : state.workspace.project().files()) {
    if (file.other) return path;
  }
  return {};
}

void AddMergeCommands(EditorState& state) {
  state.commands.Add({"file.resolve", "Resolve what somebody else has changed too", {}, [&state] {
                        Resolve(state);
                      }});
}

}  // namespace coppice::editor
