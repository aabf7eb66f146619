#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "bt_core/model/keys.h"
#include "bt_core/nodes/guards.h"
#include "bt_core/nodes/node_type.h"
#include "editor/canvas/canvas.h"
#include "editor/canvas/layout/node_metrics.h"
#include "editor/document/script_check.h"
#include "editor/live/key_search.h"
#include "editor/panels/inspector/pages.h"
#include "editor/panels/widgets/inspector_row.h"
#include "editor/scene/problem_places.h"
#include "editor/workspace/node_ports.h"
#include "editor/workspace/type_editor.h"

namespace coppice::editor {
namespace {

// What the user did; it is done after the panel is drawn, for it replaces what is drawn.
using Action = std::function<void(TreeEditor&)>;

constexpr char kAutoremap[] = "_autoremap";
constexpr std::size_t kLongestField = 20'000;  // bytes: nobody reads more in one line
constexpr std::size_t kLongestTooltip = 1'000;

// The values that a port of a built-in node can have, if its type is an enum.
std::vector<std::string> ChoicesOf(std::string_view id, std::string_view port) {
  std::vector<std::string> names;
  for (const BuiltIn& built_in : BuiltIns()) {
    if (built_in.manifest.id != id) continue;
    for (const PortDeclaration& one : built_in.manifest.ports) {
      if (one.name != port || !one.type || !one.type->enumerators) continue;
      for (const Enumerator& value : *one.type->enumerators) names.emplace_back(value.name);
    }
  }
  return names;
}

// Not one of those whose values are any text.
bool IsOwnType(std::string_view type) {
  return !type.empty() && type != "string" && type != "std::string" && type != "script" &&
         type.find("Any") == std::string_view::npos;
}

class NodePage {
 public:
  NodePage(const Ui& ui, EditorState& state, std::shared_ptr<const Scene> scene,
           const SceneNode& node)
      : ui_(ui),
        state_(state),
        scene_(std::move(scene)),
        node_(node),
        can_edit_(TreeEditor(state, ui.now).CanEdit().ok()) {}

  void Draw() {
    ImGui::SetCursorPosY(4 * ui_.scale);
    DrawName();
    Field("type", std::string(node_.id) + "  (" + Category() + ")", ui_.palette.text);
    Field("path", node_.path, ui_.palette.text);
    DrawStatus();
    const SourceLocation where = Where();
    if (where.line > 0) {
      Field("source",
            where.file.substr(where.file.rfind('/') + 1) + ":" + std::to_string(where.line),
            ui_.palette.text);
    }
    if (node_.model && !node_.model->source.empty()) {
      Field("model", node_.model->source.substr(node_.model->source.rfind('/') + 1),
            ui_.palette.text);
    }
    if (node_.scope < scene_->scopes.size()) {
      Field("blackboard", scene_->scopes[node_.scope], ui_.palette.text);
    }
    DrawPorts();
    DrawScripts();
    if (node_.model && !node_.model->description.empty())
      Hint(ui_, InOneLine(node_.model->description));
    if (can_edit_) DrawType();
    if (action_) {
      TreeEditor edit(state_, ui_.now);
      action_(edit);
    }
  }

 private:
  std::string Category() const {
    if (node_.shape == Shape::kSubTree) return "SubTree";
    return node_.model ? ToString(node_.model->category) : "unknown";
  }

  const Document& TheDocument() const {
    return *state_.workspace.forest()->documents()[node_.document];
  }

  SourceLocation Where() const {
    return TheDocument().Location(TheDocument().element(node_.element).offset);
  }

  void DrawName() {
    const std::string given(
        TheDocument().AttributeValue(TheDocument().element(node_.element), "name"));
    if (!can_edit_) {
      Field("name", std::string(node_.name), ui_.palette.text);
      return;
    }
    FieldLook look;
    look.hint = node_.id;
    look.color = ui_.palette.text;
    const FieldResult result = Edit("inspector/name", "name", given, look);
    if (!result.value) return;
    action_ = [name = *result.value](TreeEditor& edit) { edit.Rename(name); };
  }

