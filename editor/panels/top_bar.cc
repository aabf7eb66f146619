#include "editor/panels/panels.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

struct MenuEntry {
  const char* command;  // null: a line between groups
};

constexpr MenuEntry kView[] = {{"view.grow_by_itself"},
                               {"view.top_to_bottom"},
                               {"view.left_to_right"},
                               {nullptr},
                               {"view.fit_all"},
                               {"view.fit_selection"},
                               {"view.zoom_100"},
                               {nullptr},
                               {"view.compact"},
                               {"view.layered"},
                               {"view.stacked"},
                               {"view.wrapped"},
                               {nullptr},
                               {"view.ports_by_itself"},
                               {"view.ports_all"},
                               {"view.ports_none"},
                               {nullptr},
                               {"tree.collapse"},
                               {"tree.open_subtrees"},
                               {"tree.close_subtrees"},
                               {nullptr},
                               {"palette.dark"},
                               {"palette.light"},
                               {"palette.colourblind"},
                               {"view.reduce_motion"}};
constexpr MenuEntry kEditMenu[] = {{"edit.undo"},
                                   {"edit.redo"},
                                   {"edit.history"},
                                   {nullptr},
                                   {"edit.cut"},
                                   {"edit.copy"},
                                   {"edit.paste"},
                                   {"edit.paste_after"},
                                   {"edit.duplicate"},
                                   {"edit.select_all"},
                                   {nullptr},
                                   {"edit.add"},
                                   {"edit.rename"},
                                   {"edit.change_type"},
                                   {"edit.disable"},
                                   {"edit.delete"},
                                   {"edit.delete_only"},
                                   {nullptr},
                                   {"edit.find"},
                                   {"edit.find_next"},
                                   {"edit.find_previous"},
                                   {"edit.replace"},
                                   {"key.rename"},
                                   {"edit.xml"}};
constexpr MenuEntry kTreeMenu[] = {
    {"tree.new"},    {"tree.rename"},     {"tree.delete"}, {nullptr}, {"tree.extract"},
    {"tree.inline"}, {"tree.definition"}, {"tree.usages"}, {nullptr}, {"file.include"}};
constexpr MenuEntry kTilesMenu[] = {{"tile.project"},    {"tile.outline"},    {"tile.types"},
                                    {"tile.inspector"},  {"tile.blackboard"}, {"tile.xml"},
                                    {"tile.problems"},   {"tile.tests"},      {"tile.run"},
                                    {"tile.timeline"},   {"tile.minimap"},    {nullptr},
                                    {"view.canvas_only"}};
constexpr MenuEntry kRobotMenu[] = {{"robot.connect"},
                                    {"robot.next"},
                                    {"run.close"},
                                    {nullptr},
                                    {"run.pause"},
                                    {"run.continue"},
                                    {"run.step_tick"},
                                    {"run.step_node"},
                                    {nullptr},
                                    {"run.breakpoint"},
                                    {"run.breakpoint_enable"},
                                    {"run.breakpoint_condition"},
                                    {"run.breakpoint_path"},
                                    {"run.log_point"},
                                    {nullptr},
                                    {"run.force_success"},
                                    {"run.force_failure"},
                                    {"run.force_running"},
                                    {"run.force_skipped"},
                                    {"run.delay"},
                                    {"run.clear_faults"}};
constexpr MenuEntry kRunMenu[] = {{"run.back"},
                                  {"run.forward"},
                                  {"run.change_before"},
                                  {"run.next_change"},
                                  {"run.begin"},
                                  {"run.now"},
                                  {"run.play"},
                                  {"run.faster"},
                                  {"run.slower"},
                                  {nullptr},
                                  {"run.why"},
                                  {"run.running"},
                                  {"run.hooks"},
                                  {"run.log"},
                                  {"run.statistics"},
                                  {"run.comparison"},
                                  {"run.table"},
                                  {"run.coverage"},
                                  {nullptr},
                                  {"run.bookmark"},
                                  {"run.bookmark_text"},
                                  {"run.bookmarks"},
                                  {nullptr},
                                  {"run.follow"},
                                  {"run.heat"},
                                  {"run.pin"},
                                  {"blackboard.selection"},
                                  {"blackboard.write"},
                                  {"run.save"},
                                  {"run.save_test"}};
