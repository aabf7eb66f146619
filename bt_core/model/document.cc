#include "bt_core/model/document.h"

#include <tinyxml2.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

namespace coppice {
namespace {

// tinyxml2 keeps one copy of the text and hands out pointers into it, so the distance of two
// pointers is the distance of two bytes in the user's file. It only lacks the start, which the
// first node gives: it begins at the first '<'.
const char* StartOfBuffer(const tinyxml2::XMLDocument& xml, const std::string& text) {
  const tinyxml2::XMLNode* first = xml.FirstChild();
  std::size_t prefix = 1;  // <name
  if (first->ToDeclaration())
    prefix = 2;  // <?
  else if (first->ToComment())
    prefix = 4;  // <!--
  else if (first->ToUnknown())
    prefix = 2;  // <!
  return first->Value() - prefix - text.find('<');
}

const char* ErrorText(tinyxml2::XMLError error) {
  switch (error) {
    case tinyxml2::XML_ERROR_MISMATCHED_ELEMENT:
      return "this element is not closed by its own end tag";
    case tinyxml2::XML_ERROR_PARSING_ATTRIBUTE:
      return "malformed attribute; expected name=\"value\"";
    case tinyxml2::XML_ERROR_PARSING_ELEMENT:
      return "malformed element; expected <Name attribute=\"value\"/>";
    case tinyxml2::XML_ERROR_PARSING_COMMENT:
      return "comment without -->";
    case tinyxml2::XML_ERROR_PARSING_CDATA:
      return "CDATA without ]]>";
    case tinyxml2::XML_ERROR_PARSING_DECLARATION:
      return "malformed or misplaced <?xml ?> declaration";
    case tinyxml2::XML_ERROR_PARSING_TEXT:
      return "text outside of the root element";
    case tinyxml2::XML_ERROR_EMPTY_DOCUMENT:
      return "no element; expected <root BTCPP_format=\"4\">";
    case tinyxml2::XML_ELEMENT_DEPTH_EXCEEDED:
      return "elements are nested too deep";
    default:
      return "malformed XML";
  }
}

std::uint32_t StartOfLine(const std::string& text, int line) {
  std::size_t at = 0;
  for (int i = 1; i < line; ++i) {
    const std::size_t newline = text.find('\n', at);
    if (newline == std::string::npos) break;
    at = newline + 1;
  }
  return static_cast<std::uint32_t>(std::min(text.find_first_not_of(" \t", at), text.size()));
}

}  // namespace

Document::Document(Document&&) noexcept = default;
Document& Document::operator=(Document&&) noexcept = default;
Document::~Document() = default;

std::optional<Document> Document::FromText(std::string text, std::string file,
                                           Diagnostics& diagnostics) {
  Document document;
  document.file_ = std::move(file);
  document.text_ = std::make_unique<const std::string>(std::move(text));
  document.xml_ = std::make_unique<tinyxml2::XMLDocument>();
  const tinyxml2::XMLError error =
      document.xml_->Parse(document.text_->data(), document.text_->size());
  if (error != tinyxml2::XML_SUCCESS) {
    const int line = document.xml_->ErrorLineNum();
    diagnostics.Error(document.Location(StartOfLine(document.text(), line)), ErrorText(error));
    return std::nullopt;
  }
  if (!document.xml_->RootElement()) {
    diagnostics.Error(document.Location(0), ErrorText(tinyxml2::XML_ERROR_EMPTY_DOCUMENT));
    return std::nullopt;
  }
  document.BuildIndex();
  return document;
}

std::optional<Document> Document::FromFile(const std::string& path, Diagnostics& diagnostics) {
  std::ifstream stream(path, std::ios::binary);
  std::ostringstream text;
  if (stream) text << stream.rdbuf();
  if (!stream) {
    diagnostics.Error({path, 0, 0}, "cannot read this file");
    return std::nullopt;
  }
  return FromText(text.str(), path, diagnostics);
}

void Document::BuildIndex() {
  const char* const start = StartOfBuffer(*xml_, *text_);
  const auto offset_of = [start](const char* at) { return static_cast<std::uint32_t>(at - start); };

  const tinyxml2::XMLElement* at = xml_->RootElement();
  ElementIndex parent = kNoElement;
  ElementIndex previous = kNoElement;  // sibling before `at`
  while (at) {
    const auto index = static_cast<ElementIndex>(elements_.size());
    Element element{at->Name(),
                    offset_of(at->Name()) - 1,
                    static_cast<std::uint32_t>(attributes_.size()),
                    0,
                    parent,
                    kNoElement,
                    kNoElement,
                    0};
    for (const auto* a = at->FirstAttribute(); a; a = a->Next()) {
      attributes_.push_back({a->Name(), a->Value(), offset_of(a->Name()), offset_of(a->Value())});
      ++element.attribute_count;
    }
    if (parent != kNoElement) {
      ++elements_[parent].child_count;
      if (previous == kNoElement) elements_[parent].first_child = index;
    }
    if (previous != kNoElement) elements_[previous].next_sibling = index;
    elements_.push_back(element);

    // Next in document order: first child, else next sibling of the nearest ancestor that has one.
    if (const auto* child = at->FirstChildElement()) {
      at = child;
      parent = index;
      previous = kNoElement;
      continue;
    }
    previous = index;
    while (at && at != xml_->RootElement() && !at->NextSiblingElement()) {
      at = at->Parent()->ToElement();
      previous = parent;
      parent = elements_[previous].parent;
    }
    at = at && at != xml_->RootElement() ? at->NextSiblingElement() : nullptr;
  }
}

const Attribute* Document::FindAttribute(const Element& element, std::string_view name) const {
  const Attribute* end = attributes_end(element);
  const Attribute* found = std::find_if(attributes_begin(element), end,
                                        [name](const Attribute& a) { return a.name == name; });
  return found == end ? nullptr : found;
}

std::string_view Document::AttributeValue(const Element& element, std::string_view name) const {
  const Attribute* attribute = FindAttribute(element, name);
  return attribute ? attribute->value : std::string_view();
}

SourceLocation Document::Location(std::uint32_t offset) const {
  const std::string_view before = std::string_view(*text_).substr(0, offset);
  const std::size_t newline = before.rfind('\n');
  const std::size_t line_start = newline == std::string_view::npos ? 0 : newline + 1;
  return {file_, static_cast<std::uint32_t>(std::count(before.begin(), before.end(), '\n') + 1),
          static_cast<std::uint32_t>(before.size() - line_start + 1)};
}

}  // namespace coppice