  void DrawStatus() {
    if (node_.run_node == kNoNode || !state_.workspace.tree_state()) return;
    const NodeState state = StateOf(state_.workspace.tree_state(), node_);
    if (state.status == Status::kIdle) {
      const std::string was = state.before == Status::kIdle
                                  ? "IDLE, never run"
                                  : std::string("IDLE, was ") + ToString(state.before);
      Field("status", was, ui_.palette.text_dim);
      return;
    }
    const double seconds = std::chrono::duration<double>(ui_.clock - state.since).count();
    Field("status", std::string(ToString(state.status)) + "  " + DurationText(seconds),
          ui_.palette.TextOf(state.status));
  }

  void Field(std::string_view label, std::string_view value, Color color) {
    const Row row =
        ValueRow(ui_, "inspector/" + std::string(label), label, value, {Face::kSans, 12, color});
    if (row.hovered) Tooltip(ui_, value);
  }

  FieldResult Edit(const std::string& path, const std::string& attribute, const std::string& value,
                   const FieldLook& look) {
    const std::string key = attribute + "@" + scene_->tree_id + "/" + node_.path;
    return FieldRow(ui_, state_, path, key, attribute, value, look, ProblemOf(attribute));
  }

  // What the checker says of it, or nothing.
  std::string ProblemOf(const std::string& attribute) const {
    const OpenFile* file = state_.workspace.file();
    const Attribute* found =
        TheDocument().FindAttribute(TheDocument().element(node_.element), attribute);
    const Diagnostic* problem =
        file && found ? ProblemOfAttribute(TheDocument(), *found, file->problems) : nullptr;
    return problem ? problem->message : std::string();
  }

  void EditAttribute(const std::string& path, const std::string& name, const std::string& value,
                     const FieldLook& look) {
    const FieldResult result = Edit(path, name, value, look);
    if (result.cleared) {
      action_ = [name](TreeEditor& edit) { edit.ClearValue(name); };
    } else if (result.value) {
      action_ = [name, text = *result.value](TreeEditor& edit) { edit.SetValue(name, text); };
    }
  }

  const PortLine* Given(std::string_view name) const {
    for (std::uint32_t i = 0; i < node_.port_count; ++i) {
      const PortLine& port = scene_->ports[node_.first_port + i];
      if (port.name == name) return &port;
    }
    return nullptr;
  }

  // Declared ports in the declared order, given or not; then the other attributes.
  void DrawPorts() {
    const std::vector<PortModel> declared = PortsToGive(state_, node_, ui_.now);
    const bool may_have_any = can_edit_ && TakesAnyPort();
    bool any = !declared.empty() || may_have_any;
    for (std::uint32_t i = 0; i < node_.port_count; ++i) {
      any = any || !IsGuardAttribute(scene_->ports[node_.first_port + i].name);
    }
    if (any) HeadingRow(ui_, "ports");
    for (const PortModel& port : declared) DrawPort(port, Given(port.name));
    for (std::uint32_t i = 0; i < node_.port_count; ++i) {
      const PortLine& port = scene_->ports[node_.first_port + i];
      const bool is_drawn =
          std::any_of(declared.begin(), declared.end(),
                      [&](const PortModel& one) { return one.name == port.name; });
      if (!is_drawn && !IsGuardAttribute(port.name) && port.name != kAutoremap) DrawOther(port);
    }
    if (may_have_any) DrawNewPort();
    if (can_edit_ && IsSubTree()) DrawAutoremap();
  }

  bool IsSubTree() const { return node_.shape == Shape::kSubTree; }
  bool TakesAnyPort() const { return IsSubTree() || !node_.model; }

  // A row in which a name makes a port of that name.
  void DrawNewPort() {
    FieldLook look;
    look.hint = "name of a port";
    look.color = ui_.palette.text;
    const std::optional<std::string> name = Edit("inspector/new_port", "+ port", "", look).value;
    if (!name) return;
    action_ = [name = *name, &state = state_](TreeEditor& edit) {
      if (edit.AddPort(name)) state.input.focus_field = "inspector/port/" + name;
    };
  }

