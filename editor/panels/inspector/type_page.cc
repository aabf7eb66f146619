#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

#include "editor/panels/inspector/pages.h"
#include "editor/panels/widgets/inspector_row.h"
#include "editor/theme/icons.h"
#include "editor/workspace/type_editor.h"

namespace coppice::editor {
namespace {

constexpr float kRow = 24;
constexpr float kPad = 8;
constexpr float kDirection = 52;

std::string NameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

PortDirection Next(PortDirection direction) {
  if (direction == PortDirection::kInput) return PortDirection::kOutput;
  return direction == PortDirection::kOutput ? PortDirection::kInOut : PortDirection::kInput;
}

class TypePage {
 public:
  TypePage(const Ui& ui, EditorState& state)
      : ui_(ui),
        state_(state),
        type_(state.inspector.type),
        model_(*state.workspace.file()->models->Find(type_)) {}

  void Draw() {
    ImGui::SetCursorPosY(4 * ui_.scale);
    if (ActionRow(ui_, "inspector/type/done", "done: back to the node"))
      state_.inspector.type.clear();
    DrawKind();
    DrawFile();
    DrawDescription();
    HeadingRow(ui_, "ports");
    for (std::size_t i = 0; i < model_.ports.size(); ++i) DrawPort(i, model_.ports[i]);
    if (ActionRow(ui_, "inspector/type/new_port", "+ port")) AddPort();
    if (model_.category == NodeCategory::kSubTree) OfferShared();
    if (ActionRow(ui_, "inspector/type/remove", "remove this definition")) {
      action_ = [type = type_](TypeEditor& edit) { return edit.Remove(type); };
    }
    if (action_) Run();
  }

 private:
  void Run() {
    state_.after_frame = [&state = state_, now = ui_.now, action = std::move(action_)] {
      TypeEditor edit(state, now);
      const Outcome done = action(edit);
      if (!done) state.Notify(done.problem(), now, true);
    };
  }

  std::string Key(const std::string& what) const { return "type/" + type_ + "/" + what; }

  FieldLook Look(std::string_view hint) const {
    FieldLook look;
    look.hint = hint;
    look.color = ui_.palette.text;
    return look;
  }

  std::optional<std::string> Field(const std::string& name, std::string_view label,
                                   const std::string& value, const FieldLook& look) {
    return FieldRow(ui_, state_, "inspector/type/" + name, Key(name), label, value, look, "").value;
  }

  void DrawKind() {
    const std::string kind = ToString(model_.category);
    if (model_.category == NodeCategory::kSubTree) {
      ValueRow(ui_, "inspector/type/kind", "kind", kind, {Face::kSans, 12, ui_.palette.text});
      return;
    }
    FieldLook look = Look("");
    look.kind = FieldKind::kChoice;
    look.choices = {"Action", "Condition", "Control", "Decorator"};
    const auto chosen = Field("kind", "kind", kind, look);
    if (!chosen) return;
    action_ = [type = type_, chosen = *chosen](TypeEditor& edit) -> Outcome {
      const auto category = CategoryFromTag(chosen);
      if (!category) return Problem{"a node is an Action, a Condition, a Control or a Decorator"};
      return edit.SetKind(type, *category);
    };
  }

  void DrawFile() {
    FieldLook look = Look("");
    look.kind = FieldKind::kChoice;
    std::vector<std::string> paths;
    for (const Document& file : ProjectEditor(state_, ui_.now).Files()) {
      paths.push_back(file.file());
      look.choices.push_back(NameOf(file.file()));
    }
    const std::string where = NameOf(TypeEditor(state_, ui_.now).FileOf(type_));
    const auto chosen = Field("file", "written in", where, look);
    if (!chosen) return;
    const auto at = std::find(look.choices.begin(), look.choices.end(), *chosen);
    if (at == look.choices.end()) {
      state_.Notify("not a file of this project: include it first", ui_.now, true);
      return;
    }
    action_ = [type = type_, path = paths[static_cast<std::size_t>(at - look.choices.begin())]](
                  TypeEditor& edit) { return edit.MoveTo(type, path); };
  }

  void DrawDescription() {
    const auto text =
        Field("description", "description", InOneLine(model_.description), Look("what it does"));
    if (!text) return;
    action_ = [type = type_, text = *text](TypeEditor& edit) { return edit.Describe(type, text); };
  }

  // Names of types that are in use, for a start.
  std::vector<std::string> Types() const {
    std::vector<std::string> types = {"string", "bool", "int", "double", "Pose2D"};
    for (const auto& [id, model] : state_.workspace.file()->models->all()) {
      if (model.source == "built-in") continue;
      for (const PortModel& port : model.ports) {
        const bool known = std::find(types.begin(), types.end(), port.type) != types.end();
        if (!known && !port.type.empty()) types.push_back(port.type);
      }
    }
    return types;
  }

  // Three lines: name, direction and a button that removes it; type and default; what it is for.
  void DrawPort(std::size_t number, const PortModel& port) {
    const std::string path = "port/" + std::to_string(number);
    Line([&](const Box& line) { DrawName(path, line, port); });
    Line([&](const Box& line) { DrawTypeAndDefault(path, line, port); });
    Line([&](const Box& line) {
      const auto text =
          Part(path + "/description", line, InOneLine(port.description), Look("what it is for"));
      if (text) Change(port, [&](PortModel& to) { to.description = *text; });
    });
    ImGui::Dummy({0, 5 * ui_.scale});
  }

