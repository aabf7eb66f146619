#include "robot_app/storage/topics/file_store.h"

#include <algorithm>
#include <filesystem>
#include <utility>
#include <vector>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"
#include "robot_app/storage/server/calendar.h"

namespace coppice::robot::storage {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLongest = std::size_t{1} << 30;  // bytes, as a message of ROS
constexpr std::size_t kMostFiles = 100'000;             // small ones take places on the disk, too
constexpr const char* kEnding = ".bin";

// "2026-11-25/081500.123456-7.bin"
std::string NameOf(std::int64_t now, std::uint64_t number) {
  std::string clock = MomentText(now).substr(11, 15);
  clock.erase(std::remove(clock.begin(), clock.end(), ':'), clock.end());
  return DayText(now) + "/" + clock + "-" + std::to_string(number) + kEnding;
}

}  // namespace

FileStore::FileStore(std::string folder, std::uint64_t largest)
    : folder_(std::move(folder)), largest_(largest) {
  std::error_code error;
  for (fs::recursive_directory_iterator file(folder_, error), end; !error && file != end;
       file.increment(error)) {
    if (file->path().extension() != kEnding) continue;
    kept_.push_back({fs::relative(file->path(), folder_), file->file_size(error)});
    bytes_ += kept_.back().bytes;
  }
  std::sort(kept_.begin(), kept_.end(),
            [](const Kept& a, const Kept& b) { return a.name < b.name; });
}

std::string FileStore::Keep(std::string_view bytes, std::int64_t now) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (bytes.size() > largest_) return "";
  const std::string name = NameOf(now, ++count_);
  std::error_code error;
  fs::create_directories(fs::path(folder_) / DayText(now), error);
  Diagnostics diagnostics;
  if (!WriteFile(folder_ + "/" + name, bytes, diagnostics)) return "";
  kept_.push_back({name, bytes.size()});
  bytes_ += bytes.size();
  MakeRoom();
  return name;
}

void FileStore::MakeRoom() {
  while ((bytes_ > largest_ || kept_.size() > kMostFiles) && !kept_.empty()) {
    std::error_code error;
    const fs::path file = fs::path(folder_) / kept_.front().name;
    fs::remove(file, error);
    fs::remove(file.parent_path(), error);  // if it was the last one of its day
    bytes_ -= kept_.front().bytes;
    kept_.pop_front();
  }
}

std::uint64_t FileStore::bytes() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return bytes_;
}

std::optional<std::string> ReadKeptFile(const std::string& folder, const std::string& name) {
  if (folder.empty() || name.empty() || name[0] == '/' || name.find("..") != std::string::npos) {
    return std::nullopt;
  }
  return ReadFile(folder + "/" + name, kLongest);
}

}  // namespace coppice::robot::storage
