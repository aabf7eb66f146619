#include "robot_app/assistance/assistance_store.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <random>

namespace coppice::robot::assistance {
namespace {

AssistanceState Sample() {
  AssistanceState state;
  HelpRequest request;
  request.id = 7;
  request.subject = "navigation";
  request.question = "Blocked \"here\"\n\xff";
  request.opened = Time(std::chrono::seconds(5));
  request.asked = {{"Ada", AskedSupervisor::State::kReached},
                   {"Ben", AskedSupervisor::State::kDeclined}};
  state.requests = {request};
  state.passes.links["hash"] = {PageRole::kOperator, "Ada", 7, Time(std::chrono::hours(1))};
  return state;
}

TEST(AssistanceStore, ReadsWhatItHasWritten) {
  Diagnostics diagnostics;
  const AssistanceState state = ReadState(ToText(Sample()), diagnostics);
  EXPECT_FALSE(diagnostics.has_errors()) << diagnostics.ToString();
  ASSERT_EQ(state.requests.size(), 1u);
  EXPECT_EQ(state.requests[0].id, 7u);
  EXPECT_EQ(state.requests[0].opened, Time(std::chrono::seconds(5)));
  EXPECT_EQ(state.requests[0].withdrawn_at, kNever);
  ASSERT_EQ(state.requests[0].asked.size(), 2u);
  EXPECT_EQ(state.requests[0].asked[1].state, AskedSupervisor::State::kDeclined);
  EXPECT_EQ(state.passes.links.at("hash").name, "Ada");
  EXPECT_EQ(state.passes.links.at("hash").until, Time(std::chrono::hours(1)));
}

TEST(AssistanceStore, AFileIsForItsOwnerOnly) {
  const std::string path = testing::TempDir() + "store_" + std::to_string(getpid()) + ".json";
  unlink(path.c_str());
  Diagnostics diagnostics;
  EXPECT_TRUE(LoadState(path, diagnostics).requests.empty());
  EXPECT_TRUE(SaveState(path, Sample(), diagnostics)) << diagnostics.ToString();
  struct stat info {};
  ASSERT_EQ(stat(path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0600u);
  EXPECT_EQ(LoadState(path, diagnostics).requests.size(), 1u);
  EXPECT_FALSE(diagnostics.has_errors());
}

TEST(AssistanceStore, AnyDamageIsAnErrorAndAnEmptyState) {
  const std::string good = ToText(Sample());
  std::mt19937 random(1);
  int errors = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string text = good.substr(0, random() % (good.size() + 1));
    if (!text.empty()) text[random() % text.size()] = static_cast<char>(random());
    Diagnostics diagnostics;
    const AssistanceState state = ReadState(text, diagnostics);
    if (!diagnostics.has_errors()) continue;
    ++errors;
    EXPECT_TRUE(state.requests.empty());
  }
  EXPECT_GT(errors, 1900);
}

}  // namespace
}  // namespace coppice::robot::assistance
