// Runs a verb on files in a folder of its own and keeps what it prints.
#ifndef COPPICE_TESTS_BT_CORE_CLI_FIXTURE_H_
#define COPPICE_TESTS_BT_CORE_CLI_FIXTURE_H_

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "bt_core/cli/verbs.h"

namespace coppice {

class CliTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(testing::TempDir()) /
              (std::string("coppice_cli_") + test->test_suite_name() + test->name());
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string Write(const std::string& name, const std::string& text) {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  std::string WriteTree(const std::string& body) {
    return Write("tree.xml", "<root BTCPP_format=\"4\">\n<BehaviorTree ID=\"Main\">\n" + body +
                                 "\n</BehaviorTree></root>");
  }

  int Run(int (*verb)(const Arguments&), const Arguments& arguments) {
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int result = verb(arguments);
    out_ = testing::internal::GetCapturedStdout();
    err_ = testing::internal::GetCapturedStderr();
    return result;
  }

  std::filesystem::path folder_;
  std::string out_;
  std::string err_;
};

}  // namespace coppice

#endif  // COPPICE_TESTS_BT_CORE_CLI_FIXTURE_H_
