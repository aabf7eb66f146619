#include "bt_nodes/register_nodes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "bt_core/engine/compile/models.h"
#include "tests/bt_nodes/fakes.h"
#include "tests/support/folders.h"

namespace coppice::leaves {
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
  EXPECT_EQ(leaves, 66);
}

// COPPICE_UPDATE_REFERENCE=1 bt_nodes_test --gtest_filter='*TheShippedModels*' writes the file.
TEST(RegisterNodes, TheShippedModelsSayWhatTheLeavesAre) {
  FakeRobot robot;
  Registry registry;
  RegisterNodes(registry, robot.capabilities());
  for (const std::string& id : registry.Ids()) {
    if (registry.HasBuiltIn(id)) registry.Remove(id);
  }
  const std::string path = SourceFolder() + "/trees/models.xml";
  if (std::getenv("COPPICE_UPDATE_REFERENCE")) std::ofstream(path) << WriteModels(registry);
  std::ifstream file(path);
  const std::string shipped{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(shipped, WriteModels(registry)) << "trees/models.xml is older than the leaves";
}

}  // namespace
}  // namespace coppice::leaves
