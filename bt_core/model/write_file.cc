#include "bt_core/model/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <random>

namespace coppice {
namespace {

namespace fs = std::filesystem;

constexpr int kTries = 100;                             // to find a name that nobody has
constexpr std::string_view kMark = ".coppice-saving-";  // nobody else calls a file so
constexpr std::size_t kLetters = 8;                     // behind that
constexpr auto kAbandonedAfter = std::chrono::hours(1);
constexpr auto kLookEvery = std::chrono::minutes(10);
constexpr std::size_t kMostFolders = 1000;  // that are remembered

bool IsDraftName(const std::string& name) {
  const std::size_t mark = name.rfind(kMark);
  return mark != std::string::npos && name.size() == mark + kMark.size() + kLetters;
}

bool IsAbandoned(const fs::directory_entry& entry) {
  if (!IsDraftName(entry.path().filename().string())) return false;
  std::error_code error;
  const fs::file_time_type written = entry.last_write_time(error);
  return !error && entry.is_regular_file(error) &&
         fs::file_time_type::clock::now() - written > kAbandonedAfter;
}

// Looking through a folder of a hundred thousand files takes longer than to save one.
bool IsTimeToLookAt(const fs::path& folder) {
  static std::mutex mutex;
  static std::map<fs::path, std::chrono::steady_clock::time_point> looked;
  const auto now = std::chrono::steady_clock::now();
  const std::lock_guard<std::mutex> lock(mutex);
  if (looked.size() > kMostFolders) looked.clear();
  const auto [last, is_new] = looked.try_emplace(folder, now);
  if (!is_new && now - last->second < kLookEvery) return false;
  last->second = now;
  return true;
}

// What a program that was killed while it saved has left there.
void RemoveAbandoned(const fs::path& folder) {
  if (!IsTimeToLookAt(folder)) return;
  std::error_code error;
  fs::directory_iterator entry(folder.empty() ? "." : folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code gone;
    if (IsAbandoned(*entry)) fs::remove(entry->path(), gone);
  }
}

// A file beside the target. It is gone with this object, unless it has become the target.
class TemporaryFile {
 public:
  /// `mode`: before the process's mask.
  TemporaryFile(const std::string& target, mode_t mode) {
    for (int i = 0; i < kTries && (i == 0 || errno == EEXIST) && !is_open(); ++i) {
      path_ = DraftName(target);
      descriptor_ = open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    }
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  ~TemporaryFile() {
    if (descriptor_ < 0) return;
    close(descriptor_);
    if (!renamed_) unlink(path_.c_str());
  }

  bool is_open() const { return descriptor_ >= 0; }

  bool Write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t written = write(descriptor_, text.data(), text.size());
      if (written < 0 && errno == EINTR) continue;
      if (written <= 0) return false;
      text.remove_prefix(static_cast<std::size_t>(written));
    }
    return true;
  }

  bool SetMode(mode_t mode) { return fchmod(descriptor_, mode) == 0; }

  bool Become(const std::string& target) {
    renamed_ = fsync(descriptor_) == 0 && rename(path_.c_str(), target.c_str()) == 0;
    return renamed_;
  }

 private:
  std::string path_;
  int descriptor_ = -1;
  bool renamed_ = false;
};

// What the file must have in the end, if the mask of the process is not to say it.
std::optional<mode_t> ModeOf(const std::string& path, FileReaders readers) {
  if (readers == FileReaders::kOwnerOnly) return 0600;
  struct stat info = {};
  if (stat(path.c_str(), &info) != 0) return std::nullopt;
  return info.st_mode & 07777U;
}

// The rename itself is only safe once the folder is on the disk. Some file systems cannot; then
// there is nothing more to do.
void SyncFolder(const fs::path& folder) {
  const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

bool CannotWrite(const std::string& path, std::string why, Diagnostics& diagnostics) {
  diagnostics.Error({path, 0, 0}, "cannot write this file", std::move(why),
                    {ProblemKind::kCannotWrite, path});
  return false;
}

}  // namespace

std::string DraftName(const std::string& path) {
  constexpr std::string_view kAlphabet = "abcdefghijklmnopqrstuvwxyz0123456789";
  static thread_local std::random_device random;
  std::string name = path + std::string(kMark);
  for (std::size_t i = 0; i < kLetters; ++i) name += kAlphabet[random() % kAlphabet.size()];
  return name;
}

bool WriteFile(const std::string& path, std::string_view text, Diagnostics& diagnostics,
               FileReaders readers) {
  std::error_code error;
  const fs::path real = fs::is_symlink(path, error) ? fs::canonical(path, error) : fs::path(path);
  const std::string target = error ? path : real.string();
  if (fs::exists(target, error) && !fs::is_regular_file(target, error)) {
    return CannotWrite(path,
                       "it is a folder, a device or a pipe, and nothing else is replaced by a file",
                       diagnostics);
  }
  const std::optional<mode_t> mode = ModeOf(target, readers);
  TemporaryFile file(target, mode ? 0600 : 0666);  // nobody reads it before it is what it is to be
  const bool is_written = file.is_open() && file.Write(text) && (!mode || file.SetMode(*mode));
  if (!is_written || !file.Become(target)) {
    return CannotWrite(path, std::strerror(errno), diagnostics);
  }
  const fs::path folder = fs::path(target).parent_path();
  SyncFolder(folder);
  RemoveAbandoned(folder);
  return true;
}

}  // namespace coppice
