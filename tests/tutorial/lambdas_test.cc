#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

#include "bt_core/testing/leaf_harness.h"

namespace coppice {
namespace {

// [lambdas]
std::shared_ptr<Registry> MakeRegistry() {
  auto registry = std::make_shared<Registry>();
  registry->Condition("IsBright", {"lux"}, [](double lux) { return lux >= 10.0; });
  registry->Action("Dim", {"lux", {"factor", "0 to 1", "0.5"}, "level"},
                   [](double lux, double factor, Output<double>& level) {
                     if (factor > 1.0) throw std::runtime_error("the factor is above 1");
                     level.Set(lux * factor);
                     return Status::kSuccess;
                   });
  return registry;
}
// [lambdas end]

// [test]
TEST(Dim, WritesThePartOfTheBrightness) {
  LeafHarness harness(MakeRegistry(), "Dim");
  harness.Set("lux", 80.0);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  EXPECT_EQ(harness.Get<double>("level"), 40.0);
}

TEST(Dim, WhatItThrowsIsTheReasonOfItsFailure) {
  LeafHarness harness(MakeRegistry(), "Dim");
  harness.Set("lux", 80.0);
  harness.Set("factor", 2.0);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
  EXPECT_EQ(harness.message(), "the factor is above 1");
}
// [test end]

TEST(IsBright, AsksTheLambda) {
  LeafHarness harness(MakeRegistry(), "IsBright");
  harness.Set("lux", 80.0);
  EXPECT_EQ(harness.Tick(), Status::kSuccess);
  harness.Set("lux", 3.0);
  EXPECT_EQ(harness.Tick(), Status::kFailure);
}

}  // namespace
}  // namespace coppice
