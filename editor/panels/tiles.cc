#include "editor/panels/tiles.h"

#include <algorithm>

#include "editor/panels/canvas_banners.h"
#include "editor/panels/canvas_tile.h"
#include "editor/panels/panels.h"
#include "editor/panels/run/run_tile.h"
#include "editor/panels/start_screen.h"
#include "editor/panels/timeline/timeline.h"
#include "editor/panels/widgets/panel.h"
#include "editor/panels/xml/xml.h"
#include "editor/workspace/simulation_editor.h"
#include "editor/workspace/tree_editor.h"

namespace coppice::editor {
namespace {

constexpr float kBar = 30;
constexpr float kStrip = 28;
constexpr float kCanvasBar = 26;
constexpr float kGap = 4;
constexpr float kSmallest = 80;      // of a tile
constexpr float kLeastCanvas = 200;  // of its height, as long as tiles above one another can yield
constexpr float kPartAcross = 0.4F;  // of what a larger screen gains, for tiles
constexpr float kPartDown = 0.5F;
constexpr Point kUsual = {1280, 800};  // the screen that the sizes of tiles are for

using DrawTile = void (*)(const Ui&, EditorState&, const Box&);

struct Tile {
  bool shown;
  DrawTile draw;
  float* bare = nullptr;  ///< its height if it has nothing to show but what it is for; else null
  bool folded = false;    ///< to its title
};

class Screen {
 public:
  Screen(const Ui& ui, EditorState& state, const Box& box) : ui_(ui), state_(state), box_(box) {}

  void Draw() {
    Box rest = box_;
    DrawTopBar(ui_, state_, TakeTop(rest, kBar));
    if (HasConnectionStrip(state_)) DrawConnectionStrip(ui_, state_, TakeTop(rest, kStrip));
    const float gap = kGap * ui_.scale;
    rest = {rest.min + Point{gap, gap}, rest.max - Point{gap, gap}};
    if (state_.screen.tiles.others) DrawAround(rest);
    DrawMiddle(rest);
  }

 private:
  // All but the canvas, which gets the rest.
  void DrawAround(Box& rest) {
    const Tiles& tiles = state_.screen.tiles;
    Splits& splits = state_.screen.splits;
    if (tiles.project || tiles.outline || tiles.types) LeftColumn(TakeLeft(rest, splits.left));
    const bool is_run = state_.workspace.run() != nullptr;
    if (is_run && (tiles.timeline || tiles.run)) DrawRunRow(rest);
    if (tiles.inspector || tiles.blackboard) {
      const Box column = TakeRight(rest, splits.right);
      Column("right", column, {tiles.inspector, DrawInspector},
             {tiles.blackboard, DrawBlackboard, nullptr, !is_run}, splits.right_part);
    }
    DrawRow(rest);
  }

  // All tabs of the run's tile are to be seen, if the timeline can yield.
  void DrawRunRow(Box& rest) {
    const Tiles& tiles = state_.screen.tiles;
    Splits& splits = state_.screen.splits;
    squeeze_ = SqueezeOfRows(rest);
    const Box row = TakeBottom(rest, splits.timeline, "split/timeline");
    const float most = std::max(1 - RunTabsWidth(ui_, state_) / row.width(), 0.4F);
    float part = std::min(splits.run_part, most);
    const float shown = part;
    Row("run", row, {tiles.timeline, DrawTimeline}, {tiles.run, DrawRunTile}, part);
    if (part != shown) splits.run_part = part;  // it was drawn
  }

  // In a low window the rows below the canvas share what it leaves them.
  float SqueezeOfRows(const Box& rest) const {
    const Tiles& tiles = state_.screen.tiles;
    const Splits& splits = state_.screen.splits;
    const bool has_row = (tiles.row && tiles.xml) || tiles.tests;
    const float wanted = (splits.timeline + (has_row ? splits.bottom : 0)) * GrownDown();
    const float room = rest.height() / ui_.scale - kLeastCanvas - kCanvasBar - kBar - 2 * kGap;
    return std::clamp(room / wanted, 0.4F, 1.0F);
  }

  // Text and problems. Beside a run, only what was opened.
  void DrawRow(Box& rest) {
    const Tiles& tiles = state_.screen.tiles;
    Splits& splits = state_.screen.splits;
    const bool is_run = state_.workspace.run() != nullptr;
    const bool folded = !tiles.row && !tiles.tests && !HasOnlyText();
    const Tile xml = {tiles.xml && !(is_run && !tiles.row), DrawXml};
    const Tile second =
        tiles.tests ? Tile{true, DrawTests} : Tile{tiles.problems && !is_run, DrawProblems};
    if (!xml.shown && !second.shown) return;
    if (folded) return DrawFoldedRow(rest, xml, second);
    Row("bottom", TakeBottom(rest, splits.bottom, "split/bottom"), xml, second, splits.bottom_part);
    FoldRowIfTiny();
  }

