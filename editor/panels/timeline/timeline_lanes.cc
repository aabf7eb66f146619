#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/live/key_item.h"
#include "editor/panels/run/run_text.h"
#include "editor/panels/timeline/lane_painter.h"
#include "editor/panels/timeline/timeline_frame.h"
#include "editor/panels/widgets/panel.h"
#include "editor/theme/icons.h"
#include "editor/timeline/slot_history.h"

namespace coppice::editor {
namespace {

class Lanes {
 public:
  explicit Lanes(TimelineFrame& frame) : f_(frame), list_(*ImGui::GetWindowDrawList()) {}

  void DrawLanes() {
    const float height = kLaneHeight * f_.ui.scale;
    const float fixed = (f_.state.blackboard.shown_key.empty() ? 1.0F : 2.5F) * height;
    const float room = std::max(f_.lanes.height() - fixed, 0.0F);
    const Box box = {f_.lanes.min,
                     {f_.lanes.max.x, f_.lanes.min.y + std::floor(room / height) * height}};
    ListLanes(static_cast<std::size_t>(box.height() / height));
    const std::size_t count = f_.shown.listed.size();
    const float all = height * static_cast<float>(count);
    f_.shown.scroll = std::clamp(f_.shown.scroll, 0.0F, std::max(all - box.height(), 0.0F));
    f_.shown.scroll = std::round(f_.shown.scroll / height) * height;  // no lane is cut
    const float below = f_.lanes.min.y + height * static_cast<float>(f_.shown.pinned);
    DrawRows(0, f_.shown.pinned, {box.min, {box.max.x, below}});
    DrawRows(f_.shown.pinned, count, {{box.min.x, below}, box.max});
    if (count == 0) {
      f_.ui.RowText(list_, f_.lanes.min + Point{8 * f_.ui.scale, height}, height,
                    "no node of this tree was ticked in this stretch",
                    {Face::kSans, 11, f_.ui.palette.text_dim});
    }
    if (f_.shown.pinned > 0) {
      f_.ui.Fill(list_, {{f_.labels.min.x, below - 1}, {box.max.x, below}},
                 Fade(f_.ui.palette.text_dim, 0.5F));
    }
    DrawScroll(box, all);
    const float top = f_.lanes.max.y - fixed;
    DrawDurations({{f_.lanes.min.x, top}, {f_.lanes.max.x, top + height}});
    if (!f_.state.blackboard.shown_key.empty()) {
      DrawKey({{f_.lanes.min.x, top + height}, f_.lanes.max});
    }
  }

 private:
  void DrawRows(std::size_t first, std::size_t end, const Box& box) {
    const float height = kLaneHeight * f_.ui.scale;
    list_.PushClipRect({f_.labels.min.x, box.min.y}, ToIm(box.max), true);
    for (std::size_t i = first; i < end; ++i) {
      const float top = f_.TopOf(i);
      if (top + height <= box.min.y || top >= box.max.y) continue;
      DrawLane(f_.shown.listed[i], {{f_.lanes.min.x, top}, {f_.lanes.max.x, top + height}});
      DrawPin(i, {{f_.labels.min.x, std::max(top, box.min.y)}, {f_.labels.max.x, top + height}});
    }
    list_.PopClipRect();
  }

  // At the end of the label: always of a pinned lane, of others while the mouse is there.
  void DrawPin(std::size_t row, const Box& label) {
    const std::string& path = f_.tracks.tree()->nodes[f_.shown.listed[row]].path;
    const Box at = {{label.max.x - 18 * f_.ui.scale, label.min.y}, label.max};
    const bool pinned = row < f_.shown.pinned;
    bool hovered = false;
    if (f_.ui.Hit("timeline/pin/" + path, at, &hovered)) {
      f_.state.workspace.pins.Toggle(f_.view.bookmark_name(), path);
    }
    if (hovered) Tooltip(f_.ui, pinned ? "Unpin it" : "Pin it to the top");
    if (!pinned && !label.Contains(FromIm(ImGui::GetIO().MousePos))) return;
    const Color color = pinned || hovered ? f_.ui.palette.accent : f_.ui.palette.text_dim;
    f_.ui.RowText(list_, at.min + Point{4 * f_.ui.scale, 0}, at.height(), icon::kPin,
                  {Face::kSans, 11, color});
  }

  // At the right end of the names: which part of all lanes is shown.
  void DrawScroll(const Box& box, float all) {
    if (all <= box.height() || box.height() <= 0) return;
    const float part = box.height() / all;
    const float top = box.min.y + f_.shown.scroll * part;
    const float right = f_.labels.max.x - 2 * f_.ui.scale;
    const Box bar = {{right - 3 * f_.ui.scale, top}, {right, top + box.height() * part}};
    f_.ui.Fill(list_, bar, Fade(f_.ui.palette.text_dim, 0.55F), 2 * f_.ui.scale);
    f_.ui.items.Add("timeline/scroll", bar);
  }

