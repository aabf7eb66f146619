#include "bt_core/base/advisor.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace coppice {
namespace {

std::string Itself(const std::string& name) { return name; }

TEST(Advisor, GivesTheNearestNameAndTheQuestion) {
  Advisor advisor;
  const std::vector<std::string> names{"Inverter", "Sequence"};
  EXPECT_EQ(advisor.Nearest("Invertor", names, Itself), "Inverter");
  EXPECT_EQ(advisor.Advise("Invertor", names, Itself), R"(did you mean "Inverter"?)");
  EXPECT_EQ(advisor.Advise("Zzz", names, Itself), "");
}

TEST(Advisor, GivesNoAdviceAnyMoreOnceItHasTakenLong) {
  Advisor advisor;
  const std::vector<std::string> names(2000, std::string(30, 'a'));
  const std::string wrong = std::string(29, 'a') + "b";
  int advised = 0;
  while (advised < 100'000 && !advisor.Nearest(wrong, names, Itself).empty()) ++advised;
  EXPECT_GT(advised, 100);
  EXPECT_LT(advised, 1000);
}

}  // namespace
}  // namespace coppice