  // A file without a tree: its text and its problems are all there is to see.
  bool HasOnlyText() const { return state_.workspace.file() && !state_.workspace.view(); }

  // Drawn down to nothing, it is folded.
  void FoldRowIfTiny() {
    float& height = state_.screen.splits.bottom;
    if (height > kSmallest / 2) return;
    height = Splits().bottom;
    state_.screen.tiles.row = false;
  }

  // The titles alone; a click on one of them opens the row.
  void DrawFoldedRow(Box& rest, const Tile& first, const Tile& second) {
    const float height = kPanelHeader * ui_.scale;
    const Box row = {{rest.min.x, rest.max.y - height}, rest.max};
    rest.max.y = row.min.y - kGap * ui_.scale;
    Row("bottom", row, first, second, state_.screen.splits.bottom_part);
    ImGui::SetCursorScreenPos(ToIm(row.min));
    if (ui_.Hit("fold/bottom", row)) state_.screen.tiles.row = true;
    if (ImGui::IsItemHovered()) Tooltip(ui_, "Opens XML and PROBLEMS.");
  }

  Box TakeTop(Box& rest, float height) const {
    const Box taken = {rest.min, {rest.max.x, rest.min.y + height * ui_.scale}};
    rest.min.y = taken.max.y;
    return taken;
  }

  // Of the sizes of tiles: on a large screen they get a part of what is gained.
  float GrownAcross() const {
    const float gained = box_.width() / (kUsual.x * ui_.scale) - 1;
    return std::clamp(1 + kPartAcross * gained, 1.0F, 1.5F);
  }
  float GrownDown() const {
    const float gained = box_.height() / (kUsual.y * ui_.scale) - 1;
    return std::clamp(1 + kPartDown * gained, 1.0F, 1.5F) * squeeze_;
  }

  float Limit(float size, float room) const {
    return std::clamp(size * ui_.scale, kSmallest * ui_.scale,
                      std::max(kSmallest * ui_.scale, room - kSmallest * ui_.scale));
  }

  Box TakeLeft(Box& rest, float& size) {
    const float width = Limit(size * GrownAcross(), rest.width() * 0.6F);
    const float gap = kGap * ui_.scale;
    const Box taken = {rest.min, {rest.min.x + width, rest.max.y}};
    const Box bar = {{taken.max.x, rest.min.y}, {taken.max.x + gap, rest.max.y}};
    size += Splitter(ui_, "split/left", bar, true) / GrownAcross();
    rest.min.x = bar.max.x;
    return taken;
  }

  Box TakeRight(Box& rest, float& size) {
    const float width = Limit(size * GrownAcross(), rest.width() * 0.6F);
    const float gap = kGap * ui_.scale;
    const Box taken = {{rest.max.x - width, rest.min.y}, rest.max};
    const Box bar = {{taken.min.x - gap, rest.min.y}, {taken.min.x, rest.max.y}};
    size -= Splitter(ui_, "split/right", bar, true) / GrownAcross();
    rest.max.x = bar.min.x;
    return taken;
  }

  Box TakeBottom(Box& rest, float& size, const std::string& name) {
    const float height = Limit(size * GrownDown(), rest.height() * 0.8F);
    const float gap = kGap * ui_.scale;
    const Box taken = {{rest.min.x, rest.max.y - height}, rest.max};
    const Box bar = {{rest.min.x, taken.min.y - gap}, {rest.max.x, taken.min.y}};
    size -= Splitter(ui_, name, bar, false) / GrownDown();
    rest.max.y = bar.min.y;
    return taken;
  }

  void LeftColumn(Box column) {
    const Tiles& tiles = state_.screen.tiles;
    const bool upper = tiles.project || tiles.outline;
    // Nothing can be added to a run: the outline takes the room.
    const bool types = tiles.types && (!upper || !state_.workspace.run());
    if (types && upper) {
      const float gap = kGap * ui_.scale;
      float& part = state_.screen.splits.types_part;
      const float cut = column.min.y + std::clamp(part, 0.1F, 0.9F) * column.height();
      const Box bar = {{column.min.x, cut}, {column.max.x, cut + gap}};
      DrawTypes(ui_, state_, {{column.min.x, bar.max.y}, column.max});
      part += Splitter(ui_, "split/types_part", bar, false) * ui_.scale / column.height();
      column.max.y = bar.min.y;
    } else if (types) {
      DrawTypes(ui_, state_, column);
    }
    if (!upper) return;
    const bool has_files = !state_.workspace.files().empty();
    Column("left", column,
           {tiles.project, DrawProject, has_files ? nullptr : &state_.screen.splits.bare_project},
           {tiles.outline, DrawOutline}, state_.screen.splits.left_part);
  }

