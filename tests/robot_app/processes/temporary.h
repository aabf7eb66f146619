// Files and folders that are a test program's own, also when tests run at the same time. They are
// gone when the program ends.
#ifndef COPPICE_TESTS_ROBOT_APP_PROCESSES_TEMPORARY_H_
#define COPPICE_TESTS_ROBOT_APP_PROCESSES_TEMPORARY_H_

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

namespace coppice::robot::processes {

inline std::string Temporary(const std::string& name) {
  struct Folder {
    const std::string path = testing::TempDir() + "coppice_test_" + std::to_string(getpid()) + "/";
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() {
      std::error_code ignored;
      std::filesystem::remove_all(path, ignored);
    }
  };
  static const Folder folder;
  return folder.path + name;
}

}  // namespace coppice::robot::processes

#endif  // COPPICE_TESTS_ROBOT_APP_PROCESSES_TEMPORARY_H_
