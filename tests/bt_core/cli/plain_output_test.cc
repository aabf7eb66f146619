#include "bt_core/cli/plain_output.h"

#include <gtest/gtest.h>

namespace coppice {
namespace {

template <class Print>
std::string Printed(Print print) {
  testing::internal::CaptureStdout();
  {
    const PlainOutput output;
    print();
  }
  return testing::internal::GetCapturedStdout();
}

TEST(PlainOutput, WritesOutWhatATerminalObeys) {
  EXPECT_EQ(Printed([] { std::cout << "a\x1B[31m" << '\b' << "\n"; }), "a\\x1B[31m\\x08\n");
}

TEST(PlainOutput, KnowsACharacterWhoseBytesComeOneByOne) {
  EXPECT_EQ(Printed([] { std::cout << '\xC2' << '\x9B' << "31m"; }), "\\u009B31m");
  EXPECT_EQ(Printed([] { std::cout << '\xC2' << '\xB0' << "C"; }),
            "\xC2\xB0"
            "C");
}

TEST(PlainOutput, KeepsNothingBack) {
  EXPECT_EQ(Printed([] { std::cout << "a\xC2"; }), "a\xC2");
  EXPECT_EQ(Printed([] { std::cout << "a\xC2" << std::flush << "b"; }),
            "a\xC2"
            "b");
}

}  // namespace
}  // namespace coppice
