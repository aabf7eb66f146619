#include "editor/workspace/type_editor.h"

#include <utility>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/xml_text.h"
#include "editor/document/model_edits.h"
#include "editor/document/suggested_model.h"

namespace coppice::editor {
namespace {

Problem NotDefined(const std::string& type) { return {"no file of this project defines " + type}; }

Outcome CheckPortName(const std::string& name) {
  if (name.empty()) return Problem{"a port needs a name"};
  if (IsXmlName(name) && !IsReservedAttribute(name)) return {};
  return Problem{name + " cannot be the name of a port"};
}

}  // namespace

TypeEditor::Model TypeEditor::Find(const std::string& type) const {
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const ElementIndex model = FindModel(files_[i], type);
    if (model != kNoElement) return {i, model};
  }
  return {};
}

std::string TypeEditor::FileOf(const std::string& type) const {
  const Model model = Find(type);
  return model.element == kNoElement ? std::string() : files_[model.file].file();
}

Outcome TypeEditor::Change(const std::string& name, std::size_t file, Edit edit) {
  std::vector<Edit> edits(files_.size());
  edits[file] = std::move(edit);
  return project_.Change(name, files_, edits);
}

// Where models are, in the shown file or in another; else the shown file.
std::size_t TypeEditor::FileForNew() const {
  const std::optional<ElementPlace> shown = state_.workspace.ShownTree();
  std::size_t best = 0;
  bool has_models = false;
  for (std::size_t i = 0; i < files_.size(); ++i) {
    const bool is_shown = shown && files_[i].file() == shown->path;
    bool has = false;
    for (const Element& element : files_[i].elements())
      has = has || element.tag == "TreeNodesModel";
    const bool is_better = has && (!has_models || is_shown);
    if (is_better || (is_shown && !has_models)) best = i;
    has_models = has_models || has;
  }
  return best;
}

NodeModel TypeEditor::Suggested(const std::string& type) const {
  const bool is_tree = !TreesCalled(files_, type).empty();
  const KnownModel* const known = Models().Find(type);
  if (known && !is_tree) return *known;
  if (!is_tree) return SuggestModel(files_, type);
  NodeModel model;
  model.id = type;
  model.category = NodeCategory::kSubTree;
  for (const InterfacePort& port : InterfaceOf(files_, Models(), type)) {
    model.ports.push_back(port.model);
  }
  return model;
}

Outcome TypeEditor::Define(const std::string& type) {
  if (IsDefined(type)) return Problem{type + " is defined already"};
  if (files_.empty()) return Problem{"no file is open"};
  const KnownModel* const known = Models().Find(type);
  if (known && known->source == kBuiltIn) return Problem{type + " is built in"};
  const std::size_t file = FileForNew();
  return Change("Define " + type, file, AddModel(files_[file], Suggested(type)));
}

Outcome TypeEditor::Remove(const std::string& type) {
  const Model model = Find(type);
  if (model.element == kNoElement) return NotDefined(type);
  return Change("Remove the definition of " + type, model.file,
                RemoveModel(files_[model.file], model.element));
}

Outcome TypeEditor::MoveTo(const std::string& type, const std::string& path) {
  const Model model = Find(type);
  if (model.element == kNoElement) return NotDefined(type);
  const Document& from = files_[model.file];
  std::vector<Edit> edits(files_.size());
  for (std::size_t i = 0; i < files_.size(); ++i) {
    if (files_[i].file() != path || i == model.file) continue;
    const Element& element = from.element(model.element);
    const std::string_view text = from.text();
    edits[i] = AddModel(files_[i], text.substr(element.offset, element.end - element.offset));
    edits[model.file] = RemoveModel(from, model.element);
  }
  return project_.Change("Define " + type + " in " + path.substr(path.rfind('/') + 1), files_,
                         edits);
}

Outcome TypeEditor::SetKind(const std::string& type, NodeCategory kind) {
  const Model model = Find(type);
  if (model.element == kNoElement) return NotDefined(type);
  return Change("Make " + type + " a " + ToString(kind), model.file,
                SetTag(files_[model.file], model.element, ToString(kind)));
}

Outcome TypeEditor::Describe(const std::string& type, const std::string& description) {
  const Model model = Find(type);
  if (model.element == kNoElement) return NotDefined(type);
  return Change("Describe " + type, model.file,
                DescribeModel(files_[model.file], model.element, description));
}

Outcome TypeEditor::AddPort(const std::string& type, const PortModel& port) {
  const Model model = Find(type);
  if (model.element == kNoElement) return NotDefined(type);
  if (Outcome named = CheckPortName(port.name); !named) return named;
  const Document& document = files_[model.file];
  if (FindPort(document, model.element, port.name) != kNoElement) {
    return Problem{type + " has a port " + port.name + " already"};
  }
  return Change("Add port " + port.name + " to " + type, model.file,
                editor::AddPort(document, model.element, port));
}

Outcome TypeEditor::RemovePort(const std::string& type, const std::string& port) {
  const Model model = Find(type);
  if (model.element == kNoElement) return NotDefined(type);
  const ElementIndex element = FindPort(files_[model.file], model.element, port);
  if (element == kNoElement) return Problem{type + " has no port " + port};
  return Change("Remove port " + port + " of " + type, model.file,
                RemoveElement(files_[model.file], element));
}

Expected<std::vector<Edit>> TypeEditor::RenamedPort(const std::string& type,
                                                    const std::string& port,
                                                    const std::string& to) const {
  const std::vector<ElementIn> trees = TreesCalled(files_, type);
  if (!trees.empty()) return RenameKey(files_, Models(), trees[0], port, to);
  std::vector<Edit> edits(files_.size());
  for (std::size_t f = 0; f < files_.size(); ++f) {
    for (ElementIndex i{0}; i < files_[f].elements().size(); ++i) {
      if (!IsNode(files_[f], i) || TypeOf(files_[f], i) != type) continue;
      if (files_[f].FindAttribute(files_[f].element(i), to)) {
        return Problem{"a node of this type has an attribute " + to + " already"};
      }
      edits[f] = Merge(std::move(edits[f]), RenameAttribute(files_[f], i, port, to));
    }
  }
  return edits;
}

Outcome TypeEditor::ChangePort(const std::string& type, const std::string& port,
                               const PortModel& to) {
  const Model model = Find(type);
  if (model.element == kNoElement) return NotDefined(type);
  const Document& document = files_[model.file];
  const ElementIndex element = FindPort(document, model.element, port);
  if (element == kNoElement) return Problem{type + " has no port " + port};
  if (to.name == port) {
    return Change("Change port " + port + " of " + type, model.file,
                  editor::ChangePort(document, element, to));
  }
  if (Outcome named = CheckPortName(to.name); !named) return named;
  if (FindPort(document, model.element, to.name) != kNoElement) {
    return Problem{type + " has a port " + to.name + " already"};
  }
  Expected<std::vector<Edit>> edits = RenamedPort(type, port, to.name);
  if (!edits) return Problem{edits.problem()};
  (*edits)[model.file] =
      Merge(std::move((*edits)[model.file]), editor::ChangePort(document, element, to));
  return project_.Change("Rename port " + port + " of " + type + " to " + to.name, files_, *edits);
}

std::string TypeEditor::FreePortName(const std::string& type) const {
  const Model model = Find(type);
  std::string name = "port";
  for (int i = 2; model.element != kNoElement &&
                  FindPort(files_[model.file], model.element, name) != kNoElement;
       ++i) {
    name = "port_" + std::to_string(i);
  }
  return name;
}

}  // namespace coppice::editor
