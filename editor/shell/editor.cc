// The order of a frame matters: first what comes from outside (disk, robots, simulation), then the
// keys, then the tiles, then what lies over them. So commands of keys meet a state at rest. What
// would pull something from under the tile that is being drawn goes into `after_frame`.
#include "editor/shell/editor.h"

#include <imgui.h>
// After imgui.h, which it needs.
#include <imgui_internal.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "editor/canvas/canvas.h"
#include "editor/canvas/layout/node_metrics.h"
#include "editor/commands/command_needs.h"
#include "editor/commands/difference_commands.h"
#include "editor/commands/edit_commands.h"
#include "editor/commands/file_commands.h"
#include "editor/commands/help_commands.h"
#include "editor/commands/log_commands.h"
#include "editor/commands/menu_commands.h"
#include "editor/commands/menus.h"
#include "editor/commands/merge_commands.h"
#include "editor/commands/picture_commands.h"
#include "editor/commands/place_commands.h"
#include "editor/commands/project_commands.h"
#include "editor/commands/run_commands.h"
#include "editor/commands/simulation_commands.h"
#include "editor/commands/standard_commands.h"
#include "editor/live/robot_source.h"
#include "editor/panels/menu/menu.h"
#include "editor/panels/popup/popup.h"
#include "editor/panels/tiles.h"
#include "editor/panels/tour/tour.h"
#include "editor/panels/xml/xml_keys.h"
#include "editor/render/rasteriser.h"
#include "editor/theme/imgui_context.h"
#include "editor/theme/imgui_style.h"
#include "editor/theme/scale.h"

