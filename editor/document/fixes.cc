#include "editor/document/fixes.h"

#include <algorithm>
#include <cctype>
#include <cstring>
#include <optional>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/xml_text.h"

namespace coppice::editor {
namespace {

const Attribute* AttributeAt(const Document& document, const Element& element,
                             std::uint32_t offset) {
  const Attribute* end = document.attributes_end(element);
  const Attribute* at = std::find_if(document.attributes_begin(element), end, [&](const auto& a) {
    return offset >= a.name_offset && offset <= a.value_end;
  });
  return at == end ? nullptr : at;
}

// The name, number or operator that begins there.
std::string_view WordAt(std::string_view text) {
  const auto is_of_name = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.';
  };
  const auto is_of_operator = [](char c) { return std::strchr("=:!+-*/|^", c) != nullptr; };
  if (text.empty()) return text;
  const auto end = is_of_name(text[0]) ? std::find_if_not(text.begin(), text.end(), is_of_name)
                                       : std::find_if_not(text.begin(), text.end(), is_of_operator);
  return text.substr(0, static_cast<std::size_t>(end - text.begin()));
}

// In a script one word is wrong, not all of it.
std::optional<Fix> RenameInScript(const Document& document, std::uint32_t offset,
                                  const std::string& right) {
  const std::string_view wrong = WordAt(std::string_view(document.text()).substr(offset));
  if (wrong.empty()) return std::nullopt;
  return Fix{std::string(wrong) + " -> " + right,
             {{offset, static_cast<std::uint32_t>(wrong.size()), right}},
             "",
             ""};
}

// The wrong name is where the message points to: a tag, the name or the value of an attribute.
std::optional<Fix> Rename(const Document& document, ElementIndex index, std::uint32_t offset,
                          const std::string& right) {
  const Element& element = document.element(index);
  const Attribute* attribute = AttributeAt(document, element, offset);
  if (!attribute) {
    const Attribute* id = document.FindAttribute(element, "ID");
    const std::string wrong(id ? id->value : element.tag);
    if (!id && !IsXmlName(right)) return std::nullopt;
    return Fix{wrong + " -> " + right,
               id ? SetAttribute(document, index, "ID", right) : SetTag(document, index, right), "",
               ""};
  }
  if (offset >= attribute->value_offset) {
    return Fix{std::string(attribute->value) + " -> " + right,
               SetAttribute(document, index, attribute->name, right), "", ""};
  }
  if (!IsXmlName(right) || document.FindAttribute(element, right)) return std::nullopt;
  return Fix{std::string(attribute->name) + " -> " + right,
             RenameAttribute(document, index, attribute->name, right), "", ""};
}

}  // namespace

std::uint32_t OffsetOf(const Document& document, const SourceLocation& where) {
  const std::string& text = document.text();
  std::size_t at = 0;
  for (std::uint32_t line = 1; line < where.line; ++line) {
    at = text.find('\n', at);
    if (at == std::string::npos) return static_cast<std::uint32_t>(text.size());
    ++at;
  }
  const std::size_t column = where.column == 0 ? 0 : where.column - 1;
  return static_cast<std::uint32_t>(std::min(at + column, text.size()));
}

std::vector<Fix> FixesFor(const Document& document, const Diagnostic& problem) {
  std::vector<Fix> fixes;
  if (problem.where.file != document.file() || problem.where.line == 0) return fixes;
  const std::uint32_t offset = OffsetOf(document, problem.where);
  const ElementIndex element = document.ElementAt(offset);
  if (element == kNoElement) return fixes;
  if (const std::string right = NameMeant(problem.hint); !right.empty()) {
    auto fix = problem.about.kind == ProblemKind::kInScript
                   ? RenameInScript(document, offset, right)
                   : Rename(document, element, offset, right);
    if (fix && !fix->edit.empty()) fixes.push_back(*std::move(fix));
  }
  const std::string& name = problem.about.name;
  switch (problem.about.kind) {
    case ProblemKind::kMissingPort:
      if (!IsXmlName(name)) break;
      fixes.push_back({"add " + name, SetAttribute(document, element, name, ""), name, ""});
      break;
    case ProblemKind::kUnknownPort: {
      Edit edit = RemoveAttribute(document, element, name);
      if (!edit.empty()) fixes.push_back({"remove " + name, std::move(edit), "", ""});
      break;
    }
    case ProblemKind::kNoModel:
      fixes.push_back({"load models", {}, "", "file.models"});
      if (!name.empty()) fixes.push_back({"define it", {}, "", "type.define"});
      break;
    case ProblemKind::kOldFormat:
      fixes.push_back({"make it format 4", {}, "", "", true});
      break;
    case ProblemKind::kInScript:
    case ProblemKind::kEmptyTree:
    case ProblemKind::kCannotWrite:
    case ProblemKind::kOther:
      break;
  }
  return fixes;
}

}  // namespace coppice::editor
