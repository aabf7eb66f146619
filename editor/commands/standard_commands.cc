#include "editor/commands/standard_commands.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/commands/menus.h"
#include "editor/theme/scale.h"
#include "editor/workspace/canvas_tabs.h"
#include "editor/workspace/file_dialog.h"

namespace coppice::editor {
namespace {

enum class Way { kParent, kChild, kNext, kPrevious };

std::uint32_t Neighbour(const Scene& scene, const TreeView& view, std::uint32_t node, Way way) {
  const auto& nodes = scene.nodes;
  const std::uint32_t parent = nodes[node].parent;
  switch (way) {
    case Way::kParent:
      return parent;
    case Way::kChild:
      return scene.HasChildren(node) && !view.IsCollapsed(node) ? node + 1 : kNoSceneNode;
    case Way::kNext:
      return parent != kNoSceneNode && nodes[node].end < nodes[parent].end ? nodes[node].end
                                                                           : kNoSceneNode;
    case Way::kPrevious: {
      if (parent == kNoSceneNode || node == parent + 1) return kNoSceneNode;
      std::uint32_t before = parent + 1;
      while (nodes[before].end != node) before = nodes[before].end;
      return before;
    }
  }
  return kNoSceneNode;
}

class Commands {
 public:
  explicit Commands(EditorState& state) : state_(state) {}

  void AddAll() {
    AddView();
    AddTree();
    AddTiles();
    Add("robot.connect", "Connect to a robot", {'K', kCtrl},
        [&s = state_] { OpenConnectDialog(s); });
    AddSwitch(
        "robot.search", "Look for robots on the network", {},
        [&s = state_] { s.screen.finds_robots = !s.screen.finds_robots; },
        [&s = state_] { return s.screen.finds_robots; });
    Add("robot.next", "Next robot or record", {kKeyTab, kCtrl},
        [&s = state_] { s.workspace.ShowNextRun(); });
    Add("help.palette", "Command palette", {'P', kCtrl},
        [&s = state_] { s.OpenPopup(Popup::kPalette); });
    Add("help.keys", "Keys of all commands", {kKeyF1},
        [&s = state_] { s.OpenPopup(Popup::kKeys); });
  }

 private:
  void Add(std::string id, std::string title, KeyChord keys, std::function<void()> run) {
    state_.commands.Add({std::move(id), std::move(title), keys, std::move(run)});
  }

  void AddSwitch(std::string id, std::string title, KeyChord keys, std::function<void()> run,
                 std::function<bool()> is_on) {
    state_.commands.Add(
        {std::move(id), std::move(title), keys, std::move(run), nullptr, {}, std::move(is_on)});
  }

  // A command that needs a tree.
  void AddForView(std::string id, std::string title, KeyChord keys,
                  std::function<void(TreeView&)> run) {
    Add(std::move(id), std::move(title), keys, [&s = state_, run = std::move(run)] {
      if (TreeView* view = s.workspace.view()) run(*view);
    });
  }

  void AddView() {
    AddForView("view.fit_all", "Fit all", {kKeyHome},
               [&s = state_](TreeView& view) { view.FitAll(s.screen.canvas_size); });
    AddForView("view.fit_selection", "Fit selection", {kKeyPeriod},
               [&s = state_](TreeView& view) { view.FitSelection(s.screen.canvas_size); });
    AddForView("view.zoom_100", "Zoom to 100 %", {'Z'}, [&s = state_](TreeView& view) {
      view.ZoomAt(s.screen.canvas_size * 0.5F, view.screen_scale() / view.camera.zoom);
    });
    AddGrowth("view.grow_by_itself", "Down or across, as it can be read", Growth::kByItself);
    AddGrowth("view.top_to_bottom", "Top to bottom", Growth::kDown);
    AddGrowth("view.left_to_right", "Left to right", Growth::kAcross);
    AddToggle("view.compact", "Decorators lie on their children", &LayoutStyle::compact);
    AddToggle("view.layered", "All nodes of a depth on one line", &LayoutStyle::layered);
    AddToggle("view.stacked", "Many leaves stand in a column", &LayoutStyle::stacked);
    AddToggle("view.wrapped", "Trees that do not fit stand in rows", &LayoutStyle::wrapped);
    AddPorts("view.ports_by_itself", "Ports where they can be read", ShownPorts::kByItself);
    AddPorts("view.ports_all", "All ports", ShownPorts::kAll);
    AddPorts("view.ports_none", "Names only", ShownPorts::kNone);
    AddTabs();
    AddPalette("palette.dark", "Dark colours", PaletteName::kDark);
    AddPalette("palette.light", "Light colours", PaletteName::kLight);
    AddPalette("palette.colourblind", "Colour-blind colours", PaletteName::kColourBlind);
    AddScales();
    AddSwitch(
        "view.wheel_zooms", "The wheel zooms", {},
        [&s = state_] { s.screen.wheel_zooms = !s.screen.wheel_zooms; },
        [&s = state_] { return s.screen.wheel_zooms; });
    AddSwitch(
        "view.reduce_motion", "Reduce motion", {},
        [&s = state_] { s.screen.reduce_motion = !s.screen.reduce_motion; },
        [&s = state_] { return s.screen.reduce_motion; });
  }

