// tinyxml2 decides what is XML, because it does so on the robots whose files are read here; but it
// keeps no positions and resolves entities in place. So it only gives the structure: each of its
// pointers is turned into an offset of the user's text, and values, line numbers and the ends of
// elements are read from that text. Nothing of tinyxml2 outlives FromText.
#include "bt_core/model/document.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "bt_core/base/read_file.h"
#include "bt_core/model/markup.h"
#include "bt_core/model/strictness.h"
#include "bt_core/model/utf8.h"
#include "bt_core/model/xml_error.h"
#include "bt_core/model/xml_text.h"

namespace coppice {
namespace {

// An element for tinyxml2: </a/>. Neither a start tag nor an end tag; nobody can mean it.
bool IsMixedTag(const Element& element) { return element.tag.data()[-1] == '/'; }

// tinyxml2 parses a copy of the text and hands out pointers into it, so the distance of two
// pointers is the distance of two bytes in the user's file. It only lacks the start of its copy,
// which the first node gives: where it lies in the text is known.
const char* StartOfBuffer(const tinyxml2::XMLDocument& xml, const std::string& text) {
  const tinyxml2::XMLNode* first = xml.FirstChild();
  std::size_t at = text.find('<');
  if (const tinyxml2::XMLText* leading = first->ToText(); leading && !leading->CData()) {
    at = text.find_first_not_of(kXmlBlanks);
    if (text.compare(at, 3, "\xEF\xBB\xBF") == 0) at += 3;
  } else if (first->ToElement()) {
    at = text.find_first_not_of(" \t\n\v\f\r/", at + 1);  // "< name" is accepted
  } else if (first->ToText()) {
    at += std::string_view("<![CDATA[").size();
  } else if (first->ToComment()) {
    at += std::string_view("<!--").size();
  } else {
    at += std::string_view("<?").size();  // a declaration, or <! of a document type
  }
  return first->Value() - at;
}

std::vector<std::uint32_t> FindLines(const std::string& text) {
  std::vector<std::uint32_t> lines = {0};
  for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
    lines.push_back(static_cast<std::uint32_t>(at + 1));
  }
  lines.shrink_to_fit();
  return lines;
}

// tinyxml2 compares each attribute with all before it.
constexpr std::size_t kMaxAttributes = 1000;

// A larger text takes hundreds of megabytes as a tree, and is none that people write.
constexpr std::size_t kLongestText = std::size_t{32} << 20;  // bytes
constexpr std::ptrdiff_t kMostLines = 5'000'000;
constexpr std::ptrdiff_t kMostMarks = 500'000;  // elements, comments and attributes

bool IsTooLarge(std::string_view text) {
  const auto count = [text](char c) { return std::count(text.begin(), text.end(), c); };
  return text.size() > kLongestText || count('\n') > kMostLines ||
         count('<') + count('=') > kMostMarks;
}

std::size_t CountAttributes(std::string_view tag) {
  std::size_t count = 0;
  char quote = 0;
  for (const char c : tag) {
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '=') {
      ++count;
    }
  }
  return count;
}

// Where it begins.
std::optional<std::size_t> FindOvercrowdedTag(std::string_view text) {
  if (std::count(text.begin(), text.end(), '=') <= std::ptrdiff_t{kMaxAttributes}) return {};
  for (std::size_t at = 0; text.size() - at > kMaxAttributes;) {
    const Markup piece = ReadMarkup(text, at);
    at = piece.end;
    if (piece.kind != MarkupKind::kTag || piece.end - piece.begin < kMaxAttributes) continue;
    const std::string_view tag = text.substr(piece.begin, piece.end - piece.begin);
    if (CountAttributes(tag) > kMaxAttributes) return piece.begin;
  }
  return std::nullopt;
}

