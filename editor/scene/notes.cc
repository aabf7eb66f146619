#include "editor/scene/notes.h"

#include <algorithm>
#include <cctype>
#include <string_view>

#include "bt_core/model/utf8.h"

namespace coppice::editor {
namespace {

constexpr std::string_view kOpen = "<!--";
constexpr std::string_view kClose = "-->";
constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kBlanksOfALine = " \t";
constexpr std::size_t kLongest = 1000;  // bytes: each instance of a tree has them

bool IsBlank(char c) { return kBlanks.find(c) != std::string_view::npos; }

// True if nothing but blanks comes before the end of the line.
bool EndsLine(std::string_view text, std::size_t offset) {
  const std::size_t next = text.find_first_not_of(kBlanksOfALine, offset);
  return next == std::string_view::npos || text[next] == '\n' || text[next] == '\r';
}

// Groot 1 draws a line of slashes between trees.
bool SaysSomething(std::string_view comment) {
  return std::any_of(comment.begin(), comment.end(),
                     [](unsigned char c) { return c >= 0x80 || std::isalnum(c) != 0; });
}

// Adds the words of a comment, of a long one the first.
void AddWords(std::string_view comment, std::string& note) {
  if (!SaysSomething(comment)) return;
  for (std::size_t i = 0; i < comment.size() && note.size() < kLongest; ++i) {
    if (!IsBlank(comment[i])) {
      note += comment[i];
    } else if (!note.empty() && note.back() != ' ') {
      note += ' ';
    }
  }
  if (!note.empty() && note.back() != ' ') note += ' ';
}

// The comments that end before `offset` with nothing but blanks between them; the last first. Stops
// at one that follows something else on its line: that one is about what it follows.
void AddBefore(std::string_view text, std::size_t offset, std::string& note) {
  std::string before;
  while (before.size() < kLongest) {
    const std::size_t end = text.find_last_not_of(kBlanks, offset - 1);
    if (end == std::string_view::npos || end + 1 < kClose.size() + kOpen.size()) break;
    if (text.substr(end + 1 - kClose.size(), kClose.size()) != kClose) break;
    const std::size_t begin = text.rfind(kOpen, end);
    if (begin == std::string_view::npos || begin == 0) break;
    const std::size_t left = text.find_last_not_of(kBlanksOfALine, begin - 1);
    const bool follows = left != std::string_view::npos && text[left] == '>' &&
                         EndsLine(text, end + 1) &&
                         (left < 2 || text.substr(left - 2, 3) != kClose);
    if (follows) break;
    std::string words;
    AddWords(text.substr(begin + kOpen.size(), end - 2 - begin - kOpen.size()), words);
    before = words + before;
    offset = begin;
  }
  note += before;
}

// The comments that begin behind `offset` with nothing but these blanks between them.
void AddBehind(std::string_view text, std::size_t offset, std::string_view blanks,
               std::string& note) {
  while (note.size() < kLongest) {
    const std::size_t begin = text.find_first_not_of(blanks, offset);
    if (begin == std::string_view::npos || text.substr(begin, kOpen.size()) != kOpen) return;
    const std::size_t end = text.find(kClose, begin + kOpen.size());
    if (end == std::string_view::npos) return;
    if (blanks == kBlanksOfALine && !EndsLine(text, end + kClose.size())) return;
    AddWords(text.substr(begin + kOpen.size(), end - begin - kOpen.size()), note);
    offset = end + kClose.size();
  }
}

}  // namespace

std::string NoteOf(const Document& document, ElementIndex index) {
  const std::string_view text = document.text();
  const Element& element = document.element(index);
  std::string note;
  if (element.parent != kNoElement && document.element(element.parent).tag == "BehaviorTree") {
    AddBefore(text, document.element(element.parent).offset, note);
  }
  AddBefore(text, element.offset, note);
  if (!element.is_self_closing()) AddBehind(text, element.start_tag_end, kBlanksOfALine, note);
  const bool last = element.next_sibling == kNoElement;
  AddBehind(text, element.end, last ? kBlanks : kBlanksOfALine, note);
  if (!note.empty()) note.pop_back();
  return note.size() > kLongest ? PlainText(note, kLongest) : note;
}

}  // namespace coppice::editor
