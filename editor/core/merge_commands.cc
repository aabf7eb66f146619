#include "editor/core/merge_commands.h"

#include <memory>
#include <utility>
#include <vector>

#include "editor/document/merge.h"

namespace coppice::editor {
namespace {

// For each conflict whether theirs is taken.
using Choices = std::shared_ptr<std::vector<bool>>;

std::string InOneLine(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool blank = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!blank) line += c;
    if (blank && !line.empty() && line.back() != ' ') line += ' ';
  }
  return line.empty() ? "(nothing)" : line;
}

std::vector<Choice> RowsOf(const std::vector<MergeConflict>& conflicts, const Choices& theirs) {
  std::vector<Choice> rows;
  for (std::size_t i = 0; i < conflicts.size(); ++i) {
    const bool takes_theirs = (*theirs)[i];
    const std::string& stays = takes_theirs ? conflicts[i].theirs : conflicts[i].mine;
    const std::string& goes = takes_theirs ? conflicts[i].mine : conflicts[i].theirs;
    Choice row;
    row.kind = takes_theirs ? "theirs" : "mine";
    row.title = InOneLine(stays);
    row.note = (takes_theirs ? "mine goes: " : "theirs goes: ") + InOneLine(goes);
    row.run = [theirs, i] { (*theirs)[i] = !(*theirs)[i]; };
    rows.push_back(std::move(row));
  }
  return rows;
}

void Resolve(EditorState& state, const std::function<double()>& now) {
  const std::string path = DisputedFile(state);
  if (path.empty()) return state.Notify("nobody else has changed what you have", now(), true);
  const EditedFile& file = *state.workspace.project().Find(path);
  const std::vector<MergeConflict> conflicts =
      MergeTexts(file.saved, file.text, *file.other).conflicts;
  const auto theirs = std::make_shared<std::vector<bool>>(conflicts.size(), false);
  const std::string name = path.substr(path.rfind('/') + 1);
  state.Ask({name +
                 " was changed by somebody else too: a click on a place, or Space, changes whose "
                 "stays; Enter merges",
             [&state, now, path, theirs](const std::string&) -> std::string {
               if (state.workspace.project().MergeTheirs(path, *theirs) < 0) {
                 return "this would give malformed XML: choose otherwise, or take theirs (Ctrl+P)";
               }
               state.workspace.Refresh(now());
               state.Notify("Merged; Ctrl+S saves it", now());
               return {};
             },
             [conflicts, theirs](const std::string&) { return RowsOf(conflicts, theirs); }, false});
}

}  // namespace

std::string DisputedFile(const EditorState& state) {
  for (const auto& [path, file] : state.workspace.project().files()) {
    if (file.other) return path;
  }
  return {};
}

void AddMergeCommands(EditorState& state, std::function<double()> now) {
  state.commands.Add({"file.resolve",
                      "Resolve what somebody else has changed too",
                      {},
                      [&state, now = std::move(now)] { Resolve(state, now); }});
}

}  // namespace coppice::editor
