#include "editor/panels/widgets/port_editor.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "bt_core/model/keys.h"
#include "editor/panels/widgets/field.h"
#include "editor/workspace/tree_editor.h"

namespace coppice::editor {
namespace {

constexpr char kPrefix[] = "canvas/edit/";
constexpr float kHeight = 22;
constexpr float kLeastWidth = 190;

bool IsPortField(const std::string& path) {
  return path.compare(0, sizeof(kPrefix) - 1, kPrefix) == 0;
}

class PortEditor {
 public:
  PortEditor(const Ui& ui, EditorState& state, const Box& canvas, std::string field)
      : ui_(ui),
        state_(state),
        canvas_(canvas),
        field_(std::move(field)),
        port_(field_.substr(field_.rfind('/') + 1)),
        view_(*state.workspace.view()),
        scene_(*view_.scene()),
        node_(scene_.nodes[view_.selected()]) {}

  // False if another node is selected now.
  bool IsOfSelectedNode() const { return field_ == PortField(node_, port_); }

  void Draw() {
    const bool is_new = state_.input.focus_field == field_;
    const std::string value(Given());
    const FieldLook look = Look(value);
    const Box box = Place();
    const float name = NameWidth();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ui_.Fill(list, box, ui_.palette.panel, 3 * ui_.scale);
    ui_.Frame(list, box, ui_.palette.accent, 3 * ui_.scale);
    ui_.RowText(list, box.min + Point{6 * ui_.scale, 0}, box.height(), port_, NameStyle());
    const Box field = {{box.min.x + name, box.min.y}, box.max};
    const std::string typed = Typed(value);
    const FieldResult result = DrawField(ui_, state_, field_, field_, field, value, look);
    if (is_new) state_.input.typing = {field_, value};  // the field is active one frame later
    if (const int by = Step(typed, look)) {
      state_.input.typing = {};
      GoOn(by, typed == value ? std::nullopt : std::optional(typed));
    } else if (result.value) {
      Set(*result.value);
    }
  }

 private:
  TextStyle NameStyle() const { return {Face::kSans, 11, ui_.palette.text_dim}; }
  float NameWidth() const { return ui_.Width(port_, NameStyle()) + 14 * ui_.scale; }

  std::string_view Given() const {
    for (std::uint32_t i = node_.first_port; i < node_.first_port + node_.port_count; ++i) {
      if (scene_.ports[i].name == port_) return scene_.ports[i].value;
    }
    return {};
  }

  std::string Typed(const std::string& value) const {
    return state_.input.typing.key == field_ ? state_.input.typing.text : value;
  }

  FieldLook Look(const std::string& value) const {
    FieldLook look;
    look.hint = "not given";
    const std::string_view key = KeyOf(value, port_);
    look.color = key.empty() ? ui_.palette.text : ui_.palette.OfKey(key);
    look.keys = KeysSeenBy(scene_, node_);
    return look;
  }

  // Over the row of the port; below the node if it has none. Within the canvas.
  Box Place() const {
    const std::string item = "canvas/" + scene_.tree_id + "/" + node_.path;
    const Box* const body = ui_.items.Find(item);
    const Box* const row = ui_.items.Find(item + "/port/" + port_);
    const Box near = row ? *row : body ? Box{{body->min.x, body->max.y}, body->max} : canvas_;
    const float least = std::max(kLeastWidth * ui_.scale, NameWidth() + 110 * ui_.scale);
    const Point size = {std::max(near.width(), least), kHeight * ui_.scale};
    const Point at = {
        std::clamp(near.min.x, canvas_.min.x, std::max(canvas_.min.x, canvas_.max.x - size.x)),
        std::clamp(near.min.y, canvas_.min.y, std::max(canvas_.min.y, canvas_.max.y - size.y))};
    return {at, at + size};
  }

  // +1 or -1 for Tab and Shift+Tab, where it has nothing to complete.
  int Step(const std::string& typed, const FieldLook& look) const {
    for (const KeyEvent& event : state_.input.keys) {
      if (event.key != kKeyTab) continue;
      if (event.modifiers & kShift) return -1;
      if (Completions(typed, look).empty()) return +1;
    }
    return 0;
  }

  void Set(const std::string& value) {
    state_.after_frame = [&state = state_, now = ui_.now, port = port_, value] {
      TreeEditor(state, now).SetValue(port, value);
    };
  }

  void GoOn(int by, std::optional<std::string> value) {
    state_.after_frame = [&state = state_, now = ui_.now, port = port_, value = std::move(value),
                          by] {
      if (value && !TreeEditor(state, now).SetValue(port, *value)) return;
      GoToNext(state, port, by, now);
    };
  }

  // The next port of the node; behind the last one, the first of the next node that has some.
  static void GoToNext(EditorState& state, const std::string& port, int by, double now) {
    TreeView& view = *state.workspace.view();
    const Scene& scene = *view.scene();
    std::uint32_t node = view.selected();
    std::vector<std::string> names = PortNamesOf(state, scene, node, now);
    const auto at = std::find(names.begin(), names.end(), port);
    auto next = static_cast<std::ptrdiff_t>(at - names.begin()) + by;
    while (next < 0 || next >= static_cast<std::ptrdiff_t>(names.size())) {
      node += static_cast<std::uint32_t>(by);  // before the first one it wraps around
      if (node >= scene.nodes.size()) return;
      names = PortNamesOf(state, scene, node, now);
      next = by > 0 ? 0 : static_cast<std::ptrdiff_t>(names.size()) - 1;
    }
    view.Select(node);
    view.Reveal(state.screen.canvas_size);
    EditPort(state, names[static_cast<std::size_t>(next)]);
  }

  const Ui& ui_;
  EditorState& state_;
  const Box canvas_;
  const std::string field_;
  const std::string port_;
  const TreeView& view_;
  const Scene& scene_;
  const SceneNode& node_;
};

}  // namespace

void DrawPortEditor(const Ui& ui, EditorState& state, const Box& canvas) {
  const bool begins = IsPortField(state.input.focus_field);
  const std::string field = begins ? state.input.focus_field : state.input.typing.key;
  const TreeView* const view = state.workspace.view();
  if (!IsPortField(field) || !view || view->selected() == kNoSceneNode) return;
  PortEditor editor(ui, state, canvas, field);
  if (editor.IsOfSelectedNode()) return editor.Draw();
  if (begins) state.input.focus_field.clear();
}

}  // namespace coppice::editor
