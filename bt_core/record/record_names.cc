#include "bt_core/record/record_names.h"

#include <algorithm>
#include <filesystem>
#include <optional>

namespace coppice {
namespace {

namespace fs = std::filesystem;

// "12" -> 12. Numbers begin with 2, and not with a zero.
std::optional<std::uint32_t> ReadNumber(const std::string& text) {
  constexpr std::size_t kMaxDigits = 9;
  if (text.empty() || text.size() > kMaxDigits || text[0] == '0' || text == "1") return {};
  std::uint32_t number = 0;
  for (const char digit : text) {
    if (digit < '0' || digit > '9') return {};
    number = number * 10 + static_cast<std::uint32_t>(digit - '0');
  }
  return number;
}

struct NameParts {
  std::string stem;
  std::uint32_t number;
  std::string extension;
};

NameParts Split(const fs::path& name) {
  const std::string stem = name.stem();
  const std::size_t dot = stem.rfind('.');
  if (dot != std::string::npos) {
    if (const auto number = ReadNumber(stem.substr(dot + 1))) {
      return {stem.substr(0, dot), *number, name.extension()};
    }
  }
  return {stem, 1, name.extension()};
}

}  // namespace

std::string NumberedName(const std::string& path, std::uint32_t number) {
  if (number == 1) return path;
  fs::path numbered(path);
  const std::string extension = numbered.extension();
  numbered.replace_extension(std::to_string(number) + extension);
  return numbered;
}

std::vector<NumberedFile> FilesOfSeries(const std::string& path) {
  const fs::path folder = fs::path(path).parent_path();
  const NameParts wanted = Split(fs::path(path).filename());
  std::vector<NumberedFile> files;
  std::error_code error;  // a folder that cannot be read has no files
  for (fs::directory_iterator at(folder.empty() ? "." : folder, error), end; !error && at != end;
       at.increment(error)) {
    const fs::path name = at->path().filename();
    const NameParts parts = Split(name);
    if (parts.stem == wanted.stem && parts.extension == wanted.extension) {
      files.push_back({parts.number, folder / name});
    }
  }
  std::sort(files.begin(), files.end(),
            [](const NumberedFile& a, const NumberedFile& b) { return a.number < b.number; });
  return files;
}

}  // namespace coppice
