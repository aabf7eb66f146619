// A behaviour-tree XML file as a value: the user's exact text and, beside it, a flat index of its
// elements.
//
// tinyxml2 does the parsing; the index adds what it does not keep, the byte position of every name
// and value, so that every message can name file:line:column of the user's own text. What tinyxml2
// accepts is accepted, also where it is laxer than the XML standard (strictness.h says where, and
// warns). A Document is immutable. Copies share what they are made of, so a copy costs nothing, and
// views live as long as one of them does.
#ifndef COPPICE_BT_CORE_MODEL_DOCUMENT_H_
#define COPPICE_BT_CORE_MODEL_DOCUMENT_H_

#include <cstdint>
#include <forward_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/base/strong_index.h"
#include "bt_core/model/edit.h"

namespace tinyxml2 {
class XMLDocument;
}

namespace coppice {

using ElementIndex = StrongIndex<struct ElementTag>;
inline constexpr ElementIndex kRootElement{0};
inline constexpr ElementIndex kNoElement{UINT32_MAX};

struct Attribute {
  std::string_view name;
  std::string_view value;      ///< with entities resolved
  std::uint32_t name_offset;   ///< in bytes from the start of the text
  std::uint32_t value_offset;  ///< of the first byte after the quote
  std::uint32_t value_end;     ///< of the closing quote, which is the same character
};

/// One element. Elements lie in document order; the first is the root.
struct Element {
  std::string_view tag;
  std::uint32_t offset;         ///< of the '<'
  std::uint32_t start_tag_end;  ///< after the '>' of the start tag
  std::uint32_t end;            ///< after the '>' of the end tag; start_tag_end if self-closing
  std::uint32_t first_attribute;
  std::uint32_t attribute_count;
  ElementIndex parent;
  ElementIndex first_child;   ///< kNoElement if none
  ElementIndex next_sibling;  ///< kNoElement if last
  std::uint32_t child_count;

  bool is_self_closing() const { return start_tag_end == end; }
};

class Document {
 public:
  /// Parses a text; `file` is used in messages only. Nothing is returned if the XML is malformed or
  /// UTF-16, and the reason is added to `diagnostics`; text and elements outside of the root
  /// element are ignored with a warning.
  static std::optional<Document> FromText(std::string text, std::string file,
                                          Diagnostics& diagnostics);

  /// Reads and parses a file.
  static std::optional<Document> FromFile(const std::string& path, Diagnostics& diagnostics);

  /// The document after an edit, under the same file name. Nothing if the result is malformed,
  /// which can only be if the edit put malformed text in.
  std::optional<Document> Edited(const Edit& edit, Diagnostics& diagnostics) const;

  /// The same, but Location() goes on speaking of the text before the edit: for a rewriting that
  /// the user does not see, such as that of format 3.
  std::optional<Document> Rewritten(const Edit& edit, Diagnostics& diagnostics) const;

  const std::string& text() const { return content_->text; }
  const std::string& file() const { return content_->file; }

  const std::vector<Element>& elements() const { return content_->elements; }
  const Element& element(ElementIndex index) const { return content_->elements[index]; }

  /// Attributes of an element: a contiguous range of attributes().
  const Attribute* attributes_begin(const Element& element) const {
    return content_->attributes.data() + element.first_attribute;
  }
  const Attribute* attributes_end(const Element& element) const {
    return attributes_begin(element) + element.attribute_count;
  }

  /// The attribute of that name, or null.
  const Attribute* FindAttribute(const Element& element, std::string_view name) const;

  /// Its value, or empty if there is no such attribute.
  std::string_view AttributeValue(const Element& element, std::string_view name) const;

  /// The innermost element that covers this byte of the text, or kNoElement.
  ElementIndex ElementAt(std::uint32_t offset) const;

  /// The text directly inside of an element, decoded, CDATA included, without blanks at both ends;
  /// not that of its children.
  std::string TextOf(const Element& element) const;

  /// The attribute's value as it stands in the text, references unresolved.
  std::string_view RawValue(const Attribute& attribute) const {
    return std::string_view(content_->text)
        .substr(attribute.value_offset, attribute.value_end - attribute.value_offset);
  }

  /// The byte offset in the text of position `decoded_offset` of an attribute's value; for a
  /// message about a part of a value, such as a script.
  std::uint32_t OffsetInValue(const Attribute& attribute, std::size_t decoded_offset) const;

  /// Turns the text into the user's file. Empty if it is the user's file: all but after Rewritten.
  const Edit& edit_to_file() const { return content_->back; }

  /// Line and column of a byte offset, in the user's file. Binary search.
  SourceLocation Location(std::uint32_t offset) const;

 private:
  Document() = default;
  // `start` is where tinyxml2's copy of the text begins.
  void BuildIndex(const tinyxml2::XMLDocument& xml, const char* start);
  void ReportError(const tinyxml2::XMLDocument& xml, Diagnostics& diagnostics) const;
  void WarnOutsideRoot(const tinyxml2::XMLDocument& xml, const char* start,
                       Diagnostics& diagnostics) const;
  std::uint32_t FindTag(const char* name, const char* start) const;
  void FindEnds();
  std::uint32_t FindStartTagEnd(const Element& element) const;
  Attribute MakeAttribute(std::uint32_t name, std::size_t name_length);

  struct Content {
    std::string file;
    std::string text;
    std::vector<std::uint32_t> lines;         // offset of the start of each line of the user's file
    Edit back;                                // from the text to the user's file
    std::forward_list<std::string> resolved;  // values with references or line ends replaced
    std::vector<Element> elements;
    std::vector<Attribute> attributes;
  };
  std::shared_ptr<Content> content_;  // changes only while it is made
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_DOCUMENT_H_
