#include "bt_core/model/upgrade_check.h"

#include <algorithm>
#include <optional>
#include <string>

#include "bt_core/model/attribute_edits.h"
#include "bt_core/model/element_edits.h"
#include "bt_core/model/xml_text.h"

namespace coppice {
namespace {

constexpr std::string_view kPrefix = "BlackboardCheck";

bool IsNumber(std::string_view text) {
  const std::string digits(text);
  std::size_t used = 0;
  try {
    (void)std::stod(digits, &used);
  } catch (const std::exception&) {
    return false;
  }
  return used == digits.size() && digits.find_first_of("xXnN") == std::string::npos;
}

// The value as an operand of a script, or nothing if it cannot be one.
std::optional<std::string> Operand(std::string_view value, std::string_view kind) {
  if (value.size() > 2 && value.front() == '{' && value.back() == '}') {
    const std::string_view key = value.substr(1, value.size() - 2);
    return IsKey(key) ? std::optional(std::string(key)) : std::nullopt;
  }
  if (kind == "String") {
    if (value.find('\'') != std::string_view::npos) return std::nullopt;
    return "'" + std::string(value) + "'";
  }
  if (kind == "Bool") {
    const bool is_true = value == "true" || value == "1";
    const bool is_false = value == "false" || value == "0";
    if (!is_true && !is_false) return std::nullopt;
    return is_true ? "true" : "false";
  }
  return IsNumber(value) ? std::optional(std::string(value)) : std::nullopt;
}

struct Shape {
  std::string_view parent;
  std::string_view comparison;
};

std::optional<Shape> ShapeFor(std::string_view result) {
  if (result.empty() || result == "FAILURE" || result == "failure") {
    return Shape{"ReactiveSequence", " == "};
  }
  if (result == "SUCCESS" || result == "success") return Shape{"ReactiveFallback", " != "};
  return std::nullopt;
}

}  // namespace

bool IsBlackboardCheck(std::string_view type) {
  if (type.substr(0, kPrefix.size()) != kPrefix) return false;
  const std::string_view kind = type.substr(kPrefix.size());
  return kind == "Int" || kind == "Double" || kind == "String" || kind == "Bool";
}

bool IsKey(std::string_view name) {
  const auto is_letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto is_word = [is_letter](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
  return !name.empty() && is_letter(name[0]) && std::all_of(name.begin(), name.end(), is_word) &&
         name != "true" && name != "false";
}

Edit UpgradeBlackboardCheck(const Document& document, ElementIndex index, std::string_view type,
                            Diagnostics& diagnostics) {
  const Element& element = document.element(index);
  const std::string_view kind = type.substr(kPrefix.size());
  const auto a = Operand(document.AttributeValue(element, "value_A"), kind);
  const auto b = Operand(document.AttributeValue(element, "value_B"), kind);
  const auto shape = ShapeFor(document.AttributeValue(element, "return_on_mismatch"));
  if (!a || !b || !shape || element.child_count != 1) {
    const std::string why =
        element.child_count != 1
            ? "it has " + std::to_string(element.child_count) + " children, not 1"
            : std::string(!shape ? "return_on_mismatch"
                          : a    ? "value_B"
                                 : "value_A") +
                  " is not what a script can hold";
    diagnostics.Warning(document.Location(element.offset),
                        std::string(type) + " cannot be upgraded by itself: " + why,
                        "format 4 has no such node; write a ScriptCondition");
    return {};
  }
  Edit edit = SetTag(document, index, shape->parent);
  const std::string_view ports[] = {"value_A", "value_B", "return_on_mismatch"};
  for (const std::string_view name : ports) {
    edit = Merge(std::move(edit), RemoveAttribute(document, index, name));
  }
  if (element.tag != type) edit = Merge(std::move(edit), RemoveAttribute(document, index, "ID"));
  const std::string code = *a + std::string(shape->comparison) + *b;
  return Merge(std::move(edit),
               InsertElement(document, index, 0,
                             "<ScriptCondition code=\"" + EscapeXmlValue(code, '"') + "\"/>"));
}

}  // namespace coppice
