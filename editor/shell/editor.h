// The editor as a function of events: Frame() takes what the user did and how much time passed, and
// leaves draw data behind. It knows no window, no display and no clock, so it
// runs the same in a window, in a test and in a program without a display.
//
//   Editor editor({});
//   editor.Open("patrol.xml");
//   InputEvents events;                       // size, dt, mouse, keys
//   editor.Frame(events);
//   Image picture = editor.Picture();         // the software rasteriser; or draw_data() for OpenGL
//   const Box* box = editor.items().Find("canvas/MainTree/1.2");
//
// All calls from one thread. Several editors may exist at the same time.
#ifndef COPPICE_EDITOR_SHELL_EDITOR_H_
#define COPPICE_EDITOR_SHELL_EDITOR_H_

#include <cstdint>
#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "bt_core/live/discovery/robot_search.h"
#include "editor/files/history_store.h"
#include "editor/keys/input_queue.h"
#include "editor/render/image.h"
#include "editor/settings/project_session.h"
#include "editor/settings/settings.h"
#include "editor/theme/growing_fonts.h"
#include "editor/theme/item_registry.h"
#include "editor/workspace/editor_state.h"

struct ImDrawData;
struct ImGuiContext;

namespace coppice::editor {

struct EditorOptions {
  Settings settings;                   ///< of this time
  Settings kept_settings;              ///< of the last time; what differs was said for this time
  std::string settings_file;           ///< where they are kept when they change; empty: nowhere
  float scale = 1;                     ///< of the screen; 2 on a screen with tiny pixels
  std::shared_ptr<const Fonts> fonts;  ///< shared with others; null, or not fit: its own
  std::string recent_file;             ///< where recent files and robots are kept; empty: nowhere
  std::string backup_folder;    ///< where unsaved work and the history are kept; empty: nowhere
  std::string keys_file;        ///< the user's keys (commands/key_file.h); empty: none
  std::string projects_folder;  ///< where settings of projects are kept; empty: nowhere
  std::function<std::int64_t()> date;  ///< seconds since 1970; empty: always 0, which is unknown
  std::string marks_file;              ///< where breakpoints and bookmarks are kept; empty: nowhere
  std::shared_ptr<RobotSearch> search;  ///< for robots of the network; null: none are looked for
  std::function<void()> wake;           ///< called by any thread when a new frame would show news
  std::function<std::string()> get_clipboard;  ///< empty: the editor's own
  std::function<void(const std::string&)> set_clipboard;
};

class Editor {
 public:
  explicit Editor(EditorOptions options);
  ~Editor();
  Editor(const Editor&) = delete;
  Editor& operator=(const Editor&) = delete;

  /// Why the editor cannot draw (a font is missing), or empty. With an error, do not call Frame().
  const std::string& error() const;

  /// Opens a file; false if there is nothing to show. The problems are in the problems tile.
  bool Open(const std::string& path);
  /// Adds a file of node models.
  void AddModels(const std::string& path) { state_.workspace.AddModels(path); }
  /// Follows a robot at "host:port", or one of its trees at "host:port/TREE". A problem if
  /// the text is no such endpoint.
  Outcome Connect(const std::string& endpoint);
  /// Shows any other run.
  void AddRun(std::unique_ptr<RunSource> source);

  /// Builds one frame. Events that a frame cannot see together are kept for the next.
  void Frame(const InputEvents& input);

  /// Lets time pass without a frame, for a program that only waits: looks at the disk. True if a
  /// frame is worth drawing now.
  bool Rest(double seconds);

  /// Of the last frame; valid until the next.
  ImDrawData* draw_data() const;
  /// Paints the last frame without a display.
  Image Picture() const;

  /// Where everything was in the last frame.
  const ItemRegistry& items() const { return items_; }
  EditorState& state() { return state_; }
  double now() const { return state_.now; }

  /// Seconds until the next frame is worth drawing: 0 at once, infinity when nothing moves.
  double NextFrameIn() const;
  /// False if a robot has news that the last frame does not show.
  bool IsUpToDate() const;
  bool wants_quit() const { return state_.quit; }
  /// The user closes the window: as the command "file.quit", which asks if something is not saved.
  void AskToQuit();
  /// Writes what is not saved, and the history, where they are found again. The editor does so
  /// every few seconds, and when it ends without an answer of the user.
  void KeepWork();
  /// For the window: what is shown, and whether it is saved.
  std::string title() const;
  CursorShape cursor() const;

  /// For a renderer that sets itself up in the editor's context.
  ImGuiContext* context() const { return context_; }

 private:
  void SetUpImGui();
  void Apply(const InputEvents& input);
  void UseFonts();
  void DrawAgain();
  void RunKeys();
  void PassText();
  void NoteAlt(const KeyEvent& key);
  void LoadRecent();
  void KeepRecent();
  void NoteRobots();
  void RestIfUnasked();
  void KeepWorkIfDue();
  void LoadKeys();
  bool IsLogBehind() const;
  void KeepSettings();
  void TakeInFiles();
  void LoadMarks();
  void KeepMarks();
  void Remember(const std::string& path);

  const EditorOptions options_;
  GrowingFonts fonts_;
  ImGuiContext* const context_;
  std::string clipboard_;
  ItemRegistry items_;
  EditorState state_;
  InputQueue queue_;
  HistoryStore history_store_;
  ProjectSession projects_;
  std::string kept_marks_;             // as they are in the file
  std::string kept_settings_;          // likewise
  std::string kept_recent_;            // likewise
  Point window_;                       // its size when it could be seen last [pixels]
  bool asks_for_robots_ = false;       // this frame
  std::set<std::string> live_robots_;  // endpoints of those that answered in the last frame
  double kept_at_ = 0;
  struct Typed {
    std::string text;
    Key key = 0;  // that has made it
  };
  std::vector<Typed> typed_;  // in this frame
  Key run_key_ = 0;           // that has run a command in it
  std::string held_text_;     // for the field of a popup that has just opened
  int held_frames_ = 0;
  bool saves_after_typing_ = false;  // Ctrl+S in a field, whose value must be taken first
  int settle_ = 2;                   // frames that are still needed after the last event
};

}  // namespace coppice::editor

#endif  // COPPICE_EDITOR_SHELL_EDITOR_H_