  // Pinned lanes, then those of nodes that do something in what is shown, in the order of the tree.
  // One row is left for these.
  void ListLanes(std::size_t room) {
    f_.shown.listed.clear();
    const LanePins& pins = f_.state.workspace.pins;
    for (const std::string& path : pins.Of(f_.view.bookmark_name())) {
      if (f_.shown.listed.size() + 1 >= room) break;
      for (NodeIndex i{0}; i < f_.tracks.shape().size(); ++i) {
        if (f_.tracks.tree()->nodes[i].path == path) f_.shown.listed.push_back(i);
      }
    }
    f_.shown.pinned = f_.shown.listed.size();
    const std::vector<NodeIndex> pinned = f_.shown.listed;
    const auto is_pinned = [&](NodeIndex node) {
      return std::find(pinned.begin(), pinned.end(), node) != pinned.end();
    };
    std::size_t first = f_.run.size();
    std::size_t end = 0;
    for (const Column& column : f_.columns) {
      if (column.is_empty()) continue;
      first = std::min(first, column.first);
      end = std::max(end, column.end);
    }
    for (NodeIndex i{0}; i < f_.tracks.shape().size(); ++i) {
      const StatusSet seen = f_.tracks.LaneOf(i).Seen(first, end);
      if ((seen & ~SetOf(Status::kIdle)) && !is_pinned(i)) f_.shown.listed.push_back(i);
    }
  }

  void Label(const Box& lane, const std::string& text, float indent, const TextStyle& style) {
    const float left = f_.labels.min.x + (8 + indent) * f_.ui.scale;
    f_.ui.RowText(list_, {left, lane.min.y}, lane.height(), text, style,
                  f_.labels.max.x - left - 20 * f_.ui.scale);
  }

  void DrawLane(NodeIndex node, const Box& lane) {
    const DescribedNode& described = f_.tracks.tree()->nodes[node];
    const TreeView* tree = f_.state.workspace.view();
    const bool selected = tree && tree->selected_run_node() == node;
    const Box row = {{f_.labels.min.x, lane.min.y}, lane.max};
    if (selected) f_.ui.Fill(list_, row, Fade(f_.ui.palette.row_selected, 0.6F));
    f_.ui.items.Add("timeline/" + described.path, lane);
    float depth = 0;
    for (NodeIndex i = node; f_.tracks.shape()[i].parent != i && depth < 8; ++depth) {
      i = f_.tracks.shape()[i].parent;
    }
    const auto& states = f_.view.state().states;
    const bool runs = node < states.size() && states[node].status == Status::kRunning;
    Label(lane, described.path.substr(described.path.rfind('/') + 1), depth * 6,
          {selected ? Face::kBold : Face::kSans, 11,
           runs ? f_.ui.palette.running_text : f_.ui.palette.text});
    const Box bars = {lane.min + Point{0, 2 * f_.ui.scale}, lane.max - Point{0, 2 * f_.ui.scale}};
    PaintBars(f_.ui, list_, bars, BarsOf(f_.tracks.LaneOf(node), f_.columns), f_.columns.size(),
              f_.NowX());
    DrawInjections(node, bars);
  }

  void DrawInjections(NodeIndex node, const Box& bars) {
    const auto& all = f_.tracks.injections();
    float last = -1e9F;
    auto at = std::lower_bound(
        all.begin(), all.end(), f_.run.TickAt(f_.shown.view.begin()),
        [](const Injection& injection, std::size_t tick) { return injection.tick < tick; });
    for (; at != all.end(); ++at) {
      const float x = f_.XOf(f_.run.TimeOf(at->tick));
      if (x > bars.max.x) return;
      if (at->node != node || x < last + 3 * f_.ui.scale) continue;
      last = x;
      f_.ui.Fill(list_, {{x, bars.min.y}, {x + 2 * f_.ui.scale, bars.max.y}}, f_.ui.palette.error);
    }
  }

  void DrawDurations(const Box& lane) {
    float most = 0.001F;
    std::vector<float> durations;
    for (const Column& column : f_.columns) {
      durations.push_back(f_.run.durations().Largest(column.first, column.end));
      most = std::max(most, durations.back());
    }
    const float step = lane.width() / static_cast<float>(f_.columns.size());
    for (std::size_t i = 0; i < durations.size(); ++i) {
      if (durations[i] <= 0) continue;
      const float height = std::max(durations[i] / most * (lane.height() - 3), 1.0F);
      const float x = lane.min.x + step * static_cast<float>(i);
      f_.ui.Fill(list_, {{x, lane.max.y - height}, {x + step, lane.max.y}},
                 Fade(f_.ui.palette.accent, 0.6F));
    }
    Label(lane, "one tick: up to " + MillisecondsText(static_cast<double>(most)), 0,
          {Face::kSans, 11, f_.ui.palette.text_dim});
  }

  void DrawKey(const Box& lane) {
    const TreeDescription& tree = *f_.tracks.tree();
    const std::optional<SlotIndex> key = KeyOfItem(tree, f_.state.blackboard.shown_key);
    if (!key) return;
    const std::string& name = tree.slots[*key].name;
    Label(lane, "{" + name + "}", 0, {Face::kSans, 11, f_.ui.palette.OfKey(name)});
    std::vector<std::size_t> ticks;
    std::size_t empty = 0;
    for (const Column& column : f_.columns) {
      if (column.is_empty()) {
        empty += ticks.empty();
      } else {
        ticks.push_back(column.end - 1);
      }
    }
    const float step = lane.width() / static_cast<float>(f_.columns.size());
    const Box box = {{lane.min.x + step * static_cast<float>(empty), lane.min.y},
                     {lane.min.x + step * static_cast<float>(empty + ticks.size()), lane.max.y}};
    PaintCurve(f_.ui, list_, box, SampleSlot(f_.run, *key, ticks));
  }

  TimelineFrame& f_;
  ImDrawList& list_;
};

}  // namespace

void DrawTimelineLanes(TimelineFrame& frame) { Lanes(frame).DrawLanes(); }

}  // namespace coppice::editor
