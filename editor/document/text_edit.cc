#include "editor/document/text_edit.h"

#include <algorithm>

#include "bt_core/model/layout.h"

namespace coppice::editor {
namespace {

constexpr int kPage = 20;  // lines

bool IsInner(char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; }

bool IsWord(char c) {
  return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80U;
}

std::size_t Next(std::string_view text, std::size_t at) {
  if (at >= text.size()) return text.size();
  if (text[at] == '\r' && at + 1 < text.size() && text[at + 1] == '\n') return at + 2;
  ++at;
  while (at < text.size() && IsInner(text[at])) ++at;
  return at;
}

std::size_t Previous(std::string_view text, std::size_t at) {
  if (at == 0) return 0;
  --at;
  if (text[at] == '\n' && at > 0 && text[at - 1] == '\r') return at - 1;
  while (at > 0 && IsInner(text[at])) --at;
  return at;
}

std::size_t LineStart(std::string_view text, std::size_t at) {
  return at == 0 ? 0 : text.rfind('\n', at - 1) + 1;  // npos + 1 is 0
}

std::size_t LineEnd(std::string_view text, std::size_t at) {
  const std::size_t end = std::min(text.find('\n', at), text.size());
  return end > at && end < text.size() && text[end - 1] == '\r' ? end - 1 : end;
}

// The same column in a line further up or down; columns are counted in characters.
std::size_t Vertically(std::string_view text, std::size_t at, int lines) {
  std::size_t line = LineStart(text, at);
  std::size_t column = 0;
  for (std::size_t i = line; i < at; i = Next(text, i)) ++column;
  for (; lines < 0 && line > 0; ++lines) line = LineStart(text, line - 1);
  for (; lines > 0; --lines) {
    const std::size_t end = text.find('\n', line);
    if (end == std::string_view::npos) break;
    line = end + 1;
  }
  const std::size_t end = LineEnd(text, line);
  while (column-- > 0 && line < end) line = Next(text, line);
  return line;
}

std::size_t SmartStart(std::string_view text, std::size_t at) {
  const std::size_t start = LineStart(text, at);
  std::size_t first = start;
  while (first < text.size() && (text[first] == ' ' || text[first] == '\t')) ++first;
  return at == first ? start : first;
}

std::size_t WordLeft(std::string_view text, std::size_t at) {
  while (at > 0 && !IsWord(text[at - 1])) --at;
  while (at > 0 && IsWord(text[at - 1])) --at;
  return at;
}

std::size_t WordRight(std::string_view text, std::size_t at) {
  while (at < text.size() && !IsWord(text[at])) ++at;
  while (at < text.size() && IsWord(text[at])) ++at;
  return at;
}

std::size_t After(std::string_view text, std::size_t at, TextStep step) {
  switch (step) {
    case TextStep::kLeft:
      return Previous(text, at);
    case TextStep::kRight:
      return Next(text, at);
    case TextStep::kWordLeft:
      return WordLeft(text, at);
    case TextStep::kWordRight:
      return WordRight(text, at);
    case TextStep::kUp:
      return Vertically(text, at, -1);
    case TextStep::kDown:
      return Vertically(text, at, 1);
    case TextStep::kPageUp:
      return Vertically(text, at, -kPage);
    case TextStep::kPageDown:
      return Vertically(text, at, kPage);
    case TextStep::kLineStart:
      return SmartStart(text, at);
    case TextStep::kEnd:
      return LineEnd(text, at);
    case TextStep::kTextStart:
      return 0;
    case TextStep::kTextEnd:
      return text.size();
  }
  return at;
}

}  // namespace

void TextEdit::Put(std::string_view what) {
  const std::size_t start = begin();
  text.replace(start, end() - start, what);
  at = anchor = start + what.size();
}

void TextEdit::PutLineEnd() {
  const std::size_t start = LineStart(text, begin());
  std::size_t first = start;
  while (first < begin() && (text[first] == ' ' || text[first] == '\t')) ++first;
  Put(std::string(LineEndAt(text, start)) + text.substr(start, first - start));
}

void TextEdit::Erase(bool forward) {
  if (at == anchor) at = forward ? Next(text, at) : Previous(text, at);
  Put("");
}

void TextEdit::Move(TextStep step, bool extend) {
  const bool has_selection = at != anchor;
  if (!extend && has_selection && step == TextStep::kLeft) {
    at = begin();
  } else if (!extend && has_selection && step == TextStep::kRight) {
    at = end();
  } else {
    at = After(text, at, step);
  }
  if (!extend) anchor = at;
}

void TextEdit::SelectAll() {
  anchor = 0;
  at = text.size();
}

}  // namespace coppice::editor
