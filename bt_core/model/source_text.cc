#include "bt_core/model/source_text.h"

#include <algorithm>

#include "bt_core/model/markup.h"
#include "bt_core/model/xml_text.h"

namespace coppice {
namespace {

constexpr std::size_t kPartsPerPlace = 32;
constexpr std::size_t kLongestRest = 256;   // of a part: its bytes behind the blanks
constexpr unsigned char kMostInByte = 255;  // a number of blanks that goes on in the next byte

// Of the part whose blanks end there, with its '\n'.
std::string_view RestAt(std::string_view text, std::size_t begin) {
  const std::string_view longest = text.substr(begin, kLongestRest);
  return longest.substr(0, std::min(longest.find('\n'), longest.size() - 1) + 1);
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
  Place place;
  for (std::size_t parts = 0; place.offset < text.size(); ++parts) {
    if (parts % kPartsPerPlace == 0) places_.push_back(place);
    const std::size_t begin = std::min(text.size(), text.find_first_not_of(' ', place.offset));
    std::size_t blanks = begin - place.offset;
    for (; blanks >= kMostInByte; blanks -= kMostInByte) bytes_ += static_cast<char>(kMostInByte);
    bytes_ += static_cast<char>(blanks);
    bytes_ += RestAt(text, begin);
    place = Read(place).end;
  }
  bytes_.shrink_to_fit();
  places_.shrink_to_fit();
}

PackedLines::Part PackedLines::Read(Place place) const {
  Part part{place, 0, {}, place};
  std::size_t at = place.packed;
  unsigned char byte = kMostInByte;
  while (byte == kMostInByte) part.blanks += byte = static_cast<unsigned char>(bytes_[at++]);
  part.rest = RestAt(bytes_, at);
  const auto size = static_cast<std::uint32_t>(part.rest.size());
  part.end.offset += part.blanks + size;
  part.end.packed = static_cast<std::uint32_t>(at) + size;
  if (size == 0 || part.rest.back() != '\n') return part;
  ++part.end.line;
  part.end.line_begin = part.end.offset;
  return part;
}

PackedLines::Part PackedLines::PartAt(std::uint32_t offset) const {
  const auto behind =
      std::upper_bound(places_.begin(), places_.end(), offset,
                       [](std::uint32_t at, const Place& place) { return at < place.offset; });
  Part part = Read(*(behind - 1));
  while (part.end.offset <= offset && part.end.packed < bytes_.size()) part = Read(part.end);
  return part;
}

std::string PackedLines::text() const {
  std::string text;
  for (Part part; part.end.packed < bytes_.size();) {
    part = Read(part.end);
    text.append(part.blanks, ' ').append(part.rest);
  }
  return text;
}

std::string PackedLines::Piece(std::uint32_t offset, std::size_t most) const {
  const Part part = PartAt(offset);
  const std::size_t at = offset - part.begin.offset;
  const std::size_t passed = std::min<std::size_t>(part.blanks, at);
  const std::size_t blanks = std::min(most, part.blanks - passed);
  const std::size_t from = std::min(part.rest.size(), at - passed);
  return std::string(blanks, ' ').append(part.rest.substr(from, most - blanks));
}

PackedLines::Position PackedLines::PositionOf(std::uint32_t offset) const {
  const Place line = PartAt(offset).begin;
  return {line.line + 1, offset - line.line_begin + 1};
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