  void DrawAutoremap() {
    FieldLook look;
    look.kind = FieldKind::kBool;
    look.color = ui_.palette.text;
    look.hint = "false";
    look.can_clear = Given(kAutoremap) != nullptr;
    const PortLine* given = Given(kAutoremap);
    EditAttribute("inspector/autoremap", kAutoremap, given ? std::string(given->value) : "", look);
    if (ImGui::IsItemHovered()) {
      Tooltip(ui_,
              "The keys of the inner tree are those of the outer tree, except for private "
              "keys and those given here.");
    }
  }

  // What can be done to the type of the node.
  void DrawType() {
    const std::string id(node_.id);
    const bool is_unknown = !node_.model && node_.shape == Shape::kUnknown;
    const bool is_defined = !id.empty() && TypeEditor(state_, ui_.now).IsDefined(id);
    if (is_unknown) {
      Hint(ui_, "No model describes this type: it takes any port, and nothing is checked.");
      ImGui::Dummy({0, 4 * ui_.scale});
    }
    if (is_unknown || is_defined || IsSubTree()) DrawTypeAction(ui_, state_, id);
  }

  const std::vector<std::string>& Keys() {
    if (keys_.empty()) keys_ = KeysSeenBy(*scene_, node_);
    return keys_;
  }

  Color ColorOf(std::string_view port, std::string_view value) const {
    const std::string_view key = KeyOf(value, port);
    return key.empty() ? ui_.palette.text : ui_.palette.OfKey(key);
  }

  void DrawPort(const PortModel& port, const PortLine* given) {
    const std::string_view in_text = given ? std::string_view(given->value) : "";
    const std::string path = "inspector/port/" + port.name;
    if (!can_edit_ || in_text.size() > kLongestField) {
      ShowPort(port.name, given ? in_text : port.default_text.value_or("(not given)"), &port);
      return;
    }
    const std::string value(in_text);
    FieldLook look;
    const std::string outside = "{" + port.name + "}";
    const bool from_outside = node_.autoremap && !IsPrivateKey(port.name);
    look.hint = from_outside        ? std::string_view(outside)
                : port.default_text ? std::string_view(*port.default_text)
                                    : "not given";
    look.color = ColorOf(port.name, value);
    look.can_clear = given != nullptr;
    const bool is_literal = KeyOf(value, port.name).empty();
    if (is_literal) look.kind = KindOf(port.type);
    look.choices = ChoicesOf(node_.id, port.name);
    const bool may_be_enum = KindOf(port.type) == FieldKind::kText && IsOwnType(port.type);
    if (look.choices.empty() && may_be_enum) look.choices = ChoicesIn(port.description);
    look.keys = Keys();
    look.is_script = port.type == "script";
    if (!look.choices.empty() && is_literal) look.kind = FieldKind::kChoice;
    EditAttribute(path, port.name, value, look);
    if (ImGui::IsItemHovered() && state_.input.typing.key.empty())
      PortTooltip(&port, given ? value : std::string(look.hint));
    if (port.type == "script" && !value.empty()) DrawScriptProblem(value);
  }

  void DrawOther(const PortLine& port) {
    if (!can_edit_ || port.value.size() > kLongestField) {
      ShowPort(std::string(port.name), port.value, nullptr);
      return;
    }
    FieldLook look;
    look.color = ColorOf(port.name, port.value);
    look.can_clear = true;
    look.keys = Keys();
    EditAttribute("inspector/port/" + std::string(port.name), std::string(port.name),
                  std::string(port.value), look);
  }

  void ShowPort(const std::string& name, std::string_view value, const PortModel* model) {
    const std::string now = ValueNow(name);
    const Row row =
        ValueRow(ui_, "inspector/port/" + name, name,
                 BeginningOf(value, kLongestTooltip) + (now.empty() ? "" : "  = " + now),
                 {Face::kMono, 11, ColorOf(name, value)});
    if (row.hovered) PortTooltip(model, value);
  }

  // What the key of a port holds in the run; empty if there is no run, or nothing is known.
  std::string ValueNow(std::string_view name) const {
    const PortLine* const given = Given(name);
    if (!state_.workspace.run() || !given) return {};
    return state_.canvas.port_values.Of(static_cast<std::uint32_t>(given - scene_->ports.data()));
  }

