#include "bt_core/base/verbs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <iostream>

namespace coppice {
namespace {

using testing::HasSubstr;
using testing::internal::CaptureStderr;
using testing::internal::CaptureStdout;
using testing::internal::GetCapturedStderr;
using testing::internal::GetCapturedStdout;

const Command kBoil{"kettle boil", "heat water", {"CUP", 1, 1}, "Until it boils.", {}};
const Command kPour{"kettle pour", "fill a cup", {}, "All of it.", {}};

int Boil(const Options& options) {
  std::cout << "boiled " << options.files[0];
  return 0;
}
int Pour(const Options&) { return 1; }

int Boiler(const std::vector<std::string>& arguments) {
  return RunVerb("kettle", {{"boil", kBoil, Boil}, {"pour", kPour, Pour}}, arguments);
}

TEST(Verbs, AVerbGetsWhatStandsBehindIt) {
  CaptureStdout();
  EXPECT_EQ(Boiler({"boil", "tea"}), 0);
  EXPECT_EQ(GetCapturedStdout(), "boiled tea");
}

TEST(Verbs, ItsStatusIsThatOfTheProgram) { EXPECT_EQ(Boiler({"pour"}), 1); }

TEST(Verbs, HelpListsThem) {
  CaptureStdout();
  EXPECT_EQ(Boiler({"--help"}), 0);
  EXPECT_EQ(GetCapturedStdout(),
            "usage: kettle VERB ...\n\n  boil      heat water\n  pour      fill a cup\n"
            "\n`kettle VERB --help` says more.\n");
}

TEST(Verbs, WithoutOneTheHelpIsAnError) {
  CaptureStderr();
  EXPECT_EQ(Boiler({}), 2);
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("usage: kettle VERB"));
}

TEST(Verbs, OfAnUnknownOneTheNearestIsTold) {
  CaptureStderr();
  EXPECT_EQ(Boiler({"boyl"}), 2);
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("kettle: unknown verb \"boyl\" (did you mean"));
}

TEST(Verbs, WrongOptionsDoNotRunIt) {
  CaptureStderr();
  EXPECT_EQ(Boiler({"pour", "--slowly"}), 2);
  EXPECT_THAT(GetCapturedStderr(), HasSubstr("--slowly"));
}

}  // namespace
}  // namespace coppice