constexpr MenuEntry kSimulateMenu[] = {
    {"sim.start"},     {"sim.end"},        {"sim.restart"}, {"sim.again"},   {nullptr},
    {"sim.play"},      {"sim.tick"},       {"sim.change"},  {"sim.back"},    {"sim.faster"},
    {"sim.slower"},    {nullptr},          {"sim.success"}, {"sim.failure"}, {"sim.running"},
    {"sim.skipped"},   {"sim.script"},     {"sim.set"},     {nullptr},       {"sim.tests"},
    {"sim.save_test"}, {"sim.save_record"}};
constexpr MenuEntry kHelpMenu[] = {{"help.palette"}, {"help.keys"}};

constexpr float kRightPart = 196;  // of the bar: connect, and what is shown

class TopBar {
 public:
  TopBar(const Ui& ui, EditorState& state, const Box& box) : ui_(ui), state_(state), box_(box) {}

  void Draw() {
    ui_.Fill(*ImGui::GetWindowDrawList(), box_, ui_.palette.panel);
    float x = box_.min.x + 6 * ui_.scale;
    x = Menu("File", x, [this] { FileMenu(); });
    x = Menu("Edit", x, [this] { Entries(kEditMenu); });
    x = Menu("Tree", x, [this] { Entries(kTreeMenu); });
    x = Menu("View", x, [this] { Entries(kView); });
    x = Menu("Tiles", x, [this] { Entries(kTilesMenu); });
    x = Menu("Robot", x, [this] { Entries(kRobotMenu); });
    x = Menu("Run", x, [this] { Entries(kRunMenu); });
    x = Menu("Simulate", x, [this] { Entries(kSimulateMenu); });
    x = Menu("Help", x, [this] { Entries(kHelpMenu); });
    DrawField(x + 12 * ui_.scale);
    DrawMode();
    if (!HasConnectionStrip(state_)) DrawConnect();
  }

