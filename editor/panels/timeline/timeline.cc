#include "editor/panels/timeline/timeline.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/panels/run/run_text.h"
#include "editor/panels/timeline/lane_painter.h"
#include "editor/panels/timeline/timeline_frame.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/contrast.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr float kLabels = 150;  // pixels at scale 1
constexpr float kOverview = 22;
constexpr float kRuler = 16;

class Timeline {
 public:
  Timeline(const Ui& ui, EditorState& state, RunView& view, const Box& box)
      : f_{ui,
           state,
           view,
           view.run(),
           view.playhead(),
           state.run.timelines[view.name()],
           view.run().TracksAt(view.playhead().is_at_now() ? view.run().size()
                                                           : view.playhead().tick()),
           {},
           {},
           {},
           {},
           Time{},
           {}},
        list_(*ImGui::GetWindowDrawList()) {
    Box rest = box;
    f_.labels = {{box.min.x, box.min.y}, {box.min.x + kLabels * ui.scale, box.max.y}};
    rest.min.x = f_.labels.max.x;
    rest.max.x -= 6 * ui.scale;
    f_.overview = Take(rest, kOverview);
    f_.ruler = Take(rest, kRuler);
    f_.lanes = rest;
    f_.run_end = f_.run.TimeOf(f_.run.size() - 1) + LastPeriod();
    if (f_.head.is_at_now()) f_.run_end = std::max(f_.run_end, view.state().now);
  }

  void Draw() {
    MoveWithPlayhead();
    HandleTimelineMouse(f_);
    const float width = f_.lanes.width() / f_.ui.scale;
    f_.columns = ColumnsOf(f_.run, f_.shown.view, static_cast<std::size_t>(std::max(width, 1.0F)),
                           f_.run_end);
    DrawOverview();
    DrawRuler();
    DrawTimelineLanes(f_);
    DrawBreaks();
    DrawRange();
    DrawCursor();
  }

 private:
  Box Take(Box& rest, float height) const {
    const Box taken = {rest.min, {rest.max.x, rest.min.y + height * f_.ui.scale}};
    rest.min.y = taken.max.y;
    return taken;
  }

  // The last tick is shown as long as the one before it.
  Duration LastPeriod() const {
    constexpr Duration kLongest = std::chrono::seconds(1);
    const std::size_t ticks = f_.run.size();
    if (ticks < 2) return kLongest / 10;
    return std::min(f_.run.TimeOf(ticks - 1) - f_.run.TimeOf(ticks - 2), kLongest);
  }

  // It follows the end; otherwise it goes where the playhead was moved to.
  void MoveWithPlayhead() {
    if (f_.head.is_at_now() && f_.shown.was_held) f_.shown.view.StartFollowing();
    f_.shown.view.Follow(f_.run_end);
    if (!f_.head.is_at_now() && f_.head.time() != f_.shown.shown)
      f_.shown.view.Reveal(f_.head.time());
    f_.shown.shown = f_.head.time();
    f_.shown.was_held = !f_.head.is_at_now();
  }

  void DrawOverview() {
    f_.ui.Fill(list_, f_.overview, Mix(f_.ui.palette.panel, f_.ui.palette.canvas, 0.7F));
    const auto count = static_cast<std::size_t>(std::max(f_.overview.width() / f_.ui.scale, 1.0F));
    TimeView all;
    all.Fit(Time{}, std::max(f_.run_end, Time(Duration(1))));
    const std::vector<Column> columns = ColumnsOf(f_.run, all, count, f_.run_end);
    std::size_t most = 1;
    for (const Column& column : columns) {
      most = std::max(most, f_.run.Activity(column.first, column.end));
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (columns[i].is_empty()) continue;
      const Status worst =
          WorstOf(f_.tracks.LaneOf(kRootNode).Seen(columns[i].first, columns[i].end));
      const double part = static_cast<double>(f_.run.Activity(columns[i].first, columns[i].end)) /
                          static_cast<double>(most);
      const float height = 2 + static_cast<float>(std::sqrt(part)) * (f_.overview.height() - 4);
      const float x = f_.overview.min.x + static_cast<float>(i) * f_.ui.scale;
      f_.ui.Fill(list_, {{x, f_.overview.max.y - height}, {x + f_.ui.scale, f_.overview.max.y}},
                 Fade(f_.ui.palette.Of(worst), 0.65F));
      if (worst != Status::kFailure) continue;
      // Seen also by those who do not see the colour.
      f_.ui.Fill(list_,
                 {{x, f_.overview.min.y}, {x + f_.ui.scale, f_.overview.min.y + 3 * f_.ui.scale}},
                 f_.ui.palette.failure);
    }
    const auto x_of = [&](Time time) {
      return f_.overview.min.x +
             std::clamp(static_cast<float>(all.PartOf(time)), 0.0F, 1.0F) * f_.overview.width();
    };
    f_.ui.Frame(
        list_,
        {{x_of(f_.shown.view.begin()), f_.overview.min.y},
         {std::max(x_of(f_.shown.view.end()), x_of(f_.shown.view.begin()) + 3), f_.overview.max.y}},
        f_.ui.palette.text, 2);
    const float x = x_of(f_.head.time());
    f_.ui.Fill(list_, {{x, f_.overview.min.y}, {x + f_.ui.scale, f_.overview.max.y}},
               f_.ui.palette.accent);
  }

