#include "bt_core/engine/compile/shipped_models.h"

#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <utility>

#include "bt_core/engine/compile/compiler_children.h"
#include "bt_core/engine/compile/model_registry.h"
#include "bt_core/engine/compile/shipped_texts.h"
#include "bt_core/model/keys.h"

namespace coppice {
namespace {

constexpr std::size_t kEnoughTypes = 2;  // used as described, so that a set counts

std::string_view TypeOf(const Document& document, const Element& element) {
  const std::string_view id = document.AttributeValue(element, "ID");
  return CategoryFromTag(element.tag) && !id.empty() ? id : element.tag;
}

// How the node is used in another way than the model says.
std::optional<Diagnostic> Misfit(const Document& document, const Element& element,
                                 const NodeModel& model, const std::string& program) {
  const std::string wrong =
      WrongChildCount(model.id, element.child_count, ChildrenOf(model.category));
  if (!wrong.empty()) {
    return Diagnostic{Severity::kWarning, document.Location(element.offset),
                      wrong + " in " + program, ""};
  }
  for (const Attribute* a = document.attributes_begin(element);
       a != document.attributes_end(element); ++a) {
    const PortModel* const port = model.FindPort(a->name);
    const bool needs_key = port && port->direction != PortDirection::kInput;
    if (needs_key && KeyOf(a->value, a->name).empty()) {
      return Diagnostic{
          Severity::kWarning, document.Location(a->value_offset),
          "port \"" + port->name + "\" of " + program + "'s \"" + model.id + "\" needs a key",
          "write {key}"};
    }
    if (port || IsReservedAttribute(a->name)) continue;
    std::vector<std::string> names;
    for (const PortModel& one : model.ports) names.push_back(one.name);
    return Diagnostic{
        Severity::kWarning,
        document.Location(a->name_offset),
        "\"" + model.id + "\" of " + program + " has no port \"" + std::string(a->name) + "\"",
        DidYouMean(a->name, names),
        {ProblemKind::kUnknownPort, std::string(a->name)}};
  }
  return std::nullopt;
}

class Finder {
 public:
  Finder(const ShippedModels& set, const std::function<bool(std::string_view)>& is_known)
      : set_(set), is_known_(is_known) {}

  void See(const Document& document) {
    bool in_tree = false;
    std::uint32_t tree_end = 0;
    for (const Element& element : document.elements()) {
      if (element.offset >= tree_end) in_tree = false;
      if (element.tag == "BehaviorTree") {
        in_tree = true;
        tree_end = element.end;
      } else if (in_tree) {
        SeeNode(document, element);
      }
    }
  }

  ShippedTypes Result() && {
    ShippedTypes found;
    if (fitting_.size() < kEnoughTypes) return found;
    found.set = &set_;
    for (const auto& [id, model] : set_.models.models()) {
      if (!is_known_(id) && misfits_.count(id) == 0) found.types.push_back(&model);
    }
    for (auto& [id, misfit] : misfits_) found.misfits.push_back(std::move(misfit));
    return found;
  }

 private:
  void SeeNode(const Document& document, const Element& element) {
    const auto model = set_.models.models().find(TypeOf(document, element));
    if (model == set_.models.models().end() || is_known_(model->first)) return;
    if (misfits_.count(model->first) > 0) return;
    auto misfit = Misfit(document, element, model->second, set_.name);
    if (misfit) {
      fitting_.erase(model->first);
      misfits_.emplace(model->first, *std::move(misfit));
    } else {
      fitting_.insert(model->first);
    }
  }

  const ShippedModels& set_;
  const std::function<bool(std::string_view)>& is_known_;
  std::set<std::string> fitting_;  // types that are used as described
  std::map<std::string, Diagnostic> misfits_;
};

std::vector<ShippedModels> ReadShippedModels() {
  std::vector<ShippedModels> sets;
  for (const ShippedText& text : ShippedTexts()) {
    Diagnostics problems;
    auto models = Project::FromText(text.xml, text.program, problems);
    if (!models) throw std::logic_error(problems.ToString());
    sets.push_back({text.program, *std::move(models)});
  }
  return sets;
}

}  // namespace

const std::vector<ShippedModels>& AllShippedModels() {
  static const std::vector<ShippedModels> kSets = ReadShippedModels();
  return kSets;
}

std::vector<ShippedTypes> FindShippedTypes(const std::vector<const Document*>& documents,
                                           const std::function<bool(std::string_view)>& is_known) {
  std::vector<ShippedTypes> all;
  for (const ShippedModels& set : AllShippedModels()) {
    Finder finder(set, is_known);
    for (const Document* document : documents) finder.See(*document);
    ShippedTypes found = std::move(finder).Result();
    if (found.set) all.push_back(std::move(found));
  }
  return all;
}

void AddShippedModels(const Project& project, Registry& registry, Diagnostics& diagnostics) {
  std::vector<const Document*> documents;
  for (const Document& document : project.documents()) documents.push_back(&document);
  const auto is_known = [&](std::string_view id) {
    return registry.Find(id) || project.models().count(id) > 0;
  };
  for (const ShippedTypes& found : FindShippedTypes(documents, is_known)) {
    AddModels(found.types, registry);
    for (const Diagnostic& misfit : found.misfits) {
      diagnostics.Warning(misfit.where, misfit.message, misfit.hint, misfit.about);
    }
  }
}

}  // namespace coppice
