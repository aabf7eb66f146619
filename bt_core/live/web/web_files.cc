#include "bt_core/live/web/web_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
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

std::string_view Trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

bool EqualsIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](unsigned char x, unsigned char y) {
    return std::tolower(x) == std::tolower(y);
  });
}

// "q=0", "q=0.000": not that.
bool IsRefused(std::string_view weight) {
  weight = Trimmed(weight);
  return weight.size() > 2 && EqualsIgnoringCase(weight.substr(0, 2), "q=") &&
         weight.substr(2).find_first_not_of("0.") == std::string_view::npos;
}

bool IsFile(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(path, error);
}

bool IsOlder(const std::filesystem::path& path, const std::filesystem::path& other) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(path, error);
  return error || time < std::filesystem::last_write_time(other, error);
}

}  // namespace

bool AcceptsGzip(std::string_view accept_encoding) {
  bool accepts_any = false;
  while (!accept_encoding.empty()) {
    const std::size_t end = std::min(accept_encoding.find(','), accept_encoding.size());
    const std::string_view item = accept_encoding.substr(0, end);
    accept_encoding.remove_prefix(std::min(end + 1, accept_encoding.size()));
    const auto semicolon = std::find(item.begin(), item.end(), ';');
    const std::size_t length = semicolon - item.begin();
    const std::string_view name = Trimmed(item.substr(0, length));
    const bool refused = length < item.size() && IsRefused(item.substr(length + 1));
    if (EqualsIgnoringCase(name, "gzip") || EqualsIgnoringCase(name, "x-gzip")) return !refused;
    if (name == "*") accepts_any = !refused;
  }
  return accepts_any;
}

std::optional<WebFile> WebFiles::Find(std::string_view target, bool accepts_gzip) const {
  if (target.empty() || target.front() != '/') return std::nullopt;
  target = target.substr(1, target.find('?') - 1);
  const std::string_view name = target.empty() ? "index.html" : target;
  const char* const type = TypeOf(name);
  if (!type || !IsPlainName(name)) return std::nullopt;
  const std::filesystem::path path = std::filesystem::path(folder_) / name;
  const std::filesystem::path compressed = path.string() + ".gz";
  if (accepts_gzip && !IsOlder(compressed, path) && IsFile(compressed)) {
    return WebFile{type, compressed, true};
  }
  if (!IsFile(path)) return std::nullopt;
  return WebFile{type, path};
}

}  // namespace coppice
