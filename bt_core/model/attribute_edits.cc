#include "bt_core/model/attribute_edits.h"

#include <string>

#include "bt_core/model/layout.h"
#include "bt_core/model/xml_text.h"

namespace coppice {
namespace {

// Where the blanks before an attribute begin.
std::size_t BlanksBefore(const std::string& text, std::size_t offset) {
  return text.find_last_not_of(kXmlBlanks, offset - 1) + 1;
}

// Scripts of several lines keep their lines if the old value had such.
std::string EscapeLike(std::string_view old_raw, std::string_view value, char quote,
                       std::string_view line_end) {
  std::string escaped = EscapeXmlValue(value, quote);
  if (old_raw.find('\n') == std::string_view::npos) return escaped;
  constexpr std::string_view kLineFeed = "&#10;";
  for (std::size_t at = escaped.find(kLineFeed); at != std::string::npos;
       at = escaped.find(kLineFeed, at + line_end.size())) {
    escaped.replace(at, kLineFeed.size(), line_end);
  }
  return escaped;
}

}  // namespace

Edit SetAttribute(const Document& document, ElementIndex index, std::string_view name,
                  std::string_view value) {
  const Element& element = document.element(index);
  const std::string& text = document.text();
  if (const Attribute* old = document.FindAttribute(element, name)) {
    if (old->value == value) return {};
    return {Replacement(old->value_offset, old->value_end,
                        EscapeLike(document.RawValue(*old), value, text[old->value_end],
                                   LineEndAt(text, old->value_offset)))};
  }
  char quote = '"';
  std::size_t at = element.tag.data() - text.data() + element.tag.size();
  std::string blanks = " ";
  if (element.attribute_count > 0) {
    const Attribute& last = *(document.attributes_end(element) - 1);
    quote = text[last.value_end];
    at = last.value_end + std::size_t{1};
    if (IndentationAt(text, last.name_offset)) {
      const std::size_t begin = BlanksBefore(text, last.name_offset);
      blanks = text.substr(begin, last.name_offset - begin);
    }
  }
  return {Replacement(
      at, at, blanks + std::string(name) + "=" + quote + EscapeXmlValue(value, quote) + quote)};
}

Edit RemoveAttribute(const Document& document, ElementIndex index, std::string_view name) {
  const Attribute* attribute = document.FindAttribute(document.element(index), name);
  if (!attribute) return {};
  const std::string& text = document.text();
  const std::size_t end = attribute->value_end + std::size_t{1};
  // Attributes that touch each other keep the blank that parts them from the tag.
  const bool next_touches = NameLength(std::string_view(text).substr(end)) > 0;
  return {Replacement(
      next_touches ? attribute->name_offset : BlanksBefore(text, attribute->name_offset), end, "")};
}

Edit RenameAttribute(const Document& document, ElementIndex index, std::string_view name,
                     std::string_view new_name) {
  const Attribute* attribute = document.FindAttribute(document.element(index), name);
  if (!attribute || name == new_name) return {};
  const std::size_t begin = attribute->name_offset;
  return {Replacement(begin, begin + name.size(), std::string(new_name))};
}

}  // namespace coppice
