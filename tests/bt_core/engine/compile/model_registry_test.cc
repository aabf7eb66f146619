#include "bt_core/engine/compile/model_registry.h"

#include <gtest/gtest.h>

#include "bt_core/engine/compile/check_project.h"
#include "bt_core/engine/compile/models.h"
#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

constexpr char kModels[] = R"(<root BTCPP_format="4"><TreeNodesModel>)"
                           R"(<Action ID="Go"><input_port name="goal" type="Pose"/>)"
                           R"(<input_port name="speed" type="double" default="0.5"/></Action>)"
                           R"(<Action ID="Look"><output_port name="seen" type="Picture"/></Action>)"
                           R"(<Decorator ID="Twice"/>)"
                           "</TreeNodesModel></root>";

std::shared_ptr<Registry> ModelRegistry(const std::string& models) {
  Diagnostics diagnostics;
  auto registry = std::make_shared<Registry>();
  AddModels(*Project::FromText(models, "models.xml", diagnostics), *registry);
  return registry;
}

std::string Check(const std::string& body, std::shared_ptr<const Registry> registry) {
  Diagnostics diagnostics;
  auto project = Project::FromText(Main(body), "t.xml", diagnostics);
  CheckProject(std::make_shared<const Project>(*std::move(project)), std::move(registry), {true},
               diagnostics);
  return diagnostics.ToString();
}

TEST(ModelRegistry, TreesAreCheckedAgainstModels) {
  EXPECT_EQ(
      Check("<Sequence>\n<Go goal=\"1;2;3\" speed=\"fast\" sped=\"1\"/>\n<Go/>\n"
            "<Twice/>\n<Stop/></Sequence>",
            ModelRegistry(kModels)),
      "t.xml:4:31: error: Go has no port \"sped\" (did you mean \"speed\"?)\n"
      "t.xml:4:25: error: \"fast\" is not a value for port \"speed\" of Go (expected double)\n"
      "t.xml:6:1: error: Twice has 0 children, expected exactly 1\n"
      "t.xml:7:1: error: unknown node type \"Stop\"\n");
}

TEST(ModelRegistry, TypesThatOnlyHaveANameMustFitTogether) {
  EXPECT_EQ(
      Check(R"(<Sequence><Go goal="{x}"/><Go goal="{x}"/></Sequence>)", ModelRegistry(kModels)),
      "");
  EXPECT_EQ(
      Check(R"(<Sequence><Look seen="{x}"/><Go goal="{x}"/></Sequence>)", ModelRegistry(kModels)),
      R"(t.xml:3:39: error: key "x" is Picture (from Look.seen), but port "goal" of Go is )"
      "Pose\n");
}

TEST(ModelRegistry, ATreeWithTypesOfModelsDoesNotRun) {
  Diagnostics diagnostics;
  EXPECT_FALSE(CompileText(Main("<Go/>"), diagnostics, ModelRegistry(kModels)));
  EXPECT_EQ(diagnostics.ToString(),
            "t.xml:3:1: error: node type \"Go\" is known from a model only (register its class)\n");
}

TEST(ModelRegistry, WhatARegistryWritesIsReadBack) {
  const auto original = TestRegistry();
  const auto copy = ModelRegistry(WriteModels(*original));
  EXPECT_EQ(copy->Ids(), original->Ids());
  const Manifest& drive = copy->Find("Drive")->manifest;
  ASSERT_EQ(drive.ports.size(), 5U);
  EXPECT_EQ(drive.ports[0].type, &TypeOf<double>());
  EXPECT_EQ(drive.ports[1].default_text, "3");
  EXPECT_EQ(drive.ports[4].direction, PortDirection::kInOut);
}

std::string Removed(const std::string& models) {
  Diagnostics diagnostics;
  Registry registry;
  const auto project = Project::FromText(
      "<root BTCPP_format=\"4\">\n<TreeNodesModel>\n" + models + "</TreeNodesModel></root>",
      "m.xml", diagnostics);
  const std::size_t before = registry.entries().size();
  RemoveContradicted(*project, registry, diagnostics);
  EXPECT_EQ(registry.entries().size() + diagnostics.all().size(), before);
  return diagnostics.ToString();
}

