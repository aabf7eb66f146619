#include "tests/bt_core/cli/fixture.h"

namespace coppice {
namespace {

class RandomTestVerb : public CliTest {
 protected:
  std::string Tree() {
    return WriteTree("<Fallback><IsDay/><ScriptCondition code=\"battery &lt; 0.3\"/></Fallback>");
  }
};

TEST_F(RandomTestVerb, TheSameSeedPrintsTheSame) {
  const std::string file = Tree();
  const Arguments arguments = {"--random", "100", "--set", "battery=0.5", "--seed", "7", file};
  EXPECT_EQ(Run(RunTest, arguments), 0) << err_;
  const std::string first = out_;
  EXPECT_NE(first.find("100 runs, seeds 7 to 106, 100 ticks"), std::string::npos) << first;
  EXPECT_EQ(Run(RunTest, arguments), 0);
  EXPECT_EQ(out_, first);
}

TEST_F(RandomTestVerb, WhatIsFoundIsAFailure) {
  EXPECT_EQ(Run(RunTest, {"--random", "20", Tree()}), 1);
  EXPECT_NE(out_.find("found:\n"), std::string::npos) << out_;
  EXPECT_EQ(Run(RunTest, {"--random", "20", "--json", Tree()}), 1);
  EXPECT_EQ(out_.front(), '{');
}

TEST_F(RandomTestVerb, ScriptsOfAScenarioFileArePlayed) {
  Tree();
  const std::string file = Write("a.test.json", R"({"tree": "tree.xml",
   "leaves": {"<IsDay>": {"chances": {"SUCCESS": 1, "after_ms": [100, 100]}}},
   "scenarios": [{"name": "a", "steps": [{}]}]})");
  EXPECT_EQ(Run(RunTest, {"--random", "10", file}), 0) << out_ << err_;
  EXPECT_NE(out_.find(" 20 ticks: 10 SUCCESS"), std::string::npos) << out_;
}

constexpr char kRandomSuite[] = R"({"tree": "tree.xml",
   "leaves": {"<IsDay>": "SUCCESS"},
   "random": {"set": {"battery": [0.1, 0.5]}, "leaves": {"<IsDay>": "FAILURE"}, "lasts_ms": 1000},
   "scenarios": [{"name": "a", "steps": [{}]}]})";

TEST_F(RandomTestVerb, ATreeIsPlayedAsTheFileBesideItSays) {
  const std::string tree = Tree();
  EXPECT_EQ(Run(RunTest, {"--random", "50", tree}), 1) << "nobody writes the battery";
  const std::string file = Write("tree.test.json", kRandomSuite);
  EXPECT_EQ(Run(RunTest, {"--random", "50", tree}), 0) << out_ << err_;
  EXPECT_NE(out_.find("seeds 1 to 50, 500 ticks"), std::string::npos) << out_;
  const std::string of_tree = out_.substr(out_.find(": "));
  EXPECT_EQ(Run(RunTest, {"--random", "50", file}), 0) << out_ << err_;
  EXPECT_EQ(out_.substr(out_.find(": ")), of_tree);
  EXPECT_EQ(Run(RunTest, {"--random", "50", "--set", "battery=0.1", file}), 0);
  EXPECT_NE(out_.find("50 SUCCESS"), std::string::npos) << out_;
}

TEST_F(RandomTestVerb, ATreeThatIsNotTheMainOneIsPlayedAsItsOwnFileSays) {
  const std::string tree = Write("tree.xml", R"(<root BTCPP_format="4" main_tree_to_execute="A">
   <BehaviorTree ID="A"><AlwaysSuccess/></BehaviorTree>
   <BehaviorTree ID="B"><ScriptCondition code="battery &lt; 0.3"/></BehaviorTree></root>)");
  Write("tree.test.json", R"({"tree": "tree.xml", "random": {"lasts_ms": 1000},
   "scenarios": [{"name": "a", "steps": [{}]}]})");
  EXPECT_EQ(Run(RunTest, {"--random", "20", "--tree", "B", tree}), 1) << out_ << err_;
  EXPECT_NE(out_.find("20 runs, seeds 1 to 20, 20 ticks"), std::string::npos) << out_;
  Write("tree.B.test.json", R"({"tree": "tree.xml", "tree_id": "B",
   "random": {"set": {"battery": 0.1}}, "scenarios": [{"name": "a", "steps": [{}]}]})");
  EXPECT_EQ(Run(RunTest, {"--random", "20", "--tree", "B", tree}), 0) << out_ << err_;
  EXPECT_EQ(Run(RunTest, {"--random", "20", tree}), 0) << out_ << err_;
  EXPECT_NE(out_.find("200 ticks"), std::string::npos) << out_;
}

TEST_F(RandomTestVerb, AFileBesideTheTreeThatIsAboutAnotherDoesNotCount) {
  const std::string tree = Tree();
  Write("other.xml", "<root BTCPP_format=\"4\"/>");
  std::string suite = kRandomSuite;
  suite.replace(suite.find("tree.xml"), 8, "other.xml");
  Write("tree.test.json", suite);
  EXPECT_EQ(Run(RunTest, {"--random", "20", tree}), 1) << out_ << err_;
}

TEST_F(RandomTestVerb, AKeyThatTheTreeHasNotIsAnErrorWithItsPlace) {
  const std::string tree = Tree();
  std::string suite = kRandomSuite;
  suite.replace(suite.find("battery"), 7, "batery");
  Write("tree.test.json", suite);
  EXPECT_EQ(Run(RunTest, {"--random", "20", tree}), 2);
  EXPECT_NE(err_.find("tree.test.json:3:"), std::string::npos) << err_;
  EXPECT_NE(err_.find("the tree has no key \"batery\""), std::string::npos) << err_;
}

TEST_F(RandomTestVerb, WrongOptionsAreSaid) {
  EXPECT_EQ(Run(RunTest, {"--random", "0", Tree()}), 2);
  EXPECT_NE(err_.find("--random: expected a whole number from 1 to 1000000000, not \"0\""),
            std::string::npos);
  EXPECT_EQ(Run(RunTest, {"--random", "1", "--set", "batery=1", Tree()}), 2);
  EXPECT_NE(err_.find("the tree has no key \"batery\""), std::string::npos) << err_;
  EXPECT_EQ(Run(RunTest, {"--random", "1", "--set", "battery", Tree()}), 2);
  EXPECT_NE(err_.find("expected KEY=VALUE"), std::string::npos) << err_;
  EXPECT_EQ(Run(RunTest, {"--random", "1", "--tree", "Other", Tree()}), 2);
  EXPECT_EQ(Run(RunTest, {"--random", "1", (folder_ / "none.xml").string()}), 2);
}

}  // namespace
}  // namespace coppice