// Null if there is none. Elements are nested as deep as tinyxml2 allows, 98.
const tinyxml2::XMLText* FirstText(const tinyxml2::XMLElement& parent) {
  for (const auto* node = parent.FirstChild(); node; node = node->NextSibling()) {
    if (node->ToText() != nullptr) return node->ToText();
    if (const tinyxml2::XMLElement* const element = node->ToElement()) {
      if (const tinyxml2::XMLText* const text = FirstText(*element)) return text;
    }
  }
  return nullptr;
}

// Once in each tree, and beside the trees. What others keep below <root> is theirs.
void WarnOfText(const tinyxml2::XMLElement& root, const char* start, const Document& document,
                Diagnostics& diagnostics) {
  const auto warn = [&](const tinyxml2::XMLText* found, const std::string& where) {
    if (found == nullptr) return;
    const auto at = static_cast<std::size_t>(found->Value() - start);
    const std::string_view text = document.text();
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r\n", at), text.size());
    diagnostics.Warning(document.Location(static_cast<std::uint32_t>(begin)),
                        "text in " + where + " is ignored",
                        "a comment is written <!-- like this -->");
  };
  const tinyxml2::XMLText* beside = nullptr;
  for (const auto* node = root.FirstChild(); node; node = node->NextSibling()) {
    if (beside == nullptr) beside = node->ToText();
    const tinyxml2::XMLElement* const element = node->ToElement();
    if (element != nullptr && element->Name() == std::string_view("BehaviorTree")) {
      warn(FirstText(*element), "a tree");
    }
  }
  warn(beside, "<root>");
}

}  // namespace

std::optional<Document> Document::FromText(std::string text, std::string file,
                                           Diagnostics& diagnostics) {
  Document document;
  document.content_ = std::make_shared<Content>();
  document.content_->file = std::move(file);
  if (IsTooLarge(text)) {
    diagnostics.Error({document.content_->file},
                      "too large for a tree: expected at most 32 MiB, 5 million lines and "
                      "500000 elements and attributes");
    return std::nullopt;
  }
  document.content_->text = std::move(text);
  document.content_->lines = FindLines(document.text());
  if (LooksLikeUtf16(document.text())) {
    diagnostics.Error(document.Location(0), "this file is UTF-16", "save it as UTF-8");
    return std::nullopt;
  }
  if (const std::optional<std::size_t> tag = FindOvercrowdedTag(document.text())) {
    diagnostics.Error(
        document.Location(static_cast<std::uint32_t>(*tag)),
        "an element with more than " + std::to_string(kMaxAttributes) + " attributes");
    return std::nullopt;
  }
  tinyxml2::XMLDocument xml;
  const tinyxml2::XMLError error = xml.Parse(document.text().data(), document.text().size());
  if (error != tinyxml2::XML_SUCCESS || !xml.RootElement()) {
    document.ReportError(xml, diagnostics);
    return std::nullopt;
  }
  const char* const start = StartOfBuffer(xml, document.text());
  document.BuildIndex(xml, start);
  if (std::any_of(document.content_->elements.begin(), document.content_->elements.end(),
                  IsMixedTag)) {
    document.ReportError(xml, diagnostics);
    return std::nullopt;
  }
  document.WarnOutsideRoot(xml, start, diagnostics);
  if (xml.RootElement()->Name() == std::string_view("root")) {
    WarnOfText(*xml.RootElement(), start, document, diagnostics);
  }
  WarnOfLaxXml(document, diagnostics);
  return document;
}

void Document::ReportError(const tinyxml2::XMLDocument& xml, Diagnostics& diagnostics) const {
  if (const std::optional<XmlError> error = FindXmlError(text())) {
    diagnostics.Error(Location(static_cast<std::uint32_t>(error->offset)), error->message,
                      error->hint);
    return;
  }
  if (!xml.Error() || xml.ErrorID() == tinyxml2::XML_ERROR_EMPTY_DOCUMENT) {
    diagnostics.Error(Location(0), "no element", "expected <root BTCPP_format=\"4\">");
    return;
  }
  const auto line = static_cast<std::size_t>(std::max(xml.ErrorLineNum(), 1));
  diagnostics.Error(Location(content_->lines.at(line - 1)), "malformed XML", xml.ErrorName());
}

