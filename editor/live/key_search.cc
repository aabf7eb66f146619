#include "editor/live/key_search.h"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace coppice::editor {
namespace {

bool Contains(const std::string& text, const std::string& word) {
  const auto is_same = [](char a, char b) {
    return std::tolower(static_cast<unsigned char>(a)) ==
           std::tolower(static_cast<unsigned char>(b));
  };
  return std::search(text.begin(), text.end(), word.begin(), word.end(), is_same) != text.end();
}

}  // namespace

bool IsKeyFound(const std::string& path, const std::string& value, const std::string& words) {
  std::istringstream stream(words);
  for (std::string word; stream >> word;) {
    if (!Contains(path, word) && !Contains(value, word)) return false;
  }
  return true;
}

std::string BeginningOf(const std::string& value, std::size_t most_bytes) {
  if (value.size() <= most_bytes) return value;
  std::size_t end = most_bytes;
  while (end > 0 && (static_cast<unsigned char>(value[end]) & 0xC0U) == 0x80U) --end;
  return value.substr(0, end) + " ... (" + std::to_string(value.size()) + " bytes in all)";
}

}  // namespace coppice::editor
