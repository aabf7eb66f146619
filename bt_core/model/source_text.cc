#include "bt_core/model/source_text.h"

#include <algorithm>

#include "bt_core/model/markup.h"
#include "bt_core/model/xml_text.h"

namespace coppice {
namespace {

constexpr std::uint32_t kLinesPerPlace = 32;
constexpr unsigned char kMostInByte = 255;  // a number of blanks that goes on in the next byte

// Of the line that begins there, with its '\n'.
std::size_t EndOfLine(std::string_view text, std::size_t begin) {
  const std::size_t end = text.find('\n', begin);
  return end == std::string_view::npos ? text.size() : end + 1;
}

// Of a tag, from its '<' on, that a Document has accepted.
StartTag ReadStartTag(std::string_view text) {
  StartTag tag;
  std::size_t at = text.find_first_not_of(kXmlBlanks, 1);  // "< name" is accepted
  std::size_t length = NameLength(text.substr(at));
  tag.name = text.substr(at, length);
  for (;;) {
    at = text.find_first_not_of(kXmlBlanks, at + length);
    length = NameLength(text.substr(at));
    if (length == 0) return tag;
    const std::string_view name = text.substr(at, length);
    const std::size_t value = text.find_first_of("\"'", at + length) + 1;
    const std::size_t end = text.find(text[value - 1], value);
    tag.attributes.push_back({std::string(name), DecodeXml(text.substr(value, end - value))});
    at = end;
    length = 1;  // of the quote
  }
}

}  // namespace

const std::string* StartTag::Find(std::string_view attribute) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [attribute](const Attribute& a) { return a.name == attribute; });
  return found == attributes.end() ? nullptr : &found->value;
}

std::string_view StartTag::Value(std::string_view attribute) const {
  const std::string* value = Find(attribute);
  return value ? std::string_view(*value) : std::string_view();
}

bool operator==(const StartTag& a, const StartTag& b) {
  const auto same = [](const StartTag::Attribute& x, const StartTag::Attribute& y) {
    return x.name == y.name && x.value == y.value;
  };
  return a.name == b.name && std::equal(a.attributes.begin(), a.attributes.end(),
                                        b.attributes.begin(), b.attributes.end(), same);
}

PackedLines::PackedLines(std::string_view text) {
  std::size_t lines = 0;
  for (std::size_t at = 0; at < text.size(); ++lines) {
    if (lines % kLinesPerPlace == 0) {
      places_.push_back(
          {static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(bytes_.size())});
    }
    const std::size_t end = EndOfLine(text, at);
    const std::size_t rest = std::min(end, text.find_first_not_of(' ', at));
    std::size_t blanks = rest - at;
    for (; blanks >= kMostInByte; blanks -= kMostInByte) bytes_ += static_cast<char>(kMostInByte);
    bytes_ += static_cast<char>(blanks);
    bytes_.append(text, rest, end - rest);
    at = end;
  }
  bytes_.shrink_to_fit();
  places_.shrink_to_fit();
}

PackedLines::Line PackedLines::Read(Place place, std::uint32_t number) const {
  Line line{number, place, 0, {}, {}};
  std::size_t at = place.packed;
  unsigned char byte = kMostInByte;
  while (byte == kMostInByte) line.blanks += byte = static_cast<unsigned char>(bytes_[at++]);
  line.rest = std::string_view(bytes_).substr(at, EndOfLine(bytes_, at) - at);
  line.end = {place.offset + line.blanks + static_cast<std::uint32_t>(line.rest.size()),
              static_cast<std::uint32_t>(at + line.rest.size())};
  return line;
}

PackedLines::Line PackedLines::LineAt(std::uint32_t offset) const {
  const auto behind =
      std::upper_bound(places_.begin(), places_.end(), offset,
                       [](std::uint32_t at, const Place& place) { return at < place.offset; });
  const auto place = behind - 1;
  Line line = Read(*place, static_cast<std::uint32_t>(place - places_.begin()) * kLinesPerPlace);
  while (line.end.offset <= offset && line.end.packed < bytes_.size()) {
    line = Read(line.end, line.number + 1);
  }
  return line;
}

std::string PackedLines::text() const {
  std::string text;
  for (Line line; line.end.packed < bytes_.size();
       text.append(line.blanks, ' ').append(line.rest)) {
    line = Read(line.end, 0);
  }
  return text;
}

std::string PackedLines::Piece(std::uint32_t offset, std::size_t most) const {
  const Line line = LineAt(offset);
  const std::size_t column = offset - line.begin.offset;
  const std::size_t passed = std::min<std::size_t>(line.blanks, column);
  const std::size_t blanks = std::min(most, line.blanks - passed);
  const std::size_t from = std::min(line.rest.size(), column - passed);
  return std::string(blanks, ' ').append(line.rest.substr(from, most - blanks));
}

PackedLines::Position PackedLines::PositionOf(std::uint32_t offset) const {
  const Line line = LineAt(offset);
  return {line.number + 1, offset - line.begin.offset + 1};
}

SourceText::SourceText(const Document& document)
    : file_(document.file()), lines_(document.text()), to_file_(document.edit_to_file()) {
  if (!to_file_.empty()) file_lines_ = PackedLines(Apply(to_file_, document.text()));
}

StartTag SourceText::StartTagAt(std::uint32_t offset) const {
  std::string tag;  // of a line that may be a million tags long
  do {
    const std::size_t more = std::max<std::size_t>(256, tag.size());
    tag += lines_.Piece(offset + static_cast<std::uint32_t>(tag.size()), more);
  } while (!ReadMarkup(tag, 0).is_closed);
  return ReadStartTag(tag);
}

SourceLocation SourceText::Location(std::uint32_t offset) const {
  const PackedLines& lines = file_lines_.empty() ? lines_ : file_lines_;
  const auto [line, column] = lines.PositionOf(MapOffset(to_file_, offset));
  return {file_, line, column};
}

}  // namespace coppice
