#include "editor/commands/menus.h"
#include "editor/panels/panels.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr float kRightPart = 196;  // of the bar: connect, and what is shown

class TopBar {
 public:
  TopBar(const Ui& ui, EditorState& state, const Box& box) : ui_(ui), state_(state), box_(box) {}

  void Draw() {
    ui_.Fill(*ImGui::GetWindowDrawList(), box_, ui_.palette.panel);
    float x = box_.min.x + 6 * ui_.scale;
    for (const BarMenu& menu : kBarMenus) x = Menu(menu, x);
    DrawField(x + 12 * ui_.scale);
    DrawMode();
    if (!HasConnectionStrip(state_)) DrawConnect();
  }

 private:
  float Menu(const BarMenu& menu, float x) {
    const TextStyle style{Face::kSans, 13, ui_.palette.text};
    const float width = ui_.Width(menu.title, style) + 18 * ui_.scale;
    const Box box = {{x, box_.min.y}, {x + width, box_.max.y}};
    const std::string name(menu.name);
    bool hovered = false;
    const std::string path = "menu/" + name;
    const bool pressed = ui_.Hit(path, box, &hovered);
    const auto& menus = state_.menu.open;
    const bool open = !menus.empty() && menus.front().below == path;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (hovered || open) ui_.Fill(list, box, ui_.palette.row_hover, 3);
    ui_.RowText(list, box.min + Point{9 * ui_.scale, 0}, box.height(), menu.title, style);
    if (pressed) {
      OpenMenuBelow(state_, name, path);
      state_.menu.open.front().choice = -1;
    }
    return x + width;
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
      return {"PAUSED", ui_.palette.text};
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
