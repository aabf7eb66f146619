// People read the difference of two versions. So an edit takes and gives whole lines where elements
// stand on lines of their own, follows the indentation around it, and leaves every other byte
// alone, comments and odd blanks too.
#include "bt_core/model/element_edits.h"

#include <algorithm>
#include <string>

#include "bt_core/model/layout.h"
#include "bt_core/model/markup.h"
#include "bt_core/model/xml_text.h"

namespace coppice {
namespace {

std::string_view TextBetween(const Document& document, std::size_t begin, std::size_t end) {
  return std::string_view(document.text()).substr(begin, end - begin);
}

// The indentation that the text's own last line has.
std::string_view OwnIndentation(std::string_view xml) {
  const std::size_t line = xml.find_last_of("\r\n");
  if (line == std::string_view::npos) return {};
  const std::string_view last = xml.substr(line + 1);
  return last.substr(0, std::min(last.find_first_not_of(" \t"), last.size()));
}

// Behind the comments that follow on the same line: they are about what stands before them.
std::size_t SkipCommentsOnLine(std::string_view text, std::size_t at) {
  for (;;) {
    const std::size_t next = text.find_first_not_of(" \t", at);
    if (next == std::string_view::npos || text[next] != '<') return at;
    const Markup piece = ReadMarkup(text, next);
    if (piece.kind != MarkupKind::kComment) return at;
    at = piece.end;
  }
}

// Where a new child goes and what must stand around it.
struct InsertionPoint {
  std::size_t begin = 0;
  std::size_t end = 0;  // > begin: this text is replaced
  std::string before;
  std::string indentation;
  std::string after;
};

// Into an element without child elements.
InsertionPoint PlaceInEmpty(const Document& document, ElementIndex parent) {
  const Element& element = document.element(parent);
  const std::string_view text = document.text();
  const auto outer = IndentationAt(text, element.offset);
  const std::string line_end(LineEndAt(text, element.offset));
  InsertionPoint place;
  if (outer) place.indentation = std::string(*outer) += IndentationStep(document, parent);
  const std::string line = outer ? line_end + place.indentation : "";
  const std::string last_line = outer ? line_end + std::string(*outer) : "";
  if (element.is_self_closing()) {
    const std::size_t slash = element.end - 2;
    place.begin = text.find_last_not_of(kXmlBlanks, slash - 1) + 1;
    place.end = element.end;
    place.before = ">" + line;
    place.after = last_line + "</" + std::string(element.tag) + ">";
    return place;
  }
  const std::size_t end_tag = EndTagOffset(document, element);
  const std::string_view content = TextBetween(document, element.start_tag_end, end_tag);
  const std::size_t last = content.find_last_not_of(kXmlBlanks);
  const std::size_t used = last == std::string_view::npos ? 0 : last + 1;
  place.begin = place.end = element.start_tag_end + used;
  place.before = line;
  if (content.find('\n', used) == std::string_view::npos) place.after = last_line;
  return place;
}

// `moved` does not count as a child.
InsertionPoint FindPlace(const Document& document, ElementIndex parent, std::uint32_t position,
                         ElementIndex moved = kNoElement) {
  const Element& element = document.element(parent);
  const std::string_view text = document.text();
  ElementIndex previous = kNoElement;
  ElementIndex next = element.first_child;
  if (next == moved && next != kNoElement) next = document.element(next).next_sibling;
  for (; position > 0 && next != kNoElement; --position) {
    previous = next;
    next = document.element(next).next_sibling;
    if (next == moved && next != kNoElement) next = document.element(next).next_sibling;
  }
  if (previous == kNoElement && next == kNoElement) return PlaceInEmpty(document, parent);

  const Element& neighbour = document.element(previous == kNoElement ? next : previous);
  const auto indentation = IndentationAt(text, neighbour.offset);
  InsertionPoint place;
  if (!indentation) {
    place.begin = place.end = previous == kNoElement ? neighbour.offset : neighbour.end;
    return place;
  }
  place.indentation = *indentation;
  place.before = std::string(LineEndAt(text, neighbour.offset)) + place.indentation;
  place.begin = place.end =
      SkipCommentsOnLine(text, previous == kNoElement ? element.start_tag_end : neighbour.end);
  return place;
}

Splice PutAt(const Document& document, InsertionPoint place, std::string_view xml,
             std::string_view xml_indentation) {
  const std::string_view line_end = LineEndAt(document.text(), place.begin);
  place.before += Reindent(xml, xml_indentation, place.indentation, line_end);
  return Replacement(place.begin, place.end, place.before + place.after);
}

Splice Removal(const Document& document, const Element& element) {
  return RemovalOfLine(document.text(), element.offset, element.end);
}

bool LiesIn(const Document& document, ElementIndex inner, ElementIndex outer) {
  const Element& a = document.element(inner);
  const Element& b = document.element(outer);
  return a.offset >= b.offset && a.end <= b.end;
}

std::uint32_t PositionOf(const Document& document, ElementIndex element) {
  std::uint32_t position = 0;
  for (ElementIndex i = document.element(document.element(element).parent).first_child;
       i != element; i = document.element(i).next_sibling) {
    ++position;
  }
  return position;
}

}  // namespace

Edit SetTag(const Document& document, ElementIndex index, std::string_view tag) {
  const Element& element = document.element(index);
  if (element.tag == tag) return {};
  const std::size_t name = element.tag.data() - document.text().data();
  Edit edit = {Replacement(name, name + element.tag.size(), std::string(tag))};
  if (!element.is_self_closing()) {
    const std::size_t end_name = document.text().find('/', EndTagOffset(document, element)) + 1;
    edit.push_back(Replacement(end_name, end_name + element.tag.size(), std::string(tag)));
  }
  return edit;
}

Edit InsertElement(const Document& document, ElementIndex parent, std::uint32_t position,
                   std::string_view xml) {
  return {PutAt(document, FindPlace(document, parent, position), xml, OwnIndentation(xml))};
}

Edit RemoveElement(const Document& document, ElementIndex index) {
  if (index == 0) return {};
  return {Removal(document, document.element(index))};
}

Edit MoveElement(const Document& document, ElementIndex index, ElementIndex new_parent,
                 std::uint32_t position) {
  if (LiesIn(document, new_parent, index)) return {};
  const Element& element = document.element(index);
  const std::uint32_t last = document.element(new_parent).child_count;
  if (element.parent == new_parent && PositionOf(document, index) == std::min(position, last - 1)) {
    return {};
  }
  const std::string_view xml = TextBetween(document, element.offset, element.end);
  const auto indentation = IndentationAt(document.text(), element.offset);
  const InsertionPoint place = FindPlace(document, new_parent, position, index);
  return Merge({PutAt(document, place, xml, indentation ? *indentation : OwnIndentation(xml))},
               {Removal(document, element)});
}

Edit ReplaceElement(const Document& document, ElementIndex index, std::string_view xml) {
  const Element& element = document.element(index);
  InsertionPoint place;
  place.begin = element.offset;
  place.end = element.end;
  place.indentation = IndentationAt(document.text(), element.offset).value_or("");
  return {PutAt(document, place, xml, OwnIndentation(xml))};
}

Edit WrapElements(const Document& document, ElementIndex first, std::uint32_t count,
                  std::string_view tag) {
  if (first == 0 || count == 0) return {};
  ElementIndex last = first;
  for (; count > 1 && document.element(last).next_sibling != kNoElement; --count) {
    last = document.element(last).next_sibling;
  }
  const std::size_t begin = document.element(first).offset;
  const std::size_t end = document.element(last).end;
  const auto outer = IndentationAt(document.text(), begin);
  const std::string name(tag);
  if (!outer)
    return {Replacement(begin, begin, "<" + name + ">"), Replacement(end, end, "</" + name + ">")};

  const std::string line_end(LineEndAt(document.text(), begin));
  std::string inner(*outer);
  inner += IndentationStep(document, document.element(first).parent);
  const std::string lines = Reindent(TextBetween(document, begin, end), *outer, inner, line_end);
  return {Replacement(begin, end,
                      "<" + name + ">" + line_end + inner + lines + line_end + std::string(*outer) +
                          "</" + name + ">")};
}

Edit UnwrapElement(const Document& document, ElementIndex index) {
  const Element& element = document.element(index);
  if (index == 0) return {};
  if (element.child_count == 0) return RemoveElement(document, index);
  const std::size_t end_tag = EndTagOffset(document, element);
  const std::string_view text = document.text();
  const std::size_t begin = text.find_first_not_of(kXmlBlanks, element.start_tag_end);
  const std::size_t end = text.find_last_not_of(kXmlBlanks, end_tag - 1) + 1;
  const auto outer = IndentationAt(text, element.offset);
  const auto inner = IndentationAt(text, begin);
  const std::string_view content = TextBetween(document, begin, end);
  if (!outer || !inner) return {Replacement(element.offset, element.end, std::string(content))};
  return {Replacement(element.offset, element.end,
                      Reindent(content, *inner, *outer, LineEndAt(text, begin)))};
}

}  // namespace coppice
