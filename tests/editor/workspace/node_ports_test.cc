#include "editor/workspace/node_ports.h"

#include <gmock/gmock.h>

#include "tests/editor/driver.h"

namespace coppice::editor {
namespace {

using testing::ElementsAre;

class NodePorts : public testing::Test {
 protected:
  NodePorts() { driver_.editor.Open(file_.path()); }
  std::vector<std::string> Names(const std::string& path) {
    const Scene& scene = *driver_.view().scene();
    return PortNamesOf(driver_.editor.state(), scene, scene.FindPath(path), 0);
  }
  TemporaryFile file_{"small.xml", kSmallFile};
  Driver driver_;
};

TEST_F(NodePorts, AreThoseOfTheTypeWhetherGivenOrNot) {
  EXPECT_THAT(Names("1.1.2"), ElementsAre("level", "lamp", "slowly"));
}

TEST_F(NodePorts, OfASubTreeAreWhatItsTreeShares) {
  EXPECT_THAT(Names("1.2"), ElementsAre("goal"));
}

TEST_F(NodePorts, OfAnUnknownTypeAreWhatItIsGiven) {
  EXPECT_THAT(Names("1.2.1.1"), ElementsAre("to"));
}

TEST_F(NodePorts, KeysAreThoseOfTheSameBlackboard) {
  const Scene& scene = *driver_.view().scene();
  EXPECT_THAT(KeysSeenBy(scene, scene.nodes[scene.FindPath("1.2.1.1")]), ElementsAre("goal"));
  EXPECT_THAT(KeysSeenBy(scene, scene.nodes[0]), ElementsAre("goal", "level", "light"));
}

}  // namespace
}  // namespace coppice::editor
