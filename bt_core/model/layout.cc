#include "bt_core/model/layout.h"

#include <algorithm>

#include "bt_core/model/markup.h"

namespace coppice {
namespace {

// What the child's indentation adds to that of its parent; nothing if that cannot be said.
std::optional<std::string_view> StepBetween(const Document& document, const Element& parent,
                                            const Element& child) {
  const auto outer = IndentationAt(document.text(), parent.offset);
  const auto inner = IndentationAt(document.text(), child.offset);
  if (!outer || !inner || inner->size() <= outer->size()) return std::nullopt;
  if (inner->substr(0, outer->size()) != *outer) return std::nullopt;
  return inner->substr(outer->size());
}

// Copies text outside of values: at each line start, `from` is replaced by `to`.
class Indenter {
 public:
  Indenter(std::string_view from, std::string_view to, std::string_view line_end)
      : from_(from), to_(to), line_end_(line_end) {}

  void Add(std::string_view text) {
    while (!text.empty()) {
      const std::size_t line = std::min(text.find_first_of("\r\n"), text.size());
      result_ += text.substr(0, line);
      text.remove_prefix(line);
      if (!text.empty()) AddLineStart(text);
    }
  }
  void AddUnchanged(std::string_view text) { result_ += text; }
  std::string result() && { return std::move(result_); }

 private:
  void AddLineStart(std::string_view& text) {
    text.remove_prefix(text.substr(0, 2) == "\r\n" ? 2 : 1);
    result_ += line_end_;
    const std::size_t blanks = std::min(text.find_first_not_of(" \t"), text.size());
    const bool is_empty =
        blanks == text.size() ? false : text[blanks] == '\r' || text[blanks] == '\n';
    if (is_empty) return;
    result_ += to_;
    text.remove_prefix(text.substr(0, from_.size()) == from_ ? from_.size() : blanks);
  }

  std::string_view from_;
  std::string_view to_;
  std::string_view line_end_;
  std::string result_;
};

void AddTag(std::string_view tag, Indenter& indenter) {
  while (!tag.empty()) {
    const std::size_t quote = std::min(tag.find_first_of("\"'"), tag.size());
    indenter.Add(tag.substr(0, quote));
    tag.remove_prefix(quote);
    if (tag.empty()) return;
    const std::size_t end = std::min(tag.find(tag[0], 1), tag.size() - 1) + 1;
    indenter.AddUnchanged(tag.substr(0, end));
    tag.remove_prefix(end);
  }
}

}  // namespace

std::string_view LineEndAt(std::string_view text, std::size_t offset) {
  std::size_t line = offset == 0 ? std::string_view::npos : text.rfind('\n', offset - 1);
  if (line == std::string_view::npos) line = text.find('\n');
  const bool with_return = line != std::string_view::npos && line > 0 && text[line - 1] == '\r';
  return with_return ? "\r\n" : "\n";
}

std::optional<std::string_view> IndentationAt(std::string_view text, std::size_t offset) {
  const std::size_t last = text.substr(0, offset).find_last_not_of(" \t");
  const std::size_t first = last == std::string_view::npos ? 0 : last + 1;
  if (first > 0 && text[first - 1] != '\n' && text[first - 1] != '\r') return std::nullopt;
  return text.substr(first, offset - first);
}

std::string_view IndentationStep(const Document& document, ElementIndex index) {
  const Element& element = document.element(index);
  if (element.child_count > 0) {
    const auto step = StepBetween(document, element, document.element(element.first_child));
    if (step) return *step;
  }
  if (element.parent != kNoElement) {
    if (const auto step = StepBetween(document, document.element(element.parent), element)) {
      return *step;
    }
  }
  for (const Element& other : document.elements()) {
    if (other.parent == kNoElement) continue;
    const auto step = StepBetween(document, document.element(other.parent), other);
    if (step) return *step;
  }
  return "  ";
}

std::size_t EndTagOffset(const Document& document, const Element& element) {
  std::size_t at = element.start_tag_end;
  for (ElementIndex i = element.first_child; i != kNoElement;
       i = document.element(i).next_sibling) {
    at = document.element(i).end;
  }
  for (;;) {
    const Markup piece = ReadMarkup(document.text(), at);
    if (piece.kind == MarkupKind::kTag) return piece.begin;
    at = piece.end;
  }
}

Splice RemovalOfLine(std::string_view text, std::size_t begin, std::size_t end) {
  const std::size_t next = std::min(text.find_first_not_of(" \t", end), text.size());
  const bool ends_line = next == text.size() || text[next] == '\r' || text[next] == '\n';
  if (ends_line && begin > 0) {
    if (const auto indentation = IndentationAt(text, begin)) {
      begin -= indentation->size();
      const std::size_t line_end = text.substr(next, 2) == "\r\n" ? 2 : 1;
      end = std::min(next + line_end, text.size());
    } else {
      begin = text.find_last_not_of(" \t", begin - 1) + 1;
    }
  }
  return Replacement(begin, end, "");
}

std::string Reindent(std::string_view xml, std::string_view from, std::string_view to,
                     std::string_view line_end) {
  Indenter indenter(from, to, line_end);
  for (std::size_t at = 0; at < xml.size();) {
    const Markup piece = ReadMarkup(xml, at);
    const std::string_view text = xml.substr(at, piece.end - at);
    if (piece.kind == MarkupKind::kText) {
      indenter.Add(text);
    } else if (piece.kind == MarkupKind::kTag) {
      AddTag(text, indenter);
    } else {
      indenter.AddUnchanged(text);
    }
    at = piece.end;
  }
  return std::move(indenter).result();
}

}  // namespace coppice