  void DrawRuler() {
    const TextStyle style{Face::kSans, 9, f_.ui.palette.text_dim};
    const int most = static_cast<int>(f_.ruler.width() / (90 * f_.ui.scale));
    const Duration step = MarkDistance(f_.shown.view.span(), most);
    const Time first(f_.shown.view.begin().time_since_epoch() / step * step);
    for (Time at = std::max(first, Time{}); at < f_.shown.view.end(); at += step) {
      const float x = f_.XOf(at);
      if (x < f_.ruler.min.x) continue;
      f_.ui.Fill(list_, {{x, f_.ruler.max.y - 3 * f_.ui.scale}, {x + 1, f_.lanes.max.y}},
                 Fade(f_.ui.palette.text_dim, 0.15F));
      const bool is_covered = std::abs(x + 25 * f_.ui.scale - f_.NowX()) < 55 * f_.ui.scale;
      if (x + 60 * f_.ui.scale < f_.ruler.max.x && !is_covered) {
        f_.ui.RowText(list_, {x + 3 * f_.ui.scale, f_.ruler.min.y}, f_.ruler.height(), AxisText(at),
                      style);
      }
    }
    for (const Recording::Note& note : f_.run.recording().notes()) DrawNote(note);
    const Bookmarks& bookmarks = f_.state.workspace.bookmarks;
    for (const auto& [tick, text] : bookmarks.Of(f_.view.bookmark_name())) {
      if (tick < f_.run.size()) DrawBookmark(tick, text);
    }
  }

  // A flag.
  void DrawBookmark(std::size_t tick, const std::string& text) {
    const float x = f_.XOf(f_.run.TimeOf(tick));
    if (x < f_.ruler.min.x || x > f_.ruler.max.x) return;
    const float size = 7 * f_.ui.scale;
    const Box flag = {{x, f_.ruler.min.y}, {x + 1.4F * size, f_.ruler.min.y + size}};
    f_.ui.Fill(list_, {{x, f_.ruler.min.y}, {x + f_.ui.scale, f_.lanes.max.y}},
               Fade(f_.ui.palette.warning, 0.6F));
    list_.AddTriangleFilled({x, flag.min.y}, {flag.max.x, flag.center().y}, {x, flag.max.y},
                            f_.ui.palette.warning);
    f_.ui.items.Add("timeline/bookmark/" + std::to_string(tick), flag);
    if (!text.empty() && flag.Contains(FromIm(ImGui::GetIO().MousePos))) {
      Tooltip(f_.ui, text);
    }
  }

  void DrawNote(const Recording::Note& note) {
    if (f_.run.size() == 0) return;
    const float x = f_.XOf(f_.run.TimeOf(std::min(note.tick, f_.run.size() - 1)));
    if (x < f_.ruler.min.x || x > f_.ruler.max.x) return;
    const float size = 4 * f_.ui.scale;
    list_.AddTriangleFilled({x - size, f_.ruler.min.y}, {x + size, f_.ruler.min.y},
                            {x, f_.ruler.min.y + 1.6F * size}, f_.ui.palette.accent);
    const Box around = {{x - size, f_.ruler.min.y}, {x + size, f_.ruler.max.y}};
    if (around.Contains(FromIm(ImGui::GetIO().MousePos))) {
      Tooltip(f_.ui, note.note.kind + "\n" + note.note.text);
    }
  }

  void DrawBreaks() {
    for (const RunBreak& gap : f_.run.breaks()) {
      if (gap.tick == 0 || gap.tick >= f_.run.size()) continue;
      const float left = f_.XOf(f_.run.TimeOf(gap.tick - 1));
      const float right = std::max(f_.XOf(f_.run.TimeOf(gap.tick)), left + 4 * f_.ui.scale);
      if (right < f_.lanes.min.x || left > f_.lanes.max.x) continue;
      const Box box = {{std::max(left, f_.lanes.min.x), f_.ruler.min.y},
                       {std::min(right, f_.lanes.max.x), f_.lanes.max.y}};
      PaintHatched(f_.ui, list_, box,
                   gap.lost_ticks > 0 ? f_.ui.palette.warning : f_.ui.palette.text_dim);
      f_.ui.items.Add("timeline/gap/" + std::to_string(gap.tick), box);
      if (box.Contains(FromIm(ImGui::GetIO().MousePos))) {
        Tooltip(f_.ui, DescribeBreak(gap));
      }
    }
  }

