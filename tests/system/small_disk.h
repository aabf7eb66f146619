// A file system of a few megabytes to be filled: its own if it may be mounted, else the one in
// memory that every Linux has (/dev/shm).
#ifndef COPPICE_TESTS_SYSTEM_SMALL_DISK_H_
#define COPPICE_TESTS_SYSTEM_SMALL_DISK_H_

#include <filesystem>

namespace coppice::robot {

class SmallDisk {
 public:
  SmallDisk();
  ~SmallDisk();
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

  const std::filesystem::path& path() const { return path_; }
  void Fill() const;
  void Free() const;

 private:
  std::filesystem::path filler() const;

  std::filesystem::path path_;
  bool mounted_ = false;
};

}  // namespace coppice::robot

#endif  // COPPICE_TESTS_SYSTEM_SMALL_DISK_H_
