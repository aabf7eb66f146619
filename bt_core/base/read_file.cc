#include "bt_core/base/read_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace coppice {
namespace {

constexpr std::size_t kPiece = 1 << 16;

std::string WhyNot() { return std::string("cannot be read: ") + std::strerror(errno); }

// Closes it in the end.
class File {
 public:
  explicit File(const std::string& path)
      : file_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
    struct stat status {};
    if (!is_open() || fstat(file_, &status) != 0) return;
    is_regular_ = S_ISREG(status.st_mode);
    if (S_ISFIFO(status.st_mode)) fcntl(file_, F_SETFL, fcntl(file_, F_GETFL) & ~O_NONBLOCK);
  }
  ~File() {
    if (is_open()) close(file_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  bool is_open() const { return file_ >= 0; }
  /// What lies on no disk may have no end, whatever the reader expects.
  std::size_t Longest(std::size_t longest) const {
    return is_regular_ ? longest : std::min(longest, kLongestFile);
  }
  /// Negative: errno says why; 0: at the end.
  ssize_t Read(char* to, std::size_t size) const {
    ssize_t count = 0;
    do {
      count = read(file_, to, size);
    } while (count < 0 && errno == EINTR);
    return count;
  }

 private:
  const int file_;
  bool is_regular_ = false;
};

// What is wrong; empty if nothing is.
std::string Read(const std::string& path, std::size_t longest, std::string& bytes) {
  const File file(path);
  if (!file.is_open()) return WhyNot();
  longest = file.Longest(longest);
  for (;;) {
    const std::size_t size = bytes.size();
    // Never more than was asked for, and a byte to see whether there is more.
    bytes.reserve(std::min(longest + 1, std::max(bytes.capacity(), 2 * size + kPiece)));
    bytes.resize(std::min(longest + 1, size + kPiece));
    const ssize_t count = file.Read(&bytes[size], bytes.size() - size);
    bytes.resize(size + static_cast<std::size_t>(std::max<ssize_t>(count, 0)));
    if (count < 0) return WhyNot();
    if (count == 0) return "";
    if (bytes.size() > longest) return "is longer than " + std::to_string(longest) + " bytes";
  }
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
