#include "bt_core/analysis/play/scenario_models.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "bt_core/testing/scenario.h"
#include "bt_core/testing/scenario_writer.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr char kTree[] =
    "<root BTCPP_format='4'><BehaviorTree ID='Main'><Guarded speed='1'><Sequence>"
    "<Inverter><Drive to='a'/></Inverter></Sequence></Guarded></BehaviorTree></root>";
constexpr char kModel[] =
    "<Decorator ID='Guarded'><input_port name='speed' type='double'/></Decorator>";

std::string ModelsWith(const std::string& model) {
  return "<root BTCPP_format='4'><TreeNodesModel>" + model + "</TreeNodesModel></root>";
}

class ScenarioModelsTest : public ::testing::Test {
 protected:
  ScenarioModelsTest() { Write("tree.xml", kTree); }
  std::string Write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.Path(name)) << text;
    return folder_.Path(name);
  }
  std::string ModelsFor(const std::vector<std::string>& known, const std::string& models) {
    return ModelsForScenario(folder_.Path("a.test.json"), folder_.Path("tree.xml"), known, models,
                             diagnostics_);
  }

  const TemporaryFolder folder_;
  Diagnostics diagnostics_;
};

TEST_F(ScenarioModelsTest, OnlyDecoratorsThatNobodyKnowsNeedAModel) {
  const auto project = Project::FromFile(folder_.Path("tree.xml"), diagnostics_);
  EXPECT_THAT(DecoratorsWithoutModel(*project), ElementsAre("Guarded"));
  std::string text = kTree;
  text.insert(text.find("</root>"), "<TreeNodesModel>" + std::string(kModel) + "</TreeNodesModel>");
  Write("tree.xml", text);
  const auto with_model = Project::FromFile(folder_.Path("tree.xml"), diagnostics_);
  EXPECT_TRUE(DecoratorsWithoutModel(*with_model).empty());
  EXPECT_EQ(ModelsFor({}, ModelsWith(kModel)), "");
  EXPECT_FALSE(std::filesystem::exists(folder_.Path("a.models.xml")));
}

TEST_F(ScenarioModelsTest, AFileThatDescribesThemIsNamed) {
  const std::string other = Write("other.xml", ModelsWith("<Action ID='Drive'/>"));
  const std::string models = Write("models.xml", ModelsWith(kModel));
  EXPECT_EQ(ModelsFor({other, models}, ""), models);
  EXPECT_FALSE(std::filesystem::exists(folder_.Path("a.models.xml")));
}

TEST_F(ScenarioModelsTest, WithoutSuchAFileOneIsWrittenBesideTheScenario) {
  EXPECT_EQ(ModelsFor({}, ModelsWith(kModel)), folder_.Path("a.models.xml"));
  EXPECT_TRUE(
      Project::FromFile(folder_.Path("a.models.xml"), diagnostics_)->models().count("Guarded"));
}

TEST_F(ScenarioModelsTest, WhatTheScenariosNameAlreadyStays) {
  Write("a.test.json", R"({"tree": "tree.xml", "models": "mine.xml", "scenarios": [{"name": "a", )"
                       R"("steps": [{"ticks": 1}]}]})");
  EXPECT_EQ(ModelsFor({Write("models.xml", ModelsWith(kModel))}, ""), folder_.Path("mine.xml"));
}

TEST_F(ScenarioModelsTest, ADecoratorThatIsDescribedNowhereIsAWarning) {
  EXPECT_EQ(ModelsFor({}, ModelsWith("<Action ID='Drive'/>")), "");
  EXPECT_THAT(diagnostics_.ToString(), HasSubstr("no model of the decorator Guarded"));
}

TEST_F(ScenarioModelsTest, TheModelsOfARecordAreThoseOfTheNodesInIt) {
  TreeDescription tree;
  tree.models = ModelsWith(std::string(kModel) + "<Action ID='Unused'/><Action ID='Drive'/>");
  for (const char* const id : {"Guarded", "Sequence", "Drive", "Unknown"}) {
    DescribedNode node;
    node.id = id;
    tree.nodes.push_back(node);
  }
  const std::string text = ModelsOfRecord(tree);
  EXPECT_THAT(text, HasSubstr("ID='Guarded'"));
  EXPECT_THAT(text, HasSubstr("ID='Drive'"));
  EXPECT_THAT(text, Not(HasSubstr("Unused")));
  EXPECT_TRUE(Project::FromText(text, "models.xml", diagnostics_)) << text;
}

TEST_F(ScenarioModelsTest, TheFileOfTheScenariosNamesTheModelsRelativeToIt) {
  Scenario scenario;
  scenario.name = "first";
  scenario.steps.resize(1);
  const std::string file = folder_.Path("a.test.json");
  const std::string tree = folder_.Path("tree.xml");
  ASSERT_TRUE(WriteScenario(scenario, file, tree, "", diagnostics_));
  scenario.name = "second";
  const std::string models = Write("models.xml", ModelsWith(kModel));
  ASSERT_TRUE(WriteScenario(scenario, file, tree, "", diagnostics_, models));
  const auto suite = LoadScenarios(file, diagnostics_);
  ASSERT_TRUE(suite) << diagnostics_.ToString();
  EXPECT_EQ(suite->scenarios.size(), 2U);
  EXPECT_EQ(suite->models_file, models);
  scenario.name = "third";
  EXPECT_TRUE(WriteScenario(scenario, file, tree, "", diagnostics_, folder_.Path("other.xml")));
  EXPECT_EQ(LoadScenarios(file, diagnostics_)->models_file, models) << "what is named stays";
}

}  // namespace
}  // namespace coppice