std::optional<Document> Document::FromFile(const std::string& path, Diagnostics& diagnostics) {
  std::optional<std::string> text = ReadFile(path, diagnostics);
  if (!text) return std::nullopt;
  return FromText(*std::move(text), path, diagnostics);
}

std::optional<Document> Document::Edited(const Edit& edit, Diagnostics& diagnostics) const {
  return FromText(Apply(edit, text()), content_->file, diagnostics);
}

std::optional<Document> Document::Rewritten(const Edit& edit, Diagnostics& diagnostics) const {
  std::optional<Document> document = Edited(edit, diagnostics);
  if (!document) return document;
  document->content_->lines = content_->lines;
  document->content_->back = Inverse(edit, text());
  return document;
}

std::uint32_t Document::FindTag(const char* name, const char* start) const {
  return static_cast<std::uint32_t>(text().rfind('<', static_cast<std::size_t>(name - start)));
}

void Document::WarnOutsideRoot(const tinyxml2::XMLDocument& xml, const char* start,
                               Diagnostics& diagnostics) const {
  bool is_behind = false;
  for (const auto* node = xml.FirstChild(); node; node = node->NextSibling()) {
    is_behind = is_behind || node == xml.RootElement();
    if (node->ToText()) {
      diagnostics.Warning(Location(static_cast<std::uint32_t>(node->Value() - start)),
                          std::string("text ") + (is_behind ? "behind" : "before") +
                              " the root element is ignored");
    } else if (node->ToElement() && node != xml.RootElement()) {
      diagnostics.Warning(Location(FindTag(node->Value(), start)),
                          std::string("second root element <") + node->Value() + "> is ignored");
    }
  }
}

Attribute Document::MakeAttribute(std::uint32_t name, std::size_t name_length) {
  const std::string_view text = content_->text;
  std::uint32_t value = name + static_cast<std::uint32_t>(name_length);
  while (text[value] != '"' && text[value] != '\'') ++value;
  ++value;
  const auto end = static_cast<std::uint32_t>(text.find(text[value - 1], value));
  std::string_view decoded = text.substr(value, end - value);
  if (NeedsDecoding(decoded)) decoded = content_->resolved.emplace_front(DecodeXml(decoded));
  return {text.substr(name, name_length), decoded, name, value, end};
}

void Document::BuildIndex(const tinyxml2::XMLDocument& xml, const char* start) {
  const auto offset_of = [start](const char* at) { return static_cast<std::uint32_t>(at - start); };

  const auto count = [this](char c) {
    return static_cast<std::size_t>(std::count(text().begin(), text().end(), c));
  };
  content_->elements.reserve(count('<'));
  content_->attributes.reserve(count('='));
  const tinyxml2::XMLElement* at = xml.RootElement();
  ElementIndex parent = kNoElement;
  ElementIndex previous = kNoElement;  // sibling before `at`
  while (at) {
    const auto index = static_cast<ElementIndex>(content_->elements.size());
    const std::uint32_t name = offset_of(at->Name());
    Element element{std::string_view(text()).substr(name, std::strlen(at->Name())),
                    FindTag(at->Name(), start),
                    0,
                    0,
                    static_cast<std::uint32_t>(content_->attributes.size()),
                    0,
                    parent,
                    kNoElement,
                    kNoElement,
                    0};
    for (const auto* a = at->FirstAttribute(); a; a = a->Next()) {
      content_->attributes.push_back(MakeAttribute(offset_of(a->Name()), std::strlen(a->Name())));
      ++element.attribute_count;
    }
    if (parent != kNoElement) {
      ++content_->elements[parent].child_count;
      if (previous == kNoElement) content_->elements[parent].first_child = index;
    }
    if (previous != kNoElement) content_->elements[previous].next_sibling = index;
    content_->elements.push_back(element);

    // Next in document order: first child, else next sibling of the nearest ancestor that has one.
    if (const auto* child = at->FirstChildElement()) {
      at = child;
      parent = index;
      previous = kNoElement;
      continue;
    }
    previous = index;
    while (at && at != xml.RootElement() && !at->NextSiblingElement()) {
      at = at->Parent()->ToElement();
      previous = parent;
      parent = content_->elements[previous].parent;
    }
    at = at && at != xml.RootElement() ? at->NextSiblingElement() : nullptr;
  }
  content_->elements.shrink_to_fit();
  content_->attributes.shrink_to_fit();
  FindEnds();
}

