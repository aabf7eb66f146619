#include "editor/document/suggested_model.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <map>
#include <string>

#include "bt_core/model/keys.h"
#include "bt_core/nodes/guards.h"

namespace coppice::editor {
namespace {

// "Is" and a capital: not "Issue".
bool BeginsWithWord(std::string_view text, std::string_view word) {
  return text.size() > word.size() && text.substr(0, word.size()) == word &&
         std::isupper(static_cast<unsigned char>(text[word.size()])) != 0;
}

bool IsNumber(const std::string& text, bool whole) {
  char* end = nullptr;
  whole ? static_cast<void>(std::strtol(text.c_str(), &end, 10))
        : static_cast<void>(std::strtod(text.c_str(), &end));
  return !text.empty() && *end == '\0';
}

template <class Fits>
bool All(const std::vector<std::string>& values, Fits fits) {
  return std::all_of(values.begin(), values.end(), fits);
}

std::string TypeOfAll(const std::vector<std::string>& values) {
  if (values.empty()) return {};
  if (All(values, [](const auto& text) { return text == "true" || text == "false"; }))
    return "bool";
  if (All(values, [](const auto& text) { return IsNumber(text, true); })) return "int";
  if (All(values, [](const auto& text) { return IsNumber(text, false); })) return "double";
  return "string";
}

class Suggester {
 public:
  explicit Suggester(std::string_view type) {
    model_.id = type;
    if (BeginsWithWord(type, "Is") || BeginsWithWord(type, "Has")) {
      model_.category = NodeCategory::kCondition;
    }
  }

  void See(const Document& document, ElementIndex index) {
    const Element& element = document.element(index);
    const auto kind = CategoryFromTag(element.tag);
    most_children_ = std::max(most_children_, element.child_count);
    if (kind) model_.category = *kind;
    said_ = said_ || kind;
    for (const Attribute* a = document.attributes_begin(element);
         a != document.attributes_end(element); ++a) {
      if (!IsReservedAttribute(a->name) && !IsGuardAttribute(a->name)) AddPort(*a);
    }
  }

  NodeModel Result() && {
    if (!said_ && most_children_ > 0) {
      model_.category = most_children_ > 1 ? NodeCategory::kControl : NodeCategory::kDecorator;
    }
    for (PortModel& port : model_.ports) port.type = TypeOfAll(literals_[port.name]);
    return std::move(model_);
  }

 private:
  void AddPort(const Attribute& attribute) {
    if (!model_.FindPort(attribute.name)) {
      model_.ports.push_back({std::string(attribute.name), PortDirection::kInput, "", "", {}});
    }
    const bool is_literal = KeyOf(attribute.value, attribute.name).empty();
    if (is_literal && !attribute.value.empty()) {
      literals_[std::string(attribute.name)].emplace_back(attribute.value);
    }
  }

  NodeModel model_;
  std::map<std::string, std::vector<std::string>> literals_;  // by port
  std::uint32_t most_children_ = 0;
  bool said_ = false;  // by a tag
};

}  // namespace

NodeModel SuggestModel(const ProjectFiles& files, std::string_view type) {
  Suggester suggester(type);
  for (const Document& document : files) {
    for (ElementIndex i{0}; i < document.elements().size(); ++i) {
      if (IsNode(document, i) && TypeOf(document, i) == type) suggester.See(document, i);
    }
  }
  return std::move(suggester).Result();
}

}  // namespace coppice::editor
