#include "bt_core/nodes/node_type.h"

#include <gtest/gtest.h>

#include <set>

namespace coppice {
namespace {

TEST(BuiltIns, AreInTheOrderOfTheirTypes) {
  const auto& all = BuiltIns();
  ASSERT_EQ(all.size(), static_cast<std::size_t>(NodeType::kLeaf));
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(all[i].type), i) << all[i].manifest.id;
  }
}

TEST(BuiltIns, HaveDistinctIdsAndDescriptions) {
  std::set<std::string> ids;
  for (const BuiltIn& node : BuiltIns()) {
    EXPECT_TRUE(ids.insert(node.manifest.id).second) << node.manifest.id;
    EXPECT_FALSE(node.manifest.description.empty()) << node.manifest.id;
    for (const PortDeclaration& port : node.manifest.ports) {
      EXPECT_FALSE(port.description.empty()) << node.manifest.id << "." << port.name;
    }
  }
}

TEST(BuiltIns, HaveChildrenAccordingToTheirCategory) {
  for (const BuiltIn& node : BuiltIns()) {
    const bool control = node.manifest.category == NodeCategory::kControl;
    const bool decorator = node.manifest.category == NodeCategory::kDecorator;
    EXPECT_EQ(node.children.min, control || decorator ? 1U : 0U) << node.manifest.id;
    EXPECT_EQ(node.children.max, control ? UINT32_MAX : decorator ? 1U : 0U) << node.manifest.id;
  }
}

TEST(BuiltIns, DefaultsAreValuesOfTheirPorts) {
  for (const BuiltIn& node : BuiltIns()) {
    for (const PortDeclaration& port : node.manifest.ports) {
      EXPECT_EQ(port.required, !port.default_text.has_value());
      if (!port.default_text) continue;
      Value value;
      EXPECT_TRUE(value.Parse(*port.type, *port.default_text)) << port.name;
    }
  }
}

}  // namespace
}  // namespace coppice
