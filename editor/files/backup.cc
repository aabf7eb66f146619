#include "editor/files/backup.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "bt_core/model/write_file.h"

namespace coppice::editor {
namespace {

// FNV-1a, http://www.isthe.com/chongo/tech/comp/fnv: a file name for a path.
std::uint64_t HashOf(const std::string& text) {
  std::uint64_t hash = 14695981039346656037U;
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 1099511628211U;
  }
  return hash;
}

std::string AbsolutePath(const std::string& path) {
  std::error_code error;
  return std::filesystem::absolute(path, error).lexically_normal().string();
}

}  // namespace

// The name of the file stays readable; the first line of the copy is its whole path.
std::string Backup::PathOf(const std::string& path) const {
  const std::string full = AbsolutePath(path);
  return folder_ + "/" + std::to_string(HashOf(full)) + "-" + full.substr(full.rfind('/') + 1);
}

void Backup::Update(const OpenProject& project) {
  if (folder_.empty()) return;
  for (const auto& [path, file] : project.files()) {
    const auto known = written_.find(path);
    if (!file.is_dirty()) {
      if (known != written_.end()) Remove(path);
      continue;
    }
    if (known != written_.end() && known->second == file.version) continue;
    std::error_code error;
    std::filesystem::create_directories(folder_, error);
    Diagnostics ignored;  // the next time it may succeed
    if (WriteFile(PathOf(path), AbsolutePath(path) + "\n" + file.text, ignored)) {
      written_[path] = file.version;
    }
  }
}

std::optional<std::string> Backup::Find(const EditedFile& file) const {
  if (folder_.empty()) return std::nullopt;
  std::ifstream stream(PathOf(file.path), std::ios::binary);
  std::string path;
  if (!std::getline(stream, path) || path != AbsolutePath(file.path)) return std::nullopt;
  std::string text{std::istreambuf_iterator<char>(stream), {}};
  return text == file.text ? std::nullopt : std::optional(std::move(text));
}

void Backup::Remove(const std::string& path) {
  if (folder_.empty()) return;
  std::error_code error;
  std::filesystem::remove(PathOf(path), error);
  written_.erase(path);
}

}  // namespace coppice::editor
