#include "bt_core/live/client/part_packing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using namespace std::string_literals;

TEST(PartPacking, PutsTheLengthBeforeEachPart) {
  EXPECT_EQ(PackParts({"ab", ""}), "\2\0\0\0ab\0\0\0\0"s);
  EXPECT_EQ(PackParts({std::string(258, 'x')}).substr(0, 5), "\2\1\0\0x"s);
}

TEST(PartPacking, UnpacksWhatWasPacked) {
  EXPECT_THAT(UnpackParts(PackParts({"header", "", "body\0more"s})),
              ElementsAre("header", "", "body\0more"s));
}

TEST(PartPacking, RefusesWhatDoesNotAddUp) {
  EXPECT_THAT(UnpackParts(""), IsEmpty());
  EXPECT_THAT(UnpackParts("\1\0\0"s), IsEmpty());
  EXPECT_THAT(UnpackParts("\3\0\0\0ab"s), IsEmpty());
  EXPECT_THAT(UnpackParts("\1\0\0\0ab"s), IsEmpty());
  EXPECT_THAT(UnpackParts("\xff\xff\xff\xff"s), IsEmpty());
}

TEST(PartPacking, RefusesTooManyParts) {
  EXPECT_EQ(UnpackParts(std::string(4 * kMaxPackedParts, '\0')).size(), kMaxPackedParts);
  EXPECT_THAT(UnpackParts(std::string(4 * (kMaxPackedParts + 1), '\0')), IsEmpty());
}

}  // namespace
}  // namespace coppice
