#include "bt_core/engine/compile/type_names.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {

struct Colour {
  int hue = 0;
};

namespace {

class Paint : public SyncAction {
 public:
  static constexpr const char* kDescription = "Paints.";
  Input<Colour> colour{this, "colour", "which"};
  Status Run() override { return Status::kSuccess; }
};

}  // namespace

template <>
struct ValueTraits<Colour> {
  static constexpr const char* kName = "Colour";
  static bool Parse(std::string_view, Colour&) { return true; }
  static std::string Print(const Colour&) { return {}; }
};

namespace {

TEST(TypeNames, OurNamesAndThoseOfThePeerAreKnown) {
  const Registry registry;
  EXPECT_EQ(FindType(registry, "string"), &TypeOf<std::string>());
  EXPECT_EQ(FindType(registry, "std::string"), &TypeOf<std::string>());
  EXPECT_EQ(FindType(registry, "unsigned int"), &TypeOf<unsigned>());
  EXPECT_EQ(FindType(registry, "double"), &TypeOf<double>());
}

TEST(TypeNames, TypesOfRegisteredPortsAreKnown) {
  Registry registry;
  EXPECT_EQ(FindType(registry, "Colour"), nullptr);
  registry.Register<Paint>("Paint");
  EXPECT_EQ(FindType(registry, "Colour"), &TypeOf<Colour>());
}

TEST(TypeNames, AnyTypeIsNoType) {
  const Registry registry;
  EXPECT_EQ(FindType(registry, ""), nullptr);
  EXPECT_EQ(FindType(registry, "BT::AnyTypeAllowed"), nullptr);
  EXPECT_STREQ(TypeName({"any", PortDirection::kInput, nullptr, "", true, std::nullopt}),
               "BT::AnyTypeAllowed");
}

TEST(TypeNames, AllFundamentalTypesAreKnown) {
  const Registry registry;
  for (const char* name : {"char", "unsigned char", "int8_t", "std::uint8_t", "short", "int16_t",
                           "unsigned short", "uint16_t", "int32_t", "long", "unsigned long",
                           "long long", "unsigned long long", "size_t", "std::size_t"}) {
    ASSERT_NE(FindType(registry, name), nullptr) << name;
    EXPECT_LT(FindType(registry, name)->kind, TypeKind::kString) << name;
  }
  EXPECT_EQ(FindType(registry, "uint16_t"), FindType(registry, "unsigned short"));
  EXPECT_NE(FindType(registry, "unsigned short"), &TypeOf<unsigned>());
}

TEST(TypeNames, SmallIntegersKeepTheirBounds) {
  const Type& type = *FindType(Registry(), "unsigned char");
  Value value;
  EXPECT_TRUE(value.Parse(type, "255"));
  EXPECT_EQ(value.Print(), "255");
  EXPECT_FALSE(value.Parse(type, "256"));
  EXPECT_FALSE(value.Parse(type, "-1"));
}

TEST(TypeNames, WhatACompilerCallsATypeIsReadAsAPersonWritesIt) {
  EXPECT_EQ(PlainTypeName("std::vector<std::__cxx11::basic_string<char, std::char_traits<char>, "
                          "std::allocator<char> >, std::allocator<std::__cxx11::basic_string<char, "
                          "std::char_traits<char>, std::allocator<char> > > >"),
            "std::vector<std::string>");
  EXPECT_EQ(PlainTypeName("std::shared_ptr<std::vector<robot::Pose, "
                          "std::allocator<robot::Pose> > >"),
            "std::shared_ptr<std::vector<robot::Pose>>");
  EXPECT_EQ(PlainTypeName("std::vector<int, std::allocator<int"), "std::vector<int");
}

}  // namespace
}  // namespace coppice
