// The folder holds for each editor SESSION.lock and a SESSION.NUMBER.unsaved for each file with
// unsaved work: a line that says what it is, the path, "new" or "saved", and the text.
#include "editor/files/unsaved_work.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <iterator>
#include <random>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

constexpr char kFirstLine[] = "coppice unsaved work 1";
constexpr char kLock[] = ".lock";
constexpr char kCopy[] = ".unsaved";

std::string NewSession() {
  std::random_device random;
  return std::to_string(getpid()) + "-" + std::to_string(random());
}

// Its number in the name of the session.
int ProcessOf(const std::string& session) { return std::atoi(session.c_str()); }

bool ReadHeader(std::istream& stream, UnsavedCopy& copy) {
  std::string first, kind;
  const bool whole = std::getline(stream, first) && std::getline(stream, copy.path) &&
                     std::getline(stream, kind) && first == kFirstLine && !copy.path.empty();
  copy.is_new = kind == "new";
  return whole;
}

std::optional<UnsavedCopy> ReadCopy(const fs::path& path) {
  UnsavedCopy copy;
  copy.file = path.string();
  std::istringstream stream(ReadFile(path.string()).value_or(""));
  if (!ReadHeader(stream, copy)) return std::nullopt;
  std::error_code error;
  copy.time = fs::last_write_time(path, error);
  return copy;
}

std::vector<fs::path> FilesIn(const std::string& folder, const char* extension) {
  std::vector<fs::path> files;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->path().extension() == extension) files.push_back(at->path());
  }
  return files;
}

// Of the name of one of our files.
std::string SessionOf(const fs::path& file) {
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.'));
}

const EditedFile* OpenFileOf(const OpenProject& project, const UnsavedCopy& copy) {
  for (const auto& [path, file] : project.files()) {
    if (UnsavedWork::AbsolutePath(path) == copy.path) return &file;
  }
  return nullptr;
}

}  // namespace

UnsavedWork::UnsavedWork(std::string folder) : folder_(std::move(folder)) {}

UnsavedWork::~UnsavedWork() {
  if (lock_ < 0) return;
  if (kept_.empty()) unlink(LockOf(session_).c_str());
  close(lock_);
}

std::string UnsavedWork::LockOf(const std::string& session) const {
  return folder_ + "/" + session + kLock;
}

std::string UnsavedWork::AbsolutePath(const std::string& path) {
  std::error_code error;
  return fs::absolute(path, error).lexically_normal().string();
}

// A folder that was deleted, with the lock in it, gets a new one. Until that can be had the old one
// is held: the folder may come back.
bool UnsavedWork::TakeLock() {
  std::error_code error;
  if (lock_ >= 0 && fs::exists(LockOf(session_), error)) return true;
  fs::create_directories(folder_, error);
  const std::string session = NewSession();
  const int lock = open(LockOf(session).c_str(), O_CREAT | O_EXCL | O_RDWR | O_CLOEXEC, 0600);
  if (lock < 0) {
    trouble_ = folder_ + ": " + std::strerror(errno);
    return false;
  }
  flock(lock, LOCK_EX | LOCK_NB);
  if (lock_ >= 0) close(lock_);
  lock_ = lock;
  session_ = session;
  kept_.clear();
  return true;
}

void UnsavedWork::Keep(const OpenProject& project) {
  if (folder_.empty()) return;
  trouble_.clear();
  for (const auto& [path, file] : project.files()) {
    const auto known = kept_.find(path);
    if (!file.has_unsaved_work()) {
      if (known == kept_.end()) continue;
      std::error_code error;
      fs::remove(known->second.file, error);
      kept_.erase(known);
      continue;
    }
    if (!TakeLock()) return;
    if (const Outcome written = Write(file); !written) trouble_ = written.problem();
  }
  // Saved under another name.
  for (auto at = kept_.begin(); at != kept_.end();) {
    std::error_code error;
    const bool is_open = project.files().count(at->first) > 0;
    if (!is_open) fs::remove(at->second.file, error);
    at = is_open ? std::next(at) : kept_.erase(at);
  }
}

Outcome UnsavedWork::Write(const EditedFile& file) {
  std::error_code error;
  Kept& kept = kept_[file.path];
  if (kept.file.empty()) {
    for (int number = 1; kept.file.empty() || fs::exists(kept.file, error); ++number) {
      kept.file = folder_ + "/" + session_ + "." + std::to_string(number) + kCopy;
    }
  } else if (kept.version == file.version && fs::exists(kept.file, error)) {
    return {};
  }
  Diagnostics problems;
  const std::string header = std::string(kFirstLine) + "\n" + AbsolutePath(file.path) + "\n" +
                             (file.is_new ? "new" : "saved") + "\n";
  if (WriteFile(kept.file, header + file.text, problems)) {
    kept.version = file.version;
    return {};
  }
  kept.version = 0;
  return Problem{ToString(problems.all().back())};
}

void UnsavedWork::DropOwn() {
  std::error_code error;
  for (const auto& [path, kept] : kept_) fs::remove(kept.file, error);
  kept_.clear();
}

// The process that holds the lock of a session; 0: it has ended.
int UnsavedWork::EditorOf(const std::string& session) const {
  const int lock = open(LockOf(session).c_str(), O_RDWR | O_CLOEXEC);
  if (lock < 0) return 0;
  // Shared, so that two who look at the same time do not take each other for its editor.
  const bool is_held = flock(lock, LOCK_SH | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  close(lock);
  return is_held ? std::max(ProcessOf(session), 1) : 0;
}

void UnsavedWork::Look(const OpenProject& project) {
  left_.clear();
  elsewhere_.clear();
  if (folder_.empty()) return;
  std::error_code error;
  std::map<std::string, int> editors;  // by session
  for (const fs::path& lock : FilesIn(folder_, kLock)) {
    editors[SessionOf(lock)] = EditorOf(SessionOf(lock));
  }
  std::set<std::string> needed;  // locks with copies
  for (const fs::path& path : FilesIn(folder_, kCopy)) {
    const std::string session = SessionOf(path);
    std::optional<UnsavedCopy> copy = session == session_ ? std::nullopt : ReadCopy(path);
    if (!copy) continue;
    copy->editor = editors[session];
    const EditedFile* file = copy->editor == 0 ? OpenFileOf(project, *copy) : nullptr;
    if (file && !file->is_new && !file->is_gone && TextOf(*copy) == file->saved) {
      fs::remove(path, error);
      continue;
    }
    needed.insert(session);
    (copy->editor == 0 ? left_ : elsewhere_).push_back(*std::move(copy));
  }
  for (const auto& [session, editor] : editors) {
    const bool is_over = editor == 0 && session != session_ && needed.count(session) == 0;
    if (is_over) fs::remove(LockOf(session), error);
  }
  std::sort(left_.begin(), left_.end(),
            [](const UnsavedCopy& a, const UnsavedCopy& b) { return a.time > b.time; });
}

std::optional<std::string> UnsavedWork::TextOf(const UnsavedCopy& copy) {
  std::istringstream stream(ReadFile(copy.file).value_or(""));
  UnsavedCopy there;
  if (!ReadHeader(stream, there) || there.path != copy.path) return std::nullopt;
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

void UnsavedWork::Forget(const UnsavedCopy& copy) {
  const std::string file = copy.file;  // the copy may be one of ours
  std::error_code error;
  fs::remove(file, error);
  left_.erase(std::remove_if(left_.begin(), left_.end(),
                             [&](const UnsavedCopy& one) { return one.file == file; }),
              left_.end());
}

}  // namespace coppice::editor