  void AddScales() {
    Add("view.scale", "Scale", {}, [&s = state_] { OpenMenuBelow(s, "view.scale", "menu/view"); });
    const auto step = [&s = state_](int by) {
      ScreenState& screen = s.screen;
      screen.scale = NextScale(ShownScale(screen.scale, screen.scale_of_screen), by);
    };
    Add("scale.larger", "Everything larger", {'=', kCtrl}, [step] { step(1); });
    Add("scale.smaller", "Everything smaller", {'-', kCtrl}, [step] { step(-1); });
    AddScale("scale.as_screen", "Scale as the screen says", {'0', kCtrl}, kScaleOfScreen);
    for (const float scale : kScales) {
      const std::string percent = std::to_string(std::lround(scale * 100));
      AddScale("scale." + percent, "Scale " + percent + " %", {}, scale);
    }
  }

  void AddScale(std::string id, std::string title, KeyChord keys, float scale) {
    AddSwitch(
        std::move(id), std::move(title), keys, [&s = state_, scale] { s.screen.scale = scale; },
        [&s = state_, scale] { return s.screen.scale == scale; });
  }

  void AddGrowth(std::string id, std::string title, Growth growth) {
    AddChoice(std::move(id), std::move(title), &LayoutStyle::growth, growth);
  }

  void AddToggle(std::string id, std::string title, bool LayoutStyle::*part) {
    AddSwitch(
        std::move(id), std::move(title), {},
        [&s = state_, part] {
          LayoutStyle style = s.workspace.style();
          style.*part = !(style.*part);
          s.workspace.SetStyle(style, s.now);
        },
        [&s = state_, part] { return s.workspace.style().*part; });
  }

  void AddPorts(std::string id, std::string title, ShownPorts ports) {
    AddChoice(std::move(id), std::move(title), &LayoutStyle::ports, ports);
  }

  template <class Value>
  void AddChoice(std::string id, std::string title, Value LayoutStyle::*part, Value value) {
    AddSwitch(
        std::move(id), std::move(title), {},
        [&s = state_, part, value] {
          LayoutStyle style = s.workspace.style();
          style.*part = value;
          s.workspace.SetStyle(style, s.now);
        },
        [&s = state_, part, value] { return s.workspace.style().*part == value; });
  }

  void AddTabs() {
    const auto step = [&s = state_](std::size_t by) {
      const std::size_t count = s.canvas.tabs.size();
      if (count > 0) ShowTab(s, (ShownTab(s) + by) % count, s.now);
    };
    Add("tab.next", "Next tab", {kKeyPageDown, kCtrl}, [step] { step(1); });
    Add("tab.previous", "Previous tab", {kKeyPageUp, kCtrl},
        [step, &s = state_] { step(s.canvas.tabs.size() - 1); });
    Add("tab.close", "Close tab", {'W', kCtrl}, [&s = state_] { CloseTab(s, ShownTab(s), s.now); });
  }

  void AddPalette(std::string id, std::string title, PaletteName name) {
    AddSwitch(
        std::move(id), std::move(title), {}, [&s = state_, name] { s.screen.palette = name; },
        [&s = state_, name] { return s.screen.palette == name; });
  }

