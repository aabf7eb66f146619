#include "editor/keys/key_file.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace coppice::editor {
namespace {

std::string_view Trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

struct KeyLine {
  std::string_view whole;  // with its line end
  std::string_view id;     // empty: a comment, or nothing
  std::string_view keys;
  bool has_sign = false;  // "="
};

std::vector<KeyLine> Split(std::string_view text) {
  std::vector<KeyLine> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
    KeyLine line;
    line.whole = text.substr(0, end);
    std::string_view content = line.whole;
    if (content.back() == '\n') content.remove_suffix(1);
    content = Trimmed(content);
    if (!content.empty() && content.front() != '#') {
      const std::size_t sign = content.find('=');
      line.has_sign = sign != std::string_view::npos;
      line.id = Trimmed(content.substr(0, sign));
      if (line.has_sign) line.keys = Trimmed(content.substr(sign + 1));
    }
    lines.push_back(line);
    text.remove_prefix(end);
  }
  return lines;
}

std::string Replaced(std::string_view text, std::string_view id, const std::string& line) {
  std::string result;
  bool done = line.empty();
  for (const KeyLine& known : Split(text)) {
    if (known.id != id) {
      result += known.whole;
    } else if (!done) {
      result += line;
      done = true;
    }
  }
  if (done) return result;
  if (!result.empty() && result.back() != '\n') result += '\n';
  return result + line;
}

}  // namespace

void ReadKeys(std::string_view text, const std::string& file, CommandTable& commands,
              Diagnostics& diagnostics) {
  std::vector<std::string> ids;
  for (const EditorCommand& command : commands.all()) ids.push_back(command.id);
  std::uint32_t number = 0;
  for (const KeyLine& line : Split(text)) {
    const SourceLocation where = {file, ++number, 1};
    if (line.id.empty() && !line.has_sign) continue;
    const std::optional<KeyChord> keys = KeysFromString(line.keys);
    if (!commands.Find(line.id)) {
      diagnostics.Error(where, "there is no command " + std::string(line.id),
                        DidYouMean(std::string(line.id), ids));
    } else if (!line.has_sign || !keys) {
      diagnostics.Error(where, "expected keys, as in " + std::string(line.id) + " = Ctrl+Shift+F2",
                        line.keys.empty() ? "" : std::string(line.keys) + " is no key");
    } else {
      commands.SetKeys(line.id, *keys);
    }
  }
  for (const KeyConflict& conflict : commands.FindConflicts()) {
    diagnostics.Error(
        {file, 0, 0},
        ToString(conflict.keys) + " is bound to " + conflict.first + " and to " + conflict.second,
        "give one of them other keys: F1");
  }
}

std::string WithKeys(std::string_view text, std::string_view id, KeyChord keys) {
  std::string line(id);
  line += " =";
  if (keys.key != 0) line += " " + ToString(keys);
  return Replaced(text, id, line + "\n");
}

std::string WithoutKeys(std::string_view text, std::string_view id) {
  return Replaced(text, id, "");
}

}  // namespace coppice::editor
