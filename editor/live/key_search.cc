#include "editor/live/key_search.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace coppice::editor {
bool HasWord(std::string_view text, std::string_view word) {
  const auto lower = [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  };
  return std::search(text.begin(), text.end(), word.begin(), word.end(),
                     [&](char a, char b) { return a == b || lower(a) == lower(b); }) != text.end();
}

bool IsKeyFound(std::string_view path, std::string_view value, const std::string& words) {
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    if (!HasWord(path, word) && !HasWord(value, word)) return false;
  }
  return true;
}

std::string BeginningOf(std::string_view value, std::size_t most_bytes) {
  if (value.size() <= most_bytes) return std::string(value);
  std::size_t end = most_bytes;
  while (end > 0 && (static_cast<unsigned char>(value[end]) & 0xC0U) == 0x80U) --end;
  return std::string(value.substr(0, end)) + " ... (" + std::to_string(value.size()) +
         " bytes in all)";
}

}  // namespace coppice::editor
