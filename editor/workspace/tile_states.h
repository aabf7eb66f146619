// What single tiles keep from frame to frame: their choices, and what they worked out.
#ifndef COPPICE_EDITOR_WORKSPACE_TILE_STATES_H_
#define COPPICE_EDITOR_WORKSPACE_TILE_STATES_H_

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bt_core/analysis/compare.h"
#include "bt_core/base/outcome.h"
#include "editor/canvas/drop_target.h"
#include "editor/files/folder.h"
#include "editor/files/line_changes.h"
#include "editor/keys/choice.h"
#include "editor/keys/keys.h"
#include "editor/keys/recent.h"
#include "editor/live/key_writes.h"
#include "editor/live/run_figures.h"
#include "editor/live/run_log.h"
#include "editor/live/why_answer.h"
#include "editor/theme/geometry.h"
#include "editor/workspace/follow.h"
#include "editor/workspace/interface_cache.h"
#include "editor/workspace/timeline_state.h"

namespace coppice::editor {

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
  kPasteErrors,
  kPrompt,  ///< asks for a text
  kList     ///< offers rows
};

/// What a kPrompt asks.
struct Prompt {
  std::string hint;
  std::function<Outcome(const std::string&)> run;  ///< of the text
  ChoiceSource preview;       ///< rows below it; empty: none. A click on one runs it
  bool asks_for_text = true;  ///< if not, Space runs the row that the arrow keys have chosen
};

/// What a kList offers.
struct List {
  std::string hint;
  ChoiceSource rows;
  bool is_searched = true;  ///< by typing; if not, it is a question with these answers
};

/// Of kOpen: a file is chosen, to open it or to save one.
struct FileDialog {
  std::string folder;  ///< what is typed is seen from here; empty: the current one
  std::string hint;    ///< what is saved
  std::function<Outcome(const std::string& path)> save;  ///< null: a file is opened
  bool walked = false;     ///< an arrow has chosen a row since something was typed
  bool was_empty = false;  ///< nothing was typed before the keys of this frame
  Folder listed;
  double listed_at = -1;  ///< seconds of the editor; negative: never
};

/// What lies over the screen until it is answered.
struct PopupState {
  Popup kind = Popup::kNone;
  bool is_new = false;        ///< opened since the last frame
  int number = 0;             ///< of the opening: each has a field of its own
  bool selects_text = false;  ///< typing replaces the text it opened with
  std::string text;           ///< what is typed into it
  std::string error;
  int choice = 0;          ///< highlighted row
  int held = kNoModifier;  ///< modifiers that Enter has without the user holding them
  std::size_t rows = 12;   ///< choices shown in the last frame
  std::vector<Diagnostic> problems;
  Prompt prompt;
  List list;
  FileDialog files;
  std::optional<std::string> new_text;  ///< for the field in the place of what is typed

  void Open(Popup which, std::string typed) {
    kind = which;
    is_new = true;
    ++number;
    selects_text = true;
    text = std::move(typed);
    error.clear();
    choice = 0;
    held = kNoModifier;
    new_text.reset();
  }
};

/// A menu on the screen.
struct OpenMenuState {
  std::string name;   ///< commands/menus.h
  Point at;           ///< of its corner, if it hangs at no item
  std::string below;  ///< path of the item that it hangs at; empty: none
  int choice = -1;    ///< highlighted entry; -1: none
  int seen = -1;      ///< the choice that was brought into view last
};

/// What is open of the menus: one, with its submenus behind it.
struct MenuState {
  std::vector<OpenMenuState> open;
  bool is_alone = false;  ///< Alt was pressed, and nothing since: letting it go opens the bar's
};

/// The tour (workspace/tour.h).
struct Tour {
  int step = -1;               ///< that is shown; -1: none
  bool was_done = false;       ///< what it says was so already
  std::size_t steps_done = 0;  ///< of the history when it began
};

/// What the run's tile shows.
enum class RunTab {
  kWhy,
  kRunning,
  kRobots,
  kHooks,
  kStatistics,
  kComparison,
  kCoverage,
  kLog,
  kTable,
  kPictures
};

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
  std::optional<std::size_t> selected;  ///< of result->differences
};

/// Of the tiles about runs; each keeps what it worked out until the run goes on.
struct RunTile {
  RunTab tab = RunTab::kWhy;
  FollowMode follow;
  std::optional<HeatMode> heat;
  RunFigures figures;
  WhyAnswer why;
  ShownComparison comparison;
  TableSort table_sort;
  std::map<std::string, RunLog> logs;              ///< by name of the run
  std::map<std::string, TimelineState> timelines;  ///< likewise
};

class ValueCache;

struct BlackboardTile {
  std::shared_ptr<ValueCache> values;  ///< live/values/value_cache.h; null: nothing was shown yet
  bool selected_keys_only = false;
  std::string words;      ///< only keys with these in path or value; empty: all
  std::string shown_key;  ///< "blackboard/SCOPE/KEY" with its history
  KeyWrites writes;       ///< that were made here
};

inline constexpr double kNoticeSeconds = 4;  ///< how long a notice is shown

/// What the inspector shows besides the selected node.
struct InspectorTile {
  std::string type;        ///< whose model is edited in the place of the node; empty: none
  std::uint32_t node = 0;  ///< that was selected then: choosing another one ends it
  InterfaceCache interfaces;
};

/// The text field that the user types in.
struct Typing {
  std::string key;
  std::string text;
};

/// What goes to fields to type in.
struct FieldInput {
  std::vector<KeyEvent> keys;  ///< pressed in this frame
  bool by_keys = false;        ///< one was pressed since the mouse was used
  Typing typing;
  std::string focus_field;  ///< path of the field to type in next
  std::string type_filter;  ///< typed above the node types
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

struct XmlTile {
  XmlPane pane;
  XmlLines lines;
  XmlGutter gutter;
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

/// What is on its way out of a tile onto the canvas.
struct TileDrag {
  std::optional<Drag> carried;
  std::string xml;  ///< of a new node
  DropAnswer answer;
};

/// A sentence about what was just done or refused.
struct Notice {
  std::string text;
  bool is_refusal = false;
  double at = -1e9;  ///< seconds of the editor
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_WORKSPACE_TILE_STATES_H_
