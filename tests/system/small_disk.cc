#include "tests/system/small_disk.h"

#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "tests/support/folders.h"

namespace coppice::robot {

namespace fs = std::filesystem;

SmallDisk::SmallDisk() {
  path_ = fs::path(BinaryFolder()) / "tests/system" / ("disk_" + std::to_string(getpid()));
  fs::create_directories(path_);
  mounted_ = mount("coppice_test", path_.c_str(), "tmpfs", 0, "size=8m") == 0;
  if (mounted_) return;
  fs::remove(path_);
  path_ = "/dev/shm";
}

SmallDisk::~SmallDisk() {
  Free();
  if (!mounted_) return;
  umount(path_.c_str());
  fs::remove(path_);
}

void SmallDisk::Fill() const {
  struct statvfs disk {};
  ASSERT_EQ(statvfs(path_.c_str(), &disk), 0);
  const std::string block(disk.f_bsize, 'x');
  std::ofstream file(filler(), std::ios::binary);
  for (fsblkcnt_t i = 0; i < disk.f_bavail; ++i) file << block;
}

void SmallDisk::Free() const {
  std::error_code ignored;
  fs::remove(filler(), ignored);
}

fs::path SmallDisk::filler() const {
  return path_ / ("coppice_filler_" + std::to_string(getpid()));
}

}  // namespace coppice::robot