 private:
  template <class Body>
  float Menu(const std::string& title, float x, Body body) {
    const TextStyle style{Face::kSans, 13, ui_.palette.text};
    const float width = ui_.Width(title, style) + 18 * ui_.scale;
    const Box box = {{x, box_.min.y}, {x + width, box_.max.y}};
    std::string lower = title;
    lower[0] = static_cast<char>(lower[0] - 'A' + 'a');
    bool hovered = false;
    const bool pressed = ui_.Hit("menu/" + lower, box, &hovered);
    const std::string popup = "menu " + title;
    const bool open = ImGui::IsPopupOpen(popup.c_str());
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hovered || open) ui_.Fill(list, box, ui_.palette.row_hover, 3);
    ui_.RowText(list, box.min + Point{9 * ui_.scale, 0}, box.height(), title, style);
    if (pressed) ImGui::OpenPopup(popup.c_str());
    ImGui::SetNextWindowPos({box.min.x, box.max.y});
    if (ImGui::BeginPopup(popup.c_str())) {
      body();
      ImGui::EndPopup();
    }
    return x + width;
  }

  template <std::size_t kCount>
  void Entries(const MenuEntry (&entries)[kCount]) {
    for (const MenuEntry& entry : entries) {
      if (entry.command) {
        Entry(entry.command);
      } else {
        ImGui::Separator();
      }
    }
  }

  void Entry(const char* id) {
    const EditorCommand* command = state_.commands.Find(id);
    if (!command) return;
    const std::string keys = ToString(command->keys);
    const bool is_on = command->is_on && command->is_on();
    const bool applies = !command->when || command->when();
    const bool chosen = ImGui::MenuItem(command->title.c_str(), keys.c_str(), is_on, applies);
    ui_.items.Add(std::string("menu/") + id,
                  {FromIm(ImGui::GetItemRectMin()), FromIm(ImGui::GetItemRectMax())});
    if (chosen) command->run();
  }

  void FileMenu() {
    Entry("file.new");
    Entry("file.open");
    Entry("file.reload");
    Entry("file.save");
    Entry("file.save_as");
    ImGui::Separator();
    Entry("file.export");
    Entry("file.compare");
    Entry("file.stop_comparing");
    if (!state_.work.left().empty()) Entry("file.unsaved");
    if (!state_.recent.files.empty()) ImGui::Separator();
    for (std::size_t i = 0; i < state_.recent.files.size(); ++i) {
      const std::string path = state_.recent.files[i];
      const bool chosen = ImGui::MenuItem(path.c_str());
      ui_.items.Add("menu/recent/" + std::to_string(i),
                    {FromIm(ImGui::GetItemRectMin()), FromIm(ImGui::GetItemRectMax())});
      if (chosen) {
        state_.services.open_file(path);
        break;
      }
    }
    ImGui::Separator();
    Entry("file.quit");
  }

  // In the middle if there is room right of `left`.
  void DrawField(float left) {
    const float width = std::min(460 * ui_.scale, box_.width() * 0.36F);
    const float pad = 4 * ui_.scale;
    const float start = std::max(box_.center().x - width / 2, left);
    const float end = std::min(start + width, box_.max.x - kRightPart * ui_.scale);
    if (end - start < 60 * ui_.scale) return;
    const Box field = {{start, box_.min.y + pad}, {end, box_.max.y - pad}};
    bool hovered = false;
    const bool pressed = ui_.Hit("bar/palette", field, &hovered);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ui_.Fill(list, field, ui_.palette.field, 4);
    ui_.Frame(list, field, hovered ? ui_.palette.accent : ui_.palette.border, 4);
    const TextStyle style{Face::kSans, 12, ui_.palette.text_dim};
    ui_.RowText(list, field.min + Point{10 * ui_.scale, 0}, field.height(), icon::kSearch, style);
    ui_.RowText(list, field.min + Point{30 * ui_.scale, 0}, field.height(),
                "Ctrl+P   commands, nodes, trees, robots", style, field.width() - 36 * ui_.scale);
    if (pressed) state_.OpenPopup(Popup::kPalette);
  }

  struct Mode {
    const char* text;
    Color color;  // 0: none of its own
  };

  // It follows from what is shown, and from where the playhead is.
  Mode ModeOf(const RunView* run) const {
    if (!run) return {"EDIT", 0};
    if (run->source().is_simulation()) return {"SIM", ui_.palette.simulation};
    const bool is_now = run->playhead().is_at_now();
    if (is_now && run->stop().where != DebugStop::Where::kNowhere) {
      return {"PAUSED", ui_.palette.running};
    }
    if (is_now && run->phase() == RunPhase::kLive) return {"LIVE", ui_.palette.success};
    const RunPhase phase = run->phase();
    if (phase == RunPhase::kConnecting || phase == RunPhase::kReconnecting) {
      return {"OFFLINE", ui_.palette.text_dim};
    }
    return {"REPLAY", ui_.palette.accent};
  }

  void DrawMode() {
    const RunView* run = state_.workspace.run();
    const Mode mode = ModeOf(run);
    const Box chip = {{box_.max.x - 84 * ui_.scale, box_.min.y + 4 * ui_.scale},
                      {box_.max.x - 8 * ui_.scale, box_.max.y - 4 * ui_.scale}};
    if (ui_.Button("bar/mode", chip, mode.text, run, mode.color) && run) {
      state_.commands.Run("run.now");
    }
  }

  void DrawConnect() {
    const float pad = 4 * ui_.scale;
    const Box box = {{box_.max.x - (kRightPart - 8) * ui_.scale, box_.min.y + pad},
                     {box_.max.x - 92 * ui_.scale, box_.max.y - pad}};
    const std::string text = std::string(icon::kPlug) + "  connect";
    if (ui_.Button("bar/connect", box, text)) state_.commands.Run("robot.connect");
    ExplainCommand(ui_, state_.commands, "robot.connect");
  }

  const Ui& ui_;
  EditorState& state_;
  const Box box_;
};

}  // namespace

void DrawTopBar(const Ui& ui, EditorState& state, const Box& box) { TopBar(ui, state, box).Draw(); }

}  // namespace coppice::editor
