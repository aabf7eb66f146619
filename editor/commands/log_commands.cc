#include "editor/commands/log_commands.h"

#include <string>
#include <utility>

#include "editor/commands/run_commands.h"

namespace coppice::editor {
namespace {

constexpr char kHint[] =
    "words with {port} or {key}, and if you like: if battery < 20 #3  (from the third hit on)";

void AskForNewLogPoint(EditorState& state, double now) {
  const RunView* run = state.workspace.run();
  LogPoint point;
  point.path = SelectedRunPath(state);
  if (run && run->source().is_robot()) point.run = run->name();
  if (point.path.empty()) return state.Notify("Select a node first", now, true);
  if (const LogPoint* there = state.workspace.log_points.FindAt(point.run, point.path)) {
    return AskForLogPoint(state, there->number);
  }
  state.Ask({kHint,
             [&state, point](const std::string& typed) {
               LogPoint read = point;
               Outcome is_read = ReadLogPoint(typed, read);
               if (!is_read) return is_read;
               state.workspace.log_points.Add(std::move(read));
               state.run.tab = RunTab::kLog;
               return is_read;
             },
             {}});
}

void PinSelected(EditorState& state, double now) {
  const RunView* run = state.workspace.run();
  const std::string path = SelectedRunPath(state);
  if (!run || path.empty()) return state.Notify("Select a node of a run first", now, true);
  state.workspace.pins.Toggle(run->bookmark_name(), path);
}

}  // namespace

void AskForLogPoint(EditorState& state, std::uint32_t number) {
  for (const LogPoint& point : state.workspace.log_points.all()) {
    if (point.number != number) continue;
    state.Ask({kHint,
               [&state, point](const std::string& typed) {
                 LogPoint read = point;
                 Outcome is_read = ReadLogPoint(typed, read);
                 if (is_read) state.workspace.log_points.Change(point.number, std::move(read));
                 return is_read;
               },
               {}},
              ToString(point));
    return;
  }
}

void AddLogCommands(EditorState& state) {
  state.commands.Add(
      {"run.log_point", "Log-point at the node", {kKeyF1 + 8, kCtrl | kShift}, [&state] {
         AskForNewLogPoint(state, state.now);
       }});
  const auto has_run = [&state] { return state.workspace.run() != nullptr; };
  state.commands.Add(
      {"run.log", "Log", {'J'}, [&state] { state.run.tab = RunTab::kLog; }, has_run});
  state.commands.Add({"run.pin",
                      "Pin or unpin the lane of the node",
                      {'T'},
                      [&state] { PinSelected(state, state.now); },
                      has_run});
}

}  // namespace coppice::editor