  void AddTree() {
    AddForView("tree.collapse", "Collapse or open", {'C'}, [&s = state_](TreeView& view) {
      const std::uint32_t node = view.selected();
      if (node != kNoSceneNode) view.SetCollapsed(node, !view.IsCollapsed(node), s.now);
    });
    AddForView("tree.collapse_others", "Collapse all others", {'C', kShift},
               [&s = state_](TreeView& view) { view.CollapseOthers(s.now); });
    AddForView("tree.open_subtrees", "Open all SubTrees", {'E'},
               [&s = state_](TreeView& view) { view.CollapseSubTrees(false, s.now); });
    AddForView("tree.close_subtrees", "Close all SubTrees", {'E', kShift},
               [&s = state_](TreeView& view) { view.CollapseSubTrees(true, s.now); });
    AddForView("tree.unselect", "Select nothing", {kKeyEscape}, [](TreeView& view) {
      view.Select(kNoSceneNode);
      view.LightKey(kNoKey);
    });
    AddWalk("walk.up", "Walk up", kKeyUp, Way::kParent, Way::kPrevious);
    AddWalk("walk.down", "Walk down", kKeyDown, Way::kChild, Way::kNext);
    AddWalk("walk.left", "Walk left", kKeyLeft, Way::kPrevious, Way::kParent);
    AddWalk("walk.right", "Walk right", kKeyRight, Way::kNext, Way::kChild);
  }

  // The arrow keys go where they point to on the screen.
  void AddWalk(std::string id, std::string title, Key key, Way top_to_bottom, Way left_to_right) {
    AddForView(std::move(id), std::move(title), {key}, [=, &s = state_](TreeView& view) {
      const bool sideways = view.orientation() == Orientation::kLeftToRight;
      const std::uint32_t to = view.selected() == kNoSceneNode
                                   ? 0
                                   : Neighbour(*view.scene(), view, view.selected(),
                                               sideways ? left_to_right : top_to_bottom);
      if (to == kNoSceneNode) return;
      view.Select(to);
      view.Reveal(s.screen.canvas_size);
    });
  }

  void AddTiles() {
    AddTile("tile.project", "Project tile", {kKeyF1 + 1, kShift}, &Tiles::project);
    AddTile("tile.types", "Nodes tile", {kKeyF1 + 2, kCtrl | kShift}, &Tiles::types);
    AddTile("tile.outline", "Outline tile", {kKeyF1 + 2, kCtrl}, &Tiles::outline);
    AddTile("tile.inspector", "Inspector tile", {kKeyF1 + 3}, &Tiles::inspector);
    AddTile("tile.blackboard", "Blackboard tile", {kKeyF1 + 5}, &Tiles::blackboard);
    AddTileOfRow("tile.xml", "XML tile", {kKeyF1 + 6}, &Tiles::xml);
    AddTileOfRow("tile.problems", "Problems tile", {kKeyF1 + 7}, &Tiles::problems);
    AddTile("tile.timeline", "Timeline tile", {kKeyF1 + 7, kCtrl}, &Tiles::timeline);
    AddTile("tile.run", "Why, running, breakpoints tile", {kKeyF1 + 7, kShift}, &Tiles::run);
    AddTile("tile.minimap", "Minimap", {kKeyF1 + 10}, &Tiles::minimap);
    AddSwitch(
        "view.canvas_only", "The canvas alone", {kKeyF1 + 10, kCtrl},
        [&s = state_] { s.screen.tiles.others = !s.screen.tiles.others; },
        [&s = state_] { return !s.screen.tiles.others; });
  }

  // A tile whose row is folded is opened with it.
  void AddTileOfRow(std::string id, std::string title, KeyChord keys, bool Tiles::*tile) {
    const auto is_open = [&s = state_, tile] { return s.screen.tiles.*tile && s.screen.tiles.row; };
    AddSwitch(
        std::move(id), std::move(title), keys,
        [&s = state_, tile, is_open] {
          s.screen.tiles.*tile = !is_open();
          s.screen.tiles.row = true;
        },
        is_open);
  }

  void AddTile(std::string id, std::string title, KeyChord keys, bool Tiles::*tile) {
    AddSwitch(
        std::move(id), std::move(title), keys,
        [&s = state_, tile] { s.screen.tiles.*tile = !(s.screen.tiles.*tile); },
        [&s = state_, tile] { return s.screen.tiles.*tile; });
  }

  EditorState& state_;
};

}  // namespace

void AddStandardCommands(EditorState& state) { Commands(state).AddAll(); }

}  // namespace coppice::editor
