// coppice-edit: the graphical editor.
#include <malloc.h>

#include <csignal>
#include <cstdlib>
#include <ctime>
#include <iostream>

#include "bt_core/base/read_file.h"
#include "editor/app/run.h"
#include "editor/live/record_source.h"

namespace coppice::editor {

std::atomic<bool> g_stop{false};

namespace {

// A place below the user's own folder: XDG Base Directory Specification 0.8.
std::string UserPath(const char* variable, const char* fallback, const char* path) {
  if (const char* folder = std::getenv(variable); folder && *folder) {
    return std::string(folder) + path;
  }
  if (const char* home = std::getenv("HOME"); home && *home) {
    return std::string(home) + fallback + path;
  }
  return {};
}

std::string SettingsFile() {
  return UserPath("XDG_CONFIG_HOME", "/.config", "/coppice/settings.json");
}

// It was opened last.
std::string WhyNotOpen(const Workspace& workspace, const std::string& file) {
  const std::vector<Diagnostic>& problems =
      IsRecordName(file) ? workspace.record_problems() : workspace.files().back().problems;
  return problems.empty() ? "coppice-edit: nothing to show\n" : ToString(problems.back()) + "\n";
}

}  // namespace

EditorOptions LoadSettings(const EditOptions& options) {
  EditorOptions loaded;
  const auto text = options.headless ? std::nullopt : ReadFile(SettingsFile());
  if (text) {
    Diagnostics diagnostics;
    loaded.kept_settings = ReadSettings(*text, SettingsFile(), diagnostics);
    std::cerr << diagnostics.ToString();
  }
  Settings& settings = loaded.settings = loaded.kept_settings;
  if (options.palette) settings.palette = *options.palette;
  if (options.reduce_motion) settings.reduce_motion = true;
  if (options.width > 0) settings.width = options.width;
  if (options.height > 0) settings.height = options.height;
  return loaded;
}

std::unique_ptr<Editor> MakeEditor(const EditOptions& options, EditorOptions editor_options) {
  if (!options.headless) {
    editor_options.date = [] { return static_cast<std::int64_t>(std::time(nullptr)); };
    editor_options.settings_file = SettingsFile();
    editor_options.recent_file = UserPath("XDG_CONFIG_HOME", "/.config", "/coppice/recent");
    editor_options.keys_file = UserPath("XDG_CONFIG_HOME", "/.config", "/coppice/keys");
    editor_options.marks_file = UserPath("XDG_STATE_HOME", "/.local/state", "/coppice/marks.json");
    editor_options.projects_folder =
        UserPath("XDG_STATE_HOME", "/.local/state", "/coppice/projects");
    editor_options.backup_folder = UserPath("XDG_STATE_HOME", "/.local/state", "/coppice/backup");
  }
  auto editor = std::make_unique<Editor>(std::move(editor_options));
  if (!editor->error().empty()) {
    std::cerr << "coppice-edit: " << editor->error() << "\n";
    return nullptr;
  }
  for (const std::string& models : options.models) editor->AddModels(models);
  for (const std::string& file : options.files) {
    // In a window PROBLEMS tells why there is nothing to see.
    if (editor->Open(file) || !options.headless || editor->state().workspace.project().Find(file)) {
      continue;
    }
    std::cerr << WhyNotOpen(editor->state().workspace, file);
    return nullptr;
  }
  if (options.files.size() > 1) editor->Open(options.files.front());  // shows the first
  for (const std::string& robot : options.robots) {
    const Outcome connected = editor->Connect(robot);
    if (connected) continue;
    std::cerr << "coppice-edit: " << connected.problem() << "\n";
    return nullptr;
  }
  if (options.robots.size() > 1) {
    static_cast<void>(editor->Connect(options.robots.front()));  // shows the first
  }
  return editor;
}

int Main(const std::vector<std::string>& arguments) {
  const EditOptions options = ParseEditOptions(arguments);
  if (options.exit) return *options.exit;
  for (const int signal : {SIGTERM, SIGINT, SIGHUP})
    std::signal(signal, [](int) { g_stop = true; });
  WallClock clock;
  return options.headless ? RunHeadless(clock, options) : RunWindow(clock, options);
}

}  // namespace coppice::editor

int main(int argc, char** argv) {
  // A large message of a robot, once read, goes back to the system at once: else each thread keeps
  // what it has had, and four robots that send the largest take 340 MB, not 160.
  mallopt(M_MMAP_THRESHOLD, 1 << 20);
  return coppice::FinishOutput(coppice::editor::Main({argv + 1, argv + argc}));
}
