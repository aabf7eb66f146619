// The state of the user interface that all panels share. What is open is in the Workspace.
#ifndef COPPICE_EDITOR_WORKSPACE_EDITOR_STATE_H_
#define COPPICE_EDITOR_WORKSPACE_EDITOR_STATE_H_

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/analysis/compare.h"
#include "editor/canvas/drop_target.h"
#include "editor/files/git_head.h"
#include "editor/files/line_changes.h"
#include "editor/keys/choice.h"
#include "editor/keys/command_table.h"
#include "editor/keys/keys.h"
#include "editor/live/run_figures.h"
#include "editor/live/run_log.h"
#include "editor/live/why_answer.h"
#include "editor/simulation/coverage_job.h"
#include "editor/simulation/scenario_tests.h"
#include "editor/simulation/simulator.h"
#include "editor/theme/palette.h"
#include "editor/workspace/canvas_state.h"
#include "editor/workspace/follow.h"
#include "editor/workspace/timeline_state.h"
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
  bool tests = false;    ///< in the place of the problems
  bool minimap = true;
};

/// Sizes of the tiles in pixels of a screen with 1280 x 800, larger on larger ones; parts as a
/// fraction.
struct Splits {
  float left = 236;
  float right = 296;
  float bottom = 170;
  float timeline = 190;
  float bare_project = 80;     ///< without a file it only says how to get one
  float bare_blackboard = 90;  ///< likewise without a run
  float left_part = 0.28F;     ///< of the project in the upper part of the left column
  float types_part = 0.62F;    ///< of what is above the node types
  float right_part = 0.55F;    ///< of the inspector in the right column
  float run_part = 0.42F;      ///< of the XML there, while a run is shown
  float bottom_part = 0.62F;   ///< of the XML in the bottom row
};

enum class Popup {
  kNone,
  kOpen,
  kConnect,
  kPalette,
  kKeys,     ///< lists all commands
  kNewKeys,  ///< waits for the keys of a command
  kAdd,
  kChangeType,
  kRename,
  kSaveAs,
  kPasteErrors,
  kPrompt,  ///< asks for a text
  kList     ///< offers rows
};

/// The keys of commands, and the user's changes of them.
struct KeySettings {
  std::string file;      ///< where they are kept; empty: nowhere
  Diagnostics problems;  ///< of that file
  std::string command;   ///< ID of the one that gets new keys
  KeyChord taken;        ///< what was pressed and is another command's; once more takes it
};

/// What a kPrompt asks.
struct Prompt {
  std::string hint;
  std::function<std::string(const std::string&)> run;  ///< of the text; returns why not, or nothing
  ChoiceSource preview;       ///< rows below it; empty: none. A click on one runs it
  bool asks_for_text = true;  ///< if not, Space runs the row that the arrow keys have chosen
};

/// What a kList offers.
struct List {
  std::string hint;
  ChoiceSource rows;
};

/// What the run's tile shows.
enum class RunTab { kWhy, kRunning, kHooks, kStatistics, kComparison, kCoverage, kLog, kTable };

/// By which column a table is sorted; empty: as it came.
struct TableSort {
  std::string column;
  bool descending = false;
};

/// Two runs that were compared, by name.
struct ShownComparison {
  std::string first;
  std::string second;
  std::optional<RunComparison> result;
};

inline constexpr double kNoticeSeconds = 4;  ///< how long a notice is shown

/// The text field that the user types in.
struct Typing {
  std::string key;
  std::string text;
};

/// The caret of the XML tile.
struct XmlPane {
  std::string path;  ///< of the file it is in
  std::size_t at = 0;
  std::size_t anchor = 0;    ///< the other end of what is selected
  std::size_t typed_to = 0;  ///< where the caret was when a character was typed last
  bool focused = false;      ///< keys are for the text
  bool wants_focus = false;
  bool pressed = false;  ///< the mouse button went down in it
  bool follow = false;   ///< the caret has moved and must be seen
  float left = 0;        ///< how far the text is scrolled [pixels]
  float widest = 0;      ///< line in sight [pixels]
};

/// Where the lines of a text begin and end (before the line end), and of which text.
struct XmlLines {
  struct Line {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
  };
  std::optional<Document> of;
  std::vector<Line> lines;
};