  static std::string DescribeBreak(const RunBreak& gap) {
    if (gap.is_other_tree) return "another tree from here on";
    if (gap.is_other_run) return "the robot was restarted";
    if (gap.lost_ticks > 0) {
      return Count(gap.lost_ticks, "tick") + (gap.lost_ticks == 1 ? " is missing" : " are missing");
    }
    return "the tree was given another state";
  }

  void DrawRange() {
    if (!f_.shown.range) return;
    const Box box = {{std::max(f_.XOf(f_.shown.range->first), f_.lanes.min.x), f_.ruler.min.y},
                     {std::min(f_.XOf(f_.shown.range->second), f_.lanes.max.x), f_.lanes.max.y}};
    if (box.max.x <= box.min.x) return;
    f_.ui.Fill(list_, box, Fade(f_.ui.palette.accent, 0.15F));
    f_.ui.Frame(list_, box, Fade(f_.ui.palette.accent, 0.7F));
  }

  void DrawCursor() {
    const float x = f_.NowX();
    if (x < f_.lanes.min.x - 1 || x > f_.lanes.max.x + 1) return;
    const Color color = f_.head.is_at_now() ? f_.ui.palette.success : f_.ui.palette.text;
    f_.ui.Fill(list_, {{x - f_.ui.scale, f_.ruler.min.y}, {x + f_.ui.scale, f_.lanes.max.y}},
               color);
    f_.ui.items.Add("timeline/cursor", {{x - 2, f_.ruler.min.y}, {x + 2, f_.lanes.max.y}});
    const TextStyle style{Face::kBold, 10, WritingOn(color)};
    const std::string text = AxisText(f_.head.time());
    const float width = f_.ui.Width(text, style) + 8 * f_.ui.scale;
    const float left = std::clamp(x - width / 2, f_.lanes.min.x, f_.lanes.max.x - width);
    f_.ui.Fill(list_, {{left, f_.ruler.min.y}, {left + width, f_.ruler.max.y}}, color, 3);
    f_.ui.RowText(list_, {left + 4 * f_.ui.scale, f_.ruler.min.y}, f_.ruler.height(), text, style);
  }

  TimelineFrame f_;
  ImDrawList& list_;
};

constexpr float kHintRoom = 300;  // of the hint in the header of a wide tile

// Buttons in the header of the tile.
void DrawControls(const Ui& ui, EditorState& state, const RunView& run, const Box& box,
                  bool is_wide) {
  float x = box.min.x + 90 * ui.scale;
  const auto button = [&](const char* path, const std::string& text, const char* command,
                          bool active, Color tint) {
    const float width = ui.Width(text, {Face::kSans, 12, 0}) + 16 * ui.scale;
    const Box at = {{x, box.min.y + 2 * ui.scale},
                    {x + width, box.min.y + (kPanelHeader - 2) * ui.scale}};
    x += width + 3 * ui.scale;
    if (ui.Button(path, at, text, active, tint)) state.commands.Run(command);
    ExplainCommand(ui, state.commands, command);
  };
  const Playhead& head = run.playhead();
  const bool is_robot = run.source().is_robot();
  const bool is_live = !is_robot || run.phase() == RunPhase::kLive;
  button("timeline/back", icon::kStepBack, "run.back", false, 0);
  button("timeline/play", head.is_playing() ? icon::kPause : icon::kPlay, "run.play",
         head.is_playing(), ui.palette.accent);
  button("timeline/forward", icon::kStepForward, "run.forward", false, 0);
  button("timeline/now", is_robot ? "LIVE" : "END", "run.now", head.is_at_now(),
         is_live ? ui.palette.success : ui.palette.text_dim);
  char speed[16];
  std::snprintf(speed, sizeof(speed), "%s%g", icon::kTimesSign, head.speed());
  button("timeline/speed", speed, "run.faster", false, 0);
  ui.RowText(*ImGui::GetWindowDrawList(), {x + 8 * ui.scale, box.min.y}, kPanelHeader * ui.scale,
             run.is_at_beginning() ? "the beginning" : TickText(run.run(), head.tick()),
             {Face::kMono, 11, ui.palette.text},
             std::max(box.max.x - x - (is_wide ? kHintRoom : 12) * ui.scale, 1.0F));
}

}  // namespace

void DrawTimeline(const Ui& ui, EditorState& state, const Box& box) {
  RunView* run = state.workspace.run();
  const bool is_wide = box.width() > 900 * ui.scale;
  Panel(ui, "timeline", box, "TIMELINE",
        is_wide ? "wheel pan   Ctrl+wheel zoom   Shift+drag range   L now" : "", [&] {
          if (!run || !run->run().has_tree() || run->run().size() == 0) {
            Hint(ui, "What each node did over time, as soon as there are ticks.");
            return;
          }
          const Box body = {box.min + Point{1, kPanelHeader * ui.scale}, box.max - Point{1, 2}};
          Timeline(ui, state, *run, body).Draw();
        });
  if (run && run->run().size() > 0) DrawControls(ui, state, *run, box, is_wide);
}

}  // namespace coppice::editor
