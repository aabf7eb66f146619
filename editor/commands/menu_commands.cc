#include "editor/commands/menu_commands.h"

#include <algorithm>
#include <string>
#include <utility>

#include "bt_core/data/value_bytes.h"
#include "editor/commands/menus.h"
#include "editor/keys/fuzzy.h"
#include "editor/live/key_item.h"
#include "editor/workspace/canvas_tabs.h"
#include "editor/workspace/tree_editor.h"

namespace coppice::editor {
namespace {

// What a right click at the selection would open.
void OpenMenuHere(EditorState& state) {
  const TreeView* view = state.workspace.view();
  if (!view || view->selected() == kNoSceneNode) {
    return OpenMenuBelow(state, menu::kCanvas, "canvas");
  }
  const Scene& scene = *view->scene();
  OpenMenuBelow(state, menu::kNode,
                "canvas/" + scene.tree_id + "/" + scene.nodes[view->selected()].path);
}

void OpenAdd(EditorState& state, int held) {
  const Outcome can = TreeEditor(state, state.now).CanEdit();
  if (!can) return state.Notify(can.problem(), state.now, true);
  state.OpenPopup(Popup::kAdd);
  state.popup.held = held;
}

void CloseOtherTabs(EditorState& state) {
  const std::size_t shown = ShownTab(state);
  if (shown < state.canvas.tabs.size()) state.canvas.tabs = {state.canvas.tabs[shown]};
}

std::string ShownKey(const EditorState& state) {
  const std::string& path = state.blackboard.shown_key;
  return path.substr(path.rfind('/') + 1);
}

void CopyValue(EditorState& state) {
  const RunView* run = state.workspace.run();
  if (!run || !run->tree()) return;
  const std::optional<SlotIndex> key =
      KeyOfItem(*run->tree()->description(), state.blackboard.shown_key);
  const auto& values = run->follower().values();
  if (key && *key < values.size()) state.services.set_clipboard(PrintValueBytes(values[*key]));
}

void OfferRecent(EditorState& state) {
  state.Offer({"Recent files", [&state](const std::string& typed) {
                 std::vector<Choice> rows;
                 for (const std::string& path : state.recent.files) {
                   Choice row;
                   row.title = path;
                   row.run = [&state, path] { state.services.open_file(path); };
                   if (FuzzyScore(typed, path) > 0) rows.push_back(std::move(row));
                 }
                 return rows;
               }});
}

// Each with its note, and with what is done when it is chosen.
void ListRobots(EditorState& state, const char* hint,
                std::function<std::vector<OfferedRobot>()> robots,
                std::function<void(const std::string& endpoint)> run) {
  state.Offer({hint, [robots = std::move(robots), run = std::move(run)](const std::string& typed) {
                 std::vector<Choice> rows;
                 for (const OfferedRobot& robot : robots()) {
                   if (FuzzyScore(typed, robot.endpoint + " " + robot.note) == 0) continue;
                   Choice row;
                   row.title = robot.endpoint;
                   row.note = robot.note;
                   row.kind = robot.word();
                   row.run = [run, endpoint = robot.endpoint] { run(endpoint); };
                   rows.push_back(std::move(row));
                 }
                 return rows;
               }});
}

void OfferToConnect(EditorState& state) {
  ListRobots(
      state, "Connect to a robot that was met before, or that the network tells of",
      [&state] { return state.OfferedRobots(); },
      [&state](const std::string& endpoint) { state.Connect(endpoint); });
}

void OfferToForget(EditorState& state) {
  ListRobots(
      state, "Forget a robot",
      [&state] { return OfferRobots(state.recent.robots, {}, state.services.date()); },
      [&state](const std::string& endpoint) { ForgetRobot(state.recent.robots, endpoint); });
}

}  // namespace

void AddMenuCommands(EditorState& state) {
  EditorState& s = state;
  CommandTable& commands = state.commands;
  commands.Add(
      {"menu.bar", "Menus", {kKeyF1 + 9}, [&s] { OpenMenuBelow(s, "file", "menu/file"); }});
  commands.Add(
      {"menu.here", "Menu of the selection", {kKeyF1 + 9, kShift}, [&s] { OpenMenuHere(s); }});
  commands.AddKeys("menu.here", {kKeyMenu});
  commands.Add({"edit.add_after", "Add node after", {}, [&s] { OpenAdd(s, kShift); }});
  commands.Add({"edit.add_around", "Add node around", {}, [&s] { OpenAdd(s, kCtrl); }});
  commands.Add({"tab.close_others", "Close all other tabs", {}, [&s] { CloseOtherTabs(s); }});
  commands.Add({"key.copy", "Copy the name of the key", {}, [&s] {
                  s.services.set_clipboard(ShownKey(s));
                }});
  commands.Add({"key.copy_value", "Copy the value of the key", {}, [&s] { CopyValue(s); }});
  commands.Add({"robot.known", "Robots", {}, [&s] { OfferToConnect(s); }});
  commands.Add({"robot.forget", "Forget a robot", {}, [&s] { OfferToForget(s); }});
  commands.Add({"file.recent", "Recent files", {}, [&s] { OfferRecent(s); }});
}

}  // namespace coppice::editor
