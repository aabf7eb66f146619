#include "bt_core/engine/registry.h"

#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

class Adder : public SyncAction {
 public:
  static constexpr const char* kDescription = "Adds.";
  explicit Adder(int& sum, int amount) : sum_(sum), amount_(amount) {}
  Mailbox<int> answer{this, "answer"};
  Status Run() override {
    sum_ += amount_;
    return Status::kSuccess;
  }

 private:
  int& sum_;
  int amount_;
};

class Reserved : public SyncAction {
 public:
  static constexpr const char* kDescription = "Has a port with a name that XML needs.";
  Input<int> name{this, "name", "clash", 1};
  Status Run() override { return Status::kSuccess; }
};

TEST(Registry, KnowsTheBuiltInNodes) {
  const Registry registry;
  for (const BuiltIn& node : BuiltIns()) {
    const Registry::Entry* entry = registry.Find(node.manifest.id);
    ASSERT_NE(entry, nullptr) << node.manifest.id;
    EXPECT_EQ(entry->type, node.type);
  }
  EXPECT_EQ(registry.entries().size(), BuiltIns().size());
}

TEST(Registry, ReadsTheManifestOffTheLeaf) {
  const auto registry = TestRegistry();
  const Registry::Entry* entry = registry->Find("Drive");
  ASSERT_NE(entry, nullptr);
  EXPECT_EQ(entry->manifest.id, "Drive");
  EXPECT_EQ(entry->manifest.category, NodeCategory::kAction);
  EXPECT_EQ(entry->manifest.description, "Drives.");
  ASSERT_EQ(entry->manifest.ports.size(), 5U);
  EXPECT_EQ(entry->manifest.ports[1].name, "tries");
  EXPECT_EQ(entry->manifest.ports[1].default_text, "3");
}

TEST(Registry, HandsTheArgumentsToEveryInstance) {
  int sum = 0;
  Registry registry;
  registry.Register<Adder>("Adder", std::ref(sum), 5);
  const auto first = registry.Find("Adder")->build();
  const auto second = registry.Find("Adder")->build();
  first->Tick(true);
  second->Tick(true);
  EXPECT_EQ(sum, 10);
}

TEST(Registry, MailboxesAreNotInTheManifest) {
  int sum = 0;
  Registry registry;
  registry.Register<Adder>("Adder", std::ref(sum), 5);
  EXPECT_TRUE(registry.Find("Adder")->manifest.ports.empty());
  EXPECT_EQ(registry.Find("Adder")->declarations.size(), 1U);
}

TEST(Registry, RefusesAnIdThatIsTaken) {
  Registry registry;
  registry.Register<Tell>("Tell");
  EXPECT_THROW(registry.Register<Tell>("Tell"), std::invalid_argument);
  EXPECT_THROW(registry.Register<Tell>("Sequence"), std::invalid_argument);
}

TEST(Registry, RefusesAnIdThatIsNoName) {
  Registry registry;
  EXPECT_THROW(registry.Register<Tell>(""), std::invalid_argument);
  EXPECT_THROW(registry.Register<Tell>("1st"), std::invalid_argument);
  EXPECT_THROW(registry.Register<Tell>("_x"), std::invalid_argument);
}

TEST(Registry, RefusesPortsWithReservedNames) {
  Registry registry;
  EXPECT_THROW(registry.Register<Reserved>("Reserved"), std::invalid_argument);
  EXPECT_EQ(registry.Find("Reserved"), nullptr);
}

TEST(Registry, ListsIdsInAlphabeticalOrder) {
  const std::vector<std::string> ids = TestRegistry()->Ids();
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  EXPECT_EQ(Registry().Find("sequence"), nullptr) << "case matters";
}

}  // namespace
}  // namespace coppice
