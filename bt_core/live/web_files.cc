#include "bt_core/live/web_files.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

namespace coppice {
namespace {

struct Kind {
  std::string_view ending;
  const char* type;
};
constexpr Kind kKinds[] = {
    {".html", "text/html; charset=utf-8"},
    {".css", "text/css; charset=utf-8"},
    {".js", "text/javascript"},
    {".wasm", "application/wasm"},
    {".data", "application/octet-stream"},
};

const char* TypeOf(std::string_view name) {
  for (const Kind& kind : kKinds) {
    if (name.size() > kind.ending.size() &&
        name.substr(name.size() - kind.ending.size()) == kind.ending) {
      return kind.type;
    }
  }
  return nullptr;
}

// No folders, nothing hidden.
bool IsPlainName(std::string_view name) {
  constexpr std::string_view kAllowed =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.";
  return !name.empty() && name.front() != '.' &&
         name.find_first_not_of(kAllowed) == std::string_view::npos;
}

}  // namespace

std::optional<WebFile> WebFiles::Find(std::string_view target) const {
  if (target.empty() || target.front() != '/') return std::nullopt;
  target = target.substr(1, target.find('?') - 1);
  const std::string_view name = target.empty() ? "index.html" : target;
  const char* const type = TypeOf(name);
  if (!type || !IsPlainName(name)) return std::nullopt;
  const std::filesystem::path path = std::filesystem::path(folder_) / name;
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  if (!file) return std::nullopt;
  return WebFile{type, {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()}};
}

}  // namespace coppice