/// Which lines of the shown text differ, and from what that was computed.
struct XmlGutter {
  std::string path;
  std::uint32_t version = 0;  ///< of the text
  std::uint32_t saved_version = 0;
  std::shared_ptr<const std::string> head;
  std::vector<LineMark> since_saved;  ///< by line; empty: nothing to compare with
  std::vector<LineMark> since_head;
};

/// The last answer to "may this be dropped there?".
struct DropAnswer {
  std::uint64_t version = 0;  ///< of the project
  std::string label;
  DropTarget target;
  bool copy = false;
  bool replace = false;
  std::string refusal;
};

/// A sentence about what was just done or refused.
struct Notice {
  std::string text;
  bool is_refusal = false;
  double at = -1e9;  ///< seconds of the editor
};

struct EditorState {
  explicit EditorState(TreeView::SizeOf size_of) : workspace(std::move(size_of)) {}

  Workspace workspace;
  CanvasState canvas;
  Simulator simulator;
  CoverageJob coverage;  ///< of the tree of the simulation
  ScenarioTests tests;
  CommandTable commands;
  KeySettings key_settings;
  GitHead git;
  PaletteName palette = PaletteName::kDark;
  bool reduce_motion = false;  ///< nothing pulses, walks or glides
  Tiles tiles;
  Splits splits;
  Popup popup = Popup::kNone;
  bool popup_is_new = false;  ///< opened since the last frame
  std::string popup_text;     ///< what is typed into it
  std::string popup_error;
  int popup_choice = 0;         ///< highlighted row
  std::size_t popup_rows = 12;  ///< choices shown in the last frame
  std::vector<Diagnostic> popup_problems;
  Prompt prompt;
  List list;
  std::vector<std::string> recent;        ///< files, newest first
  std::vector<std::string> recent_types;  ///< of nodes that were added, newest first
  std::string last_search;
  Notice notice;
  Typing typing;
  XmlPane xml;
  XmlLines xml_lines;
  XmlGutter xml_gutter;
  std::string type_filter;       ///< typed above the node types
  std::optional<Drag> incoming;  ///< dragged out of a tile
  std::string dragged_xml;       ///< of a new node that is being dragged
  DropAnswer drop_answer;
  std::function<void()> after_frame;  ///< what would disturb the frame that is being drawn
  std::string focus_field;            ///< path of the field to type in next
  std::map<std::string, std::string> restorable;  ///< unsaved texts of the last time, by path
  std::vector<KeyEvent> keys;                     ///< pressed in this frame
  RunTab run_tab = RunTab::kWhy;
  std::map<std::string, TimelineState> timelines;  ///< by name of the run
  FollowMode follow;
  std::optional<HeatMode> heat;
  RunFigures figures;
  std::map<std::string, RunLog> logs;  ///< by name of the run
  WhyAnswer why;
  ShownComparison comparison;
  bool selected_keys_only = false;  ///< in the blackboard
  std::string shown_key;            ///< "blackboard/SCOPE/KEY" with its history
  TableSort table_sort;
  Point canvas_size{800, 600};  ///< of the last frame
  bool quit = false;
  std::function<bool(const std::string&)> open_file;
  std::function<std::string(const std::string&)> connect;  ///< returns what is wrong, or nothing
  /// Goes on with unsaved work and its history; false: there is no history of it.
  std::function<bool(const std::string& path, const std::string& text)> resume;
  std::function<std::string()> get_clipboard;
  std::function<void(const std::string&)> set_clipboard;

  void Notify(std::string text, double now, bool is_refusal = false) {
    notice = {std::move(text), is_refusal, now};
  }

  /// Asks for a text.
  void Ask(Prompt what, std::string text = {}) {
    prompt = std::move(what);
    OpenPopup(Popup::kPrompt, std::move(text));
  }

  /// Offers rows that are searched by typing.
  void Offer(List what, std::string text = {}) {
    list = std::move(what);
    OpenPopup(Popup::kList, std::move(text));
  }

  void OpenPopup(Popup which, std::string text = {}) {
    popup = which;
    popup_is_new = true;
    popup_text = std::move(text);
    popup_error.clear();
    popup_choice = 0;
  }
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_EDITOR_STATE_H_
