#include <string>

#include "editor/commands/log_commands.h"
#include "editor/commands/run_commands.h"
#include "editor/panels/run/run_bodies.h"
#include "editor/panels/run/run_text.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr std::size_t kMostRows = 500;

std::string NameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

class Rows {
 public:
  Rows(const Ui& ui, EditorState& state, RunView& run, const RunLog& log)
      : ui_(ui), state_(state), run_(run), log_(log), list_(*ImGui::GetWindowDrawList()) {}

  void DrawPoint(const LogPoint& point) {
    const std::string path = "run/log/point/" + std::to_string(point.number);
    const Row row = NextRow(ui_, path, false);
    ImGui::SetItemAllowOverlap();
    const ImVec2 behind = ImGui::GetCursorScreenPos();
    if (!row.visible) return;
    right_ = row.box.max.x - 4 * ui_.scale;
    LogPoints& points = state_.workspace.log_points;
    const bool removed = Button(row, path + "/remove", icon::kTimes);
    const bool switched = Button(row, path + "/on", point.enabled ? "on" : "off");
    const bool asked = Button(row, path + "/text", "text");
    ImGui::SetCursorScreenPos(behind);
    const Color color = point.enabled ? ui_.palette.accent : ui_.palette.text_dim;
    const float size = 4 * ui_.scale;
    const Point at = {row.box.min.x + 12 * ui_.scale, row.box.center().y};
    list_.AddQuadFilled({at.x - size, at.y}, {at.x, at.y - size}, {at.x + size, at.y},
                        {at.x, at.y + size}, color);
    x_ = row.box.min.x + 24 * ui_.scale;
    Write(row, point.path, {Face::kBold, 12, color});
    const std::string hits = Count(log_.HitsOf(point.number), "hit");
    const TextStyle dim{Face::kSans, 11, ui_.palette.text_dim};
    const float end = right_;
    right_ -= ui_.Width(hits, dim) + 8 * ui_.scale;
    Write(row, ToString(point), {Face::kSans, 12, ui_.palette.text});
    right_ = end;
    Write(row, hits, dim);
    Write(row, log_.ProblemOf(point.number), {Face::kSans, 12, ui_.palette.warning});
    if (removed) return points.Remove(point.number);
    if (asked) return AskForLogPoint(state_, point.number);
    if (!switched) return;
    LogPoint changed = point;
    changed.enabled = !changed.enabled;
    points.Change(point.number, std::move(changed));
  }

  // The newest first.
  void DrawLines() {
    std::size_t number = log_.lines().size();
    const std::size_t last = number > kMostRows ? number - kMostRows : 0;
    while (number-- > last) DrawLine(number, log_.lines()[number]);
  }

 private:
  void DrawLine(std::size_t number, const LogLine& line) {
    const bool is_shown = !run_.playhead().is_at_now() && run_.playhead().tick() == line.tick;
    const Row row = NextRow(ui_, "run/log/" + std::to_string(number), is_shown);
    if (row.hovered) ImGui::SetTooltip("%s\n%s", line.path.c_str(), line.text.c_str());
    if (row.clicked) {
      run_.playhead().GoToTick(line.tick);
      if (run_.run().TracksAt(line.tick).tree() == run_.tree()->description()) {
        SelectRunNode(state_, line.node);
      }
    }
    if (!row.visible) return;
    x_ = row.box.min.x + 8 * ui_.scale;
    right_ = row.box.max.x - 4 * ui_.scale;
    const Color color = ui_.palette.Of(line.status);
    Write(row, AxisText(run_.run().TimeOf(line.tick)), {Face::kMono, 11, ui_.palette.text_dim});
    const std::string status = std::string(GlyphOf(line.status)) + " " + ToString(line.status);
    Write(row, status, {Face::kSans, 11, color});
    Write(row, NameOf(line.path), {Face::kBold, 12, ui_.palette.text});
    Write(row, line.text, {Face::kSans, 12, ui_.palette.text});
  }

  bool Button(const Row& row, const std::string& path, const std::string& text) {
    const float width = ui_.Width(text, {Face::kSans, 12, 0}) + 12 * ui_.scale;
    const Box at = {{right_ - width, row.box.min.y + ui_.scale},
                    {right_, row.box.max.y - ui_.scale}};
    right_ -= width + 3 * ui_.scale;
    return ui_.Button(path, at, text);
  }

  void Write(const Row& row, const std::string& text, const TextStyle& style) {
    const float room = right_ - x_ - 4 * ui_.scale;
    if (text.empty() || room < 8 * ui_.scale) return;
    x_ += ui_.RowText(list_, {x_, row.box.min.y}, row.box.height(), text, style, room) +
          8 * ui_.scale;
  }

  const Ui& ui_;
  EditorState& state_;
  RunView& run_;
  const RunLog& log_;
  ImDrawList& list_;
  float x_ = 0;
  float right_ = 0;
};

}  // namespace

void DrawLog(const Ui& ui, EditorState& state, RunView& run) {
  RunLog& log = state.run.logs[run.name()];
  log.Update(run.run(), run.name(), state.workspace.log_points);
  const std::vector<LogPoint> points = state.workspace.log_points.all();  // rows may change it
  if (points.empty()) {
    Hint(ui,
         "Ctrl+Shift+F9 writes a line here whenever the selected node begins or returns, with "
         "values: \"to {goal}\". The robot does not stop; the past counts too.");
  }
  Rows rows(ui, state, run, log);
  for (const LogPoint& point : points) rows.DrawPoint(point);
  rows.DrawLines();
}

}  // namespace coppice::editor