  void DrawScripts() {
    bool headed = false;
    for (const std::string_view name : kGuardAttributes) {
      const PortLine* given = Given(name);
      if (!given) continue;
      if (!headed) HeadingRow(ui_, "guards and hooks");
      headed = true;
      if (can_edit_) {
        FieldLook look;
        look.color = ui_.palette.text;
        look.can_clear = true;
        look.keys = Keys();
        look.is_script = true;
        EditAttribute("inspector/script/" + std::string(name), std::string(name),
                      std::string(given->value), look);
      } else {
        ShowPort(std::string(name), given->value, nullptr);
      }
      DrawScriptProblem(given->value);
    }
    if (can_edit_) DrawNewScript();
  }

  void DrawScriptProblem(std::string_view script) {
    const std::string problem = ScriptProblemOf(script);
    if (problem.empty()) return;
    const Row row = NextRow(ui_, "inspector/script_problem", false, 20);
    ui_.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{8 * ui_.scale, 0},
                row.box.height(), problem, {Face::kSans, 11, ui_.palette.error},
                row.box.width() - 16 * ui_.scale);
    if (row.hovered) Tooltip(ui_, problem);
  }

  // A row that gives the node a guard or hook that it does not have yet.
  void DrawNewScript() {
    const Row row = NextRow(ui_, "inspector/new_script", false, 24);
    ui_.RowText(*ImGui::GetWindowDrawList(), row.box.min + Point{8 * ui_.scale, 0},
                row.box.height(), "+ guard or hook", {Face::kSans, 11, ui_.palette.text_dim});
    if (row.clicked) ImGui::OpenPopup("new script");
    ImGui::SetNextWindowPos({row.box.min.x + 8 * ui_.scale, row.box.max.y});
    const MenuSpacing spacing(ui_);
    if (!ImGui::BeginPopup("new script")) return;
    for (const std::string_view name : kGuardAttributes) {
      if (Given(name)) continue;
      const std::string text(name);
      const bool chosen = ImGui::MenuItem(text.c_str());
      ui_.items.Add("inspector/new_script/" + text,
                    {FromIm(ImGui::GetItemRectMin()), FromIm(ImGui::GetItemRectMax())});
      if (!chosen) continue;
      action_ = [text, &state = state_](TreeEditor& edit) {
        if (edit.SetValue(text, "true")) state.input.focus_field = "inspector/script/" + text;
      };
    }
    ImGui::EndPopup();
  }

  // Who writes and who reads the key of an attribute: "written by Plan; read by Follow, Say".
  std::string UsersOf(std::string_view name) const {
    const PortLine* port = Given(name);
    const TreeView* view = state_.workspace.view();
    if (!port || !view) return {};
    const KeyUses& uses = view->keys();
    const std::uint32_t key =
        uses.key_of_port[static_cast<std::size_t>(port - scene_->ports.data())];
    if (key == kNoKey) return {};
    std::string writers, readers;
    for (const KeyUse& use : uses.uses[key]) {
      const std::string user(scene_->nodes[use.node].name);
      if (use.writes) writers += (writers.empty() ? "" : ", ") + user;
      if (use.reads) readers += (readers.empty() ? "" : ", ") + user;
    }
    return "\nwritten by " + (writers.empty() ? "no port" : writers) + "\nread by " +
           (readers.empty() ? "no port" : readers);
  }

  void PortTooltip(const PortModel* model, std::string_view value) {
    std::string text = BeginningOf(value, kLongestTooltip);
    if (can_edit_ && value.size() > kLongestField) {
      text += "\ntoo long for a field: the XML has it whole";
    }
    if (model) text += UsersOf(model->name);
    if (model) {
      text += std::string("\n") + ToString(model->direction) + " ";
      text += TypeText(model->type);
      if (!model->description.empty()) text += "\n" + InOneLine(model->description);
    }
    Tooltip(ui_, text);
  }

  const Ui& ui_;
  EditorState& state_;
  const std::shared_ptr<const Scene> scene_;
  const SceneNode& node_;
  const bool can_edit_;
  Action action_;
  std::vector<std::string> keys_;
};

}  // namespace

void DrawNodePage(const Ui& ui, EditorState& state) {
  const TreeView& view = *state.workspace.view();
  NodePage(ui, state, view.scene(), view.scene()->nodes[view.selected()]).Draw();
}

}  // namespace coppice::editor
