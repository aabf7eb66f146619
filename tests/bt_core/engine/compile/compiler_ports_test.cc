// How the compiler binds ports, and what it says when it cannot.
#include <gtest/gtest.h>

#include "tests/bt_core/engine/fixture.h"

namespace coppice {
namespace {

std::string Problems(const std::string& body) {
  Diagnostics diagnostics;
  CompileText(Main(body), diagnostics, TestRegistry());
  return diagnostics.ToString();
}

TEST(Ports, LiteralsAndKeysAreAccepted) {
  EXPECT_EQ(Problems(R"(<Drive goal="1.5" tries="{n}" label="hall" distance="{d}" )"
                     R"(total=" {t} "/>)"),
            "");
}

TEST(Ports, MisspeltPortGetsTheNearestName) {
  EXPECT_EQ(Problems("<Drive goal=\"1\" total=\"{t}\"\n  distanse=\"{d}\"/>"),
            "t.xml:4:3: error: Drive has no port \"distanse\" (did you mean \"distance\"?)\n");
}

TEST(Ports, RequiredInputsMustBeGiven) {
  EXPECT_EQ(Problems(R"( <Drive total="{t}"/>)"),
            "t.xml:3:2: error: Drive needs its port \"goal\" (where to [m])\n");
}

TEST(Ports, InOutMustBeGiven) {
  EXPECT_EQ(Problems(R"(<Drive goal="1"/>)"),
            "t.xml:3:1: error: Drive needs its port \"total\" (sum of all drives)\n");
}

TEST(Ports, LiteralsMustBeOfTheType) {
  EXPECT_EQ(Problems(R"(<Drive goal="far" total="{t}"/>)"),
            R"(t.xml:3:14: error: "far" is not a value for port "goal" of Drive )"
            "(expected double)\n");
  EXPECT_EQ(
      Problems(R"(<Drive goal="" total="{t}"/>)"),
      "t.xml:3:14: error: \"\" is not a value for port \"goal\" of Drive (expected double)\n");
}

TEST(Ports, AnEmptyLiteralIsToldOfTheDefault) {
  EXPECT_EQ(Problems(R"(<Drive goal="1" total="{t}" tries=""/>)"),
            R"(t.xml:3:36: error: "" is not a value for port "tries" of Drive )"
            "(expected int; without the attribute it is 3)\n");
}

TEST(Ports, OutputsNeedAKey) {
  EXPECT_EQ(Problems(R"(<Drive goal="1" total="{t}" distance="d"/>)"),
            "t.xml:3:39: error: output \"distance\" needs a key (write {key})\n");
}

TEST(Ports, AnInOutReadsALiteralAndLosesWhatIsWritten) {
  EXPECT_EQ(Problems(R"(<Drive goal="1" total="5"/>)"),
            "t.xml:3:24: warning: what is written to inout \"total\" is lost: \"5\" is no key "
            "(write {key})\n");
}

TEST(Ports, AnOutputOfTextWithoutKeyIsLostWithAWarning) {
  EXPECT_EQ(Problems(R"(<Tell text="x" to="k"/>)"),
            "t.xml:3:20: warning: what is written to output \"to\" is lost: \"k\" is no key "
            "(write {key})\n");
}

TEST(Ports, AnEmptyOutputIsNotGiven) {
  EXPECT_EQ(Problems(R"(<Drive goal="1" total="{t}" distance=""/>)"), "");
}

TEST(Ports, APortOfFormat3IsToldItsNewName) {
  EXPECT_EQ(Problems(R"(<Parallel success_threshold="1"><AlwaysSuccess/></Parallel>)"),
            "t.xml:3:11: error: Parallel has no port \"success_threshold\" (in format 4 it is "
            "success_count)\n");
}

TEST(Ports, AListWithCommasIsToldOfSemicolons) {
  EXPECT_EQ(Problems(R"(<LoopDouble queue="1, 2" value="{v}"><AlwaysSuccess/></LoopDouble>)"),
            R"(t.xml:3:20: error: "1, 2" is not a value for port "queue" of LoopDouble )"
            "(expected list of double; its elements are separated by semicolons)\n");
}

TEST(Ports, EmptyBracesAreNoKey) {
  EXPECT_NE(Problems(R"(<Drive goal="{}" total="{t}"/>)"), "");
  EXPECT_NE(Problems(R"(<Drive goal="{@}" total="{t}"/>)"), "");
}

TEST(Ports, AllUsersOfAKeyAgreeOnItsType) {
  EXPECT_EQ(Problems("<Sequence>\n<Tell text=\"x\" to=\"{k}\"/>\n"
                     R"(<Drive goal="{k}" total="{t}"/></Sequence>)"),
            R"(t.xml:5:14: error: key "k" is string (from Tell.to), but port "goal" of Drive is )"
            "double\n");
}

TEST(Ports, TheDefaultIsUsedWhenThePortIsLeftOut) {
  Stage stage(Main(R"(<Drive goal="1" total="{t}"/>)"));
  EXPECT_EQ(stage.executor->Tick(), Status::kSuccess);
  const SlotIndex total = stage.program->layout.Find(kMainScope, "t");
  EXPECT_EQ(stage.executor->blackboard()[total].value.Get<int>(), 3);
}

TEST(Ports, EqualsSignMeansTheKeyOfTheSameName) {
  for (const char* text : {"=", "{=}", " {=} "}) {
    Stage stage(Main(std::string(R"(<Drive goal="1" total=")") + text + "\"/>"));
    EXPECT_NE(stage.program->layout.Find(kMainScope, "total"), kNoSlot) << text;
  }
}

TEST(Ports, OneNodeReadsWhatAnotherWrote) {
  Stage stage(Main(R"(<Sequence><Tell text="hello" to="{a}"/><Tell text="{a}" to="{b}"/>)"
                   "</Sequence>"));
  EXPECT_EQ(stage.executor->Tick(), Status::kSuccess);
  const SlotIndex b = stage.program->layout.Find(kMainScope, "b");
  EXPECT_EQ(stage.executor->blackboard()[b].value.Get<std::string>(), "hello");
}

TEST(Ports, OneThatIsAboutAKeyTakesItsPlainName) {
  Stage stage(
      Root(R"(<BehaviorTree ID="Main"><SubTree ID="Sub" inner="{outer}"/></BehaviorTree>)"
           R"(<BehaviorTree ID="Sub"><Sequence><SetBlackboard value="7" output_key="inner"/>)"
           R"(<WasEntryUpdated entry="inner"/><SetBlackboard value="8" output_key="@own"/>)"
           R"(<UnsetBlackboard key="@own"/></Sequence></BehaviorTree>)"));
  EXPECT_EQ(stage.executor->Tick(), Status::kSuccess);
  const auto at = [&stage](const char* key) -> const Slot& {
    return stage.executor->blackboard()[stage.program->layout.Find(kMainScope, key)];
  };
  EXPECT_EQ(at("outer").value.Print(), "7");
  EXPECT_EQ(at("own").writes, 2U);
  EXPECT_FALSE(at("own").value.has_value());
}

TEST(Ports, AnUnsetInputFailsTheLeafAndNamesPortAndKey) {
  Stage stage(Main(R"(<Drive goal="{target}" total="{t}"/>)"));
  const KeepingSink& sink = stage.Listen();
  EXPECT_EQ(stage.executor->Tick(), Status::kFailure);
  ASSERT_EQ(sink.ticks[0].messages.size(), 1U);
  EXPECT_EQ(sink.ticks[0].messages[0].text,
            R"(input "goal" has no value: nobody has written key "target" yet)");
}

TEST(Ports, AnUnsetInputOfABuiltInNodeFailsIt) {
  Stage stage(Main(R"(<Repeat num_cycles="{n}"><AlwaysSuccess/></Repeat>)"));
  const KeepingSink& sink = stage.Listen();
  EXPECT_EQ(stage.executor->Tick(), Status::kFailure);
  ASSERT_EQ(sink.ticks[0].messages.size(), 1U);
  EXPECT_EQ(sink.ticks[0].messages[0].text,
            R"(input "num_cycles" has no value: nobody has written key "n" yet)");
}

TEST(Ports, AnUnsetInputIsNotTakenForTheScriptWithItsNumber) {
  Stage stage(Main(R"(<Precondition if="false" else="{result}"><AlwaysSuccess/></Precondition>)"));
  const KeepingSink& sink = stage.Listen();
  EXPECT_EQ(stage.executor->Tick(), Status::kFailure);
  ASSERT_EQ(sink.ticks[0].messages.size(), 1U);
  EXPECT_EQ(sink.ticks[0].messages[0].text,
            R"(input "else" has no value: nobody has written key "result" yet)");
}

TEST(Ports, ParallelSaysWhenAThresholdIsTooHigh) {
  Stage stage(Main(R"(<Parallel success_count="3"><AlwaysSuccess/><AlwaysSuccess/></Parallel>)"));
  const KeepingSink& sink = stage.Listen();
  EXPECT_EQ(stage.executor->Tick(), Status::kFailure);
  ASSERT_EQ(sink.ticks[0].messages.size(), 1U);
  EXPECT_EQ(sink.ticks[0].messages[0].text, "asks for 3 of 2 children");
}

class Converter : public Leaf {
 public:
  class AnyPort : public PortBase {
   public:
    explicit AnyPort(std::string name) : PortBase(Declaration(std::move(name))) {}

