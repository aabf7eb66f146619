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

}  // namespace

enum class Answer { YES = 1, NO };
enum class Vote { YES = 5, NO = 2, ABSENT };

}  // namespace coppice

COPPICE_ENUM(coppice::Answer, YES, NO)
COPPICE_ENUM(coppice::Vote, YES, NO, ABSENT)

namespace coppice {
namespace {

template <class E>
class TakesEnum : public SyncAction {
 public:
  static constexpr const char* kDescription = "Takes an enum.";
  Input<E> value{this, "value", "which"};
  Status Run() override { return Status::kSuccess; }
};
using Answerer = TakesEnum<Answer>;
using Voter = TakesEnum<Vote>;

class Scripted : public SyncAction {
 public:
  static constexpr const char* kDescription = "Wants a script.";
  Input<ScriptCode> code{this, "code", "what to run"};
  Status Run() override { return Status::kSuccess; }
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

TEST(Registry, RefusesScriptsInPortsOfUserNodes) {
  Registry registry;
  EXPECT_THROW(registry.Register<Scripted>("Scripted"), std::invalid_argument);
}

TEST(Registry, EnumeratorsOfPortsAreConstantsOfScripts) {
  Registry registry;
  registry.Register<Answerer>("Answerer");
  EXPECT_EQ(registry.script_constants(), (ScriptConstants{{"YES", 1}, {"NO", 2}}));
}

TEST(Registry, ANameForTwoNumbersIsNoConstant) {
  Registry registry;
  registry.Register<Answerer>("Answerer");
  registry.Register<Voter>("Voter");
  registry.Register<Answerer>("Another");
  EXPECT_EQ(registry.script_constants(), (ScriptConstants{{"NO", 2}, {"ABSENT", 3}}));
}

TEST(Registry, ConstantsOfScriptsCanBeAdded) {
  Registry registry;
  registry.AddScriptConstant("LIMIT", 7);
  registry.AddScriptConstant("LIMIT", 7);
  EXPECT_EQ(registry.script_constants(), (ScriptConstants{{"LIMIT", 7}}));
  EXPECT_THROW(registry.AddScriptConstant("LIMIT", 8), std::invalid_argument);
}

TEST(Registry, ListsIdsInAlphabeticalOrder) {
  const std::vector<std::string> ids = TestRegistry()->Ids();
  EXPECT_TRUE(std::is_sorted(ids.begin(), ids.end()));
  EXPECT_EQ(Registry().Find("sequence"), nullptr) << "case matters";
}

TEST(Registry, ABuilderAddsATypeWithThePortsOfItsNodes) {
  Registry registry;
  registry.AddBuilder({"Vote", NodeCategory::kAction, "Votes.", {}}, {0, 0},
                      [] { return std::make_unique<Voter>(); });
  const Registry::Entry& entry = *registry.Find("Vote");
  EXPECT_EQ(entry.type, NodeType::kLeaf);
  ASSERT_EQ(entry.manifest.ports.size(), 1U);
  EXPECT_EQ(entry.manifest.ports[0].name, "value");
  EXPECT_EQ(entry.manifest.description, "Votes.");
}

TEST(Registry, AnAliasIsTheSameTypeUnderAnotherName) {
  Registry registry;
  registry.AddAlias("Again", "Repeat");
  EXPECT_EQ(registry.Find("Again")->type, NodeType::kRepeat);
  EXPECT_EQ(registry.Find("Again")->manifest.id, "Again");
}

TEST(Registry, AnAliasOfNothingIsRefused) {
  Registry registry;
  EXPECT_THROW(registry.AddAlias("Again", "Repaet"), std::invalid_argument);
}

TEST(Registry, AnAliasMustHaveAFreeName) {
  Registry registry;
  EXPECT_THROW(registry.AddAlias("Sequence", "Repeat"), std::invalid_argument);
}

}  // namespace
}  // namespace coppice