TEST(ModelRegistry, SaysHowAModelContradictsABuiltInNode) {
  EXPECT_EQ(Removed(R"(<Decorator ID="Sleep"><input_port name="msec"/></Decorator>)"),
            R"(m.xml:3:1: warning: "Sleep" of this model is of category Decorator, but the )"
            "built-in Action of "
            "that name is not (trees are checked against the model)\n");
  EXPECT_EQ(Removed(R"(<Action ID="Sleep"><input_port name="msec"/>)"
                    R"(<input_port name="why"/></Action>)"),
            R"(m.xml:3:1: warning: "Sleep" of this model has port "why", but the built-in Action )"
            "of that name has not (trees are checked against the model)\n");
  EXPECT_EQ(Removed(R"(<Action ID="Sleep"/>)"),
            R"(m.xml:3:1: warning: "Sleep" of this model has no port "msec", but the built-in )"
            "Action of that name needs it (trees are checked against the model)\n");
}

TEST(ModelRegistry, ABuiltInNodeThatAModelDescribesStays) {
  EXPECT_EQ(Removed(R"(<Action ID="Sleep"><input_port name="msec" type="int"/></Action>)"
                    R"(<Control ID="Parallel"/><Action ID="Say"/>)"),
            "");
}

TEST(ModelRegistry, TheModelsOfAllBuiltInNodesContradictNone) {
  Diagnostics diagnostics;
  Registry registry;
  const auto project = Project::FromText(WriteModels(registry), "m.xml", diagnostics);
  RemoveContradicted(*project, registry, diagnostics);
  EXPECT_EQ(diagnostics.ToString(), "");
}

TEST(ModelRegistry, ScriptsMayDoWhatTheyLikeWithATypeThatOnlyHasAName) {
  EXPECT_EQ(Check(R"(<Sequence><Look seen="{x}"/><Script code="y := x + 1; x = 5"/>)"
                  R"(<AlwaysSuccess _skipIf="x == 4"/></Sequence>)",
                  ModelRegistry(kModels)),
            "");
}

TEST(ModelRegistry, AnInputThatReadsATextIsAWarningForItConverts) {
  const auto registry =
      ModelRegistry(R"(<root BTCPP_format="4"><TreeNodesModel>)"
                    R"(<Action ID="Ask"><output_port name="answer" type="std::string"/></Action>)"
                    R"(<Action ID="Use"><input_port name="number" type="double"/></Action>)"
                    "</TreeNodesModel></root>");
  EXPECT_EQ(Check(R"(<Sequence><Ask answer="{x}"/><Use number="{x}"/></Sequence>)", registry),
            R"(t.xml:3:43: warning: key "x" is string (from Ask.answer), but port "number" of Use )"
            "is double (BehaviorTree.CPP converts the text whenever it is read)\n");
  EXPECT_NE(Check(R"(<Sequence><Use number="{x}"/><Ask answer="{x}"/></Sequence>)", registry)
                .find(": error: key \"x\" is double"),
            std::string::npos)
      << "a text for a number is none";
}

TEST(ModelRegistry, DefaultsMayHaveTheSuffixesOfCpp) {
  const auto registry =
      ModelRegistry(R"(<root BTCPP_format="4"><TreeNodesModel><Action ID="Plan">)"
                    R"(<input_port name="attempts" type="unsigned int" default="1u"/>)"
                    R"(<input_port name="speed" type="float" default="0.5f"/>)"
                    R"(<input_port name="frame" type="std::string" default="full"/>)"
                    "</Action></TreeNodesModel></root>");
  const auto& ports = registry->Find("Plan")->manifest.ports;
  EXPECT_EQ(ports[0].default_text, "1");
  EXPECT_EQ(ports[1].default_text, "0.5");
  EXPECT_EQ(ports[2].default_text, "full");
  EXPECT_EQ(Check("<Plan/>", registry), "");
}

}  // namespace
}  // namespace coppice