std::uint32_t Document::FindStartTagEnd(const Element& element) const {
  const std::size_t behind_name = element.tag.data() + element.tag.size() - text().data();
  const std::size_t from = element.attribute_count == 0
                               ? behind_name
                               : (attributes_end(element) - 1)->value_end + std::size_t{1};
  return static_cast<std::uint32_t>(text().find('>', from) + 1);
}

// tinyxml2 does not tell where elements end. It has accepted the text, so every tag that is not the
// start of the next element is the end tag of the innermost open one.
void Document::FindEnds() {
  std::vector<ElementIndex> open;
  ElementIndex next{0};
  std::size_t at = content_->elements[0].offset;
  do {
    if (next < content_->elements.size() && at == content_->elements[next].offset) {
      Element& element = content_->elements[next];
      at = element.start_tag_end = element.end = FindStartTagEnd(element);
      if (text()[at - 2] != '/') open.push_back(next);
      ++next;
    } else {
      const Markup piece = ReadMarkup(text(), at);
      at = piece.end;
      if (piece.kind != MarkupKind::kTag) continue;
      content_->elements[open.back()].end = static_cast<std::uint32_t>(at);
      open.pop_back();
    }
  } while (!open.empty());
}

ElementIndex Document::ElementAt(std::uint32_t offset) const {
  const auto behind =
      std::upper_bound(content_->elements.begin(), content_->elements.end(), offset,
                       [](std::uint32_t at, const Element& e) { return at < e.offset; });
  if (behind == content_->elements.begin()) return kNoElement;
  auto index = static_cast<ElementIndex>(behind - content_->elements.begin() - 1);
  while (index != kNoElement && content_->elements[index].end <= offset)
    index = content_->elements[index].parent;
  return index;
}

std::string Document::TextOf(const Element& element) const {
  std::string result;
  int depth = 0;  // of the children that are open
  for (std::size_t at = element.start_tag_end; at < element.end;) {
    const Markup piece = ReadMarkup(text(), at);
    const std::string_view content = std::string_view(text()).substr(at, piece.end - at);
    if (piece.kind == MarkupKind::kText && depth == 0) {
      result += DecodeXml(content);
    } else if (piece.kind == MarkupKind::kCharacterData && depth == 0) {
      constexpr std::size_t kOpen = std::string_view("<![CDATA[").size();
      constexpr std::size_t kClose = std::string_view("]]>").size();
      result += content.substr(kOpen, content.size() - kOpen - kClose);
    } else if (piece.kind == MarkupKind::kTag && content[content.size() - 2] != '/') {
      depth += content[1] == '/' ? -1 : 1;
    }
    at = piece.end;
  }
  const std::size_t first = result.find_first_not_of(kXmlBlanks);
  return first == std::string::npos
             ? std::string()
             : result.substr(first, result.find_last_not_of(kXmlBlanks) - first + 1);
}

std::uint32_t Document::OffsetInValue(const Attribute& attribute,
                                      std::size_t decoded_offset) const {
  return attribute.value_offset +
         static_cast<std::uint32_t>(RawOffset(RawValue(attribute), decoded_offset));
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
  offset = MapOffset(content_->back, offset);
  const auto next = std::upper_bound(content_->lines.begin(), content_->lines.end(), offset);
  return {content_->file, static_cast<std::uint32_t>(next - content_->lines.begin()),
          offset - *(next - 1) + 1};
}

}  // namespace coppice
