#include "bt_nodes/register_nodes.h"

#include <gtest/gtest.h>

#include "tests/bt_nodes/fakes.h"

namespace coppice {
namespace {

TEST(RegisterNodes, DescribesEveryPortOfEveryLeaf) {
  FakeRobot robot;
  Registry registry;
  RegisterNodes(registry, robot.capabilities());
  for (const auto& [id, entry] : registry.entries()) {
    EXPECT_FALSE(entry.manifest.description.empty()) << id;
    for (const PortDeclaration& port : entry.manifest.ports) {
      EXPECT_FALSE(port.description.empty()) << id << "." << port.name;
    }
  }
}

TEST(RegisterNodes, BuildsEveryLeaf) {
  FakeRobot robot;
  Registry registry;
  RegisterNodes(registry, robot.capabilities());
  int leaves = 0;
  for (const auto& [id, entry] : registry.entries()) {
    if (entry.type != NodeType::kLeaf) continue;
    EXPECT_NE(entry.build(), nullptr) << id;
    ++leaves;
  }
  EXPECT_EQ(leaves, 37);
}

}  // namespace
}  // namespace coppice
