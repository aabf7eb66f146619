// A .btlog as FileLogger2 of BehaviorTree.CPP 4 writes it and Groot2 reads it: 18 bytes of name, a
// byte of version, the size of the XML in 4 bytes, the XML, the start in microseconds since 1970 in
// 8 bytes; then for each change 6 bytes of microseconds since the start, 2 of the node's number and
// one of its status. All numbers are little endian.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "behaviortree_cpp/loggers/bt_file_logger_v2.h"
#include "behaviortree_cpp/xml_parsing.h"
#include "tests/bt_core/compat/logged_tree.h"
#include "tests/support/temporary_folder.h"

namespace {

using compat_test::LoggedTree;

std::uint64_t Number(const std::string& bytes, std::size_t at, std::size_t size) {
  std::uint64_t number = 0;
  for (std::size_t k = 0; k < size; ++k) {
    number |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes.at(at + k))) << (8 * k);
  }
  return number;
}

std::uint64_t MicrosecondsNow() {
  return static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(
                                        std::chrono::system_clock::now().time_since_epoch())
                                        .count());
}

struct BtlogFile : testing::Test {
  // What is in the file behind two ticks, should the program be killed then.
  std::string Written() {
    BT::FileLogger2 logger(logged.tree, folder.Path("run.btlog"));
    logged.tree.tickExactlyOnce();
    logged.tree.tickExactlyOnce();
    return coppice::ReadFile(folder.Path("run.btlog"));
  }
  coppice::TemporaryFolder folder;
  LoggedTree logged;
};

TEST_F(BtlogFile, BeginsWithNameAndVersion) {
  EXPECT_EQ(Written().substr(0, 19), "BTCPP4-FileLogger2\x01");
}

TEST_F(BtlogFile, HasTheTreeWithTheNumbersOfItsNodes) {
  const std::string bytes = Written();
  const std::string xml = bytes.substr(23, Number(bytes, 19, 4));
  EXPECT_EQ(xml, BT::WriteTreeToXML(logged.tree, true, true));
  EXPECT_NE(xml.find("_uid=\"3\""), std::string::npos) << xml;
}

TEST_F(BtlogFile, SaysWhenItBegan) {
  const std::uint64_t before = MicrosecondsNow();
  const std::string bytes = Written();
  const std::uint64_t start = Number(bytes, 23 + Number(bytes, 19, 4), 8);
  EXPECT_GE(start, before);
  EXPECT_LE(start, MicrosecondsNow());
}

TEST_F(BtlogFile, HoldsEveryChangeInNineBytes) {
  const std::string bytes = Written();
  std::vector<std::pair<std::uint64_t, std::uint64_t>> changes;
  std::uint64_t last = 0;
  std::size_t at = 23 + Number(bytes, 19, 4) + 8;
  for (; at + 9 <= bytes.size(); at += 9) {
    EXPECT_GE(Number(bytes, at, 6), last);
    last = Number(bytes, at, 6);
    changes.emplace_back(Number(bytes, at + 6, 2), Number(bytes, at + 8, 1));
  }
  EXPECT_EQ(at, bytes.size());
  const std::vector<std::pair<std::uint64_t, std::uint64_t>> expected = {
      {1, 1}, {2, 1}, {3, 1},          // all run
      {3, 2}, {3, 0}, {2, 3},          // the action succeeds, its decorator fails
      {4, 1}, {5, 2}, {5, 0}, {4, 2},  // the tree below succeeds
      {2, 0}, {4, 0}, {1, 2}, {1, 0},  // all is over
  };
  EXPECT_EQ(changes, expected);
}

TEST_F(BtlogFile, WantsItsExtension) {
  EXPECT_THROW(BT::FileLogger2(logged.tree, folder.Path("run.log")), BT::RuntimeError);
}

}  // namespace