  void DrawName(const std::string& path, Box line, const PortModel& port) {
    if (Button(path + "/remove", line, 20, icon::kTimes, "Remove it")) {
      action_ = [type = type_, name = port.name](TypeEditor& edit) {
        return edit.RemovePort(type, name);
      };
    }
    const char* const direction = ToString(port.direction);
    if (Button(path + "/direction", line, kDirection, direction, "Input, output or both")) {
      Change(port, [&](PortModel& to) { to.direction = Next(port.direction); });
    }
    const auto name = Part(path + "/name", line, port.name, Look("name"));
    if (name) Change(port, [&](PortModel& to) { to.name = *name; });
  }

  void DrawTypeAndDefault(const std::string& path, const Box& line, const PortModel& port) {
    const float middle = line.center().x;
    FieldLook look = Look("type");
    look.kind = FieldKind::kChoice;
    look.choices = Types();
    const Box left = {line.min, {middle - ui_.scale, line.max.y}};
    const auto type = Part(path + "/type", left, port.type, look);
    if (type) Change(port, [&](PortModel& to) { to.type = *type; });
    look = Look("no default");
    look.can_clear = port.default_text.has_value();
    const Box right = {{middle + ui_.scale, line.min.y}, line.max};
    const FieldResult text =
        DrawField(ui_, state_, "inspector/type/" + path + "/default", Key(path + "/default"), right,
                  port.default_text.value_or(""), look);
    if (!text.value && !text.cleared) return;
    Change(port,
           [&](PortModel& to) { to.default_text = text.cleared ? std::nullopt : text.value; });
  }

  std::optional<std::string> Part(const std::string& path, const Box& box, const std::string& value,
                                  const FieldLook& look) {
    return DrawField(ui_, state_, "inspector/type/" + path, Key(path), box, value, look).value;
  }

  template <class Do>
  void Change(const PortModel& port, Do change) {
    PortModel to = port;
    change(to);
    action_ = [type = type_, name = port.name, to](TypeEditor& edit) {
      return edit.ChangePort(type, name, to);
    };
  }

  // A line of fields, which `draw` draws into the box that it gets.
  template <class Draw>
  void Line(Draw draw) const {
    const Point at = FromIm(ImGui::GetCursorScreenPos());
    const Point size = {ImGui::GetContentRegionAvail().x, kRow * ui_.scale};
    const Point margin = Point{kPad, 1} * ui_.scale;
    draw(Box{at + margin, at + size - margin});
    ImGui::SetCursorScreenPos(ToIm(at));
    ImGui::Dummy(ToIm(size));
  }

  // At the right end of what is left.
  bool Button(const std::string& name, Box& rest, float width, std::string_view text,
              const char* explanation) const {
    const Box box = {{rest.max.x - width * ui_.scale, rest.min.y}, rest.max};
    rest.max.x = box.min.x - 2 * ui_.scale;
    const bool pressed = ui_.Button("inspector/type/" + name, box, text);
    if (ImGui::IsItemHovered()) Tooltip(ui_, explanation);
    return pressed;
  }

  void AddPort() {
    const std::string name = TypeEditor(state_, ui_.now).FreePortName(type_);
    state_.input.focus_field =
        "inspector/type/port/" + std::to_string(model_.ports.size()) + "/name";
    action_ = [type = type_, name](TypeEditor& edit) {
      return edit.AddPort(type, {name, PortDirection::kInput, "", "", std::nullopt});
    };
  }

  // Keys that the tree shares although its model does not say so.
  void OfferShared() {
    const ProjectFiles files = ProjectEditor(state_, ui_.now).Files();
    for (const InterfacePort& port :
         state_.inspector.interfaces.Of(type_, state_.workspace, files)) {
      if (port.declared) continue;
      const std::string words =
          "+ " + port.model.name + ", " + ToString(port.model.direction) + " of its nodes";
      if (!ActionRow(ui_, "inspector/type/shared/" + port.model.name, words)) continue;
      action_ = [type = type_, model = port.model](TypeEditor& edit) {
        return edit.AddPort(type, model);
      };
    }
  }

  const Ui& ui_;
  EditorState& state_;
  const std::string type_;
  const KnownModel& model_;
  std::function<Outcome(TypeEditor&)> action_;
};

}  // namespace

void DrawTypeAction(const Ui& ui, EditorState& state, const std::string& type) {
  const bool is_defined = TypeEditor(state, ui.now).IsDefined(type);
  const bool is_tree = state.workspace.forest()->Find(type) >= 0;
  const char* const words = is_tree ? (is_defined ? "edit the declared ports" : "declare its ports")
                                    : (is_defined ? "edit this type" : "define this type");
  if (!ActionRow(ui, "inspector/edit_type", words)) return;
  state.after_frame = [&state] { state.commands.Run("type.define"); };
}

void DrawTypePage(const Ui& ui, EditorState& state) {
  if (!TypeEditor(state, ui.now).IsDefined(state.inspector.type) ||
      !state.workspace.file()->models->Find(state.inspector.type)) {
    state.inspector.type.clear();
    return;
  }
  TypePage(ui, state).Draw();
}

}  // namespace coppice::editor
