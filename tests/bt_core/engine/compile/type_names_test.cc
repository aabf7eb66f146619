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

}  // namespace
}  // namespace coppice
