#include <algorithm>

#include "editor/live/run_summary.h"
#include "editor/panels/panels.h"
#include "editor/panels/widgets/panel.h"
#include "editor/panels/widgets/run_dot.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

std::string ShortName(const RunView& run) {
  const std::string& name = run.name();
  return run.source().is_robot() ? name : name.substr(name.rfind('/') + 1);
}

class Strip {
 public:
  Strip(const Ui& ui, EditorState& state, const Box& box)
      : ui_(ui), state_(state), box_(box), list_(*ImGui::GetWindowDrawList()) {}

  void Draw() {
    const RunView* shown = state_.workspace.run();
    const Color tint = shown ? RunColor(ui_, *shown) : ui_.palette.panel;
    const bool stopped = shown && IsStopped(*shown);
    ui_.items.Add("strip", box_);
    ui_.Fill(list_, box_, Mix(ui_.palette.panel, tint, stopped ? 0.22F : 0.10F));
    ui_.Fill(list_, {box_.min, {box_.min.x + 3, box_.max.y}}, shown ? tint : ui_.palette.border);
    right_ = box_.max.x - 6 * ui_.scale;
    DrawFaults();
    if (shown) DrawControls(*shown);
    DrawNeeds();
    float x = box_.min.x + 8 * ui_.scale;
    is_crowded_ = IsCrowded();
    for (std::size_t i = FirstTab(); i < state_.workspace.runs().size(); ++i) {
      if (x < right_ - 60 * ui_.scale) x = DrawTab(x, i);
    }
    DrawConnect(x);
  }

 private:
  // Buttons grow from the right end.
  bool Button(const std::string& path, const std::string& text, bool active = false,
              Color tint = 0) {
    const float width = ui_.Width(text, {Face::kSans, 12, 0}) + 18 * ui_.scale;
    const Box at = {{right_ - width, box_.min.y + 4 * ui_.scale},
                    {right_, box_.max.y - 4 * ui_.scale}};
    right_ -= width + 4 * ui_.scale;
    return ui_.Button(path, at, text, active, tint);
  }

  // Whatever is shown, and on which robot: nobody shall forget a fault.
  void DrawFaults() {
    std::size_t count = 0;
    std::string first;
    for (const WantedHook& wanted : state_.workspace.hooks.all()) {
      if (IsBreakpoint(wanted.hook) || !wanted.hook.enabled) continue;
      if (count++ == 0) first = wanted.hook.path + ": " + ToString(wanted.hook);
    }
    if (count == 0) return;
    if (Button("strip/clear_faults", "clear", true, ui_.palette.error)) {
      state_.commands.Run("run.clear_faults");
    }
    const std::string text = std::string(icon::kWarning) + "  FAULTS ACTIVE  " +
                             (count == 1 ? first : std::to_string(count) + " forced results");
    const TextStyle style{Face::kBold, 12, ui_.palette.text};
    const float width = std::min(ui_.Width(text, style), box_.width() * 0.4F) + 20 * ui_.scale;
    const Box chip = {{right_ - width, box_.min.y + 3 * ui_.scale},
                      {right_, box_.max.y - 3 * ui_.scale}};
    ui_.Fill(list_, chip, Mix(ui_.palette.panel, ui_.palette.error, 0.45F), 4);
    ui_.Frame(list_, chip, ui_.palette.error, 4);
    ui_.RowText(list_, {chip.min.x + 10 * ui_.scale, chip.min.y}, chip.height(), text, style,
                width - 18 * ui_.scale);
    ui_.items.Add("strip/faults", chip);
    right_ = chip.min.x - 8 * ui_.scale;
  }

