#include "bt_core/data/enum.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "bt_core/data/value.h"

namespace shop {
enum class Color : std::uint8_t { RED = 1, GREEN, BLUE = 200 };
enum Gear { kSlow = -1, kFast = 1 };
enum class Lonely { ONE };
}  // namespace shop

COPPICE_ENUM(shop::Color, RED, GREEN, BLUE)
COPPICE_ENUM(shop::Lonely, ONE)

template <>
struct coppice::ValueTraits<shop::Gear> : coppice::EnumTraits<shop::Gear> {
  static constexpr const char* kName = "Gear";
  static constexpr coppice::Enumerator kEnumerators[] = {{"slow", shop::kSlow},
                                                         {"fast", shop::kFast}};
};

namespace coppice {
namespace {

using shop::Color;

TEST(Enum, IsReadByNameOrNumber) {
  Color color{};
  EXPECT_TRUE(ValueTraits<Color>::Parse("GREEN", color));
  EXPECT_EQ(color, Color::GREEN);
  EXPECT_TRUE(ValueTraits<Color>::Parse(" 200 ", color));
  EXPECT_EQ(color, Color::BLUE);
  for (const char* bad : {"", "green", "GREE", "3", "-1", "1.0"}) {
    EXPECT_FALSE(ValueTraits<Color>::Parse(bad, color)) << bad;
  }
  EXPECT_EQ(color, Color::BLUE) << "unchanged";
}

TEST(Enum, IsPrintedByName) {
  EXPECT_EQ(ValueTraits<Color>::Print(Color::RED), "RED");
  EXPECT_EQ(ValueTraits<Color>::Print(static_cast<Color>(7)), "7") << "has no name";
}

TEST(Enum, MayHaveNamesOfItsOwn) {
  shop::Gear gear{};
  EXPECT_TRUE(ValueTraits<shop::Gear>::Parse("slow", gear));
  EXPECT_EQ(gear, shop::kSlow);
  EXPECT_STREQ(TypeOf<shop::Gear>().name, "Gear");
}

TEST(Enum, ListsItsEnumerators) {
  std::string names;
  for (const Enumerator& enumerator : EnumeratorsOf<Color>()) {
    names += std::string(enumerator.name) + "=" + std::to_string(enumerator.value) + " ";
  }
  EXPECT_EQ(names, "RED=1 GREEN=2 BLUE=200 ");
  EXPECT_EQ(TypeOf<Color>().enumerators, &EnumeratorsOf<Color>());
  EXPECT_EQ(TypeOf<Color>().kind, TypeKind::kEnum);
  EXPECT_EQ(EnumeratorsOf<shop::Lonely>().count, 1U);
  EXPECT_EQ(TypeOf<int>().enumerators, nullptr);
}

TEST(Enum, AValueTellsItsNumber) {
  EXPECT_EQ(Value(Color::BLUE).EnumeratorValue(), 200);
  EXPECT_EQ(Value(shop::kSlow).EnumeratorValue(), -1);
}

TEST(Enum, ChoicesAreForPeople) {
  EXPECT_EQ(Choices(EnumeratorsOf<Color>()), "RED, GREEN or BLUE");
  EXPECT_EQ(Choices(EnumeratorsOf<shop::Lonely>()), "ONE");
}

}  // namespace
}  // namespace coppice
