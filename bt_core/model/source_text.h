// The text of a file as a program keeps it: read only for messages and for those who watch, so it
// is small rather than quick.
//
//   const SourceText source(document);
//   source.StartTagAt(document.element(3).offset).Value("name")
//   source.Location(document.element(3).offset)          robot.xml:12:5
//
// Most of a file of trees is indentation: a line is kept as the number of its leading blanks and
// what follows them; a long line in parts that are kept in this way. One part in 32 has its place
// in an index; the others are counted from there. Immutable.
#ifndef COPPICE_BT_CORE_MODEL_SOURCE_TEXT_H_
#define COPPICE_BT_CORE_MODEL_SOURCE_TEXT_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "bt_core/base/diagnostic.h"
#include "bt_core/model/document.h"

namespace coppice {

/// The start tag of one element, without the document that it stands in.
struct StartTag {
  struct Attribute {
    std::string name;
    std::string value;  ///< with entities resolved
  };
  std::string name;
  std::vector<Attribute> attributes;  ///< as written

  /// The value of the attribute of that name, or null.
  const std::string* Find(std::string_view attribute) const;

  /// The same, or empty if there is no such attribute.
  std::string_view Value(std::string_view attribute) const;
};

bool operator==(const StartTag& a, const StartTag& b);

/// A text as lines; see above.
class PackedLines {
 public:
  PackedLines() = default;
  explicit PackedLines(std::string_view text);

  bool empty() const { return bytes_.empty(); }
  std::string text() const;

  /// From a byte of the text on at most so many, and no further than the end of its line, with its
  /// '\n', or of a part of a long line. Empty behind the last byte.
  std::string Piece(std::uint32_t offset, std::size_t most) const;

  /// Line and column of a byte of the text, both from 1.
  struct Position {
    std::uint32_t line;
    std::uint32_t column;
  };
  Position PositionOf(std::uint32_t offset) const;

 private:
  struct Place {
    std::uint32_t offset = 0;      // in the text
    std::uint32_t packed = 0;      // in bytes_
    std::uint32_t line = 0;        // from 0
    std::uint32_t line_begin = 0;  // in the text
  };
  // A line, or some of it.
  struct Part {
    Place begin;
    std::uint32_t blanks = 0;  // that it begins with
    std::string_view rest;     // in bytes_, with its '\n'
    Place end;
  };
  Part Read(Place place) const;
  Part PartAt(std::uint32_t offset) const;

  std::string bytes_;
  std::vector<Place> places_;  // of every 32nd part
};

class SourceText {
 public:
  explicit SourceText(const Document& document);

  const std::string& file() const { return file_; }
  std::string text() const { return lines_.text(); }

  /// Of an element of the document, by its offset.
  StartTag StartTagAt(std::uint32_t offset) const;

  /// As Document::Location.
  SourceLocation Location(std::uint32_t offset) const;

 private:
  std::string file_;
  PackedLines lines_;
  Edit to_file_;            // from the text to the user's file
  PackedLines file_lines_;  // of the user's file, if that is another text
};

}  // namespace coppice

#endif  // COPPICE_BT_CORE_MODEL_SOURCE_TEXT_H_