  // How many robots need somebody, whichever of them is shown; a click lists them.
  void DrawNeeds() {
    std::size_t robots = 0;
    std::size_t needing = 0;
    auto most = RunNeed::Level::kNone;
    for (const auto& run : state_.workspace.runs()) {
      if (!run->source().is_robot()) continue;
      const RunNeed::Level level = NeedOf(*run).level;
      ++robots;
      if (level != RunNeed::Level::kNone) ++needing;
      most = std::max(most, level);
    }
    if (robots < 2) return;
    const std::string text = needing == 0
                                 ? Count(robots, "robot")
                                 : std::string(icon::kWarning) + "  " + std::to_string(needing) +
                                       " of " + Count(robots, "robot");
    if (Button("strip/robots", text, needing > 0, needing > 0 ? NeedColor(ui_, most) : 0)) {
      state_.commands.Run("run.robots");
    }
    ExplainCommand(ui_, state_.commands, "run.robots");
  }

  void DrawControls(const RunView& run) {
    if (run.phase() == RunPhase::kLive) {
      if (Button("strip/step_node", "step node")) state_.commands.Run("run.step_node");
      ExplainCommand(ui_, state_.commands, "run.step_node");
      if (Button("strip/step_tick", "step tick")) state_.commands.Run("run.step_tick");
      ExplainCommand(ui_, state_.commands, "run.step_tick");
      const bool stopped = IsStopped(run);
      const std::string text = stopped ? "continue" : std::string(icon::kPause) + "  pause";
      if (Button("strip/pause", text, stopped, stopped ? ui_.palette.text : 0)) {
        state_.commands.Run("run.pause");
      }
      ExplainCommand(ui_, state_.commands, "run.pause");
    }
    if (!IsStopped(run)) return;
    const std::string text = StopText(run);
    const TextStyle style{Face::kBold, 12, ui_.palette.text};
    const float width = std::min(ui_.Width(text, style), box_.width() * 0.35F);
    right_ -= width + 8 * ui_.scale;
    ui_.RowText(list_, {right_, box_.min.y}, box_.height(), text, style, width);
    ui_.items.Add("strip/stopped", {{right_, box_.min.y}, {right_ + width, box_.max.y}});
    right_ -= 10 * ui_.scale;
  }

  // Of the one that is shown more is said than that it needs somebody.
  bool HasSign(const RunView& run) const {
    return state_.workspace.run() != &run && NeedOf(run).level != RunNeed::Level::kNone;
  }

  // With all that it tells, or with the name alone.
  float TabWidth(const RunView& run, bool whole) const {
    const float gap = 12 * ui_.scale;
    float width = 26 * ui_.scale + ui_.Width(ShortName(run), {Face::kBold, 12, 0}) + gap;
    if (HasSign(run)) width += ui_.Width(icon::kWarning, {Face::kBold, 12, 0}) + gap;
    if (!whole) return width;
    const std::string tree = run.tree() ? run.tree()->description()->main_tree : "";
    const TextStyle plain{Face::kSans, 12, 0};
    if (!tree.empty()) width += ui_.Width(tree, plain) + gap;
    return width + std::max(ui_.Width(SummaryOf(run), plain), 110 * ui_.scale) + gap;
  }

  // Whether the tabs would not fit if each told all.
  bool IsCrowded() const {
    float width = 0;
    for (const auto& run : state_.workspace.runs()) width += TabWidth(*run, true) + 6 * ui_.scale;
    return box_.min.x + width > right_ - 110 * ui_.scale;
  }

  // The first one from which on there is room for the tab of the shown run.
  std::size_t FirstTab() const {
    const auto& runs = state_.workspace.runs();
    float room = right_ - box_.min.x - 8 * ui_.scale;
    std::size_t first = 0;
    while (first < runs.size() && runs[first].get() != state_.workspace.run()) ++first;
    if (first == runs.size()) return 0;
    room -= TabWidth(*runs[first], true);
    while (first > 0) {
      room -= TabWidth(*runs[first - 1], !is_crowded_) + 6 * ui_.scale;
      if (room < 0) break;
      --first;
    }
    return first;
  }

