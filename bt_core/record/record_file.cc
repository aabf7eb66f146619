#include "bt_core/record/record_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <stdexcept>
#include <utility>

namespace coppice {
namespace {

std::string CannotText(const std::string& path, const char* what, int error) {
  return path + ": cannot " + what + ": " + std::strerror(error);
}

[[noreturn]] void RefuseToOverwrite(const std::string& path) {
  throw std::runtime_error(path + ": there is a file already, and a record overwrites nothing");
}

// A device is not even opened: that may be enough to disturb it.
void CheckPlace(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0 || S_ISFIFO(status.st_mode)) return;
  if (!S_ISREG(status.st_mode)) {
    throw std::runtime_error(path + ": this is a folder or a device, and a record is a file");
  }
  if (status.st_size > 0) RefuseToOverwrite(path);
}

}  // namespace

RecordFile::RecordFile(std::string path) : path_(std::move(path)) {
  CheckPlace(path_);
  file_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | O_NONBLOCK, 0644);
  if (file_ < 0) throw std::runtime_error(CannotText(path_, "make this record", errno));
  fcntl(file_, F_SETFL, O_APPEND);  // only the opening must not wait
  try {
    BecomeOnlyOne();
  } catch (const std::runtime_error&) {
    close(file_);
    throw;
  }
}

// Two programs that were started at the same moment have both seen that there is nothing. Where
// the file system knows no locks, or it is a pipe, there is nothing to be done.
void RecordFile::BecomeOnlyOne() const {
  if (flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
    throw std::runtime_error(path_ + ": another program is recording there");
  }
  struct stat status {};
  if (fstat(file_, &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0) {
    RefuseToOverwrite(path_);
  }
}

RecordFile::~RecordFile() { close(file_); }

Outcome RecordFile::Write(Bytes& bytes) {
  std::size_t written = 0;
  int error = 0;
  while (written < bytes.size() && error == 0) {
    const ssize_t count = write(file_, bytes.data() + written, bytes.size() - written);
    if (count >= 0) {
      written += static_cast<std::size_t>(count);
    } else if (errno != EINTR) {
      error = errno;
    }
  }
  bytes.erase(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(written));
  return error ? Problem{CannotText(path_, "write", error)} : Outcome();
}

Outcome RecordFile::Sync() {
  if (!has_name_) SyncFolder();
  struct stat status {};
  is_deleted_ = fstat(file_, &status) == 0 && status.st_nlink == 0;
  if (is_deleted_) {
    return Problem{path_ + ": somebody has deleted this record while it was written"};
  }
  if (fdatasync(file_) == 0) return {};
  const bool no_disk = errno == EINVAL || errno == EROFS;  // a pipe
  return no_disk ? Outcome() : Problem{CannotText(path_, "sync", errno)};
}

// A folder that cannot be synced is none that keeps names, such as that of a pipe.
void RecordFile::SyncFolder() {
  const std::filesystem::path folder = std::filesystem::path(path_).parent_path();
  const int opened =
      open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (opened >= 0) {
    fsync(opened);
    close(opened);
  }
  has_name_ = true;
}

}  // namespace coppice
