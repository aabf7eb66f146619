#include "editor/canvas/layout/value_lines.h"

#include <algorithm>
#include <string_view>

#include "editor/canvas/layout/node_metrics.h"
#include "editor/theme/icons.h"

namespace coppice::editor {
namespace {

constexpr std::size_t kMostLines = 4;  // of a script on the canvas
constexpr std::string_view kSetIn = "  ";
constexpr std::string_view kBlanks = " \t\r\n";

bool IsScript(const PortLine& port) {
  const bool is_guard = !port.name.empty() && port.name.front() == '_';
  return is_guard || (port.model && port.model->type == "script");
}

// Where the character behind the first `count` begins; the size if there are no more.
std::size_t Behind(std::string_view text, std::size_t count) {
  std::size_t at = 0;
  while (at < text.size()) {
    const bool is_start = (static_cast<unsigned char>(text[at]) & 0xC0U) != 0x80U;
    if (is_start && count-- == 0) break;
    ++at;
  }
  return at;
}

std::string_view Trimmed(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) + 1 - begin);
}

// At blanks if there are any far enough to the right. What is seen is no more than `most` lines, so
// that of a script as long as a file no more is looked at.
void Wrap(std::string_view text, std::size_t most, std::vector<std::string>& lines) {
  std::string_view before;
  for (text = Trimmed(text); !text.empty() && lines.size() < most; before = kSetIn) {
    std::size_t end = Behind(text, metrics::kValueColumns - before.size());
    if (end < text.size()) {
      const std::size_t blank = text.find_last_of(kBlanks, end);
      if (blank != std::string_view::npos && blank > end / 3) end = blank;
    }
    lines.push_back(std::string(before) + std::string(Trimmed(text.substr(0, end))));
    text = Trimmed(text.substr(end));
  }
}

// Where the next statement begins: behind a semicolon or a line end that is in no text.
std::size_t EndOfStatement(std::string_view script) {
  bool in_text = false;
  for (std::size_t i = 0; i < script.size(); ++i) {
    if (script[i] == '\'') in_text = !in_text;
    if (!in_text && (script[i] == ';' || script[i] == '\n')) return i + 1;
  }
  return script.size();
}

std::vector<std::string> LinesOfScript(std::string_view script, std::size_t most) {
  std::vector<std::string> lines;
  while (!script.empty() && lines.size() < most) {
    const std::size_t end = EndOfStatement(script);
    Wrap(script.substr(0, end), most, lines);
    script.remove_prefix(end);
  }
  return lines;
}

bool IsShort(std::string_view value) {
  return Behind(value, metrics::kValueColumns) == value.size() &&
         value.find('\n') == std::string_view::npos;
}

bool IsOneLine(const PortLine& port, bool whole) {
  return !port.key.empty() || IsShort(port.value) || !(whole || IsScript(port));
}

}  // namespace

std::vector<std::string> ValueLines(const PortLine& port, bool whole) {
  if (IsOneLine(port, whole)) {
    return {whole && !port.key.empty() ? std::string(port.value) : ShownValue(port.value)};
  }
  const std::size_t most = whole ? port.value.size() : kMostLines + 1;
  std::vector<std::string> lines;
  if (IsScript(port)) {
    lines = LinesOfScript(port.value, most);
  } else {
    Wrap(port.value, most, lines);
  }
  if (!whole && lines.size() > kMostLines) {
    lines.resize(kMostLines);
    lines.back() += icon::kEllipsis;
  }
  if (lines.empty()) lines.emplace_back();
  return lines;
}

std::uint32_t ValueLineCount(const PortLine& port, bool whole) {
  if (IsOneLine(port, whole)) return 1;
  return static_cast<std::uint32_t>(ValueLines(port, whole).size());
}

}  // namespace coppice::editor
