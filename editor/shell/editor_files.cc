// What an editor keeps for the next time: keys, marks, settings, recent files and robots.
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"
#include "editor/keys/key_file.h"
#include "editor/keys/recent.h"
#include "editor/live/kept_marks.h"
#include "editor/shell/editor.h"

namespace coppice::editor {
namespace {

// Longer ones nobody has written; a line of keys that is wrong takes many times its length.
constexpr std::size_t kLongestOwnFile = std::size_t{1} << 20;  // bytes
constexpr std::size_t kLongestMarks = std::size_t{16} << 20;

// In a folder that may not be there yet. When it fails it may succeed the next time.
bool WriteOwnFile(const std::string& path, const std::string& text) {
  std::error_code error;
  std::filesystem::create_directories(std::filesystem::path(path).parent_path(), error);
  Diagnostics ignored;
  return WriteFile(path, text, ignored);
}

}  // namespace

void Editor::LoadKeys() {
  KeySettings& keys = state_.key_settings;
  keys.file = options_.keys_file;
  std::error_code error;
  const bool is_there = std::filesystem::exists(keys.file, error);
  const auto text = is_there ? ReadFile(keys.file, keys.problems, kLongestOwnFile) : std::nullopt;
  if (text) {
    ReadKeys(*text, keys.file, state_.commands, keys.problems);
  }
  if (keys.problems.has_errors()) {
    state_.Notify("some keys in " + keys.file + " are not valid: F1 says why", state_.now, true);
  }
}

void Editor::LoadMarks() {
  Workspace& workspace = state_.workspace;
  const std::optional<std::string> text = ReadFile(options_.marks_file, kLongestMarks);
  if (!text) return;
  Diagnostics problems;
  ReadMarks(*text, options_.marks_file, workspace.marks(), problems);
  if (!problems.all().empty()) state_.Notify(ToString(problems.all().front()), state_.now, true);
  kept_marks_ = WriteMarks(workspace.marks());
}

void Editor::KeepSettings() {
  if (options_.settings_file.empty()) return;
  Settings settings = SettingsOf(state_);
  settings.width = static_cast<int>(window_.x);
  settings.height = static_cast<int>(window_.y);
  // What was said for this time alone is not what the user has chosen.
  const Settings& now = options_.settings;
  const Settings& before = options_.kept_settings;
  if (settings.palette == now.palette) settings.palette = before.palette;
  if (settings.reduce_motion == now.reduce_motion) settings.reduce_motion = before.reduce_motion;
  if (settings.width == now.width) settings.width = before.width;
  if (settings.height == now.height) settings.height = before.height;
  std::string text = WriteSettings(settings);
  if (text != kept_settings_ && WriteOwnFile(options_.settings_file, text)) {
    kept_settings_ = std::move(text);
  }
}

void Editor::KeepMarks() {
  if (options_.marks_file.empty()) return;
  std::string marks = WriteMarks(state_.workspace.marks());
  const bool never_any = kept_marks_.empty() && !HasAny(state_.workspace.marks());
  if (marks == kept_marks_ || never_any) return;
  if (WriteOwnFile(options_.marks_file, marks)) kept_marks_ = std::move(marks);
}

void Editor::LoadRecent() {
  const std::optional<std::string> text = ReadFile(options_.recent_file, kLongestOwnFile);
  if (text) state_.recent = ReadRecent(*text);
  kept_recent_ = WriteRecent(state_.recent);
}

void Editor::KeepRecent() {
  std::string text = WriteRecent(state_.recent);
  if (options_.recent_file.empty() || text == kept_recent_) return;
  if (WriteOwnFile(options_.recent_file, text)) kept_recent_ = std::move(text);
}

// To the minute, so that a robot that is watched all day changes the file once a minute.
void Editor::NoteRobots() {
  const std::int64_t date = state_.services.date() / 60 * 60;
  std::set<std::string> live;
  for (const auto& run : state_.workspace.runs()) {
    if (!run->source().is_robot() || run->phase() != RunPhase::kLive) continue;
    live.insert(run->name());
    const LiveConnection& connection = run->connection();
    const bool is_told = connection.tree < connection.trees.size();
    if (live_robots_.count(run->name()) == 0) {
      MeetRobot(state_.recent.robots,
                {run->name(), is_told ? connection.trees[connection.tree] : "", date});
    } else {
      SeeRobot(state_.recent.robots, run->name(), date);
    }
  }
  live_robots_ = std::move(live);
}

// Robots are looked for as long as the screen offers some.
void Editor::RestIfUnasked() {
  if (options_.search && !std::exchange(asks_for_robots_, false)) options_.search->Rest();
}

void Editor::Remember(const std::string& path) {
  std::error_code error;
  UseAgain(state_.recent.files, std::filesystem::absolute(path, error).lexically_normal().string());
  KeepRecent();
}

}  // namespace coppice::editor