  // Two tiles one above the other; the one with something to show gets the room.
  void Column(const std::string& name, const Box& box, Tile first, Tile second, float& part) {
    if (!first.shown || !second.shown) {
      (first.shown ? first : second).draw(ui_, state_, box);
      return;
    }
    const float gap = kGap * ui_.scale;
    const bool is_first_bare = first.bare && !second.bare;
    float cut = box.min.y + std::clamp(part, 0.1F, 0.9F) * box.height();
    if (second.folded) {
      cut = box.max.y - kPanelHeader * ui_.scale;
      first.draw(ui_, state_, {box.min, {box.max.x, cut - gap}});
      return second.draw(ui_, state_, {{box.min.x, cut}, box.max});
    }
    if (is_first_bare) cut = box.min.y + Limit(*first.bare, box.height());
    const Box bar = {{box.min.x, cut}, {box.max.x, cut + gap}};
    first.draw(ui_, state_, {box.min, {box.max.x, bar.min.y}});
    second.draw(ui_, state_, {{box.min.x, bar.max.y}, box.max});
    const float moved = Splitter(ui_, "split/" + name + "_part", bar, false);
    if (is_first_bare) {
      *first.bare += moved;
    } else {
      part += moved * ui_.scale / box.height();
    }
  }

  // Two tiles side by side.
  void Row(const std::string& name, const Box& box, Tile first, Tile second, float& part) {
    if (!first.shown || !second.shown) {
      (first.shown ? first : second).draw(ui_, state_, box);
      return;
    }
    const float gap = kGap * ui_.scale;
    const float cut = box.min.x + std::clamp(part, 0.1F, 0.9F) * box.width();
    const Box bar = {{cut, box.min.y}, {cut + gap, box.max.y}};
    first.draw(ui_, state_, {box.min, {bar.min.x, box.max.y}});
    second.draw(ui_, state_, {{bar.max.x, box.min.y}, box.max});
    part += Splitter(ui_, "split/" + name + "_part", bar, true) * ui_.scale / box.width();
  }

  void DrawMiddle(Box rest) {
    DrawCanvasBar(ui_, state_, TakeTop(rest, kCanvasBar));
    const bool is_simulation = SimulationEditor(state_, ui_.now).IsShown();
    if (is_simulation) DrawSimulationBar(ui_, state_, TakeTop(rest, kBar));
    rest = DrawCanvasBanners(ui_, state_, rest);
    state_.screen.canvas_size = {rest.width(), rest.height()};
    ImGui::SetCursorScreenPos(ToIm(rest.min));
    if (state_.workspace.view()) {
      // What lies over the canvas takes clicks before it, and is painted over it.
      ImDrawListSplitter layers;
      ImDrawList& painting = *ImGui::GetWindowDrawList();
      layers.Split(&painting, 2);
      layers.SetCurrentChannel(&painting, 1);
      if (is_simulation) DrawSimulatedLeaf(ui_, state_, rest);
      DrawStopBar(ui_, state_, rest);
      layers.SetCurrentChannel(&painting, 0);
      ImGui::SetCursorScreenPos(ToIm(rest.min));
      DrawCanvasTile(ui_, state_, rest);
      layers.Merge(&painting);
      DrawNotice(rest);
      return;
    }
    ui_.items.Add("canvas", rest);
    DropRoot(rest);
    DrawStartScreen(ui_, state_, rest);
    DrawNotice(rest);
  }

  // A type that is dropped onto an empty tree becomes its root.
  void DropRoot(const Box& canvas) {
    const bool dropped = state_.drag.carried && ImGui::IsMouseReleased(0) &&
                         canvas.Contains(FromIm(ImGui::GetIO().MousePos));
    if (!dropped) return;
    state_.after_frame = [&s = state_, xml = state_.drag.xml, type = state_.drag.carried->label,
                          now = ui_.now] { TreeEditor(s, now).Add(xml, type, AddWhere::kChild); };
  }

  // What was just done or refused, at the lower edge of the canvas.
  void DrawNotice(const Box& canvas) const {
    const Notice& notice = state_.notice;
    const double age = ui_.now - notice.at;
    if (notice.text.empty() || age >= kNoticeSeconds) return;
    const TextStyle style{Face::kSans, 13,
                          notice.is_refusal ? ui_.palette.error : ui_.palette.text};
    const float width = std::min(ui_.Width(notice.text, style), canvas.width() - 60 * ui_.scale);
    const float height = 28 * ui_.scale;
    const Point at = {canvas.center().x - width / 2, canvas.max.y - height - 12 * ui_.scale};
    const Box box = {at - Point{12 * ui_.scale, 0}, at + Point{width + 12 * ui_.scale, height}};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ui_.Fill(list, box, ui_.palette.panel, 6 * ui_.scale);
    ui_.Frame(list, box, notice.is_refusal ? ui_.palette.error : ui_.palette.border, 6 * ui_.scale);
    ui_.RowText(list, at, height, notice.text, style, width + 1);
    ui_.items.Add("notice", box);
  }

  const Ui& ui_;
  EditorState& state_;
  const Box box_;
  float squeeze_ = 1;  // of the rows below the canvas
};

}  // namespace

void DrawTiles(const Ui& ui, EditorState& state, const Box& box) { Screen(ui, state, box).Draw(); }

}  // namespace coppice::editor
