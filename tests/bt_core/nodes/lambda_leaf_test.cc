#include "bt_core/nodes/lambda_leaf.h"

#include <gtest/gtest.h>

#include "bt_core/testing/leaf_harness.h"

namespace coppice {
namespace {

const PortDeclaration& PortOf(const Registry& registry, const char* id, std::size_t k) {
  return registry.Find(id)->manifest.ports.at(k);
}

TEST(LambdaCondition, AsksTheFunction) {
  auto registry = std::make_shared<Registry>();
  bool night = true;
  registry->Condition("IsNight", [&night] { return night; });
  LeafHarness harness(registry, "IsNight");
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  night = false;
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(registry->Find("IsNight")->manifest.category, NodeCategory::kCondition);
}

TEST(LambdaAction, ReadsAndWritesPortsByItsParameters) {
  auto registry = std::make_shared<Registry>();
  registry->Action("Add", {"a", "b", "sum"}, [](double a, const double& b, Output<double>& sum) {
    sum.Set(a + b);
    return Status::kSuccess;
  });
  LeafHarness harness(registry, "Add");
  harness.Set("a", 2.0);
  harness.Set("b", 3.0);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<double>("sum"), 5.0);
}

TEST(LambdaAction, ItsParametersMakeTheManifest) {
  Registry registry;
  registry.Action(
      "Log", {{"text", "what to say"}, {"times", "how often", "1"}, "to", "total"},
      [](const std::string&, int, const Input<std::string>&, InOut<int>&) {
        return Status::kSuccess;
      },
      "Says it.");
  EXPECT_EQ(registry.Find("Log")->manifest.description, "Says it.");
  EXPECT_EQ(PortOf(registry, "Log", 0).name, "text");
  EXPECT_EQ(PortOf(registry, "Log", 0).description, "what to say");
  EXPECT_TRUE(PortOf(registry, "Log", 0).required);
  EXPECT_EQ(PortOf(registry, "Log", 1).default_text, "1");
  EXPECT_EQ(PortOf(registry, "Log", 1).type, &TypeOf<int>());
  EXPECT_FALSE(PortOf(registry, "Log", 1).required);
  EXPECT_FALSE(PortOf(registry, "Log", 2).required);
  EXPECT_EQ(PortOf(registry, "Log", 3).direction, PortDirection::kInOut);
}

TEST(LambdaAction, AnInputWithoutValueFailsAndSaysWhichOne) {
  auto registry = std::make_shared<Registry>();
  registry->Action("Use", {"number"}, [](int) { return Status::kSuccess; });
  LeafHarness harness(registry, "Use");
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_NE(harness.message().find(R"("number")"), std::string::npos) << harness.message();
}

TEST(LambdaAction, AnInputMayBeLeftOut) {
  auto registry = std::make_shared<Registry>();
  registry->Action("Use", {"number", "out"}, [](const Input<int>& number, Output<int>& out) {
    out.Set(number.has_value() ? *number : -1);
    return Status::kSuccess;
  });
  LeafHarness harness(registry, "Use");
  harness.Tick();
  EXPECT_EQ(harness.Get<int>("out"), -1);
  harness.Set("number", 7);
  harness.Tick();
  EXPECT_EQ(harness.Get<int>("out"), 7);
}

TEST(LambdaAction, WhatItThrowsIsTheReasonOfItsFailure) {
  auto registry = std::make_shared<Registry>();
  registry->Action("Break", []() -> Status { throw std::runtime_error("no paper"); });
  LeafHarness harness(registry, "Break");
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "no paper");
}

TEST(LambdaAction, EveryNodeHasItsOwnCopyOfTheFunction) {
  auto registry = std::make_shared<Registry>();
  registry->Action("Count", {"count"}, [n = 0](Output<int>& count) mutable {
    count.Set(++n);
    return Status::kSuccess;
  });
  LeafHarness first(registry, "Count");
  LeafHarness second(registry, "Count");
  first.Tick();
  first.Tick();
  second.Tick();
  EXPECT_EQ(first.Get<int>("count"), 2);
  EXPECT_EQ(second.Get<int>("count"), 1);
}

bool IsLarge(int number) { return number > 100; }

TEST(LambdaCondition, TakesAPlainFunction) {
  auto registry = std::make_shared<Registry>();
  registry->Condition("IsLarge", {"number"}, &IsLarge);
  LeafHarness harness(registry, "IsLarge");
  harness.Set("number", 101);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
}

TEST(LambdaCondition, RefusesATakenId) {
  Registry registry;
  registry.Condition("A", [] { return true; });
  EXPECT_THROW(registry.Condition("A", [] { return true; }), std::invalid_argument);
}

}  // namespace
}  // namespace coppice
