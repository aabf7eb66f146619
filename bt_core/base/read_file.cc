#include "bt_core/base/read_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

namespace coppice {
namespace {

constexpr std::size_t kPiece = 1 << 16;

// What is wrong; empty if nothing is.
std::string Read(const std::string& path, std::size_t longest, std::string& bytes) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             std::fclose);
  if (!file) return std::string("cannot be read: ") + std::strerror(errno);
  for (std::size_t count = kPiece; count == kPiece;) {
    const std::size_t size = bytes.size();
    bytes.resize(size + kPiece);
    count = std::fread(&bytes[size], 1, kPiece, file.get());
    bytes.resize(size + count);
    if (std::ferror(file.get())) return std::string("cannot be read: ") + std::strerror(errno);
    if (bytes.size() > longest) return "is longer than " + std::to_string(longest) + " bytes";
  }
  return "";
}

}  // namespace

std::optional<std::string> ReadFile(const std::string& path, std::size_t longest) {
  std::string bytes;
  return Read(path, longest, bytes).empty() ? std::optional(std::move(bytes)) : std::nullopt;
}

std::optional<std::string> ReadFile(const std::string& path, Diagnostics& diagnostics,
                                    std::size_t longest) {
  std::string bytes;
  const std::string problem = Read(path, longest, bytes);
  if (problem.empty()) return bytes;
  diagnostics.Error({path}, problem);
  return std::nullopt;
}

}  // namespace coppice
