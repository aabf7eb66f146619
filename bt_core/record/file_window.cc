#include "bt_core/record/file_window.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

namespace coppice {
namespace {
constexpr std::uint64_t kWindowBytes = 64 << 10;
}

FileWindow::FileWindow(const std::string& path)
    : file_(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {
  struct stat status {};
  if (file_ < 0 || fstat(file_, &status) != 0) {
    error_ = std::strerror(errno);
  } else if (!S_ISREG(status.st_mode)) {
    error_ = "not a regular file";
  } else {
    size_ = static_cast<std::uint64_t>(status.st_size);
  }
}

FileWindow::~FileWindow() {
  if (file_ >= 0) close(file_);
}

FileWindow::FileWindow(FileWindow&& other) noexcept
    : file_(std::exchange(other.file_, -1)),
      size_(other.size_),
      error_(std::move(other.error_)),
      start_(other.start_),
      window_(std::move(other.window_)) {}

void FileWindow::Refresh() {
  struct stat status {};
  if (file_ >= 0 && error_.empty() && fstat(file_, &status) == 0) {
    size_ = static_cast<std::uint64_t>(status.st_size);
  }
}

const std::uint8_t* FileWindow::View(std::uint64_t offset, std::uint64_t count) {
  if (offset > size_ || count > size_ - offset) return nullptr;
  const bool inside = offset >= start_ && offset + count <= start_ + window_.size();
  if (!inside && !Load(offset, count)) return nullptr;
  return window_.data() + (offset - start_);
}

bool FileWindow::Load(std::uint64_t offset, std::uint64_t count) {
  const std::uint64_t wanted = std::min(std::max(count, kWindowBytes), size_ - offset);
  window_.resize(wanted);
  start_ = offset;
  std::uint64_t got = 0;
  while (got < wanted) {
    const ssize_t part =
        pread(file_, window_.data() + got, wanted - got, static_cast<off_t>(offset + got));
    if (part < 0 && errno == EINTR) continue;
    if (part <= 0) break;  // shorter than it was, or a broken disk
    got += static_cast<std::uint64_t>(part);
  }
  window_.resize(got);
  return got >= count;
}

}  // namespace coppice
