// The state of the user interface that all panels share. What is open is in the Workspace.
#ifndef COPPICE_EDITOR_WORKSPACE_EDITOR_STATE_H_
#define COPPICE_EDITOR_WORKSPACE_EDITOR_STATE_H_

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "editor/files/git_head.h"
#include "editor/files/path_check.h"
#include "editor/files/unsaved_work.h"
#include "editor/keys/command_table.h"
#include "editor/simulation/coverage_job.h"
#include "editor/simulation/scenario_tests.h"
#include "editor/simulation/simulator.h"
#include "editor/theme/palette.h"
#include "editor/workspace/canvas_state.h"
#include "editor/workspace/tile_states.h"
#include "editor/workspace/workspace.h"

namespace coppice::editor {

/// Which tiles are shown.
struct Tiles {
  bool project = true;
  bool outline = true;
  bool types = true;
  bool inspector = true;
  bool blackboard = true;
  bool xml = true;
  bool problems = true;
  bool run = true;       ///< why, running, breakpoints, statistics; while a run is shown
  bool timeline = true;  ///< while a run is shown
  bool tests = false;    ///< in the place of the problems, whose row it opens
  bool minimap = true;
  bool row = false;    ///< XML and problems are open below the canvas, else folded to their titles
  bool others = true;  ///< all but the canvas
};

/// Sizes of the tiles in pixels of a screen with 1280 x 800, larger on larger ones; parts as a
/// fraction.
struct Splits {
  float left = 216;
  float right = 260;
  float bottom = 170;
  float timeline = 190;       ///< and what stands beside it
  float bare_project = 80;    ///< without a file it only says how to get one
  float left_part = 0.28F;    ///< of the project in the upper part of the left column
  float types_part = 0.62F;   ///< of what is above the node types
  float right_part = 0.55F;   ///< of the inspector in the right column
  float run_part = 0.58F;     ///< of the timeline in its row
  float bottom_part = 0.62F;  ///< of the XML in the bottom row
};

/// How the screen is divided and coloured.
struct ScreenState {
  PaletteName palette = PaletteName::kDark;
  bool reduce_motion = false;  ///< nothing pulses, walks or glides
  float scale = 0;             ///< that was chosen (theme/scale.h); 0: that of the screen
  float scale_of_screen = 1;
  bool wheel_zooms = false;  ///< on the canvas (canvas/wheel.h)
  bool finds_robots = true;  ///< asks the network for them while robots are offered
  Tiles tiles;
  Splits splits;
  Point canvas_size{800, 600};  ///< of the last frame
};

/// The keys of commands, and the user's changes of them.
struct KeySettings {
  std::string file;      ///< where they are kept; empty: nowhere
  Diagnostics problems;  ///< of that file
  std::string command;   ///< ID of the one that gets new keys
  KeyChord taken;        ///< what was pressed and is another command's; once more takes it
};

/// What the editor does for its tiles and commands.
struct Services {
  std::function<bool(const std::string&)> open_file;
  std::function<Outcome(const std::string&)> connect;  ///< to an endpoint
  /// Of the network; looked for as long as a frame asks.
  std::function<std::vector<FoundRobot>()> found_robots;
  /// Goes on with unsaved work and its history; false: there is no history of it.
  std::function<bool(const std::string& path, const std::string& text)> resume;
  std::function<std::int64_t()> date;  ///< seconds since 1970
  std::function<std::string()> get_clipboard;
  std::function<void(const std::string&)> set_clipboard;
};

struct EditorState {
  explicit EditorState(TreeView::SizeOf size_of, std::string work_folder = {})
      : workspace(std::move(size_of)), work(std::move(work_folder)) {}

  double now = 0;  ///< seconds of the editor; stands still during a frame
  Workspace workspace;
  Simulator simulator;
  CoverageJob coverage;  ///< of the tree of the simulation
  ScenarioTests tests;
  CommandTable commands;
  KeySettings key_settings;
  GitHead git;
  UnsavedWork work;
  std::map<std::string, std::string> unsaveable;  ///< why files could not be saved, by path
  std::string replaces;  ///< path of a file that was said to be replaced by the next "save as"
  ScreenState screen;
  CanvasState canvas;
  XmlTile xml;
  RunTile run;
  BlackboardTile blackboard;
  InspectorTile inspector;
  PopupState popup;
  MenuState menu;
  Tour tour;
  Recent recent;
  PathCheck paths;
  Notice notice;
  FieldInput input;
  TileDrag drag;
  Services services;
  std::function<void()> after_frame;  ///< what would disturb the frame that is being drawn
  bool quit = false;

  void Notify(std::string text, double at, bool is_refusal = false) {
    notice = {std::move(text), is_refusal, at};
  }

  /// To which the user may connect.
  std::vector<OfferedRobot> OfferedRobots() const {
    return OfferRobots(recent.robots,
                       screen.finds_robots ? services.found_robots() : std::vector<FoundRobot>(),
                       services.date());
  }
  /// Because the user says so; what does not work is told.
  void Connect(const std::string& endpoint) {
    const Outcome connected = services.connect(endpoint);
    if (!connected) Notify(connected.problem(), now, true);
  }

  /// Asks for a text.
  void Ask(Prompt what, std::string text = {}) {
    popup.prompt = std::move(what);
    OpenPopup(Popup::kPrompt, std::move(text));
  }

  /// Offers rows that are searched by typing.
  void Offer(List what, std::string text = {}) {
    popup.list = std::move(what);
    OpenPopup(Popup::kList, std::move(text));
  }

  void OpenPopup(Popup which, std::string text = {}) { popup.Open(which, std::move(text)); }
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_EDITOR_STATE_H_
