#include "editor/document/fixes.h"

#include <algorithm>
#include <optional>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/xml_text.h"
#include "editor/document/shown_problems.h"

namespace coppice::editor {
namespace {

// What stands in quotes behind `before`.
std::optional<std::string> Quoted(std::string_view text, std::string_view before) {
  const std::size_t at = text.find(before);
  if (at == std::string_view::npos) return std::nullopt;
  const std::size_t begin = at + before.size();
  const std::size_t end = text.find('"', begin);
  if (end == std::string_view::npos) return std::nullopt;
  return std::string(text.substr(begin, end - begin));
}

const Attribute* AttributeAt(const Document& document, const Element& element,
                             std::uint32_t offset) {
  const Attribute* end = document.attributes_end(element);
  const Attribute* at = std::find_if(document.attributes_begin(element), end, [&](const auto& a) {
    return offset >= a.name_offset && offset <= a.value_end;
  });
  return at == end ? nullptr : at;
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
  if (const auto right = Quoted(problem.hint, "did you mean \"")) {
    auto fix = Rename(document, element, offset, *right);
    if (fix && !fix->edit.empty()) fixes.push_back(*std::move(fix));
  }
  if (const auto port = Quoted(problem.message, " needs its port \"")) {
    if (IsXmlName(*port)) {
      fixes.push_back({"add " + *port, SetAttribute(document, element, *port, ""), *port, ""});
    }
  }
  if (const auto port = Quoted(problem.message, " has no port \"")) {
    Edit edit = RemoveAttribute(document, element, *port);
    if (!edit.empty()) fixes.push_back({"remove " + *port, std::move(edit), "", ""});
  }
  if (IsAboutModels(problem)) {
    fixes.push_back({"load models", {}, "", "file.models"});
    if (problem.message.substr(0, 5) == "type ")
      fixes.push_back({"define it", {}, "", "type.define"});
  }
  return fixes;
}

}  // namespace coppice::editor
