#include "bt_core/frames/crc32c.h"

#include <gtest/gtest.h>

#include <string>

namespace coppice {
namespace {

TEST(Crc32c, HasTheValuesOfTheStandard) {  // RFC 3720, section B.4
  EXPECT_EQ(Crc32c("123456789", 9), 0xe3069283u);
  EXPECT_EQ(Crc32c(std::string(32, '\0').data(), 32), 0x8a9136aau);
  EXPECT_EQ(Crc32c(std::string(32, '\xff').data(), 32), 0x62a8ab43u);
  EXPECT_EQ(Crc32c(nullptr, 0), 0u);
}

TEST(Crc32c, GoesOnBehindOtherBytes) {
  EXPECT_EQ(Crc32c("456789", 6, Crc32c("123", 3)), Crc32c("123456789", 9));
}

}  // namespace
}  // namespace coppice