  // Returns the right end of the tab.
  float DrawTab(float x, std::size_t number) {
    const RunView& run = *state_.workspace.runs()[number];
    const bool shown = state_.workspace.run() == &run;
    const Color color = RunColor(ui_, run);
    const std::string tree = run.tree() ? run.tree()->description()->main_tree : "";
    const Color writing = shown ? ui_.palette.text : ui_.palette.text_dim;
    const TextStyle bold{Face::kBold, 12, writing};
    const TextStyle plain{Face::kSans, 12, writing};
    const std::string name = ShortName(run);
    const std::string about = SummaryOf(run);
    const float gap = 12 * ui_.scale;
    const float width = TabWidth(run, shown || !is_crowded_);
    const Box tab = {{x, box_.min.y + 2 * ui_.scale},
                     {std::min(x + width, right_), box_.max.y - 2 * ui_.scale}};
    bool hovered = false;
    const bool pressed = ui_.Hit("strip/" + run.name(), tab, &hovered);
    if (shown || hovered) {
      ui_.Fill(list_, tab, Mix(ui_.palette.panel, color, shown ? 0.22F : 0.10F), 4);
      if (shown) ui_.Frame(list_, tab, Mix(ui_.palette.panel, color, 0.55F), 4);
    }
    DrawRunDot(ui_, list_, {tab.min.x + 13 * ui_.scale, tab.center().y}, run);
    float at = tab.min.x + 26 * ui_.scale;
    const auto write = [&](const std::string& text, const TextStyle& style) {
      const float room = tab.max.x - at - 4 * ui_.scale;
      if (room > 10 * ui_.scale) {
        at += ui_.RowText(list_, {at, tab.min.y}, tab.height(), text, style, room) + gap;
      }
    };
    write(name, bold);
    if (HasSign(run)) write(icon::kWarning, {Face::kBold, 12, NeedColor(ui_, NeedOf(run).level)});
    if (shown || !is_crowded_) {
      if (!tree.empty()) write(tree, plain);
      write(about, plain);
    }
    if (hovered) Explain(run, tab.width() < width);
    if (pressed) state_.workspace.ShowRun(number);
    return tab.max.x + 6 * ui_.scale;
  }

  // Nothing that the tab tells itself.
  void Explain(const RunView& run, bool is_cut) const {
    std::string text = is_cut || ShortName(run) != run.name() ? run.name() : "";
    const std::string asked = NeedOf(run).why;
    if (asked.rfind("asks: ", 0) == 0) text += "\n" + asked;
    const LiveConnection& connection = run.connection();
    if (!connection.problem.empty()) text += "\n" + connection.problem;
    if (!connection.refusal.empty()) text += "\ncannot be controlled: " + connection.refusal;
    if (connection.protocol == LiveConnection::Protocol::kGroot2) {
      text += "\nspeaks the Groot2 protocol only: no pausing, no stepping";
    }
    if (connection.trees.size() > 1) {
      text += "\ntrees:";
      for (const std::string& tree : connection.trees) text += " " + tree;
    }
    if (!text.empty()) Tooltip(ui_, text[0] == '\n' ? text.substr(1) : text);
  }

  void DrawConnect(float x) {
    const std::string text = std::string(icon::kPlug) + "  connect";
    const float width = ui_.Width(text, {Face::kSans, 12, 0}) + 20 * ui_.scale;
    if (x + width > right_) return;
    const Box button = {{x, box_.min.y + 4 * ui_.scale}, {x + width, box_.max.y - 4 * ui_.scale}};
    if (ui_.Button("strip/connect", button, text)) {
      state_.commands.Run("robot.connect");
    }
  }

  const Ui& ui_;
  EditorState& state_;
  const Box box_;
  ImDrawList& list_;
  float right_ = 0;
  bool is_crowded_ = false;
};

}  // namespace

bool HasConnectionStrip(const EditorState& state) {
  const auto& hooks = state.workspace.hooks.all();
  return !state.workspace.runs().empty() ||
         std::any_of(hooks.begin(), hooks.end(), [](const WantedHook& wanted) {
           return !IsBreakpoint(wanted.hook) && wanted.hook.enabled;
         });
}

void DrawConnectionStrip(const Ui& ui, EditorState& state, const Box& box) {
  Strip(ui, state, box).Draw();
}

}  // namespace coppice::editor