   private:
    static PortDeclaration Declaration(std::string name) {
      PortDeclaration declaration;
      declaration.name = std::move(name);
      declaration.required = false;
      declaration.converts = true;
      return declaration;
    }
  };
  AnyPort first{"first"};
  AnyPort second{"second"};
  Status Tick(bool) override { return Status::kSuccess; }
};

std::shared_ptr<const Registry> RegistryWithConverter() {
  auto registry = std::make_shared<Registry>(*TestRegistry());
  registry->AddBuilder({"Convert", NodeCategory::kAction, "", {}}, {0, 0},
                       [] { return std::make_unique<Converter>(); });
  return registry;
}

TEST(Ports, ANodeThatConvertsSharesKeysOfAnyType) {
  Diagnostics diagnostics;
  const auto program = CompileText(
      Main(R"(<Sequence><Convert first="{d}" second="{t}"/>)"
           R"(<Drive goal="1" total="{t}" distance="{d}" tries="{n}"/><Convert first="{n}"/>)"
           R"(</Sequence>)"),
      diagnostics, RegistryWithConverter());
  EXPECT_EQ(diagnostics.ToString(), "");
  ASSERT_TRUE(program);
  const SlotIndex tries = program->layout.Find(kMainScope, "n");
  EXPECT_EQ(program->layout.slots[tries].type, &TypeOf<int>());
}

TEST(Ports, ALiteralOfANodeThatConvertsStaysAText) {
  Diagnostics diagnostics;
  const auto program =
      CompileText(Main(R"(<Convert first="007"/>)"), diagnostics, RegistryWithConverter());
  ASSERT_TRUE(program);
  const Value& literal = program->layout.slots[program->ports[0].slot].initial;
  ASSERT_TRUE(literal.Is<std::string>());
  EXPECT_EQ(literal.Get<std::string>(), "007");
}

}  // namespace
}  // namespace coppice