namespace coppice::editor {
namespace {

constexpr int kFramesToSettle = 2;       // Dear ImGui shows some reactions a frame later
constexpr int kFramesToFocus = 3;        // and a field of a popup takes what is typed even later
constexpr double kLiveFrame = 1.0 / 20;  // while something runs on the robot
constexpr double kKeepSeconds = 3;       // between two copies of unsaved work
constexpr float kLeastWidth = 320;       // of a window that is neither closed nor an icon
constexpr float kLeastHeight = 240;
constexpr double kWaitingFrame = 1.0;  // to count down to the next try

// Nothing goes on in the run that is shown.
bool IsAtRest(const EditorState& state) {
  const RunView* const run = state.workspace.run();
  if (!run || run->playhead().is_playing()) return false;
  if (run->source().is_simulation()) return !state.simulator.is_playing();
  const bool is_live = run->phase() == RunPhase::kLive && run->playhead().is_at_now();
  return !is_live || run->stop().where != DebugStop::Where::kNowhere;
}

}  // namespace

Editor::Editor(EditorOptions options)
    : options_(std::move(options)),
      fonts_(options_.fonts, ShownScale(options_.settings.scale, options_.scale)),
      context_(fonts_->MakeContext()),
      state_(
          [this](const Scene& scene, const SceneNode& node) {
            const Ui ui{
                GetPalette(state_.screen.palette), *fonts_, items_, fonts_->scale(), 0, Time{}};
            return MeasureNode(ui, scene, node, false);
          },
          options_.backup_folder),
      history_store_(options_.backup_folder),
      projects_(options_.projects_folder) {
  const WithContext current(context_);
  SetUpImGui();
  editor::Apply(options_.settings, state_, state_.now);
  window_ = {static_cast<float>(options_.settings.width),
             static_cast<float>(options_.settings.height)};
  kept_settings_ = WriteSettings(options_.kept_settings);
  state_.screen.scale_of_screen = options_.scale;
  state_.services.open_file = [this](const std::string& path) { return Open(path); };
  state_.services.resume = [this](const std::string& path, const std::string& text) {
    return history_store_.Resume(state_.workspace.project(), path, text);
  };
  state_.services.connect = [this](const std::string& endpoint) { return Connect(endpoint); };
  state_.services.found_robots = [this] {
    asks_for_robots_ = true;
    return options_.search ? options_.search->Look() : std::vector<FoundRobot>();
  };
  state_.services.date = [this] { return options_.date ? options_.date() : std::int64_t{0}; };
  state_.services.get_clipboard = [this] {
    const WithContext own(context_);
    return std::string(ImGui::GetClipboardText());
  };
  state_.services.set_clipboard = [this](const std::string& text) {
    const WithContext own(context_);
    ImGui::SetClipboardText(text.c_str());
  };
  AddFileCommands(state_);
  AddEditCommands(state_);
  AddProjectCommands(state_);
  AddMergeCommands(state_);
  AddDifferenceCommands(state_);
  AddPictureCommands(state_);
  AddRunCommands(state_);
  AddLogCommands(state_);
  AddPlaceCommands(state_);
  AddStandardCommands(state_);
  AddHelpCommands(state_);
  AddMenuCommands(state_);
  AddSimulationCommands(state_);  // last: see there
  AddNeeds(state_);
  state_.git = GitHead(options_.wake);
  LoadRecent();
  LoadKeys();
  LoadMarks();
  state_.work.Look(state_.workspace.project());
}

Editor::~Editor() {
  const WithContext current(context_);
  KeepWork();
  ImGui::DestroyContext(context_);
}

const std::string& Editor::error() const { return fonts_->error(); }

void Editor::SetUpImGui() {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigInputTextCursorBlink = false;  // the same events give the same picture
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  MapKeys(io);
  io.ClipboardUserData = this;
  io.GetClipboardTextFn = [](void* self) {
    auto& editor = *static_cast<Editor*>(self);
    if (editor.options_.get_clipboard) editor.clipboard_ = editor.options_.get_clipboard();
    return editor.clipboard_.c_str();
  };
  io.SetClipboardTextFn = [](void* self, const char* text) {
    auto& editor = *static_cast<Editor*>(self);
    editor.clipboard_ = text;
    if (editor.options_.set_clipboard) editor.options_.set_clipboard(editor.clipboard_);
  };
}

bool Editor::Open(const std::string& path) {
  const WithContext current(context_);
  const bool good = state_.workspace.Open(path, state_.now);
  if (good) Remember(path);
  projects_.Follow(state_);
  TakeInFiles();
  return good;
}

// That were opened: what is known of them beside their texts.
void Editor::TakeInFiles() {
  for (const auto& [name, file] : state_.workspace.project().files()) {
    fonts_.Expect(file.text);
  }
  history_store_.Restore(state_.workspace.project());
  state_.work.Look(state_.workspace.project());
  settle_ = kFramesToSettle;
}

// Once the user has said what becomes of it, nothing is unsaved any more.
void Editor::KeepWork() {
  const OpenProject& project = state_.workspace.project();
  if (!state_.quit) state_.work.Keep(project);
  history_store_.Update(project);
  KeepMarks();
  KeepSettings();
  projects_.Keep(state_);
  KeepRecent();
}

void Editor::KeepWorkIfDue() {
  if (state_.now - kept_at_ < kKeepSeconds) return;
  kept_at_ = state_.now;
  state_.git.Look();
  KeepWork();
  state_.work.Look(state_.workspace.project());
}

void Editor::AskToQuit() {
  state_.commands.Run("file.quit");
  settle_ = kFramesToSettle;
}

std::string Editor::title() const {
  const Workspace& workspace = state_.workspace;
  const std::string* const path = workspace.run()    ? &workspace.run()->name()
                                  : workspace.file() ? &workspace.file()->path
                                                     : nullptr;
  if (!path) return "Coppice";
  bool is_dirty = false;
  std::size_t others = 0;
  for (const auto& [name, file] : workspace.project().files()) {
    if (file.is_dirty() && name == *path) is_dirty = true;
    if (file.is_dirty() && name != *path) ++others;
  }
  const std::string more = others > 0 ? " (+" + std::to_string(others) + " not saved)" : "";
  return (is_dirty ? "* " : "") + path->substr(path->rfind('/') + 1) + more + " - Coppice";
}

Outcome Editor::Connect(const std::string& endpoint) {
  const int known = state_.workspace.FindRun(endpoint);
  if (known >= 0) {
    state_.workspace.ShowRun(static_cast<std::size_t>(known));
    return {};
  }
  try {
    AddRun(std::make_unique<RobotSource>(endpoint, options_.wake));
  } catch (const std::invalid_argument& wrong) {
    return Problem{wrong.what()};
  }
  return {};
}

void Editor::AddRun(std::unique_ptr<RunSource> source) {
  state_.workspace.AddRun(std::move(source));
  state_.workspace.ShowRun(state_.workspace.runs().size() - 1);
  settle_ = kFramesToSettle;
}

void Editor::Frame(const InputEvents& input) {
  const WithContext current(context_);
  state_.now += input.dt;
  state_.simulator.Update(state_.workspace.project(), state_.now);
  state_.coverage.Update();
  state_.workspace.Update(state_.now);
  if (ImGui::GetFrameCount() > 0 && projects_.OpenRest(state_)) TakeInFiles();
  projects_.Follow(state_);
  for (const auto& run : state_.workspace.runs()) {
    const std::string answer = run->TakeAnswer();
    if (!answer.empty()) state_.Notify(run->name() + ": " + answer, state_.now, true);
  }
  NoteRobots();
  KeepWorkIfDue();
  const std::string news = state_.workspace.TakeNews();
  if (!news.empty()) state_.Notify(news, state_.now);
  Apply(input);
  UseFonts();
  ImGui::NewFrame();
  items_.Clear();
  const Palette& palette = GetPalette(state_.screen.palette);
  ApplyImGuiStyle(palette, fonts_->scale());
  if (TreeView* view = state_.workspace.view()) view->animated = !state_.screen.reduce_motion;
  RunKeys();
  PassText();
  const TreeSnapshot* shown = state_.workspace.tree_state();
  const Ui ui{GetPalette(state_.screen.palette),
              *fonts_,
              items_,
              fonts_->scale(),
              state_.now,
              shown ? shown->now : Time{},
              state_.screen.reduce_motion,
              IsAtRest(state_)};
  ImGui::SetNextWindowPos({0, 0});
  ImGui::SetNextWindowSize({input.width, input.height});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  ImGui::Begin("editor", nullptr,
               ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  DrawTiles(ui, state_, {{0, 0}, {input.width, input.height}});
  ImGui::End();
  DrawTour(ui, state_);
  DrawMenus(ui, state_);
  DrawPopup(ui, state_);
  ImGui::Render();
  RestIfUnasked();
  if (!ImGui::IsMouseDown(0)) state_.drag.carried.reset();
  if (state_.after_frame) std::exchange(state_.after_frame, {})();
  if (saves_after_typing_ && state_.input.typing.key.empty()) {
    saves_after_typing_ = false;
    state_.commands.Run("file.save");
  }
  if (fonts_.AreLacking(state_.now)) DrawAgain();
}

// Fonts are baked for one scale. Boxes of nodes follow: their texts are not exactly twice as wide.
void Editor::UseFonts() {
  const Expected<bool> others =
      fonts_.Fit(ShownScale(state_.screen.scale, options_.scale), state_.now);
  if (!others) {
    state_.Notify(others.problem(), state_.now, true);
    state_.screen.scale = fonts_->scale();
  }
  if (!others || !*others) return;
  fonts_->UseInContext();
  state_.workspace.MeasureAgain(state_.now);
  if (Comparison* const shown = state_.canvas.comparison.get()) {
    shown->view().MeasureAgain(state_.workspace.size_of(), state_.now);
  }
}

// Nobody sees the frame with boxes in the place of letters.
void Editor::DrawAgain() {
  InputEvents nothing;
  nothing.width = ImGui::GetIO().DisplaySize.x;
  nothing.height = ImGui::GetIO().DisplaySize.y;
  nothing.dt = 0;
  Frame(nothing);
  settle_ = kFramesToSettle;
}

bool Editor::Rest(double seconds) {
  const WithContext current(context_);
  const double notice_end = state_.notice.at + kNoticeSeconds;
  const bool showed_notice = notice_end > state_.now;
  state_.now += seconds;
  const bool changed = state_.workspace.Update(state_.now);
  KeepWorkIfDue();
  return changed || (showed_notice && notice_end <= state_.now) || NextFrameIn() == 0;
}

void Editor::Apply(const InputEvents& input) {
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {std::max(input.width, 1.0F), std::max(input.height, 1.0F)};
  if (input.width >= kLeastWidth && input.height >= kLeastHeight) {
    window_ = {input.width, input.height};
  }
  io.DeltaTime = std::max(input.dt, 1e-6F);
  io.MouseDoubleClickMaxDist = 6;
  settle_ = input.events.empty() ? std::max(settle_ - 1, 0) : kFramesToSettle;
  queue_.Add(input.events);
  state_.input.keys.clear();
  typed_.clear();
  run_key_ = 0;
  Key key_before = 0;
  for (const InputEvent& event : queue_.TakeFrame()) {
    const auto* pressed = std::get_if<KeyEvent>(&event);
    if (!pressed) {
      state_.input.by_keys = state_.input.by_keys && std::get_if<TypedText>(&event);
    } else if (pressed->down && !IsModifier(pressed->key)) {
      state_.input.by_keys = true;
    }
    if (const auto* move = std::get_if<MouseMove>(&event)) io.MousePos = {move->x, move->y};
    if (const auto* button = std::get_if<MouseButton>(&event)) {
      state_.menu.is_alone = false;
      if (button->button >= 0 && button->button < 5) io.MouseDown[button->button] = button->down;
    }
    if (const auto* wheel = std::get_if<MouseWheel>(&event)) {
      io.MouseWheel += wheel->y;
      io.MouseWheelH += wheel->x;
    }
    if (const auto* text = std::get_if<TypedText>(&event)) {
      typed_.push_back({text->utf8, std::exchange(key_before, 0)});
    }
    if (const auto* key = std::get_if<KeyEvent>(&event)) {
      ApplyKey(io, *key);
      if (key->down) state_.input.keys.push_back(*key);
      if (key->down) key_before = key->key;
      NoteAlt(*key);
    }
  }
}

// Alt, pressed and let go alone, opens and closes the menus.
void Editor::NoteAlt(const KeyEvent& key) {
  MenuState& menu = state_.menu;
  const bool is_end = key.key == kKeyLeftAlt && !key.down && menu.is_alone;
  menu.is_alone = key.key == kKeyLeftAlt && key.down;
  if (!is_end || state_.popup.kind != Popup::kNone) return;
  if (menu.open.empty()) {
    state_.commands.Run("menu.bar");
  } else {
    menu.open.clear();
  }
}

// While a text is being typed, its keys are its own, but for that which saves: it takes the text.
void Editor::RunKeys() {
  if (state_.popup.kind != Popup::kNone) return;
  if (!state_.menu.open.empty()) {
    for (const KeyEvent& event : std::exchange(state_.input.keys, {})) {
      if (!state_.menu.open.empty()) PressInMenu(state_, event);
    }
    return;
  }
  if (ImGui::GetIO().WantTextInput) {
    const EditorCommand* const save = state_.commands.Find("file.save");
    for (const KeyEvent& event : state_.input.keys) {
      if (!(save->keys == KeyChord{event.key, event.modifiers})) continue;
      ImGui::ClearActiveID();
      saves_after_typing_ = true;
    }
    return;
  }
  const std::vector<KeyEvent> keys = state_.input.keys;
  for (const KeyEvent& event : keys) {
    if (state_.xml.pane.focused && IsTextKey({event.key, event.modifiers})) continue;
    if (state_.commands.Press({event.key, event.modifiers})) {
      state_.input.keys.clear();
      run_key_ = event.key;
    }
    if (state_.popup.kind != Popup::kNone) return;
  }
}

// A popup opens by a key, and its field is ready some frames later: what was typed in between is
// for that field, but for the letter of the key itself.
void Editor::PassText() {
  ImGuiIO& io = ImGui::GetIO();
  for (Typed& typed : typed_) {
    if (typed.key == 0 || typed.key != run_key_) held_text_ += typed.text;
  }
  const bool waits = state_.popup.kind != Popup::kNone && !io.WantTextInput;
  if (waits && held_frames_++ < kFramesToFocus) return;
  io.AddInputCharactersUTF8(held_text_.c_str());
  held_text_.clear();
  if (!waits) held_frames_ = 0;
}

ImDrawData* Editor::draw_data() const {
  const WithContext current(context_);
  return ImGui::GetDrawData();
}

Image Editor::Picture() const {
  const WithContext current(context_);
  const ImGuiIO& io = ImGui::GetIO();
  Texture texture;
  unsigned char* alpha = nullptr;
  io.Fonts->GetTexDataAsAlpha8(&alpha, &texture.width, &texture.height);
  texture.alpha = alpha;
  Image image = MakeImage(static_cast<int>(io.DisplaySize.x), static_cast<int>(io.DisplaySize.y),
                          GetPalette(state_.screen.palette).canvas);
  if (const ImDrawData* data = ImGui::GetDrawData()) Rasterise(*data, texture, image);
  return image;
}

double Editor::NextFrameIn() const {
  if (queue_.pending() || settle_ > 0 || !held_text_.empty()) return 0;
  const Workspace& workspace = state_.workspace;
  if (const TreeView* view = const_cast<Workspace&>(workspace).view()) {
    if (view->IsMoving(state_.now)) return 0;
  }
  if (state_.coverage.is_running() || IsLogBehind()) return 0;
  double next =
      std::min({workspace.NextUpdateIn(state_.now), state_.simulator.NextUpdateIn(state_.now),
                fonts_.NextBakeIn(state_.now)});
  if (state_.notice.at + kNoticeSeconds > state_.now) {
    next = std::min(next, state_.notice.at + kNoticeSeconds - state_.now);
  }
  for (const auto& run : workspace.runs()) {
    if (run->source().has_news() || run->playhead().is_playing()) return 0;
    const RunPhase phase = run->phase();
    const bool waits = phase == RunPhase::kConnecting || phase == RunPhase::kReconnecting;
    if (waits) next = std::min(next, kWaitingFrame);
  }
  const RunView* shown = workspace.run();
  const bool is_live = shown && shown->phase() == RunPhase::kLive;
  if (is_live && !IsAtRest(state_)) next = std::min(next, kLiveFrame);
  return next;
}

bool Editor::IsUpToDate() const {
  if (options_.search && options_.search->has_news()) return false;
  const auto& runs = state_.workspace.runs();
  return std::none_of(runs.begin(), runs.end(),
                      [](const auto& run) { return run->source().has_news(); });
}

CursorShape Editor::cursor() const {
  const WithContext current(context_);
  switch (ImGui::GetMouseCursor()) {
    case ImGuiMouseCursor_TextInput:
      return CursorShape::kText;
    case ImGuiMouseCursor_ResizeEW:
      return CursorShape::kResizeAcross;
    case ImGuiMouseCursor_ResizeNS:
      return CursorShape::kResizeDown;
    case ImGuiMouseCursor_Hand:
      return CursorShape::kHand;
    default:
      return CursorShape::kArrow;
  }
}

bool Editor::IsLogBehind() const {
  const RunView* run = state_.workspace.run();
  if (!run || state_.run.tab != RunTab::kLog) return false;
  const auto log = state_.run.logs.find(run->name());
  return log != state_.run.logs.end() && log->second.is_behind(run->run());
}

}  // namespace coppice::editor
